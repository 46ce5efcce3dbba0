"""The seven columns of a call: numbers, arrays that broadcast, or the columns of a frame."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any, Protocol, Union

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._errors import InputError
from slipmode._exact import Number, exact, given, is_of, unit
from slipmode._frames import Kind, aligned, array_of, columns_of, known, package_of
from slipmode._run import remark

#: The arguments, and their names in columns and in what commands print.
KEYS = {
    "a": "direct_effect",
    "b": "evolution_effect",
    "d_c": "critical_slip_distance_m",
    "k": "stiffness_pa_per_m",
    "m": "mass_per_area_kg_per_m2",
    "sigma": "normal_stress_pa",
    "v": "loading_velocity_m_per_s",
}
NAMES = tuple(KEYS)
SCALARS = {float, str, int, Decimal, Fraction, tuple}

class FrameColumn(Protocol):
    """A column of a frame of pandas, polars, xarray or pyarrow."""

    def to_numpy(self) -> Any: ...


#: Several numbers.
Arrays = Union[NDArray[Any], list[Any]]
Value = Union[Number, Arrays]
#: A column as the native module takes it: its name, its values, and the size in SI of its unit.
Native = tuple[str, Union[str, float, bytes, list[str]], Union[str, None]]


@dataclass(frozen=True)
class Column:
    """A column: its name in messages, one value or an array of floats or texts, and the size in SI of its unit."""

    name: str
    values: str | float | NDArray[Any]
    unit: str | None = None

    def native(self, shape: tuple[int, ...]) -> Native:
        """Return the column for rows of this shape."""
        if not isinstance(self.values, np.ndarray):
            return (self.name, self.values, self.unit)
        # NumPy takes longer for this than the rest of the call takes for a few rows.
        rows = self.values if self.values.shape == shape else np.broadcast_to(self.values, shape)
        flat = rows.ravel().tolist() if rows.dtype == object else rows.astype("<f8", copy=False).tobytes()
        return (self.name, flat, self.unit)

    def texts(self, shape: tuple[int, ...]) -> list[str]:
        """Return an exact text in SI for each row, empty where the value is missing."""
        if not isinstance(self.values, np.ndarray):
            return [exact(self.values)] * math.prod(shape)
        size = None if self.unit is None else Fraction(self.unit)
        flat = np.broadcast_to(self.values, shape).ravel().tolist()
        if self.values.dtype == object:
            return flat
        return ["" if x != x else exact(x if size is None else Fraction(x) * size) for x in flat]

    def value_of(self, row: int, shape: tuple[int, ...]) -> str | float:
        """Return the exact value in SI of a row."""
        if not isinstance(self.values, np.ndarray):
            return self.values
        value: str | float = np.broadcast_to(self.values, shape).flat[row]
        return value if self.unit is None or isinstance(value, str) else exact(Fraction(float(value)) * Fraction(self.unit))

    @property
    def is_uncertain(self) -> bool:
        """Whether a text has an error bar."""
        if isinstance(self.values, np.ndarray) and self.values.dtype == object:
            return any(map(_slipmode.has_error_bar, self.values.ravel().tolist()))
        return isinstance(self.values, str) and _slipmode.has_error_bar(self.values)

    def shown(self, shape: tuple[int, ...]) -> NDArray[Any]:
        """Return the values in SI as 64-bit numbers, or as texts where they are no plain numbers."""
        values = self.values
        if isinstance(values, np.ndarray) and values.dtype != object:
            values = values if self.unit is None else values * float(Fraction(self.unit))
        else:
            values = np.asarray(number_of(values) if isinstance(values, str) else values)
        return np.broadcast_to(values, shape)


def number_of(text: str) -> float | str:
    """Return the 64-bit number next to a text, or the text where it has a unit or an error bar."""
    try:
        return float(Fraction(text))
    except ValueError:
        return text


@dataclass(frozen=True)
class Rows:
    """The columns of a call, as many as it needs, and what its results are returned as."""

    columns: dict[str, Column]
    shape: tuple[int, ...]
    kind: Kind

    @classmethod
    def of(cls, frame: Any, values: Mapping[str, Any], unused: Sequence[str] = ()) -> Rows:
        """Return the columns of a frame, if there is one, and of values by argument; a frame may lack the ``unused`` ones."""
        frame = known(frame)
        if frame is None:
            found, kind = aligned(dict(values))
            columns = {name: of_value(name, value) for name, value in found.items()}
        else:
            kind = Kind(package_of(frame), frame, True)
            columns = of_frame(frame, values, unused)
        shapes = {column.values.shape for column in columns.values() if isinstance(column.values, np.ndarray)}
        try:
            shape = shapes.pop() if len(shapes) == 1 else np.broadcast_shapes(*shapes)
        except ValueError:
            listed = ", ".join(f"{c.name} has {c.values.shape}" for c in columns.values() if isinstance(c.values, np.ndarray))
            raise InputError(f"the shapes do not broadcast: {listed}") from None
        return cls(columns, shape, kind)

    @property
    def size(self) -> int:
        """The number of rows."""
        return math.prod(self.shape)

    @property
    def native(self) -> list[Native]:
        """All columns for the native module."""
        return [self.columns[name].native(self.shape) for name in NAMES]

    @property
    def is_uncertain(self) -> bool:
        """Whether a value has an error bar."""
        return any(column.is_uncertain for column in self.columns.values())

    def texts(self) -> list[dict[str, str] | None]:
        """Return the exact texts of each row by argument; none where one is missing."""
        texts = [column.texts(self.shape) for column in self.columns.values()]
        return [dict(zip(self.columns, row)) if all(row) else None for row in zip(*texts)]

    def values_of(self, row: int) -> tuple[str | float, ...]:
        """Return the exact values in SI of a row."""
        return tuple(column.value_of(row, self.shape) for column in self.columns.values())

    def inputs(self) -> dict[str, NDArray[Any]]:
        """Return the inputs by the names of the command line."""
        return {KEYS[name]: column.shown(self.shape) for name, column in self.columns.items()}

    @property
    def is_framed(self) -> bool:
        """Whether results are the columns of a frame, and not arrays alone."""
        return self.kind.is_frame or self.kind.package != "numpy"

    def wrap(self, results: Mapping[str, Any]) -> Any:
        """Return results as what was given."""
        return self.kind.wrap(self.inputs() if not self.kind.is_frame else {}, results)


def is_number(value: Any) -> bool:
    """Return whether a value is one number, and not an array of them."""
    if type(value) in SCALARS:
        return True
    if is_of("pint", value, "magnitude"):
        return is_number(value.magnitude)
    return not hasattr(value, "__len__") and np.ndim(value) == 0 or isinstance(value, str)


def of_value(name: str, value: Any) -> Column:
    """Return the column of an argument."""
    if is_number(value):
        return Column(name, given(value, name))
    if is_of("pint", value, "magnitude"):
        (size,) = _slipmode.exact_values([name], [f"1 {unit(value)}".rstrip()], NAMES.index(name))
        array = array_of(value.magnitude, name)
        if array.dtype != object:
            return Column(name, array, size)
        in_si = [text and exact(Fraction(text) * Fraction(size)) for text in array.ravel().tolist()]
        return Column(name, np.array(in_si, dtype=object).reshape(array.shape))
    return Column(name, array_of(value, name))


def of_frame(frame: Any, values: Mapping[str, Any], unused: Sequence[str]) -> dict[str, Column]:
    """Return the columns of a frame by the names that the command line reads, with units and columns of errors."""
    found = columns_of(frame) | {KEYS[name]: value for name, value in values.items()}
    names, keys = list(found), [KEYS[name] for name in unused]
    code, messages, places = _slipmode.table_columns(line(names).encode(), keys)
    remark(code, messages)
    assert places is not None  # A call without a result has raised.
    positions, units, errors = places
    columns: dict[str, Column] = {}
    for name, position, size in zip(NAMES, positions, units):
        if position is not None:
            values_of = found[names[position]]
            single = is_number(values_of)
            columns[name] = Column(names[position], given(values_of, names[position]) if single else array_of(values_of, names[position]), size)
    is_text = any(c.unit and isinstance(c.values, np.ndarray) and c.values.dtype == object for c in columns.values())
    return read_rows(columns, {names[i]: array_of(found[names[i]], names[i]) for i in errors}, keys) if errors or is_text else columns


def read_rows(columns: dict[str, Column], errors: dict[str, NDArray[Any]], keys: Sequence[str]) -> dict[str, Column]:
    """Return the columns with their errors, as the command line reads the rows of a file."""
    cells = {column.name: column.values for column in columns.values()} | errors
    length = max(array.size for array in cells.values() if isinstance(array, np.ndarray))
    texts = [Column(name, values).texts((length,)) for name, values in cells.items()]
    lines = (line(row) for row in zip(*texts))
    code, messages, rows = _slipmode.table_rows("".join([line(cells), *lines]).encode(), keys)
    remark(code, messages)
    assert rows is not None  # A call without a result has raised.
    read = np.array(rows, dtype=object).reshape(len(rows), len(NAMES)).T
    return {name: Column(column.name, read[NAMES.index(name)]) for name, column in columns.items()}


def line(cells: Iterable[str]) -> str:
    """Return a line of CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(cells)
    return text.getvalue()
