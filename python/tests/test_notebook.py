"""The notebooks in docs/, run from the first cell to the last, and what they show."""

import base64
import os
import shutil
from pathlib import Path

import pytest

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")
pytest.importorskip("ipykernel")

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


def run(notebook, folder, monkeypatch):
    """In a kernel of its own; the first cell that fails is raised."""
    for name in ("HOME", "IPYTHONDIR", "JUPYTER_RUNTIME_DIR"):
        monkeypatch.setenv(name, str(folder / name))
    os.makedirs(folder / "HOME")
    nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(folder)}}).execute()


def outputs_of(notebook):
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


def of_type(notebook, mime):
    return [output.data[mime] for output in outputs_of(notebook) if mime in output.get("data", {})]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs_and_its_pictures_show_themselves(path, tmp_path, monkeypatch):
    folder = tmp_path / "docs" / "notebooks"
    folder.mkdir(parents=True)
    shutil.copytree(ROOT / "scenes", tmp_path / "scenes", ignore=shutil.ignore_patterns("pictures"))
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert outputs_of(notebook) == []  # stored ones grow old, and the repository with them
    shown = [cell for cell in notebook.cells if cell.source.splitlines()[-1].startswith(("renderer.render(", "image"))]
    run(notebook, folder, monkeypatch)
    pictures = [base64.b64decode(text) for text in of_type(notebook, "image/png")]
    assert len(pictures) == len([cell for cell in shown if cell.cell_type == "code"]) > 3
    assert all(picture.startswith(b"\x89PNG\r\n\x1a\n") for picture in pictures)
    assert [output.text for output in outputs_of(notebook) if output.get("name") == "stderr"] == []


def test_progress_is_a_widget(tmp_path, monkeypatch):
    pytest.importorskip("ipywidgets")
    code = (
        "import lichtraum as lt\n"
        "scene = lt.Scene([lt.Sphere((0, 0, -5), 1), lt.Light.point((5, 8, 2))])\n"
        "image = lt.render(scene, size=(2048, 2048), samples=64{})"
    )
    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell(code.format("")), nbformat.v4.new_code_cell(code.format(", progress=False"))]
    )
    run(notebook, tmp_path, monkeypatch)
    with_bar, without = notebook.cells
    assert "application/vnd.jupyter.widget-view+json" in with_bar.outputs[0].data
    assert without.outputs == []
