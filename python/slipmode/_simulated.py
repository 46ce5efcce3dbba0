"""What ``simulate`` returns: runs of the nonlinear slider with their errors."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from numpy.typing import NDArray

from slipmode._exact import Number, exact
from slipmode._run import call
from slipmode._table import Table, axes, columns_of_csv, fixed, html_table, series

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes


#: What has a range over error bars.
RANGES = ("peak_velocity_m_per_s", "minimum_velocity_log10_ratio", "period_s", "stress_drop_pa", "frequency_hz")

#: Keys of the command line's object that are no cells.
NOT_IN_TABLES = ("schema", "inputs", "within_error_bars")


@dataclass(frozen=True)
class Observable:
    """A computed value with its estimated absolute error, in the same unit."""

    value: float
    error: float
    unit: str

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return f"{self.value:.10g} ± {self.error:.2g} {self.unit}".strip()


@dataclass(frozen=True)
class Simulation:
    """A run from its start to its long-term behaviour."""

    #: ``periodic`` or ``decaying``.
    mode: str
    #: The slip mode, from the trajectory alone.
    slip_mode: str
    #: The peak velocity, m/s: of the cycle, or of the transient of a decaying run.
    peak_velocity: Observable
    #: log10 of the minimum velocity over V0.
    minimum_velocity_log10_ratio: Observable
    #: Largest minus least spring stress, Pa: of the cycle, or of a decaying run from its start to steady sliding, where it may only rise.
    stress_drop: Observable
    #: The period, s; none if nothing oscillates.
    period: Observable | None
    #: The frequency, Hz; none if nothing oscillates.
    frequency: Observable | None
    #: The object that ``slipmode simulate --json`` prints.
    details: dict[str, Any] = field(repr=False)
    _options: tuple[str, ...] = field(repr=False, compare=False)

    @classmethod
    def of(cls, found: dict[str, Any], options: tuple[str, ...]) -> Simulation:
        """Return the simulation of an object of the command line, made with these options."""

        def observable(name: str, relative_error: str, unit: str) -> Observable | None:
            value = found[name]
            return None if value is None else Observable(value, abs(value) * found[relative_error], unit)

        def present(name: str, relative_error: str, unit: str) -> Observable:
            return Observable(found[name], abs(found[name]) * found[relative_error], unit)

        minimum, error = found["minimum_velocity_log10_ratio"], found["minimum_velocity_log10_error"]
        return cls(
            mode=found["mode"],
            slip_mode=found["slip_mode"],
            peak_velocity=present("peak_velocity_m_per_s", "peak_relative_error", "m/s"),
            minimum_velocity_log10_ratio=Observable(minimum, error, ""),
            stress_drop=present("stress_drop_pa", "stress_drop_relative_error", "Pa"),
            period=observable("period_s", "period_relative_error", "s"),
            frequency=observable("frequency_hz", "period_relative_error", "Hz"),
            details=found,
            _options=options,
        )

    @property
    def ranges(self) -> dict[str, tuple[float, float]] | None:
        """The ranges over the error bars in SI, by name; none without error bars.

        They are sampled: ``details["within_error_bars"]`` has the number of runs, the modes that occur, and what the linear theory
        decides exactly. The other fields are those of the middle values.
        """
        found = self.details.get("within_error_bars")
        if found is None:
            return None
        return {name: (ends[0], ends[1]) for name in RANGES if (ends := found[name]) is not None}

    def trajectory(self, duration: Number | None = None, samples: int | None = None) -> Trajectory:
        """Return the run from its start.

        ``duration`` is in seconds; without it, ten periods. ``samples`` are at equal steps of time; without it, eight in each step
        of the integrator.
        """
        extent = () if duration is None else ("--duration-s", exact(duration, "duration"))
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder, "trajectory.svg")
            sampled = () if samples is None else ("--samples", str(samples))
            text = call("simulate", *self._options, "--trajectory", "-", "--svg", str(picture), *extent, *sampled)
            svg = picture.read_text()
        return Trajectory(columns_of_csv(text), svg)

    def cells(self) -> dict[str, Any]:
        """Return the values by the names of the command line, and the ends of ranges."""
        row = {name: value for name, value in self.details.items() if name not in NOT_IN_TABLES}
        for name, (low, high) in (self.ranges or {}).items():
            row |= {f"{name}_low": low, f"{name}_high": high}
        return row

    def to_pandas(self) -> pandas.Series[Any]:
        """Return the values by the names of the command line, and the ends of ranges."""
        return series(self.cells())

    def __hash__(self) -> int:
        return hash((self.mode, self.slip_mode, self.peak_velocity))

    def _repr_html_(self) -> str:
        names = ("peak_velocity", "period", "frequency", "stress_drop", "minimum_velocity_log10_ratio")
        rows = [["mode", self.mode], ["slip mode", self.slip_mode]]
        rows += [[name.replace("_", " "), str(getattr(self, name) or "none")] for name in names]
        for name, (low, high) in (self.ranges or {}).items():
            rows.append([f"{name} within error bars, sampled", f"{low:.6g} to {high:.6g}"])
        return html_table(["observable", "value ± error"], rows)


class Trajectory(Table):
    """Samples of a run: time, velocity, state variable, shear stress relative to steady sliding, and slip since the start."""

    def __init__(self, columns: Any, svg: str) -> None:
        super().__init__(columns)
        #: The picture of velocity, shear stress and slip against time.
        self.svg = svg

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw the velocity against time with matplotlib; return the axes. ``svg`` has a picture that does not need matplotlib."""
        ax = axes(ax, "time (s)", "velocity (m/s)", "linear")
        ax.set_yscale("log")
        ax.plot(self["time_s"], self["velocity_m_per_s"])
        return ax

    def _repr_svg_(self) -> str:
        return self.svg


@dataclass(frozen=True)
class Failed:
    """A run of several that has no result, and why."""

    reason: str


class Simulations(Sequence["Simulation | Failed"]):
    """Runs of several points, in their order."""

    def __init__(self, runs: Sequence[Simulation | Failed], inputs: Mapping[str, NDArray[Any]]) -> None:
        self._runs = tuple(runs)
        #: The inputs, by the names of the command line.
        self.inputs = {name: fixed(array) for name, array in inputs.items()}

    @overload
    def __getitem__(self, index: int) -> Simulation | Failed: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Simulation | Failed]: ...
    def __getitem__(self, index: int | slice) -> Simulation | Failed | Sequence[Simulation | Failed]:
        return self._runs[index]

    def __len__(self) -> int:
        return len(self._runs)

    def __iter__(self) -> Iterator[Simulation | Failed]:
        return iter(self._runs)

    def rows(self) -> list[dict[str, Any]]:
        """Return the results of each run, with the column names of the command line, and the ends of ranges."""
        rows = []
        for run in self._runs:
            row: dict[str, Any] = {"status": run.reason} if isinstance(run, Failed) else run.cells() | {"status": "ok"}
            rows.append(row)
        return rows

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each run: its inputs and its results."""
        import pandas

        results = pandas.DataFrame(self.rows())
        return pandas.concat([pandas.DataFrame(self.inputs), results], axis=1)

    def to_dataframe(self) -> pandas.DataFrame:
        """Return :meth:`to_pandas`."""
        return self.to_pandas()

    def __repr__(self) -> str:
        failed = sum(isinstance(run, Failed) for run in self._runs)
        return f"<Simulations: {len(self)} runs, {failed} of them without a result>"

    def _repr_html_(self) -> str:
        def cells(run: Simulation | Failed) -> dict[str, Any]:
            if isinstance(run, Failed):
                return {"mode": run.reason, "slip mode": "", "peak velocity": "", "period": ""}
            return {"mode": run.mode, "slip mode": run.slip_mode, "peak velocity": run.peak_velocity, "period": run.period}

        return Table.of_rows([{"run": row} | cells(run) for row, run in enumerate(self)])._repr_html_()
