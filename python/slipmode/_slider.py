"""The slider: a, b, D_c, K and M."""

from __future__ import annotations

import csv
import io
import os
import tempfile

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from decimal import Decimal
from pathlib import Path
from typing import Any, TypeGuard, Union, overload

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._classified import BoundaryTable, Categories, Classification, Classifications, Map, Possibilities
from slipmode._exact import Number, exact
from slipmode._run import call, call_json, progress, remark
from slipmode._simulated import Failed, Simulation, Simulations
from slipmode._slipmode import CheckFailed, InputError
from slipmode._table import Table

#: Points between two looks at signals and at the bar of progress.
POINTS_TOGETHER = 1 << 20
OPTIONS = {
    "a": "--direct-effect",
    "b": "--evolution-effect",
    "d_c": "--critical-slip-distance-m",
    "k": "--stiffness-pa-per-m",
    "m": "--mass-per-area-kg-per-m2",
}
STRESS, VELOCITY = "--normal-stress-pa", "--loading-velocity-m-per-s"
UNKNOWNS = {"normal_stress": STRESS, "loading_velocity": VELOCITY, "stiffness": OPTIONS["k"], "mass": OPTIONS["m"]}

#: Several numbers of 64 bits.
Arrays = Union[NDArray[Any], Sequence[float]]
Value = Union[Number, Arrays]
Signs = NDArray[np.int8]
Rates = NDArray[np.float64]
Columns = tuple[Signs, Signs, Categories, Categories, Rates, Rates, Rates]


def refuse_error_bars(command: str, is_uncertain: bool) -> None:
    """Say which command takes error bars, where a call does not."""
    if is_uncertain:
        raise InputError(f"this call takes values without error bars; `slipmode {command}` takes error bars")


@dataclass(frozen=True)
class Root:
    """A root s of eq 8, 1/s: the true one lies within ``radius`` of re + i·im."""

    re: Decimal
    im: Decimal
    radius: Decimal
    multiplicity: int

    def __complex__(self) -> complex:
        return complex(float(self.re), float(self.im))


@dataclass(frozen=True)
class Solution:
    """A solution of an inverse question, in SI."""

    value: Decimal
    #: Whether the value is exact; else all its digits are certain.
    is_exact: bool
    #: The sign of K − K_c there.
    transition_sign: int
    #: ``complex-pair``, ``real-root``, ``upper-arc`` or ``lower-arc``.
    kind: str

    def __float__(self) -> float:
        return float(self.value)


class Slider:
    """A spring-slider with rate-and-state friction.

    ``a`` and ``b`` are the direct and the evolution effect of eq 1, ``d_c`` the critical slip distance D_c in m, ``k`` the
    stiffness K in Pa/m, and ``m`` the mass per area of contact M in kg/m².

    Texts, ``Decimal``, ``Fraction`` and whole numbers are exact: ``"0.004"`` is 1/250. A float is the exact binary number that it
    is: ``0.004`` is not 1/250 but differs from it by less than 1e-18. Texts may have a unit (``"8um"``, ``"2MPa/mm"``) and an error
    bar (``"0.009±0.001"``, ``"[0.008, 0.010]"``).
    """

    def __init__(self, *, a: Number, b: Number, d_c: Number, k: Number, m: Number) -> None:
        self._texts = {"a": exact(a), "b": exact(b), "d_c": exact(d_c), "k": exact(k), "m": exact(m)}
        #: Whether a value has an error bar.
        self.is_uncertain = _slipmode.check_slider(list(self._texts.values()))

    def __repr__(self) -> str:
        return f"Slider({', '.join(f'{name}={text!r}' for name, text in self._texts.items())})"

    def _options(self, without: str | None = None) -> tuple[str, ...]:
        return tuple(f"{OPTIONS[name]}={text}" for name, text in self._texts.items() if OPTIONS[name] != without)

    def _point(self, sigma: Number, v: Number) -> tuple[str, ...]:
        return (*self._options(), f"{STRESS}={exact(sigma)}", f"{VELOCITY}={exact(v)}")

    @overload
    def classify(
        self, sigma: Number, v: Number, *, inertial_threshold: Number | None = None
    ) -> Classification | Possibilities: ...
    @overload
    def classify(self, sigma: Arrays, v: Value, *, inertial_threshold: Number | None = None) -> Classifications: ...
    @overload
    def classify(self, sigma: Number, v: Arrays, *, inertial_threshold: Number | None = None) -> Classifications: ...
    def classify(
        self, sigma: Value, v: Value, *, inertial_threshold: Number | None = None
    ) -> Classification | Classifications | Possibilities:
        """Decide stability and slip mode at the normal stresses ``sigma`` (Pa) and the loading velocities ``v`` (m/s).

        Two numbers give a :class:`Classification`, or :class:`Possibilities` if a value has an error bar. Arrays broadcast and give
        :class:`Classifications`; their values are bit for bit those of ``slipmode classify --points``. Floats are taken as the
        exact binary numbers that they are. Signs are exact. Frequencies in Hz are correctly rounded; growth rates and angular
        frequencies have a relative error below 1e-14.

        An oscillation is inertial from ω/ω_n > ``inertial_threshold``; √(1/2) without it.
        """
        texts = None if inertial_threshold is None else exact(inertial_threshold)
        if is_number(sigma) and is_number(v):
            return self._classify_point([*self._texts.values(), exact(sigma), exact(v)], texts)
        if self.is_uncertain:
            raise InputError("values with error bars are classified at one point, not at an array of points")
        stress, velocity = np.broadcast_arrays(as_floats(sigma), as_floats(v))
        return Classifications(stress, velocity, *self._columns(stress, velocity, texts))

    def _classify_point(self, values: list[str], threshold: str | None) -> Classification | Possibilities:
        answer = _slipmode.classify_point(values, threshold)
        if answer is None:
            limit = () if threshold is None else (f"--inertial-threshold={threshold}",)
            return Possibilities.of(call_json("classify", *self._point(*values[5:]), *limit))
        code, messages, fields = answer
        remark(code, messages)
        assert fields is not None  # A command without a result has raised.
        return Classification(*fields, (values, threshold))

    def _columns(self, stress: NDArray[np.float64], velocity: NDArray[np.float64], threshold: str | None) -> Columns:
        slider, shape, size = list(self._texts.values()), stress.shape, stress.size
        flat = [np.ascontiguousarray(array, dtype="<f8").ravel() for array in (stress, velocity)]
        starts = range(0, size, POINTS_TOGETHER)
        parts = []
        for start in progress(starts, len(starts)):
            stresses, velocities = (array[start : start + POINTS_TOGETHER].tobytes() for array in flat)
            parts.append(_slipmode.classify_points(slider, stresses, velocities, threshold, start))
        types = [np.int8] * 4 + [np.float64] * 3
        buffers = [bytearray().join(columns) for columns in zip(*parts)] if len(parts) != 1 else list(parts[0])
        buffers = buffers or [bytearray() for _ in types]
        arrays: list[NDArray[Any]] = [np.frombuffer(bytes_, kind).reshape(shape) for bytes_, kind in zip(buffers, types)]
        transition_sign, boundary_sign, classes, modes, growth_rate, angular_frequency, frequency = arrays
        spectral_class = Categories(classes, tuple(_slipmode.SPECTRAL_CLASSES))
        slip_mode = Categories(modes, tuple(_slipmode.SLIP_MODES))
        return transition_sign, boundary_sign, spectral_class, slip_mode, growth_rate, angular_frequency, frequency

    def map(
        self,
        sigma: tuple[Number, Number, int],
        v: tuple[Number, Number, int],
        *,
        inertial_threshold: Number | None = None,
    ) -> Map:
        """Classify a grid with equal logarithmic steps, each axis given as (from, to, number of coordinates), and draw it."""
        stresses, velocities = (f"{exact(low)}:{exact(high)}:{points}" for low, high, points in (sigma, v))
        threshold = None if inertial_threshold is None else exact(inertial_threshold)
        code, messages, grid = _slipmode.draw_grid(list(self._texts.values()), velocities, stresses, threshold)
        remark(code, messages)
        assert grid is not None  # A command without a result has raised.
        axes = (np.frombuffer(axis, "<f8").astype(np.float64) for axis in grid[:2])
        velocity, stress = np.meshgrid(*axes)
        return Map(stress, velocity, *self._columns(stress, velocity, threshold), grid[2])

    def roots(self, sigma: Number, v: Number, digits: int = 50) -> list[Root]:
        """Compute the three roots s of eq 8, 1/s, with this many certain digits of every part."""
        found = call_json("roots", *self._point(sigma, v), f"--digits={digits}")
        return [
            Root(Decimal(root["re"]), Decimal(root["im"]), Decimal(root["radius"]), root["multiplicity"])
            for root in found
        ]

    def boundary(self, n: int = 200, digits: int | None = None) -> BoundaryTable:
        """Compute the exact boundary max Im(s) = 0, with ``n`` points on each arc and the marked ones.

        The columns are those of ``slipmode boundary``. Numbers are floats, or ``Decimal`` with this many ``digits``.
        """
        refuse_error_bars("boundary", self.is_uncertain)
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder, "boundary.svg")
            options = (*self._options(), f"--points={n}", f"--svg={picture}")
            if digits is None:
                table = Table.of_rows(call_json("boundary", *options)["points"])
            else:
                rows = csv.DictReader(io.StringIO(call("boundary", *options, f"--digits={digits}")))
                words = ("arc", "asymptote", "mark")
                cells = [{k: x if k in words else Decimal(x) for k, x in row.items()} for row in rows]
                table = Table.of_rows(cells)
            return BoundaryTable(table, picture.read_text())

    def transition(self, v: float | Arrays | None = None) -> Table:
        """Compute the transition K = K_c: the normal stress at each loading velocity, where there is one.

        Without ``v``, at 200 velocities with equal logarithmic steps over those of the boundary.
        """
        if v is None:
            velocity = self.boundary(n=2)["loading_velocity_m_per_s"].astype(np.float64)
            v = np.geomspace(velocity.min(), velocity.max(), 200)
        points: list[tuple[float, float]] = []
        for each in as_floats(v).ravel().tolist():
            # With its unit, no velocity of the curve looks like another unit's.
            found = self.solve("normal_stress", transition=True, v=f"{exact(each)}m/s")
            points.extend((each, float(solution)) for solution in found)
        velocities, stresses = zip(*points) if points else ((), ())
        return Table({"loading_velocity_m_per_s": velocities, "normal_stress_pa": stresses})

    def tolerance(self, *errors: Number) -> Table:
        """Compute where each formula of the paper may be used, for these relative errors; 0.1, 0.01 and 0.001 without any."""
        refuse_error_bars("tolerance", self.is_uncertain)
        given = [f"--relative-error={exact(error)}" for error in errors]
        rows = []
        for row in call_json("tolerance", *self._options(), *given)["formulas"]:
            (limit,) = row.pop("limit").items()
            names = ("formula", "relative_error", "where")
            (value,) = [(name, number) for name, number in row.items() if name not in names]
            of_value = {"value_of": value[0], "value": value[1]}
            rows.append({name: row[name] for name in names} | of_value | {"limit_of": limit[0], "limit": limit[1]})
        return Table.of_rows(rows)

    def solve(
        self,
        unknown: str,
        *,
        sigma: Number | None = None,
        v: Number | None = None,
        frequency: Number | None = None,
        angular_frequency: Number | None = None,
        growth_rate: Number | None = None,
        transition: bool = False,
        boundary: bool = False,
        digits: int = 17,
    ) -> list[Solution]:
        """Solve for ``unknown``: ``normal_stress``, ``loading_velocity``, ``stiffness`` or ``mass``.

        One of the targets is given: a ``frequency`` (Hz), an ``angular_frequency`` or a ``growth_rate`` (1/s), the ``transition``
        or the ``boundary``. The slider's own value of what is solved for is not used.
        """
        numbers = {
            STRESS: sigma,
            VELOCITY: v,
            "--frequency": frequency,
            "--angular-frequency": angular_frequency,
            "--growth-rate": growth_rate,
        }
        options = [f"{name}={exact(number)}" for name, number in numbers.items() if number is not None]
        options += [name for name, given in (("--transition", transition), ("--boundary", boundary)) if given]
        own = self._options(without=UNKNOWNS.get(unknown))
        asked = (f"--for={unknown.replace('_', '-')}", f"--digits={digits}")
        names = ("is_exact", "transition_sign", "kind")
        found = call_json("solve", *own, *options, *asked)["solutions"]
        refuse_error_bars("solve", self.is_uncertain or any("range" in one for one in found))
        return [Solution(Decimal(one["value"]), *(one[name] for name in names)) for one in found]

    @overload
    def simulate(
        self, sigma: Number, v: Number, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulation: ...
    @overload
    def simulate(
        self, sigma: Arrays, v: Value, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulations: ...
    @overload
    def simulate(
        self, sigma: Number, v: Arrays, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulations: ...
    def simulate(
        self,
        sigma: Value,
        v: Value,
        *,
        law: str,
        rtol: Number = "1e-8",
        start: str = "steady-at-velocity",
    ) -> Simulation | Simulations:
        """Simulate the nonlinear slider with the ``law`` ``slip`` (eq 3) or ``aging`` (eq 2).

        ``rtol`` is the permitted relative error of peak velocity and period. Two numbers give a :class:`Simulation`. Arrays
        broadcast and give :class:`Simulations`, where a run that fails is :class:`Failed`. With error bars, the run is that of the
        middle values, and ``ranges`` has the sampled ranges.
        """
        common = (f"--law={law}", f"--tolerance={exact(rtol)}", f"--start={start}")
        if is_number(sigma) and is_number(v):
            return self._simulate((*self._point(sigma, v), *common))
        arrays = np.broadcast_arrays(as_floats(sigma), as_floats(v))
        points = list(zip(*(array.ravel().tolist() for array in arrays)))
        pool = ThreadPoolExecutor(max_workers=os.cpu_count())
        try:
            options = ((*self._point(*point), *common) for point in points)
            runs = list(progress(pool.map(self._attempt, options), len(points)))
        finally:
            pool.shutdown(cancel_futures=True)
        return Simulations(runs, points)

    def _simulate(self, options: tuple[str, ...]) -> Simulation:
        return Simulation.of(call_json("simulate", *options), options)

    def _attempt(self, options: tuple[str, ...]) -> Simulation | Failed:
        try:
            return self._simulate(options)
        except CheckFailed as failure:
            return Failed(str(failure))


def is_number(value: Any) -> TypeGuard[Number]:
    """Return whether a value is one number, and not an array of them."""
    return isinstance(value, str) or np.ndim(value) == 0 and not isinstance(value, np.ndarray)


def as_floats(values: Any) -> NDArray[np.float64]:
    """Return an array of 64-bit numbers; texts and exact numbers in it are refused unless they are such numbers."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError("arrays hold 64-bit numbers; classify texts, Decimal and Fraction one by one, which is exact")
    floats = array.astype(np.float64)
    if not np.array_equal(floats, array, equal_nan=array.dtype.kind == "f"):
        raise TypeError("a number of the array has more digits than a 64-bit number")
    return floats
