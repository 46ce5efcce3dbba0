"""Columns of pandas, polars, xarray and pyarrow, none of which is imported unless it is given; results of the same kind."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from slipmode._errors import InputError
from slipmode._exact import exact, is_of
from slipmode._table import Table, column, fixed, pandas_column

PACKAGES = ("pandas", "polars", "xarray", "pyarrow")
#: Up to here, every integer is a 64-bit number.
EXACT_INTEGERS = 2**53


@dataclass(frozen=True)
class Categories:
    """Words as an array of codes: ``categories[codes]``; -1 where a value is missing."""

    codes: NDArray[np.int8]
    categories: tuple[str, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "codes", fixed(self.codes))

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        # The code -1 is the last place.
        return np.asarray(np.array([*self.categories, ""], dtype=str)[self.codes], dtype=dtype)

    def __eq__(self, other: object) -> Any:
        if isinstance(other, str):
            return self.codes == (self.categories.index(other) if other in self.categories else -2)
        return np.asarray(self) == np.asarray(other)

    def __hash__(self) -> int:
        raise TypeError("categories are an array, which has no hash")

    def __getitem__(self, index: Any) -> Any:
        codes = self.codes[index]
        return Categories(codes, self.categories) if isinstance(codes, np.ndarray) else ([*self.categories, ""][codes])

    def __len__(self) -> int:
        return len(self.codes)

    def ravel(self) -> Categories:
        """Return the words along one axis."""
        return Categories(self.codes.ravel(), self.categories)

    def to_pandas(self) -> Any:
        """Return the words as a categorical of pandas."""
        import pandas

        return pandas.Categorical.from_codes(self.codes.ravel(), categories=list(self.categories))


@dataclass(frozen=True)
class Kind:
    """What results are returned as: arrays of NumPy, or what the example is."""

    #: The package; ``numpy`` for arrays.
    package: str = "numpy"
    #: A frame, or the first of the columns that were given.
    example: Any = None
    is_frame: bool = False

    def wrap(self, inputs: Mapping[str, Any], results: Mapping[str, Any]) -> Any:
        """Return the columns of a frame and results, or inputs and results; the index is kept."""
        columns = dict(results) if self.is_frame else {**inputs, **results}
        return getattr(self, f"_{self.package}")(columns)

    def table(self, columns: Mapping[str, Any], rows: NDArray[Any]) -> Any:
        """Return columns that have any number of rows for each row that was given; pandas repeats the index."""
        table = Table(columns)
        if self.package == "pandas":
            return table.to_pandas().set_index(self.example.index[rows])
        if self.package == "xarray":
            import xarray

            return xarray.Dataset({name: ("point", filled(column)) for name, column in table.items()})
        # The columns alone, as if no frame had been given.
        return getattr(Kind(self.package), f"_{self.package}")(dict(table))

    def _numpy(self, columns: dict[str, Any]) -> Table:
        if not self.is_frame:
            return Table(columns)
        shape = next(iter(columns.values())).shape
        given = {name: np.array(cells_of(values, shape), subok=True) for name, values in self.example.items()}
        return Table({**given, **columns})

    def _pandas(self, columns: dict[str, Any]) -> Any:
        import pandas

        data = {name: pandas_column(column) for name, column in columns.items()}
        if self.is_frame:
            return self.example.assign(**data)
        return pandas.DataFrame(data, index=self.example.index)

    def _polars(self, columns: dict[str, Any]) -> Any:
        import polars

        def series(name: str, column: Any) -> Any:
            if isinstance(column, Categories):
                return polars.Series(name, listed(column), dtype=polars.Enum(column.categories))
            return polars.Series(name, listed(column) if np.ma.isMA(column) or column.dtype == object else column.ravel())

        found = [series(name, column) for name, column in columns.items()]
        return self.example.with_columns(found) if self.is_frame else polars.DataFrame(found)

    def _xarray(self, columns: dict[str, Any]) -> Any:
        import xarray

        dimensions, coordinates = self.example.dims, self.example.coords
        if self.is_frame:
            first = next(iter(self.example.data_vars.values()))
            dimensions, coordinates = first.dims, first.coords
        arrays = {name: (dimensions, filled(column)) for name, column in columns.items()}
        if self.is_frame:
            return self.example.assign(arrays)
        return xarray.Dataset(arrays, coordinates)

    def _pyarrow(self, columns: dict[str, Any]) -> Any:
        import pyarrow

        def array(column: Any) -> Any:
            has_words = isinstance(column, Categories) or np.ma.isMA(column)
            return pyarrow.array(listed(column) if has_words else column.ravel())

        if not self.is_frame:
            return pyarrow.table({name: array(column) for name, column in columns.items()})
        frame = self.example
        for name, column in columns.items():
            frame = frame.append_column(name, array(column))
        return frame


def cells_of(values: Any, shape: tuple[int, ...]) -> NDArray[Any]:
    """Return a column of a mapping, or one value for all rows, as an array."""
    if isinstance(values, (str, tuple)) or not hasattr(values, "__len__"):
        one = np.empty((), dtype=object)
        one[()] = values
        return np.broadcast_to(one, shape)
    return np.broadcast_to(values if isinstance(values, np.ndarray) else column(list(values)), shape, subok=True)


def filled(column: Any) -> NDArray[Any]:
    """Return an array without a mask: integers become floats, with NaN, where a value is missing."""
    if np.ma.isMA(column):
        return np.where(np.ma.getmaskarray(column), np.nan, column.data)
    return np.array(column)


def listed(column: Any) -> list[Any]:
    """Return a column as a list, with None where a value is missing."""
    if isinstance(column, Categories):
        return [word or None for word in np.asarray(column).ravel().tolist()]
    found: list[Any] = column.ravel().tolist()
    return found


def package_of(value: object) -> str:
    """Return the package that a value is of, if it is one of those that are known; else ``numpy``."""
    package = type(value).__module__.partition(".")[0]
    return package if package in PACKAGES else "numpy"


def known(frame: Any) -> Any:
    """Return a frame whose package is not known as one of pandas, by the interchange protocol; any other as it is."""
    if not hasattr(frame, "__dataframe__") or hasattr(frame, "columns") or hasattr(frame, "column_names"):
        return frame
    import pandas

    with warnings.catch_warnings():
        # The newer protocol, of Arrow, would need pyarrow.
        warnings.simplefilter("ignore")
        return pandas.api.interchange.from_dataframe(frame)


def columns_of(frame: Any) -> dict[str, Any]:
    """Return the columns of a frame by name."""
    if hasattr(frame, "data_vars"):
        names = list(frame.data_vars)
    elif isinstance(frame, Mapping):
        names = list(frame)
    elif hasattr(frame, "columns") or hasattr(frame, "column_names"):
        names = list(getattr(frame, "column_names", None) or frame.columns)
    else:
        raise InputError(f"a {type(frame).__name__} is no frame and no mapping of columns")
    if wrong := [name for name in names if not isinstance(name, str)]:
        raise InputError(f"names of columns are texts, and {wrong[0]!r} is none")
    return {name: frame[name] for name in names}


def aligned(values: dict[str, Any]) -> tuple[dict[str, Any], Kind]:
    """Return columns of which the indices agree, and the kind of the first that is no array of NumPy."""
    examples = {name: value for name, value in values.items() if package_of(value) != "numpy"}
    if not examples:
        return values, Kind()
    first, example = next(iter(examples.items()))
    package = package_of(example)
    for name, value in examples.items():
        if package_of(value) != package:
            raise InputError(f"{first} is of {package} and {name} of {package_of(value)}: give columns of one package")
        if package == "pandas" and not value.index.equals(example.index):
            raise InputError(f"{first} and {name} have different indices: align them, or give arrays")
    if package == "xarray":
        import xarray

        broadcast = xarray.broadcast(*examples.values())
        return values | dict(zip(examples, broadcast)), Kind(package, broadcast[0])
    return values, Kind(package, example)


def array_of(values: Any, name: str) -> NDArray[Any]:
    """Return an array of 64-bit numbers, NaN where a value is missing; or of exact texts, empty where one is missing.

    Values that 64-bit numbers would round are texts. Messages have the name.
    """
    array = cells_array(values, name)
    mask = np.ma.getmaskarray(array) if isinstance(array, np.ma.MaskedArray) else None
    plain = np.asarray(array)
    if plain.dtype.kind in "fiu":
        with np.errstate(over="ignore"):
            floats = plain.astype(np.float64)
        if has_all(floats, plain):
            return floats if mask is None else np.where(mask, np.nan, floats)
    elif plain.dtype.kind not in "OUST":
        raise InputError(f"{name}: an array of {plain.dtype} has no numbers")
    texts = np.empty(plain.shape, dtype=object)
    cells = plain.astype(object).ravel().tolist()
    hidden = [False] * len(cells) if mask is None else mask.ravel().tolist()
    missing = [out or is_missing(cell) for cell, out in zip(cells, hidden)]
    if all(out or isinstance(cell, float) for cell, out in zip(cells, missing)):
        numbers = [np.nan if out else cell for cell, out in zip(cells, missing)]
        return np.array(numbers, dtype=np.float64).reshape(plain.shape)
    each = enumerate(zip(cells, missing))
    texts.ravel()[:] = ["" if out else exact(cell, f"{name}[{row}]") for row, (cell, out) in each]
    return texts


def cells_array(values: Any, name: str) -> NDArray[Any]:
    """Return values as an array that NumPy does not round: of objects where the values have different types."""
    if not isinstance(values, (list, tuple)):
        array: NDArray[Any] = values if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
        kind = str(getattr(values, "dtype", None) or getattr(values, "type", "")).lower()
        if array.dtype.kind != "f" or "int" not in kind or not (np.abs(array) >= EXACT_INTEGERS).any():
            return array
        # Missing values have made floats of integers.
        values = (getattr(values, "to_list", None) or values.to_pylist)()
    try:
        if all(isinstance(each, float) or isinstance(each, np.ndarray) and each.dtype == np.float64 for each in values):
            return np.asarray(values, dtype=np.float64)
        if isinstance(values[0], (list, np.ndarray)):
            return np.array(values, dtype=object)
    except ValueError:
        raise InputError(f"{name}: the rows have different lengths") from None
    array = np.empty(len(values), dtype=object)
    for place, cell in enumerate(values):
        array[place] = cell
    return array


def has_all(floats: NDArray[np.float64], plain: NDArray[Any]) -> bool:
    """Return whether 64-bit numbers are the values of an array."""
    if plain.dtype.kind == "f":
        return plain.dtype.itemsize <= 8 or np.array_equal(floats, plain, equal_nan=True)
    ends = (plain.min(), plain.max()) if plain.size and plain.dtype.itemsize == 8 else ()
    return all(abs(int(end)) <= EXACT_INTEGERS for end in ends)


def is_missing(cell: Any) -> bool:
    """Return whether a cell of a column has no value."""
    if cell is None or isinstance(cell, (float, np.floating)) and cell != cell:
        return True
    return is_of("pandas", cell, "__bool__") and cell is sys.modules["pandas"].NA
