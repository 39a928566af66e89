"""Files: their names, and how they are written."""

from __future__ import annotations

import os
import uuid
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, Union

from ._errors import FileError, UsageError


def file_name(path: Union[str, os.PathLike[str]]) -> str:
    """As the library takes it. Raises UsageError for what it would cut off or not understand."""
    name = os.fspath(path)
    if "\0" in name:
        raise UsageError(f"{name!r}: no file has a name with a NUL character")
    try:
        name.encode()
    except UnicodeEncodeError:
        raise UsageError(f"{name!r}: expected a name in UTF-8: rename the file") from None
    return name


@contextmanager
def reading(*paths: str) -> Iterator[None]:
    """Tells of a FileError what the library does not, if one of these files, the first of them, is the reason."""
    try:
        yield
    except FileError as error:
        for path in paths:
            _explain(error, path, path)
        raise


@contextmanager
def writing(path: str) -> Iterator[None]:
    """As `reading`, if its folder is the reason."""
    try:
        yield
    except FileError as error:
        _explain(error, path, os.path.join(os.path.dirname(path), "."))
        raise


def _explain(error: FileError, path: str, reason: str) -> None:
    try:
        os.stat(reason)
    except OSError as cause:
        raise FileError.of(str(error), cause, path) from None


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
