"""Scenes that were read from files, and what is changed of them."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native
from ._errors import FileError, UsageError
from ._materials import Material, Phong
from ._nodes import Camera, Light
from ._values import Color, Vector, rotation, scaling, translation

if TYPE_CHECKING:
    from ._native import Diagnostic

Line = list[Any]


class LoadedScene:
    """A scene or a model that was read: see `load`. It can be drawn many times, and be changed in between."""

    def __init__(self, native: _native.Scene, path: str, is_dialect: bool = False) -> None:
        self._native = native
        self._path = path
        self._is_dialect = is_dialect
        self._moves: list[Line] = []
        self._materials: dict[str, Material] = {}
        self._lights: dict[str, Light | None] = {}
        self._cameras: dict[str, Camera] = {}

    @property
    def name(self) -> str:
        """Of its file."""
        return self._native.name

    @property
    def cameras(self) -> list[str]:
        """Names, the first for the one that is used unless another is asked for."""
        return self._native.cameras

    @property
    def shapes(self) -> list[str]:
        """Names."""
        return self._native.shapes

    @property
    def materials(self) -> list[str]:
        """Names."""
        return self._native.materials

    @property
    def lights(self) -> list[str]:
        """Names."""
        return self._native.lights

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """Warnings and notes."""
        return self._native.diagnostics

    def shape(self, name: str) -> LoadedShape:
        """To move it. Raises UsageError for a name that is not in `shapes`."""
        if name not in self.shapes:
            raise UsageError(f"the scene has no shape {name!r}")
        return LoadedShape(self, name)

    def set_material(self, name: str, material: Material) -> None:
        """Gives all that has the material of this name another one, with no textures but its own. Raises UsageError."""
        _native.set_material(self._native, name, *material.native())
        self._materials[name] = material

    def set_light(self, name: str, light: Light) -> None:
        """Puts a lamp in the place of the one of this name, or beside the others. Raises UsageError."""
        _native.set_light(self._native, name, light.kind, light.fields)
        self._lights[name] = light

    def remove_light(self, name: str) -> None:
        """Raises UsageError for a name that is not in `lights`."""
        _native.remove_light(self._native, name)
        self._lights[name] = None

    def set_camera(self, name: str, camera: Camera) -> None:
        """Puts a camera in the place of the one of this name, or beside the others: `render(scene, camera=name)`. Raises
        UsageError."""
        steps = [_native.Step(step[0], step[1:]) for step in camera.transforms()]
        _native.set_camera(self._native, name, float(camera.fov_x_degrees), steps, *map(int, camera.size))
        self._cameras[name] = camera

    def _move(self, name: str, step: Line) -> None:
        _native.transform(self._native, name, step[0], step[1:])
        self._moves.append(["transform", name, *step])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes its eSDF file with the changes, as it is now: with one `render`, the last. Its comments stay. Raises
        FileError, and UsageError for what eSDF cannot say: models' files, Pbr, spot and directional lamps; and for files
        that the scene reads from its own folder, if this is another one."""
        target = Path(path)
        if self._native.is_model:
            raise UsageError(f"{self._path}: a model is not saved as eSDF; lt.Scene([lt.Model(...)]) holds one")
        if self._is_dialect:
            raise UsageError(f"{self._path}: a scene that was read with transform_order or rotation cannot be saved")
        try:
            text = Path(self._path).read_text(encoding="utf-8", errors="surrogateescape")
            same_folder = os.path.realpath(target.parent) == os.path.realpath(Path(self._path).parent)
            new = "\n".join(self._saved_lines(text.splitlines(), same_folder)) + "\n"
            temporary = target.with_name(target.name + ".partial")
            temporary.write_text(new, encoding="utf-8", errors="surrogateescape")
            os.replace(temporary, target)
        except OSError as error:
            raise FileError(f"cannot save {self._path!r} as {str(target)!r}: {error.strerror}") from error

    def _saved_lines(self, lines: list[str], same_folder: bool) -> list[str]:
        new = {("material", name): _material_line(name, material) for name, material in self._materials.items()}
        new |= {("light", name): _light_line(name, light) for name, light in self._lights.items()}
        cameras = {("camera", name): _camera_lines(name, camera) for name, camera in self._cameras.items()}
        kept, seen, last_render = [], set(), ""
        for line in lines:
            words = line.split("#")[0].split()
            if words[:1] == ["render"]:
                last_render = line
                continue
            if not same_folder and _names_a_file(words):
                raise UsageError(f"{self._path}: {' '.join(words[:4])} reads a file of its folder: save it there")
            if words[:1] == ["transform"] and ("camera", words[1]) in cameras:
                continue
            thing = _defined(words)
            if thing in new or thing in cameras:
                seen.add(thing)
                kept += [new[thing]] if thing in new else cameras[thing]
            else:
                kept.append(line)
        for thing, made in new.items():
            if thing[0] == "material" and thing not in seen:
                raise UsageError(f"{self._path}: the line that defines material {thing[1]!r} cannot be found")
            if thing not in seen and not made.startswith("#"):
                kept.append(made)
        for thing, several in cameras.items():
            kept += several if thing not in seen else []
        kept += [_text(move) for move in self._moves]
        return kept + [last_render] if last_render else kept

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
        """Scales it about the origin: by one factor, or by one along each axis. None is 0."""
        self._scene._move(self.name, scaling(factor))

    def __repr__(self) -> str:
        return f"<lichtraum.LoadedShape {self.name!r}>"


def _text(words: Line) -> str:
    return " ".join(word if isinstance(word, str) else repr(float(word)) for word in words)


def _material_line(name: str, material: Material) -> str:
    if not isinstance(material, Phong):
        raise UsageError(f"material {name!r}: eSDF has no material like Pbr")
    return _text(["define", "material", name, *material.words()])


def _light_line(name: str, light: Light | None) -> str:
    if light is None:
        return f"# {name} was removed"
    words = light.words(name)
    if words is None:
        raise UsageError(f"light {name!r}: eSDF has no {light.kind} lamp")
    return _text(words)


def _camera_lines(name: str, camera: Camera) -> list[str]:
    size = [str(int(side)) for side in camera.size]
    first = _text(["define", "camera", name, camera.fov_x_degrees, *size])
    return [first, *(_text(["transform", name, *step]) for step in camera.transforms())]


def _names_a_file(words: list[str]) -> bool:
    if words[:3] == ["define", "light", "environment"]:
        return len(words) > 4 and words[4] != "studio" and not words[4].replace(".", "").isdigit()
    return words[:3] == ["define", "shape", "mesh"]


def _defined(words: list[str]) -> tuple[str, str]:
    """The kind and the name of what a line defines."""
    words = words[1:] if words[:1] == ["define"] else words
    if len(words) > 2 and words[0] == "light" and words[1] in ("diffuse", "ambient"):
        return "light", words[2]
    return (words[0], words[1]) if len(words) > 1 and words[0] in ("material", "light", "camera") else ("", "")
