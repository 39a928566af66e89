"""Processes that were forked, in which OpenCL does not work."""

from __future__ import annotations

import os
from typing import Optional

from ._errors import DeviceError


class OpenClUse:
    """Which process has used OpenCL. A fork copies that, but not the threads, for which a call would wait for ever."""

    def __init__(self) -> None:
        self._process: Optional[int] = None

    def begin(self) -> None:
        self._process = os.getpid()

    def check(self) -> None:
        """Raises DeviceError."""
        if self._process not in (None, os.getpid()):
            raise DeviceError(
                "this process was forked from one that had drawn with OpenCL, which does not work in it: begin processes with "
                'multiprocessing.get_context("spawn"), or draw only after the fork'
            )


#: OpenCL is one for the whole process, so this is as well.
OPENCL = OpenClUse()
