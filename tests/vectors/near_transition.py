"""Limit cycles just below K_c at small eta, by heyoka: references for the estimated errors of `simulate` where a fixed point magnifies rounding.

Usage: python near_transition.py SEED SLIDERS > near-transition.txt (numpy 2.4, heyoka 7.13, mpmath 1.4).
"""

import math
import random
import sys
from fractions import Fraction

import mpmath
from taylor import QUADRUPLE, Taylor, fraction

MOST_RETURNS = 200
NEAR = 1e-4


def sample(seed, count):
    """The sliders: b/a from 1.1 to 3, uniform; eta from 1e-9 to 1e-5 and 1 - K/K_c from 10^-2.8 to 10^-1.7, uniform in the logarithm."""
    draw = random.Random(seed)
    for at in range(count):
        b, mass = f"{0.01 * draw.uniform(1.1, 3.0):.4g}", f"{0.1 * 10 ** draw.uniform(-9, -5):.3e}"
        beta, eta = float(b) / 0.01, float(mass) / 0.1
        stiffness = f"{1e9 * (1 - 10 ** draw.uniform(-2.8, -1.7)) * (beta - 1) * (1 + eta):.9e}"
        yield "aging" if at % 4 == 3 else "slip", b, stiffness, mass


def near_cycle(run):
    """A crossing (y, w) near the cycle, after returns from steady sliding at V0/10."""
    crossings = []

    def is_done(name, _, at):
        crossings.extend([at[1:]] if name == "rise" else [])
        return bool(crossings)

    run.follow([-math.log(10), math.log(10), -math.log(10)], is_done)
    point = crossings[0]
    for _ in range(MOST_RETURNS):
        before, (point, _) = point, run.back(point)
        if max(abs(point[i] - before[i]) / (1 + abs(point[i])) for i in (0, 1)) < NEAR:
            break
    return point


def exact(value):
    return mpmath.mpf(value.numerator) / value.denominator


def reference(rough, runs, b, stiffness, mass):
    """ln V_peak/V0, ln V_min/V0, stress drop in a sigma and period in D_c/V0, each with the difference of two runs."""
    groups = Fraction(mass) * 10, Fraction(stiffness) / 10**9, Fraction(b) * 100
    for run in (rough, *runs):
        run.set(*groups)
    point, inverse, found = [QUADRUPLE(c) for c in near_cycle(rough)], None, []
    for run in runs:
        if inverse is None:
            point, _, _, _ = run.fixed_point(point, 1e-6)
        point, shown, left, inverse = run.fixed_point(point, 1e-19, inverse)
        found.append([exact(fraction(value)) for value in shown])
        print(f"# left {left:.1e}", file=sys.stderr)
    return [(fine, abs(coarse - fine) + abs(fine) * mpmath.mpf("1e-18")) for coarse, fine in zip(*found, strict=True)]


def main(seed, count):
    mpmath.mp.dps = 40
    rough = {law: Taylor(law, float, 6, 1e-9, 1e-12) for law in ("slip", "aging")}
    runs = {
        law: [Taylor(law, QUADRUPLE, 7, 1e-18, 1e-25, 1e-28), Taylor(law, QUADRUPLE, 8, 1e-22, 1e-28)] for law in ("slip", "aging")
    }
    print("law,evolution_effect,stiffness_pa_per_m,mass_per_area_kg_per_m2,log_peak,log_peak_error,log_trough,log_trough_error,stress_drop,stress_drop_error,period,period_error")
    for law, *slider in sample(seed, count):
        try:
            pairs = reference(rough[law], runs[law], *slider)
        except (ArithmeticError, KeyError) as failure:
            print(f"# no reference: {law},{','.join(slider)}: {failure}", flush=True)
            continue
        values = ",".join(f"{mpmath.nstr(value, 18)},{mpmath.nstr(error, 2)}" for value, error in pairs)
        print(",".join([law, *slider, values]), flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
