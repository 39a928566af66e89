"""Writes glTF 2.0 models as .glb files, with nothing but Python's standard library."""
import json
import math
import struct
import zlib

FLOAT, UINT16, UINT32 = 5126, 5123, 5125
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def png(width, height, pixel):
    """A picture whose pixel (x, y) is pixel(x, y): red, green, blue and perhaps alpha, 0..255, the first row on top."""
    rows = bytearray()
    channels = len(pixel(0, 0))
    for y in range(height):
        rows.append(0)  # no filter
        for x in range(width):
            rows.extend(max(0, min(255, round(c))) for c in pixel(x, y))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b"")


def look_at(eye, target):
    """The matrix (by columns) of something at `eye` whose -z axis points to `target`."""
    back = [e - t for e, t in zip(eye, target)]
    length = math.sqrt(sum(c * c for c in back))
    back = [c / length for c in back]
    right = [back[2], 0.0, -back[0]] if abs(back[1]) < 0.9999 else [1.0, 0.0, 0.0]
    length = math.sqrt(sum(c * c for c in right))
    right = [c / length for c in right]
    up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
          back[0] * right[1] - back[1] * right[0]]
    return [*right, 0, *up, 0, *back, 0, *eye, 1]


def turn(angle_degrees, axis=(0, 1, 0)):
    """A rotation as a quaternion; the axis has unit length."""
    half = math.radians(angle_degrees) / 2
    return [*(math.sin(half) * a for a in axis), math.cos(half)]


class Model:
    def __init__(self):
        self.binary = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "lichtraum's tools/make_models"}, "scene": 0,
                     "scenes": [{"nodes": []}]}

    def add(self, kind, value):
        self.json.setdefault(kind, []).append(value)
        return len(self.json[kind]) - 1

    def extension(self, name):
        used = self.json.setdefault("extensionsUsed", [])
        if name not in used:
            used.append(name)
        return name

    def view(self, data):
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        start = len(self.binary)
        self.binary.extend(data)
        return self.add("bufferViews", {"buffer": 0, "byteOffset": start, "byteLength": len(data)})

    def accessor(self, rows, kind, component=FLOAT):
        """`rows`: a sequence of tuples, or of numbers for SCALAR."""
        flat = list(rows) if kind == "SCALAR" else [c for row in rows for c in row]
        data = struct.pack("<%d%s" % (len(flat), {FLOAT: "f", UINT16: "H", UINT32: "I"}[component]), *flat)
        count = len(flat) // COMPONENTS[kind]
        accessor = {"bufferView": self.view(data), "componentType": component, "count": count, "type": kind}
        if kind == "VEC3" or kind == "SCALAR":
            width = COMPONENTS[kind]
            values = struct.unpack("<%d%s" % (len(flat), {FLOAT: "f", UINT16: "H", UINT32: "I"}[component]), data)
            accessor["min"] = [min(values[i::width]) for i in range(width)]
            accessor["max"] = [max(values[i::width]) for i in range(width)]
        return self.add("accessors", accessor)

    def material(self, name, color=(0.8, 0.8, 0.8, 1), metallic=0.0, roughness=0.6, **more):
        """`more`: other members of the material, as they are."""
        pbr = {"baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}
        pbr.update(more.pop("pbr", {}))
        for extension in more.get("extensions", {}):
            self.extension(extension)
        return self.add("materials", {"name": name, "pbrMetallicRoughness": pbr, **more})

    def texture(self, picture, nearest=False):
        image = self.add("images", {"bufferView": self.view(picture), "mimeType": "image/png"})
        sampler = self.add("samplers", {"magFilter": 9728 if nearest else 9729, "wrapS": 10497, "wrapT": 10497})
        return {"index": self.add("textures", {"source": image, "sampler": sampler})}

    def mesh(self, name, *parts):
        """`parts`: (geometry, material). A geometry is a dictionary, see geometry.py."""
        primitives = []
        for geometry, material in parts:
            attributes = {"POSITION": self.accessor(geometry["positions"], "VEC3")}
            for key, attribute, kind in (("normals", "NORMAL", "VEC3"), ("uvs", "TEXCOORD_0", "VEC2"),
                                         ("colors", "COLOR_0", "VEC3"), ("weights", "WEIGHTS_0", "VEC4")):
                if key in geometry:
                    attributes[attribute] = self.accessor(geometry[key], kind)
            if "joints" in geometry:
                attributes["JOINTS_0"] = self.accessor(geometry["joints"], "VEC4", UINT16)
            wide = len(geometry["positions"]) > 65535
            primitive = {"attributes": attributes, "material": material,
                         "indices": self.accessor(geometry["indices"], "SCALAR", UINT32 if wide else UINT16)}
            if "targets" in geometry:
                primitive["targets"] = [{"POSITION": self.accessor(target, "VEC3")} for target in geometry["targets"]]
            primitives.append(primitive)
        return self.add("meshes", {"name": name, "primitives": primitives})

    def node(self, name=None, parent=None, root=True, **members):
        if name:
            members["name"] = name
        number = self.add("nodes", members)
        if parent is not None:
            self.json["nodes"][parent].setdefault("children", []).append(number)
        elif root:
            self.json["scenes"][0]["nodes"].append(number)
        return number

    def camera(self, eye, target, yfov_degrees=30.0, aspect=4 / 3):
        camera = self.add("cameras", {"type": "perspective", "perspective": {
            "yfov": math.radians(yfov_degrees), "aspectRatio": aspect, "znear": 0.01}})
        return self.node("camera", camera=camera, matrix=look_at(eye, target))

    def light(self, kind, eye, target=(0, 0, 0), color=(1, 1, 1), intensity=1.0, **more):
        name = self.extension("KHR_lights_punctual")
        lights = self.json.setdefault("extensions", {}).setdefault(name, {"lights": []})["lights"]
        lights.append({"type": kind, "color": list(color), "intensity": intensity, **more})
        return self.node(kind, matrix=look_at(eye, target), extensions={name: {"light": len(lights) - 1}})

    def instances(self, name, mesh, translations, scales=None, rotations=None):
        extension = self.extension("EXT_mesh_gpu_instancing")
        attributes = {"TRANSLATION": self.accessor(translations, "VEC3")}
        if scales:
            attributes["SCALE"] = self.accessor(scales, "VEC3")
        if rotations:
            attributes["ROTATION"] = self.accessor(rotations, "VEC4")
        return self.node(name, mesh=mesh, extensions={extension: {"attributes": attributes}})

    def bytes(self):
        self.binary.extend(b"\0" * (-len(self.binary) % 4))
        document = dict(self.json, buffers=[{"byteLength": len(self.binary)}])
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        chunks += struct.pack("<II", len(self.binary), 0x004E4942) + self.binary
        return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks
