"""Files: their names, and how they are written."""

from __future__ import annotations

import os
import uuid
from contextlib import contextmanager
from pathlib import Path
from typing import Iterator, Union

from . import _native
from ._errors import FileError, UsageError


def file_name(path: Union[str, bytes, os.PathLike[str]]) -> str:
    """As the library takes it. Raises UsageError for what it would cut off or not understand."""
    name = _as_text(path)
    try:
        name.encode()
    except UnicodeEncodeError:
        raise UsageError(f"{name!r}: expected a name in UTF-8: rename the file") from None
    return name


def _as_text(path: Union[str, bytes, os.PathLike[str]]) -> str:
    try:
        name = os.fsdecode(path)
    except TypeError:
        raise TypeError(f"expected the name of a file, not {path!r}") from None
    if "\0" in name:
        raise UsageError(f"{name!r}: no file has a name with a NUL character")
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


def scene_file(path: Union[str, os.PathLike[str]]) -> Path:
    """To write a scene to. Raises UsageError where that would take a picture's place."""
    name = _as_text(path)
    if _native.names_picture(os.fsencode(name)):
        raise UsageError(f"{name!r} is named as a picture: scenes are saved as .sdf, pictures with Image.save")
    return Path(name)


def write_file(target: Path, content: bytes) -> None:
    """As pictures are written: whole or not at all, where a link leads to, and with the permissions of the old file."""
    name = _as_text(target)
    with writing(name):
        _native.write_file(os.fsencode(name), content)


@contextmanager
def draft(target: Path) -> Iterator[Path]:
    """The name of a file beside `target`, which nobody else has, and which is removed at the end."""
    temporary = target.with_name(f"{target.name}.{uuid.uuid4().hex[:12]}.partial")
    try:
        yield temporary
    finally:
        temporary.unlink(missing_ok=True)
