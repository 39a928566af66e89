"""Scenes for Cycles, in Blender's Python module. The time is what Cycles itself calls render time and writes into its .exr files:
from the first sample's start to the end of the last, without synchronization and building."""

import math
import os
import re
import struct

import bpy
import mathutils
import numpy


class Cycles:
    def __init__(self):
        # Blender tells of each step on standard output.
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)

    def open(self, scene, job):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        self.picture = job.folder / "cycles.exr"
        self.folder = job.folder
        set_options(self.scene, scene, job)
        add_camera(self.scene, scene.camera)
        add_sky(self.scene, scene.environment)
        for i, mesh in enumerate(scene.meshes):
            add_mesh(self.scene, mesh, self.folder, f"mesh{i}")
        self.scene.render.filepath = str(self.picture)

    def render(self, seed):
        self.scene.cycles.seed = seed
        bpy.ops.render.render(write_still=True)
        head = self.picture.read_bytes()[:65536]
        image = bpy.data.images.load(str(self.picture), check_existing=False)
        image.colorspace_settings.name = "Non-Color"
        width, height = image.size
        pixels = numpy.empty(4 * width * height, numpy.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
        return render_seconds(head), pixels.reshape(height, width, 4)[::-1, :, :3].copy()


def render_seconds(head):
    """From the header of an .exr: an attribute is its name, its type, the length of its value, and that."""
    found = re.search(rb"cycles\.[^\0]*\.render_time\0string\0", head)
    length = struct.unpack_from("<I", head, found.end())[0]
    seconds = 0.0
    for part in head[found.end() + 4 :][:length].decode().split(":"):
        seconds = 60 * seconds + float(part)
    return seconds


def set_options(target, scene, job):
    render, cycles = target.render, target.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = job.width, job.height, 100
    render.threads_mode, render.threads = "FIXED", job.threads
    render.use_persistent_data = True
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode, render.image_settings.color_depth = "RGB", "32"
    target.view_settings.view_transform = "Raw"
    cycles.device, cycles.samples = "CPU", job.samples
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    bounces = scene.depth - 1  # the first surface is no bounce there
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
    # Paths begin to end by chance where those of the others do.
    cycles.min_light_bounces = 2


def blender(v):
    """glTF's y up is Blender's z up."""
    return mathutils.Vector((v[0], -v[2], v[1]))


def blender_rows(array):
    return numpy.ascontiguousarray(array[:, [0, 2, 1]] * numpy.float32([1, -1, 1]))


def add_camera(target, camera):
    data = bpy.data.cameras.new("eye")
    data.sensor_fit, data.angle = "HORIZONTAL", math.radians(camera.fov_x)
    data.clip_start, data.clip_end = 1e-3, 1e5
    eye = bpy.data.objects.new("eye", data)
    eye.location = blender(camera.eye)
    eye.rotation_mode = "QUATERNION"
    eye.rotation_quaternion = (blender(camera.target) - blender(camera.eye)).to_track_quat("-Z", "Y")
    target.collection.objects.link(eye)
    target.camera = eye


def nodes_of(tree):
    tree.nodes.clear()
    return tree.nodes, tree.links


def add_sky(target, environment):
    world = target.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    nodes, links = nodes_of(world.node_tree)
    background, output = nodes.new("ShaderNodeBackground"), nodes.new("ShaderNodeOutputWorld")
    links.new(background.outputs[0], output.inputs[0])
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = 1.0
    if isinstance(environment, float):
        background.inputs["Strength"].default_value = environment
    else:
        image = nodes.new("ShaderNodeTexEnvironment")
        image.image = bpy.data.images.load(str(environment))
        links.new(image.outputs["Color"], background.inputs["Color"])


def add_material(material, folder, name):
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    nodes, links = nodes_of(result.node_tree)
    output = nodes.new("ShaderNodeOutputMaterial")
    color = (*map(float, material.color), 1.0)

    def picture(file, space):
        path = folder / f"{name}-{space}"
        path.write_bytes(file)
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = bpy.data.images.load(str(path))
        texture.image.colorspace_settings.name = space
        return texture.outputs["Color"]

    if material.shines:
        surface = nodes.new("ShaderNodeEmission")
        strength = max(material.emission)
        surface.inputs["Color"].default_value = (*(part / strength for part in material.emission), 1.0)
        surface.inputs["Strength"].default_value = strength
        result.cycles.emission_sampling = "FRONT"  # nobody sees the others
    elif material.kind == "diffuse":
        surface = nodes.new("ShaderNodeBsdfDiffuse")
        surface.inputs["Color"].default_value = color
    elif material.kind == "glass":
        surface = nodes.new("ShaderNodeBsdfGlass")
        surface.inputs["Color"].default_value = color
        surface.inputs["Roughness"].default_value = 0.0
        surface.inputs["IOR"].default_value = material.ior
    else:
        surface = nodes.new("ShaderNodeBsdfPrincipled")
        surface.inputs["Base Color"].default_value = color
        surface.inputs["Roughness"].default_value = material.roughness
        surface.inputs["Metallic"].default_value = material.metallic
        if material.color_texture:
            links.new(picture(material.color_texture, "sRGB"), surface.inputs["Base Color"])
        if material.metal_rough_texture:
            channels = nodes.new("ShaderNodeSeparateColor")
            links.new(picture(material.metal_rough_texture, "Non-Color"), channels.inputs[0])
            links.new(channels.outputs["Green"], surface.inputs["Roughness"])
            links.new(channels.outputs["Blue"], surface.inputs["Metallic"])
    links.new(surface.outputs[0], output.inputs["Surface"])
    return result


def add_mesh(target, mesh, folder, name):
    data = bpy.data.meshes.new(name)
    count = len(mesh.triangles)
    data.vertices.add(len(mesh.positions))
    data.vertices.foreach_set("co", blender_rows(mesh.positions).ravel())
    data.loops.add(3 * count)
    data.loops.foreach_set("vertex_index", mesh.triangles.astype(numpy.int32).ravel())
    data.polygons.add(count)
    data.polygons.foreach_set("loop_start", numpy.arange(0, 3 * count, 3, dtype=numpy.int32))
    if mesh.uvs is not None:
        layer = data.uv_layers.new()
        upward = mesh.uvs * numpy.float32([1, -1]) + numpy.float32([0, 1])
        layer.data.foreach_set("uv", upward[mesh.triangles.ravel()].ravel())
    data.update(calc_edges=True)
    if mesh.normals is None:
        data.shade_flat()
    else:
        data.normals_split_custom_set_from_vertices(blender_rows(mesh.normals))
    data.materials.append(add_material(mesh.material, folder, name))
    target.collection.objects.link(bpy.data.objects.new(name, data))
