"""Jobs on Dask's workers: each failure is found, and the picture has the bytes of one machine."""

import os
import signal
import subprocess
import sys
import threading

import pytest

pytest.importorskip("distributed")

import lichtraum as lt
from dask_processes import HELLO, PROGRAM, is_running, lichtraum, machines, merged, picture_of, plan, tracers_of, unit_files, wait_for
from lichtraum import farm
from lichtraum._batch_worker import draw_batch
from lichtraum._batches import MOST_TASKS, MissingUnits, Pace, least_size
from lichtraum._job_folder import JobFolder


@pytest.fixture
def job(tmp_path):
    return plan(tmp_path / "job")


def in_background(function):
    result = {}

    def call():
        try:
            result["value"] = function()
        except BaseException as error:  # the test looks at it
            result["error"] = error

    thread = threading.Thread(target=call)
    thread.start()
    return thread, result


def test_batches_have_each_missing_unit_once():
    ranges = [(0, 7), (9, 9), (50, 50), (500, 777), (900, 901)]
    for size in (1, 2, 7, 100, 1000):
        units, seen = MissingUnits(ranges), []
        while (batch := units.take(size)) is not None:
            inside = [n for first, last in ranges for n in range(first, last + 1) if batch.first <= n <= batch.last]
            assert len(inside) == batch.missing <= size and batch.last - batch.first < size + 200
            seen += inside
        assert seen == [n for first, last in ranges for n in range(first, last + 1)] and units.count == 0


@pytest.mark.parametrize("pace", [Pace(10), Pace(10, size=1, is_known=True)])
def test_there_are_never_too_many_tasks(pace):
    units, tasks = MissingUnits([(0, 3_999_999)]), 0
    least = least_size(units.count)
    while units.take(pace.batch_size(units.count, 3, least)) is not None:
        tasks += 1
        assert tasks <= MOST_TASKS


def test_one_machine_alone(job, tmp_path):
    told = []
    summary = farm.run(job, workers=2, output=tmp_path / "farm.png", progress=told.append)
    assert (tmp_path / "farm.png").read_bytes() == picture_of(tmp_path)
    assert (summary.units, summary.drawn, summary.failed) == (12, 12, 0) and 1 < summary.tasks <= 12
    assert told == sorted(told) and told[-1] == 1
    before = unit_files(job)
    again = farm.run(job, output=tmp_path / "farm.png")
    assert (again.drawn, again.tasks) == (0, 0) and unit_files(job) == before


def test_damaged_units_are_drawn_again(job, tmp_path):
    other = plan(tmp_path / "other", size="64x49")
    assert lichtraum("job", "work", other).returncode == lichtraum("job", "work", job).returncode == 0
    files = {int(path.stem): path for path in unit_files(job)}
    files[2].write_bytes(files[2].read_bytes()[:-100])
    flipped = bytearray(files[3].read_bytes())
    flipped[len(flipped) // 2] ^= 1
    files[3].write_bytes(flipped)
    files[5].write_bytes({int(path.stem): path for path in unit_files(other)}[5].read_bytes())
    before = unit_files(job)
    with machines(tmp_path) as crew:
        address = crew.begin(1)
        summary = farm.run(job, address, output=tmp_path / "farm.png", progress=False)
        assert summary.drawn == 3
        after = unit_files(job)
        assert {int(path.stem) for path in after if after[path] != before.get(path)} == {2, 3, 5}
        files[7].unlink()  # now one that a device of another class draws
        assert lichtraum("job", "work", job, "--units=7..7", "--device=reference", "--allow-mixed").returncode == 0
        mixed = unit_files(job)
        farm.run(job, address, output=tmp_path / "farm.png", progress=False)
    after = unit_files(job)
    assert {int(path.stem) for path in after if after[path] != mixed.get(path)} == {7}
    assert (tmp_path / "farm.png").read_bytes() == picture_of(tmp_path)


@pytest.mark.parametrize("victim", ["worker", "tracer"])
def test_what_was_killed_is_done_again(job, tmp_path, victim):
    """Also where Dask gives a task up at its worker's first death."""
    with machines(tmp_path) as crew:
        address = crew.begin(1, SCHEDULER__ALLOWED_FAILURES=0)
        thread, result = in_background(lambda: farm.run(job, address, progress=False, timeout=120))
        tracer = wait_for(lambda: tracers_of(crew.workers[0].pid), "a tracer")[0]
        os.kill(tracer, signal.SIGSTOP)  # by itself it ends no more
        if victim == "worker":
            crew.workers[0].kill()
            wait_for(lambda: not is_running(tracer), "the tracer's end: nobody waits for it")
            crew.add_worker()
        else:
            os.kill(tracer, signal.SIGKILL)
        thread.join()
    assert result["value"].failed >= 1, result
    assert merged(job) == picture_of(tmp_path)


def test_same_units_on_two_workers(job, tmp_path):
    from distributed import Client

    work = JobFolder(str(job)).work([])
    with machines(tmp_path) as crew, Client(crew.begin(2)) as client:
        client.wait_for_workers(2)
        workers = list(client.nthreads())
        both = [client.submit(draw_batch, work, 0, 11, workers=[worker], pure=False) for worker in workers]
        assert [outcome.status for outcome in client.gather(both)] == [0, 0]
    assert merged(job) == picture_of(tmp_path)


def test_what_never_works_ends_the_job(tmp_path):
    scene = tmp_path / "scene.sdf"
    scene.write_bytes(HELLO.read_bytes())
    job = plan(tmp_path / "job", scene=scene)
    scene.write_bytes(HELLO.read_bytes() + b"\n")
    with machines(tmp_path) as crew, pytest.raises(lt.JobError, match="scene.sdf") as caught:
        farm.run(job, crew.begin(1), progress=False)
    assert caught.value.status == 65 and not unit_files(job)


def test_machines_that_cannot_take_part_say_why(job):
    work = JobFolder(str(job)).work([])
    for wrong, status, reason in [
        (work._replace(version="0.0.1"), 65, "begun by 0.0.1"),
        (work._replace(folder=str(job) + "x"), 75, "cannot read the plan"),
        (work._replace(plan_hash="0" * 64), 65, "another plan"),
    ]:
        outcome = draw_batch(wrong, 0, 0)
        assert outcome.status == status and reason in outcome.message
    assert not unit_files(job)


def test_a_plan_that_is_gone_when_a_child_begins_may_come_back(job, monkeypatch):
    work = JobFolder(str(job)).work([])
    program = job.parent / "program"
    program.write_text(f"#!/bin/sh\nmv {job} {job}.gone\nexec {PROGRAM} \"$@\"\n")
    program.chmod(0o755)
    monkeypatch.setattr("lichtraum._batch_worker.PROGRAM", str(program))
    outcome = draw_batch(work, 0, 0)
    assert outcome.status == 75 and "no plan.json" in outcome.message


def test_one_of_two_machines_has_lost_the_folder(job, tmp_path):
    from distributed import Client

    hidden = ["unshare", "-m", "sh", "-c", f'mount -t tmpfs none {job} && exec "$@"', "sh"]
    if subprocess.run([*hidden, "true"], capture_output=True).returncode:
        pytest.skip("no folder can be hidden here")
    with machines(tmp_path) as crew, Client(crew.begin(1)) as client:
        crew.add_worker(*hidden)
        client.wait_for_workers(2)
        summary = farm.run(job, client, progress=False)
    assert summary.drawn == 12 and summary.failed >= 1
    assert merged(job) == picture_of(tmp_path)


def test_full_disk(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk], capture_output=True).returncode:
        pytest.skip("no disk can be mounted here, to be filled")
    try:
        job = plan(disk / "job", size="256x64", tile="128x64")
        with machines(tmp_path) as crew:
            address = crew.begin(1)
            with pytest.raises(lt.JobError, match="the disk is full") as caught:
                farm.run(job, address, progress=False)
            assert caught.value.status == 75
            subprocess.run(["mount", "-o", "remount,size=16m", disk], check=True)
            farm.run(job, address, progress=False)
        assert merged(job) == picture_of(tmp_path, "256x64")
    finally:
        subprocess.run(["umount", disk], check=True)


def command(*words, **options):
    how = {"stderr": subprocess.PIPE, "text": True, **options}
    return subprocess.Popen([sys.executable, "-m", "lichtraum.farm", *map(str, words)], **how)


def test_interrupted(job, tmp_path):
    process = command(job, start_new_session=True)
    tracer = wait_for(lambda: tracers_of(process.pid), "a tracer")[0]
    os.kill(process.pid, signal.SIGINT)
    message = process.communicate(timeout=120)[1]
    assert process.returncode == 130 and "interrupted: what is drawn stays" in message
    wait_for(lambda: not is_running(tracer), "the tracer's end")
    assert farm.main([str(job), "--quiet", "-o", str(tmp_path / "farm.png")]) == 0
    assert (tmp_path / "farm.png").read_bytes() == picture_of(tmp_path)


def test_errors_of_the_command(job, tmp_path, capsys):
    assert farm.main([str(job), "--scheduler", "tcp://127.0.0.1:1", "--timeout=1"]) == 75
    assert "no Dask scheduler answers at 'tcp://127.0.0.1:1' within 1 s" in capsys.readouterr().err
    assert farm.main([str(job), "--scheduler", "head"]) == 64
    assert "'head' is no address of a scheduler" in capsys.readouterr().err
    with machines(tmp_path) as crew:
        assert farm.main([str(job), "--scheduler", crew.begin(0), "--timeout=1"]) == 75
        assert "the scheduler has no workers" in capsys.readouterr().err
    assert farm.main([str(tmp_path / "nothing")]) == 66
    assert "no plan.json" in capsys.readouterr().err
    for option, name in (("--workers=0", "workers"), ("--batch-seconds=nan", "batch_seconds"), ("--timeout=inf", "timeout")):
        with pytest.raises(SystemExit) as ended:
            farm.main([str(job), option])
        assert ended.value.code == 64 and f"error: {name}: expected" in capsys.readouterr().err
    for words in ([], [str(job), "--bogus"], [str(job), "--workers=two"], [str(job), "-o", ""]):
        with pytest.raises(SystemExit) as ended:
            farm.main(words)
        assert ended.value.code == 64 and "\nerror: " in capsys.readouterr().err


@pytest.mark.parametrize("output, status, message", [
    ("foo", 64, "'foo' has no extension"),
    ("foo.bmp", 64, "no picture format has the extension '.bmp'"),
    ("nowhere/foo.png", 73, "cannot write 'nowhere/foo.png': there is no folder 'nowhere'"),
    ("nowhere/%02d.png", 73, "cannot write 'nowhere/01.png'"),
    ("nowhere/foo.gif", 73, "cannot write 'nowhere/foo.gif'"),
])
def test_what_cannot_be_written_is_told_before_anything_is_drawn(job, tmp_path, monkeypatch, output, status, message):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(lt.JobError) as caught:
        farm.run(job, output=output, progress=False)
    assert caught.value.status == status and str(caught.value).startswith(message)
    assert not unit_files(job)


def test_what_a_file_cannot_take_is_told_before_anything_is_drawn(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scene = tmp_path / "scene.sdf"
    scene.write_bytes(HELLO.read_bytes())
    (tmp_path / "link.exr").symlink_to(scene)
    job = plan(tmp_path / "job", "--planes=depth,normal", scene=scene)
    for output, status, message in [("a.png", 64, "'a.png' has room for one"), ("link.exr", 73, "'link.exr' is read for this picture")]:
        with pytest.raises(lt.JobError, match=message) as caught:
            farm.run(job, output=output, progress=False)
        assert caught.value.status == status and not unit_files(job)


def test_the_picture_goes_to_standard_output(job, tmp_path):
    for _ in range(2):
        process = command(job, "-o", "-", stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=False)
        picture, told = process.communicate(timeout=120)
        assert process.returncode == 0 and picture == picture_of(tmp_path) and b"12 units drawn by" in told


@pytest.mark.parametrize("name", ["workers", "batch_seconds", "timeout"])
@pytest.mark.parametrize("value", [0, -1, float("nan"), float("inf"), True, None, "2"])
def test_numbers_that_make_no_sense(job, name, value):
    with pytest.raises(lt.UsageError, match=f"^{name}: expected a .*number.*not {value!r}"):
        farm.run(job, **{name: value})


def test_without_dask(job, tmp_path):
    (tmp_path / "distributed.py").write_text("raise ImportError('as if it were not installed')\n")
    path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    process = command(job, env={**os.environ, "PYTHONPATH": path})
    assert "error: Dask is not installed: pip install 'lichtraum[dask]'" in process.communicate()[1]
    assert process.returncode == 69
