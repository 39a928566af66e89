"""Ray tracing of eSDF scenes and 3D models, on OpenCL devices.

>>> import lichtraum as lt
>>> image = lt.render("scenes/hello.sdf", size=(64, 36), progress=False)
>>> image
<lichtraum.Image 64x36, 1 sample a pixel>

The options are those of the program `lichtraum render`, and the pictures are the same to the byte.
"""


def _load_module() -> None:
    try:
        from . import _native  # noqa: F401
    except ImportError as error:
        if "libOpenCL" not in str(error):
            raise
        raise ImportError(
            "lichtraum needs OpenCL's loader, which is not installed or broken (Debian, Ubuntu: apt install "
            f"ocl-icd-libopencl1 pocl-opencl-icd): {error}"
        ) from error


_load_module()

from ._errors import DeviceError, Error, FileError, JobError, SceneError, SceneWarning, UsageError
from ._image import Image
from ._loaded import LoadedScene, LoadedShape
from ._materials import Pbr, Phong
from ._native import Diagnostic
from ._native import version as __version__
from ._nodes import Box, Camera, Cone, Cylinder, Group, Light, Mesh, Model, Plane, Shape, Sphere
from ._options import RenderOptions
from ._render import Renderer, load, render
from ._scene import Scene
from ._texture import Texture

__all__ = [
    "Box",
    "Camera",
    "Cone",
    "Cylinder",
    "DeviceError",
    "Diagnostic",
    "Error",
    "FileError",
    "Group",
    "Image",
    "JobError",
    "Light",
    "LoadedScene",
    "LoadedShape",
    "Mesh",
    "Model",
    "Pbr",
    "Phong",
    "Plane",
    "RenderOptions",
    "Renderer",
    "Scene",
    "SceneError",
    "SceneWarning",
    "Shape",
    "Sphere",
    "Texture",
    "UsageError",
    "__version__",
    "load",
    "render",
]
