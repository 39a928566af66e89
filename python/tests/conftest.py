"""What several files of tests draw with, and draw."""

import os
import subprocess
import sys

import pytest

import lichtraum as lt

SCENE = """define material red 0.3 0 0  0.9 0.1 0.1  0.6 0.6 0.6  40
define shape sphere ball 0 0 -5 1 red
define light diffuse sun 5 8 2  0.9 0.9 0.8
define camera eye 60
render eye one.png 32 24
transform ball translate 1 0 0
render eye two.png 40 24
"""


@pytest.fixture
def renderer():
    return lt.Renderer()


@pytest.fixture
def film(tmp_path):
    path = tmp_path / "film.sdf"
    path.write_text(SCENE)
    return path


@pytest.fixture
def child():
    """Runs code in a Python of its own."""

    def run(code, **environment):
        command = [sys.executable, "-W", "always", "-c", code]
        return subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True)

    return run
