"""Pictures on surfaces."""

from __future__ import annotations

import os
from typing import Any, Union

import numpy
from numpy.typing import ArrayLike

from . import _native
from ._errors import UsageError
from ._files import file_name, reading
from ._values import expect

_LARGEST = 16384  # texels a side


class Texture:
    """A picture on a surface: the name of a PNG, JPEG, WebP, BMP or TGA file, or an array of 8-bit numbers, first row at
    the top: height x width (grey), with 3 for red, green and blue, or with 4 for alpha as well. Copied; a file is read
    now, and one with a side longer than 4096 is halved until it fits. Colours are stored in sRGB, all else is linear.

    `wrap`: how it goes on beyond its edges: "repeat", "mirror" or "clamp". `filter`: "linear" or "nearest".
    """

    def __init__(
        self, picture: Union[str, os.PathLike[str], ArrayLike], *, wrap: str = "repeat", filter: str = "linear"
    ) -> None:
        for what, value in (("wrap", wrap), ("filter", filter)):
            expect(what, value, str, "a text")
        if isinstance(picture, (str, bytes, os.PathLike)):
            name = file_name(picture)
            with reading(name):
                self._native = _native.read_texture(name, wrap, filter)
            return
        texels = numpy.asarray(picture)
        if texels.dtype != numpy.uint8:
            raise UsageError(f"a texture's numbers are 8 bits from 0 to 255 (uint8), not {texels.dtype}")
        if texels.ndim == 2:
            texels = numpy.repeat(texels[:, :, None], 3, axis=2)
        if texels.ndim != 3 or texels.shape[2] not in (3, 4) or not all(0 < side <= _LARGEST for side in texels.shape[:2]):
            shape = " x ".join(map(str, texels.shape))
            raise UsageError(f"a texture is an array of height x width x 3 or 4, at most {_LARGEST} a side, not of {shape}")
        if texels.shape[2] == 3:
            opaque = numpy.full((*texels.shape[:2], 1), 255, dtype=numpy.uint8)
            texels = numpy.concatenate((texels, opaque), axis=2)
        self._native = _native.make_texture(numpy.ascontiguousarray(texels), wrap, filter)

    def __copy__(self) -> Texture:
        return self  # nothing of it ever changes

    def __deepcopy__(self, _: Any) -> Texture:
        return self
