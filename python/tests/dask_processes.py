"""Dask's scheduler and workers as processes that tests may kill, and jobs for them."""

import json
import os
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import lichtraum as lt

ROOT = Path(__file__).parents[2]
HELLO = ROOT / "scenes" / "hello.sdf"
PROGRAM = os.path.join(os.path.dirname(lt.__file__), "bin", "lichtraum")
PATIENCE = 120  # seconds, on machines that are busy


def lichtraum(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


def plan(folder, *words, size="64x48", tile="16x16", scene=HELLO):
    assert lichtraum("job", "plan", scene, f"--size={size}", f"--tile={tile}", *words, "-o", folder).returncode == 0
    return folder


def picture_of(folder, size="64x48", scene=HELLO):
    """The bytes that one machine writes."""
    folder.mkdir(exist_ok=True)
    assert lichtraum("render", scene, f"--size={size}", "-o", folder / "one.png").returncode == 0
    return (folder / "one.png").read_bytes()


def merged(folder):
    done = lichtraum("job", "merge", folder, "-o", folder / "merged.png")
    assert done.returncode == 0, done.stderr
    return (folder / "merged.png").read_bytes()


def unit_files(folder):
    return {path: path.stat().st_ino for path in Path(folder).rglob("*.unit")}


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE
    while not (result := condition()):
        assert time.monotonic() < end, f"waited in vain for {what}"
        time.sleep(0.02)
    return result


def tracers_of(pid):
    """The processes below this one that draw."""
    found = []
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        try:
            children = [int(child) for child in task.read_text().split()]
        except OSError:
            continue
        for child in children:
            found += tracers_of(child)
            try:
                words = Path(f"/proc/{child}/cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if words[1:3] == [b"job", b"work"]:
                found.append(child)
    return found


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


class Machines:
    """A scheduler and its workers. Each is a process in a group of its own."""

    def __init__(self, folder, prefix=()):
        self._file = folder / "scheduler.json"
        self._log = open(folder / "dask.log", "ab")
        self._prefix = [*prefix]
        self.scheduler = None
        self.workers = []

    def begin(self, workers, host="127.0.0.1", **settings):
        self._file.unlink(missing_ok=True)
        self.scheduler = self._start("scheduler", "--host", host, "--port", "0", "--no-dashboard", settings=settings)
        for _ in range(workers):
            self.add_worker()
        return wait_for(self._address, "the scheduler")

    def add_worker(self, *prefix):
        wait_for(self._address, "the scheduler")
        words = ["worker", "--nthreads", "1", "--no-nanny", "--no-dashboard", "--memory-limit", "0"]
        self.workers.append(self._start(*words, prefix=prefix))
        return self.workers[-1]

    def end(self):
        for process in [*self.workers, self.scheduler]:
            if process is not None:
                process.kill()
                process.wait()
        self.workers = []
        self._log.close()

    def _address(self):
        try:
            return json.loads(self._file.read_text())["address"]
        except (OSError, ValueError):
            return None

    def _start(self, *words, prefix=(), settings={}):
        command = [*(prefix or self._prefix), sys.executable, "-m", "dask", *words, "--scheduler-file", str(self._file)]
        environment = {**os.environ, **{f"DASK_DISTRIBUTED__{name}": str(value) for name, value in settings.items()}}
        return subprocess.Popen(command, stdout=self._log, stderr=self._log, env=environment, start_new_session=True)


@contextmanager
def machines(folder, **options):
    all_of_them = Machines(folder, **options)
    try:
        yield all_of_them
    finally:
        all_of_them.end()
