"""What a scene is, to all renderers alike: triangles, materials, one camera, one environment.

World: x right, y up, right-handed; metres; colours and radiance are linear, Rec. 709 primaries.
"""

from dataclasses import dataclass, field
import pathlib

import numpy


@dataclass
class Material:
    """kind: "diffuse" (Lambert; nothing else is seen of a lamp), "metal_rough" (glTF's) or "glass" (smooth)."""

    kind: str
    color: tuple = (0.0, 0.0, 0.0)
    roughness: float = 1.0  # squared, it is GGX's alpha
    metallic: float = 0.0
    ior: float = 1.5
    emission: tuple = (0.0, 0.0, 0.0)  # radiance
    color_texture: bytes | None = None  # a PNG or JPEG file, sRGB; instead of the color
    metal_rough_texture: bytes | None = None  # the same, linear: roughness in green, metallic in blue

    @property
    def shines(self):
        return max(self.emission) > 0


@dataclass
class Mesh:
    """Triangles, counter-clockwise seen from outside. Without normals, flat. v of texture coordinates points down."""

    positions: numpy.ndarray  # (n, 3) float32
    triangles: numpy.ndarray  # (m, 3) uint32
    material: Material
    normals: numpy.ndarray | None = None  # (n, 3) float32, unit
    uvs: numpy.ndarray | None = None  # (n, 2) float32


@dataclass
class Camera:
    eye: tuple
    target: tuple
    fov_x: float  # degrees
    aspect: float = 16 / 9  # width over height


@dataclass
class Scene:
    """depth: surfaces that may scatter a path. environment: the radiance that is the same from everywhere, or a .hdr
    file in latitude and longitude, u = 0.5 + atan2(z, x) / 2 pi."""

    name: str
    camera: Camera
    meshes: list[Mesh] = field(default_factory=list)
    environment: float | pathlib.Path = 0.0
    depth: int = 8

    def triangle_count(self):
        return sum(len(mesh.triangles) for mesh in self.meshes)


@dataclass
class Job:
    """How a scene is to be drawn: by every renderer the same."""

    width: int
    height: int
    samples: int
    threads: int
    folder: pathlib.Path  # for files that a renderer needs
