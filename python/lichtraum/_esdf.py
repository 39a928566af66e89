"""Scenes that were made in Python, as eSDF."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy

from ._errors import UsageError
from ._nodes import Camera, Color, Light, Mesh, Phong, Shape, color


def _text(word: Any) -> str:
    return word if isinstance(word, str) else repr(float(word))


class Writer:
    """Collects the statements of one scene. `folder`: where its file will be, and the files of its meshes."""

    def __init__(self, folder: Path, prefix: str) -> None:
        self._folder = folder
        self._prefix = prefix
        self._lines: list[str] = []
        self._materials: dict[Phong, str] = {}
        self._shapes: dict[int, str] = {}
        self._open: set[int] = set()
        self._names: set[str] = set()
        self._meshes: dict[int, str] = {}

    def _line(self, *words: Any) -> None:
        self._lines.append(" ".join(_text(word) for word in words))

    def _name(self, wanted: str | None, kind: str) -> str:
        """Of a shape or a light."""
        if wanted is not None:
            if not wanted or any(letter.isspace() for letter in wanted) or "#" in wanted:
                raise UsageError(f"{wanted!r} cannot be a name: it has spaces or a #")
            if wanted in self._names:
                raise UsageError(f"there are two things that are called {wanted!r}")
        count = 1
        while wanted is None or (wanted in self._names):
            candidate = f"{kind}_{count}"
            wanted = candidate if candidate not in self._names else None
            count += 1
        self._names.add(wanted)
        return wanted

    def _material(self, material: Phong) -> str:
        if material not in self._materials:
            self._materials[material] = f"material_{len(self._materials) + 1}"
            self._line("define", "material", self._materials[material], *material.words())
        return self._materials[material]

    def shape(self, shape: Shape) -> str:
        """Defines it, unless it is, and returns its name."""
        if id(shape) in self._open:
            raise UsageError("a group cannot hold itself")
        if id(shape) not in self._shapes:
            self._open.add(id(shape))
            words = shape.words(self)
            self._open.remove(id(shape))
            material = [] if shape.material is None else [self._material(shape.material)]
            name = self._shapes[id(shape)] = self._name(shape.name, shape.kind)
            self._line("define", "shape", shape.kind, name, *words, *material)
            for transform in shape.transforms:
                self._line("transform", name, *transform)
        return self._shapes[id(shape)]

    def light(self, light: Light) -> None:
        self._line("define", "light", light.kind, self._name(light.name, "light"), *light.values)

    def background(self, value: Color) -> None:
        self._line("define", "background", *color(value))

    def camera(self, camera: Camera, picture: str) -> None:
        width, height = (str(int(side)) for side in camera.size)
        name = self._name(None, "camera")
        self._line("define", "camera", name, camera.fov_x_degrees, width, height)
        for transform in camera.transforms():
            self._line("transform", name, *transform)
        self._line("render", name, picture)

    def file_of(self, mesh: Mesh) -> str:
        """The name of a PLY file with its triangles, which is written unless it is there."""
        if id(mesh) not in self._meshes:
            name = self._meshes[id(mesh)] = f"{self._prefix}{len(self._meshes) + 1}.ply"
            content = _ply(mesh)
            path = self._folder / name
            if not path.exists() or path.read_bytes() != content:
                path.write_bytes(content)
        return self._meshes[id(mesh)]

    def path_of(self, path: str) -> str:
        """As seen from the scene's file."""
        return os.path.relpath(path, self._folder.resolve())

    def text(self) -> str:
        return "\n".join(self._lines) + "\n"


def _ply(mesh: Mesh) -> bytes:
    rows = numpy.empty(len(mesh.faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, mesh.faces
    head = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(mesh.vertices)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(mesh.faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    return head.encode() + mesh.vertices.tobytes() + rows.tobytes()
