"""Drawing."""

from __future__ import annotations

import inspect
import os
import sys
import warnings
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence, Union

from . import _native
from ._errors import SceneWarning, UsageError
from ._files import file_name, reading
from ._forks import OPENCL
from ._image import Image
from ._loaded import LoadedScene
from ._native import Diagnostic
from ._options import READING, Path, RenderOptions, as_here, named_as_here, parsed, taking
from ._progress import Bar
from ._scene import Scene
from ._values import expect, whole
from ._waiting import wait_for

if sys.version_info >= (3, 11):
    from typing import Unpack
elif TYPE_CHECKING:
    from typing_extensions import Unpack

Progress = Union[bool, Callable[[float], Any], None]


def _warn(text: str) -> None:
    """At the line outside of this package that called it."""
    level, frame = 1, inspect.currentframe()
    while frame is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, SceneWarning, stacklevel=level)


def _warn_of(diagnostics: Sequence[Diagnostic], is_made_here: bool = False) -> None:
    """`is_made_here`: of a Scene, whose author may not know eSDF."""
    for diagnostic in diagnostics:
        if diagnostic.severity != "warning":
            continue
        text = str(diagnostic).rstrip()
        if is_made_here and diagnostic.hint.startswith("define light"):
            text = text.replace(diagnostic.hint, "Light.point((10, 10, 10)) among its items")
        _warn(as_here(text))


def _folders(value: Any) -> list[Any]:
    if value is None:
        return []
    return [value] if isinstance(value, (str, os.PathLike)) else list(value)


Drawable = Union[Path, LoadedScene, Scene]

#: Options that a Renderer is made with.
_DEVICE = ("device", "traversal")


class Renderer:
    """Draws on one device, and keeps programs, models and hierarchies from one picture to the next.

    `device`: an index, a part of its name, "cpu", "gpu" or "reference"; None: the best. Where there is no OpenCL device,
    that is the reference tracer, which is slow; a SceneWarning says so. Raises DeviceError.
    """

    def __init__(self, device: str | int | None = None, *, traversal: Optional[str] = None) -> None:
        wanted = "" if device is None else str(device)
        parsed({"device": device, "traversal": traversal})
        if wanted != "reference":
            OPENCL.check()
        self._session = wait_for(lambda _: _native.Session(wanted, traversal or ""))
        if not self._session.is_reference:
            OPENCL.begin()
        if self._session.warnings:
            _warn("\n".join(self._session.warnings))

    @property
    def device(self) -> str:
        """The name of the device."""
        return self._session.device

    @taking(name for name in RenderOptions.__annotations__ if name not in _DEVICE)
    def render(
        self, source: Drawable, /, *, picture: int = 0, progress: Progress = None, **options: Unpack[RenderOptions]
    ) -> Image:
        """As `lichtraum.render`, on this device."""
        given = dict(options)
        for name in _DEVICE:
            if name in given:
                raise TypeError(f"{name} is chosen when the Renderer is made")
        _check(source, picture, given)
        return self._draw(source, picture, progress, given)

    def _draw(self, scene: Drawable, picture: int, progress: Progress, given: dict[str, Any]) -> Image:
        if not self._session.is_reference:
            OPENCL.check()
        if isinstance(scene, Scene):
            with scene._workplace.use():
                written, given = _as_drawn(scene, given)
                drawn = self._drawn(written, picture, progress, given)
        else:
            drawn = self._drawn(scene, picture, progress, given)
        _warn_of(drawn.diagnostics, isinstance(scene, Scene))
        return Image(drawn)

    def _drawn(
        self, scene: Path | LoadedScene, picture: int, progress: Progress, given: dict[str, Any]
    ) -> _native.Picture:
        session, options = self._session, parsed(given)
        environment = given.get("environment")
        maps = [] if environment in (None, "studio", "none") else [file_name(environment)]
        with named_as_here(), Bar(progress) as bar:
            if isinstance(scene, LoadedScene):
                read = scene._native
                with reading(*maps):
                    return wait_for(lambda control: session.draw_scene(read, options, picture, control), bar.show)
            name = file_name(scene)
            with reading(name, *maps):
                return wait_for(lambda control: session.draw_file(name, options, picture, control), bar.show)

    def __repr__(self) -> str:
        return f"<lichtraum.Renderer on {self.device!r}>"


def _check(scene: Drawable, picture: int, given: dict[str, Any]) -> None:
    """Raises TypeError for what cannot be drawn, UsageError for what has no effect on a scene that is no file, and as `parsed`
    and `whole` do."""
    expect("scene", scene, (str, bytes, os.PathLike, LoadedScene, Scene), "a file's name, a LoadedScene or a Scene")
    parsed(given)
    whole("picture", picture)
    if isinstance(scene, Scene) and picture:
        raise UsageError(f"there is no picture {picture}: a Scene has one, number 0")
    if not isinstance(scene, LoadedScene):
        return
    if picture:
        raise UsageError(
            f"picture: {scene.name!r} was loaded as it is at the end of its file: render the file for its picture {picture}"
        )
    for name in READING:
        if given.get(name) is not None:
            raise UsageError(f"{name}: {scene.name!r} was read before: give {name} to lt.load")


def _as_drawn(scene: Scene, given: dict[str, Any]) -> tuple[str | LoadedScene, dict[str, Any]]:
    """The file of a scene, or, where eSDF cannot say all of it, what was read of that, with the rest."""
    path, folders, writer = scene._drawable()
    if folders:
        given = {**given, "allow_path": [*_folders(given.get("allow_path")), *folders]}
    if not writer.materials and not writer.lights:
        return path, given
    how: Any = {name: given.pop(name) for name in READING if name in given}
    loaded = load(path, **how)
    for name, material in writer.materials.items():
        loaded.set_material(name, material)
    for name, light in writer.lights.items():
        loaded.set_light(name, light)
    if writer.materials:
        given.setdefault("integrator", "path")  # as of models, whose materials they are
    return loaded, given


@taking(RenderOptions.__annotations__)
def render(
    source: Drawable, /, *, picture: int = 0, progress: Progress = None, **options: Unpack[RenderOptions]
) -> Image:
    """Draws a scene or a model: a file's name, what `load` read, or a Scene.

    `picture`: which of the file's `render` statements, counted from 0. `progress`: False for no bar, or a function that is called
    with a number from 0 to 1, at last with 1. The others mean what they mean to `lichtraum render`: help(lichtraum.RenderOptions)
    says what each is. Other threads run meanwhile, and Ctrl-C stops it.

    Raises SceneError, UsageError, FileError, DeviceError.

    >>> image = render("scenes/hello.sdf", size=(64, 36), samples=16, progress=False)
    >>> image.size
    (64, 36)
    """
    given: dict[str, Any] = dict(options)
    device, traversal = given.pop("device", None), given.pop("traversal", None)
    _check(source, picture, given)  # mistakes are told before a device is looked for
    return Renderer(device, traversal=traversal)._draw(source, picture, progress, given)


@taking(READING)
def load(path: Path, /, **options: Unpack[RenderOptions]) -> LoadedScene:
    """Reads a scene or a model, as it is at the end of its file; with `time`, at that second of its animation.

    The options are those that say how files are read: help(lichtraum.RenderOptions) says what each is. Raises SceneError,
    UsageError, FileError.

    >>> load("scenes/hello.sdf").cameras
    ['eye']
    """
    for name in options:
        if name not in READING:
            raise TypeError(f"{name!r} does not affect how a file is read: pass it to render")
    how, how_saved = parsed(dict(options)), parsed({"allow_path": options.get("allow_path")})
    scene = LoadedScene(file_name(path), how, how_saved)
    _warn_of(scene.diagnostics)
    return scene
