"""The options of `lichtraum render`, as keywords."""

from __future__ import annotations

import os
import re
from contextlib import contextmanager
from typing import Any, Iterable, Iterator, Sequence, TypedDict, Union

from numpy.typing import NDArray

from . import _native
from ._errors import FileError, UsageError
from ._values import expect, items_of

Path = Union[str, "os.PathLike[str]"]
Numbers = Union[Sequence[float], NDArray[Any]]


class RenderOptions(TypedDict, total=False):
    """What a picture is asked for. What is left out, or None, is as the scene has it; `lichtraum render --help` says
    more of each: its options have the same names, with dashes. A text is taken as on its command line."""

    size: Sequence[int] | str | None  #: width and height in pixels
    region: Sequence[int] | str | None  #: x, y, width, height: only this part
    planes: Sequence[str] | str | None  #: "radiance", "depth", "normal", ...: see Image.planes
    camera: str | int | None  #: name or number
    eye: Numbers | str | None  #: x, y, z: put the camera there
    look_at: Numbers | str | None
    up: Numbers | str | None
    orbit: Numbers | str | None  #: azimuth, elevation in degrees, and a distance or none
    fov_x: float | str | None  #: degrees
    fov_y: float | str | None
    orthographic: bool | None  #: rays are parallel
    aperture: float | str | None  #: diameter of the lens
    focus: float | Numbers | str | None  #: distance, or a point
    root: str | None  #: only this shape and what is below it
    environment: Path | None  #: a map's file, "studio" or "none"
    environment_rotation: float | str | None  #: degrees
    environment_brightness: float | str | None
    integrator: str | None  #: "whitted" or "path"
    samples: int | Sequence[int] | str | None  #: a pixel: 16 random ones, or (4, 4), a grid
    depth: int | str | None  #: of reflections
    clamp: float | str | None
    seed: int | str | None
    background: Numbers | Sequence[Numbers] | str | None  #: r, g, b; two of these; "environment" or "none"
    ground: bool | str | None  #: True, "matt", "glossy" or "none"
    exposure: float | str | None  #: stops
    tonemap: str | None
    transfer: str | None  #: "linear" or "srgb"
    device: str | int | None  #: only of lichtraum.render
    traversal: str | None  #: only of lichtraum.render
    noise: float | str | None
    denoise: str | bool | None  #: "auto", "on", "off" or "builtin"
    strict: bool | None
    keep_going: bool | None
    transform_order: str | None  #: "parent" or "local"
    rotation: str | None  #: "right" or "left"
    material_extras: Sequence[str] | str | None
    allow_path: Path | Sequence[Path] | None  #: folders that a scene may read besides its own
    scene: str | int | None  #: of a model's file
    variant: str | int | None
    time: float | str | None  #: seconds
    animation: str | int | None
    both_sides: bool | None
    max_texture: int | str | None
    point_size: float | str | None


FLAGS = frozenset({"strict", "keep_going", "both_sides", "orthographic"})
#: Those that say how a file is read.
READING = (
    "time", "animation", "scene", "variant", "max_texture", "point_size", "both_sides", "strict",
    "keep_going", "transform_order", "rotation", "material_extras", "allow_path",
)  # fmt: skip


def _plain(value: Any) -> Any:
    """NumPy's numbers, and its arrays of one without a dimension, as Python has them."""
    return value.item() if getattr(value, "ndim", None) == 0 else value


def _flat(values: Iterable[Any]) -> list[Any]:
    flat: list[Any] = []
    for value in map(_plain, values):
        if isinstance(value, (str, bytes, os.PathLike)) or not hasattr(value, "__iter__"):
            flat.append(value)
        else:
            flat.extend(_flat(value))
    return flat


def _word(name: str, value: Any) -> str:
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, (str, int)):
        return str(value)
    if hasattr(value, "__float__"):
        number = float(value)
        return str(int(number)) if hasattr(value, "__index__") else repr(number)
    raise TypeError(f"{name}: expected a number or a text, not {value!r}")


def _option(name: str) -> str:
    return "--" + name.replace("_", "-")


def _with_value(name: str, text: str, value: Any) -> str:
    """Without a text it would take the next word for its value."""
    if not text:
        raise UsageError(f"{name}: expected a value, not {value!r}")
    return f"{_option(name)}={text}"


def _words(name: str, value: Any) -> list[str]:
    """The words of the command line that say `name`=`value`."""
    option, value = _option(name), _plain(value)
    if name in FLAGS:
        expect(name, value, bool, "True or False")
        return [option] if value else []
    if name == "allow_path":
        folders = [value] if isinstance(value, (str, os.PathLike)) else [*items_of(name, value, "a folder, or a list of them")]
        return [_with_value(name, _word(name, folder), value) for folder in folders or [""]]
    if isinstance(value, bool):
        if name == "ground":
            return [option] if value else []
        if name == "denoise":
            return [option + ("=on" if value else "=off")]
        raise TypeError(f"{name} cannot be True or False")
    if isinstance(value, (str, bytes, os.PathLike)) or not hasattr(value, "__iter__"):
        return [_with_value(name, _word(name, value), value)]
    between = "x" if name in ("size", "samples") else ","
    return [_with_value(name, between.join(_word(name, part) for part in _flat(value)), value)]


def parsed(options: dict[str, Any]) -> _native.Options:
    """Raises TypeError for unknown names, UsageError for values that make no sense."""
    words: list[str] = []
    for name, value in options.items():
        if name not in RenderOptions.__annotations__:
            raise TypeError(f"there is no option {name!r}; there are: {', '.join(RenderOptions.__annotations__)}")
        if value is not None:
            words += _words(name, value)
            if any("\0" in word for word in words):
                raise UsageError(f"{name}: expected no NUL character, not {value!r}")
    with named_as_here():
        return _native.parse_options(words)


@contextmanager
def named_as_here() -> Iterator[None]:
    """Lets an error name options as Python does, not the command line."""
    try:
        yield
    except (UsageError, FileError) as error:
        error.args = (as_here(str(error).removesuffix(" (lichtraum render --help shows how)")),)
        raise


#: An option in a sentence, and its value if that is a number or one of the words that hints ask for.
_OPTION = re.compile(r"(--[a-z][a-z-]+)(?:[ =](?:(-?[0-9]+(?:[.][0-9]+)?)|(neutral|path|studio))(?![.,]?\w))?")


def as_here(text: str) -> str:
    """With options as Python has them: `exposure=-2` for `--exposure -2`."""
    names = {_option(name): name for name in (*RenderOptions.__annotations__, "bits")}

    def keyword(match: re.Match[str]) -> str:
        option, number, word = match.groups()
        name = names.get(option)
        if name is None:
            return match[0]
        return f"{name}={number}" if number else f"{name}={word!r}" if word else name

    return _OPTION.sub(keyword, text)
