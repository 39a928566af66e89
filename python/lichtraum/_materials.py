"""What surfaces are made of."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, Iterable, Optional, Union

from ._texture import Texture
from ._values import Color, color, expect, number, unchanging

if TYPE_CHECKING:
    from . import _native

Fields = dict[str, list[float]]
Textures = dict[str, "_native.Texture"]


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

    def __post_init__(self) -> None:
        _settle(self, ("ambient", "diffuse", "specular", "emission"))
        self.native()

    def words(self) -> list[Any]:
        """Of eSDF, after the name."""
        _, fields, _ = self.native()
        words: list[Any] = [*fields["ka"], *fields["kd"], *fields["ks"], *fields["m"]]
        for name, usual in (("reflect", 0), ("transmit", 0), ("ior", 1)):
            value = fields[name][0]
            if value != usual:
                words.append(f"{name}={value!r}")
        return words + (["emission", *fields["emission"]] if any(fields["emission"]) else [])

    def native(self) -> tuple[str, Fields, Textures]:
        """The model, and its fields and textures as the library calls them."""
        colors = {"ka": "ambient", "kd": "diffuse", "ks": "specular", "emission": "emission"}
        numbers = {"m": "exponent", "reflect": "reflect", "transmit": "transmit", "ior": "ior"}
        made: Fields = {key: [*color(name, getattr(self, name))] for key, name in colors.items()}
        return "phong", made | {key: [number(name, getattr(self, name))] for key, name in numbers.items()}, {}


@dataclass(frozen=True)
class Pbr:
    """glTF's material (docs/GLTF.md): what is left out is as glTF has it. Colours are linear red, green and blue, or one
    number for all; shares are 0 to 1. Both are multiplied with their texture, if there is one, in the channels that glTF
    says. A base colour's texture that is not opaque everywhere shows what is behind. eSDF does not have this material, so
    scenes with it can be drawn, but not saved."""

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
    iridescence_thickness_minimum: float = 100.0  #: nanometres
    iridescence_thickness_maximum: float = 400.0
    double_sided: bool = False
    unlit: bool = False
    normal_scale: float = 1.0
    clearcoat_normal_scale: float = 1.0
    occlusion_strength: float = 1.0
    base_color_texture: Optional[Texture] = None
    metallic_roughness_texture: Optional[Texture] = None
    normal_texture: Optional[Texture] = None
    occlusion_texture: Optional[Texture] = None
    emissive_texture: Optional[Texture] = None
    specular_texture: Optional[Texture] = None
    specular_color_texture: Optional[Texture] = None
    transmission_texture: Optional[Texture] = None
    clearcoat_texture: Optional[Texture] = None
    clearcoat_roughness_texture: Optional[Texture] = None
    clearcoat_normal_texture: Optional[Texture] = None
    sheen_color_texture: Optional[Texture] = None
    sheen_roughness_texture: Optional[Texture] = None
    anisotropy_texture: Optional[Texture] = None
    diffuse_transmission_texture: Optional[Texture] = None
    diffuse_transmission_color_texture: Optional[Texture] = None
    iridescence_texture: Optional[Texture] = None
    iridescence_thickness_texture: Optional[Texture] = None

    def __post_init__(self) -> None:
        _settle(self, _COLORS)
        self.native()

    def has_textures(self) -> bool:
        return any(getattr(self, field.name) is not None for field in fields(self) if field.name in _TEXTURES)

    def native(self) -> tuple[str, Fields, Textures]:
        """The model, and its fields and textures as the library calls them."""
        made: Fields = {}
        textures: Textures = {}
        for field in fields(self):
            name, value = field.name, getattr(self, field.name)
            if name in _TEXTURES:
                if value is not None:
                    expect(name, value, Texture, "a lichtraum.Texture")
                    textures[name] = value._native
            elif name in _COLORS:
                made[name] = [*color(name, value, least=0)]
            elif name in _LEAST:
                made[name] = [number(name, value, least=_LEAST[name], endless=name == "attenuation_distance")]
            else:
                made[name] = [number(name, value, least=0, most=1)]
        base = textures.get("base_color_texture")
        if made["alpha"][0] < 1 or (base is not None and base.has_alpha):
            made["alpha_mode"] = [2]  # AlphaMode::blend
        return "pbr", made, textures


def _settle(material: Material, colors: Iterable[str]) -> None:
    """Lists and arrays become tuples, as scenes look materials up."""
    for name in colors:
        object.__setattr__(material, name, unchanging(name, getattr(material, name)))


_TEXTURES = tuple(field.name for field in fields(Pbr) if field.name.endswith("_texture"))
_COLORS = ("base_color", "emissive", "specular_color", "attenuation_color", "sheen_color", "diffuse_transmission_color")
#: Those that are no shares, and what they are at least.
_LEAST = {
    "ior": 1.0,
    "thickness": 0.0,
    "attenuation_distance": 1e-30,
    "dispersion": 0.0,
    "anisotropy_rotation": -math.inf,
    "iridescence_ior": 1.0,
    "iridescence_thickness_minimum": 0.0,
    "iridescence_thickness_maximum": 0.0,
    "normal_scale": 0.0,
    "clearcoat_normal_scale": 0.0,
}

Material = Union[Phong, Pbr]


def checked(material: Any) -> Material:
    """Raises TypeError for what is none."""
    expect("material", material, (Phong, Pbr), "a lichtraum.Phong or Pbr")
    return material  # type: ignore[no-any-return]


WHITE = Phong()
