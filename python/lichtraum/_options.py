"""The options of `lichtraum render`, as keywords."""

from __future__ import annotations

import inspect
import os
import re
from contextlib import contextmanager
from typing import Annotated, Any, Callable, Iterable, Iterator, Sequence, TypedDict, TypeVar, Union, get_type_hints

from numpy.typing import NDArray

from . import _native
from ._errors import FileError, UsageError
from ._values import expect, items_of

Path = Union[str, "os.PathLike[str]"]
Numbers = Union[Sequence[float], NDArray[Any]]


class RenderOptions(TypedDict, total=False):
    """What a picture is asked for. What is left out, or None, is as the scene has it; `lichtraum render --help` says
    more of each: its options have the same names, with dashes. A text is taken as on its command line."""

    size: Annotated[Sequence[int] | str | None, "width and height in pixels"]
    region: Annotated[Sequence[int] | str | None, "x, y, width, height: only this part"]
    planes: Annotated[Sequence[str] | str | None, '"radiance", "depth", "normal", ...: see Image.planes']
    camera: Annotated[str | int | None, "name or number"]
    eye: Annotated[Numbers | str | None, "x, y, z: put the camera there"]
    look_at: Annotated[Numbers | str | None, "x, y, z: point the camera there"]
    up: Annotated[Numbers | str | None, "x, y, z: which way is up"]
    orbit: Annotated[Numbers | str | None, "azimuth, elevation in degrees, and a distance or none"]
    fov_x: Annotated[float | str | None, "degrees from the left edge to the right one"]
    fov_y: Annotated[float | str | None, "degrees from the upper edge to the lower one"]
    orthographic: Annotated[bool | None, "rays are parallel"]
    aperture: Annotated[float | str | None, "diameter of the lens; 0: all is sharp"]
    focus: Annotated[float | Numbers | str | None, "distance of what is sharp, or a point there"]
    root: Annotated[str | None, "only this shape and what is below it"]
    environment: Annotated[Path | None, 'a map\'s file, "studio" or "none"']
    environment_rotation: Annotated[float | str | None, "degrees, counter-clockwise seen from above"]
    environment_brightness: Annotated[float | str | None, "factor for its light"]
    integrator: Annotated[str | None, '"whitted" or "path"']
    samples: Annotated[int | Sequence[int] | str | None, "a pixel: 16 random ones, or (4, 4), a grid"]
    depth: Annotated[int | str | None, "the most reflections and refractions of a ray"]
    clamp: Annotated[float | str | None, "the most radiance that scattered light may add at each bounce"]
    seed: Annotated[int | str | None, "number that decides the random samples"]
    background: Annotated[Numbers | Sequence[Numbers] | str | None, 'r, g, b; two of these; "environment" or "none"']
    ground: Annotated[bool | str | None, 'True, "matt", "glossy" or "none"']
    exposure: Annotated[float | str | None, "stops brighter, or darker"]
    tonemap: Annotated[str | None, '"auto", "neutral", "agx", "aces", "reinhard" or "none"']
    transfer: Annotated[str | None, '"linear" or "srgb"']
    device: Annotated[str | int | None, "see Renderer; only of lichtraum.render"]
    traversal: Annotated[str | None, '"auto", "scalar", "wide" or "packet"; only of lichtraum.render']
    noise: Annotated[float | str | None, "stop once it is below this share of the brightness"]
    denoise: Annotated[str | bool | None, '"auto", "on", "off" or "builtin"']
    strict: Annotated[bool | None, "accept standard eSDF only, no dialects"]
    keep_going: Annotated[bool | None, "leave faulty statements out and go on"]
    transform_order: Annotated[str | None, '"parent" or "local": the frame that eSDF transforms in']
    rotation: Annotated[str | None, '"right" or "left": the hand by which eSDF rotates']
    material_extras: Annotated[Sequence[str] | str | None, 'what numbers after a material\'s m mean: "opacity", "ior", ...']
    allow_path: Annotated[Path | Sequence[Path] | None, "folders that a scene may read besides its own"]
    scene: Annotated[str | int | None, "of a model's file: name or number"]
    variant: Annotated[str | int | None, "of a model's materials: name or number"]
    time: Annotated[float | str | None, "seconds from the start of the animation"]
    animation: Annotated[str | int | None, "name or number"]
    both_sides: Annotated[bool | None, "show the backs of single-sided surfaces"]
    max_texture: Annotated[int | str | None, "pixels: textures with a longer side are shrunk"]
    point_size: Annotated[float | str | None, "diameter of points and lines, in thousandths of the model's diagonal"]


def _described() -> Iterator[str]:
    for name, hint in get_type_hints(RenderOptions, include_extras=True).items():
        yield f"{name}: {hint.__metadata__[0]}"


RenderOptions.__doc__ = "\n".join([inspect.cleandoc(RenderOptions.__doc__ or ""), "", *_described()])

FLAGS = frozenset({"strict", "keep_going", "both_sides", "orthographic"})
#: Those that say how a file is read.
READING = (
    "time", "animation", "scene", "variant", "max_texture", "point_size", "both_sides", "strict",
    "keep_going", "transform_order", "rotation", "material_extras", "allow_path",
)  # fmt: skip


Function = TypeVar("Function", bound=Callable[..., Any])


def taking(names: Iterable[str]) -> Callable[[Function], Function]:
    """Tells help() and editors which options a function takes, which is written with `**options`."""

    def told(function: Function) -> Function:
        signature = inspect.signature(function)
        own = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
        options = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in names]
        setattr(function, "__signature__", signature.replace(parameters=[*own, *options]))
        return function

    return told


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
