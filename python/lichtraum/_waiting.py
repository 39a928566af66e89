"""Work that takes long, beside the thread that asked for it."""

from __future__ import annotations

import threading
from typing import Callable, Generic, Optional, TypeVar

from . import _native

Result = TypeVar("Result")


class _Work(Generic[Result]):
    def __init__(self, work: Callable[[_native.Control], Result]) -> None:
        self._work = work
        self._result: Optional[Result] = None
        self._failure: Optional[BaseException] = None
        self.control = _native.Control()
        self.ended = threading.Event()

    def run(self) -> None:
        try:
            self._result = self._work(self.control)
        except BaseException as failure:
            self._failure = failure
        finally:
            self.ended.set()

    def result(self) -> Result:
        if self._failure is not None:
            raise self._failure
        return self._result  # type: ignore[return-value]


def wait_for(work: Callable[[_native.Control], Result], show: Optional[Callable[[float], object]] = None) -> Result:
    """What `work` returns or raises, which runs in a thread of its own: nothing but this would let a signal (Ctrl-C) be
    answered while a file is read. `show` is called with a fraction from 0 to 1, with 1 once all is done.

    When a signal comes or `show` raises, that is raised at once. The work is told to stop, does so when it can, and
    nobody hears of it any more; whoever uses the same renderer waits for it, and so does Python's end.
    """
    task = _Work(work)
    thread = threading.Thread(target=task.run, name="lichtraum")
    thread.start()
    shown = 0.0
    try:
        while not task.ended.wait(0.05):
            fraction = task.control.fraction
            if show is not None and fraction > shown:
                shown = fraction
                show(fraction)
    except BaseException:
        task.control.stop()
        raise
    thread.join()
    result = task.result()
    if show is not None and shown < 1:
        show(1.0)
    return result
