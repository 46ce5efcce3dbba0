"""CPU time of the Python package and of numpy.roots for 1, 10^3 and 10^6 sliders, as a table in Markdown.

`python python_times.py` needs NumPy and the wheel of slipmode. Times are the least of several turns, user and system, of all threads.
"""

import time
from collections.abc import Callable

import numpy as np
import slipmode

#: Decades of the seven inputs, in SI.
DECADES = {"a": (-3, -1), "b": (-3, -1), "d_c": (-6, -3), "k": (7, 11), "m": (1, 4), "sigma": (4, 9), "v": (-8, -1)}


def cpu_seconds(work: Callable[[], object], turns: int) -> float:
    """Return the CPU time of one call, the least of some turns."""
    times = []
    for _ in range(turns):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def cubics(a, b, d_c, k, m, sigma, v):
    """Return the coefficients of eq 8 in 1/s, highest first: M D_c s³ + (M V + a σ D_c/V)·s² + ((a − b)·σ + K D_c)·s + K V."""
    return np.stack([m * d_c, m * v + a * sigma * d_c / v, (a - b) * sigma + k * d_c, k * v], axis=-1)


def main() -> None:
    """Print the table."""
    random = np.random.default_rng(7)
    print("| sliders | `classify` | `roots` | `numpy.roots`, one by one |\n|---|---|---|---|")
    for count in (1, 1000, 1_000_000):
        columns = {name: 10 ** random.uniform(*ends, count) for name, ends in DECADES.items()}
        if count == 1:
            scalars = {name: float(array[0]) for name, array in columns.items()}
            one = cubics(**scalars)
            calls = [lambda: slipmode.classify(**scalars), lambda: slipmode.roots(**columns), lambda: np.roots(one)]
            repeat = 2000
            times = [cpu_seconds(lambda call=call: [call() for _ in range(repeat)], 5) / repeat for call in calls]
        else:
            rows = cubics(**columns)
            calls = [lambda: slipmode.classify(**columns), lambda: slipmode.roots(**columns)]
            times = [cpu_seconds(call, 5) for call in calls]
            times.append(cpu_seconds(lambda: [np.roots(row) for row in rows], 1))
        print(f"| {count} | " + " | ".join(f"{seconds * 1e6:.3g} µs" for seconds in times) + " |")


if __name__ == "__main__":
    main()
