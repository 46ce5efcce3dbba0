"""What the Python players share: CPU time, the fastest of several runs, and the row that every player prints."""

import sys
import time
from pathlib import Path

FOLDER = Path(sys.argv[2]) if len(sys.argv) > 2 else Path()


def best_of(repetitions, work):
    """CPU seconds of the fastest run, and what the last one made."""
    best = float("inf")
    for _ in range(repetitions):
        start = time.process_time()
        made = work()
        best = min(best, time.process_time() - start)
    return best, made


# Tolerances of every method with one: 10^-1.5, 10^-2 ... 10^-12.
TOLERANCES = [10.0 ** (-0.5 * halves) for halves in range(3, 25)]


def row(work, method, options, items, seconds, error=None, wrong=0, tolerance=None, steps="-", evaluations="-"):
    """Prints one measurement; options are words joined by `;` with `~` for a blank, an error below the range of a float comes as text."""

    def number(value):
        return "-" if value is None else value if isinstance(value, str) else f"{value:.2e}"

    print(
        f"row work={work} method={method} options={options} tolerance={number(tolerance)} items={items} seconds={seconds:.6e}"
        f" error={number(error)} wrong={wrong} steps={steps} evaluations={evaluations}",
        flush=True,
    )


def model_lines(name):
    """Lines of an input file of simulations: name, law, numbers."""
    for line in (FOLDER / name).read_text().splitlines():
        cells = line.split()
        yield cells[0], cells[1], [float(cell) for cell in cells[2:]]


def main(works, version):
    """Answers `version`, or plays one work: `script.py work folder`."""
    work = sys.argv[1]
    if work == "version":
        print(version)
        return
    kind, _, which = work.partition("-")
    works[kind](which)
