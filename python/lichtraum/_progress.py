"""A bar that shows how far a picture is: in a terminal, or in a notebook where ipywidgets is installed."""

from __future__ import annotations

import sys
from typing import Any, Callable, Optional

from ._values import expect

Show = Callable[[float], Any]


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and type(shell).__name__ == "ZMQInteractiveShell"


class Bar:
    """Shows nothing until it is told something, and nothing where nobody looks."""

    def __init__(self, progress: Optional[bool | Show]) -> None:
        self._show: Optional[Show] = None
        self._close: Callable[[], Any] = lambda: None
        if not callable(progress):
            expect("progress", progress, (bool, type(None)), "True, False or a function")
        if callable(progress):
            self._show = progress
        elif progress is None or progress:
            if _in_notebook():
                self._begin_in_notebook()
            elif sys.stderr is not None and sys.stderr.isatty():
                self._show, self._close = self._write, self._wipe

    @property
    def show(self) -> Optional[Show]:
        return self._show

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        self._close()

    def _begin_in_notebook(self) -> None:
        try:
            import ipywidgets
            from IPython.display import display
        except ImportError:
            return
        bar = ipywidgets.FloatProgress(min=0, max=1)

        def show(fraction: float) -> None:
            if not bar.value and fraction < 1:  # else it is over before anybody looks
                display(bar)
            bar.value = fraction

        self._show, self._close = show, bar.close

    def _write(self, fraction: float) -> None:
        width = 40
        done = round(width * fraction)
        print(f"\r[{'#' * done}{' ' * (width - done)}] {100 * fraction:3.0f} %", end="", file=sys.stderr, flush=True)

    def _wipe(self) -> None:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
