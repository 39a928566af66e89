"""Pictures."""

from __future__ import annotations

import json
import os
from typing import Any, Iterator, Mapping, Optional

import numpy
from numpy.typing import NDArray

from . import _native
from ._errors import UsageError
from ._files import file_name, writing
from ._native import Diagnostic
from ._options import named_as_here
from ._values import expect, whole


class Planes(Mapping[str, Any]):
    """What is known of each pixel, by name: arrays of height x width, of colours, positions and normals x 3.

    All are float32, but `object`, `instance` and `material`, which are uint32. They share the picture's memory.
    """

    def __init__(self, picture: _native.Picture) -> None:
        self._picture = picture

    def __getitem__(self, name: str) -> Any:
        if name not in self._picture.plane_names:
            there = ", ".join(self._picture.plane_names)
            raise KeyError(f"there is no plane {name!r} in this picture; there are: {there} (see planes=)")
        return self._picture.plane(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._picture.plane_names)

    def __len__(self) -> int:
        return len(self._picture.plane_names)

    def __repr__(self) -> str:
        return f"<planes {', '.join(self)}>"


class Image:
    """A picture that was drawn. It shows itself in notebooks.

    `numpy.asarray(image)` is height x width x 3, float32: linear radiance without limit, before exposure and tone map,
    without noise where that is taken out. It shares the picture's memory and cannot be written to.
    """

    def __init__(self, picture: _native.Picture) -> None:
        self._picture = picture

    @property
    def width(self) -> int:
        """Width in pixels."""
        return self._picture.width

    @property
    def height(self) -> int:
        """Height in pixels."""
        return self._picture.height

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.width, self.height

    @property
    def samples(self) -> int:
        """Samples per pixel."""
        return self._picture.samples

    @property
    def developed(self) -> NDArray[numpy.float32]:
        """What files of pictures store: height x width x 3, after exposure, tone map and transfer; 0..1 is shown."""
        return self._picture.developed

    @property
    def planes(self) -> Planes:
        """What was asked for with `planes=`, as it was traced: `image.planes["depth"]`."""
        return Planes(self._picture)

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What was found in the scene, and while it was drawn."""
        return self._picture.diagnostics

    @property
    def job(self) -> dict[str, Any]:
        """All that decides the picture (docs/JOB.md), as it was decided."""
        job: dict[str, Any] = json.loads(self._picture.job)
        return job

    @property
    def statistics(self) -> dict[str, Any]:
        """`device`, `denoiser`, `rays` and `seconds` of tracing."""
        return {
            "device": self._picture.device,
            "denoiser": self._picture.denoiser,
            "rays": self._picture.rays,
            "seconds": self._picture.seconds,
        }

    def save(
        self,
        path: str | os.PathLike[str],
        *,
        format: Optional[str] = None,
        bits: int = 8,
        quality: int = 92,
        ppm_ascii: bool = False,
    ) -> None:
        """Writes a .png, .ppm, .jpg, .exr or .pfm file, the bytes that `lichtraum render` writes. An .exr holds all
        planes. The old file stays until the new one is whole.

        `format`: whatever the name ends with; `bits`: 8 or 16 a channel (png, ppm); `quality`: 1 to 100 (jpg).
        Raises UsageError for what the format cannot hold; FileError, also for a file that the picture is drawn from.
        """
        bits, quality = self._checked(format, bits, quality, ppm_ascii)
        name = file_name(path)
        with writing(name), named_as_here():
            self._picture.save(name, format or "", bits, quality, ppm_ascii)

    def encoded(
        self, format: str = "png", *, bits: int = 8, quality: int = 92, ppm_ascii: bool = False
    ) -> bytes:
        """The bytes of such a file."""
        bits, quality = self._checked(format, bits, quality, ppm_ascii)
        with named_as_here():
            return self._picture.encoded(format, bits, quality, ppm_ascii)

    @staticmethod
    def _checked(format: Optional[str], bits: int, quality: int, ppm_ascii: bool) -> tuple[int, int]:
        expect("format", format, (str, type(None)), "a text")
        expect("ppm_ascii", ppm_ascii, bool, "True or False")
        bits, quality = whole("bits", bits), whole("quality", quality)
        if bits not in (8, 16):
            raise UsageError(f"bits: expected 8 or 16, not {bits}")
        if not 1 <= quality <= 100:
            raise UsageError(f"quality: expected a number from 1 to 100, not {quality}")
        return bits, quality

    def _repr_png_(self) -> bytes:
        return self._picture.shown()

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        pixels: NDArray[Any] = self._picture.radiance
        if dtype is not None and dtype != pixels.dtype:
            if copy is False:
                raise ValueError(f"the pixels are float32: as {dtype} they have to be copied")
            return pixels.astype(dtype)
        return pixels.copy() if copy else pixels

    def __dlpack__(self, **options: Any) -> Any:
        return self._picture.radiance.__dlpack__(**options)

    def __dlpack_device__(self) -> tuple[int, int]:
        return self._picture.radiance.__dlpack_device__()

    def __repr__(self) -> str:
        samples = f"{self.samples} sample{'' if self.samples == 1 else 's'} a pixel"
        return f"<lichtraum.Image {self.width}x{self.height}, {samples}>"
