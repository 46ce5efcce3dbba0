"""Questions on sliders: of one point, of arrays, or of every row of a frame."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode._classified import WORDS, Classification, Classifications, Possibilities, computed
from slipmode._errors import CheckFailed, InputError
from slipmode._exact import Number, exact, fault, flag, given
from slipmode._rows import KEYS, NAMES, FrameColumn, Rows, Value, is_number
from slipmode._run import call_json, each, in_python, remark, warn
from slipmode._simulated import Failed, Simulation, Simulations
from slipmode._table import Record, Table, column

#: Options of the command line by argument.
OPTIONS = {name: f"--{key.replace('_', '-')}" for name, key in KEYS.items()}
#: What can be solved for, by argument.
UNKNOWNS = {"sigma": "normal-stress", "v": "loading-velocity", "k": "stiffness", "m": "mass"}
#: Columns of solutions, as the command line has them.
MOST_SOLUTIONS = 4

#: A frame of pandas, polars, xarray or pyarrow.
Frame = TypeVar("Frame")
#: A number without an error bar, whatever its value.
Plain = Union[float, Decimal, Fraction]

Warned = list[str]
Texts = Mapping[str, str]


@dataclass(frozen=True)
class Root(Record):
    """A root s of eq 8, 1/s: the true one lies within ``radius`` of re + i·im."""

    re: Decimal
    im: Decimal
    radius: Decimal
    multiplicity: int

    def __complex__(self) -> complex:
        return complex(float(self.re), float(self.im))


@dataclass(frozen=True)
class Solution(Record):
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


@dataclass(frozen=True)
class Distance(Record):
    """log10 of the factors by which one input has to change; none where no change suffices."""

    #: Of σ, to the transition K = K_c.
    transition_normal_stress: float | None
    #: Of V0, to the transition.
    transition_loading_velocity: float | None
    #: Of σ, to the boundary max Im(s) = 0.
    boundary_normal_stress: float | None
    #: Of V0, to the boundary.
    boundary_loading_velocity: float | None


def options(texts: Texts) -> list[str]:
    """Return the options of a point."""
    return [f"{OPTIONS[name]}={text}" for name, text in texts.items()]


def chosen(values: Mapping[str, Any], needed: Sequence[str], frame: Any) -> dict[str, Any]:
    """Return the values that are given; without a frame, all that are needed have to be."""
    found = {name: values[name] for name in needed if values[name] is not None}
    if frame is None and len(found) < len(needed):
        missing = ", ".join(name for name in needed if name not in found)
        raise InputError(f"{missing}: missing (wanted: a number or an array for each, or a frame with such columns)")
    return found


def single(values: Mapping[str, Any], frame: Any) -> bool:
    """Return whether every value is one number."""
    return frame is None and all(map(is_number, values.values()))


def refuse_error_bars(command: str, is_uncertain: bool) -> None:
    """Say which command takes error bars, where a call does not."""
    if is_uncertain:
        raise InputError(f"this call takes values without error bars; `slipmode {command}` takes error bars")


@overload
def classify(  # type: ignore[overload-overlap]
    frame: None = None, /, *, a: Plain, b: Plain, d_c: Plain, k: Plain, m: Plain, sigma: Plain, v: Plain,
    inertial_threshold: Number | None = None
) -> Classification: ...
@overload
def classify(  # type: ignore[overload-overlap]
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, sigma: Number, v: Number,
    inertial_threshold: Number | None = None
) -> Classification | Possibilities: ...
@overload
def classify(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    inertial_threshold: Number | None = None
) -> Table: ...
@overload
def classify(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    inertial_threshold: Number | None = None
) -> Frame: ...
@overload
def classify(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, sigma: Number | FrameColumn, v: Number | FrameColumn, inertial_threshold: Number | None = None
) -> Any: ...
@overload
def classify(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, sigma: Value, v: Value,
    inertial_threshold: Number | None = None
) -> Classifications: ...
def classify(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    sigma: Any = None,
    v: Any = None,
    inertial_threshold: Number | None = None,
) -> Any:
    """Decide stability and slip mode of one point, of arrays of points, or of every row of a frame.

    Arguments are in SI: a and b of eq 1, D_c (m), K (Pa/m), M (kg/m²), σ (Pa) and V0 (m/s). ``str``, ``Decimal``, ``Fraction`` and
    ``int`` are exact: ``"0.009"`` is 9/1000. A float is the exact binary number that it is: ``0.009`` differs from 9/1000 by less
    than 1e-18. Texts may have a unit and an error (``"8 um"``, ``"0.009±0.001"``); ``(0.009, 0.001)`` is a value with its error.
    Numbers of ``uncertainties`` and quantities of ``pint`` are taken with their error and their unit.

    Seven numbers give a :class:`Classification`, or :class:`Possibilities` if one has an error. Arrays and lists broadcast as in
    NumPy and give :class:`Classifications`. Columns of pandas, polars, xarray or pyarrow give a frame of that package, with the
    index of the columns.

    ``frame`` has columns with the names that ``slipmode classify --points`` reads, such as ``a``, ``Dc [um]`` and ``a_err``, or is a
    mapping of columns. Arguments add columns to it. The result is the frame with further columns, whose names are those of the
    command line; a :class:`Table` for a mapping. With errors they are ranges and what is possible.

    A row with a missing value (NaN, None or masked) has a missing result. Signs are exact. Frequencies in Hz are correctly
    rounded; growth rates and angular frequencies have a relative error below 1e-14. An oscillation is inertial from
    ω/ω_n > ``inertial_threshold``; √(1/2) without it.
    """
    given_values = {"a": a, "b": b, "d_c": d_c, "k": k, "m": m, "sigma": sigma, "v": v}
    values = chosen(given_values, NAMES, frame)
    threshold = None if inertial_threshold is None else exact(inertial_threshold, "inertial_threshold")
    if single(values, frame):
        return classify_point({name: given(value, name) for name, value in values.items()}, threshold)
    rows = Rows.of(frame, values)
    if rows.is_uncertain:
        return classify_uncertain(rows, threshold)
    if not rows.is_framed:
        return classify_rows(rows, threshold)
    columns, warning = computed(rows, threshold, True)
    warn(in_python(warning))
    return rows.wrap(columns)


def classify_point(values: Mapping[str, str | float], threshold: str | None) -> Classification | Possibilities:
    """Classify the point of seven values."""
    answer = _slipmode.classify_point([(name, value, None) for name, value in values.items()], threshold)
    if answer is None:
        texts = {name: exact(value, name) for name, value in values.items()}
        return Possibilities.of(possible(texts, threshold, None))
    ((growth, angular, hertz, *_), (transition, boundary, spectral_class, mode, _)), warnings = answer
    if warnings:
        warn(in_python(warnings))
    words = WORDS[0][spectral_class], WORDS[1][mode]
    return Classification(transition, boundary, *words, growth, angular, hertz, (tuple(values.values()), threshold))


def possible(texts: Texts, threshold: str | None, warned: Warned | None) -> dict[str, Any]:
    """Return what ``slipmode classify --json`` prints of a point."""
    limit = [] if threshold is None else [f"--inertial-threshold={threshold}"]
    found: dict[str, Any] = call_json("classify", *options(texts), *limit, warned=warned)
    return found


def classify_rows(rows: Rows, threshold: str | None) -> Classifications:
    """Classify rows without error bars."""
    columns, warning = computed(rows, threshold, False)
    warn(in_python(warning))
    fields: list[Any] = [*columns.values(), rows, threshold]
    return Classifications(*fields)


def classify_uncertain(rows: Rows, threshold: str | None) -> Any:
    """Classify rows with error bars: what is certain, what is possible, and ranges, in columns."""

    def one(texts: Texts, warned: Warned) -> dict[str, Any]:
        return ranges(possible(texts, threshold, warned))

    return rows.wrap(columns_of_rows(each(rows.texts(), one), rows.shape))


def ranges(found: Mapping[str, Any]) -> dict[str, Any]:
    """Return what is found over a box, or at a point, as a row of ranges."""
    is_box = "slip_modes" in found
    modes = [each["mode"] for each in (*found["slip_modes"], *found["undecided"])] if is_box else [found["slip_mode"]]
    row: dict[str, Any] = {"certain": found.get("certain", True), "slip_modes": ";".join(modes)}
    row["undecided_share"] = found.get("undecided_share", 0.0)
    for name in ("transition_sign", "boundary_sign", *RANGES):
        ends = found[f"{name}s"] if is_box and name.endswith("_sign") else found[name]
        low, high = (ends or (None, None)) if is_box else (ends, ends)
        row |= {f"{name}_low": low, f"{name}_high": high}
    return row


#: Numbers that are ranges over error bars.
RANGES = ("max_real_per_s", "max_imaginary_per_s", "frequency_hz", "critical_stiffness_pa_per_m")


def columns_of_rows(rows: Sequence[Mapping[str, Any] | None], shape: tuple[int, ...]) -> dict[str, NDArray[Any]]:
    """Return columns of objects, with None in a row that has none."""
    names: dict[str, None] = dict.fromkeys(name for row in rows if row is not None for name in row)
    cells = {name: [None if row is None else row.get(name) for row in rows] for name in names}
    return {name: column(each).reshape(shape) for name, each in cells.items()}


@overload
def roots(  # type: ignore[overload-overlap]
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, sigma: Number, v: Number,
    digits: int = 50
) -> list[Root]: ...
@overload
def roots(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    digits: int = 50
) -> Table: ...
@overload
def roots(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    digits: int = 50
) -> Frame: ...
@overload
def roots(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, sigma: Number | FrameColumn, v: Number | FrameColumn, digits: int = 50
) -> Any: ...
@overload
def roots(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, sigma: Value, v: Value,
    digits: int = 50
) -> NDArray[np.complex128]: ...
def roots(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    sigma: Any = None,
    v: Any = None,
    digits: int = 50,
) -> Any:
    """Compute the three roots s of eq 8, 1/s. The arguments are those of :func:`classify`.

    Seven numbers give three :class:`Root` with this many certain ``digits``. Arrays give complex numbers with one more axis, of
    three: real roots first, ascending; then the pair, negative imaginary part first. Each has an error below 1.2e-16 of its
    modulus; NaN where a value is missing, and beyond 1e-300 to 1e300. Frames get columns ``root_1_re_per_s`` and so on.
    """
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m, "sigma": sigma, "v": v}, NAMES, frame)
    if single(values, frame):
        texts = [exact(values[name], name) for name in NAMES]
        code, messages, answer = _slipmode.roots_of_point(texts, str(digits))
        remark(code, in_python(messages))
        found = json.loads(answer or "[]")
        return [Root(Decimal(x["re"]), Decimal(x["im"]), Decimal(x["radius"]), x["multiplicity"]) for x in found]
    rows = Rows.of(frame, values)
    refuse_error_bars("classify", rows.is_uncertain)
    buffer = _slipmode.roots_of_points(rows.native, rows.size)
    complexes = np.frombuffer(buffer, "<c16").reshape(*rows.shape, 3)
    if not rows.is_framed:
        return complexes
    parts = {"re": complexes.real, "im": complexes.imag}
    names = ((place, part) for place in range(3) for part in parts)
    return rows.wrap({f"root_{place + 1}_{part}_per_s": parts[part][..., place] for place, part in names})


@overload
def distance(  # type: ignore[overload-overlap]
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, sigma: Number, v: Number
) -> Distance: ...
@overload
def distance(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None
) -> Table: ...
@overload
def distance(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None
) -> Frame: ...
@overload
def distance(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, sigma: Number | FrameColumn, v: Number | FrameColumn
) -> Any: ...
@overload
def distance(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, sigma: Value, v: Value
) -> Table: ...
def distance(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    sigma: Any = None,
    v: Any = None,
) -> Any:
    """Compute how far points are from the transition K = K_c and from the boundary max Im(s) = 0, in decades of σ and of V0.

    The arguments are those of :func:`classify`. Seven numbers give a :class:`Distance`, arrays and frames give columns.
    """
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m, "sigma": sigma, "v": v}, NAMES, frame)

    def one(texts: Texts, warned: Warned | None) -> dict[str, float | None]:
        found = possible(texts, None, warned)
        refuse_error_bars("classify", "slip_modes" in found)
        places = ((place, found[f"{place}_distance"]) for place in ("transition", "boundary"))
        parts = ("normal_stress", "loading_velocity")
        return {f"{place}_{part}": ends[f"log10_{part}"] for place, ends in places for part in parts}

    if single(values, frame):
        return Distance(**one({name: exact(value, name) for name, value in values.items()}, None))
    rows = Rows.of(frame, values)
    return rows.wrap(columns_of_rows(each(rows.texts(), one), rows.shape))


@overload
def solve(
    unknown: str, frame: None = None, /, *, a: Number | None = None, b: Number | None = None,
    d_c: Number | None = None, k: Number | None = None, m: Number | None = None, sigma: Number | None = None,
    v: Number | None = None, frequency: Number | None = None, angular_frequency: Number | None = None,
    growth_rate: Number | None = None, frequency_ratio: Number | None = None, transition: bool = False, boundary: bool = False, digits: int = 17
) -> list[Solution]: ...
@overload
def solve(
    unknown: str, frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None,
    d_c: Value | None = None, k: Value | None = None, m: Value | None = None, sigma: Value | None = None,
    v: Value | None = None, frequency: Number | None = None, angular_frequency: Number | None = None,
    growth_rate: Number | None = None, frequency_ratio: Number | None = None, transition: bool = False, boundary: bool = False, digits: int = 17
) -> Table: ...
@overload
def solve(
    unknown: str, frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    frequency: Number | None = None, angular_frequency: Number | None = None, growth_rate: Number | None = None,
    frequency_ratio: Number | None = None, transition: bool = False, boundary: bool = False, digits: int = 17
) -> Frame: ...
@overload
def solve(
    unknown: str, frame: None = None, /, *, a: Number | FrameColumn | None = None, b: Number | FrameColumn | None = None,
    d_c: Number | FrameColumn | None = None, k: Number | FrameColumn | None = None, m: Number | FrameColumn | None = None,
    sigma: Number | FrameColumn | None = None, v: Number | FrameColumn | None = None, frequency: Number | None = None,
    angular_frequency: Number | None = None, growth_rate: Number | None = None, frequency_ratio: Number | None = None, transition: bool = False,
    boundary: bool = False, digits: int = 17
) -> Any: ...
@overload
def solve(
    unknown: str, frame: None = None, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    frequency: Number | None = None, angular_frequency: Number | None = None, growth_rate: Number | None = None,
    frequency_ratio: Number | None = None, transition: bool = False, boundary: bool = False, digits: int = 17
) -> Table: ...
def solve(
    unknown: str,
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    sigma: Any = None,
    v: Any = None,
    frequency: Number | None = None,
    angular_frequency: Number | None = None,
    growth_rate: Number | None = None,
    frequency_ratio: Number | None = None,
    transition: bool = False,
    boundary: bool = False,
    digits: int = 17,
) -> Any:
    """Solve for ``unknown``: ``normal_stress``, ``loading_velocity``, ``stiffness`` or ``mass`` (or ``sigma``, ``v``, ``k``, ``m``).

    One of the targets is given: a ``frequency`` (Hz), an ``angular_frequency`` or a ``growth_rate`` (1/s), a ``frequency_ratio``
    ω/ω_n, the ``transition`` or the ``boundary``. The other arguments are those of :func:`classify`; the unknown's own value is not used. Numbers give
    a list of :class:`Solution`, arrays and frames columns ``solutions`` (their number), ``solution_1`` to ``solution_4``, with
    errors the ends of ranges, and ``status``: ``solved``, ``none``, or why a row is not decided.
    """
    argument = next((name for name, word in UNKNOWNS.items() if str(unknown).replace("_", "-") in (name, word)), None)
    if argument is None:
        raise fault("unknown", unknown, "not allowed (allowed: normal_stress, loading_velocity, stiffness, mass)")
    needed = [name for name in NAMES if name != argument]
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m, "sigma": sigma, "v": v}, needed, frame)
    numbers = {"frequency": frequency, "angular_frequency": angular_frequency}
    numbers |= {"growth_rate": growth_rate, "frequency_ratio": frequency_ratio}
    targets = {name: f"={exact(number, name)}" for name, number in numbers.items() if number is not None}
    flags = {"transition": transition, "boundary": boundary}
    targets |= {name: "" for name, is_given in flags.items() if flag(is_given, name)}
    if len(targets) != 1:
        given_ones = f"{', '.join(targets)}: more than one target" if targets else "the target is missing"
        raise InputError(f"{given_ones} (allowed: one of {', '.join([*numbers, *flags])})")
    asked = [f"--for={UNKNOWNS[argument]}", f"--digits={digits}"]
    asked += [f"--{name.replace('_', '-')}{value}" for name, value in targets.items()]

    def one(texts: Texts, warned: Warned | None) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = call_json("solve", *options(texts), *asked, warned=warned)["solutions"]
        return found

    if single(values, frame):
        found = one({name: exact(value, name) for name, value in values.items()}, None)
        refuse_error_bars("solve", any("range" in each for each in found))
        return [Solution(Decimal(x["value"]), x["is_exact"], x["transition_sign"], x["kind"]) for x in found]
    rows = Rows.of(frame, values, [argument])

    def row(texts: Texts, warned: Warned) -> dict[str, Any]:
        try:
            return solutions(one(texts, warned))
        except CheckFailed as failure:
            return solutions(()) | {"solutions": None, "status": str(failure)}

    return rows.wrap(columns_of_rows(each(rows.texts(), row), rows.shape))


def solutions(found: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Return the solutions of a row as cells."""
    row: dict[str, Any] = {"solutions": len(found)}
    for place in range(MOST_SOLUTIONS):
        one = found[place] if place < len(found) else {}
        if "range" in one:
            low, high = map(float, one["range"])
            row |= {f"solution_{place + 1}_low": low, f"solution_{place + 1}_high": high}
        else:
            row[f"solution_{place + 1}"] = float(one["value"]) if one else None
    return row | {"status": "solved" if found else "none"}


@overload
def simulate(  # type: ignore[overload-overlap]
    frame: None = None, /, *, a: Number, b: Number, d_c: Number, k: Number, m: Number, sigma: Number, v: Number,
    law: str | None = None, rtol: Number = "1e-8", start: str = "steady-at-velocity"
) -> Simulation: ...
@overload
def simulate(
    frame: dict[str, Any], /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    law: str | None = None, rtol: Number = "1e-8", start: str = "steady-at-velocity"
) -> Table: ...
@overload
def simulate(
    frame: Frame, /, *, a: Value | None = None, b: Value | None = None, d_c: Value | None = None,
    k: Value | None = None, m: Value | None = None, sigma: Value | None = None, v: Value | None = None,
    law: str | None = None, rtol: Number = "1e-8", start: str = "steady-at-velocity"
) -> Frame: ...
@overload
def simulate(
    frame: None = None, /, *, a: Number | FrameColumn, b: Number | FrameColumn, d_c: Number | FrameColumn, k: Number | FrameColumn,
    m: Number | FrameColumn, sigma: Number | FrameColumn, v: Number | FrameColumn, law: str | None = None, rtol: Number = "1e-8",
    start: str = "steady-at-velocity"
) -> Any: ...
@overload
def simulate(
    frame: None = None, /, *, a: Value, b: Value, d_c: Value, k: Value, m: Value, sigma: Value, v: Value,
    law: str | None = None, rtol: Number = "1e-8", start: str = "steady-at-velocity"
) -> Simulations: ...
def simulate(
    frame: Any = None,
    /,
    *,
    a: Any = None,
    b: Any = None,
    d_c: Any = None,
    k: Any = None,
    m: Any = None,
    sigma: Any = None,
    v: Any = None,
    law: str | None = None,
    rtol: Number = "1e-8",
    start: str = "steady-at-velocity",
) -> Any:
    """Simulate the nonlinear slider with the ``law`` ``slip`` (eq 3) or ``aging`` (eq 2), rows in parallel.

    The other arguments are those of :func:`classify`. ``rtol`` is the permitted relative error of peak velocity and period. A frame
    may have the law in a column ``law``. Numbers give a :class:`Simulation`, arrays :class:`Simulations`, where a run that fails is
    :class:`Failed`, and frames further columns. With errors, the run is that of the middle values, and ranges are sampled.
    """
    values = chosen({"a": a, "b": b, "d_c": d_c, "k": k, "m": m, "sigma": sigma, "v": v}, NAMES, frame)
    common = [f"--tolerance={exact(rtol, 'rtol')}", f"--start={start}"]
    if single(values, frame):
        return simulate_point(values, law, common, None)
    rows = Rows.of(frame, values)
    laws = [law] * rows.size if law is not None or not rows.kind.is_frame else np.asarray(rows.kind.example["law"]).tolist()

    def one(item: tuple[Texts, str], warned: Warned) -> Simulation | Failed:
        texts, own_law = item
        try:
            return simulate_point(texts, own_law, common, warned)
        except CheckFailed as failure:
            return Failed(str(failure))

    items = [None if texts is None else (texts, own) for texts, own in zip(rows.texts(), laws)]
    inputs = {name: array.ravel() for name, array in rows.inputs().items()}
    runs = Simulations([run or Failed("a value is missing") for run in each(items, one)], inputs)
    return rows.wrap(columns_of_rows(runs.rows(), rows.shape)) if rows.is_framed else runs


def simulate_point(
    values: Mapping[str, Any], law: str | None, common: Sequence[str], warned: Warned | None
) -> Simulation:
    """Simulate the point of seven values."""
    if law is None:
        raise InputError("law: missing (allowed: slip, aging)")
    arguments = (*options({name: exact(value, name) for name, value in values.items()}), f"--law={law}", *common)
    return Simulation.of(call_json("simulate", *arguments, warned=warned), arguments)
