"""Numbers, vectors and colours that callers give."""

from __future__ import annotations

import math
import operator
from typing import Any, Sequence, Union

from numpy.typing import NDArray

from ._errors import UsageError

Vector = Union[Sequence[float], NDArray[Any]]
Color = Union[float, Vector]
#: Of an eSDF statement: texts and numbers.
Words = list[Any]


def text_of(words: Words) -> str:
    return " ".join(word if isinstance(word, str) else repr(float(word)) for word in words)


def expect(what: str, value: Any, kind: type | tuple[type, ...], wanted: str) -> None:
    """Raises TypeError for another kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{what}: expected {wanted}, not {value!r}")


def whole(what: str, value: Any) -> int:
    """Raises TypeError for what is no whole number, Python's or NumPy's."""
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{what}: expected a whole number, not {value!r}") from None


def is_word(name: str) -> bool:
    """Whether eSDF can name something, or a file, so."""
    return bool(name) and not any(letter.isspace() or letter == "#" for letter in name)


def number(value: Any, *, least: float = -math.inf, most: float = math.inf) -> float:
    """Raises TypeError for what is no number, UsageError for what is not finite, or not in that range."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        result = float(value)
    except TypeError:
        raise TypeError(f"expected a number, not {value!r}") from None
    except OverflowError:
        result = math.inf
    if not math.isfinite(result):
        raise UsageError(f"expected a finite number, not {result}")
    if not least <= result <= most:
        what = f"from {least:g} to {most:g}" if most < math.inf else f"that is at least {least:g}"
        raise UsageError(f"expected a number {what}, not {result}")
    return result


def length(value: float, what: str = "radius") -> float:
    """Raises UsageError for what is not above 0."""
    result = number(value)
    if result <= 0:
        raise UsageError(f"expected a {what} above 0, not {result}")
    return result


def vector(value: Vector, *, least: float = -math.inf) -> tuple[float, float, float]:
    """Raises TypeError for what is no sequence of numbers, UsageError for what is not three finite ones."""
    if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__") or _is_single(value):
        raise TypeError(f"expected three numbers, not {value!r}")
    numbers = [number(each, least=least) for each in value]
    if len(numbers) != 3:
        raise UsageError(f"expected three numbers, not {len(numbers)}")
    return numbers[0], numbers[1], numbers[2]


def _is_single(value: Any) -> bool:
    """Whether it is one number: Python's, or NumPy's, whose arrays have `__float__` as well."""
    return hasattr(value, "__float__") and not getattr(value, "ndim", 0)


def color(value: Color, *, least: float = -math.inf) -> tuple[float, float, float]:
    """Three numbers, or one for all."""
    given: Any = value
    if isinstance(given, (str, bytes)):
        raise TypeError(f"expected a number or three for a colour, not {given!r}")
    return vector([given] * 3 if _is_single(given) else given, least=least)


def unchanging(value: Color) -> Color:
    """The same, in numbers that nobody can change and that have a hash."""
    return number(value) if _is_single(value) else color(value)


def translation(offset: Vector) -> list[Any]:
    return ["translate", *vector(offset)]


def rotation(angle_degrees: float, axis: Vector) -> list[Any]:
    if not any(vector(axis)):
        raise UsageError("the axis must not be zero")
    return ["rotate", number(angle_degrees), *vector(axis)]


def scaling(factor: Color) -> list[Any]:
    if not all(color(factor)):
        raise UsageError("scale factors must not be 0")
    return ["scale", *color(factor)]
