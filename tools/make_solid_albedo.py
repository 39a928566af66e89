#!/usr/bin/env python3
"""Writes kernels/shared/solid_albedo.h: how much light a rough surface of glass keeps after one bounce.

Reflection and refraction by GGX's microfacets (Walter et al., "Microfacet Models for Refraction through Rough
Surfaces", 2007), with Smith's height-correlated masking and Schlick's Fresnel term, taken over visible normals as
tools/make_ggx_albedo.py does.
"""

import math

import albedo_table

IORS, ROUGHNESSES, COSINES = 10, 16, 16
LARGEST = 0.5  # of (ior - 1) / (ior + 1): ior 3
STEPS_U, STEPS_V = 64, 32
LEAST_ROUGHNESS = math.sqrt(0.001)  # MIN_ALPHA of kernels/shared/pbr_material.h


class Albedo:
    """Of light from everywhere, what is sent to a viewer after one bounce: in all, and of it what is reflected. The same
    where microfacets reflect nothing but what cannot be refracted: "bare" (KHR_materials_specular, a factor of 0)."""

    def __init__(self, reflected, critical, refracted, bare):
        self.total, self.reflected = reflected + critical + refracted, reflected + critical
        self.bare_total, self.bare_reflected = critical + bare, critical


def albedo(eta, f0, alpha, cosine):
    """eta: the index on the viewer's side over the one beyond."""
    ox = math.sqrt(1 - cosine * cosine)
    length = math.hypot(alpha * ox, cosine)
    sx, sz = alpha * ox / length, cosine / length
    projected_o = math.sqrt(alpha * alpha * ox * ox + cosine * cosine)

    def unmasked(x, y, z):
        projected = math.sqrt(alpha * alpha * (x * x + y * y) + z * z)
        return z * (cosine + projected_o) / (z * projected_o + cosine * projected)

    reflected = critical = refracted = bare = 0.0
    for i in range(STEPS_U):
        root = 1 - (i + 0.5) / STEPS_U
        z = root * root * (1 + sz) - sz
        radius = math.sqrt(max(0.0, 1 - z * z))
        for j in range(STEPS_V):
            phi = math.pi * (j + 0.5) / STEPS_V  # the other half is its mirror image
            hx, hy, hz = alpha * (radius * math.cos(phi) + sx), alpha * radius * math.sin(phi), max(0.0, z + sz)
            length = math.sqrt(hx * hx + hy * hy + hz * hz)
            hx, hy, hz = hx / length, hy / length, hz / length
            dot = min(1.0, ox * hx + cosine * hz)
            beyond = 1 - eta * eta * (1 - dot * dot)
            inner = math.sqrt(max(0.0, beyond))
            fresnel = f0 + (1 - f0) * (1 - (inner if eta > 1 else dot)) ** 5
            if 2 * dot * hz > cosine:
                mirrored = 2 * root * unmasked(2 * dot * hx - ox, 2 * dot * hy, 2 * dot * hz - cosine)
                if beyond > 0:
                    reflected += fresnel * mirrored
                else:
                    critical += mirrored
            along = eta * dot - inner
            if beyond > 0 and along * hz < eta * cosine:
                passed = 2 * root * unmasked(along * hx - eta * ox, along * hy, eta * cosine - along * hz)
                refracted += (1 - fresnel) * passed
                bare += passed
    steps = STEPS_U * STEPS_V
    return Albedo(reflected / steps, critical / steps, refracted / steps, bare / steps)


def main():
    values = []
    for i in range(IORS):
        ratio = LARGEST * (i / (IORS - 1)) ** 2
        ior = (1 + ratio) / (1 - ratio)
        for row in range(ROUGHNESSES):
            alpha = (LEAST_ROUGHNESS + (1 - LEAST_ROUGHNESS) * row / (ROUGHNESSES - 1)) ** 2
            for column in range(COSINES):
                cosine = max((column / (COSINES - 1)) ** 2, 1e-4)
                outside = albedo(1 / ior, ratio * ratio, alpha, cosine)
                within = albedo(ior, ratio * ratio, alpha, cosine)
                values += [outside.bare_total, outside.total, within.bare_total, within.total, within.bare_reflected,
                           within.reflected]
    albedo_table.write(
        "solid",
        "of light from everywhere, what is reflected and\n"
        " * refracted towards a viewer outside, towards one within, and what is reflected towards that one; each without what\n"
        " * Fresnel's factor reflects before the critical angle, and with it; for the square root of the cosine between\n"
        " * viewer and normal from 0 to 1, roughness = sqrt(alpha) from the least to 1, and the square root of\n"
        " * (ior - 1) / (ior + 1) / SOLID_LARGEST from 0 to 1.",
        {
            "SOLID_IORS": IORS,
            "SOLID_ROUGHNESSES": ROUGHNESSES,
            "SOLID_COSINES": COSINES,
            "SOLID_LARGEST": f"{LARGEST}f",
            "SOLID_LEAST_ROUGHNESS": f"{LEAST_ROUGHNESS:.7g}f",
        }, values, ".5f")


if __name__ == "__main__":
    main()
