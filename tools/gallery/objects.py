"""Single objects, each a function that returns a Model."""
import math

import geometry as g
from glb import Model, png, turn

UPRIGHT = (0.0, 0.0, 1.0)  # at right angles to curves in the xy plane


def spring():
    m = Model()
    steel = m.material("steel", (0.75, 0.77, 0.8, 1), metallic=1.0, roughness=0.25)
    plate = m.material("plate", (0.35, 0.12, 0.1, 1), roughness=0.5)
    turns = 7

    def coil(t):
        a = 2 * math.pi * turns * t
        return (math.cos(a), 0.15 + 2.6 * t, math.sin(a))
    m.node("coil", mesh=m.mesh("coil", (g.tube(coil, 0.13, rows=420), steel)))
    for name, y in (("foot", 0.0), ("head", 2.85)):
        disc = g.lathe([(0, y), (1.3, y), (1.3, y + 0.1), (0, y + 0.1)], rows=3, smooth=False)
        del disc["normals"]
        m.node(name, mesh=m.mesh(name, (disc, plate)))
    m.camera((3.8, 3.4, 6.4), (0, 1.4, 0))
    return m


def gears():
    m = Model()

    def wheel(teeth, radius):
        outline = []
        for i in range(teeth):
            for step, r in ((-0.28, radius - 0.1), (-0.14, radius + 0.12), (0.14, radius + 0.12), (0.28, radius - 0.1)):
                a = 2 * math.pi * (i + step) / teeth
                outline.append((r * math.cos(a), r * math.sin(a)))
        return g.extrude(outline, 0.35, hole=0.3)
    brass = m.material("brass", (0.85, 0.6, 0.25, 1), metallic=1.0, roughness=0.35)
    steel = m.material("steel", (0.6, 0.63, 0.68, 1), metallic=1.0, roughness=0.4)
    m.node("large", mesh=m.mesh("large", (wheel(24, 1.6), brass)))
    m.node("small", mesh=m.mesh("small", (wheel(12, 0.8), steel)), translation=[2.42, 0, 0], rotation=turn(15, (0, 0, 1)))
    m.node("top", mesh=m.mesh("top", (wheel(12, 0.8), steel)), translation=[-1.2, 2.1, 0],
           rotation=turn(4, (0, 0, 1)))
    m.camera((1.8, 1.2, 10.2), (0.55, 0.6, 0.1))
    return m


def globe():
    m = Model()

    def map_pixel(x, y):
        latitude = abs(y - 127.5) / 127.5
        height = g.noise(x / 64, y / 64, period=8, seed=3)
        if latitude + 0.25 * (height - 0.5) > 0.86:
            return (240, 245, 250)
        if height < 0.52:
            shade = height / 0.52
            return (20 + 20 * shade, 50 + 70 * shade, 110 + 70 * shade)
        land = (height - 0.52) / 0.3
        dry = 1 - abs(latitude - 0.3) * 3 if latitude < 0.6 else 0
        return (70 + 120 * land + 70 * max(dry, 0), 110 + 30 * land, 50 + 20 * land)
    sea = m.material("map", roughness=0.35, pbr={"baseColorTexture": m.texture(png(512, 256, map_pixel))},
                     color=(1, 1, 1, 1))
    wood = m.material("wood", (0.3, 0.14, 0.06, 1), roughness=0.4)
    brass = m.material("brass", (0.85, 0.6, 0.25, 1), metallic=1.0, roughness=0.3)
    tilted = m.node("axis", rotation=turn(-23.4, (0, 0, 1)))
    m.node("globe", parent=tilted, mesh=m.mesh("globe", (g.sphere(1.0, 96, 48), sea)), rotation=turn(-60))
    ring = g.tube(lambda t: (1.12 * math.cos(math.pi * (t - 0.5)), 1.12 * math.sin(math.pi * (t - 0.5)), 0.0), 0.04,
                  aside=UPRIGHT)
    pin = g.tube(lambda t: (0.0, -1.14 + 2.28 * t, 0.0), 0.025, rows=8, aside=UPRIGHT)
    m.node("ring", parent=tilted, mesh=m.mesh("ring", (ring, brass), (pin, brass)))
    foot = g.lathe([(0, -1.9), (0.7, -1.9), (0.7, -1.8), (0.5, -1.74), (0.14, -1.6), (0.1, -1.35), (0.14, -1.2), (0, -1.12)])
    m.node("foot", mesh=m.mesh("foot", (foot, wood)))
    m.camera((2.0, 0.9, 6.6), (0, -0.3, 0))
    return m


def jug():
    m = Model()
    glaze = m.material("glaze", (0.12, 0.3, 0.42, 1), roughness=0.18)
    body = g.lathe([(0, 0), (0.62, 0), (0.7, 0.05), (0.95, 0.5), (1.0, 0.9), (0.8, 1.45), (0.52, 1.8), (0.5, 2.05),
                    (0.64, 2.3), (0.6, 2.3), (0.46, 2.05), (0.47, 1.8), (0.74, 1.45), (0.93, 0.9), (0.88, 0.5),
                    (0.6, 0.12), (0, 0.1)], rows=128)
    handle = g.tube(lambda t: g.spline([(0.55, 2.0, 0.0), (1.0, 2.3, 0.0), (1.5, 1.9, 0.0), (1.4, 1.2, 0.0),
                                        (0.93, 0.75, 0.0)], t), lambda t: 0.1 - 0.03 * math.sin(math.pi * t), rows=64, aside=UPRIGHT)
    spout = g.tube(lambda t: g.spline([(-0.75, 0.7, 0.0), (-1.25, 1.0, 0.0), (-1.4, 1.5, 0.0), (-1.8, 1.8, 0.0)], t),
                   lambda t: 0.24 - 0.14 * t, rows=48, aside=UPRIGHT)
    m.node("jug", mesh=m.mesh("jug", (body, glaze), (handle, glaze), (spout, glaze)))
    table = m.material("table", (0.75, 0.72, 0.66, 1), roughness=0.8)
    m.node("table", mesh=m.mesh("table", (g.floor(3.2), table)))
    m.camera((1.4, 3.4, 6.6), (-0.1, 1.0, 0))
    return m


def knot():
    m = Model()

    def curve(t):
        a = 2 * math.pi * t
        r = 1.5 + 0.6 * math.cos(3 * a)
        return (r * math.cos(2 * a), r * math.sin(2 * a), 0.75 * math.sin(3 * a))
    geometry = g.tube(curve, 0.3, columns=32, rows=300, closed=True, aside=UPRIGHT)
    colors = []
    for _, v in geometry["uvs"]:  # a rainbow along the knot
        colors.append(tuple(0.5 + 0.45 * math.cos(2 * math.pi * (v + k / 3)) for k in range(3)))
    geometry["colors"] = colors
    m.node("knot", mesh=m.mesh("knot", (geometry, m.material("rainbow", (1, 1, 1, 1), roughness=0.3))))
    m.camera((0.6, 1.2, 9.6), (0, 0, 0))
    return m


def sponge():
    m = Model()
    m.material("sponge", (0.9, 0.72, 0.35, 1), roughness=0.9)
    cubes = [(0.0, 0.0, 0.0)]
    size = 3.0
    for _ in range(3):
        size /= 3
        cubes = [(x + size * i, y + size * j, z + size * k) for x, y, z in cubes
                 for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1) if (i == 0) + (j == 0) + (k == 0) < 2]
    half = size / 2
    cube = m.mesh("cube", (g.box((-half,) * 3, (half,) * 3), 0))
    m.instances("sponge", cube, cubes)
    m.camera((5.0, 3.9, 7.5), (0, -0.1, 0))
    return m


def fence():
    """A picture whose holes are cut out of the surface, and of its shadow."""
    m = Model()

    def leaf_pixel(x, y):
        u, v = (x + 0.5) / 64 % 1 - 0.5, (y + 0.5) / 64 % 1 - 0.5
        is_wire = abs(abs(u) - abs(v)) < 0.1 or max(abs(u), abs(v)) > 0.44
        return (60, 95, 70, 255 if is_wire else 0)
    wire = m.material("wire", (1, 1, 1, 1), roughness=0.5, alphaMode="MASK", doubleSided=True,
                      pbr={"baseColorTexture": dict(m.texture(png(64, 64, leaf_pixel)), extensions={
                          m.extension("KHR_texture_transform"): {"scale": [8, 4]}})})
    panel = {"positions": [(-2, 0, 0), (2, 0, 0), (2, 2, 0), (-2, 2, 0)], "normals": [(0.0, 0.0, 1.0)] * 4,
             "uvs": [(0, 1), (1, 1), (1, 0), (0, 0)], "indices": [0, 1, 2, 0, 2, 3]}
    m.node("fence", mesh=m.mesh("fence", (panel, wire)))
    red = m.material("ball", (0.75, 0.15, 0.1, 1), roughness=0.4)
    m.node("ball", mesh=m.mesh("ball", (g.sphere(0.6, 48, 24), red)), translation=[0.4, 0.6, -1.0])
    ground = m.material("ground", (0.7, 0.68, 0.62, 1), roughness=0.9)
    m.node("ground", mesh=m.mesh("ground", (g.floor(5), ground)))
    m.light("directional", (-2, 4, -3), intensity=3)
    m.light("directional", (3, 3, 6), intensity=1)
    m.camera((1.8, 2.6, 6.4), (0, 0.75, 0))
    return m
