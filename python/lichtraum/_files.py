"""Files that are written."""

from __future__ import annotations

import os
import uuid
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator


@contextmanager
def replacement(target: Path) -> Iterator[Path]:
    """The name of a file to write beside `target`, which it then replaces: whole, or not at all if something is raised.
    Nobody else has that name."""
    temporary = target.with_name(f"{target.name}.{uuid.uuid4().hex[:12]}.partial")
    try:
        yield temporary
        os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
