#!/usr/bin/env python3
"""Writes kernels/shared/sheen_albedo.h: how much light sheen of colour 1 reflects, in all.

The lobe is that of kernels/bsdf/sheen.clh: Charlie's distribution with its fitted masking (Estevez and Kulla,
"Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course notes). Its mean over the light's directions is taken
over a grid that is denser where they graze. Of thin fuzz at grazing angles the formula reflects more than arrives; the
table says so, and the kernel divides by it.
"""

import math

import albedo_table

SIZE = 32
STEPS_Z, STEPS_PHI = 128, 96
MIN_ROUGHNESS = 0.07  # as kernels/bsdf/sheen.clh
MIN_COSINE = 0.001


def masking(alpha):
    """Lambda of a cosine."""
    rest = (1 - alpha) ** 2
    a, b, c, d, e = (
        smooth + (rough - smooth) * rest
        for smooth, rough in ((21.5473, 25.3245), (3.82987, 3.32435), (0.19823, 0.16801), (-1.9776, -1.27393),
                              (-4.32054, -4.85967)))

    def fit(x):
        return a / (1 + b * x ** c) + d * x + e

    def of(cosine):
        x = max(cosine, MIN_COSINE)
        return math.exp(fit(x) if x < 0.5 else 2 * fit(0.5) - fit(1 - x))

    return of


def lights(alpha):
    """Cosines with their share of the hemisphere's height, and Lambda."""
    of = masking(alpha)
    for i in range(STEPS_Z):
        root = (i + 0.5) / STEPS_Z
        yield root ** 3, 3 * root * root / STEPS_Z, of(root ** 3)


def albedo(cosine, alpha, all_lights, own_masking):
    sine = math.sqrt(1 - cosine * cosine)
    total = 0.0
    for z, share, light_masking in all_lights:
        radius = math.sqrt(1 - z * z)
        ring = 0.0
        for j in range(STEPS_PHI):
            hx = sine + radius * math.cos(math.pi * (j + 0.5) / STEPS_PHI)  # the other half is its mirror image
            hy = radius * math.sin(math.pi * (j + 0.5) / STEPS_PHI)
            plane = hx * hx + hy * hy
            ring += (plane / (plane + (z + cosine) ** 2)) ** (0.5 / alpha)
        total += share * ring / (1 + own_masking + light_masking) * min(z / MIN_COSINE, 1)
    return (2 + 1 / alpha) * total / (4 * max(cosine, MIN_COSINE) * STEPS_PHI)


def main():
    values = []
    for row in range(SIZE):
        alpha = (MIN_ROUGHNESS + (1 - MIN_ROUGHNESS) * row / (SIZE - 1)) ** 2
        all_lights = list(lights(alpha))
        for column in range(SIZE):
            cosine = max((column / (SIZE - 1)) ** 2, MIN_COSINE)
            values.append(albedo(cosine, alpha, all_lights, masking(alpha)(cosine)))
    albedo_table.write(
        "sheen",
        "for the square root of the cosine between viewer\n"
        " * and normal from 0 to 1 (columns), roughness = sqrt(alpha) from SHEEN_LEAST_ROUGHNESS to 1 (rows).",
        {"SHEEN_ALBEDO_SIZE": SIZE, "SHEEN_LEAST_ROUGHNESS": f"{MIN_ROUGHNESS}f"}, values, ".7g")


if __name__ == "__main__":
    main()
