"""Columns of equal length, as arrays, a data frame, or HTML."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from slipmode._errors import InputError

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

#: Rows that are shown in a notebook.
SHOWN_ROWS = 10


class Table(Mapping[str, NDArray[Any]]):
    """Columns by name; every column is an array."""

    def __init__(self, columns: Mapping[str, Any]) -> None:
        self._columns: dict[str, NDArray[Any]] = {name: fixed(np.asanyarray(column)) for name, column in columns.items()}

    @classmethod
    def of_rows(cls, rows: list[dict[str, Any]]) -> Table:
        """Return a table with a row for each object; the first one names the columns."""
        names = rows[0].keys() if rows else ()
        return cls({name: column([row[name] for row in rows]) for name in names})

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """The number of rows."""
        return max((array.size for array in self._columns.values()), default=0)

    def to_pandas(self) -> pandas.DataFrame:
        """Return the columns as a data frame of pandas."""
        import pandas

        return pandas.DataFrame({name: pandas_column(array) for name, array in self._columns.items()})

    def to_dataframe(self) -> pandas.DataFrame:
        """Return :meth:`to_pandas`."""
        return self.to_pandas()

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.rows} rows of {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        shown = [array.ravel()[:SHOWN_ROWS] for array in self._columns.values()]
        body = [[str(cell) for cell in row] for row in zip(*shown)]
        rest = self.rows - len(body)
        note = f"<p>and {rest} more rows</p>" if rest > 0 else ""
        return html_table(list(self._columns), body) + note


class Record:
    """A result whose fields are values: a row of pandas, and a table of a notebook."""

    def to_pandas(self) -> pandas.Series[Any]:
        """Return the fields by name."""
        import pandas

        return pandas.Series(vars(self), dtype=object)

    def _repr_html_(self) -> str:
        return html_table(["name", "value"], [[name, str(value)] for name, value in vars(self).items()])


def fixed(array: NDArray[Any]) -> NDArray[Any]:
    """Return an array with the same values that cannot be changed."""
    array = array.copy() if np.ma.isMA(array) else np.asarray(array).view()
    for part in (array, np.ma.getmask(array)):
        if part is not np.ma.nomask:
            part.flags.writeable = False
    return array


def pandas_column(column: Any) -> Any:
    """Return a column of pandas, with missing values as such."""
    import pandas

    if hasattr(column, "to_pandas"):
        return column.to_pandas()
    if np.ma.isMA(column) and column.dtype.kind == "f":
        return column.filled(np.nan).ravel()
    if np.ma.isMA(column):
        return pandas.arrays.IntegerArray(np.asarray(column.data).ravel(), np.ma.getmaskarray(column).ravel())
    return column.ravel()


def column(cells: list[Any]) -> NDArray[Any]:
    """Return an array of numbers, with NaN where there is none, or of objects."""
    if all(cell is None or isinstance(cell, (int, float)) and not isinstance(cell, bool) for cell in cells):
        if not any(cell is None or isinstance(cell, float) for cell in cells):
            return np.array(cells, dtype=np.int64)
        return np.array([np.nan if cell is None else cell for cell in cells], dtype=np.float64)
    array = np.empty(len(cells), dtype=object)
    array[:] = cells
    return array


def series(values: Mapping[str, Any]) -> pandas.Series[Any]:
    """Return the numbers and words of an object as a series of pandas."""
    import pandas

    plain = {name: value for name, value in values.items() if value is None or isinstance(value, (bool, int, float, str))}
    return pandas.Series(plain, dtype=object)


def axes(ax: Axes | None, x: str, y: str, scale: str = "log") -> Axes:
    """Return axes of matplotlib with these labels, new ones unless they are given."""
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.figure(layout="constrained").subplots()
    ax.set(xlabel=x, ylabel=y, xscale=scale, yscale=scale)
    return ax


def html_table(head: list[str], body: list[list[str]]) -> str:
    """Return a table as HTML."""
    heads = "".join(f"<th>{escape(name)}</th>" for name in head)
    rows = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in body)
    return f"<table><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>"


def columns_of_csv(text: str) -> dict[str, NDArray[np.float64]]:
    """Return the columns of numbers that a command printed."""
    head, _, body = text.partition("\n")
    numbers = np.loadtxt(io.StringIO(body), delimiter=",", ndmin=2)
    return dict(zip(head.split(","), numbers.T))


def write_csv(file: Path, table: Any) -> None:
    """Write a data frame of pandas or polars, or columns or rows by name, as CSV; a float has digits that give it again."""
    if hasattr(table, "to_csv"):
        table.to_csv(file, index=False)
        return
    if hasattr(table, "write_csv"):
        table.write_csv(file)
        return
    if isinstance(table, Mapping):
        columns = {name: np.atleast_1d(np.asarray(column, dtype=object)) for name, column in table.items()}
        lengths = {name: len(array) for name, array in columns.items()}
        if len(set(lengths.values())) > 1:
            listed = ", ".join(f"{name} has {length}" for name, length in lengths.items())
            raise InputError(f"the columns have different numbers of rows: {listed}")
        rows = [dict(zip(columns, row)) for row in zip(*columns.values())]
    else:
        columns, rows = {}, list(table) if isinstance(table, Iterable) else [table]
        if wrong := [row for row in rows if not isinstance(row, Mapping)]:
            raise InputError(f"{wrong[0]!r} is no table (wanted: a data frame, columns by name, or rows with names)")
    names = list(columns or dict.fromkeys(name for row in rows for name in row))
    with file.open("w", newline="") as stream:
        writer = csv.DictWriter(stream, fieldnames=names)
        writer.writeheader()
        writer.writerows(rows)
