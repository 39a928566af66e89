"""Small meshes to build scenes of."""

import numpy

from .scene import Mesh


def mesh(positions, triangles, material, normals=None):
    smooth = None if normals is None else numpy.asarray(normals, numpy.float32).reshape(-1, 3)
    return Mesh(numpy.asarray(positions, numpy.float32).reshape(-1, 3),
                numpy.asarray(triangles, numpy.uint32).reshape(-1, 3), material, smooth)


def joined(meshes):
    """One mesh of several flat ones; the material is that of the first."""
    offsets = numpy.cumsum([0] + [len(m.positions) for m in meshes[:-1]])
    return mesh(numpy.concatenate([m.positions for m in meshes]),
                numpy.concatenate([m.triangles + offset for m, offset in zip(meshes, offsets)]), meshes[0].material)


def quad(a, b, c, d, material):
    """Corners counter-clockwise, seen from its front."""
    return mesh([a, b, c, d], [[0, 1, 2], [0, 2, 3]], material)


def box(center, half, turn_degrees, material):
    """Turned about the y axis."""
    corners = numpy.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]) * half
    angle = numpy.radians(turn_degrees)
    cosine, sine = numpy.cos(angle), numpy.sin(angle)
    turned = corners @ numpy.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]]) + center
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3)]
    return joined([quad(*turned[list(face)], material) for face in faces])


def octahedron(center, radius, material):
    ends = numpy.concatenate([numpy.eye(3), -numpy.eye(3)]) * radius + center
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    return mesh(ends, faces, material)


def grid_of_revolution(point, normal, columns, rows, material):
    """Of smooth functions of u (round about) and v, both 0..1."""
    u, v = numpy.meshgrid(numpy.linspace(0, 1, columns + 1), numpy.linspace(0, 1, rows + 1))
    first = numpy.arange(rows)[:, None] * (columns + 1) + numpy.arange(columns)
    right, below = first + 1, first + columns + 1
    triangles = numpy.stack([first, below, below + 1, first, below + 1, right], axis=-1).reshape(-1, 3)
    positions = numpy.stack(numpy.broadcast_arrays(*point(u, v)), axis=-1).reshape(-1, 3)
    normals = numpy.stack(numpy.broadcast_arrays(*normal(u, v)), axis=-1).reshape(-1, 3)
    corners = positions[triangles]
    areas = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return mesh(positions, triangles[areas > 1e-9 * areas.max()], material, normals)


def sphere(center, radius, material, columns=96, rows=48):
    def normal(u, v):
        phi, theta = 2 * numpy.pi * u, numpy.pi * v
        return numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta), numpy.sin(theta) * numpy.cos(phi)

    def point(u, v):
        return [c + radius * n for c, n in zip(center, normal(u, v))]

    return grid_of_revolution(point, normal, columns, rows, material)


def torus(center, radius, tube, material, columns=128, rows=64):
    """About the y axis through its center."""
    def normal(u, v):
        phi, theta = 2 * numpy.pi * u, 2 * numpy.pi * v
        return numpy.cos(theta) * numpy.sin(phi), -numpy.sin(theta), numpy.cos(theta) * numpy.cos(phi)

    def point(u, v):
        phi = 2 * numpy.pi * u
        around = numpy.sin(phi), 0, numpy.cos(phi)
        return [c + radius * a + tube * n for c, a, n in zip(center, around, normal(u, v))]

    return grid_of_revolution(point, normal, columns, rows, material)
