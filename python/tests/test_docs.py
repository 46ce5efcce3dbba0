"""The Python of the documentation runs from its first line to its last."""

import os
import re
import runpy
import shutil
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[2]
PAGES = REPOSITORY / "docs" / "python"


def blocks(page):
    """The code of a page of the documentation."""
    return re.findall(r"^```python\n(.*?)^```$", (PAGES / page).read_text(), re.MULTILINE | re.DOTALL)


def test_every_line_of_the_documentation_runs(monkeypatch, capsys):
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(REPOSITORY)
    names: dict[str, object] = {}
    promised = []
    for page in ("index.md", "columns.md", "fits.md"):
        for block in blocks(page):
            exec(block, names)
            promised += re.findall(r"^print\(.*\)  # (.*)$", block, re.MULTILINE)
    printed = capsys.readouterr().out
    assert len(promised) > 1 and all(line in printed for line in promised), printed


def test_the_pictures_of_the_gallery_are_those_of_the_program(tmp_path, monkeypatch):
    kept = PAGES / "gallery"
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"record": REPOSITORY / "tests" / "data" / "records" / "basalt-step.csv"}
    for block in blocks("gallery.md"):
        exec(block, names)
    if "SLIPMODE_WRITE_GALLERY" in os.environ:
        shutil.copytree(tmp_path, kept, dirs_exist_ok=True)
    made = {picture.name: picture.read_text() for picture in tmp_path.iterdir()}
    assert len(made) == 6 and made == {picture.name: picture.read_text() for picture in kept.iterdir()}


def test_the_example_for_type_checkers_runs(capsys):
    runpy.run_path(str(REPOSITORY / "python" / "examples" / "typed.py"))["main"]()
    assert capsys.readouterr().out == "stick-slip stick-slip periodic (3, 3)\n"


def test_the_example_prints_shares_and_runs(capsys):
    pytest.importorskip("pandas")
    runpy.run_path(str(REPOSITORY / "python" / "examples" / "columns.py"))["main"](count=2000)
    printed = capsys.readouterr().out
    assert "stick-slip" in printed and "period_s" in printed
