"""Scenes as .glb, drawn by `lichtraum render`. The time is that of tracing, as --json tells it: from the first kernel's start
until the film is on the host, without reading, building, programs and writing."""

import json
import os
import struct
import subprocess

import numpy

from . import radiance_map


class Lichtraum:
    def __init__(self, program):
        self.program = program

    def open(self, scene, job):
        model = job.folder / "lichtraum.glb"
        write_glb(model, scene)
        self.picture = job.folder / "lichtraum.pfm"
        camera = scene.camera
        self.command = [self.program, "render", str(model), "-q", "--json", "-o", str(self.picture),
                        "--planes", "radiance", "--integrator", "path", "--denoise", "off", "--device", "cpu",
                        "--size", f"{job.width}x{job.height}", "--samples", str(job.samples), "--depth", str(scene.depth),
                        f"--eye={numbers(camera.eye)}", f"--look-at={numbers(camera.target)}",
                        "--fov-x", repr(float(camera.fov_x))]
        sky = scene.environment
        if isinstance(sky, float):
            # Also where it is black, so that all scenes are drawn alike.
            sky = job.folder / "constant.pfm"
            radiance_map.write_pfm(sky, numpy.full((4, 8, 3), scene.environment))
        self.command += ["--environment", str(sky), "--background", "environment"]
        # Both names: PoCL has renamed it.
        threads = str(job.threads)
        self.variables = dict(os.environ, POCL_MAX_PTHREAD_COUNT=threads, POCL_CPU_MAX_CU_COUNT=threads)

    def render(self, seed):
        done = subprocess.run(self.command + ["--seed", str(seed)], capture_output=True, text=True, check=False,
                              env=self.variables)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(self.command)}: {done.stderr.strip()}")
        picture = json.loads(done.stdout)["scenes"][0]["pictures"][0]
        return 1e-3 * picture["trace_ms"], radiance_map.read_pfm(self.picture)


def numbers(values):
    return ",".join(repr(float(value)) for value in values)


def material_json(material, texture):
    """texture: adds a picture, and tells how a material names it."""
    pbr = {"baseColorFactor": [*map(float, material.color), 1.0], "metallicFactor": material.metallic,
           "roughnessFactor": material.roughness}
    extensions = {}
    if material.color_texture:
        pbr["baseColorTexture"] = texture(material.color_texture)
    if material.metal_rough_texture:
        pbr["metallicRoughnessTexture"] = texture(material.metal_rough_texture)
    if material.kind == "diffuse":
        extensions["KHR_materials_specular"] = {"specularFactor": 0.0}
    if material.kind == "glass":
        extensions["KHR_materials_transmission"] = {"transmissionFactor": 1.0}
        extensions["KHR_materials_volume"] = {"thicknessFactor": 1.0}
        extensions["KHR_materials_ior"] = {"ior": material.ior}
    emission = max(material.emission)
    if material.shines:
        extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": emission}
    return {"pbrMetallicRoughness": pbr, "doubleSided": True, "extensions": extensions,
            "emissiveFactor": [part / emission if emission else 0.0 for part in material.emission]}


class Glb:
    """A .glb in the making: its document, and the bytes that follow it."""

    def __init__(self):
        self.document = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], "materials": [], "meshes": [],
                         "nodes": [], "images": [], "textures": []}
        self.blocks, self.size = [], 0

    def add(self, name, item):
        self.document[name].append(item)
        return len(self.document[name]) - 1

    def add_view(self, data):
        view = {"buffer": 0, "byteOffset": self.size, "byteLength": len(data)}
        self.blocks.append(data + bytes(-len(data) % 4))
        self.size += len(self.blocks[-1])
        return self.add("bufferViews", view)

    def add_array(self, array, component, kind, **more):
        return self.add("accessors", {"bufferView": self.add_view(array.tobytes()), "componentType": component,
                                      "count": array.size if kind == "SCALAR" else len(array), "type": kind, **more})

    def add_texture(self, file):
        kind = "image/png" if file[:4] == b"\x89PNG" else "image/jpeg"
        image = self.add("images", {"bufferView": self.add_view(file), "mimeType": kind})
        return {"index": self.add("textures", {"source": image})}

    def add_mesh(self, mesh):
        low, high = (corner.tolist() for corner in (mesh.positions.min(axis=0), mesh.positions.max(axis=0)))
        attributes = {"POSITION": self.add_array(mesh.positions, 5126, "VEC3", min=low, max=high)}
        if mesh.normals is not None:
            attributes["NORMAL"] = self.add_array(mesh.normals, 5126, "VEC3")
        if mesh.uvs is not None:
            attributes["TEXCOORD_0"] = self.add_array(mesh.uvs, 5126, "VEC2")
        part = {"attributes": attributes, "indices": self.add_array(mesh.triangles, 5125, "SCALAR"),
                "material": self.add("materials", material_json(mesh.material, self.add_texture))}
        self.add("nodes", {"mesh": self.add("meshes", {"primitives": [part]})})

    def write(self, path):
        document = {key: value for key, value in self.document.items() if value}
        used = {name for material in document["materials"] for name in material["extensions"]}
        document |= {"scene": 0, "scenes": [{"nodes": list(range(len(document["nodes"])))}],
                     "buffers": [{"byteLength": self.size}]} | ({"extensionsUsed": sorted(used)} if used else {})
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + self.size, len(text), 0x4E4F534A) + text
                         + struct.pack("<II", self.size, 0x004E4942) + b"".join(self.blocks))


def write_glb(path, scene):
    glb = Glb()
    for mesh in scene.meshes:
        glb.add_mesh(mesh)
    glb.write(path)
