"""What scenes are made of. Each can write itself as eSDF, which is also how it is drawn."""

from __future__ import annotations

import math
import os
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterable, Optional

import numpy
from numpy.typing import ArrayLike, NDArray

from ._errors import UsageError
from ._files import file_name
from ._materials import WHITE, Fields, Material, checked
from ._values import Color, Vector, color, direction_of, expect, items_of, length, number, rotation, scaling, size_in_pixels, translation, vector

if TYPE_CHECKING:
    from ._esdf import Writer

class Shape(ABC):
    """A node of a scene. It may be in several groups, or several times in one: each shows it."""

    def __init__(self, material: Optional[Material], name: Optional[str]) -> None:
        self.material = material
        self.name = name
        self.transforms: list[list[Any]] = []
        self.has_texcoords = False  #: which textures need

    def translate(self, offset: Vector) -> None:
        """Moves it, after what was done before."""
        self.transforms.append(translation(offset))

    def rotate(self, angle_degrees: float, axis: Vector) -> None:
        """Turns it about an axis through the origin, anticlockwise where that points at you."""
        self.transforms.append(rotation(angle_degrees, axis))

    def scale(self, factor: Color) -> None:
        """Scales it about the origin: by one factor, or by one along each axis. No factor may be 0."""
        self.transforms.append(scaling(factor))

    @property
    def material(self) -> Optional[Material]:
        """None: a model's own, or a group's, which has none."""
        return self._material

    @material.setter
    def material(self, material: Optional[Material]) -> None:
        self._material = self._accepted(material)

    def _accepted(self, material: Optional[Material]) -> Optional[Material]:
        """Raises TypeError for what is no material, UsageError for one that it cannot have."""
        return checked(material)

    @property
    @abstractmethod
    def kind(self) -> str:
        """As eSDF calls it."""

    @abstractmethod
    def words(self, writer: Writer) -> list[Any]:
        """Of eSDF, between the name and the material."""


class Sphere(Shape):
    """All within the radius about the centre."""

    def __init__(self, center: Vector, radius: float, material: Material = WHITE, *, name: Optional[str] = None) -> None:
        super().__init__(material, name)
        self._words = [*vector("center", center), length("radius", radius)]

    kind = "sphere"

    def words(self, writer: Writer) -> list[Any]:
        return self._words


class Box(Shape):
    """Between two opposite corners."""

    def __init__(self, p1: Vector, p2: Vector, material: Material = WHITE, *, name: Optional[str] = None) -> None:
        super().__init__(material, name)
        self._words = [*vector("p1", p1), *vector("p2", p2)]

    kind = "box"

    def words(self, writer: Writer) -> list[Any]:
        return self._words


class Cylinder(Shape):
    """Round about the way from p1 to p2, with flat ends there."""

    def __init__(
        self, p1: Vector, p2: Vector, radius: float, material: Material = WHITE, *, name: Optional[str] = None
    ) -> None:
        super().__init__(material, name)
        self._words = [*vector("p1", p1), *vector("p2", p2), length("radius", radius)]

    kind = "cylinder"

    def words(self, writer: Writer) -> list[Any]:
        return self._words


class Cone(Shape):
    """On a disc around the base, up to the tip."""

    def __init__(
        self, base: Vector, tip: Vector, radius: float, material: Material = WHITE, *, name: Optional[str] = None
    ) -> None:
        super().__init__(material, name)
        self._words = [*vector("base", base), *vector("tip", tip), length("radius", radius)]

    kind = "cone"

    def words(self, writer: Writer) -> list[Any]:
        return self._words


class Plane(Shape):
    """Without an end, through the point and at right angles to the normal."""

    def __init__(self, point: Vector, normal: Vector, material: Material = WHITE, *, name: Optional[str] = None) -> None:
        super().__init__(material, name)
        self._words = [*vector("point", point), *direction_of("normal", normal)]

    kind = "plane"

    def words(self, writer: Writer) -> list[Any]:
        return self._words


class Mesh(Shape):
    """Triangles: vertices (N, 3), faces (M, 3) of their numbers from 0, counter-clockwise seen from outside. With normals
    (N, 3), outward, it looks smooth. Texture coordinates (N, 2) are (0, 0) at the picture's lower left corner and (1, 1) at
    the upper right one, as OBJ and trimesh have them. Copied; each can be replaced, and is looked at again when the mesh is
    drawn or saved."""

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike,
        material: Material = WHITE,
        *,
        normals: Optional[ArrayLike] = None,
        texcoords: Optional[ArrayLike] = None,
        name: Optional[str] = None,
    ) -> None:
        super().__init__(material, name)
        self.vertices = vertices
        self.faces = faces
        self.normals = normals
        self.texcoords = texcoords
        self._check()

    @property
    def vertices(self) -> NDArray[numpy.float32]:
        """N x 3."""
        return self._vertices

    @vertices.setter
    def vertices(self, vertices: ArrayLike) -> None:
        self._vertices = _floats("vertices", vertices)

    @property
    def faces(self) -> NDArray[numpy.int64]:
        """M x 3."""
        return self._faces

    @faces.setter
    def faces(self, faces: ArrayLike) -> None:
        corners = _array("faces", faces)
        if not numpy.issubdtype(corners.dtype, numpy.integer):
            raise UsageError(f"faces: expected whole numbers, not {corners.dtype}")
        self._faces = corners.astype(numpy.int64)

    @property
    def normals(self) -> Optional[NDArray[numpy.float32]]:
        """N x 3; None: it is flat."""
        return self._normals

    @normals.setter
    def normals(self, normals: Optional[ArrayLike]) -> None:
        self._normals = None if normals is None else _floats("normals", normals)

    @property
    def texcoords(self) -> Optional[NDArray[numpy.float32]]:
        """N x 2, or None."""
        return self._texcoords

    @texcoords.setter
    def texcoords(self, texcoords: Optional[ArrayLike]) -> None:
        self._texcoords = None if texcoords is None else _floats("texcoords", texcoords)
        self.has_texcoords = texcoords is not None

    def _check(self) -> None:
        """Raises UsageError for arrays that do not belong together."""
        for what, array in (("vertices", self.vertices), ("faces", self.faces)):
            if array.ndim != 2 or array.shape[1] != 3 or len(array) == 0:
                raise UsageError(f"{what}: expected an array of N x 3, not of {_shape_of(array)}")
        count = len(self.vertices)
        if self.faces.min() < 0 or self.faces.max() >= count:
            raise UsageError(f"faces: a vertex is a number from 0 to {count - 1}")
        of_vertices = (("vertices", self.vertices, 3), ("normals", self.normals, 3), ("texcoords", self.texcoords, 2))
        for what, values, width in of_vertices:
            if values is None:
                continue
            if values.shape != (count, width):
                raise UsageError(f"{what}: expected an array of {count} x {width}, not of {_shape_of(values)}")
            if not numpy.isfinite(values).all():
                raise UsageError(f"{what}: expected finite numbers")

    @classmethod
    def from_trimesh(cls, mesh: Any, material: Material = WHITE, *, name: Optional[str] = None) -> Mesh:
        """Of a trimesh.Trimesh, or of anything with `vertices` and `faces`, with the texture coordinates of its `visual.uv`.
        Colours, normals and materials are left out."""
        texcoords = getattr(getattr(mesh, "visual", None), "uv", None)
        return cls(mesh.vertices, mesh.faces, material, texcoords=texcoords, name=name)

    kind = "mesh"

    def words(self, writer: Writer) -> list[Any]:
        self._check()
        return [writer.file_of(self)]


def _array(what: str, given: ArrayLike, dtype: Optional[str] = None) -> NDArray[Any]:
    """A copy."""
    try:
        return numpy.array(given, dtype=dtype)
    except ValueError as error:
        raise UsageError(f"{what}: expected an array of numbers: {error}") from None
    except TypeError:
        raise TypeError(f"{what}: expected an array of numbers, not {given!r}") from None


def _floats(what: str, given: ArrayLike) -> NDArray[numpy.float32]:
    """As files of meshes store numbers."""
    return _array(what, given, "<f4")


def _shape_of(array: NDArray[Any]) -> str:
    return " x ".join(map(str, array.shape))


class Model(Shape):
    """A .gltf, .glb, .obj, .ply or .stl file, with its own materials unless another is given."""

    def __init__(
        self, path: str | os.PathLike[str], material: Optional[Material] = None, *, name: Optional[str] = None
    ) -> None:
        super().__init__(material, name)
        self.path = os.path.abspath(file_name(path))
        self.has_texcoords = True  # for all we know

    def _accepted(self, material: Optional[Material]) -> Optional[Material]:
        return None if material is None else checked(material)

    kind = "mesh"

    def words(self, writer: Writer) -> list[Any]:
        return [writer.path_of(self.path)]


class Group(Shape):
    """Shapes, and groups of them, that move as one."""

    def __init__(self, children: Iterable[Shape] = (), *, name: Optional[str] = None) -> None:
        super().__init__(None, name)
        self.children: list[Shape] = []
        for child in items_of("children", children, "a list of shapes and groups"):
            self.add(child)

    def add(self, child: Shape) -> None:
        """A shape or a group; the same one may be in several groups."""
        expect("a group's child", child, Shape, "a shape or a group")
        self.children.append(child)

    def _accepted(self, material: Optional[Material]) -> None:
        if material is not None:
            raise UsageError("material: a group has none: set those of the shapes in it")

    kind = "composite"

    def words(self, writer: Writer) -> list[Any]:
        if not self.children:
            raise UsageError("a group has at least one shape")
        return [writer.name_of(child) for child in self.children]


@dataclass(frozen=True)
class Light:
    """A lamp: see `point`, `spot`, `directional`, `ambient`."""

    kind: str
    fields: Fields
    name: Optional[str] = None

    @classmethod
    def point(cls, position: Vector, brightness: Color = 1.0, *, radius: float = 0.0, name: Optional[str] = None) -> Light:
        """As bright at any distance. Only paths show a radius."""
        fields = {"position": [*vector("position", position)], "radius": [number("radius", radius, least=0)]}
        return cls("point", {**fields, "brightness": [*color("brightness", brightness)]}, name)

    @classmethod
    def ambient(cls, brightness: Color = 0.2, *, name: Optional[str] = None) -> Light:
        """Light that reaches every surface equally."""
        return cls("ambient", {"brightness": [*color("brightness", brightness)]}, name)

    @classmethod
    def directional(cls, direction: Vector, brightness: Color = 1.0, *, name: Optional[str] = None) -> Light:
        """From infinitely far away, in that direction, as the sun. eSDF does not have it."""
        return cls("directional", {"direction": [*direction_of("direction", direction)], "brightness": [*color("brightness", brightness)]}, name)

    @classmethod
    def spot(
        cls,
        position: Vector,
        direction: Vector,
        brightness: Color = 1.0,
        *,
        inner_degrees: float = 0.0,
        outer_degrees: float = 45.0,
        range: float = math.inf,
        name: Optional[str] = None,
    ) -> Light:
        """A cone: full brightness within the inner angle from its middle, none beyond the outer one, 0 <= inner < outer <=
        90. It falls off with the square of the distance (`brightness` is that at distance 1), and ends at `range`. eSDF
        does not have it."""
        inner, outer = number("inner_degrees", inner_degrees), number("outer_degrees", outer_degrees)
        if not 0 <= inner < outer <= 90:
            raise UsageError(f"inner_degrees, outer_degrees: expected 0 <= inner < outer <= 90, not {inner} and {outer}")
        fields = {
            "position": [*vector("position", position)],
            "direction": [*direction_of("direction", direction)],
            "brightness": [*color("brightness", brightness)],
            "inner": [inner],
            "outer": [outer],
            "range": [length("range", range, endless=True)],
        }
        return cls("spot", fields, name)

    def words(self, name: str) -> Optional[list[Any]]:
        """Of eSDF; None: it has no such lamp."""
        if self.kind == "ambient":
            return ["define", "light", "ambient", name, *self.fields["brightness"]]
        if self.kind != "point":
            return None
        radius = self.fields["radius"][0]
        size = [f"radius={radius!r}"] if radius else []
        return ["define", "light", "diffuse", name, *self.fields["position"], *self.fields["brightness"], *size]


@dataclass(frozen=True)
class Camera:
    """At `eye`, looks at `target` with `up` upwards; `fov_x_degrees` wide, between 0 and 180. `size`: of pictures for
    which no other is asked. `orthographic`: its rays are parallel, and it sees so much across, whatever the angle."""

    fov_x_degrees: float = 45.0
    eye: Vector = (0.0, 0.0, 0.0)
    target: Vector = (0.0, 0.0, -1.0)
    up: Vector = (0.0, 1.0, 0.0)
    size: tuple[int, int] = (640, 480)
    orthographic: Optional[float] = None

    def __post_init__(self) -> None:
        self.words("")
        self.transforms()

    def words(self, name: str) -> list[Any]:
        """Of eSDF."""
        keys = [] if self.orthographic is None else [f"orthographic={length('orthographic', self.orthographic)!r}"]
        sides = map(str, size_in_pixels("size", self.size))
        return ["define", "camera", name, number("fov_x_degrees", self.fov_x_degrees), *sides, *keys]

    def transforms(self) -> list[list[Any]]:
        """From the origin, where it looks along -z: it rolls, nods, turns, and goes to its place."""
        eye, target, up = (numpy.array(vector(name, getattr(self, name))) for name in ("eye", "target", "up"))
        x, y, z = target - eye
        across = math.hypot(x, z)
        if math.hypot(across, y) == 0:
            raise UsageError("target: a camera does not look at the place where it stands")
        yaw, pitch = math.atan2(-x, -z) if across else 0.0, math.atan2(y, across)
        right = numpy.array([math.cos(yaw), 0.0, -math.sin(yaw)])
        above = numpy.cross(right, (target - eye) / math.hypot(across, y))
        sideways, upwards = float(up @ right), float(up @ above)
        if math.hypot(sideways, upwards) < 1e-9 * math.hypot(*up) or not any(up):
            raise UsageError("up: a camera does not look along what is up")
        steps: list[list[Any]] = []
        for angle, axis in ((math.atan2(-sideways, upwards), (0, 0, 1)), (pitch, (1, 0, 0)), (yaw, (0, 1, 0))):
            if angle:
                steps.append(["rotate", math.degrees(angle), *axis])
        return steps + [["translate", *map(float, eye)]]
