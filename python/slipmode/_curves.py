"""Questions on sliders without an operating point: each has a table of its own."""

from __future__ import annotations

import csv
import io
import tempfile
from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any, overload

import numpy as np

from slipmode import _slipmode
from slipmode._classified import BoundaryTable
from slipmode._exact import Number, exact
from slipmode._questions import Frame, Texts, Warned, chosen, options, refuse_error_bars, single
from slipmode._rows import NAMES, FrameColumn, Rows, Value
from slipmode._run import call, call_json, each
from slipmode._table import Table

OF_THE_SLIDER = NAMES[:5]
OF_THE_POINT = NAMES[5:]


@overload
def boundary(
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, n: int = 200,
    digits: int | None = None, frequency_ratio: Number | None = None
) -> BoundaryTable: ...
@overload
def boundary(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, n: int = 200, digits: int | None = None,
    frequency_ratio: Number | None = None
) -> Table: ...
@overload
def boundary(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, n: int = 200, digits: int | None = None,
    frequency_ratio: Number | None = None
) -> Frame: ...
@overload
def boundary(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, n: int = 200, digits: int | None = None,
    frequency_ratio: Number | None = None
) -> Any: ...
@overload
def boundary(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, n: int = 200,
    digits: int | None = None, frequency_ratio: Number | None = None
) -> Table: ...
def boundary(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    n: int = 200,
    digits: int | None = None,
    frequency_ratio: Number | None = None,
) -> Any:
    """Compute the exact boundary max Im(s) = 0, with ``n`` points on each arc and the marked ones.

    With a ``frequency_ratio`` between 0 and 1, compute the line of this ω/ω_n instead, at ``n`` points and where it crosses K = K_c.
    The columns are those of ``slipmode boundary``. Numbers are floats, or ``Decimal`` with this many ``digits``. The arguments are
    those of :func:`classify` without σ and V0. Arrays of sliders give one table, whose column ``row`` counts the sliders from 0. A
    frame gives such a frame of its package; pandas repeats the index of the slider.
    """
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m}, OF_THE_SLIDER, frame)
    asked = [f"--points={n}"] + ([] if frequency_ratio is None else [f"--frequency-ratio={exact(frequency_ratio, 'frequency_ratio')}"])
    if single(values, frame):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder, "boundary.svg")
            texts = {name: exact(value, name) for name, value in values.items()}
            found = boundary_points(texts, [*asked, f"--svg={picture}"], digits, None)
            return BoundaryTable(Table.of_rows(found), picture.read_text())
    return table_of(frame, values, "boundary", lambda texts, warned: boundary_points(texts, asked, digits, warned))


def boundary_points(
    texts: Texts, asked: Sequence[str], digits: int | None, warned: Warned | None
) -> list[dict[str, Any]]:
    """Return the points of the boundary of a slider."""
    refuse_error_bars("boundary", any(map(_slipmode.has_error_bar, texts.values())))
    if digits is None:
        found: list[dict[str, Any]] = call_json("boundary", *options(texts), *asked, warned=warned)["points"]
        return found
    printed = call("boundary", *options(texts), *asked, f"--digits={digits}", warned=warned)
    words = ("arc", "asymptote", "mark")
    cells = csv.DictReader(io.StringIO(printed))
    return [{name: x if name in words else Decimal(x) for name, x in row.items()} for row in cells]


@overload
def tolerance(
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, errors: Sequence[Number] = ()
) -> Table: ...
@overload
def tolerance(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, errors: Sequence[Number] = ()
) -> Table: ...
@overload
def tolerance(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, errors: Sequence[Number] = ()
) -> Frame: ...
@overload
def tolerance(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, errors: Sequence[Number] = ()
) -> Any: ...
@overload
def tolerance(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, errors: Sequence[Number] = ()
) -> Table: ...
def tolerance(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    errors: Any = (),
) -> Any:
    """Compute where each formula of the paper may be used, for these relative ``errors``; 0.1, 0.01 and 0.001 without any.

    The arguments are those of :func:`boundary`, and arrays and frames give what they give there.
    """
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m}, OF_THE_SLIDER, frame)
    listed = [errors] if isinstance(errors, str) or np.ndim(errors) == 0 else errors
    asked = [f"--relative-error={exact(error, 'errors')}" for error in listed]
    if single(values, frame):
        texts = {name: exact(value, name) for name, value in values.items()}
        return Table.of_rows(tolerances(texts, asked, None))
    return table_of(frame, values, "tolerance", lambda texts, warned: tolerances(texts, asked, warned))


def tolerances(texts: Texts, asked: Sequence[str], warned: Warned | None) -> list[dict[str, Any]]:
    """Return the rows of ``slipmode tolerance``."""
    refuse_error_bars("tolerance", any(map(_slipmode.has_error_bar, texts.values())))
    rows = []
    for row in call_json("tolerance", *options(texts), *asked, warned=warned)["formulas"]:
        (limit,) = row.pop("limit").items()
        names = ("formula", "relative_error", "where")
        (value,) = [(name, number) for name, number in row.items() if name not in names]
        of_value = {"value_of": value[0], "value": value[1]}
        rows.append({name: row[name] for name in names} | of_value | {"limit_of": limit[0], "limit": limit[1]})
    return rows


def table_of(
    frame: Any, values: Mapping[str, Any], command: str, work: Callable[[Texts, Warned], list[dict[str, Any]]]
) -> Any:
    """Return the tables of several sliders as one, with the number of the row."""
    rows = Rows.of(frame, values, OF_THE_POINT)
    refuse_error_bars(command, rows.is_uncertain)
    tables = each(rows.texts(), work)
    listed = [{"row": place} | cells for place, table in enumerate(tables) for cells in table or ()]
    table = Table.of_rows(listed) if listed else Table({"row": np.zeros(0, dtype=np.int64)})
    return rows.kind.table(table, table["row"])
