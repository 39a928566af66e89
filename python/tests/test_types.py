"""Types, as mypy sees them, and whether they are those of the module."""

import inspect
import os
import subprocess
import sys
import typing
from pathlib import Path

import pytest

import lichtraum

ROOT = Path(__file__).parents[2]
PACKAGES = Path(lichtraum.__file__).parents[1]

pytest.importorskip("mypy")

GOOD = """
import numpy
import lichtraum as lt
image: lt.Image = lt.render("a.sdf", size=(4, 3), samples=(2, 2), background=((0, 0, 0), (1, 1, 1)), progress=False)
size: tuple[int, int] = image.size
number: int = lt.load("a.glb", time=1.5).diagnostics[0].line
corner = numpy.zeros(3)
lt.render(lt.Scene([lt.Sphere(corner, 1, lt.Phong(diffuse=corner))]), eye=corner, size=[4, 3])
options: lt.RenderOptions = {"samples": 4}
"""
BAD = """
import lichtraum as lt
lt.render("a.sdf", sizes=(4, 3))
lt.render("a.sdf", seed=(4, 3))
lt.load("a.sdf").nothing
"""


def run(tmp_path, module, *arguments):
    command = [sys.executable, "-m", module, *map(str, arguments)]
    environment = {**os.environ, "MYPY_CACHE_DIR": str(tmp_path / "cache")}
    if PACKAGES.name != "site-packages":
        environment |= {"MYPYPATH": str(PACKAGES), "PYTHONPATH": str(PACKAGES)}
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)


def public_functions():
    for name in lichtraum.__all__:
        thing = getattr(lichtraum, name)
        if inspect.isfunction(thing):
            yield name, thing
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            function = getattr(value, "fget", None) or getattr(value, "__func__", value)
            if inspect.isfunction(function) and member not in {"words", "native"}:  # which write eSDF and compile materials
                yield f"{name}.{member}", function


@pytest.mark.skipif(sys.version_info < (3, 11), reason="typing has no Unpack")
def test_types_can_be_asked_for():
    functions = dict(public_functions())
    assert {"render", "load", "Renderer.render", "Image.diagnostics", "Error.__init__"} <= functions.keys()
    for function in functions.values():
        typing.get_type_hints(function)


def test_package_is_typed(tmp_path):
    checked = run(tmp_path, "mypy", "--config-file", ROOT / "pyproject.toml", "-p", "lichtraum")
    assert checked.returncode == 0, checked.stdout


def test_users_are_helped(tmp_path):
    (tmp_path / "good.py").write_text(GOOD)
    (tmp_path / "bad.py").write_text(BAD)
    good = run(tmp_path, "mypy", "--strict", "good.py")
    assert good.returncode == 0, good.stdout
    bad = run(tmp_path, "mypy", "--strict", "bad.py")
    assert [line.split(":")[1] for line in bad.stdout.splitlines() if ": error:" in line] == ["3", "4", "5"], bad.stdout


def test_stubs_are_the_module(tmp_path):
    (tmp_path / "mypy.ini").write_text("[mypy]\n[mypy-ipywidgets.*,IPython.*]\nignore_missing_imports = True\n[mypy-dask.*,distributed.*]\nignore_missing_imports = True\nfollow_imports = skip\n")
    allowed = ROOT / "python" / "tests" / "stubtest_allowlist.txt"
    checked = run(tmp_path, "mypy.stubtest", "lichtraum", "--mypy-config-file", "mypy.ini", "--allowlist", allowed)
    assert checked.returncode == 0, checked.stdout
