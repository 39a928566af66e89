"""Pictures in PPM, and how far one is from another."""

import math
import re

# The weights of YIQ's channels (Kotsarenko and Ramos, Measuring perceived color difference using YIQ NTSC transmission
# color space in mobile applications, 2010), and the largest difference that they can add up to.
Y, I, Q = (0.29889531, 0.58662247, 0.11448223), (0.59597799, -0.27417610, -0.32180189), (0.21147017, -0.52261711, 0.31114694)
LARGEST = 35215


def read_ppm(path):
    """The bytes of its pixels: red, green, blue, from the top left."""
    data = path.read_bytes()
    fields = re.match(rb"P6\s+(?:#.*\s+)*(\d+)\s+(\d+)\s+(\d+)\s", data)
    return data[fields.end():]


def decibels(a, b):
    """How far two pictures are from each other: 10 log10 of the root mean square of the pixels' differences, as
    glTF-Render-Fidelity measures renderers. Less is nearer; below -25 or so eyes have to search."""
    total = 0.0
    for i in range(0, len(a), 3):
        if a[i:i + 3] != b[i:i + 3]:
            rgb = [a[i + channel] - b[i + channel] for channel in range(3)]
            y, in_phase, quadrature = (sum(w * c for w, c in zip(weights, rgb)) for weights in (Y, I, Q))
            total += (0.5053 * y * y + 0.299 * in_phase * in_phase + 0.1957 * quadrature * quadrature) ** 2
    return 10 * math.log10(math.sqrt(total / (len(a) / 3)) / LARGEST + 1e-9)
