"""Compares the optima that two programs found for the same records.

    python3 tests/independent/fit/same_optimum.py FOLDER ANSWERS OTHER_ANSWERS

FOLDER has manifest.json. The folders of answers are those of coverage.py --answers, one JSON file per record. Differences are
relative for a, b, D_c and K, in units of a for mu_0 and in units of a/D_c for the drift; the exit code is 1 if one exceeds 1e-6.
Differences in standard errors are printed, too: they tell what a difference means for the result.
"""

import json
import sys
from pathlib import Path

from model import NAMES
from optimum import LOGARITHMIC, TOLERANCE


def units(truth):
    """What a difference of each parameter is divided by."""
    found = {NAMES[name]: abs(truth[NAMES[name]]) for name in LOGARITHMIC}
    a, d_c = truth[NAMES["a"]], truth[NAMES["d_c"]]
    return found | {NAMES["mu_0"]: a, NAMES["drift"]: a / d_c}


def differences(entry, mine, theirs):
    """(parameter, difference in its unit, difference in standard errors) for each fitted parameter."""
    of = units(entry["truth"])
    for name in entry["fitted"]:
        apart = abs(mine[name]["value"] - theirs[name]["value"])
        yield name, apart / of[name], apart / mine[name]["error"]


def main():
    folder, *answers = map(Path, sys.argv[1:])
    records = json.loads((folder / "manifest.json").read_text())["records"]
    found, missing = {}, 0
    for entry in records:
        files = [path / Path(entry["file"]).with_suffix(".json") for path in answers]
        if not all(path.exists() for path in files):
            missing += 1
            continue
        for name, *apart in differences(entry, *(json.loads(path.read_text()) for path in files)):
            found.setdefault(name, []).append((*apart, entry["file"]))
    print(f"{len(records) - missing} records compared, {missing} without two answers")
    for name, rows in found.items():
        above = [file for apart, _, file in rows if not apart <= TOLERANCE]
        largest, errors = max(row[0] for row in rows), max(row[1] for row in rows)
        print(
            f"{name}: largest difference {largest:.2g} ({errors:.2g} standard errors), {len(above)} of {len(rows)} above {TOLERANCE:g}",
            *above[:5],
        )
    return int(any(not row[0] <= TOLERANCE for rows in found.values() for row in rows))


if __name__ == "__main__":
    sys.exit(main())
