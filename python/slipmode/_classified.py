"""What ``classify`` returns: one point, arrays of points, error bars, or a map."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._exact import exact
from slipmode._frames import Categories, filled
from slipmode._table import Table, axes, fixed, html_table, pandas_column, series

if TYPE_CHECKING:
    import pandas
    import xarray

    from slipmode._rows import Rows
    from matplotlib.axes import Axes

#: The attributes of points that are numbers.
NUMBERS = ("growth_rate", "angular_frequency", "frequency")


@dataclass(frozen=True, eq=False)
class Classification:
    """A point: what small disturbances of steady sliding do."""

    #: The sign of K − K_c: 1 is linearly stable, 0 on the transition, -1 unstable.
    transition_sign: int
    #: The sign of the discriminant: 1 means real roots, -1 a complex pair, 0 the boundary max Im(s) = 0.
    boundary_sign: int
    #: The spectral class.
    spectral_class: str
    #: The slip mode.
    slip_mode: str
    #: max Re(s), 1/s.
    growth_rate: float
    #: max Im(s), 1/s; 0 exactly when no root is complex.
    angular_frequency: float
    #: max Im(s)/2π, Hz, correctly rounded; NaN beyond the range of 64-bit numbers.
    frequency: float = field(repr=False)
    _question: tuple[tuple[str | float, ...], str | None] = field(repr=False, compare=False)

    @cached_property
    def details(self) -> dict[str, Any]:
        """The object that ``slipmode classify --json`` prints; it is computed when it is read."""
        values, threshold = self._question
        found: dict[str, Any] = json.loads(_slipmode.describe_point([exact(value) for value in values], threshold))
        return found

    def __eq__(self, other: object) -> bool:
        return self.details == other.details if isinstance(other, Classification) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.slip_mode, self.growth_rate, self.angular_frequency))

    def to_pandas(self) -> pandas.Series[Any]:
        """Return the values by the names of the command line."""
        return series(self.details)

    def _repr_html_(self) -> str:
        shown = {name: value for name, value in self.details.items() if isinstance(value, (int, float, str))}
        return html_table(["quantity", "value"], [[name, str(value)] for name, value in shown.items()])


@dataclass(frozen=True)
class Possibilities:
    """All that is possible within error bars."""

    #: Whether all values within the error bars have one slip mode.
    certain: bool
    #: The slip modes that are possible.
    slip_modes: tuple[str, ...]
    #: An exact point for each slip mode: the seven inputs as texts; none where it is not rational.
    witnesses: tuple[dict[str, str] | None, ...]
    #: The least and the greatest sign of K − K_c.
    transition_signs: tuple[int, int]
    #: The least and the greatest sign of the discriminant.
    boundary_signs: tuple[int, int]
    #: The share of the box, at most, in which the slip mode is not decided.
    undecided_share: float
    #: The object that ``slipmode classify --json`` prints.
    details: dict[str, Any] = field(repr=False)

    @classmethod
    def of(cls, found: dict[str, Any]) -> Possibilities:
        """Return what is possible according to an object of the command line."""
        modes = found["slip_modes"]
        transition, boundary = found["transition_signs"], found["boundary_signs"]
        return cls(
            certain=found["certain"],
            slip_modes=tuple(possible["mode"] for possible in modes),
            witnesses=tuple(possible["witness"] for possible in modes),
            transition_signs=(transition[0], transition[1]),
            boundary_signs=(boundary[0], boundary[1]),
            undecided_share=found["undecided_share"],
            details=found,
        )

    def to_pandas(self) -> pandas.Series[Any]:
        """Return the values by the names of the command line."""
        return series(self.details)

    def _repr_html_(self) -> str:
        sure = "certain" if self.certain else "possible"
        rows = [[mode, str(witness or "")] for mode, witness in zip(self.slip_modes, self.witnesses)]
        return html_table([f"{sure} slip mode", "at"], rows)


@dataclass(frozen=True, repr=False, eq=False)
class Classifications(Sequence["Classification | None"]):
    """Points of the shape to which the inputs broadcast: an array for each result, and a :class:`Classification` for each index.

    Where a value is missing, signs are masked, words are empty, numbers are NaN, and the point is ``None``.
    """

    #: The signs of K − K_c: 1 is linearly stable.
    transition_sign: NDArray[np.int8]
    #: The signs of the discriminant: -1 is a complex pair.
    boundary_sign: NDArray[np.int8]
    #: The spectral classes.
    spectral_class: Categories
    #: The slip modes.
    slip_mode: Categories
    #: max Re(s), 1/s; NaN beyond the range of 64-bit numbers.
    growth_rate: NDArray[np.float64]
    #: max Im(s), 1/s; 0 exactly where no root is complex, NaN beyond the range of 64-bit numbers.
    angular_frequency: NDArray[np.float64]
    #: max Im(s)/2π, Hz, correctly rounded; NaN beyond the range of 64-bit numbers.
    frequency: NDArray[np.float64]
    _rows: Rows
    _threshold: str | None
    _part: NDArray[np.int64] | None = None

    def __post_init__(self) -> None:
        for name in ("transition_sign", "boundary_sign", *NUMBERS):
            object.__setattr__(self, name, fixed(getattr(self, name)))

    @cached_property
    def _places(self) -> NDArray[np.int64]:
        """The rows of the call that the points are."""
        return np.arange(self._rows.size).reshape(self._rows.shape) if self._part is None else self._part

    @cached_property
    def inputs(self) -> dict[str, NDArray[Any]]:
        """The inputs in SI by the names of the command line: 64-bit numbers, or texts where they are no plain numbers."""
        inputs = self._rows.inputs()
        if self._part is None:
            return inputs
        return {name: fixed(array.ravel()[self._part]) for name, array in inputs.items()}

    @property
    def normal_stress(self) -> NDArray[Any]:
        """σ, Pa."""
        return self.inputs["normal_stress_pa"]

    @property
    def loading_velocity(self) -> NDArray[Any]:
        """V0, m/s."""
        return self.inputs["loading_velocity_m_per_s"]

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of every array."""
        return self.transition_sign.shape

    def __len__(self) -> int:
        return len(self.transition_sign)

    def __getitem__(self, index: Any) -> Any:
        """Return the point of an index, or the points of a slice or an array of indices."""
        names = ("transition_sign", "boundary_sign", "spectral_class", "slip_mode", *NUMBERS)
        results: list[Any] = [getattr(self, name)[index] for name in names]
        places = self._places[index]
        if isinstance(places, np.ndarray):
            results += [self._rows, self._threshold, places]
            return Classifications(*results)
        if not results[3]:
            return None
        question = (self._rows.values_of(int(places)), self._threshold)
        fields: list[Any] = [*map(int, results[:2]), *results[2:4], *map(float, results[4:]), question]
        return Classification(*fields)

    def results(self) -> dict[str, Any]:
        """Return the results by the names of the command line."""
        found, _ = computed(self._rows, self._threshold, True)
        return found if self._part is None else {name: column.ravel()[self._part] for name, column in found.items()}

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each point, with the column names of the command line; words are categories."""
        import pandas

        columns = {**self.inputs, **self.results()}
        return pandas.DataFrame({name: pandas_column(column) for name, column in columns.items()})

    def to_dataframe(self) -> pandas.DataFrame:
        """Return :meth:`to_pandas`."""
        return self.to_pandas()

    def to_xarray(self) -> xarray.Dataset:
        """Return a data set with a variable for each column; an axis along which one input varies alone has it as coordinate."""
        import xarray

        columns = self.results()
        names = [f"dim_{axis}" for axis in range(len(self.shape))]
        coordinates: dict[str, Any] = {}
        for name, values in self.inputs.items():
            axes = [axis for axis in range(values.ndim) if not np.array_equal(values, first_along(values, axis))]
            if len(axes) == 1 and names[axes[0]].startswith("dim_"):
                (axis,) = axes
                names[axis] = name
                coordinates[name] = values[tuple(slice(None) if i == axis else 0 for i in range(values.ndim))]
            else:
                columns[name] = values
        return xarray.Dataset({name: (names, filled(array)) for name, array in columns.items()}, coordinates)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of shape {self.shape}: {self._counts()}>"

    def _counts(self) -> dict[str, int]:
        codes = self.slip_mode.codes.ravel()
        counts = np.bincount(codes[codes >= 0], minlength=len(self.slip_mode.categories))
        return {mode: int(count) for mode, count in zip(self.slip_mode.categories, counts) if count}

    def _repr_html_(self) -> str:
        rows = [[mode, str(count)] for mode, count in self._counts().items()]
        return html_table(["slip mode", "points"], rows)


@dataclass(frozen=True, repr=False, eq=False)
class Map(Classifications):
    """A grid of normal stresses (first axis) and loading velocities (second axis), with a picture."""

    #: The picture of the slip modes.
    svg: str = ""

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the slip modes with matplotlib; return the axes. ``svg`` has a picture that does not need matplotlib."""
        from matplotlib.colors import ListedColormap

        ax = axes(ax, "loading velocity (m/s)", "normal stress (Pa)")
        found = np.unique(self.slip_mode.codes)
        colours = ListedColormap([f"C{place}" for place in range(len(found))])
        places = np.searchsorted(found, self.slip_mode.codes)
        mesh = ax.pcolormesh(self.loading_velocity, self.normal_stress, places, cmap=colours, shading="nearest")
        mesh.set_clim(-0.5, len(found) - 0.5)
        bar = ax.figure.colorbar(mesh, ax=ax, ticks=range(len(found)))
        bar.ax.set_yticklabels([self.slip_mode.categories[code] for code in found])
        return ax

    def _repr_svg_(self) -> str:
        return self.svg


def computed(rows: Rows, threshold: str | None, is_whole: bool) -> tuple[dict[str, Any], str]:
    """Return the results by the names of the command line, and a warning or nothing; not all results unless ``is_whole``."""
    buffer, warning = _slipmode.classify_points(rows.native, rows.size, threshold, is_whole)
    count, names = (6, OF_A_POINT) if is_whole else (3, OF_A_POINT[:6] + OF_A_POINT[7:8])
    numbers = np.frombuffer(buffer, "<f8", count * rows.size).reshape(count, *rows.shape)
    kinds = len(names) - count
    codes = np.frombuffer(buffer, np.int8, kinds * rows.size, numbers.nbytes).reshape(kinds, *rows.shape)
    missing = codes[3] < 0
    signs = [np.ma.array(sign, mask=missing) if missing.any() else sign for sign in codes[:2]]
    words = map(Categories, codes[2:], WORDS)
    columns = [*signs, next(words), next(words), *numbers[:2], *words, *numbers[2:]]
    return dict(zip(names, columns)), warning


#: The results of points by the names of the command line, in its order.
OF_A_POINT = tuple(_slipmode.RESULT_COLUMNS)
#: The words of spectral classes, slip modes and precision levels.
WORDS = (tuple(_slipmode.SPECTRAL_CLASSES), tuple(_slipmode.SLIP_MODES), tuple(_slipmode.PRECISION_LEVELS))


def first_along(values: NDArray[Any], axis: int) -> NDArray[Any]:
    """Return the array with its first entry along an axis everywhere along it."""
    return np.broadcast_to(np.take(values, [0], axis=axis), values.shape)


class BoundaryTable(Table):
    """Points of the boundary max Im(s) = 0, or of the line of an ω/ω_n, with a picture."""

    def __init__(self, columns: Any, svg: str) -> None:
        super().__init__(columns)
        #: The picture of the boundary with its asymptotes and the transition.
        self.svg = svg

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the line with matplotlib, or its arcs; return the axes. ``svg`` has a picture that does not need matplotlib."""
        ax = axes(ax, "loading velocity (m/s)", "normal stress (Pa)")
        lines = self["arc"] if "arc" in self else np.full(self.rows, "frequency ratio")
        for line in dict.fromkeys(lines):
            on_line = lines == line
            points = (self[name][on_line].astype(float) for name in ("loading_velocity_m_per_s", "normal_stress_pa"))
            ax.plot(*points, label=f"{line} arc" if "arc" in self else line)
        ax.legend()
        return ax

    def _repr_svg_(self) -> str:
        return self.svg
