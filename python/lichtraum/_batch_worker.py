"""What a Dask worker does: it has a child process draw some units of a plan."""

from __future__ import annotations

import hashlib
import os
import socket
import subprocess
import sys
import time
from typing import NamedTuple

from .__main__ import PROGRAM
from ._native import version

#: Statuses of the program that no second try changes: mistakes of usage or scene, and what is not there.
NEVER = (64, 65, 66, 69, 73)
TRY_AGAIN = 75
#: A machine whose children die at once must not take all tasks before others can.
_PAUSE_SECONDS = 2.0

# A worker that is killed takes its child along, where the system can do that (Linux's PR_SET_PDEATHSIG).
_CHILD = """
import ctypes, os, sys
if sys.platform == "linux":
    ctypes.CDLL(None).prctl(1, 9)
os.execv(sys.argv[1], sys.argv[1:])
"""


#: Those of this process that draw, and in which folder.
_children: dict[subprocess.Popen[bytes], str] = {}


class Work(NamedTuple):
    """What is the same for all tasks of a job."""

    folder: str
    plan_hash: str
    version: str
    options: tuple[str, ...]


class Outcome(NamedTuple):
    """How a child ended: its status, negative for a signal, and what it said."""

    status: int
    message: str
    seconds: float


def message_of(stderr: str) -> str:
    """What the program said last, without its name.

    >>> message_of("lichtraum: error: shared: it has no plan.json\\n")
    'shared: it has no plan.json'
    """
    return stderr[-2000:].strip().removeprefix("lichtraum: ").removeprefix("error: ")


def plan_hash(folder: str) -> str:
    with open(os.path.join(folder, "plan.json"), "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def _obstacle(work: Work) -> tuple[int, str]:
    """Why this machine cannot take part, and the status for that; 0 where it can."""
    if version != work.version:
        return 65, f"it has lichtraum {version}, and the job was begun by {work.version}: install the same everywhere"
    try:
        is_same = plan_hash(work.folder) == work.plan_hash
    except OSError as error:  # a share may be gone for a while, and others have it
        return TRY_AGAIN, f"it cannot read the plan ({error}): all machines need the folder under the same path"
    return (0, "") if is_same else (65, f"{work.folder} has another plan there: all machines need the same folder")


def draw_batch(work: Work, first: int, last: int) -> Outcome:
    """Has units `first` to `last` drawn, both included; those that are there already are skipped."""
    begin = time.monotonic()
    status, text = _obstacle(work)
    was_ended = False
    if status == 0:
        status, text, was_ended = _draw(work, first, last)
        if status in NEVER and _obstacle(work)[0] == TRY_AGAIN:  # the plan is gone meanwhile
            status = TRY_AGAIN
    if status != 0 and status not in NEVER and not was_ended:
        time.sleep(_PAUSE_SECONDS)
    return Outcome(status, f"worker on {socket.gethostname()}: {text}", time.monotonic() - begin)


def _draw(work: Work, first: int, last: int) -> tuple[int, str, bool]:
    """The child's status, what it said, and whether `end_children` ended it."""
    program = [PROGRAM, "job", "work", work.folder, f"--units={first}..{last}", "--quiet", *work.options]
    child = subprocess.Popen(
        [sys.executable, "-I", "-S", "-c", _CHILD, *program],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    _children[child] = work.folder
    stderr = child.communicate()[1]
    was_ended = _children.pop(child, None) is None
    text = message_of(stderr.decode(errors="replace"))
    if child.returncode < 0:
        text = f"'lichtraum job work' was ended by signal {-child.returncode} in units {first}..{last}. {text}".strip()
    return child.returncode, text, was_ended


def end_children(folder: str) -> None:
    """Of the workers in this process."""
    for child in [child for child, other in _children.copy().items() if other == folder]:
        if _children.pop(child, None) is not None:
            child.kill()
