"""Draws a job on many machines, with Dask: `pip install 'lichtraum[dask]'`.

A job is a folder that `lichtraum job plan` has made, and that all machines see under the same path.

    import lichtraum.farm
    lichtraum.farm.run("shared", "tcp://head:8786", output="hello.png")

In a shell: `python -m lichtraum.farm shared --scheduler tcp://head:8786 -o hello.png`. See docs/FARM.md.
"""

from __future__ import annotations

import argparse
import asyncio
import math
import os
import sys
import time
import warnings
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Iterator, NoReturn, Optional, Sequence, Union

from ._batch_worker import TRY_AGAIN, end_children
from ._crew import Crew
from ._errors import JobError, UsageError
from ._files import file_name
from ._job_folder import JobFolder
from ._progress import Bar, Show

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["Summary", "run"]

_USAGE, _UNAVAILABLE = 64, 69
_MOST_MERGES = 3
#: Of workers that only wait for a process: looked at a hundred times a second they take 3 % of a core.
_LOCAL_SETTINGS = {"distributed.worker.profile.enabled": False, "distributed.admin.tick.interval": "1s"}


@dataclass(frozen=True)
class Summary:
    """What a run did.

    >>> print(Summary(units=12, drawn=9, tasks=3, failed=1, seconds=21.5))
    9 of 12 units drawn by 3 tasks in 21.5 s, 3 there already, 1 task failed and was done again
    """

    units: int  #: of the plan
    drawn: int  #: by this run
    tasks: int  #: batches of units that were given to workers
    failed: int  #: tasks whose worker or child process died, or could not go on
    seconds: float

    def __str__(self) -> str:
        text = f"{self.drawn} of {self.units} units drawn by {self.tasks} tasks in {self.seconds:.1f} s"
        if self.drawn < self.units:
            text += f", {self.units - self.drawn} there already"
        if self.failed:
            text += f", {self.failed} task{' failed and was' if self.failed == 1 else 's failed and were'} done again"
        return text


def run(
    folder: Union[str, os.PathLike[str]],
    scheduler: Union[None, str, Client] = None,
    *,
    workers: int = 1,
    output: Union[None, str, os.PathLike[str]] = None,
    device: Optional[str] = None,
    allow_mixed: bool = False,
    progress: Union[None, bool, Show] = None,
    batch_seconds: float = 10.0,
    timeout: float = 30.0,
) -> Summary:
    """Has Dask's workers draw what is missing of the job in `folder`, and waits for it.

    `scheduler` is the address of a Dask scheduler, or a `distributed.Client`; without, `workers` threads are begun on this
    machine, each with a process for its batch. With `output` the pictures are then put together; units that turn out to be
    damaged are drawn again before. "-" is standard output. A task takes about `batch_seconds`. `timeout` is how many seconds to wait for the scheduler
    and for its first worker.

    Raises a `JobError` where the job cannot go on, or workers die again and again and no unit gets done. What is drawn stays.
    Raises a `UsageError` for values that make no sense.
    """
    begin = time.monotonic()
    _check(workers=workers, batch_seconds=batch_seconds, timeout=timeout)
    picture = None if output is None else file_name(output)
    if picture == "":
        raise UsageError("output: expected the name of a file, not ''")
    job = JobFolder(os.fspath(folder))
    mixed = ["--allow-mixed"] if allow_mixed else []
    if picture is not None and job.merge(picture, mixed) is None:  # also to hear whether it can be written
        return Summary(job.units, 0, 0, 0, time.monotonic() - begin)
    work = job.work([*mixed, *([f"--device={device}"] if device is not None else [])])
    with _connected(scheduler, workers, timeout, job) as client, Bar(progress) as bar:
        _wait_for_worker(client, timeout)
        crew = Crew(client, job, work, batch_seconds, bar.show)
        drawn = crew.draw_missing()
        if picture is not None:
            for attempt in range(_MOST_MERGES):
                missing = job.merge(picture, mixed)
                if missing is None:
                    break
                if attempt == _MOST_MERGES - 1:
                    raise JobError(missing, TRY_AGAIN)
                drawn += crew.draw_damaged()
    return Summary(job.units, drawn, crew.tasks, crew.failed, time.monotonic() - begin)


def _check(workers: int, **seconds: float) -> None:
    """Raises UsageError."""
    if isinstance(workers, bool) or not hasattr(workers, "__index__") or workers < 1:
        raise UsageError(f"workers: expected a whole number that is at least 1, not {workers!r}")
    for name, value in seconds.items():
        if isinstance(value, bool) or not hasattr(value, "__float__") or not 0 < value < math.inf:
            raise UsageError(f"{name}: expected a number of seconds above 0, not {value!r}")


@contextmanager
def _connected(
    scheduler: Union[None, str, Client], workers: int, timeout: float, job: JobFolder
) -> Iterator[Client]:
    try:
        import dask
        from distributed import Client, LocalCluster
    except ImportError as error:
        raise JobError("Dask is not installed: pip install 'lichtraum[dask]'", _UNAVAILABLE) from error
    if isinstance(scheduler, Client):
        yield scheduler
    elif scheduler is not None:
        from distributed.comm.addressing import get_address_host_port

        try:
            get_address_host_port(scheduler, strict=True)  # a client that was refused for this would hang when it is closed
        except ValueError as error:
            raise JobError(f"'{scheduler}' is no address of a scheduler, such as tcp://head:8786: {error}", _USAGE) from error
        try:
            client = Client(scheduler, timeout=timeout, set_as_default=False)
        except (OSError, asyncio.TimeoutError) as error:
            message = f"no Dask scheduler answers at '{scheduler}' within {timeout:g} s: {error}"
            raise JobError(message, TRY_AGAIN) from error
        with client:
            yield client
    else:
        # Threads, as batches have processes of their own.
        with dask.config.set(_LOCAL_SETTINGS):
            cluster = LocalCluster(
                n_workers=workers, threads_per_worker=1, processes=False, memory_limit=None, dashboard_address="127.0.0.1:0"
            )
        with cluster, Client(cluster, set_as_default=False) as client:
            try:
                yield client
            finally:
                end_children(job.path)  # or the cluster would wait for them


def _wait_for_worker(client: Client, timeout: float) -> None:
    try:
        client.wait_for_workers(1, timeout=timeout)
    except (TimeoutError, asyncio.TimeoutError) as error:
        message = f"the scheduler has no workers: 'dask worker {client.scheduler.address} --nthreads 1' begins one"
        raise JobError(message, TRY_AGAIN) from error
    if any(threads > 1 for threads in client.nthreads().values()):
        text = "Dask gives a worker as many tasks at once as it has threads, and each task uses all cores: --nthreads 1 is better"
        warnings.warn(text, stacklevel=3)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.print_usage(sys.stderr)
        self.exit(_USAGE, f"error: {message}\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="python -m lichtraum.farm",
        description="Draws what is missing of the job in the folder DIR, on the workers of a Dask scheduler. "
        "All machines need the same lichtraum[dask], and the folder under the same path. "
        "Ends with status 75 where the same command may succeed later, with 65 where it never will.",
    )
    parser.add_argument("folder", metavar="DIR", help="what 'lichtraum job plan' has made")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler, such as tcp://head:8786 "
                        "(default: begin workers on this machine)")
    parser.add_argument("--workers", type=int, default=1, metavar="N", help="so many without --scheduler; each uses all "
                        "cores (default: 1)")
    parser.add_argument("-o", "--output", metavar="FILE", help="then put the pictures together, as 'lichtraum job merge' does")
    parser.add_argument("--device", metavar="NAME", help="index, part of a name, cpu, gpu or reference (default: of the plan's kind)")
    parser.add_argument("--allow-mixed", action="store_true", help="take what devices of other classes draw: edges may show")
    parser.add_argument("--batch-seconds", type=float, default=10.0, metavar="S", help="what a task shall take (default: 10)")
    parser.add_argument("--timeout", type=float, default=30.0, metavar="S", help="wait so long for the scheduler and its "
                        "first worker (default: 30)")
    parser.add_argument("-q", "--quiet", action="store_true", help="print errors only")
    return parser


def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        summary = run(
            options.folder,
            options.scheduler,
            workers=options.workers,
            output=options.output,
            device=options.device,
            allow_mixed=options.allow_mixed,
            progress=False if options.quiet else None,
            batch_seconds=options.batch_seconds,
            timeout=options.timeout,
        )
    except UsageError as error:
        parser.error(str(error))
    except JobError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.status
    except KeyboardInterrupt:
        print("interrupted: what is drawn stays", file=sys.stderr)
        return 130
    if not options.quiet:
        print(f"{options.folder}: {summary}", file=sys.stderr)  # the picture may be on standard output
    return 0


if __name__ == "__main__":
    sys.exit(main())
