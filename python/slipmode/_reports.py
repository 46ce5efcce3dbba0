"""Folders: comparisons of runs, and reports."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from slipmode._exact import Number, exact
from slipmode._errors import CheckFailed
from slipmode._run import in_records, run
from slipmode._table import html_table, write_csv

if TYPE_CHECKING:
    import pandas

Place = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Comparison:
    """Runs of another program next to the theory and to our simulation."""

    #: Whether every run agrees.
    agrees: bool
    #: An object for each run, as ``slipmode compare --json`` prints it.
    runs: list[dict[str, Any]] = field(repr=False)

    def to_dataframe(self) -> pandas.DataFrame:
        """Return :meth:`to_pandas`."""
        return self.to_pandas()

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each finding of each run."""
        import pandas

        rows = [
            {"row": each["row"], "run_verdict": each["verdict"]} | finding
            for each in self.runs
            for finding in each["findings"]
        ]
        return pandas.DataFrame(rows)

    def _repr_html_(self) -> str:
        rows = [[str(each["row"]), each["verdict"], each["reason"] or ""] for each in self.runs]
        return html_table(["run", "verdict", "reason"], rows)


@dataclass(frozen=True)
class Report:
    """A report that was computed."""

    #: Whether every verdict is the recorded one and no published byte moved; none if they were not compared.
    is_unchanged: bool | None
    #: The page.
    page: Path
    #: The verdicts, as ``ledger.json`` has them.
    ledger: dict[str, Any] = field(repr=False)
    #: What the command printed.
    text: str = field(repr=False)

    @property
    def verdicts(self) -> dict[str, str]:
        """The verdict of each claim."""
        return {claim["id"]: claim["verdict"] for claim in self.ledger["claims"]}

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each claim of the ledger."""
        import pandas

        return pandas.DataFrame(self.ledger["claims"])

    def _repr_html_(self) -> str:
        rows = [[claim["id"], claim["verdict"], claim["strength"] or ""] for claim in self.ledger["claims"]]
        return html_table(["claim", "verdict", "strength"], rows)


def compare(
    runs: Place | Mapping[str, Any] | Iterable[Mapping[str, Any]] | pandas.DataFrame,
    *,
    law: str | None = None,
    tolerance: Number | None = None,
    report: Place | None = None,
) -> Comparison:
    """Compare runs of another program with the theory and with our simulation.

    ``runs`` is a file as ``slipmode compare --runs`` reads it, a data frame of pandas or polars, or columns or rows with its
    column names. ``report`` is a folder for pages with figures.
    """
    options = [] if law is None else [f"--law={law}"]
    options += [] if tolerance is None else [f"--tolerance={exact(tolerance, 'tolerance')}"]
    options += [] if report is None else [f"--report={os.fspath(report)}"]
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(runs, (str, os.PathLike)):
            file, written = Path(runs), None
        else:
            file = Path(folder, "runs.csv")
            written = str(file)
            write_csv(file, runs)

        def reworded(text: str) -> str:
            return in_records(text, "runs", written)

        agrees, text = run("compare", f"--runs={file}", "--json", *options, may_differ=True, reworded=reworded)
    # Where runs disagree, a line of words follows the object.
    found, _ = json.JSONDecoder().raw_decode(text)
    return Comparison(agrees, found["rows"])


def report(folder: Place, output: Place | None = None) -> Report:
    """Compute the report of a folder; ``output`` is ``target/report/NAME`` without it."""
    return made("report", folder, output)


def verify(folder: Place, output: Place | None = None) -> Report:
    """Compute the report of a folder and compare it with its recorded verdicts and its published copy."""
    return made("verify", folder, output)


def made(command: str, folder: Place, output: Place | None) -> Report:
    """Run a command that makes a report."""
    to = [] if output is None else [f"--output={os.fspath(output)}"]
    passed, text = run(command, os.fspath(folder), *to, may_differ=command == "verify")
    pages = [line for line in text.splitlines() if line.endswith("index.html")]
    page = Path(pages[0])
    ledger = json.loads(page.with_name("ledger.json").read_text())
    return Report(passed if command == "verify" else None, page, ledger, text)
