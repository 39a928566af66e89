"""What can go wrong. Each class is for one thing that a caller may do something about."""

from __future__ import annotations

from typing import Any, Sequence

from ._native import Diagnostic


class Error(Exception):
    """Everything that lichtraum raises on purpose, and a fault in it."""

    def __init__(self, message: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(message)
        #: What was found, warnings included, each with `file`, `line`, `column`, `message`, `hint` and `severity`.
        self.diagnostics: tuple[Diagnostic, ...] = tuple(diagnostics)


class SceneError(Error):
    """A scene or a model is faulty: `diagnostics` say where, why and what to do."""


class UsageError(Error, ValueError):
    """What was asked for makes no sense, or cannot be had of this scene."""


class FileError(Error, OSError):
    """A file cannot be read or written. `errno`, `strerror` and `filename` are those of Python's own errors, where known."""

    @classmethod
    def of(cls, message: str, cause: OSError, path: str) -> FileError:
        """Of that file, for that reason."""
        error = (MissingFileError if isinstance(cause, FileNotFoundError) else FileError)(message)
        error.errno, error.strerror, error.filename = cause.errno, cause.strerror, path
        return error

    def __str__(self) -> str:
        return str(self.args[0])  # OSError would make another text of the three

    def __reduce__(self) -> tuple[Any, ...]:
        state = {"errno": self.errno, "strerror": self.strerror, "filename": self.filename}
        return type(self), self.args, self.__dict__ | state


class MissingFileError(FileError, FileNotFoundError):
    """There is no such file or folder."""


class DeviceError(Error):
    """There is no such device, or it cannot be used."""


class JobError(Error):
    """Machines cannot go on with a job. What they have drawn stays."""

    def __init__(self, message: str, status: int) -> None:
        super().__init__(message)
        #: That of the program: 75 where the same may succeed later, 65 where it never will.
        self.status = status

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.status), self.__dict__


class SceneWarning(UserWarning):
    """Something in a scene was repaired or left out, or a device cannot be used."""
