"""Machines that fail for a long time, or again and again."""

import os
import signal
import subprocess
import time

import pytest

pytest.importorskip("distributed")

import lichtraum as lt
from dask_processes import machines, merged, picture_of, plan, tracers_of, unit_files, wait_for
from lichtraum import farm
from test_farm import in_background

pytestmark = pytest.mark.long
SIZE = "160x80"  # 200 units
KILLS = 20


@pytest.fixture
def job(tmp_path):
    return plan(tmp_path / "job", size=SIZE, tile="8x8")


def test_a_worker_is_killed_every_half_second(job, tmp_path):
    with machines(tmp_path) as crew:
        address = crew.begin(3, SCHEDULER__ALLOWED_FAILURES=100)
        thread, result = in_background(lambda: farm.run(job, address, progress=False, batch_seconds=0.5, timeout=120))
        for _ in range(KILLS):
            at_work = wait_for(
                lambda: not thread.is_alive() or [w for w in crew.workers if tracers_of(w.pid)], "a worker at work"
            )
            if at_work is True:
                break
            at_work[0].kill()
            at_work[0].wait()
            crew.workers.remove(at_work[0])
            crew.add_worker()
            time.sleep(0.5)
        thread.join()
    assert "error" not in result, result
    assert result["value"].drawn == 200 and len(unit_files(job)) == 200
    assert merged(job) == picture_of(tmp_path, SIZE)


def test_the_scheduler_is_killed(job, tmp_path):
    with machines(tmp_path) as crew:
        address = crew.begin(2)
        thread, result = in_background(lambda: farm.run(job, address, progress=False, batch_seconds=1, timeout=120))
        wait_for(lambda: len(unit_files(job)) >= 10, "ten units")
        crew.scheduler.kill()
        thread.join()
        assert isinstance(result.get("error"), lt.JobError), result
        assert result["error"].status == 75 and "the scheduler is gone" in str(result["error"])
    before = unit_files(job)
    assert 10 <= len(before) < 200
    with machines(tmp_path) as crew:
        again = farm.run(job, crew.begin(2), progress=False)
    after = unit_files(job)
    assert again.drawn == 200 - len(before) and {path: after[path] for path in before} == before
    assert merged(job) == picture_of(tmp_path, SIZE)


def test_a_machine_stands_still_for_half_a_minute(job, tmp_path):
    with machines(tmp_path) as crew:
        address = crew.begin(2)
        thread, result = in_background(lambda: farm.run(job, address, progress=False, batch_seconds=1, timeout=120))
        tracer = wait_for(lambda: tracers_of(crew.workers[0].pid), "a tracer")[0]
        stopped = [crew.workers[0].pid, tracer]
        for pid in stopped:
            os.kill(pid, signal.SIGSTOP)
        time.sleep(30)
        for pid in stopped:
            os.kill(pid, signal.SIGCONT)
        thread.join()
    assert "error" not in result, result
    assert merged(job) == picture_of(tmp_path, SIZE)


NAMESPACE = "lichtraum-farm"
BRIDGE = f"""ip netns add {NAMESPACE}
ip link add lichtraum0 type veth peer name lichtraum1 netns {NAMESPACE}
ip addr add 10.213.7.1/30 dev lichtraum0
ip link set lichtraum0 up
ip -n {NAMESPACE} addr add 10.213.7.2/30 dev lichtraum1
ip -n {NAMESPACE} link set lichtraum1 up
ip -n {NAMESPACE} link set lo up"""


@pytest.fixture
def network():
    subprocess.run(["ip", "netns", "del", NAMESPACE], capture_output=True)  # of a test that was killed
    try:
        for line in BRIDGE.splitlines():
            subprocess.run(line.split(), check=True, capture_output=True)
        yield
    except (OSError, subprocess.CalledProcessError) as error:
        pytest.skip(f"no network can be made here, to be cut: {error}")
    finally:
        subprocess.run(["ip", "netns", "del", NAMESPACE], capture_output=True)


def test_the_network_is_cut_for_a_minute(job, tmp_path, network):
    """One of two workers is behind the cut."""
    with machines(tmp_path) as crew:
        address = crew.begin(1, host="10.213.7.1")
        far = crew.add_worker("ip", "netns", "exec", NAMESPACE)
        thread, result = in_background(lambda: farm.run(job, address, progress=False, batch_seconds=1, timeout=120))
        wait_for(lambda: tracers_of(far.pid), "a tracer behind the cut")
        subprocess.run(["ip", "link", "set", "lichtraum0", "down"], check=True)
        time.sleep(60)
        subprocess.run(["ip", "link", "set", "lichtraum0", "up"], check=True)
        thread.join()
    assert "error" not in result, result
    assert merged(job) == picture_of(tmp_path, SIZE)
