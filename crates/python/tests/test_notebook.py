"""The notebooks run from beginning to end in any folder, and tell what they tell as they stand.

After a change, in examples: jupyter execute --inplace rebound.ipynb
"""

import pathlib

import pytest

NOTEBOOKS = sorted((pathlib.Path(__file__).parents[1] / "examples").glob("*.ipynb"))


def told(cell):
    """What a cell prints, without warnings, which name a temporary file, and without pictures, whose bytes are
    matplotlib's."""
    printed = [output for output in cell.get("outputs", []) if output.get("name") != "stderr"]
    return "".join(output.get("text", "") for output in printed)


def pictures(notebook):
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    return sum("image/png" in output.get("data", {}) for output in outputs)


def test_there_are_notebooks():
    assert [path.stem for path in NOTEBOOKS] == ["rebound", "rough_surface", "tennis_ball"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_in_any_folder(path, tmp_path):
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    notebook = nbformat.read(path, as_version=4)
    expected, drawn = [told(cell) for cell in notebook.cells], pictures(notebook)
    assert sum(map(bool, expected)) >= 3 and drawn >= 2
    where = {"metadata": {"path": str(tmp_path)}}
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources=where).execute()
    assert [told(cell) for cell in notebook.cells] == expected
    assert pictures(notebook) == drawn
