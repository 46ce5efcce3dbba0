"""Laps of the slider's limit cycle where integrators go wrong, by a program unrelated to slipmode.

Radau IIA with nine stages in balls of FLINT at 640 bits, whose radii are dropped after each operation that joins steps: the
equations in x = ln(V/V_l), y = ln(V_l theta/D_c), z = (spring stress/sigma - mu0)/a, full Newton iteration, steps by the size of the
collocation polynomial's last coefficient, and events by repeating the step that holds them. Every lap is run at two tolerances; the
digits in which both agree are kept.

usage: python3 simulation.py > simulation-hard.txt
"""
import sys

from flint import arb, arb_mat, ctx, fmpq, fmpq_poly

ctx.prec = 640
STAGES = 9


def nodes():
    """Right Radau points on [0, 1]: roots of P_s - P_(s-1), shifted."""
    def legendre(n):
        older, old = fmpq_poly([1]), fmpq_poly([-1, 2])
        if n == 0:
            return older
        for k in range(1, n):
            older, old = old, ((2 * k + 1) * fmpq_poly([-1, 2]) * old - k * older) / fmpq(k + 1)
        return old
    polynomial = legendre(STAGES) - legendre(STAGES - 1)
    roots = [root.real for root, _ in polynomial.numer().complex_roots()]
    return sorted((root.mid() for root in roots), key=lambda root: float(root))


C = nodes()


def inverse_matrix():
    """A from the order conditions: A V = W with V_ij = c_i^(j-1) and W_ij = c_i^j / j; and the weights of the last divided difference."""
    v = arb_mat([[c ** j for j in range(STAGES)] for c in C])
    w = arb_mat([[c ** (j + 1) / (j + 1) for j in range(STAGES)] for c in C])
    a = w * v.inv()
    points = [arb(0)] + C
    last = []
    for i, p in enumerate(points):
        product = arb(1)
        for j, q in enumerate(points):
            if i != j:
                product *= p - q
        last.append((1 / product).mid())
    return [[a[i, j].mid() for j in range(STAGES)] for i in range(STAGES)], last


A, LAST = inverse_matrix()


class Slider:
    def __init__(self, law, eta, kappa, beta):
        self.law, self.eta, self.kappa, self.beta = law, arb(eta), arb(kappa), arb(beta)

    def rate(self, s):
        x, y, z = s
        e = x.exp()
        healing = -e * (x + y) if self.law == "slip" else (-y).exp() - e
        return [(z - x - self.beta * y) / (e * self.eta), healing, self.kappa * (1 - e)]

    def jacobian(self, s):
        x, y, z = s
        e = x.exp()
        i = 1 / (e * self.eta)
        row = [-e * (x + y) - e, -e] if self.law == "slip" else [-e, -(-y).exp()]
        return [[-(z - x - self.beta * y) * i - i, -self.beta * i, i], row + [arb(0)], [-self.kappa * e, arb(0), arb(0)]]


def step(slider, start, h, guess=None):
    """The stages of one step, or None when Newton's iteration does not end."""
    stages = [list(row) for row in guess] if guess else [list(start) for _ in range(STAGES)]
    size = 3 * STAGES
    for _ in range(14):
        rates = [slider.rate(stage) for stage in stages]
        jacobians = [slider.jacobian(stage) for stage in stages]
        matrix, right = [[arb(0)] * size for _ in range(size)], []
        for i in range(STAGES):
            for k in range(3):
                total = stages[i][k] - start[k]
                for j in range(STAGES):
                    total -= h * A[i][j] * rates[j][k]
                    for l in range(3):
                        matrix[3 * i + k][3 * j + l] = (-h * A[i][j] * jacobians[j][k][l] + (1 if i == j and k == l else 0)).mid()
                right.append([total.mid()])
        try:
            move = arb_mat(matrix).solve(arb_mat(right), algorithm="approx")
        except Exception:
            return None
        largest = 0.0
        for i in range(STAGES):
            for k in range(3):
                change = move[3 * i + k, 0].mid()
                largest = max(largest, abs(float(change)))
                stages[i][k] = (stages[i][k] - change).mid()
        if not largest < 1e3:
            return None
        if largest < 1e-28:
            return stages
    return None


def last_coefficient(start, stages):
    points = [start] + stages
    return max(abs(float(sum(w * p[k] for w, p in zip(LAST, points)))) for k in range(3)) / 4 ** STAGES


def event(slider, start, h, of):
    """The step, by the secant method safeguarded by halving, at whose end `of` vanishes."""
    low, high = arb(0), h
    sign = lambda value: float(value) > 0
    at_low, at_high = of(start), of(step(slider, start, h)[-1])
    for k in range(120):
        guess = (low - at_low * (high - low) / (at_high - at_low)).mid() if k % 3 else ((low + high) / 2).mid()
        stages = step(slider, start, guess)
        value = of(stages[-1])
        if abs(float(value)) == 0.0 or float((high - low) / h) < 1e-26:
            break
        if sign(value) == sign(at_low):
            low, at_low = guess, value
        else:
            high, at_high = guess, value
    return guess, stages[-1]


def lap(slider, start, tolerance):
    """Largest x, least x and duration up to the next upward passage of x = 0; and the steps."""
    state, time, h, steps = [arb(s) for s in start], arb(0), arb("1e-6"), 0
    slope = lambda s: s[2] - s[0] - slider.beta * s[1]
    peak, trough = None, None
    while steps < 60000:
        stages = step(slider, state, h)
        error = last_coefficient(state, stages) if stages else 1e9
        factor = min(2.0, 0.8 * (tolerance / max(error, 1e-300)) ** (1 / (STAGES + 1)))
        if error > tolerance:
            h = (h * arb(max(0.1, min(0.7, factor)))).mid()
            continue
        steps += 1
        end = stages[-1]
        before, after = float(slope(state)) > 0, float(slope(end)) > 0
        if before != after:
            _, extreme = event(slider, state, h, slope)
            if before and (peak is None or float(extreme[0]) > float(peak)):
                peak = extreme[0]
            if after and (trough is None or float(extreme[0]) < float(trough)):
                trough = extreme[0]
        if float(state[0]) < 0 <= float(end[0]):
            taken, _ = event(slider, state, h, lambda s: s[0])
            return peak, trough, (time + taken).mid(), steps
        state, time = end, (time + h).mid()
        h = (h * arb(factor)).mid()
    raise SystemExit("no passage")


def agreed(one, other):
    """The digits in which two results agree, at most 17."""
    difference = abs(float((one - other) / other))
    digits = 17
    while digits > 1 and difference > 0.3 * 10.0 ** -digits:
        digits -= 1
    return other.str(digits, radius=False), digits


# family, law, eta, kappa, beta, y and z on V = V_l
CASES = [line.split() for line in """\
sticks-to-1e-65 slip 7.905694150420949e5 7.905694150420949e1 1.5e0 1.0208158868067925e-2 7.906291591181569e3
sticks-to-1e-79 aging 7.905694150420949e5 7.905694150420949e1 1.5e0 1.0263565779910642e-2 7.906780496264273e3
widest-rates slip 7.905694150420949e-10 7.905694150420948e-4 1.5e0 3.021136844325667e0 4.531705270071128e0
widest-rates aging 7.905694150420949e-10 7.905694150420948e-4 1.5e0 5.601239114884322e0 8.40185867350796e0
stick-slip slip 7.905694150420949e-8 7.90569415042095e-3 1.5e0 2.2452050759485314e0 3.3678078801712146e0
stick-slip aging 7.905694150420949e-8 7.90569415042095e-3 1.5e0 4.58699243252177e0 6.880488766160432e0
below-transition slip 0.025 0.51244875 1.5 0 1
below-transition aging 0.025 0.51244875 1.5 0 1
above-transition slip 0.025 0.51255125 1.5 0 1
above-transition aging 0.025 0.51255125 1.5 0 1
below-transition-small slip 0.025 0.51244875 1.5 0 1e-6
above-transition-small aging 0.025 0.51255125 1.5 0 1e-6
no-inertia slip 1e-20 0.1 1.5 0 1
""".splitlines()]


def main():
    print("# Laps of the slider in units of V_l, D_c/V_l and a sigma: from x = ln(V/V_l) = 0, y, z to the next upward passage of V = V_l.")
    print("# Made by simulation.py (python-flint, Radau IIA with nine stages at 640 bits); digits in which two tolerances agree.")
    print("family,law,inertial_parameter,stiffness_group,effect_ratio,start_y,start_z,expected_log_peak,expected_log_trough,expected_duration")
    for case in CASES:
        family, law, eta, kappa, beta, y, z = case
        slider = Slider(law, eta, kappa, beta)
        size = min(1.0, float(z) ** 2)
        loose = lap(slider, ["0", y, z], 1e-13 * size)
        tight = lap(slider, ["0", y, z], 1e-15 * size)
        results = [agreed(a, b) for a, b in zip(loose[:3], tight[:3])]
        print(",".join([family, law, eta, kappa, beta, y, z] + [text for text, _ in results]), flush=True)
        print(family, law, "steps", loose[3], tight[3], "digits", [d for _, d in results], file=sys.stderr, flush=True)


main()
