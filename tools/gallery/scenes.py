"""Whole scenes, each a function that returns a Model."""
import math

import geometry as g
from glb import Model, png, turn

FOOT = [(0, 0), (0.36, 0), (0.38, 0.06), (0.34, 0.14), (0.26, 0.18), (0.24, 0.24)]
PIECES = {
    "pawn": FOOT + [(0.13, 0.4), (0.11, 0.6), (0.22, 0.66), (0.12, 0.7), (0.2, 0.82), (0.18, 0.96), (0, 1.04)],
    "rook": FOOT + [(0.18, 0.45), (0.17, 0.8), (0.26, 0.9), (0.28, 0.92), (0.28, 1.14), (0.2, 1.14), (0.2, 1.02), (0, 1.02)],
    "bishop": FOOT + [(0.14, 0.5), (0.11, 0.9), (0.22, 0.96), (0.12, 1.0), (0.2, 1.16), (0.15, 1.34), (0.04, 1.46),
                      (0.06, 1.52), (0, 1.58)],
    "queen": FOOT + [(0.16, 0.6), (0.12, 1.1), (0.25, 1.18), (0.14, 1.22), (0.26, 1.52), (0.2, 1.5), (0.1, 1.56),
                     (0.1, 1.64), (0, 1.7)],
    "king": FOOT + [(0.17, 0.6), (0.13, 1.2), (0.27, 1.28), (0.15, 1.33), (0.24, 1.62), (0.1, 1.68), (0, 1.7)],
}


def chess():
    m = Model()

    def board_pixel(x, y):
        grain = 18 * (g.noise(x / 10, y / 50, seed=5) - 0.5)
        light = (x // 32 + y // 32) % 2 == 0
        return (222 + grain, 190 + grain, 145 + grain) if light else (110 + grain, 66 + grain, 40 + grain)
    board = m.material("board", (1, 1, 1, 1), roughness=0.45, pbr={"baseColorTexture": m.texture(png(256, 256, board_pixel))})
    frame = m.material("frame", (0.2, 0.1, 0.06, 1), roughness=0.4)
    m.node("board", mesh=m.mesh("board", (g.floor(4, 0.0), board), (g.box((-4.4, -0.35, -4.4), (4.4, -0.01, 4.4)), frame)))
    sides = {"white": m.material("white", (0.85, 0.78, 0.62, 1), roughness=0.3),
             "black": m.material("black", (0.1, 0.07, 0.06, 1), roughness=0.3)}
    knight_outline = [(-0.26, 0.2), (0.28, 0.2), (0.2, 0.6), (0.24, 0.95), (0.1, 1.2), (-0.02, 1.34), (-0.08, 1.22),
                      (-0.34, 0.98), (-0.32, 0.86), (-0.12, 0.9), (-0.2, 0.6)]
    center = (0.0, 0.7)
    outline = [(x - center[0], y - center[1]) for x, y in knight_outline]
    meshes = {}
    for side, material in sides.items():
        for name, profile in PIECES.items():
            parts = [(g.lathe(profile, 40, 80), material)]
            if name == "king":
                parts.append((g.joined(g.box((-0.03, 1.68, -0.03), (0.03, 1.96, 0.03)),
                                       g.box((-0.1, 1.8, -0.028), (0.1, 1.86, 0.028))), material))
            meshes[side, name] = m.mesh(f"{side} {name}", *parts)
        head = g.moved(g.extrude(outline, 0.2), offset=(center[0], center[1], -0.1))
        meshes[side, "knight"] = m.mesh(f"{side} knight", (g.lathe(FOOT + [(0, 0.26)], 40, 40), material), (head, material))
    row = ("rook", "knight", "bishop", "queen", "king", "bishop", "knight", "rook")
    moved_pawns = {("white", 4): -2, ("black", 3): 2, ("white", 3): -2}
    for side, z, forward in (("white", 3.5, -1), ("black", -3.5, 1)):
        for file, name in enumerate(row):
            place = [file - 3.5, 0, z]
            if (side, file) == ("white", 6):
                place = [1.5, 0, 1.5]
            m.node(mesh=meshes[side, name], translation=place, rotation=turn(90 if side == "white" else -90))
        for file in range(8):
            m.node(mesh=meshes[side, "pawn"], translation=[file - 3.5, 0, z + forward + moved_pawns.get((side, file), 0)])
    m.light("directional", (-3, 6, 2), intensity=3)
    m.light("directional", (5, 3, 5), intensity=1)
    m.camera((5.0, 7.6, 13.0), (-0.2, 0, 0.1))
    return m


def city():
    m = Model()

    def window_pixel(x, y):
        is_pane = x % 8 in range(2, 7) and y % 8 in range(2, 6)
        if not is_pane:
            return (150, 148, 145)
        return (250, 220, 140) if g.hash_noise(x // 8, y // 8, 9) > 0.72 else (50, 65, 85)
    windows = m.texture(png(64, 128, window_pixel), nearest=True)
    walls = [m.material(f"wall {i}", (*color, 1), roughness=0.6, pbr={"baseColorTexture": windows})
             for i, color in enumerate(((0.9, 0.85, 0.8), (0.7, 0.75, 0.85), (0.85, 0.65, 0.55)))]
    roof = m.material("roof", (0.25, 0.25, 0.27, 1), roughness=0.9)
    houses = [m.mesh(f"house {i}", (g.box((-0.4, 0, -0.4), (0.4, 1, 0.4)), wall),
                     (g.box((-0.3, 1, -0.3), (0.1, 1.06, 0.1)), roof)) for i, wall in enumerate(walls)]
    places = [([], []) for _ in houses]
    for x in range(-13, 13):
        for z in range(-13, 13):
            if x % 5 == 0 or z % 6 == 0:
                continue  # streets
            r = math.hypot(x, z)
            height = 0.5 + 5 * g.hash_noise(x, z, 1) * math.exp(-r * r / 60) + 0.6 * g.hash_noise(x, z, 2)
            kind = places[int(2.999 * g.hash_noise(x, z, 3))]
            kind[0].append((x + 0.5, 0, z + 0.5))
            kind[1].append((1, height, 1))
    for i, (translations, scales) in enumerate(places):
        m.instances(f"district {i}", houses[i], translations, scales=scales)
    m.node("ground", mesh=m.mesh("ground", (g.floor(14), m.material("street", (0.2, 0.2, 0.21, 1), roughness=0.9))))
    m.light("directional", (-4, 5, 3), color=(1, 0.93, 0.8), intensity=3)
    m.light("directional", (5, 4, 6), color=(0.7, 0.8, 1), intensity=0.8)
    m.camera((12, 11, 18), (0.4, 0.6, 0))
    return m


def window():
    """Panes that let a part of the light through."""
    m = Model()
    lead = m.material("lead", (0.12, 0.12, 0.13, 1), roughness=0.5)
    palette = [(0.9, 0.1, 0.08), (0.95, 0.65, 0.05), (0.08, 0.3, 0.85), (0.1, 0.6, 0.2), (0.55, 0.1, 0.6), (0.9, 0.85, 0.5)]
    panes = [m.material(f"pane {i}", (*c, 0.45), roughness=0.1, alphaMode="BLEND", doubleSided=True)
             for i, c in enumerate(palette)]
    pieces = [[] for _ in panes]
    bars = []
    for ring, (inner, outer, count) in enumerate(((0.0, 0.45, 6), (0.45, 0.95, 12), (0.95, 1.5, 12))):
        for i in range(count):
            a, b = 2 * math.pi * i / count, 2 * math.pi * (i + 1) / count
            corners = [(r * math.cos(t), 1.7 + r * math.sin(t), 0.0) for r, t in
                       ((inner, a), (outer, a), (outer, (a + b) / 2), (outer, b), (inner, b), (inner, (a + b) / 2))]
            pieces[(i * (ring + 1) + 2 * ring) % len(panes)].append(
                {"positions": corners, "normals": [(0.0, 0.0, 1.0)] * 6, "indices": [0, 1, 2, 0, 2, 5, 5, 2, 3, 5, 3, 4]})
            start, end = (inner * math.cos(a), 1.7 + inner * math.sin(a)), (outer * math.cos(a), 1.7 + outer * math.sin(a))
            bars.append(g.tube(lambda t, s=start, e=end: (s[0] + t * (e[0] - s[0]), s[1] + t * (e[1] - s[1]), 0.0), 0.025,
                               columns=8, rows=2, aside=(0.0, 0.0, 1.0)))
        bars.append(g.tube(lambda t, r=outer: (r * math.cos(2 * math.pi * t), 1.7 + r * math.sin(2 * math.pi * t), 0.0),
                           0.03, columns=8, rows=72, closed=True, aside=(0.0, 0.0, 1.0)))
    parts = [(g.joined(*piece), pane) for piece, pane in zip(pieces, panes) if piece]
    m.node("window", mesh=m.mesh("window", *parts, (g.joined(*bars), lead)))
    ground = m.material("floor", (0.8, 0.78, 0.74, 1), roughness=0.9)
    m.node("floor", mesh=m.mesh("floor", (g.floor(6), ground)))
    m.light("directional", (-1, 3.2, -4), intensity=3)
    m.light("directional", (2, 3, 6), intensity=0.6)
    m.camera((2.6, 2.8, 10.4), (0, 1.25, 0.6))
    return m


def tentacle():
    """A skin over a chain of joints that an animation bends."""
    m = Model()
    joint_count, length = 8, 3.2
    step = length / joint_count
    skin_color = m.material("skin", (0.75, 0.35, 0.4, 1), roughness=0.35)
    geometry = g.tube(lambda t: (0.0, length * t, 0.0), lambda t: 0.42 * (1 - t) + 0.05, columns=32, rows=96,
                      aside=(0.0, 0.0, 1.0))
    joints, weights = [], []
    for _, y, _ in geometry["positions"]:
        at = min(max(y / step, 0), joint_count - 1.001)
        i, f = int(at), at - int(at)
        joints.append((i, i + 1, 0, 0))
        weights.append((1 - f, f, 0, 0))
    geometry.update(joints=joints, weights=weights)
    del geometry["uvs"]
    mesh = m.mesh("tentacle", (geometry, skin_color))
    nodes = [m.node("joint 0")]
    for i in range(1, joint_count):
        nodes.append(m.node(f"joint {i}", parent=nodes[-1], translation=[0, step, 0]))
    bind = m.accessor([(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -step * i, 0, 1) for i in range(joint_count)], "MAT4")
    skin = m.add("skins", {"joints": nodes, "inverseBindMatrices": bind})
    m.node("body", mesh=mesh, skin=skin)
    times = m.accessor([0.0, 1.0, 2.0], "SCALAR")
    bend = m.accessor([turn(a, (0, 0, 1)) for a in (24, 0, -24)], "VEC4")
    curl = m.accessor([turn(a, (0.6, 0, 0.8)) for a in (-10, 18, 38)], "VEC4")
    m.add("animations", {"name": "sway", "samplers": [{"input": times, "output": bend}, {"input": times, "output": curl}],
                         "channels": [{"sampler": 0 if i < 4 else 1, "target": {"node": n, "path": "rotation"}}
                                      for i, n in enumerate(nodes) if i > 0]})
    m.node("ground", mesh=m.mesh("ground", (g.floor(4), m.material("ground", (0.45, 0.5, 0.5, 1), roughness=0.9))))
    m.camera((0.5, 2.6, 8.4), (0, 1.25, 0))
    return m


def flag():
    """Morph targets: two waves, whose weights an animation changes."""
    m = Model()

    def cloth_pixel(x, y):
        if abs(x - 40) < 10 or abs(y - 48) < 10:
            return (235, 235, 230)
        return (30, 60, 130)
    cloth = m.material("cloth", (1, 1, 1, 1), roughness=0.8, doubleSided=True,
                       pbr={"baseColorTexture": m.texture(png(160, 96, cloth_pixel))})
    sheet = g.surface(60, 30, lambda u, v: (3 * u, 1.8 * (1 - v), 0.0))
    sheet["indices"] = sheet["indices"][::-1]
    del sheet["normals"]  # they would have to follow the waves: flat ones do
    sheet["targets"] = [[(0.0, 0.0, 0.55 * (x / 3) * f(2.2 * x + 0.6 * y)) for x, y, _ in sheet["positions"]]
                        for f in (math.sin, math.cos)]
    node = m.node("flag", mesh=m.mesh("flag", (sheet, cloth)), translation=[0, 1.7, 0])
    times = m.accessor([0.25 * i for i in range(9)], "SCALAR")
    weights = m.accessor([w for i in range(9) for w in (math.cos(math.pi * i / 4), math.sin(math.pi * i / 4))], "SCALAR")
    m.add("animations", {"name": "wind", "samplers": [{"input": times, "output": weights}],
                         "channels": [{"sampler": 0, "target": {"node": node, "path": "weights"}}]})
    wood = m.material("pole", (0.5, 0.35, 0.2, 1), roughness=0.6)
    m.node("pole", mesh=m.mesh("pole", (g.tube(lambda t: (-0.05, 3.8 * t, 0.0), 0.06, rows=4, aside=(0.0, 0.0, 1.0)), wood)))
    m.camera((3.4, 2.8, 6.8), (1.3, 2.0, 0))
    return m


def terrain():
    m = Model()

    def height(x, z):
        h = g.noise(x * 0.7 + 10, z * 0.7 + 20, seed=4, octaves=7)
        return max(3.2 * (h - 0.42), 0.0)

    def color(y, slope):
        if y <= 0.0:
            return (0.05, 0.16, 0.3)
        if y > 1.05 + 0.4 * slope:
            return (0.85, 0.88, 0.92)
        if slope > 0.52:
            return (0.24, 0.21, 0.18)
        return (0.45, 0.4, 0.25) if y < 0.07 else (0.1 + 0.06 * y, 0.25 - 0.08 * y, 0.06)
    land = g.surface(160, 160, lambda u, v: (8 * u - 4, height(8 * u - 4, 8 * v - 4), 4 - 8 * v))
    land["colors"] = [color(p[1], 1 - n[1]) for p, n in zip(land["positions"], land["normals"])]
    del land["uvs"]
    m.node("land", mesh=m.mesh("land", (land, m.material("land", (1, 1, 1, 1), roughness=0.9))))
    m.light("directional", (-5, 4, 1), color=(1, 0.95, 0.85), intensity=3)
    m.light("directional", (3, 6, 5), color=(0.7, 0.8, 1), intensity=0.7)
    m.camera((0, 4.0, 7.4), (0, 0.1, 0.2), yfov_degrees=36)
    return m


def room():
    """Three spot lights and a lamp."""
    m = Model()
    wall = m.material("wall", (0.75, 0.7, 0.62, 1), roughness=0.9)
    wood = m.material("floor", (0.4, 0.25, 0.14, 1), roughness=0.5)
    m.node("walls", mesh=m.mesh("walls", (g.box((-3.1, 0, -2.2), (3.1, 3.2, -2.0)), wall),
                                (g.box((-3.3, 0, -2.2), (-3.1, 3.2, 3)), wall), (g.box((3.1, 0, -2.2), (3.3, 3.2, 3)), wall)))
    m.node("floor", mesh=m.mesh("floor", (g.box((-3.3, -0.1, -2.2), (3.3, 0, 3)), wood)))
    plaster = m.material("plaster", (0.8, 0.8, 0.78, 1), roughness=0.7)
    column = m.mesh("column", (g.box((-0.35, 0, -0.35), (0.35, 0.9, 0.35)), plaster))
    figures = [g.sphere(0.4, 48, 24), g.lathe([(0, 0), (0.3, 0), (0.45, 0.3), (0.2, 0.7), (0.28, 0.85), (0, 0.9)]),
               g.tube(lambda t: (0.3 * math.cos(4 * math.pi * t), 0.12 + 0.7 * t, 0.3 * math.sin(4 * math.pi * t)), 0.1, rows=120)]
    colors = ((1, 0.75, 0.5), (0.75, 0.85, 1), (1, 0.6, 0.65))
    for i, (figure, color) in enumerate(zip(figures, colors)):
        x = -1.9 + 1.9 * i
        m.node(f"column {i}", mesh=column, translation=[x, 0, -0.9])
        m.node(f"figure {i}", mesh=m.mesh(f"figure {i}", (figure, plaster)), translation=[x, 1.3 if i == 0 else 0.9, -0.9])
        m.light("spot", (x, 3.1, 0.9), (x, 1.1, -0.9), color=color, intensity=60,
                spot={"innerConeAngle": 0.22, "outerConeAngle": 0.36})
    m.light("point", (0, 2.6, 2.6), color=(1, 0.9, 0.75), intensity=4)
    m.camera((0, 2.0, 6.8), (0, 1.2, -0.9))
    return m


def materials():
    """Metallic across, roughness down."""
    m = Model()
    ball = g.sphere(0.45, 64, 32)
    for row in range(5):
        for column in range(5):
            metallic, roughness = column / 4, 0.05 + 0.95 * row / 4
            paint = m.material(f"metallic {metallic:.2f} roughness {roughness:.2f}", (0.9, 0.45, 0.2, 1), metallic, roughness)
            m.node(mesh=m.mesh("ball", (ball, paint)), translation=[column - 2, 2 - row, 0])
    m.camera((0, 0, 9.8), (0, 0, 0))
    return m


def glasses():
    """Alpha across, transmission below it, emission in the last row."""
    m = Model()
    ball = g.sphere(0.45, 64, 32)

    def checker(x, y):
        return (210, 210, 205) if (x // 16 + y // 16) % 2 else (60, 62, 70)
    back = m.material("back", (1, 1, 1, 1), roughness=0.9, pbr={"baseColorTexture": m.texture(png(320, 192, checker), nearest=True)})
    wall = {"positions": [(-3, -1.8, -0.7), (3, -1.8, -0.7), (3, 1.8, -0.7), (-3, 1.8, -0.7)],
            "normals": [(0.0, 0.0, 1.0)] * 4, "uvs": [(0, 1), (1, 1), (1, 0), (0, 0)], "indices": [0, 1, 2, 0, 2, 3]}
    m.node("wall", mesh=m.mesh("wall", (wall, back)))
    for i in range(5):
        share = i / 4
        blend = m.material(f"alpha {1 - share:.2f}", (0.2, 0.5, 0.9, 1 - 0.9 * share), roughness=0.3, alphaMode="BLEND")
        glass = m.material(f"transmission {share:.2f}", (0.95, 1, 0.97, 1), roughness=0.0, extensions={
            "KHR_materials_transmission": {"transmissionFactor": share}, "KHR_materials_ior": {"ior": 1.5},
            "KHR_materials_volume": {"thicknessFactor": 0.9}})
        glow = m.material(f"emission {share:.2f}", (0.3, 0.3, 0.3, 1), emissiveFactor=[share, 0.6 * share, 0.1 * share])
        for row, material in enumerate((blend, glass, glow)):
            m.node(mesh=m.mesh("ball", (ball, material)), translation=[1.1 * (i - 2), 1.1 * (1 - row), 0])
    m.camera((0, 0, 8.2), (0, 0, 0))
    return m
