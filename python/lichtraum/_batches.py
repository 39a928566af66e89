"""How the units that a job lacks become tasks."""

from __future__ import annotations

import math
from collections import deque
from typing import Iterable, NamedTuple, Optional

#: The scheduler holds all tasks in memory, and each costs it about a millisecond.
MOST_TASKS = 20_000
#: So many units that are there already may lie in a batch: who draws it looks at each.
_MOST_SKIPPED = 100


def least_size(missing: int) -> int:
    """How many units each batch has at least, so that there are not too many tasks."""
    return math.ceil(missing / MOST_TASKS)


class Batch(NamedTuple):
    """Units `first` to `last`, both included, of which `missing` are not there yet."""

    first: int
    last: int
    missing: int


class MissingUnits:
    """Gives out what is missing, from the front.

    >>> units = MissingUnits([(0, 2), (4, 4), (1000, 1004)])
    >>> units.take(4), units.take(4), units.take(4), units.take(4)
    (Batch(first=0, last=4, missing=4), Batch(first=1000, last=1003, missing=4), Batch(first=1004, last=1004, missing=1), None)
    """

    def __init__(self, ranges: Iterable[tuple[int, int]]) -> None:
        self._ranges = deque((first, last) for first, last in ranges)
        self.count = sum(last - first + 1 for first, last in self._ranges)

    def take(self, most: int) -> Optional[Batch]:
        if not self._ranges:
            return None
        begin = end = self._ranges[0][0]
        taken = 0
        while self._ranges and taken < most and self._ranges[0][0] - end <= _MOST_SKIPPED:
            first, last = self._ranges.popleft()
            end = min(last, first + most - taken - 1)
            taken += end - first + 1
            if end < last:
                self._ranges.appendleft((end + 1, last))
        self.count -= taken
        return Batch(begin, end, taken)


class Pace:
    """How many units make a batch of `seconds`: tried with few units first, then with more.

    >>> pace = Pace(10)
    >>> pace.learn(1, 0.5)
    >>> pace.size, pace.is_known
    (8, False)
    >>> pace.learn(8, 2.5)
    >>> pace.size, pace.is_known
    (32, False)
    >>> pace.learn(32, 8)
    >>> pace.size, pace.is_known
    (40, True)

    Towards the end batches get smaller, so that several workers end together:

    >>> pace.batch_size(missing=1000, workers=5), pace.batch_size(missing=100, workers=5), pace.batch_size(missing=100, workers=1)
    (40, 5, 40)
    """

    def __init__(self, seconds: float, size: int = 1, is_known: bool = False) -> None:
        self._seconds = seconds
        self.size = size
        self.is_known = is_known

    def learn(self, units: int, seconds: float) -> None:
        """What a batch took, with the start of its process: the more units, the less that counts."""
        if self.is_known or units < self.size:
            return
        fitting = math.ceil(units * self._seconds / max(seconds, 1e-3))
        self.is_known = seconds >= self._seconds / 2
        self.size = fitting if self.is_known else min(fitting, 8 * self.size)

    def batch_size(self, missing: int, workers: int, least: int = 1) -> int:
        share = math.ceil(missing / (4 * workers)) if workers > 1 else missing
        return max(1, least, min(self.size, share))
