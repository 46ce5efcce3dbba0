"""The cycles and decays of reports/im-avouac/vectors/certified-*.csv by heyoka in quadruple precision: references for the stored bounds.

Usage: python stored_certificates.py slip aging > stored-certificates.txt (heyoka 7.13, numpy 2.4, mpmath 1.4).
"""

import csv
import sys
from fractions import Fraction
from pathlib import Path

import mpmath
from estimated_errors import LEAST_INERTIA, smooth_amplitude
from taylor import QUADRUPLE, Taylor, fraction, number

REPORT = Path(__file__).parents[2] / "reports/im-avouac/vectors"
# From here on Newton's iteration finds the cycle in double precision.
NEAR = 1e-6
# The amplitude of a vibration that soon stops.
LARGER = 1.1
mpmath.mp.dps = 40


def start(run):
    """Steady sliding at V_l/10."""
    x = -number(Fraction(*mpmath.log(10).as_integer_ratio()), run.real)
    return [x, -x, x]


def near_cycle(run):
    """A crossing of V = V_l upward near the cycle of a slider that stops, after up to 200 returns from a larger vibration or from V_l/10."""
    crossings = []

    def is_done(name, _, at):
        crossings.extend([at[1:]] if name == "rise" else [])
        return bool(crossings)

    if run.eta * run.kappa > LEAST_INERTIA:
        crossings.append(run.vibration(LARGER))
    else:
        run.follow(start(run), is_done)
    point = crossings[0]
    for _ in range(200):
        before, (point, _) = point, run.back(point)
        if max(abs(point[i] - before[i]) / (1 + abs(point[i])) for i in (0, 1)) < NEAR:
            break
    return point


def cycle(groups, rough, runs):
    """What the limit cycle shows by each of the two runs, and the last step of Newton's iteration."""
    amplitude, inverse, found, most = smooth_amplitude(rough.law, *groups), None, [], 0.0
    if amplitude is None:
        point, _, _, inverse = rough.fixed_point(near_cycle(rough), 1e-7)
        point = [QUADRUPLE(c) for c in point]
    else:
        point = runs[0].vibration(amplitude)
    for run in runs:
        point, shown, left, inverse = run.fixed_point(point, 1e-20, inverse)
        found.append([shown[0], shown[3], shown[2]])
        most = max(most, left)
    return found, most


def decay(run):
    """Largest x and stress drop of the run from V_l/10, steady sliding included."""
    first = start(run)
    stresses, largest = [run.real(0), run.stress(first)], [run.real(0)]

    def is_done(name, _, at):
        if name == "peak":
            largest.append(at[0])
        elif name in ("rise", "fall"):
            stresses.append(run.stress(at))
        # Later extremes are smaller once the oscillation has shrunk.
        small = max(largest) / 100 if len(stresses) > 3 else 0
        return name == "step" and max(abs(c) for c in at) < max(small, 1e-13)

    run.follow(first, is_done)
    return [max(largest), None, max(stresses) - min(stresses)]


def reference(row, rough, runs):
    """Peak velocity, period (of a cycle) and stress drop in SI, and the largest relative error."""
    a, b, d_c, k, m, sigma, velocity = (Fraction(row[name]) for name in list(row)[:7])
    groups = m * velocity**2 / (a * sigma * d_c), k * d_c / (a * sigma), b / a
    for run in (rough, *runs):
        run.set(*groups)
    found, left = cycle(groups, rough, runs) if row["certificate"] == "cycle" else ([decay(run) for run in runs], 0.0)
    units = [velocity, d_c / velocity, a * sigma]
    coarse, fine = ([value if value is None else exact(fraction(value)) for value in values] for values in found)
    for values in (coarse, fine):
        values[0] = mpmath.exp(values[0])
    # What Newton's last step leaves, and rounding to eighteen digits.
    error = max(abs(c / f - 1) for c, f in zip(coarse, fine, strict=True) if f is not None) + left + 1e-17
    return [None if value is None else value * exact(unit) for value, unit in zip(fine, units, strict=True)], error


def exact(value):
    return mpmath.mpf(value.numerator) / value.denominator


def references(law):
    rough = Taylor(law, float, 6, 1e-9, 1e-12)
    runs = [Taylor(law, QUADRUPLE, 7, 1e-18, 1e-25, 1e-28), Taylor(law, QUADRUPLE, 8, 1e-22, 1e-28)]
    with open(REPORT / f"certified-{law}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for at, row in enumerate(rows, 1):
        try:
            values, error = reference(row, rough, runs)
        except (ArithmeticError, KeyError) as failure:
            print(f"# no reference: {law},{at}: {failure}", flush=True)
            continue
        cells = ["" if value is None else mpmath.nstr(value, 18, strip_zeros=False) for value in values]
        print(",".join([law, str(at), row["certificate"], *cells, f"{float(error):.0e}"]), flush=True)


def main(laws):
    print("law,row,certificate,peak_velocity_m_per_s,period_s,stress_drop_pa,relative_error")
    for law in laws:
        references(law)


if __name__ == "__main__":
    main(sys.argv[1:])
