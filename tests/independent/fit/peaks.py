"""Coverage of the 95 % intervals of `slipmode fit --peaks` on synthetic experiments with known parameters.

    python3 tests/independent/fit/peaks.py FOLDER --command target/release/slipmode [--experiments N] [--seed N] [--csv FILE] [--tables FILE]

FOLDER gets points.csv, runs.csv and a table for each experiment. An experiment is a slider in deep stick-slip with one of the two laws. Its
peak velocities come from limit cycles that `slipmode simulate` integrates to 1e-8, and not from the formula that is fitted. They get
multiplicative noise of 1 to 5 %. The fit knows one of three things besides the table: nothing, a range of b/a, or ranges of b/a and D_c with K and M.
The noise is stated in half of the tables. Experiment i does not depend on N.

--tables keeps the tables with options and truth in one file: tests/data/peak_tables.csv has 12 experiments of seed 2.

The table of results has, for each group: the share of intervals that contain the true (b - a) sigma/sqrt(K M); the same for the interval of the
noise alone, with the true law; the median of (value - truth)/truth and of half the interval over the truth; refused tables; tables that tell the
laws apart, rightly and wrongly. The exit code is 1 if less than 93 % of the intervals contain the truth, or more than 5 % of the tables are refused.
"""

import argparse
import csv
import json
import random
import subprocess
import sys
from math import exp, inf, log, pi, sqrt
from pathlib import Path
from statistics import median

LEAST_SHARE, MOST_REFUSED = 0.93, 0.05
KINDS = ("table alone", "b/a within 10 %", "b/a within 10 %, K, M, D_c within 30 %")
GROUPS = {
    "all experiments": lambda one: True,
    "slip law": lambda one: one["law"] == "slip",
    "aging law": lambda one: one["law"] == "aging",
    "noise 1-2 %": lambda one: one["noise"] < 0.02,
    "noise 2-5 %": lambda one: one["noise"] >= 0.02,
    "noise stated": lambda one: one["stated"],
    "noise from the scatter": lambda one: not one["stated"],
} | {kind: lambda one, kind=kind: one["kind"] == kind for kind in KINDS}
HEADER = (
    "group,experiments,contain_truth_percent,noise_alone_percent,median_error_percent,median_half_width_percent,refused,"
    "told_apart_rightly,told_apart_wrongly"
).split(",")
QUANTITIES = {
    "direct_effect": "a",
    "evolution_effect": "b",
    "critical_slip_distance_m": "d",
    "stiffness_pa_per_m": "k",
    "mass_per_area_kg_per_m2": "m",
    "normal_stress_pa": "s",
}


def drawn(seed, index):
    """A slider with K/K_c,qs of 0.0003 to 0.09, and load velocities below 0.08 V_18."""
    draw = random.Random(f"{seed} {index}")

    def between(low, high):
        return exp(draw.uniform(log(low), log(high)))

    ratio = 1 + between(0.2, 2.0)
    a, s, d = between(0.003, 0.02), between(1e3, 1e8), between(3e-7, 1e-4)
    b = a * ratio
    k = between(3e-4, 0.09) * (b - a) * s / d
    m = k / (2 * pi * between(5, 500)) ** 2
    truth = (b - a) * s / sqrt(k * m)
    fastest, decades, rows = truth / 2 * between(3e-3, 0.08), draw.uniform(1, 2), draw.randint(5, 12)
    noise = between(0.01, 0.05)
    one = {"law": ("slip", "aging")[index % 2], "a": a, "b": b, "d": d, "k": k, "m": m, "s": s, "truth": truth, "noise": noise}
    one["loads"] = [fastest * 10 ** (-decades * row / (rows - 1)) for row in range(rows)]
    one["factors"] = [1 + noise * draw.gauss(0, 1) for _ in range(rows)]
    one["kind"], one["stated"] = KINDS[index // 2 % 3], draw.random() < 0.5
    # The ranges contain the truth at any place.
    within = {"ratio": 1.1 ** draw.uniform(-1, 1), "distance": 1.3 ** draw.uniform(-1, 1)}
    low, high = (min(max(ratio * within["ratio"] * by, 1.2), 5) for by in (1 / 1.1, 1.1))
    one["options"] = [] if one["kind"] == KINDS[0] else [f"--effect-ratio=[{low!r}, {high!r}]"]
    if one["kind"] == KINDS[2]:
        low, high = (d * within["distance"] * by for by in (1 / 1.3, 1.3))
        one["options"] += [f"-d=[{low!r}, {high!r}]", f"-k={k!r}", f"-m={m!r}"]
    return one


def simulated(given, experiments):
    """Peak velocities of all rows, and the table of each experiment."""
    points, runs = given.folder / "points.csv", given.folder / "runs.csv"
    with open(points, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["law", *QUANTITIES, "loading_velocity_m_per_s"])
        for one in experiments:
            writer.writerows([one["law"], *(repr(one[key]) for key in QUANTITIES.values()), repr(load)] for load in one["loads"])
    subprocess.run([given.command, "simulate", "--quiet", "--points", points, "-o", runs], check=True, stderr=subprocess.DEVNULL)
    with open(runs, newline="") as file:
        rows = list(csv.DictReader(file))
    assert all(row["mode"] == "periodic" for row in rows)
    peaks = (float(row["peak_velocity_m_per_s"]) for row in rows)
    for index, one in enumerate(experiments):
        one["file"] = given.folder / f"{index:04}.csv"
        with open(one["file"], "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["loading_velocity_m_per_s", "peak_velocity_m_per_s"] + ["peak_velocity_error_m_per_s"] * one["stated"])
            for load, factor in zip(one["loads"], one["factors"]):
                peak = next(peaks) * factor
                writer.writerow([repr(load), repr(peak)] + [repr(one["noise"] * peak)] * one["stated"])


def keep(path, experiments):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["experiment", "law", "options", "truth", "loading_velocity_m_per_s", "peak_velocity_m_per_s", "peak_velocity_error_m_per_s"])
        for index, one in enumerate(experiments):
            options = "|".join(one["options"])
            with open(one["file"], newline="") as table:
                rows = list(csv.reader(table))[1:]
            writer.writerows([index, one["law"], options, repr(one["truth"]), *(row + [""])[:3]] for row in rows)


def fitted(given, one):
    """The answer, or none for a table that is refused."""
    arguments = [given.command, "fit", "--peaks", one["file"], "--json", *one["options"]]
    ended = subprocess.run(arguments, capture_output=True, text=True, check=False)
    if ended.returncode:
        print(f"{one['file'].name}: {ended.stderr.strip()}")
        return None
    return json.loads(ended.stdout)


def contains(interval, truth):
    low, high = interval["low"], interval["high"]
    return (-inf if low is None else low) <= truth <= (inf if high is None else high)


def of_group(name, pairs):
    """A row of the table of results."""
    found = [(one, answer) for one, answer in pairs if answer]
    scales = [(one, answer["twice_v18_m_per_s"]) for one, answer in found]
    of_law = [(one, next(fit for fit in answer["laws"] if fit["law"] == one["law"])["from_noise_m_per_s"]) for one, answer in found]
    alone = [contains({"low": low, "high": high}, one["truth"]) for one, (low, high) in of_law]
    widths = [inf if scale["low"] is None else (scale["high"] - scale["low"]) / 2 / one["truth"] for one, scale in scales]
    apart = [answer["law"] == one["law"] for one, answer in found if (answer.get("law_comparison") or {}).get("tells_apart")]
    percent = [
        sum(contains(scale, one["truth"]) for one, scale in scales) / len(found),
        sum(alone) / len(alone),
        median(scale["value"] / one["truth"] - 1 for one, scale in scales),
        median(widths),
    ]
    return [name, len(pairs), *(f"{100 * number:.3g}" for number in percent), len(pairs) - len(found), sum(apart), len(apart) - sum(apart)]


def main():
    given = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    given.add_argument("folder", type=Path)
    given.add_argument("--command", required=True)
    given.add_argument("--experiments", type=int, default=200)
    given.add_argument("--seed", type=int, default=1)
    given.add_argument("--csv", type=Path)
    given.add_argument("--tables", type=Path)
    given = given.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    experiments = [drawn(given.seed, index) for index in range(given.experiments)]
    simulated(given, experiments)
    if given.tables:
        keep(given.tables, experiments)
    pairs = [(one, fitted(given, one)) for one in experiments]
    groups = ((name, [pair for pair in pairs if is_of(pair[0])]) for name, is_of in GROUPS.items())
    rows = [of_group(name, group) for name, group in groups if any(answer for _, answer in group)]
    writers = [csv.writer(sys.stdout, lineterminator="\n")]
    if given.csv:
        writers.append(csv.writer(open(given.csv, "w", newline=""), lineterminator="\n"))
    for writer in writers:
        writer.writerows([HEADER, *rows])
    share, refused = float(rows[0][2]) / 100, rows[0][6]
    return int(share < LEAST_SHARE or refused > MOST_REFUSED * len(experiments))


if __name__ == "__main__":
    sys.exit(main())
