"""What surfaces are made of."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any, Union

from ._values import Color, color, number

Fields = dict[str, list[float]]


@dataclass(frozen=True)
class Phong:
    """What a surface is made of: Phong's coefficients, with a mirror's and glass's (docs/ESDF.md). Colours are linear red,
    green and blue, or one number for all; shares are 0 to 1."""

    ambient: Color = 0.8
    diffuse: Color = 0.8
    specular: Color = 0.0
    exponent: float = 1.0
    reflect: float = 0.0
    transmit: float = 0.0
    ior: float = 1.0
    emission: Color = 0.0

    def words(self) -> list[Any]:
        """Of eSDF, after the name."""
        words: list[Any] = [*color(self.ambient), *color(self.diffuse), *color(self.specular), number(self.exponent)]
        for name, usual in (("reflect", 0), ("transmit", 0), ("ior", 1)):
            value = number(getattr(self, name))
            if value != usual:
                words.append(f"{name}={value!r}")
        return words + (["emission", *color(self.emission)] if any(color(self.emission)) else [])

    def native(self) -> tuple[str, Fields]:
        """The model, and its fields as the library calls them."""
        colors = {"ka": self.ambient, "kd": self.diffuse, "ks": self.specular, "emission": self.emission}
        numbers = {"m": self.exponent, "reflect": self.reflect, "transmit": self.transmit, "ior": self.ior}
        made: Fields = {name: [*color(value)] for name, value in colors.items()}
        return "phong", made | {name: [number(value)] for name, value in numbers.items()}


@dataclass(frozen=True)
class Pbr:
    """glTF's material (docs/GLTF.md), without textures: what is left out is as glTF has it. Colours are linear red, green
    and blue, or one number for all; shares are 0 to 1. eSDF does not have it, so scenes with it can be drawn, but not
    saved."""

    base_color: Color = 1.0
    metallic: float = 1.0
    roughness: float = 1.0
    alpha: float = 1.0  #: below 1, what is behind is seen through it
    emissive: Color = 0.0  #: may be above 1
    ior: float = 1.5
    specular: float = 1.0
    specular_color: Color = 1.0
    transmission: float = 0.0
    thickness: float = 0.0  #: 0: a thin wall; else a solid body
    attenuation_color: Color = 1.0
    attenuation_distance: float = math.inf
    dispersion: float = 0.0
    clearcoat: float = 0.0
    clearcoat_roughness: float = 0.0
    sheen_color: Color = 0.0
    sheen_roughness: float = 0.0
    anisotropy: float = 0.0
    anisotropy_rotation: float = 0.0  #: radians
    iridescence: float = 0.0
    iridescence_ior: float = 1.3
    diffuse_transmission: float = 0.0
    diffuse_transmission_color: Color = 1.0
    double_sided: bool = False
    unlit: bool = False

    def native(self) -> tuple[str, Fields]:
        """The model, and its fields as the library calls them."""
        made: Fields = {}
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name in _COLORS:
                made[field.name] = [*color(value, least=0)]
            elif field.name in _LEAST:
                value = math.inf if value == math.inf else number(value)
                made[field.name] = [number(value, least=_LEAST[field.name]) if value != math.inf else value]
            else:
                made[field.name] = [number(value, least=0, most=1)]
        if made["alpha"][0] < 1:
            made["alpha_mode"] = [2]  # AlphaMode::blend
        return "pbr", made


_COLORS = ("base_color", "emissive", "specular_color", "attenuation_color", "sheen_color", "diffuse_transmission_color")
#: Those that are no shares, and what they are at least.
_LEAST = {
    "ior": 1.0,
    "thickness": 0.0,
    "attenuation_distance": 1e-30,
    "dispersion": 0.0,
    "anisotropy_rotation": -math.inf,
    "iridescence_ior": 1.0,
}

Material = Union[Phong, Pbr]
WHITE = Phong()
