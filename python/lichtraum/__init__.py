"""Ray tracing of eSDF scenes and 3D models, on OpenCL devices.

>>> import lichtraum as lt
>>> image = lt.render("scenes/hello.sdf", size=(64, 36), progress=False)
>>> image
<lichtraum.Image 64x36, 1 sample a pixel>

The options are those of the program `lichtraum render`, and the pictures are the same to the byte.
"""

from ._errors import DeviceError, Error, FileError, SceneError, SceneWarning, UsageError
from ._image import Image
from ._native import Diagnostic
from ._native import version as __version__
from ._render import Renderer, Scene, load, render

__all__ = [
    "DeviceError",
    "Diagnostic",
    "Error",
    "FileError",
    "Image",
    "Renderer",
    "Scene",
    "SceneError",
    "SceneWarning",
    "UsageError",
    "__version__",
    "load",
    "render",
]
