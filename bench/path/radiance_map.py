"""Environments that are made, not photographed, and files of radiance."""

import re

import numpy


def sky(width, with_sun):
    """A sky above dark ground, in latitude and longitude: with a sun of 4 degrees, or with three large windows."""
    height = width // 2
    v, u = numpy.meshgrid((numpy.arange(height) + 0.5) / height, (numpy.arange(width) + 0.5) / width, indexing="ij")
    theta, phi = numpy.pi * v, 2 * numpy.pi * (u - 0.5)
    direction = numpy.stack([numpy.sin(theta) * numpy.cos(phi), numpy.cos(theta), numpy.sin(theta) * numpy.sin(phi)], -1)
    up = numpy.clip(direction[..., 1:2], 0, 1)
    above = (1 - up) * (0.9, 0.95, 1.0) + up * (0.25, 0.45, 0.9)
    ripples = 1 + 0.3 * numpy.sin(9 * phi + 5 * theta)[..., None] * numpy.sin(7 * theta)[..., None]
    image = numpy.where(direction[..., 1:2] > 0, above * ripples, (0.18, 0.15, 0.12))
    if with_sun:
        sun = numpy.array((0.5, 0.6, 0.62))
        cosine = direction @ (sun / numpy.linalg.norm(sun))
        image[cosine > numpy.cos(numpy.radians(4))] = (200, 185, 160)
    else:
        for center in (0.55, 0.85, 0.25):
            image[(numpy.abs(u - center) < 0.04) & (numpy.abs(v - 0.3) < 0.09)] = (9, 8.5, 8)
    return image.astype(numpy.float32)


def write_hdr(path, image):
    """Radiance's format, without run lengths."""
    mantissa, exponent = numpy.frexp(image.max(axis=-1))
    scale = numpy.where(mantissa > 0, mantissa * 256 / numpy.maximum(image.max(axis=-1), 1e-30), 0)
    rgbe = numpy.empty(image.shape[:2] + (4,), numpy.uint8)
    rgbe[..., :3] = numpy.clip(image * scale[..., None], 0, 255)
    rgbe[..., 3] = numpy.where(mantissa > 0, exponent + 128, 0)
    height, width = image.shape[:2]
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode() + rgbe.tobytes())


def write_pfm(path, image):
    height, width = image.shape[:2]
    path.write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + image[::-1].astype("<f4").tobytes())


def read_pfm(path):
    """(height, width, 3), the topmost row first."""
    data = path.read_bytes()
    head = re.match(rb"PF\s+(\d+)\s+(\d+)\s+(-?[\d.]+)\s", data)
    width, height, scale = int(head[1]), int(head[2]), float(head[3])
    pixels = numpy.frombuffer(data, "<f4" if scale < 0 else ">f4", 3 * width * height, head.end())
    return pixels.reshape(height, width, 3)[::-1].astype(numpy.float32)
