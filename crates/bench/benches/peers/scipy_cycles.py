"""SciPy: one stick-slip cycle by Radau, LSODA and BDF with the analytic Jacobian."""

import math

import numpy
import scipy
from common import TOLERANCES, best_of, main, model_lines, row
from scipy.integrate import solve_ivp

METHODS = ["Radau", "LSODA", "BDF"]
OPTIONS = "analytic~Jacobian;events=crossing+peak"


def slider(aging, eta, kappa, beta):
    """The rate and its Jacobian in x = ln(V/V_l), y = ln(V_l theta/D_c), zeta."""

    def rate(_, state):
        x, y, z = state
        u = math.exp(x)
        evolution = math.exp(-y) - u if aging else -u * (x + y)
        return [(z - x - beta * y) / (u * eta), evolution, -kappa * math.expm1(x)]

    def jacobian(_, state):
        x, y, z = state
        u = math.exp(x)
        stiff = 1 / (u * eta)
        second = [-u, -math.exp(-y), 0] if aging else [-u * (x + y + 1), -u, 0]
        return numpy.array([[-stiff * (1 + z - x - beta * y), -stiff * beta, stiff], second, [-kappa * u, 0, 0]])

    return rate, jacobian


def cycle(method, law, groups, start, until, tolerance):
    """Peak and duration from V = V_l to its next upward passage; None where the solver gives up or the passage is missed."""
    rate, jacobian = slider(law == "aging", *groups)

    def rises(_, state):
        return state[0]

    def peaks(_, state):
        # Below V_l the derivative is rounding noise.
        return rate(0, state)[0] if state[0] > 0 else 1.0

    # The start lies on the section and counts as a passage: the second one ends the run.
    rises.direction, rises.terminal, peaks.direction = 1, 2, -1
    try:
        done = solve_ivp(
            rate, (0, 1.5 * until), start, method, jac=jacobian, rtol=tolerance, atol=tolerance, events=(rises, peaks)
        )
    except (ArithmeticError, ValueError, numpy.linalg.LinAlgError):
        return None
    if done.status != 1 or not len(done.y_events[1]):
        return None
    return max(state[0] for state in done.y_events[1]), done.t_events[0][-1], len(done.t) - 1, done.nfev


def cycles(_):
    """Every case, method and tolerance, once: a cycle takes long enough."""
    for name, law, numbers in model_lines("cycles.txt"):
        start, peak, duration = numbers[3:6], numbers[6], numbers[7]
        for method in METHODS:
            for tolerance in TOLERANCES[:20]:
                seconds, found = best_of(1, lambda: cycle(method, law, numbers[:3], start, duration, tolerance))
                work, label = f"cycles-{name}", f"scipy-{method}"
                if found is None:
                    row(work, label, OPTIONS, 1, seconds, None, 1, tolerance)
                    continue
                error = max(abs(found[0] - peak), abs(found[1] / duration - 1))
                row(work, label, OPTIONS, 1, seconds, error, 0, tolerance, found[2], found[3])


main({"cycles": cycles}, f"SciPy {scipy.__version__}")
