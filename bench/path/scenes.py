"""The six scenes. Those that need a file (kitchen, textured) are None without it."""

import numpy

from . import gltf_reader, radiance_map
from .meshes import box, joined, octahedron, quad, sphere, torus
from .scene import Camera, Material, Scene


def diffuse(*color):
    return Material("diffuse", color)


def lamp(*radiance):
    return Material("diffuse", emission=radiance)


def cornell(files):
    """Two blocks in a box that is open to the camera. The lamp fills a hole of the ceiling, so its back is not seen."""
    white, red, green = diffuse(0.725, 0.71, 0.68), diffuse(0.63, 0.065, 0.05), diffuse(0.14, 0.45, 0.091)
    x, z = 0.235, 0.19  # the hole's half sides
    low = [quad((-1, -1, 1), (1, -1, 1), (1, -1, -1), (-1, -1, -1), white),
           quad((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), white)]
    ceiling = [quad((a, 1, c), (b, 1, c), (b, 1, d), (a, 1, d), white)
               for a, b, c, d in ((-1, -x, -1, 1), (x, 1, -1, 1), (-x, x, -1, -z), (-x, x, z, 1))]
    blocks = [box((-0.335, -0.4, -0.38), (0.3, 0.6, 0.3), 18.25, white),
              box((0.33, -0.7, 0.28), (0.3, 0.3, 0.3), -18.25, white)]
    return Scene("Cornell's box", Camera((0, 0, 4), (0, 0, 0), 38, aspect=1), [
        joined(low + ceiling + blocks),
        quad((-1, -1, 1), (-1, -1, -1), (-1, 1, -1), (-1, 1, 1), red),
        quad((1, -1, -1), (1, -1, 1), (1, 1, 1), (1, 1, -1), green),
        quad((-x, 1, -z), (x, 1, -z), (x, 1, z), (-x, 1, z), lamp(18.4, 14.0, 6.8)),
    ])


def kitchen(files):
    if files.kitchen is None:
        return None
    meshes = gltf_reader.read(files.kitchen)
    for part in meshes:
        part.material, part.normals, part.uvs = diffuse(0.7, 0.7, 0.7), None, None
    eye = numpy.array((1.2110, 1.80475, 3.8524))
    return Scene("kitchen, white sky", Camera(tuple(eye), tuple(eye + (-0.4381, -0.0417, -0.898)), 75), meshes, 1.0)


def spheres(files):
    """Five rows of metals and coloured dielectrics, from smooth to rough, on a matt floor."""
    colors = ((0.95, 0.93, 0.88), (1.0, 0.77, 0.34), (0.95, 0.64, 0.54), (0.15, 0.35, 0.7), (0.7, 0.12, 0.1))
    meshes = [ground(8, diffuse(0.4, 0.4, 0.4))]
    for row, color in enumerate(colors):
        for column in range(7):
            material = Material("metal_rough", color, 0.15 + 0.075 * column, 1.0 if row < 3 else 0.0)
            meshes.append(sphere((1.1 * (column - 3), 0.5, 1.1 * (2 - row)), 0.5, material))
    return Scene("35 glossy spheres, HDR", Camera((0, 6, 8), (0, 0.2, 0.3), 52), meshes, files.environment)


def textured(files):
    """A model on a matt floor, seen from the front, whatever its size."""
    if files.model is None:
        return None
    meshes = gltf_reader.read(files.model)
    positions = numpy.concatenate([part.positions for part in meshes])
    low, high = positions.min(axis=0), positions.max(axis=0)
    middle, size = (low + high) / 2, float(numpy.linalg.norm(high - low))
    floor = ground(4 * size, diffuse(0.5, 0.5, 0.5))
    floor.positions += (middle[0], low[1], middle[2])
    eye = middle + size * numpy.array((0.5, 0.35, 1.1))
    return Scene("textured model, HDR", Camera(tuple(eye), tuple(middle), 50), meshes + [floor], files.environment)


def glass(files):
    clear = Material("glass", (1, 1, 1), 0.0)
    meshes = [ground(8, diffuse(0.4, 0.37, 0.33)),
              sphere((-1.6, 0.85, 0), 0.8, clear), torus((0.4, 0.35, 0.9), 0.8, 0.33, clear),
              box((1.9, 0.75, -0.3), (0.6, 0.7, 0.6), 30, clear), sphere((0.4, 0.35, 0.9), 0.35, diffuse(0.7, 0.15, 0.1)),
              sphere((0.1, 0.7, -1.6), 0.7, diffuse(0.15, 0.3, 0.65)), sphere((-0.8, 0.3, 1.8), 0.3, clear)]
    return Scene("glass, soft sky", Camera((0, 2.6, 6.2), (0.1, 0.5, 0), 42), meshes, files.soft_environment, depth=16)


def lamps(files):
    """A town by night: 64 blocks, and between them 1,250 octahedra that shine in eight colours."""
    chance = numpy.random.default_rng(1)
    grey = diffuse(0.6, 0.6, 0.6)
    blocks = []
    for x in range(-7, 8, 2):
        for z in range(-7, 8, 2):
            half = chance.uniform((0.3, 0.2, 0.3), (0.6, 1.2, 0.6))
            blocks.append(box((x, half[1], z), half, chance.uniform(0, 90), grey))
    centers = chance.uniform((-9, 0.1, -9), (9, 1.2, 9), (1250, 3))
    across = 2 * chance.integers(2, size=1250)  # x or z of the street's middle
    rows = numpy.arange(1250)
    centers[rows, across] = 2 * numpy.round(centers[rows, across] / 2) + chance.uniform(-0.1, 0.1, 1250)
    meshes = [ground(10, grey), joined(blocks)]
    for group in numpy.array_split(centers, 8):
        light = lamp(*chance.uniform(1, 10, 3))
        meshes.append(joined([octahedron(center, chance.uniform(0.02, 0.06), light) for center in group]))
    return Scene("10,000 lamps", Camera((4, 9, 11), (0, 0, 0.5), 55), meshes)


def ground(half, material):
    return quad((-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half), material)


ALL = {"cornell": cornell, "kitchen": kitchen, "spheres": spheres, "textured": textured, "glass": glass, "lamps": lamps}
