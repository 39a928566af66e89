"""What documents and docstrings show is what happens."""

import doctest
import importlib
import inspect
import os
import pkgutil
import re
from pathlib import Path

import pytest

import lichtraum
from lichtraum._options import READING

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


def test_help_names_the_options():
    """Which the functions take as `**options`."""
    every = set(lichtraum.RenderOptions.__annotations__)
    of_renderers = {"device", "traversal"}
    for function, options in ((lichtraum.render, every), (lichtraum.Renderer.render, every - of_renderers), (lichtraum.load, set(READING))):
        keywords = {each.name for each in inspect.signature(function).parameters.values() if each.kind is each.KEYWORD_ONLY}
        assert keywords - {"picture", "progress"} == options
    described = dict(re.findall(r"^(\w+): (.+)$", inspect.getdoc(lichtraum.RenderOptions), re.MULTILINE))
    assert set(described) == every and "width" in described["size"]
