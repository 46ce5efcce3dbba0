"""Coverage of the 95 % intervals of `slipmode fit` on the synthetic records that records.py wrote.

    python3 tests/independent/fit/coverage.py FOLDER --command "target/release/slipmode fit" [--records N] [--jobs N] [--csv FILE] [--answers FOLDER]

FOLDER has manifest.json. The command gets a record, the options of the manifest and --json. To test the records themselves, the
independent fit can stand in: --command "python3 tests/independent/fit/optimum.py --profile".

The table has, for each parameter, the share of intervals that contain the true value with its binomial standard error, the mean
of (estimate - truth)/(standard error) with its standard error, and the median of half the interval over the true value. --answers
keeps the answers; same_optimum.py compares those of two programs.

The exit code is 1 if more than 1 % of the records fail, or if a share over all records is outside of 95 % +- 2 % sqrt(500/n), n being
the number of intervals. With n = 500 this is 93 to 97 %. It is two binomial standard deviations: a correct program is outside with
a probability of about 5 % for each parameter, so a share just outside asks for records of another seed before it is called an error.
"""

import argparse
import csv
import json
import resource
import shlex
import subprocess
import sys
from functools import partial
from math import sqrt
from multiprocessing.pool import ThreadPool
from pathlib import Path

import numpy as np

LEVEL = 0.95
BOUND, BOUND_RECORDS = 0.02, 500  # Half the accepted range of a share, for this many intervals.
MOST_FAILURES = 0.01
GROUPS = {
    "all": lambda one: "all records",
    "law": lambda one: f"{one['law']} law",
    "noise": lambda one: f"noise {one['noise_class']}",
    "mass": lambda one: "with mass" if one["mass"] else "without mass",
    "stiffness": lambda one: "K fitted" if one["fits_stiffness"] else "K given",
}
HEADER = [
    "group",
    "parameter",
    "intervals",
    "contain_truth_percent",
    "standard_error_percent",
    "bias_in_standard_errors",
    "standard_error_of_bias",
    "median_half_width_percent",
    "failed_records",
]


def fitted(given, entry):
    """The answer for one record, or the words with which the command failed."""
    arguments = [*shlex.split(given.command), str(given.folder / entry["file"]), *entry["options"], "--json"]
    try:
        ended = subprocess.run(arguments, capture_output=True, text=True, timeout=given.seconds, check=False)
    except subprocess.TimeoutExpired:
        return f"no answer after {given.seconds} s"
    if ended.returncode:
        return f"exit code {ended.returncode}: {ended.stderr.strip()[-300:]}"
    if given.answers:
        (given.answers / Path(entry["file"]).with_suffix(".json")).write_text(ended.stdout)
    try:
        answer = json.loads(ended.stdout)
        return {name: {key: float(answer[name][key]) for key in ("value", "error", "low", "high")} for name in entry["fitted"]}
    except (ValueError, KeyError, TypeError) as error:
        return f"an answer without {error!r}: {ended.stdout[:200]}"


def rows_of(group, answers):
    """Rows of the table for one group of (entry, answer)."""
    failed = sum(isinstance(answer, str) for _, answer in answers)
    parameters = dict.fromkeys(parameter for entry, _ in answers for parameter in entry["fitted"])
    for parameter in parameters:
        found = [(one[parameter], entry["truth"][parameter]) for entry, one in answers if not isinstance(one, str) and parameter in one]
        if not found:
            continue
        inside = np.mean([one["low"] <= truth <= one["high"] for one, truth in found])
        pulls = np.array([(one["value"] - truth) / one["error"] for one, truth in found])
        halves = [(one["high"] - one["low"]) / 2 / abs(truth) for one, truth in found]
        n = len(found)
        bias, spread = pulls.mean(), pulls.std() / sqrt(n)
        numbers = [100 * inside, 100 * sqrt(LEVEL * (1 - LEVEL) / n), bias, spread, 100 * np.median(halves)]
        yield [group, parameter, n, *(f"{number:.3g}" for number in numbers), failed]


def table(answers):
    for of_entry in GROUPS.values():
        for group in sorted({of_entry(entry) for entry, _ in answers}):
            yield from rows_of(group, [pair for pair in answers if of_entry(pair[0]) == group])


def outside(rows):
    """Sentences on shares over all records that are outside of the accepted range."""
    for row in rows:
        bound = BOUND * sqrt(BOUND_RECORDS / row[2])
        if row[0] == "all records" and abs(float(row[3]) / 100 - LEVEL) > bound + 1e-9:
            yield f"{row[1]}: {row[3]} % of {row[2]} intervals contain the truth, accepted are {95 - 100 * bound:.1f} to {95 + 100 * bound:.1f} %"


def main():
    given = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    given.add_argument("folder", type=Path)
    given.add_argument("--command", required=True)
    given.add_argument("--records", type=int, help="the first N of the manifest only")
    given.add_argument("--jobs", type=int, default=2)
    given.add_argument("--seconds", type=float, default=120.0, help="a command that runs longer has failed")
    given.add_argument("--csv", type=Path)
    given.add_argument("--answers", type=Path)
    given = given.parse_args()
    entries = json.loads((given.folder / "manifest.json").read_text())["records"][: given.records]
    if given.answers:
        given.answers.mkdir(parents=True, exist_ok=True)
    with ThreadPool(given.jobs) as pool:
        results = pool.map(partial(fitted, given), entries, chunksize=1)
    answers = list(zip(entries, results))
    rows = list(table(answers))
    for row in [HEADER, *rows]:
        print("{:<15}{:<26}{:>10}{:>22}{:>23}{:>24}{:>23}{:>26}{:>15}".format(*map(str, row)))
    if given.csv:
        with open(given.csv, "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([HEADER, *rows])
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{len(entries)} records, {(spent.ru_utime + spent.ru_stime) / len(entries):.3g} s of CPU time for each")
    failures = [f"{entry['file']}: {answer}" for entry, answer in answers if isinstance(answer, str)]
    complaints = [*failures, *outside(rows)]
    print("\n".join(complaints))
    return int(len(failures) > MOST_FAILURES * len(entries) or len(complaints) > len(failures))


if __name__ == "__main__":
    sys.exit(main())
