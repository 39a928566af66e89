"""What documents and docstrings show is what happens."""

import doctest
import importlib
import os
import pkgutil
from pathlib import Path

import pytest

import lichtraum

ROOT = Path(__file__).parents[2]
FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """Examples draw scenes/hello.sdf, and write beside it what they write."""
    monkeypatch.chdir(tmp_path)
    os.symlink(ROOT / "scenes", tmp_path / "scenes")


def test_guide():
    result = doctest.testfile(str(ROOT / "docs" / "PYTHON.md"), module_relative=False, optionflags=FLAGS)
    assert result.attempted >= 20 and result.failed == 0


@pytest.mark.parametrize("name", [m.name for m in pkgutil.iter_modules(lichtraum.__path__) if m.name != "__main__"] + [""])
def test_docstrings(name):
    module = importlib.import_module(("lichtraum." + name).rstrip("."))
    assert doctest.testmod(module, optionflags=FLAGS).failed == 0


def test_examples_in_docstrings_are_found():
    finder = doctest.DocTestFinder()
    modules = [lichtraum, importlib.import_module("lichtraum._render")]
    assert sum(len(test.examples) for module in modules for test in finder.find(module)) >= 4
