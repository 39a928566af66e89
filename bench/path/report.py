"""What is made of the pictures: noise, agreement, and the lines that say so."""

import statistics
import struct
import zlib

import numpy

# Of the scene's mean square, added below: so that pixels which are nearly black do not count for more than all others.
BLACK_SHARE = 1e-2
BLOCK = 16  # pixels


def noise(first, second, mean):
    """Mean square relative error of one picture, from two with different seeds: their difference has twice its variance."""
    below = mean**2 + BLACK_SHARE * numpy.mean(mean**2)
    return float(numpy.mean((first - second) ** 2 / 2 / below))


def blocks(picture):
    """Means of squares of BLOCK x BLOCK pixels and channels; what is left over at the edges is left out."""
    height, width = (side // BLOCK for side in picture.shape[:2])
    return picture[: height * BLOCK, : width * BLOCK].reshape(height, BLOCK, width, BLOCK, 3).mean(axis=(1, 3))


def block_difference(picture, mean):
    """Root mean square of how far blocks are from the mean of all renderers, relative as above; noise is part of it."""
    one, other = blocks(picture), blocks(mean)
    return float(numpy.sqrt(numpy.mean((one - other) ** 2 / (other**2 + BLACK_SHARE * numpy.mean(mean**2)))))


class Table:
    """Runs of one scene: of each renderer, for each repetition, two pictures (of two seeds) and the seconds of both."""

    def __init__(self, scene, job, labels):
        self.scene, self.job = scene, job
        self.runs = {label: [] for label in labels}

    def add(self, label, runs):
        self.runs[label].append(runs)

    def summary(self):
        """Of each renderer: medians of seconds, noise and their product; means; how far its picture is from that of all."""
        pictures = {label: numpy.mean([picture for pair in runs for _, picture in pair], axis=0, dtype=numpy.float64)
                    for label, runs in self.runs.items()}
        mean = numpy.mean(list(pictures.values()), axis=0)
        rows = {}
        for label, runs in self.runs.items():
            seconds = [statistics.mean(s for s, _ in pair) for pair in runs]
            noises = [noise(pair[0][1], pair[1][1], mean) for pair in runs]
            rows[label] = {
                "seconds": statistics.median(seconds),
                "noise": statistics.median(noises),
                "product": statistics.median(s * n for s, n in zip(seconds, noises)),
                "mean": float(pictures[label].mean()),
                "mean_ratio": float(pictures[label].mean() / mean.mean()),
                "block_difference": block_difference(pictures[label], mean),
            }
        return rows, pictures


def print_scene(scene, job, rows):
    print(f"{scene.name}: {scene.triangle_count()} triangles, {job.width}x{job.height}, {job.samples} samples, "
          f"depth {scene.depth}")
    first = next(iter(rows.values()))
    for label, row in rows.items():
        paths = job.width * job.height * job.samples / row["seconds"] * 1e-6
        print(f"  {label:<10}{row['seconds']:8.2f} s {paths:6.2f} Mpaths/s  noise {row['noise']:.5f}  "
              f"noise x s {row['product']:.5f}  ratio {first['product'] / row['product']:5.2f}  |  "
              f"mean {row['mean']:.4f} ({100 * (row['mean_ratio'] - 1):+.1f} %), blocks {100 * row['block_difference']:.1f} %",
              flush=True)


def print_means(tables):
    """Geometric means over the scenes."""
    first, *others = tables[0]
    for label in others:
        ratios = [rows[first]["product"] / rows[label]["product"] for rows in tables]
        print(f"noise x time of {first} over that of {label}: {statistics.geometric_mean(ratios):.2f} "
              f"(geometric mean of {len(ratios)}), at most {max(ratios):.2f}")


def write_png(path, picture):
    """In sRGB, clipped."""
    linear = numpy.clip(picture, 0, 1)
    encoded = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    height, width = picture.shape[:2]
    rows = numpy.zeros((height, 1 + 3 * width), numpy.uint8)
    rows[:, 1:] = numpy.round(255 * encoded).reshape(height, -1)
    chunks = ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows.tobytes())),
              (b"IEND", b""))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks))
