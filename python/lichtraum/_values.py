"""Numbers, vectors and colours that callers give."""

from __future__ import annotations

import math
import operator
from typing import Any, Iterable, Iterator, Sequence, TypeVar, Union

from numpy.typing import NDArray

from ._errors import UsageError

Vector = Union[Sequence[float], NDArray[Any]]
Color = Union[float, Vector]
Item = TypeVar("Item")
#: Of an eSDF statement: texts and numbers.
Words = list[Any]


def text_of(words: Words) -> str:
    return " ".join(word if isinstance(word, str) else repr(float(word)) for word in words)


def expect(what: str, value: Any, kind: type | tuple[type, ...], wanted: str) -> None:
    """Raises TypeError for another kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{what}: expected {wanted}, not {value!r}")


def named(name: Any) -> str:
    """Raises TypeError for what is no text."""
    expect("name", name, str, "a text")
    return name  # type: ignore[no-any-return]


def items_of(what: str, values: Iterable[Item], wanted: str) -> Iterator[Item]:
    """Raises TypeError for what has no items."""
    try:
        return iter(values)
    except TypeError:
        raise TypeError(f"{what}: expected {wanted}, not {values!r}") from None


def whole(what: str, value: Any) -> int:
    """Raises TypeError for what is no whole number, Python's or NumPy's, UsageError for what has more than 32 bits."""
    try:
        result = operator.index(value)
    except TypeError:
        raise TypeError(f"{what}: expected a whole number, not {value!r}") from None
    if not -(2**31) <= result < 2**31:
        raise UsageError(f"{what}: expected a whole number below {2**31}, not {result}")
    return result


def size_in_pixels(what: str, value: Sequence[int]) -> tuple[int, int]:
    """Raises TypeError for what is no sequence of whole numbers, UsageError for what is not two that a picture can have."""
    if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__"):
        raise TypeError(f"{what}: expected width and height in pixels, not {value!r}")
    sides = [whole(what, side) for side in value]
    if len(sides) != 2 or not all(side > 0 for side in sides):
        raise UsageError(f"{what}: expected width and height in pixels, at least 1 x 1, not {' x '.join(map(str, sides))}")
    return sides[0], sides[1]


def is_word(name: str) -> bool:
    """Whether eSDF can name something, or a file, so."""
    return bool(name) and not any(letter.isspace() or letter == "#" for letter in name)


def number(
    what: str, value: Any, *, least: float = -math.inf, most: float = math.inf, endless: bool = False
) -> float:
    """Raises TypeError for what is no number, UsageError for what is not finite (`endless`: it may be math.inf), or not in
    that range."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        result = float(value)
    except TypeError:
        raise TypeError(f"{what}: expected a number, not {value!r}") from None
    except OverflowError:
        result = math.inf
    if not math.isfinite(result) and not (endless and result > 0):
        raise UsageError(f"{what}: expected a finite number, not {result}")
    if not least <= result <= most:
        which = f"from {least:g} to {most:g}" if most < math.inf else f"that is at least {least:g}"
        raise UsageError(f"{what}: expected a number {which}, not {result}")
    return result


def length(what: str, value: float, *, endless: bool = False) -> float:
    """Raises UsageError for what is not above 0."""
    result = number(what, value, endless=endless)
    if result <= 0:
        raise UsageError(f"{what}: expected a number above 0, not {result}")
    return result


def vector(what: str, value: Vector, *, least: float = -math.inf) -> tuple[float, float, float]:
    """Raises TypeError for what is no sequence of numbers, UsageError for what is not three finite ones."""
    if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__") or _is_single(value):
        raise TypeError(f"{what}: expected three numbers, not {value!r}")
    numbers = [number(what, each, least=least) for each in value]
    if len(numbers) != 3:
        raise UsageError(f"{what}: expected three numbers, not {len(numbers)}")
    return numbers[0], numbers[1], numbers[2]


def direction_of(what: str, value: Vector) -> tuple[float, float, float]:
    """As `vector`; raises UsageError for what points nowhere."""
    result = vector(what, value)
    if not any(result):
        raise UsageError(f"{what}: expected a direction, not zero")
    return result


def _is_single(value: Any) -> bool:
    """Whether it is one number: Python's, or NumPy's, whose arrays have `__float__` as well."""
    return hasattr(value, "__float__") and not getattr(value, "ndim", 0)


def color(what: str, value: Color, *, least: float = -math.inf) -> tuple[float, float, float]:
    """Three numbers, or one for all."""
    given: Any = value
    if isinstance(given, (str, bytes)) or not (_is_single(given) or hasattr(given, "__iter__")):
        raise TypeError(f"{what}: expected a number or three for a colour, not {given!r}")
    return vector(what, [given] * 3 if _is_single(given) else given, least=least)


def unchanging(what: str, value: Color) -> Color:
    """The same, in numbers that nobody can change and that have a hash."""
    return number(what, value) if _is_single(value) else color(what, value)


def translation(offset: Vector) -> list[Any]:
    return ["translate", *vector("offset", offset)]


def rotation(angle_degrees: float, axis: Vector) -> list[Any]:
    return ["rotate", number("angle_degrees", angle_degrees), *direction_of("axis", axis)]


def scaling(factor: Color) -> list[Any]:
    factors = color("factor", factor)
    if not all(factors):
        raise UsageError("factor: a scale factor must not be 0")
    return ["scale", *factors]
