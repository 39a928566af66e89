"""Scenes for Mitsuba 3 (llvm_ad_rgb, path integrator). The time is that of mi.render after the kernels are compiled: it
includes what Dr.Jit needs to find them again, some hundredths of a second."""

import time

import drjit
import mitsuba
import numpy

# The surface at which paths begin to end by chance: lichtraum's choice.
FIRST_ROULETTE = 4


class Mitsuba:
    def __init__(self, sampler):
        mitsuba.set_variant("llvm_ad_rgb")
        mitsuba.set_log_level(mitsuba.LogLevel.Error)
        self.sampler = sampler

    def open(self, scene, job):
        drjit.set_thread_count(job.threads)
        self.samples = job.samples
        camera = scene.camera
        view = mitsuba.ScalarTransform4f().look_at(list(map(float, camera.eye)), list(map(float, camera.target)), [0, 1, 0])
        description = {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": scene.depth + 1, "rr_depth": FIRST_ROULETTE},
            "sensor": {
                "type": "perspective", "fov": camera.fov_x, "fov_axis": "x", "to_world": view, "near_clip": 1e-3,
                "film": {"type": "hdrfilm", "width": job.width, "height": job.height, "rfilter": {"type": "box"},
                         "pixel_format": "rgb", "component_format": "float32"},
                "sampler": {"type": self.sampler, "sample_count": job.samples},
            },
        }
        if isinstance(scene.environment, float):
            if scene.environment > 0:
                description["sky"] = {"type": "constant", "radiance": rgb([scene.environment] * 3)}
        else:
            # Its seam lies at +z, where ours is at -x.
            turn = mitsuba.ScalarTransform4f().rotate([0, 1, 0], 90)
            description["sky"] = {"type": "envmap", "filename": str(scene.environment), "to_world": turn}
        for i, mesh in enumerate(scene.meshes):
            description[f"mesh{i}"] = mesh_of(mesh)
        self.scene = mitsuba.load_dict(description)

    def render(self, seed):
        drjit.sync_thread()
        start = time.perf_counter()
        image = mitsuba.render(self.scene, spp=self.samples, seed=seed)
        drjit.eval(image)
        drjit.sync_thread()
        seconds = time.perf_counter() - start
        return seconds, numpy.array(image)[..., :3]


def rgb(color):
    return {"type": "rgb", "value": [float(part) for part in color]}


def texture_of(file, channel=None):
    """Of a PNG or JPEG: sRGB, or a channel of a linear one."""
    stream = mitsuba.MemoryStream()
    stream.write(file)
    stream.seek(0)
    bitmap = mitsuba.Bitmap(stream)
    if channel is None:
        return {"type": "bitmap", "bitmap": bitmap}
    plane = numpy.array(bitmap)[..., channel : channel + 1].astype(numpy.float32) / 255
    return {"type": "bitmap", "bitmap": mitsuba.Bitmap(plane), "raw": True}


def bsdf_of(material):
    if material.kind == "glass":
        return {"type": "dielectric", "int_ior": material.ior, "ext_ior": 1.0}
    if material.kind == "diffuse":
        return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(material.color)}}
    bsdf = {"type": "principled", "base_color": rgb(material.color), "roughness": material.roughness,
            "metallic": material.metallic, "specular": 0.5}
    if material.color_texture:
        bsdf["base_color"] = texture_of(material.color_texture)
    if material.metal_rough_texture:
        bsdf["roughness"] = texture_of(material.metal_rough_texture, 1)
        bsdf["metallic"] = texture_of(material.metal_rough_texture, 2)
    return {"type": "twosided", "bsdf": bsdf}


def mesh_of(mesh):
    properties = mitsuba.Properties()
    properties["bsdf"] = mitsuba.load_dict(bsdf_of(mesh.material))
    if mesh.material.shines:
        properties["emitter"] = mitsuba.load_dict({"type": "area", "radiance": rgb(mesh.material.emission)})
    shape = mitsuba.Mesh("mesh", len(mesh.positions), len(mesh.triangles), has_vertex_normals=mesh.normals is not None,
                         has_vertex_texcoords=mesh.uvs is not None, props=properties)
    parameters = mitsuba.traverse(shape)
    parameters["vertex_positions"] = mesh.positions.ravel()
    parameters["faces"] = mesh.triangles.ravel()
    if mesh.normals is not None:
        parameters["vertex_normals"] = mesh.normals.ravel()
    if mesh.uvs is not None:
        parameters["vertex_texcoords"] = mesh.uvs.ravel()
    parameters.update()
    return shape
