"""Compares the verdicts of claims with their truth at random points: an independent program for slipmode's language of claims.

    python3 tests/independent [REPORT ...] [--points N] [--seed N] [--self-test]
    python3 tests/independent --claims FILE --equations FILE --ledger FILE

REPORT is a folder with claims.toml, equations.toml and published/ledger.json or ledger.json; without one, all of reports/ are
compared. It exits with 1 when a verdict is contradicted, with 2 when the input cannot be read.
"""

import argparse
import sys
from functools import partial
from multiprocessing import Pool
from pathlib import Path

from claims import read_report
from decide import compare
from language import Unreadable
from planted import self_test

REPORTS = Path(__file__).resolve().parents[2] / "reports"


def options():
    parser = argparse.ArgumentParser(prog="independent", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reports", nargs="*", type=Path)
    parser.add_argument("--claims", type=Path)
    parser.add_argument("--equations", type=Path)
    parser.add_argument("--ledger", type=Path)
    parser.add_argument("--points", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, help="processes at a time (default: one for each processor)")
    parser.add_argument("--self-test", action="store_true", help="plant wrong verdicts and wrong equations, and count those noticed")
    parser.add_argument("--quiet", action="store_true", help="print contradictions and the last line only")
    return parser.parse_args()


def files(given):
    """Claims, equations and ledger of each report."""
    if given.claims or given.equations:
        if not (given.claims and given.equations):
            raise Unreadable("--claims and --equations stand beside each other")
        return [(given.claims, given.equations, given.ledger)]
    folders = given.reports or sorted(path.parent for path in REPORTS.glob("*/claims.toml"))
    found = []
    for folder in folders:
        ledgers = [given.ledger] if given.ledger else [folder / "published/ledger.json", folder / "ledger.json"]
        ledger = next((path for path in ledgers if path.exists()), None)
        found.append((folder / "claims.toml", folder / "equations.toml", ledger))
    return found


def line(name, formula, tally):
    state = "CONTRADICTED" if tally.contradiction else formula.verdict
    words = tally.contradiction or tally.remark
    return f"{name}: {formula.id}: {state}: {tally.decided} of {tally.tried} points decided{'; ' + words if words else ''}"


def run(given, pool):
    """Prints a line for each formula, and a closing one."""
    counts = {"formulas": 0, "points": 0, "decided": 0, "contradictions": 0, "open": 0}
    skipped = {}
    for claims, equations, ledger in files(given):
        report = read_report(claims, equations, ledger)
        for key, count in report.skipped.items():
            skipped[key] = skipped.get(key, 0) + count
        compared = partial(compare, names=report.names, count=given.points, seed=f"{given.seed} {claims.parent.name}")
        for formula, tally in zip(report.formulas, pool.imap(compared, report.formulas)):
            counts["formulas"] += 1
            counts["points"] += tally.tried
            counts["decided"] += tally.decided
            counts["contradictions"] += bool(tally.contradiction)
            counts["open"] += not tally.decided and not tally.contradiction
            if tally.contradiction or not given.quiet:
                print(line(claims.parent.name, formula, tally), flush=True)
    left = ", ".join(f"{count} {word}" for word, count in skipped.items())
    print(f"{counts['formulas']} formulas, {counts['points']} points, {counts['decided']} decided, {counts['open']} formulas without a decided point, {counts['contradictions']} contradictions (not compared: {left})")
    return 1 if counts["contradictions"] else 0


def main():
    given = options()
    try:
        with Pool(given.jobs) as pool:
            return self_test(files(given), given.points, given.seed, pool) if given.self_test else run(given, pool)
    except Unreadable as error:
        print(f"independent: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
