#!/usr/bin/env python3
"""Writes kernels/shared/ggx_albedo.h: how much light a rough mirror reflects, in all.

The directional albedo of GGX with Smith's height-correlated masking and Schlick's Fresnel term is
f0 * A + f90 * B (Karis, "Real Shading in Unreal Engine 4", 2013). Both are means of G2 / G1 over visible normals
(Heitz, "Sampling the GGX Distribution of Visible Normals", 2018; Dupuy and Benyoub, 2023), taken over a grid that is
denser where normals are steep: there light begins to be mirrored below the surface.
"""

import math

import albedo_table

SIZE = 48
STEPS_U, STEPS_V = 128, 64
MIN_ALPHA = 0.001  # as kernels/shared/pbr_material.h


def albedo(cosine, alpha):
    wo = (math.sqrt(1 - cosine * cosine), 0.0, cosine)
    stretched = (alpha * wo[0], 0.0, wo[2])
    length = math.hypot(stretched[0], stretched[2])
    stretched = (stretched[0] / length, 0.0, stretched[2] / length)
    projected_o = math.sqrt(alpha * alpha * wo[0] ** 2 + wo[2] ** 2)
    a = b = 0.0
    for i in range(STEPS_U):
        root = 1 - (i + 0.5) / STEPS_U
        z = root * root * (1 + stretched[2]) - stretched[2]
        radius = math.sqrt(max(0.0, 1 - z * z))
        for j in range(STEPS_V):
            phi = math.pi * (j + 0.5) / STEPS_V  # the other half is its mirror image
            hx = alpha * (radius * math.cos(phi) + stretched[0])
            hy = alpha * radius * math.sin(phi)
            hz = max(0.0, z + stretched[2])
            length = math.sqrt(hx * hx + hy * hy + hz * hz)
            hx, hy, hz = hx / length, hy / length, hz / length
            dot = wo[0] * hx + wo[2] * hz
            ix, iy, iz = 2 * dot * hx - wo[0], 2 * dot * hy, 2 * dot * hz - wo[2]
            if iz <= 0:
                continue
            projected_i = math.sqrt(alpha * alpha * (ix * ix + iy * iy) + iz * iz)
            weight = 2 * root * iz * (wo[2] + projected_o) / (iz * projected_o + wo[2] * projected_i)
            schlick = (1 - max(0.0, dot)) ** 5
            a += (1 - schlick) * weight
            b += schlick * weight
    return a / (STEPS_U * STEPS_V), b / (STEPS_U * STEPS_V)


def main():
    values = []
    for row in range(SIZE):
        alpha = max((row / (SIZE - 1)) ** 2, MIN_ALPHA)
        for column in range(SIZE):
            values += albedo(max((column / (SIZE - 1)) ** 2, 1e-4), alpha)
    albedo_table.write(
        "ggx",
        "A and B, in turn, for the square root of the cosine\n"
        " * between viewer and normal from 0 to 1 (columns), roughness = sqrt(alpha) from 0 to 1 (rows).",
        {"GGX_ALBEDO_SIZE": SIZE}, values, ".7g")


if __name__ == "__main__":
    main()
