"""The Python of the documentation runs from its first line to its last."""

import re
import runpy
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[2]


def test_every_line_of_the_documentation_runs(monkeypatch, capsys):
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(REPOSITORY)
    text = (REPOSITORY / "docs" / "python.md").read_text()
    names: dict[str, object] = {}
    promised = []
    for block in re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        exec(block, names)
        promised += re.findall(r"^print\(.*\)  # (.*)$", block, re.MULTILINE)
    printed = capsys.readouterr().out
    assert promised and all(line in printed for line in promised), printed


def test_the_example_prints_shares_and_runs(capsys):
    pytest.importorskip("pandas")
    runpy.run_path(str(REPOSITORY / "python" / "examples" / "columns.py"))["main"](count=2000)
    printed = capsys.readouterr().out
    assert "stick-slip" in printed and "period_s" in printed
