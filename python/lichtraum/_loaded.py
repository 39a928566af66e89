"""Scenes that were read from files, and what is changed of them."""

from __future__ import annotations

import os
from pathlib import Path

from . import _native
from ._edited_text import EditedText
from ._errors import FileError, SceneError, UsageError
from ._files import draft, reading, scene_file, write_file
from ._materials import Material, checked
from ._native import Diagnostic
from ._nodes import Camera, Light
from ._values import Color, Vector, Words, expect, named, number, rotation, scaling, size_in_pixels, translation
from ._waiting import wait_for


class LoadedScene:
    """A scene or a model that was read: see `load`. It can be drawn many times, and be changed in between."""

    def __init__(self, path: str, how: _native.Options, how_saved: _native.Options) -> None:
        """`how` it is read, and what of that holds for files that are saved of it."""
        with reading(path):
            self._native = wait_for(lambda _: _native.read_scene(path, how))
        self._path, self._how, self._how_saved = os.path.abspath(path), how, how_saved
        self._moves: list[tuple[str, Words]] = []
        self._materials: dict[str, Material] = {}
        self._lights: dict[str, Light] = {}
        self._removed_lights: set[str] = set()
        self._cameras: dict[str, Camera] = {}

    @property
    def name(self) -> str:
        """The name of the scene's file."""
        return self._native.name

    @property
    def cameras(self) -> list[str]:
        """Names, the first for the one that is used unless another is asked for."""
        return self._native.cameras

    @property
    def shapes(self) -> list[str]:
        """The names of the shapes."""
        return self._native.shapes

    @property
    def materials(self) -> list[str]:
        """The names of the materials."""
        return self._native.materials

    @property
    def lights(self) -> list[str]:
        """The names of the lights."""
        return self._native.lights

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """Warnings and notes."""
        return self._native.diagnostics

    def shape(self, name: str) -> LoadedShape:
        """To move it. Raises UsageError for a name that is not in `shapes`."""
        if named(name) not in self.shapes:
            raise UsageError(f"the scene has no shape {name!r}")
        return LoadedShape(self, name)

    def set_material(self, name: str, material: Material) -> None:
        """Gives all that has the material of this name another one, with no textures but its own. Raises UsageError."""
        _native.set_material(self._native, named(name), *checked(material).native())
        self._materials[name] = material

    def set_light(self, name: str, light: Light) -> None:
        """Puts a lamp in the place of the one of this name, or beside the others. Raises UsageError."""
        expect("light", light, Light, "a lichtraum.Light")
        _native.set_light(self._native, named(name), light.kind, light.fields)
        self._lights[name] = light

    def remove_light(self, name: str) -> None:
        """Raises UsageError for a name that is not in `lights`."""
        _native.remove_light(self._native, named(name))
        self._lights.pop(name, None)
        self._removed_lights.add(name)

    def set_camera(self, name: str, camera: Camera) -> None:
        """Puts a camera in the place of the one of this name, or beside the others: `render(scene, camera=name)`. Raises
        UsageError."""
        expect("camera", camera, Camera, "a lichtraum.Camera")
        steps = [_native.Step(step[0], step[1:]) for step in camera.transforms()]
        width = None if camera.orthographic is None else number("orthographic", camera.orthographic)
        fov, sides = number("fov_x_degrees", camera.fov_x_degrees), size_in_pixels("size", camera.size)
        _native.set_camera(self._native, named(name), fov, width, steps, *sides)
        self._cameras[name] = camera

    def _move(self, name: str, step: Words) -> None:
        _native.transform(self._native, name, step[0], step[1:])
        self._moves.append((name, step))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes its eSDF file with the changes: what `render(scene)` draws, as the only picture. All other lines stay, with
        their comments. What was written is read again, without the options of `load` but `allow_path`, and only kept if
        it gives the same pictures to the byte.

        Raises FileError, and UsageError for what eSDF cannot say: models' files, Pbr, spot and directional lamps; files that
        the scene reads from its own folder, if this is another one; scenes that only options make what they are."""
        target = scene_file(path)
        if self._native.is_model:
            raise UsageError(f"{self._path}: a model is not saved as eSDF; lt.Scene([lt.Model(...)]) holds one")
        try:
            edited = self._edited(Path(self._path).read_bytes())
            with draft(target) as temporary:
                temporary.write_bytes(edited)
                self._check(temporary, target)
            write_file(target, edited)
        except FileError:
            raise
        except OSError as error:
            message = f"cannot save {self._path!r} as {str(target)!r}: {error.strerror or error}"
            raise FileError.of(message, error, str(target)) from error

    def _edited(self, source: bytes) -> bytes:
        statements = wait_for(lambda _: _native.statements_of(source, self._path, self._how))
        text = EditedText(source.decode("utf-8", "surrogateescape"), statements, self._native.has_brightness)
        for name, material in self._materials.items():
            text.set_material(name, material)
        for name in self._removed_lights:
            text.remove_light(name)
        for name, light in self._lights.items():
            text.set_light(name, light, at_end=name in self._removed_lights)
        for name, camera in self._cameras.items():
            text.set_camera(name, camera)
        for name, step in self._moves:
            text.move(name, step)
        return text.text().encode("utf-8", "surrogateescape")

    def _check(self, saved: Path, target: Path) -> None:
        refused = f"{self._path} cannot be saved as {target}"
        is_elsewhere = os.path.realpath(target.parent) != os.path.realpath(Path(self._path).parent)
        hint = "; files that it reads are looked for beside it: save it in its own folder" if is_elsewhere else ""
        try:
            again = wait_for(lambda _: _native.read_scene(str(saved), self._how_saved))
        except SceneError as error:
            first = next(found for found in error.diagnostics if found.severity == "error")
            raise UsageError(f"{refused}: line {first.line} would be wrong: {first.message}{hint}") from error
        if _native.identity_of(again) != _native.identity_of(self._native):
            why = "eSDF cannot say these changes, options such as rotation made it what it is, or its file was changed"
            raise UsageError(f"{refused}: read again, it would be another scene: {why}{hint}")

    def __repr__(self) -> str:
        return f"<lichtraum.LoadedScene {self.name!r}>"


class LoadedShape:
    """A shape or a group of a scene that was loaded. Wherever it occurs, it moves."""

    def __init__(self, scene: LoadedScene, name: str) -> None:
        self._scene = scene
        self.name = name

    def translate(self, offset: Vector) -> None:
        """Moves it, after what was done before."""
        self._scene._move(self.name, translation(offset))

    def rotate(self, angle_degrees: float, axis: Vector) -> None:
        """Turns it about an axis through the origin, anticlockwise where that points at you."""
        self._scene._move(self.name, rotation(angle_degrees, axis))

    def scale(self, factor: Color) -> None:
        """Scales it about the origin: by one factor, or by one along each axis. No factor may be 0."""
        self._scene._move(self.name, scaling(factor))

    def __repr__(self) -> str:
        return f"<lichtraum.LoadedShape {self.name!r}>"

