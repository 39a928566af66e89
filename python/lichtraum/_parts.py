"""What scenes hold, with all that is in their groups."""

from __future__ import annotations

from typing import Iterable, Union

from ._errors import UsageError
from ._nodes import Group, Light, Shape

Item = Union[Shape, Light]


def parts_of(items: Iterable[Item]) -> list[Item]:
    """These in their order, each group after its children, and each shape once. A loop, as Python's recursion ends long
    before groups get too deep for the library. Raises UsageError for a group that holds itself."""
    parts: list[Item] = []
    begun: set[int] = set()
    ended: set[int] = set()
    waiting = [*items][::-1]
    while waiting:
        item = waiting[-1]
        if id(item) in ended:
            waiting.pop()
        elif isinstance(item, Group) and id(item) not in begun:
            begun.add(id(item))
            for child in reversed(item.children):
                if id(child) in begun and id(child) not in ended:
                    raise UsageError("a group cannot hold itself")
                waiting.append(child)
        else:
            parts.append(waiting.pop())
            if isinstance(item, Shape):
                ended.add(id(item))
    return parts
