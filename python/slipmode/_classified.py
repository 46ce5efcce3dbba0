"""What ``classify`` returns: one point, arrays of points, error bars, or a map."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._table import Table, html_table

if TYPE_CHECKING:
    import pandas
    import xarray


@dataclass(frozen=True)
class Categories:
    """Words as an array of codes: ``categories[codes]``."""

    codes: NDArray[np.int8]
    categories: tuple[str, ...]

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        return np.asarray(np.array(self.categories, dtype=str)[self.codes], dtype=dtype)

    def __eq__(self, other: object) -> Any:
        if isinstance(other, str):
            code = self.categories.index(other) if other in self.categories else -1
            return self.codes == code
        return np.asarray(self) == np.asarray(other)

    def __hash__(self) -> int:
        raise TypeError("categories are an array, which has no hash")

    def __getitem__(self, index: Any) -> Any:
        codes = self.codes[index]
        return Categories(codes, self.categories) if isinstance(codes, np.ndarray) else self.categories[codes]

    def __len__(self) -> int:
        return len(self.codes)

    def to_pandas(self) -> pandas.Categorical:
        """Return the words as a categorical of pandas."""
        import pandas

        return pandas.Categorical.from_codes(self.codes.ravel().tolist(), categories=list(self.categories))


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
    _question: tuple[list[str], str | None] = field(repr=False)

    @cached_property
    def details(self) -> dict[str, Any]:
        """The object that ``slipmode classify --json`` prints; it is computed when it is read."""
        found: dict[str, Any] = json.loads(_slipmode.describe_point(*self._question))
        return found

    def __eq__(self, other: object) -> bool:
        return self.details == other.details if isinstance(other, Classification) else NotImplemented

    #: The object has a dictionary.
    __hash__ = None  # type: ignore[assignment]

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

    def _repr_html_(self) -> str:
        sure = "certain" if self.certain else "possible"
        rows = [[mode, str(witness or "")] for mode, witness in zip(self.slip_modes, self.witnesses)]
        return html_table([f"{sure} slip mode", "at"], rows)


@dataclass(frozen=True, repr=False)
class Classifications:
    """Arrays of points, of the shape to which normal stresses and loading velocities broadcast."""

    #: σ, Pa.
    normal_stress: NDArray[np.float64]
    #: V0, m/s.
    loading_velocity: NDArray[np.float64]
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

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of every array."""
        return self.transition_sign.shape

    def _columns(self) -> dict[str, Any]:
        return {
            "normal_stress_pa": self.normal_stress,
            "loading_velocity_m_per_s": self.loading_velocity,
            "transition_sign": self.transition_sign,
            "boundary_sign": self.boundary_sign,
            "spectral_class": self.spectral_class,
            "slip_mode": self.slip_mode,
            "max_real_per_s": self.growth_rate,
            "max_imaginary_per_s": self.angular_frequency,
        }

    def to_dataframe(self) -> pandas.DataFrame:
        """Return a row for each point, with the column names of the command line; words are categories."""
        import pandas

        flat = {
            name: column.to_pandas() if isinstance(column, Categories) else column.ravel()
            for name, column in self._columns().items()
        }
        return pandas.DataFrame(flat)

    def to_xarray(self) -> xarray.Dataset:
        """Return a data set with a variable for each column; an axis along which one input varies alone has it as coordinate."""
        import xarray

        columns = self._columns()
        inputs = {name: columns.pop(name) for name in ("normal_stress_pa", "loading_velocity_m_per_s")}
        names = [f"dim_{axis}" for axis in range(len(self.shape))]
        coordinates: dict[str, Any] = {}
        for name, values in inputs.items():
            axes = [axis for axis in range(values.ndim) if not np.array_equal(values, first_along(values, axis))]
            if len(axes) == 1 and names[axes[0]].startswith("dim_"):
                (axis,) = axes
                names[axis] = name
                coordinates[name] = values[tuple(slice(None) if i == axis else 0 for i in range(values.ndim))]
            else:
                columns[name] = values
        return xarray.Dataset({name: (names, np.asarray(array)) for name, array in columns.items()}, coordinates)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of shape {self.shape}: {self._counts()}>"

    def _counts(self) -> dict[str, int]:
        counts = np.bincount(self.slip_mode.codes.ravel(), minlength=len(self.slip_mode.categories))
        return {mode: int(count) for mode, count in zip(self.slip_mode.categories, counts) if count}

    def _repr_html_(self) -> str:
        rows = [[mode, str(count)] for mode, count in self._counts().items()]
        return html_table(["slip mode", "points"], rows)


@dataclass(frozen=True, repr=False)
class Map(Classifications):
    """A grid of normal stresses (first axis) and loading velocities (second axis), with a picture."""

    #: The picture of the slip modes.
    svg: str

    def _repr_svg_(self) -> str:
        return self.svg


def first_along(values: NDArray[Any], axis: int) -> NDArray[Any]:
    """Return the array with its first entry along an axis everywhere along it."""
    return np.broadcast_to(np.take(values, [0], axis=axis), values.shape)


class BoundaryTable(Table):
    """Points of the boundary max Im(s) = 0, with a picture."""

    def __init__(self, columns: Any, svg: str) -> None:
        super().__init__(columns)
        #: The picture of the boundary with its asymptotes and the transition.
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg
