"""The notebook runs from beginning to end, and tells what it tells as it stands.

After a change, in examples: jupyter execute --inplace rebound.ipynb
"""

import pathlib

import pytest

NOTEBOOK = pathlib.Path(__file__).parents[1] / "examples" / "rebound.ipynb"


def told(cell):
    """What a cell prints, without warnings, which name a temporary file, and without pictures, whose bytes are
    matplotlib's."""
    printed = [output for output in cell.get("outputs", []) if output.get("name") != "stderr"]
    return "".join(output.get("text", "") for output in printed)


def test_the_notebook_runs():
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    pytest.importorskip("matplotlib")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    expected = [told(cell) for cell in notebook.cells]
    assert sum(map(bool, expected)) >= 4
    where = {"metadata": {"path": str(NOTEBOOK.parent)}}
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources=where).execute()
    assert [told(cell) for cell in notebook.cells] == expected
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 3
