"""The notebook runs from its first cell to its last."""

from pathlib import Path

import pytest

NOTEBOOK = Path(__file__).parents[1] / "examples" / "own_data.ipynb"


@pytest.mark.filterwarnings("ignore")
def test_every_cell_runs_and_shows_what_it_promises(tmp_path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    resources = {"metadata": {"path": str(tmp_path)}}
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", resources=resources).execute()
    outputs = [output["data"] for cell in notebook.cells for output in cell.get("outputs", []) if "data" in output]
    assert any("image/svg+xml" in data for data in outputs), "the map is a picture"
    assert any("stick-slip" in data.get("text/html", "") for data in outputs)
    assert any("<th>verdict</th>" in data.get("text/html", "") for data in outputs)
