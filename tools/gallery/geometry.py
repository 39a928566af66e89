"""Geometries as dictionaries of lists: positions, indices, and perhaps normals, uvs, colors."""
import math


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v) if length > 1e-12 else (0.0, 1.0, 0.0)


def surface(columns, rows, point):
    """A smooth sheet of columns x rows cells: point(u, v) with u and v in 0..1. Seen from outside, v is counter-clockwise from u."""
    step = 1e-4
    positions, normals, uvs = [], [], []
    for j in range(rows + 1):
        for i in range(columns + 1):
            u, v = i / columns, j / rows
            positions.append(tuple(point(u, v)))
            # At a pole, where one derivative is gone, look a little beside it.
            inner = min(max(v, 2 * step), 1 - 2 * step)
            du = subtract(point(u + step, inner), point(u - step, inner))
            dv = subtract(point(u, inner + step), point(u, inner - step))
            normals.append(unit(cross(du, dv)))
            uvs.append((u, v))
    indices = []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b, c, d = a + 1, a + columns + 2, a + columns + 1
            indices.extend((a, b, c, a, c, d))
    return {"positions": positions, "normals": normals, "uvs": uvs, "indices": indices}


def sphere(radius=1.0, columns=64, rows=32):
    def point(u, v):
        a, b = 2 * math.pi * u, math.pi * v
        return (radius * math.sin(b) * math.cos(-a), radius * math.cos(b), radius * math.sin(b) * math.sin(-a))
    geometry = surface(columns, rows, point)
    geometry["normals"] = [unit(p) for p in geometry["positions"]]
    geometry["indices"] = geometry["indices"][::-1]  # v runs down
    return geometry


def spline(points, t):
    """A curve through the points (Catmull-Rom), t in 0..1."""
    t = min(max(t, 0.0), 1.0) * (len(points) - 1)
    i = min(int(t), len(points) - 2)
    f = t - i
    p = [points[max(0, min(len(points) - 1, i + k))] for k in (-1, 0, 1, 2)]
    return tuple(0.5 * (2 * b + f * (c - a) + f * f * (2 * a - 5 * b + 4 * c - d) + f ** 3 * (3 * b - a - 3 * c + d))
                 for a, b, c, d in zip(*p))


def lathe(profile, columns=48, rows=64, smooth=True):
    """Turns a profile of (radius, height), from the bottom up, about the y axis."""
    def at(v):
        if smooth:
            return spline(profile, v)
        t = min(max(v, 0.0), 1.0) * (len(profile) - 1)
        i = min(int(t), len(profile) - 2)
        return tuple(a + (t - i) * (b - a) for a, b in zip(profile[i], profile[i + 1]))

    def point(u, v):
        r, y = at(v)
        r = max(r, 0.0)
        return (r * math.cos(-2 * math.pi * u), y, r * math.sin(-2 * math.pi * u))
    return surface(columns, rows, point)


def tube(curve, radius, columns=24, rows=200, closed=False, aside=(0.0, 1.0, 0.0)):
    """A pipe along curve(t), t in 0..1, with caps unless it is closed. The curve must never run along `aside`."""
    def frame(t):
        h = 1e-4
        if not closed:
            t = min(max(t, h), 1 - h)
        tangent = unit(subtract(curve(t + h), curve(t - h)))
        x = unit(cross(aside, tangent))
        return x, cross(tangent, x)

    def point(u, v):
        center = curve(v)
        x, y = frame(v)
        r = radius(v) if callable(radius) else radius
        a = 2 * math.pi * u
        return tuple(c + r * (math.cos(a) * p + math.sin(a) * q) for c, p, q in zip(center, x, y))
    geometry = surface(columns, rows, point)
    if not closed:
        for v, first in ((0.0, 0), (1.0, rows * (columns + 1))):
            center = len(geometry["positions"])
            geometry["positions"].append(tuple(curve(v)))
            normal = unit(subtract(curve(v), curve(0.02 if v == 0 else 0.98)))
            geometry["normals"].append(normal)
            geometry["uvs"].append((0.5, v))
            for i in range(columns):
                edge = (first + i + 1, first + i) if v == 0 else (first + i, first + i + 1)
                geometry["indices"].extend((center, *edge))
    return geometry


def box(low, high):
    """With flat sides: each has vertices of its own."""
    positions, normals, uvs, indices = [], [], [], []
    for axis in range(3):
        for side in (0, 1):
            x, y = (axis + 1) % 3, (axis + 2) % 3
            first = len(positions)
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = [0.0, 0.0, 0.0]
                p[axis] = (low, high)[side][axis]
                p[x] = (low, high)[a][x]
                p[y] = (low, high)[b][y]
                positions.append(tuple(p))
                normals.append(tuple(float(side * 2 - 1) if i == axis else 0.0 for i in range(3)))
                uvs.append((a, 1 - b) if axis == 2 else (b, 1 - a))
            order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
            indices.extend(first + i for i in order)
    return {"positions": positions, "normals": normals, "uvs": uvs, "indices": indices}


def extrude(outline, depth, hole=0.0):
    """A plate with the outline (x, y), counter-clockwise around the origin, from z = 0 to `depth`; `hole`: its radius."""
    n = len(outline)
    inner = [tuple(hole * c for c in unit(p)) for p in outline]
    positions, indices = [], []

    def quad(a, b, c, d):
        first = len(positions)
        positions.extend((a, b, c, d))
        indices.extend(first + i for i in (0, 1, 2, 0, 2, 3))
    for i in range(n):
        p, q, r, s = outline[i], outline[(i + 1) % n], inner[i], inner[(i + 1) % n]
        quad((*p, 0.0), (*q, 0.0), (*q, depth), (*p, depth))
        quad((*r, depth), (*p, depth), (*q, depth), (*s, depth))
        quad((*r, 0.0), (*s, 0.0), (*q, 0.0), (*p, 0.0))
        if hole > 0:
            quad((*s, 0.0), (*r, 0.0), (*r, depth), (*s, depth))
    return {"positions": positions, "indices": indices}


def joined(*geometries):
    """One geometry of several with the same attributes."""
    result = {key: [] for key in geometries[0]}
    for geometry in geometries:
        first = len(result["positions"])
        for key, values in geometry.items():
            result[key].extend(first + i for i in values) if key == "indices" else result[key].extend(values)
    return result


def moved(geometry, offset=(0, 0, 0), scale=(1, 1, 1)):
    result = dict(geometry)
    result["positions"] = [tuple(p * s + o for p, s, o in zip(q, scale, offset)) for q in geometry["positions"]]
    if "normals" in geometry:
        result["normals"] = [unit(tuple(n / s for n, s in zip(q, scale))) for q in geometry["normals"]]
    return result


def floor(size, y=0.0):
    return {"positions": [(-size, y, size), (size, y, size), (size, y, -size), (-size, y, -size)],
            "normals": [(0.0, 1.0, 0.0)] * 4, "uvs": [(0, 1), (1, 1), (1, 0), (0, 0)], "indices": [0, 1, 2, 0, 2, 3]}


def hash_noise(x, y, seed=0):
    """A number in 0..1 for each pair of integers, the same on every machine."""
    n = (x * 374761393 + y * 668265263 + seed * 974634541) & 0xFFFFFFFF
    n = ((n ^ (n >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((n ^ (n >> 16)) & 0xFFFF) / 65535


def noise(x, y, period=None, seed=0, octaves=5):
    """Smooth noise of several octaves in 0..1; repeats after `period` in x."""
    total, weight, amplitude = 0.0, 0.0, 1.0
    for octave in range(octaves):
        f = 2 ** octave
        fx, fy = x * f, y * f
        ix, iy = math.floor(fx), math.floor(fy)
        sx, sy = fx - ix, fy - iy
        sx, sy = sx * sx * (3 - 2 * sx), sy * sy * (3 - 2 * sy)

        def corner(i, j):
            column = (ix + i) % (period * f) if period else ix + i
            return hash_noise(column, iy + j, seed + octave)
        top = corner(0, 0) * (1 - sx) + corner(1, 0) * sx
        bottom = corner(0, 1) * (1 - sx) + corner(1, 1) * sx
        total += amplitude * (top * (1 - sy) + bottom * sy)
        weight += amplitude
        amplitude *= 0.5
    return total / weight
