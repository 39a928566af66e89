"""The workers of a Dask scheduler, and what they do for a job."""

from __future__ import annotations

import uuid
from typing import TYPE_CHECKING, Optional, Sequence

from ._batch_worker import NEVER, TRY_AGAIN, Outcome, Work, draw_batch
from ._batches import Batch, MissingUnits, Pace, least_size
from ._errors import JobError
from ._job_folder import JobFolder
from ._progress import Show

if TYPE_CHECKING:
    from distributed import Client, Future, as_completed

#: So often may all tasks end without any new unit before the job is given up.
_MOST_FRUITLESS = 3


def _scheduler_is_gone() -> JobError:
    return JobError("the scheduler is gone, or has cancelled the job. What is drawn stays: run it again", TRY_AGAIN)


class Crew:
    def __init__(self, client: Client, job: JobFolder, work: Work, batch_seconds: float, show: Optional[Show]) -> None:
        self.tasks = 0
        self.failed = 0
        self._client = client
        self._job = job
        self._work = work
        self._pace = Pace(batch_seconds)
        self._show = show
        self._batches: dict[Future, Batch] = {}
        self._run = uuid.uuid4().hex[:6]
        self._complaint = ""

    def draw_missing(self) -> int:
        """Goes on until nothing is missing. The number of units that were."""
        first = status = self._job.status()
        fruitless = 0
        while status.missing:
            before = status.done
            self._draw(status.missing)
            status = self._job.status()
            fruitless = 0 if status.done > before else fruitless + 1
            if fruitless == _MOST_FRUITLESS:
                missing = self._job.units - status.done
                raise JobError(f"{self._job.path}: {missing} units are missing still. {self._complaint}", TRY_AGAIN)
            if fruitless:  # one unit may keep those behind it from being drawn
                self._pace = Pace(1, is_known=True)
        return status.done - first.done

    def draw_damaged(self) -> int:
        """After a merge: what it set aside is missing. What another class drew looks whole, and workers look into it."""
        missing = self._job.status().missing
        if not missing:
            self._draw([(0, self._job.units - 1)])
        return self.draw_missing()

    def _draw(self, ranges: Sequence[tuple[int, int]]) -> None:
        """Each of these units is tried once."""
        from distributed import as_completed

        units = MissingUnits(ranges)
        total = units.count
        least = least_size(total)
        tried = 0
        workers = len(self._client.nthreads())
        completed = as_completed(loop=self._client.loop)
        try:
            for _ in range(max(1, workers)):
                self._submit(units.take(self._pace.batch_size(units.count, workers, least)), completed)
            for future in completed:
                batch = self._batches.pop(future)
                outcome = self._outcome(future)
                if outcome.status == 0:
                    self._pace.learn(batch.missing, outcome.seconds)
                tried += batch.missing
                if self._show is not None:
                    self._show((self._job.units - total + tried) / self._job.units)
                # Until the pace is known a worker gets one batch for another, then they get all that is left.
                self._submit(units.take(self._pace.batch_size(units.count, workers, least)), completed)
                while units.count and self._pace.is_known:
                    self._submit(units.take(self._pace.batch_size(units.count, workers, least)), completed)
        except OSError as error:  # of the connection: the scheduler may die while it is asked for an answer
            raise _scheduler_is_gone() from error
        finally:
            if self._batches:
                self._client.cancel(list(self._batches), force=True)
                self._batches.clear()

    def _submit(self, batch: Optional[Batch], completed: as_completed) -> None:
        if batch is None:
            return
        self.tasks += 1
        # The dashboard groups by what is before the hyphen; a key that the scheduler knows would not be done again.
        key = f"{self._job.name}-units {batch.first}..{batch.last} ({self._run}.{self.tasks})"
        future = self._client.submit(draw_batch, self._work, batch.first, batch.last, key=key, pure=False)
        self._batches[future] = batch
        completed.add(future)

    def _outcome(self, future: Future) -> Outcome:
        from distributed import KilledWorker

        if future.status == "finished":
            outcome: Outcome = future.result()
            if outcome.status in NEVER:
                raise JobError(outcome.message, outcome.status)
        elif future.status == "error":
            error = future.exception()
            if not isinstance(error, KilledWorker):
                raise JobError(
                    f"a worker or the scheduler cannot run lichtraum: {error!r}; install the same lichtraum[dask] on all", 65
                )
            outcome = Outcome(TRY_AGAIN, f"workers died: {error}", 0.0)
        elif future.status != "cancelled":
            outcome = Outcome(TRY_AGAIN, "a worker died before its answer arrived", 0.0)  # the folder knows what it drew
        else:
            raise _scheduler_is_gone()
        if outcome.status != 0:
            self.failed += 1
            self._complaint = outcome.message
        return outcome
