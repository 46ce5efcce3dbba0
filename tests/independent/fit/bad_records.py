"""Writes the wrong records of tests/data/bad_records and their table, tests/data/bad_records.csv.

    python3 tests/independent/fit/bad_records.py tests/data

The table has the file, the options, words that the message of `slipmode fit` must contain (separated by |). The text behind the words says what is wrong.
good.csv is right; it stands in the table with wrong options. Numbers have 7 digits, so that the files are the same everywhere.
"""

import csv
import sys
from pathlib import Path

import numpy as np

from model import Drive, Parameters, friction

SIGMA = 5e6
STRESS = f"--normal-stress-pa {SIGMA:g}"
TRUE = Parameters(a=0.010, b=0.013, d_c=5e-5, k=1e9, mu_0=0.6)  # K is 3.3 K_c.
STEP = 20  # The first row after the velocity step.
TIME, VELOCITY, DISPLACEMENT, FRICTION, SHEAR = (
    "time_s",
    "load_point_velocity_m_per_s",
    "load_point_displacement_m",
    "friction",
    "shear_stress_pa",
)


def digits(value):
    return value if isinstance(value, str) else f"{value:.7g}"


class Base:
    """A record with a step from 1e-5 to 1e-4 m/s, 20 rows before and 100 after it, 10 and then 5 points per D_c."""

    def __init__(self, parameters=TRUE, factor=10.0):
        spacing = np.concatenate([np.full(STEP, 5e-6), np.full(40, 5e-6), np.full(60, 1e-5)])
        self.velocity = np.where(np.arange(len(spacing) + 1) < STEP, 1e-5, factor * 1e-5)
        self.time = np.concatenate([[0.0], np.cumsum(spacing / self.velocity[:-1])])
        imposed = Drive(self.time, self.velocity, np.full(len(self.time), SIGMA))
        noise = np.random.default_rng(1).normal(0.0, 5e-5, len(self.time))
        self.friction, self.displacement = friction(parameters, imposed) + noise, imposed.displacement

    def columns(self, **changed):
        """Time, velocity and friction, with replaced or further columns; None leaves a column out."""
        found = {TIME: self.time, VELOCITY: self.velocity, FRICTION: self.friction} | changed
        return {name: [digits(value) for value in values] for name, values in found.items() if values is not None}


def without_rows(columns, left_out):
    return {name: [value for row, value in enumerate(values) if row not in left_out] for name, values in columns.items()}


def with_cell(columns, name, row, text):
    return columns | {name: [text if at == row else value for at, value in enumerate(columns[name])]}


def stick_slips(base):
    """Friction rises with displacement and drops at once, again and again, after the velocity step."""
    after = base.displacement - base.displacement[STEP]
    return np.where(after < 0, base.friction, base.friction + 0.05 * (after / 2e-4 % 1.0))


def wrong_rows(base):
    """Records without a usable step, or with rows that cannot be read as a response to it."""
    good, steady = base.columns(), Base(factor=1.0)
    u = base.displacement
    yield (
        "no-step",
        good | steady.columns(),
        STRESS,
        "step|1e-5",
        ("no velocity step: the load-point velocity is 1e-5 m/s in all rows. a, b and D_c show after a step only"),
    )
    yield (
        "too-few-rows",
        without_rows(good, {*range(2, 18), *range(23, 121)}),
        STRESS,
        "7 rows",
        ("7 rows are too few for 5 parameters. A record needs at least 20 rows, and 3 within the first D_c after a step"),
    )
    yield (
        "too-few-points-per-slip-distance",
        without_rows(good, set(range(21, 121)) - set(range(40, 121, 20))),
        STRESS,
        ("points per D_c"),
        "0.5 points per D_c after the velocity step: the record does not determine a, b and D_c. A fit needs at least 3 points per D_c",
    )
    yield (
        "velocity-from-another-row",
        good | {VELOCITY: good[VELOCITY][40:] + good[VELOCITY][:40]},
        STRESS,
        "does not determine D_c",
        (
            "row 82: the velocity falls by a factor of 10, and the friction does not answer; the friction changes at row 21 without a step. "
            "Do the columns belong to the same times?"
        ),
    )
    yield (
        "negative-friction",
        base.columns(friction=-base.friction),
        STRESS,
        "column friction|sign|row 1",
        ("row 1, column friction = -0.6: friction must be positive. Reverse the sign of the column"),
    )
    yield (
        "response-with-wrong-sign",
        base.columns(friction=1.2 - base.friction),
        STRESS,
        "sign|row 21",
        (
            "row 21: the friction falls at once when the velocity rises, so that a would be negative. Reverse the sign of the changes of friction"
        ),
    )
    yield (
        "displacement-with-wrong-sign",
        base.columns(**{VELOCITY: None, DISPLACEMENT: -u}),
        STRESS,
        f"{DISPLACEMENT}|sign",
        (f"row 2, column {DISPLACEMENT}: the displacement falls. It must rise in the direction of the shear stress. Reverse the sign"),
    )
    clipped = np.minimum(base.friction, 0.6105)
    yield (
        "saturated",
        base.columns(friction=clipped),
        STRESS,
        "0.6105|saturated",
        (
            "column friction has its largest value 0.6105 in 19 successive rows: the sensor is saturated. Leave these rows out only if a "
            "full step remains"
        ),
    )
    yield (
        "gap-over-step",
        without_rows(good, range(STEP - 4, STEP + 30)),
        STRESS,
        "gap|row 17",
        (
            "a gap of 4 s after row 16, 8 times the larger neighbouring interval, where the velocity changes: the time of the step is unknown"
        ),
    )
    yield (
        "stick-slip",
        base.columns(friction=stick_slips(base)),
        STRESS,
        "stick-slip",
        (
            "the friction drops by 0.05 within one row at a constant velocity, 4 times (rows 61, 81, 101, 121). These are stick-slip events; a fit "
            "needs steady sliding before and after a step"
        ),
    )


def wrong_units(base):
    """Factors of 1000 and more: values outside of the accepted ranges of the fit."""
    u, shear = base.displacement, base.friction * SIGMA
    yield (
        "displacement-in-millimetres",
        base.columns(**{VELOCITY: None, DISPLACEMENT: 1e3 * u}),
        STRESS,
        ("critical_slip_distance_m|unit"),
        "the fit gives D_c = 0.05 m, outside of 1e-8 to 1e-2 m. Is the displacement in metres?",
    )
    yield (
        "displacement-in-micrometres",
        base.columns(**{VELOCITY: None, DISPLACEMENT: 1e6 * u}),
        STRESS,
        f"{DISPLACEMENT}|unit",
        (f"column {DISPLACEMENT}: the load-point velocity is 100 m/s, outside of 1e-12 to 10 m/s. Is the displacement in metres?"),
    )
    yield (
        "time-in-milliseconds",
        base.columns(**{TIME: 1e3 * base.time}),
        STRESS,
        "critical_slip_distance_m|unit",
        ("the fit gives D_c = 0.05 m, outside of 1e-8 to 1e-2 m. Are time and velocity in seconds and metres per second?"),
    )
    yield (
        "stress-in-kilopascals",
        base.columns(friction=None, **{SHEAR: shear / 1e3}),
        STRESS,
        f"{SHEAR}|unit",
        (f"column {SHEAR}: shear stress over normal stress is 0.0006 in row 1, outside of 0.01 to 5. Are both in pascals?"),
    )
    yield (
        "stress-in-megapascals",
        base.columns(friction=None, **{SHEAR: shear / 1e6}),
        STRESS,
        f"{SHEAR}|unit",
        (f"column {SHEAR}: shear stress over normal stress is 6e-7 in row 1, outside of 0.01 to 5. Are both in pascals?"),
    )
    yield (
        "friction-in-percent",
        base.columns(friction=100 * base.friction),
        STRESS,
        "column friction|row 1",
        ("row 1, column friction = 60: outside of 0.01 to 5"),
    )
    small = Base(TRUE.of(a=0.01 / 1e3, b=0.013 / 1e3, k=1e6))
    yield (
        "changes-of-friction-too-small",
        small.columns(),
        STRESS,
        "no definite minimum",
        ("the fit gives a = 1e-5, outside of 1e-4 to 1, with an error as large: the step does not show above the noise"),
    )


def wrong_tables(base):
    """Cells and columns."""
    good, u, n = base.columns(), base.displacement, len(base.time)
    swapped = good[TIME][:40] + [good[TIME][41], good[TIME][40]] + good[TIME][42:]
    yield (
        "time-not-increasing",
        good | {TIME: swapped},
        STRESS,
        "row 42|time_s",
        "row 42, column time_s: earlier than row 41. Time must rise",
    )
    same = good[TIME][:40] + [good[TIME][39]] + good[TIME][41:]
    yield "time-twice", good | {TIME: same}, STRESS, "row 41|time_s", "row 41, column time_s: the same time as row 40. Time must rise"
    yield (
        "nan",
        with_cell(good, FRICTION, 16, "NaN"),
        STRESS,
        "row 17|friction|NaN",
        ("row 17, column friction = NaN: not a finite number. Leave the row out"),
    )
    yield "empty-cell", with_cell(good, FRICTION, 16, ""), STRESS, "row 17|friction", "row 17, column friction: the cell is empty"
    yield (
        "infinite",
        with_cell(good, VELOCITY, 16, "inf"),
        STRESS,
        f"row 17|{VELOCITY}",
        f"row 17, column {VELOCITY} = inf: not a finite number",
    )
    yield "text", with_cell(good, FRICTION, 16, "0.61x"), STRESS, "row 17|friction", "row 17, column friction = 0.61x: not a number"
    yield (
        "zero-velocity",
        with_cell(good, VELOCITY, 0, "0"),
        STRESS,
        f"row 1|{VELOCITY}",
        (f"row 1, column {VELOCITY} = 0: the record must begin with steady sliding. Holds at zero velocity are allowed later only"),
    )
    yield "no-time", base.columns(**{TIME: None}), STRESS, TIME, "no column time_s"
    yield (
        "no-stress",
        base.columns(friction=None),
        STRESS,
        f"{SHEAR}|{FRICTION}",
        f"no column {SHEAR} or friction; a record needs one of them",
    )
    yield (
        "no-load-point",
        base.columns(**{VELOCITY: None}),
        STRESS,
        f"{VELOCITY}|{DISPLACEMENT}",
        (f"no column {DISPLACEMENT} or {VELOCITY}; a record needs one of them"),
    )
    yield (
        "stress-and-friction",
        base.columns(**{SHEAR: base.friction * SIGMA}),
        STRESS,
        f"{SHEAR}|{FRICTION}",
        (f"both {SHEAR} and friction; a record has one of them"),
    )
    yield (
        "velocity-and-displacement",
        base.columns(**{DISPLACEMENT: u}),
        STRESS,
        f"{VELOCITY}|{DISPLACEMENT}",
        (f"both {DISPLACEMENT} and {VELOCITY}; a record has one of them"),
    )
    negative = with_cell(base.columns(normal_stress_pa=np.full(n, SIGMA)), "normal_stress_pa", 16, "-5000000")
    yield "negative-normal-stress", negative, "", "row 17|normal_stress_pa", "row 17, column normal_stress_pa = -5000000: must be positive"
    both = base.columns(normal_stress_pa=np.full(n, SIGMA))
    yield (
        "normal-stress-twice",
        both,
        STRESS,
        "normal_stress_pa|--normal-stress-pa",
        ("the record has the column normal_stress_pa, and --normal-stress-pa is given; leave one out"),
    )
    yield "header-only", {name: [] for name in good}, STRESS, "row", "no rows below the header"


def wrong_options(base):
    """A good record with options that are refused."""
    good = base.columns()
    yield "good", good, "", "normal_stress_pa|--normal-stress-pa", "no normal stress: add --normal-stress-pa or the column normal_stress_pa"
    yield "good", good, f"{STRESS} --stiffness-pa-per-m 0", "--stiffness-pa-per-m", "--stiffness-pa-per-m = 0: must be positive"
    yield "good", good, f"{STRESS} --law rate", "--law|rate", "--law = rate: one of slip, aging, both"
    yield (
        "good",
        good,
        f"{STRESS} --mass-per-area-kg-per-m2 -1",
        "--mass-per-area-kg-per-m2",
        "--mass-per-area-kg-per-m2 = -1: must not be negative",
    )


def main():
    folder, base = Path(sys.argv[1]), Base()
    (folder / "bad_records").mkdir(exist_ok=True)
    table = []
    for rows in (wrong_rows, wrong_units, wrong_tables, wrong_options):
        for name, columns, options, words, _ in rows(base):
            table.append([f"{name}.csv", options, words])
            with open(folder / "bad_records" / f"{name}.csv", "w", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(columns)
                writer.writerows(zip(*columns.values()))
    with open(folder / "bad_records.csv", "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["file", "options", "words"], *table])


if __name__ == "__main__":
    main()
