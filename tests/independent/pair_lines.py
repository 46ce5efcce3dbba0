"""The lines of a given share of the natural frequency and of a given damping ratio, from the roots of eq 8 by mpmath, against
`slipmode boundary --frequency-ratio` and `--damping-ratio`.

At random b/a, ratio and V0 each normal stress that the command prints must give a pair of this ratio and real part, and the pair
must be above or below the line on a grid of normal stresses as the number of printed ones says. No formula of the line is used.

    python3 tests/independent/pair_lines.py target/release/slipmode [CASES]
"""

import random
import subprocess
import sys

from mpmath import mp, mpf, polyroots, sqrt

mp.dps = 40
# The paper's machine: D_c, K, M.
SLIP, STIFFNESS, MASS = mpf("1e-5"), mpf("1e7"), mpf("1000")
DIRECT = "0.004"
DIGITS = 25
GRID = [mpf(10) ** (mpf(step) / 4) for step in range(0, 48)]


def pair(evolution, stress, velocity):
    """ω/ω_n, −Re(s)/|s| and Re(s) D_c/V0 of the pair of eq 8; where all roots are real, those of the largest root."""
    direct = mpf(DIRECT)
    cubic = [
        MASS,
        direct * stress / velocity + MASS * velocity / SLIP,
        STIFFNESS + (direct - evolution) * stress / SLIP,
        STIFFNESS * velocity / SLIP,
    ]
    scale = sqrt(STIFFNESS / MASS)
    scaled = [coefficient * scale ** (-power) for power, coefficient in enumerate(cubic)]
    roots = polyroots([part / scaled[0] for part in scaled], maxsteps=400, extraprec=300)
    root = max(roots, key=lambda root: (root.imag > mpf(10) ** -25, root.real))
    frequency = root.imag if root.imag > mpf(10) ** -25 else mpf(0)
    return frequency, -root.real / sqrt(root.real**2 + frequency**2), root.real * scale * SLIP / velocity


def printed(command, evolution, line, velocity):
    """The rows of the command."""
    arguments = ["-a", DIRECT, "-b", evolution, "-d", "1e-5", "-k", "1e7", "-m", "1000", "--digits", str(DIGITS)]
    asked = ["boundary", *line, "--at-velocity", velocity]
    text = subprocess.run([command, *asked, *arguments], capture_output=True, text=True, check=True).stdout
    head, *rows = (row.split(",") for row in text.splitlines())
    return [dict(zip(head, row)) for row in rows]


def faults(command, case):
    """What is wrong at a random case, in words."""
    source = random.Random(f"frequency line {case}")
    evolution = f"{float(DIRECT) * 10 ** source.uniform(-1.5, 1.5):.6g}" if case % 10 else DIRECT
    ratio, velocity = f"{source.uniform(0.01, 0.99):.5f}", f"{10 ** source.uniform(-5, 2):.4e}"
    of_damping = case % 2 == 1
    if of_damping and source.random() < 0.5:
        ratio = f"-{ratio}"
    line = ["--damping-ratio" if of_damping else "--frequency-ratio", ratio]
    rows = printed(command, evolution, line, velocity)
    evolution, ratio, velocity = mpf(evolution), mpf(ratio), mpf(velocity)
    found, stresses = [], [mpf(row["normal_stress_pa"]) for row in rows]
    for row, stress in zip(rows, stresses):
        *both, real = pair(evolution, stress, velocity)
        if abs(both[of_damping] / ratio - 1) > mpf(10) ** -18:
            found.append(f"the ratio is {both[of_damping]} at {stress} Pa")
        if abs(real - mpf(row["real_part"])) > mpf(10) ** -15 * (1 + abs(real)):
            found.append(f"the real part is {real} at {stress} Pa, printed {row['real_part']}")
        if row["transition_sign"] != str((real < 0) - (real > 0)):
            found.append(f"transition_sign {row['transition_sign']} with the real part {real}")
    # As σ → 0 the pair tends to ±iω_n: ω/ω_n is above every ratio below 1, and ζ is below a positive and above a negative one.
    starts_above = not of_damping or ratio < 0
    for stress in GRID:
        is_above = pair(evolution, stress, velocity)[of_damping] > ratio
        if is_above != (starts_above == (sum(other < stress for other in stresses) % 2 == 0)):
            found.append(f"at {stress} Pa the pair is {'above' if is_above else 'below'}; printed {stresses}")
    return [f"b = {evolution}, {' '.join(line)}, V0 = {velocity}: {words}" for words in found]


def main():
    command, cases = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    found = [words for case in range(cases) for words in faults(command, case)]
    print("\n".join([*found, f"{cases} cases, {len(found)} contradictions"]))
    sys.exit(1 if found else 0)


main()
