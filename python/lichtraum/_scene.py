"""Scenes that are made in Python."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
import weakref
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterable, Iterator, Optional

from ._errors import FileError, SceneError, UsageError
from ._esdf import Writer
from ._files import scene_file, write_file
from ._native import Diagnostic
from ._nodes import Camera, Light, Model, Shape
from ._parts import Item, parts_of
from ._values import Color, expect, is_word, items_of


class _Workplace:
    """Where the files of a scene are while it is drawn: those of one picture at a time. A copy of the scene, and one that
    was pickled, gets another."""

    def __init__(self) -> None:
        self.models: dict[str, str] = {}  #: their files, by what the scene's file calls them
        self._turn = threading.RLock()  # again by one thread: `progress` may draw
        self._folder: Optional[Path] = None

    def folder(self) -> Path:
        """Goes with the scene, without the warning of a TemporaryDirectory that its user has to clean up."""
        if self._folder is None:
            self._folder = Path(tempfile.mkdtemp(prefix="lichtraum-"))
            weakref.finalize(self, shutil.rmtree, self._folder, ignore_errors=True)
        return self._folder

    def file(self) -> Path:
        return self.folder() / "scene.sdf"

    @contextmanager
    def use(self) -> Iterator[None]:
        """For one picture. Nobody has written that file: what is wrong in it are values, which a UsageError names, and models,
        which a FileError does."""
        with self._turn:
            try:
                yield
            except SceneError as error:
                faults = [each for each in error.diagnostics if each.severity == "error"]
                if any(each.file != str(self.file()) for each in faults):
                    raise
                for each in faults:
                    self._raise_of_model(each)
                text = "; ".join(f"{each.message}, in '{each.source_line.strip()}'" for each in faults)
                raise UsageError(text) from error

    def _raise_of_model(self, fault: Diagnostic) -> None:
        """If it is one, by the name that was given."""
        for word in fault.source_line.split():
            if word in self.models:
                path = self.models[word]
                try:
                    os.stat(path)
                except OSError as cause:
                    raise FileError.of(f"cannot read '{path}': {cause.strerror}", cause, path) from None
                why = fault.message.partition("': ")[2] or fault.message  # after the scene's name for it
                raise FileError(f"cannot read '{path}': {why}")

    def __reduce__(self) -> tuple[type[_Workplace], tuple[()]]:
        return _Workplace, ()


class Scene:
    """Shapes and lights, a camera and a background.

    >>> import lichtraum as lt
    >>> scene = lt.Scene([lt.Sphere((0, 0, -5), 1), lt.Light.point((5, 8, 2))])
    >>> lt.render(scene, size=(40, 30)).size
    (40, 30)
    """

    def __init__(
        self, items: Iterable[Item] = (), *, camera: Optional[Camera] = None, background: Optional[Color] = None
    ) -> None:
        self.items: list[Item] = []
        self.camera = Camera() if camera is None else camera
        self.background = background
        self._workplace = _Workplace()
        for item in items_of("items", items, "a list of shapes and lights"):
            self.add(item)

    @property
    def camera(self) -> Camera:
        """Which sees it, unless options say otherwise."""
        return self._camera

    @camera.setter
    def camera(self, camera: Camera) -> None:
        expect("camera", camera, Camera, "a lichtraum.Camera")
        self._camera = camera

    def add(self, item: Item) -> None:
        """A shape, a group of them, or a light."""
        if not isinstance(item, (Shape, Light)):
            raise TypeError(f"a scene holds shapes and lights, not {item!r}")
        self.items.append(item)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the scene as eSDF (.sdf): `lichtraum render` draws the same picture of it. Meshes become .ply files beside
        it, and replace only those of earlier saves to the same file; models stay where they are, and outside the scene's
        folder take --allow-path. Raises FileError, and UsageError for what eSDF cannot say: Pbr, spot and directional
        lamps, files with spaces in their names."""
        self._write(scene_file(path))

    def _write(self, path: Path, *, only_drawn: bool = False) -> Writer:
        if not is_word(path.name):
            raise UsageError(f"{path.name!r}: eSDF cannot name files with spaces or a #, such as the meshes beside it")
        parts = parts_of(self.items)
        if any(isinstance(part, Model) and os.path.realpath(part.path) == os.path.realpath(path) for part in parts):
            raise UsageError(f"{str(path)!r} is a model of this scene, and would be lost: save the scene under another name")
        writer = Writer(path, parts, only_drawn=only_drawn)
        try:
            for part in parts:
                if isinstance(part, Light):
                    writer.light(part)
                else:
                    writer.shape(part)
            if self.background is not None:
                writer.background(self.background)
            writer.camera(self.camera, path.stem + ".png")
            writer.write_meshes()
            write_file(path, writer.text().encode("utf-8", "surrogateescape"))
        except FileError:
            raise
        except OSError as error:
            raise FileError.of(f"cannot write {str(path)!r}: {error.strerror or error}", error, str(path)) from error
        return writer

    def _drawable(self) -> tuple[str, list[str], Writer]:
        """A file of the scene as it is now, the folders of its models, and what eSDF could not say."""
        path = self._workplace.file()
        writer = self._write(path, only_drawn=True)
        self._workplace.models = writer.files
        folders = {os.path.dirname(os.path.realpath(model.path)) for model in parts_of(self.items) if isinstance(model, Model)}
        return str(path), sorted(folders), writer

    def __getstate__(self) -> dict[str, Any]:
        """Parts first: of what they are copied or pickled with, groups then find their children done, however deep."""
        return {"parts": parts_of(self.items), **self.__dict__}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update((name, value) for name, value in state.items() if name != "parts")

    def __repr__(self) -> str:
        return f"<lichtraum.Scene of {len(self.items)} things>"
