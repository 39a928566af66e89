"""Scenes for the benchmarks: the same thing in eSDF and in POV-Ray's language, and large ones of a wanted size.

Everything follows from a seed. World: x right, y up, the camera at the origin looks along -z; colours are linear.
"""

import array
import json
import math
import random
import struct

FOV_X_DEGREES = 60.0
AMBIENT = 0.2


class Thing:
    """A sphere (center, radius) or an axis-parallel box (low, high) of a material's number."""

    def __init__(self, kind, numbers, material):
        self.kind, self.numbers, self.material = kind, numbers, material


class SmallScene:
    """`count` spheres and boxes, half each, above a floor, under `light_count` point lights; eight Phong materials."""

    def __init__(self, count, light_count=3, seed=1):
        chance = random.Random(seed)
        self.materials = [
            ([chance.uniform(0.2, 0.9) for _ in range(3)], chance.uniform(0.2, 0.6), chance.choice([10, 40, 100]))
            for _ in range(8)
        ]
        # As many as there are, they fill about the same part of the picture.
        size = 1.6 / (count / 100.0) ** (1.0 / 3.0) if count > 1 else 3.0
        self.things = []
        if count > 1:
            self.things.append(Thing("box", [-40, -6.2, -60, 40, -6, 0], 0))
        while len(self.things) < count:
            depth = chance.uniform(8, 30)
            reach = depth * 0.5
            center = [chance.uniform(-reach, reach), chance.uniform(-5, 0.45 * depth), -depth] if count > 1 else [0, 0, -9]
            material = chance.randrange(8)
            if len(self.things) % 2 == 1 or count == 1:
                self.things.append(Thing("sphere", center + [size * chance.uniform(0.4, 1)], material))
            else:
                half = [size * chance.uniform(0.3, 0.9) for _ in range(3)]
                low = [c - h for c, h in zip(center, half)]
                high = [c + h for c, h in zip(center, half)]
                self.things.append(Thing("box", low + high, material))
        self.lights = [
            ([chance.uniform(-15, 15), chance.uniform(8, 15), chance.uniform(-10, 5)],
             [chance.uniform(0.5, 1.0) * 1.5 / light_count for _ in range(3)])
            for _ in range(light_count)
        ]

    def esdf(self):
        lines = []
        for i, (color, ks, m) in enumerate(self.materials):
            rgb = words(color)
            lines.append(f"define material m{i} {rgb} {rgb} {words([ks] * 3)} {m}")
        for i, thing in enumerate(self.things):
            lines.append(f"define shape {thing.kind} s{i} {words(thing.numbers)} m{thing.material}")
        lines.append(f"define light ambient sky {words([AMBIENT] * 3)}")
        for i, (position, color) in enumerate(self.lights):
            lines.append(f"define light diffuse l{i} {words(position)} {words(color)}")
        lines.append("define background 0.1 0.1 0.12")
        lines.append(f"define camera eye {FOV_X_DEGREES:g}")
        lines.append("render eye picture.png 1280 720")
        return "\n".join(lines) + "\n"

    def povray(self, aspect):
        distance = 0.5 * aspect / math.tan(math.radians(FOV_X_DEGREES) / 2)
        lines = [
            "#version 3.7;",
            "global_settings { assumed_gamma 1 max_trace_level 5 ambient_light rgb 1 }",
            "background { rgb <0.1, 0.1, 0.12> }",
            f"camera {{ perspective location <0,0,0> direction <0,0,{-distance!r}> right <{aspect!r},0,0> up <0,1,0> }}",
        ]
        for i, (color, ks, m) in enumerate(self.materials):
            # Phong's highlight has the light's colour there; Ks is grey here for that reason.
            lines.append(f"#declare M{i} = texture {{ pigment {{ rgb {vector(color)} }} "
                         f"finish {{ ambient {AMBIENT} diffuse 1 phong {ks!r} phong_size {m} }} }}")
        for thing in self.things:
            n = thing.numbers
            shape = (f"sphere {{ {vector(n[:3])}, {n[3]!r}" if thing.kind == "sphere"
                     else f"box {{ {vector(n[:3])}, {vector(n[3:])}")
            lines.append(f"{shape} texture {{ M{thing.material} }} }}")
        for position, color in self.lights:
            lines.append(f"light_source {{ {vector(position)}, rgb {vector(color)} }}")
        return "\n".join(lines) + "\n"


def words(numbers):
    return " ".join(repr(n) for n in numbers)


def vector(numbers):
    return "<" + ", ".join(repr(n) for n in numbers) + ">"


def write_sphere_cloud(path, count, light_count=1, seed=1):
    """An eSDF file of `count` spheres that fill a cube before the camera."""
    chance = random.Random(seed)
    radius = 4.0 / count ** (1.0 / 3.0)
    with open(path, "w", encoding="ascii") as out:
        out.write("define material grey 0.5 0.5 0.5 0.7 0.7 0.7 0.3 0.3 0.3 20\n")
        for i in range(count):
            x, y, z = chance.uniform(-5, 5), chance.uniform(-5, 5), chance.uniform(-17, -7)
            out.write(f"define shape sphere s{i} {x:.5f} {y:.5f} {z:.5f} {radius:.6f} grey\n")
        write_surroundings(out, light_count)


def write_surroundings(out, light_count):
    out.write("define light ambient sky 0.2 0.2 0.2\n")
    for i in range(light_count):
        angle = 2 * math.pi * i / light_count
        brightness = 0.9 / light_count
        out.write(f"define light diffuse l{i} {12 * math.cos(angle):.4f} {14 + i % 7} {12 * math.sin(angle):.4f} "
                  f"{brightness} {brightness} {brightness}\n")
    out.write(f"define camera eye {FOV_X_DEGREES:g}\nrender eye picture.png 1280 720\n")


def write_terrain(path, triangle_count):
    """A .glb of a wavy sheet of about that many triangles before the camera; returns how many there are."""
    side = max(2, round(math.sqrt(triangle_count / 2)))
    positions = array.array("f")
    for j in range(side + 1):
        v = j / side
        row = array.array("f")
        for i in range(side + 1):
            u = i / side
            height = math.sin(19 * u + 3) * math.cos(23 * v) + 0.3 * math.sin(97 * u) * math.sin(89 * v)
            row.extend((20 * u - 10, -4 + 0.8 * height, -4 - 20 * v))
        positions.extend(row)
    indices = array.array("I")
    for j in range(side):
        base = j * (side + 1)
        for i in range(base, base + side):
            indices.extend((i, i + 1, i + side + 2, i, i + side + 2, i + side + 1))
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": 4 * (len(positions) + len(indices))}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 4 * len(positions)},
            {"buffer": 0, "byteOffset": 4 * len(positions), "byteLength": 4 * len(indices)},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(positions) // 3, "type": "VEC3",
             "min": [min(positions[a::3]) for a in range(3)], "max": [max(positions[a::3]) for a in range(3)]},
            {"bufferView": 1, "componentType": 5125, "count": len(indices), "type": "SCALAR"},
        ],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary_bytes = 4 * (len(positions) + len(indices))
    with open(path, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + binary_bytes))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text)
        out.write(struct.pack("<I4s", binary_bytes, b"BIN\0"))
        positions.tofile(out)
        indices.tofile(out)
    return len(indices) // 3
