"""Triangles of a glTF model as they stand in its default scene: positions, normals, the first texture coordinates, and of
materials the base colour, metallic and roughness, or their textures without factors. All else is left out, for all renderers alike."""

import json
import pathlib
import struct

import numpy

from .scene import Material, Mesh

TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Document:
    def __init__(self, path):
        data = path.read_bytes()
        self.folder, self.binary = path.parent, None
        if data[:4] == b"glTF":
            length = struct.unpack_from("<I", data, 12)[0]
            self.binary = data[28 + length:]
            data = data[20:20 + length]
        self.json = json.loads(data)

    def view(self, number):
        view = self.json["bufferViews"][number]
        uri = self.json["buffers"][view["buffer"]].get("uri")
        data = (self.folder / uri).read_bytes() if uri else self.binary
        return data[view.get("byteOffset", 0):][:view["byteLength"]], view.get("byteStride")

    def accessor(self, number):
        accessor = self.json["accessors"][number]
        data, stride = self.view(accessor["bufferView"])
        item, width = numpy.dtype(TYPES[accessor["componentType"]]), WIDTHS[accessor["type"]]
        values = numpy.ndarray((accessor["count"], width), item, data, accessor.get("byteOffset", 0),
                               (stride or item.itemsize * width, item.itemsize))
        scale = numpy.iinfo(item).max if accessor.get("normalized") else 1
        return values / numpy.float32(scale) if scale != 1 else values

    def picture(self, texture):
        if texture is None:
            return None
        image = self.json["images"][self.json["textures"][texture["index"]]["source"]]
        return self.view(image["bufferView"])[0] if "bufferView" in image else (self.folder / image["uri"]).read_bytes()

    def material(self, number):
        if number is None:
            return Material("metal_rough", (1, 1, 1), 1.0, 1.0)
        pbr = self.json["materials"][number].get("pbrMetallicRoughness", {})
        color, metal_rough = (self.picture(pbr.get(name)) for name in ("baseColorTexture", "metallicRoughnessTexture"))
        return Material("metal_rough", (1, 1, 1) if color else tuple(pbr.get("baseColorFactor", (1, 1, 1))[:3]),
                        1.0 if metal_rough else pbr.get("roughnessFactor", 1.0),
                        1.0 if metal_rough else pbr.get("metallicFactor", 1.0),
                        color_texture=color, metal_rough_texture=metal_rough)


def matrix_of(node):
    if "matrix" in node:
        return numpy.reshape(node["matrix"], (4, 4)).T
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    matrix = numpy.eye(4)
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                      [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                      [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    matrix[:3, :3] *= node.get("scale", (1, 1, 1))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def read(path):
    document = Document(pathlib.Path(path))
    meshes = []

    def visit(number, outer):
        node = document.json["nodes"][number]
        matrix = outer @ matrix_of(node)
        for part in document.json["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            meshes.append(mesh_of(document, part, matrix))
        for child in node.get("children", ()):
            visit(child, matrix)

    for root in document.json["scenes"][document.json.get("scene", 0)]["nodes"]:
        visit(root, numpy.eye(4))
    return meshes


def mesh_of(document, part, matrix):
    attributes = {name: document.accessor(number) for name, number in part["attributes"].items()
                  if name in ("POSITION", "NORMAL", "TEXCOORD_0")}
    positions = attributes["POSITION"] @ matrix[:3, :3].T + matrix[:3, 3]
    indices = document.accessor(part["indices"]) if "indices" in part else numpy.arange(len(positions))
    triangles = indices.reshape(-1, 3).astype(numpy.uint32)
    if numpy.linalg.det(matrix[:3, :3]) < 0:
        triangles = triangles[:, ::-1]
    normals = attributes.get("NORMAL")
    if normals is not None:
        normals = normals @ numpy.linalg.inv(matrix[:3, :3])
        normals = (normals / numpy.linalg.norm(normals, axis=1, keepdims=True)).astype(numpy.float32)
    uvs = attributes.get("TEXCOORD_0")
    return Mesh(positions.astype(numpy.float32), triangles, document.material(part.get("material")), normals,
                None if uvs is None else uvs.astype(numpy.float32))
