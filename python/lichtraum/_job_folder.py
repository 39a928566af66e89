"""A folder that `lichtraum job plan` has made, by way of the program."""

from __future__ import annotations

import json
import os
import subprocess
from typing import Any, NamedTuple, Optional, Sequence

from .__main__ import PROGRAM
from ._batch_worker import TRY_AGAIN, Work, message_of, plan_hash
from ._errors import JobError
from ._native import version


class Status(NamedTuple):
    done: int
    missing: list[tuple[int, int]]  #: ranges, both ends included; only the first thousand


class JobFolder:
    def __init__(self, path: str) -> None:
        self.path = os.path.abspath(path)
        self.units = int(self._status()["units"])
        self._hash = plan_hash(self.path)

    @property
    def name(self) -> str:
        return os.path.basename(self.path)

    def status(self) -> Status:
        """By names and sizes of files: `merge` looks into them."""
        now = self._status()
        return Status(now["done"], [(first, last) for first, last in now["missing"]])

    def work(self, options: Sequence[str]) -> Work:
        return Work(self.path, self._hash, version, tuple(options))

    def merge(self, output: str, options: Sequence[str]) -> Optional[str]:
        """What is missing, or None if nothing was: then the pictures are written. Raises JobError for what drawing units does
        not mend; an output that cannot be written is found before units are looked for."""
        merged = self._run("merge", f"--output={output}", "--quiet", *options, stdout=None)  # "-" is that
        if merged.returncode not in (0, TRY_AGAIN):
            raise JobError(message_of(merged.stderr), merged.returncode)
        return message_of(merged.stderr) if merged.returncode else None

    def _status(self) -> dict[str, Any]:
        told = self._run("status", "--json")
        if told.returncode != 0:
            raise JobError(message_of(told.stderr), told.returncode)
        status: dict[str, Any] = json.loads(told.stdout)
        return status

    def _run(
        self, command: str, *options: str, stdout: Optional[int] = subprocess.PIPE
    ) -> subprocess.CompletedProcess[str]:
        line = [PROGRAM, "job", command, self.path, *options]
        return subprocess.run(
            line, stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE, text=True, errors="replace"
        )
