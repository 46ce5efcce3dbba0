"""Ranges of growth rate and frequency over boxes of parameters, against points of the boxes; how sharp they are, and what they cost.

    python3 tests/independent/boxes.py --command target/release/slipmode [--boxes N] [--percent P] [--up-to] [--points N] [--seed N]

A box has error bars of P % of all seven values, with --up-to of random widths up to P %. Its middle has random groups: M V0^2/(a sigma D_c) from
1e-4 to 100, K D_c/(a sigma) from 0.01 to 10 and b/a from 0.5 to 3. The roots at corners and random points come from Cardano's formulas here, and
share nothing with the program. The exit code is 1 if a value lies outside of its range by more than a part of 1e-6, the error of these formulas.

A range is too wide by (its width over that of the values that it says points have) - 1.
"""

import argparse
import cmath
import json
import random
import resource
import subprocess
import sys
from math import exp, log, pi, sqrt

NAMES = "abdkmsv"
QUANTITIES = ("max_real_per_s", "frequency_hz")
OUTSIDE = 1e-6


def drawn(seed, percent, up_to):
    """The middle of a box and its half-widths over the values."""
    draw = random.Random(seed)

    def between(low, high):
        return exp(draw.uniform(log(low), log(high)))

    a, d = between(0.003, 0.03), between(1e-7, 1e-3)
    b, m, k = a * between(0.5, 3), between(10, 1e5), between(1e5, 1e9)
    eta, kappa = between(1e-4, 1e2), between(1e-2, 1e1)
    s = k * d / (a * kappa)
    middle = [float(f"{value:.6g}") for value in (a, b, d, k, m, s, sqrt(eta * a * s * d / m))]
    return middle, [percent * (draw.random() if up_to else 1) / 100 for _ in NAMES]


def values(a, b, d, k, m, s, v):
    """The largest real part and the frequency of the roots of eq 8."""
    c3, c2, c1, c0 = d * m, m * v + a * d * s / v, (a - b) * s + k * d, k * v
    shift, p = c2 / (3 * c3), c1 / c3 - c2 * c2 / (3 * c3 * c3)
    q = 2 * shift**3 - shift * c1 / c3 + c0 / c3
    inner = cmath.sqrt((q / 2) ** 2 + (p / 3) ** 3)
    cube = max(-q / 2 + inner, -q / 2 - inner, key=abs) ** (1 / 3)
    turns = [cmath.exp(2j * pi * n / 3) * cube for n in range(3)]
    roots = [turn - p / (3 * turn) - shift for turn in turns]
    # One step of Newton's method mends what cancels.
    roots = [z - (((c3 * z + c2) * z + c1) * z + c0) / ((3 * c3 * z + 2 * c2) * z + c1) for z in roots]
    return max(z.real for z in roots), max(z.imag for z in roots) / (2 * pi)


def spent():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", required=True)
    for name, default in (("boxes", 100), ("percent", 10.0), ("points", 200), ("seed", 1)):
        parser.add_argument(f"--{name}", type=type(default), default=default)
    parser.add_argument("--up-to", action="store_true")
    options = parser.parse_args()
    excesses, times, outside = {name: [] for name in QUANTITIES}, [], 0
    for index in range(options.boxes):
        seed = f"{options.seed} {index}"
        middle, widths = drawn(seed, options.percent, options.up_to)
        cells = [f"{value!r}±{100 * width:.9f}%" for value, width in zip(middle, widths)]
        arguments = [part for name, cell in zip(NAMES, cells) for part in (f"-{name}", cell)]
        before = spent()
        ended = subprocess.run([options.command, "classify", "--json", *arguments], capture_output=True, text=True, check=True)
        times.append(1000 * (spent() - before))
        found = json.loads(ended.stdout)
        draw = random.Random(f"points {seed}")
        for point in range(options.points):
            shares = [draw.choice((-1, 1)) if point % 2 else draw.uniform(-1, 1) for _ in NAMES]
            at = values(*(value * (1 + share * width) for value, share, width in zip(middle, shares, widths)))
            scale = max(abs(at[0]), at[1])
            for name, value in zip(QUANTITIES, at):
                low, high = found[name]
                if not low - OUTSIDE * scale <= value <= high + OUTSIDE * scale:
                    outside += 1
                    print(f"box {index}: {name} = {value} outside of {found[name]}")
        for name in QUANTITIES:
            (low, high), (least, greatest) = found[name], found["attained"][name]
            excesses[name].append(0.0 if high - low == greatest - least else (high - low) / (greatest - least) - 1 if greatest > least else 9.0)
    for name, all_of in excesses.items():
        counts = ", ".join(f"{sum(excess <= limit for excess in all_of)} up to {limit:g}" for limit in (1e-6, 0.01, 0.1))
        print(f"{name}: too wide by {counts} of {options.boxes}; most {max(all_of):.3g}")
    both = sum(max(pair) <= 0.01 for pair in zip(*excesses.values()))
    times.sort()
    print(f"both up to 0.01: {both}; CPU ms median {times[len(times) // 2]:.1f}, 90 % {times[len(times) * 9 // 10]:.1f}, most {times[-1]:.1f}")
    print(f"{options.points * options.boxes} points, {outside} values outside")
    return 1 if outside else 0


if __name__ == "__main__":
    sys.exit(main())
