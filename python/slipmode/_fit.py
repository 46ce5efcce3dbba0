"""What ``fit`` returns: friction parameters of a record of velocity steps, with errors and intervals."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._exact import Number, exact, flag
from slipmode._run import in_records, remark
from slipmode._simulated import Observable
from slipmode._slider import Slider
from slipmode._errors import InputError
from slipmode._table import Table, columns_of_csv, html_table, write_csv

if TYPE_CHECKING:
    import pandas
    import polars

Record = Union[str, "os.PathLike[str]", Mapping[str, Any], "pandas.DataFrame", "polars.DataFrame"]

#: Units of the fitted values, by the names of the command line.
UNITS = {
    "direct_effect": "",
    "evolution_effect": "",
    "critical_slip_distance_m": "m",
    "stiffness_pa_per_m": "Pa/m",
    "reference_friction": "",
    "drift_per_m": "1/m",
}


@dataclass(frozen=True)
class FittedValue(Observable):
    """A fitted value with one standard error and its 95 % interval, all in the same unit."""

    #: The lower end of the 95 % interval by profile likelihood; none if the record sets no bound.
    low: float | None
    #: The upper end.
    high: float | None

    def __str__(self) -> str:
        value, interval = _slipmode.fitted_words(self.value, self.error, self.low, self.high, self.unit)
        return f"{value} (95 %: {interval})"


@dataclass(frozen=True)
class Residuals:
    """The friction of the record less that of the fit, as numbers."""

    #: The standard deviation of one residual, which estimates the noise of the friction.
    standard_deviation: float
    #: The correlation of neighbouring residuals; near 0 for independent noise.
    autocorrelation: float
    #: The factor by which the correlation enlarges the variances of the fitted values; 1 without a significant correlation.
    variance_inflation: float


@dataclass(frozen=True)
class LawComparison:
    """The other evolution law on the same record."""

    #: The law that fits less well, ``slip`` or ``aging``.
    other_law: str
    #: The standard deviation of its residuals.
    other_residual_standard_deviation: float
    #: The logarithm of the likelihood of the better law over that of the other.
    log_likelihood_ratio: float
    #: This logarithm over its standard deviation (Vuong, 1989). Above 1.96, the record distinguishes the laws (95 % confidence).
    vuong: float


@dataclass(frozen=True)
class Fit:
    """Friction parameters of a record of velocity steps, from the nonlinear slider by least squares."""

    #: The evolution law that fits better, or the one that was requested: ``slip`` (eq 3) or ``aging`` (eq 2).
    law: str
    #: a of eq 1.
    direct_effect: FittedValue
    #: b of eq 1.
    evolution_effect: FittedValue
    #: The critical slip distance D_c of eqs 1 to 3, m.
    critical_slip_distance_m: FittedValue
    #: The stiffness K of eq 4, Pa/m; none if it was given.
    stiffness_pa_per_m: FittedValue | None
    #: The friction of steady sliding at the load-point velocity before the first step.
    reference_friction: FittedValue
    #: The change of friction in proportion to the load-point displacement, 1/m; none if it was not fitted.
    drift_per_m: FittedValue | None
    #: The correlations of the errors of two values, by their names in the order of the fields above.
    correlations: dict[tuple[str, str], float] = field(repr=False)
    #: The noise of the friction.
    residuals: Residuals
    #: Rows within the first D_c of load-point displacement after a step, of the step with the fewest.
    points_per_slip_distance: float
    #: How much better the law fits than the other one; none if one law was requested, or if the other does not fit.
    law_comparison: LawComparison | None
    #: The shares of slip modes among sliders drawn with the errors and correlations of the fit (sampled); none without a mass.
    slip_modes: dict[str, float] | None
    #: What the record does not determine, in sentences.
    remarks: tuple[str, ...]
    #: ``time_s``, ``load_point_displacement_m``, ``friction``, ``fitted_friction`` and ``residual`` of each row.
    fitted: Table = field(repr=False, compare=False)
    #: The picture of the record, the fit and the residuals.
    svg: str = field(repr=False)
    _found: dict[str, Any] = field(repr=False)

    @classmethod
    def of(cls, found: dict[str, Any], fitted: Table, svg: str) -> Fit:
        """Return the fit of an object that the command line printed."""
        values = {
            name: FittedValue(one["value"], one["error"], unit, one["low"], one["high"])
            for name, unit in UNITS.items()
            if (one := found.get(name)) is not None
        }
        noise = ("residual_standard_deviation", "residual_autocorrelation", "variance_inflation")
        comparison, modes = found.get("law_comparison"), found.get("slip_modes")
        pairs = ((tuple(names.split(",")), value) for names, value in found["correlations"].items())
        order = list(UNITS).index
        return cls(
            law=found["law"],
            direct_effect=values["direct_effect"],
            evolution_effect=values["evolution_effect"],
            critical_slip_distance_m=values["critical_slip_distance_m"],
            stiffness_pa_per_m=values.get("stiffness_pa_per_m"),
            reference_friction=values["reference_friction"],
            drift_per_m=values.get("drift_per_m"),
            correlations=dict(sorted(pairs, key=lambda pair: [order(name) for name in pair[0]])),
            residuals=Residuals(*(found[name] for name in noise)),
            points_per_slip_distance=found["points_per_slip_distance"],
            law_comparison=None if comparison is None else LawComparison(**comparison),
            slip_modes=None if modes is None else {each["mode"]: each["share"] for each in modes},
            remarks=tuple(in_records(remark, "record") for remark in found["remarks"]),
            fitted=fitted,
            svg=svg,
            _found=found,
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the object that ``slipmode fit --json`` prints."""
        return dict(self._found)

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each fitted value: value, error, and the ends of its 95 % interval."""
        import pandas

        found = {name: value for name in UNITS if (value := getattr(self, name)) is not None}
        return pandas.DataFrame.from_dict({name: vars(value) for name, value in found.items()}, orient="index")

    def slider(self) -> Slider:
        """Return the slider whose error bars are the 95 % intervals.

        The stiffness is the fitted or the given one. The fit needs ``mass_per_area_kg_per_m2``. The error bars do not have the
        correlations of the fit: the box of all values within them contains values that the record excludes.
        """
        given = self._found["inputs"]
        mass = given["mass_per_area_kg_per_m2"]
        if mass is None:
            raise InputError("a slider needs mass_per_area_kg_per_m2")
        stiffness = self.stiffness_pa_per_m
        return Slider(
            a=interval("direct_effect", self.direct_effect),
            b=interval("evolution_effect", self.evolution_effect),
            d_c=interval("critical_slip_distance_m", self.critical_slip_distance_m),
            k=repr(given["stiffness_pa_per_m"]) if stiffness is None else interval("stiffness_pa_per_m", stiffness),
            m=repr(mass),
        )

    def plot(self, ax: NDArray[np.object_] | None = None) -> NDArray[np.object_]:
        """Draw the record with the fit, and the residuals below, with matplotlib; return both axes.

        ``ax`` are two axes to draw on. ``svg`` has a picture that does not need matplotlib.
        """
        from matplotlib import pyplot

        axes = ax
        if axes is None:
            _, axes = pyplot.subplots(2, sharex=True, layout="constrained", height_ratios=(2, 1))
        way, deviation = 1e6 * self.fitted["load_point_displacement_m"], self.residuals.standard_deviation
        axes[0].plot(way, self.fitted["friction"], ".", markersize=2, color="0.5", label="measured")
        axes[0].plot(way, self.fitted["fitted_friction"], label=f"fitted, {self.law} law")
        axes[0].set_ylabel("friction")
        axes[0].legend()
        axes[1].plot(way, self.fitted["residual"], ".", markersize=2, color="0.5")
        axes[1].axhspan(-deviation, deviation, alpha=0.2)
        axes[1].set(xlabel="load-point displacement (µm)", ylabel="residual")
        return np.asarray(axes, dtype=np.object_)

    def _repr_html_(self) -> str:
        rows = [["evolution law", self.law]]
        rows += [[name, str(value)] for name in UNITS if (value := getattr(self, name)) is not None]
        rows += [["remark", remark] for remark in self.remarks]
        return html_table(["name", "value ± standard error"], rows)


def interval(name: str, value: FittedValue) -> str:
    """Return the 95 % interval as an error bar."""
    if value.low is None or value.high is None:
        raise InputError(f"the record does not bound {name} on both sides, and a slider needs its interval")
    return f"[{value.low!r}, {value.high!r}]"


def fit(
    record: Record,
    *,
    law: str = "both",
    normal_stress_pa: Number | None = None,
    stiffness_pa_per_m: Number | None = None,
    mass_per_area_kg_per_m2: Number | None = None,
    drift: bool = False,
    loading_velocity_m_per_s: Number | None = None,
) -> Fit:
    """Fit a, b, D_c and more to a record of velocity steps, by the routine of ``slipmode fit``.

    ``record`` is a data frame of pandas or polars, columns by name, or the path of a CSV file. Its columns are ``time_s``;
    ``load_point_displacement_m`` or ``load_point_velocity_m_per_s``; ``shear_stress_pa`` or ``friction``; and optionally
    ``normal_stress_pa``. A name may end with another unit: ``load_point_displacement_um``. The record begins with steady
    sliding. Messages count the rows of a frame from 1.

    ``law`` is ``slip`` (eq 3), ``aging`` (eq 2), or ``both`` for the one that fits better. ``normal_stress_pa`` (Pa) is for a
    record without this column. ``stiffness_pa_per_m`` (Pa/m) is K of eq 4; without it, K is fitted.
    ``mass_per_area_kg_per_m2`` (kg/m²) is M of eq 4; without it, the slider has no inertia. ``drift`` adds a change of friction
    in proportion to the load-point displacement. ``loading_velocity_m_per_s`` (m/s) is V0 for ``slip_modes``; without it, the
    velocity before the first step.
    """
    if loading_velocity_m_per_s is not None and mass_per_area_kg_per_m2 is None:
        raise InputError("loading_velocity_m_per_s is for slip modes, which need mass_per_area_kg_per_m2")
    numbers = {
        "normal_stress_pa": normal_stress_pa,
        "stiffness_pa_per_m": stiffness_pa_per_m,
        "mass_per_area_kg_per_m2": mass_per_area_kg_per_m2,
        "loading_velocity_m_per_s": loading_velocity_m_per_s,
    }
    options = [f"--law={law}"] + [f"--{name.replace('_', '-')}={exact(number, name)}" for name, number in numbers.items() if number is not None]
    options += ["--drift"] if flag(drift, "drift") else []
    with tempfile.TemporaryDirectory() as folder:
        curve, picture = Path(folder, "fitted.csv"), Path(folder, "fitted.svg")
        found = printed(folder, record, [*options, f"--output={curve}", f"--svg={picture}"])
        return Fit.of(found, Table(columns_of_csv(curve.read_text())), picture.read_text())


@dataclass(frozen=True)
class PeakFit:
    """(b − a)σ/√(KM) = 2 V_18 from peak velocities of stick-slip."""

    #: The evolution law that fits better, or the one that was requested: ``slip`` (eq 3) or ``aging`` (eq 2).
    law: str
    #: 2 V_18, m/s.
    twice_v18_m_per_s: FittedValue
    #: (b − a)σ, Pa; none without K and M.
    effect_difference_stress_pa: FittedValue | None
    #: b − a; none without K, M and the normal stress.
    effect_difference: FittedValue | None
    #: The ends of 2 V_18 that each unknown alone gives, m/s: ``noise``, ``law``, ``effect_ratio``, ``model``, ``bandwidth``.
    error_parts_m_per_s: dict[str, tuple[float | None, float | None]] = field(repr=False)
    #: 2 V_18 with each law, m/s.
    laws: dict[str, FittedValue] = field(repr=False)
    #: Whether the table distinguishes the laws (95 % confidence); none if one law was requested, or if the other does not fit.
    distinguishes_laws: bool | None
    #: What the table does not determine, in sentences.
    remarks: tuple[str, ...]
    _found: dict[str, Any] = field(repr=False)

    @classmethod
    def of(cls, found: dict[str, Any]) -> PeakFit:
        """Return the fit of an object that the command line printed."""

        def value(name: str, unit: str, of: dict[str, Any] = found) -> FittedValue | None:
            one = of.get(name)
            return None if one is None else FittedValue(one["value"], one["error"], unit, one["low"], one["high"])

        scale = value("twice_v18_m_per_s", "m/s")
        assert scale is not None
        laws = {each["law"]: value("twice_v18_m_per_s", "m/s", each) for each in found["laws"]}
        comparison = found.get("law_comparison")
        return cls(
            law=found["law"],
            twice_v18_m_per_s=scale,
            effect_difference_stress_pa=value("effect_difference_stress_pa", "Pa"),
            effect_difference=value("effect_difference", ""),
            error_parts_m_per_s={name: (ends[0], ends[1]) for name, ends in found["error_parts_m_per_s"].items()},
            laws={law: one for law, one in laws.items() if one is not None},
            distinguishes_laws=None if comparison is None else comparison["tells_apart"],
            remarks=tuple(in_records(remark, "record") for remark in found["remarks"]),
            _found=found,
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the object that ``slipmode fit --peaks --json`` prints."""
        return dict(self._found)

    def to_pandas(self) -> pandas.DataFrame:
        """Return a row for each fitted value: value, error, and the ends of its 95 % interval."""
        import pandas

        names = ("twice_v18_m_per_s", "effect_difference_stress_pa", "effect_difference")
        found = {name: value for name in names if (value := getattr(self, name)) is not None}
        return pandas.DataFrame.from_dict({name: vars(value) for name, value in found.items()}, orient="index")


def fit_peaks(
    table: Record,
    *,
    law: str = "both",
    effect_ratio: Number | None = None,
    normal_stress_pa: Number | None = None,
    stiffness_pa_per_m: Number | None = None,
    mass_per_area_kg_per_m2: Number | None = None,
    critical_slip_distance_m: Number | None = None,
    bandwidth_hz: Number | None = None,
) -> PeakFit:
    """Fit (b − a)σ/√(KM) to peak velocities of stick-slip, without a velocity step.

    ``table`` is a data frame of pandas or polars, columns by name, or the path of a CSV file. Its columns are
    ``loading_velocity_m_per_s``; ``peak_velocity_m_per_s``; optionally ``peak_velocity_error_m_per_s``, the standard error; and
    optionally ``normal_stress_pa``. ``effect_ratio`` is b/a, and ``critical_slip_distance_m`` (m) is D_c, each a value or a range
    such as ``"[1.5, 2]"``. ``bandwidth_hz`` is the −3 dB frequency of the velocity record. D_c and the bandwidth need
    ``stiffness_pa_per_m`` (Pa/m) and ``mass_per_area_kg_per_m2`` (kg/m²).
    """
    numbers = {
        "effect_ratio": effect_ratio,
        "normal_stress_pa": normal_stress_pa,
        "stiffness_pa_per_m": stiffness_pa_per_m,
        "mass_per_area_kg_per_m2": mass_per_area_kg_per_m2,
        "critical_slip_distance_m": critical_slip_distance_m,
        "bandwidth_hz": bandwidth_hz,
    }
    options = [f"--law={law}"] + [f"--{name.replace('_', '-')}={exact(number, name)}" for name, number in numbers.items() if number is not None]
    with tempfile.TemporaryDirectory() as folder:
        return PeakFit.of(printed(folder, table, ["--peaks", *options]))


def printed(folder: str, record: Record, options: list[str]) -> dict[str, Any]:
    """Return the object that ``slipmode fit`` prints for a record or a table; a frame is written into the folder."""
    if isinstance(record, (str, os.PathLike)):
        file, of_frame = str(Path(record)), None
        if file == "-":
            raise InputError("record = -: standard input is not read (write the path of a file)")
    else:
        file = of_frame = str(Path(folder, "record.csv"))
        write_csv(Path(file), record)
    code, output, messages = _slipmode.call(("fit", "--json", *options, "--", file))
    remark(code, in_records(messages, "record", of_frame))
    found: dict[str, Any] = json.loads(output)
    return found
