"""Scenes that were made in Python, as eSDF."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any, Sequence

import numpy

from ._errors import FileError, UsageError
from ._files import write_file
from ._materials import WHITE, Material, Pbr, Phong
from ._nodes import Camera, Light, Mesh, Model, Shape
from ._values import Color, color, is_word, named, text_of


class Writer:
    """Collects the statements of one scene. `target`: its file, beside which those of its meshes will be. `parts`: all that
    it will be told of. What eSDF cannot say is a UsageError, or, of a scene that is only drawn, in `materials` and
    `lights`."""

    def __init__(self, target: Path, parts: Sequence[Shape | Light], *, only_drawn: bool = False) -> None:
        self._only_drawn = only_drawn
        self.materials: dict[str, Material] = {}
        self.lights: dict[str, Light] = {}
        #: The models' files, by what the scene calls them.
        self.files: dict[str, str] = {}
        self._links: dict[str, str] = {}
        self._target = target
        self._folder = target.parent
        self._models = {os.path.realpath(part.path) for part in parts if isinstance(part, Model)}
        self._reserved = {part.name for part in parts if part.name is not None}
        self._lines: list[str] = []
        self._materials: dict[Material, str] = {}
        self._shapes: dict[int, str] = {}
        self._names: set[str] = set()
        self._meshes: dict[int, tuple[Mesh, str]] = {}
        self._mesh_count = 0

    def _line(self, *words: Any) -> None:
        self._lines.append(text_of([*words]))

    def _name(self, wanted: str | None, kind: str) -> str:
        """Of a shape or a light."""
        if wanted is not None:
            if not is_word(named(wanted)):
                raise UsageError(f"{wanted!r} cannot be a name: it is empty, or has spaces or a #")
            if wanted in self._names:
                raise UsageError(f"there are two things that are called {wanted!r}")
        count = 1
        while wanted is None or (wanted in self._names):
            candidate = f"{kind}_{count}"
            wanted = candidate if candidate not in self._names and candidate not in self._reserved else None
            count += 1
        self._names.add(wanted)
        return wanted

    def _refuse(self, what: str) -> None:
        if not self._only_drawn:
            raise UsageError(f"eSDF has no {what}: such a scene can be drawn, but not saved")

    def _material(self, material: Material) -> str:
        if material not in self._materials:
            name = self._materials[material] = f"material_{len(self._materials) + 1}"
            if isinstance(material, Phong):
                words = material.words()
            else:
                self._refuse("material like Pbr")
                self.materials[name], words = material, WHITE.words()
            self._line("define", "material", name, *words)
        return self._materials[material]

    def shape(self, shape: Shape) -> None:
        """Defines it, after its children."""
        words = shape.words(self)
        if isinstance(shape.material, Pbr) and shape.material.has_textures() and not shape.has_texcoords:
            raise UsageError(f"a texture needs texture coordinates, and this {shape.kind} has none: take a Mesh with texcoords")
        material = [] if shape.material is None else [self._material(shape.material)]
        name = self._shapes[id(shape)] = self._name(shape.name, shape.kind)
        self._line("define", "shape", shape.kind, name, *words, *material)
        for transform in shape.transforms:
            self._line("transform", name, *transform)

    def name_of(self, shape: Shape) -> str:
        """Of one that is defined."""
        return self._shapes[id(shape)]

    def light(self, light: Light) -> None:
        name = self._name(light.name, "light")
        words = light.words(name)
        if words is not None:
            self._line(*words)
        else:
            self._refuse(f"{light.kind} lamp")
            self.lights[name] = light

    def background(self, value: Color) -> None:
        self._line("define", "background", *color("background", value))

    def camera(self, camera: Camera, picture: str) -> None:
        name = self._name(None, "camera")
        self._line(*camera.words(name))
        for transform in camera.transforms():
            self._line("transform", name, *transform)
        self._line("render", name, picture)

    def file_of(self, mesh: Mesh) -> str:
        """The name of a PLY file with its triangles, which `write_meshes` writes."""
        if id(mesh) not in self._meshes:
            self._meshes[id(mesh)] = mesh, self._free_name()
        return self._meshes[id(mesh)][1]

    def _free_name(self) -> str:
        """Of no file but one that an earlier save to the same target has made."""
        while True:
            self._mesh_count += 1
            path = self._folder / f"{self._target.stem}_mesh_{self._mesh_count}.ply"
            if not os.path.lexists(path) or (_is_made_for(path, self._target) and os.path.realpath(path) not in self._models):
                return path.name

    def write_meshes(self) -> None:
        for mesh, name in self._meshes.values():
            path, content = self._folder / name, _ply(mesh, self._target)
            if not path.exists() or path.read_bytes() != content:
                write_file(path, content)

    def path_of(self, path: str) -> str:
        """As the scene's file calls it: as seen from there; one that eSDF cannot name, by a link."""
        name = self._name_of(path)
        self.files[name] = path
        return name

    def _name_of(self, path: str) -> str:
        relative = os.path.relpath(path, self._folder.resolve())
        if is_word(relative):
            return relative
        if not self._only_drawn:
            raise UsageError(f"{relative}: eSDF cannot name a file with spaces or a # in its path")
        if path not in self._links:
            self._links[path] = self._link(path)
        return self._links[path]

    def _link(self, path: str) -> str:
        """Its whole folder, as what else the model reads is beside it."""
        folder, file = os.path.split(path)
        links = self._folder / f"model_{len(self._links) + 1}"
        shutil.rmtree(links, ignore_errors=True)
        links.mkdir()
        try:
            others = os.listdir(folder)
        except OSError as error:
            raise FileError.of(f"cannot read '{path}': {error.strerror}", error, path) from error
        for other in others:
            os.symlink(os.path.join(folder, other), links / other)
        plain = "model" + os.path.splitext(file)[1]
        if not is_word(plain):
            raise UsageError(f"{path}: there is no such kind of model")
        if not is_word(file):
            (links / plain).unlink(missing_ok=True)
            os.symlink(path, links / plain)
        return f"{links.name}/{plain if not is_word(file) else file}"

    def text(self) -> str:
        return "\n".join(self._lines) + "\n"


def _ply_begin(target: Path) -> bytes:
    """How the files of the meshes of `target` begin, and no others."""
    return b"ply\nformat binary_little_endian 1.0\ncomment a mesh of lichtraum's scene " + os.fsencode(target.name) + b"\n"


def _is_made_for(path: Path, target: Path) -> bool:
    begin = _ply_begin(target)
    if not path.is_file() or path.is_symlink():
        return False
    with path.open("rb") as file:
        return file.read(len(begin)) == begin


def _ply(mesh: Mesh, target: Path) -> bytes:
    rows = numpy.empty(len(mesh.faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, mesh.faces
    columns = [("x y z", mesh.vertices), ("nx ny nz", mesh.normals), ("u v", mesh.texcoords)]
    given = [(names, values) for names, values in columns if values is not None]
    head = (
        f"element vertex {len(mesh.vertices)}\n"
        + "".join(f"property float {name}\n" for names, _ in given for name in names.split())
        + f"element face {len(mesh.faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    vertices = numpy.hstack([values for _, values in given])
    return _ply_begin(target) + head.encode() + vertices.tobytes() + rows.tobytes()
