"""The text of an eSDF file, and what is changed of it."""

from __future__ import annotations

import re

from ._errors import UsageError
from ._materials import Material, Phong
from ._native import Statement
from ._nodes import Camera, Light
from ._values import Words, is_word, text_of


class EditedText:
    """Lines that change nothing which was changed since stay as they are, with their comments.

    `statements`: what the lines do. `has_brightness`: a lamp is a colour times a brightness, which decides on the tone map.
    """

    def __init__(self, text: str, statements: list[Statement], has_brightness: bool) -> None:
        self._lines = re.split("\r\n|\r|\n", text.removeprefix("\ufeff"))
        self._places: dict[tuple[str, str], list[int]] = {}
        for each in statements:
            self._places.setdefault((each.kind, each.name), []).append(each.line)
        self._renders = [each.line for each in statements if each.kind == "render"]
        self._has_brightness = has_brightness
        self._new: dict[int, list[str]] = {}  # instead of the line of that number
        self._end: list[str] = []

    def _define(self, kind: str, name: str, lines: list[str]) -> None:
        places = self._places.get((kind, name))
        if places:
            self._new[places[-1]] = lines
        else:
            self._end += lines

    def set_material(self, name: str, material: Material) -> None:
        if not isinstance(material, Phong):
            raise UsageError(f"material {name!r}: eSDF has no material like Pbr")
        if ("material", name) not in self._places:
            raise UsageError(f"material {name!r} is a model's, whose file is not changed")
        self._define("material", name, [text_of(["define", "material", name, *material.words()])])

    def remove_light(self, name: str) -> None:
        for place in self._places.get(("light", name), []):
            self._new[place] = [f"# {name} was removed"]

    def set_light(self, name: str, light: Light, *, at_end: bool) -> None:
        line = text_of(self._light_words(name, light))
        if at_end:
            self._end.append(line)
        else:
            self._define("light", name, [line])

    def _light_words(self, name: str, light: Light) -> Words:
        words = light.words(name)
        if words is None:
            raise UsageError(f"light {name!r}: eSDF has no {light.kind} lamp")
        if not is_word(name):
            if light.kind != "ambient":
                raise UsageError(f"light {name!r}: a name in eSDF has no spaces and no #")
            return ["ambient", *light.fields["brightness"]]
        if not self._has_brightness:
            return words
        if light.kind == "ambient":
            return ["ambient", name, *light.fields["brightness"], 1]
        return ["define", "light", name, *words[4:10], 1, *words[10:]]

    def set_camera(self, name: str, camera: Camera) -> None:
        if not is_word(name):
            raise UsageError(f"camera {name!r}: a name in eSDF has no spaces and no #")
        first = text_of(camera.words(name))
        moves = [text_of(["transform", name, *step]) for step in camera.transforms()]
        for place in self._places.get(("camera_transform", name), []):
            self._new[place] = []
        self._define("camera", name, [first, *moves])

    def move(self, shape: str, step: Words) -> None:
        self._end.append(text_of(["transform", shape, *step]))

    def text(self) -> str:
        """With one `render`, the first, at its end."""
        new = self._new | {place: [] for place in self._renders}
        kept = [line for number, old in enumerate(self._lines, 1) for line in new.get(number, [old])]
        while kept and not kept[-1]:
            kept.pop()
        last = [self._lines[place - 1] for place in self._renders[:1]]
        return "\n".join([*kept, *self._end, *last, ""])
