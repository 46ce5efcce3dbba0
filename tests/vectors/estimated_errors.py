"""Limit cycles of randomly drawn sliders that vibrate or stop, by heyoka and SciPy: references for the estimated errors of `simulate`.

Usage: python estimated_errors.py SEED SLIDERS > estimated-errors.txt (numpy 2.4, scipy 1.17, heyoka 7.13).
"""

import math
import random
import sys
from fractions import Fraction

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from taylor import QUADRUPLE, Taylor

# Where ln(V/V0) is below -ln(eta kappa) by this much, a slider counts as at rest: it stops within e^-20 of the time in which stress
# is loaded by one unit, and x follows w as exactly. Then y and zeta follow from the exact solution at V = 0.
REST = 20.0
# An amplitude nearer to 1 may stop.
LEAST_DISTANCE = 1e-9
# From this eta kappa on the vibration is harmonic enough for its amplitude to follow from the energy of a return.
LEAST_INERTIA = 100.0


def sample(seed, count):
    """The sliders: b/a from 1.05 to 3, eta from 1e3 to 1e8 and K/K_c from 1e-4 to 1, uniform in the logarithm."""
    draw = random.Random(seed)
    for _ in range(count):
        beta = 10 ** draw.uniform(math.log10(1.05), math.log10(3.0))
        eta = 10 ** draw.uniform(3.0, 8.0)
        part = 10 ** draw.uniform(-4.0, 0.0)
        # a = 0.01, D_c = 1e-5 m, sigma = 1 MPa and V0 = 1 m/s: b and M are rounded before K is computed from K_c.
        b, mass = f"{0.01 * beta:.4g}", f"{0.1 * eta:.3e}"
        beta, eta = float(b) / 0.01, float(mass) / 0.1
        stiffness = f"{1e9 * part * (beta - 1) * (1 + eta):.3e}"
        for law in ("slip", "aging"):
            yield law, b, stiffness, mass


def energy_of_return(law, omega, beta, amplitude, pieces=4000):
    """The energy that friction adds in one period of V = 1 + A cos(omega t), by quadrature."""
    turn = math.sqrt(max(1e-12, 1 - amplitude))
    phase = turn * numpy.sinh(numpy.linspace(-1, 1, pieces + 1) * math.asinh(math.pi / turn))
    velocity = 1 - amplitude + 2 * amplitude * numpy.sin(phase / 2) ** 2
    x, time = numpy.log(velocity), phase / omega
    slip = numpy.diff(time - amplitude / omega * numpy.sin(phase))
    kept = numpy.exp(-slip)
    y = numpy.zeros(pieces + 1)
    value = 0.0 if law == "slip" else 1.0
    for _ in range(3):
        for i in range(pieces):
            y[i] = value if law == "slip" else math.log(value)
            if law == "slip":
                slope = (x[i + 1] - x[i]) / slip[i]
                value = (value + x[i] - slope) * kept[i] - x[i + 1] + slope
            elif slip[i] < 1e-3:
                value = value * kept[i] + (time[i + 1] - time[i]) * math.exp(-slip[i] / 2)
            else:
                start, end = 1 / velocity[i], 1 / velocity[i + 1]
                slope = (end - start) / slip[i]
                value = (value - start + slope) * kept[i] + end - slope
        y[pieces] = value if law == "slip" else math.log(value)
    power = (velocity - 1) * (x + beta * y)
    return -float(numpy.sum((power[1:] + power[:-1]) / 2 * numpy.diff(time)))


def amplitude_of_cycle(law, eta, kappa, beta):
    """Where friction adds no energy; None when vibrations grow until the slider stops."""
    def added(amplitude):
        return energy_of_return(law, math.sqrt(kappa / eta), beta, amplitude)

    if added(1 - LEAST_DISTANCE) > 0 or added(0.01) < 0:
        return None
    return brentq(added, 0.01, 1 - LEAST_DISTANCE, xtol=1e-10)


def smooth_amplitude(law, eta, kappa, beta):
    """The amplitude of a vibration that the energy of a return describes; None for others."""
    eta, kappa, beta = float(eta), float(kappa), float(beta)
    return amplitude_of_cycle(law, eta, kappa, beta) if eta * kappa > LEAST_INERTIA else None


def stopping_cycle(law, eta, kappa, beta, start, tolerance, most_returns=200):
    """The limit cycle from a crossing (y, w) by SciPy's Radau method; its crossing, and what its last return shows."""
    aging = law == "aging"
    rest = -REST - math.log(eta * kappa)

    def exponentials(state):
        # Trials of the solver's iteration may lie far outside.
        return [math.exp(min(max(value, -700.0), 700.0)) for value in (state[0], -state[1])]

    def rate(_, state):
        x, y, w = state
        u, healing = exponentials(state)
        evolution = healing - u if aging else -u * (x + y)
        return [(w - x) / (u * eta), evolution, -kappa * math.expm1(min(x, 700.0)) - beta * evolution]

    def jacobian(_, state):
        x, y, w = state
        u, healing = exponentials(state)
        stiff = 1 / (u * eta)
        second = [-u, -healing, 0.0] if aging else [-u * (x + y + 1), -u, 0.0]
        return [[-stiff * (1 + w - x), 0.0, stiff], second, [-kappa * u - beta * second[0], -beta * second[1], 0.0]]

    def event(value, direction, terminal):
        function = lambda _, state: value(state)  # noqa: E731
        function.direction, function.terminal = direction, terminal
        return function

    def run(start, until, events=None):
        return solve_ivp(rate, (0.0, until), start, "Radau", jac=jacobian, rtol=tolerance, atol=tolerance, events=events)

    def refined(done, time):
        """The state at a moment: the polynomial of a step is less accurate than its ends."""
        at = max(int(numpy.searchsorted(done.t, time)) - 1, 0)
        if time <= done.t[at]:
            return done.y[:, at]
        return run(done.y[:, at], time - done.t[at]).y[:, -1]

    state, duration = [0.0, *start], 0.0
    shown, last, peak, trough, fall = None, None, -1e300, 1e300, None
    crossings = 0
    while crossings <= most_returns:
        # A slider stops in ever shorter times: the clock starts anew every ten units of ln V.
        below = max(-10.0 * (1 + math.floor(-state[0] / 10)), rest) if state[0] < 0 else -10.0
        events = [
            event(lambda s: s[0], 1, 1 if state[0] < 0 else 2),
            event(lambda s: s[0], -1, False),
            event(lambda s: s[2] - s[0], -1, False),
            event(lambda s: s[2] - s[0], 1, False),
            event(lambda s: s[0] - below, -1, True),
        ]
        done = run(state, 1e12, events)
        if done.status != 1:
            raise ArithmeticError("Radau failed")
        rises, falls, tops, bottoms, rests = done.t_events
        for time in falls:
            at = refined(done, time)
            part = -at[0] / rate(0, at)[0]
            at = at + part * numpy.array(rate(0, at))
            fall = at[2] + beta * at[1]
        for time in tops:
            peak = max(peak, refined(done, time)[0])
        for time in bottoms:
            trough = min(trough, refined(done, time)[0])
        if len(rests):
            duration += rests[-1]
            at = refined(done, rests[-1])
            if below > rest:
                state = [below - 1e-12, at[1], at[2]]
                continue
            _, y, w = at
            theta = math.exp(y)
            gained = (lambda t: kappa * t - beta * math.log1p(t / theta)) if aging else (lambda t: kappa * t)
            least = max(beta / kappa - theta, 0.0) if aging else 0.0
            trough = min(trough, w + gained(least))
            high = least + 1.0 / kappa
            while w + gained(high) < rest:
                high = least + 2 * (high - least)
            wait = brentq(lambda t: w + gained(t) - rest, least, high, xtol=1e-300, rtol=1e-15) if w < rest else 0.0
            duration += wait
            # Above the threshold by a little, so that it is not met again at once.
            w = max(w + gained(wait), rest) + 1e-6
            state = [max(w, rest + 1e-6), math.log(theta + wait) if aging else y, w]
            continue
        at = refined(done, rises[-1])
        part = -at[0] / rate(0, at)[0]
        at = at + part * numpy.array(rate(0, at))
        duration += rises[-1] + part
        crossings += 1
        stress = at[2] + beta * at[1]
        if fall is not None and last is not None:
            now = [peak, trough, max(stress, last[3]) - fall, duration]
            if shown is not None and closed(now, shown, tolerance):
                return at[1:], now
            shown = now
        last = [*at, stress]
        state, duration, peak, trough, fall = [0.0, at[1], at[2]], 0.0, -1e300, 1e300, None
    raise ArithmeticError("no closed return")


def closed(now, before, tolerance):
    """Whether two returns show the same, up to a hundred times the tolerance."""
    scales = [1.0, max(1.0, abs(before[1])), before[2], before[3]]
    return all(abs(a - b) < 100 * tolerance * scale for a, b, scale in zip(now, before, scales, strict=True))


def reference(taylors, law, b, stiffness, mass):
    """ln V_peak/V0, ln V_min/V0, stress drop in a sigma, period in D_c/V0, with an error for each; and the program."""
    eta, kappa, beta = Fraction(mass) * 10, Fraction(stiffness) / 10**9, Fraction(b) * 100
    amplitude = smooth_amplitude(law, eta, kappa, beta)
    if amplitude is not None:
        run = taylors[law].set(eta, kappa, beta)
        _, shown, left, _ = run.fixed_point(run.vibration(amplitude), 1e-13)
        shown = [float(value) for value in shown]
        # What is left of the amplitude shows in V_min by as much.
        left = max(left, 1e-14)
        return "heyoka", shown, [left, left / math.exp(shown[1]), left * shown[2], left * shown[3]]
    eta, kappa, beta = float(eta), float(kappa), float(beta)
    # A vibration that stops.
    start = [0.0, 1.1 * math.sqrt(eta * kappa)]
    start, coarse = stopping_cycle(law, eta, kappa, beta, start, 1e-8)
    _, fine = stopping_cycle(law, eta, kappa, beta, start, 1e-10)
    errors = [abs(a - b) for a, b in zip(coarse, fine, strict=True)]
    # Of the rest, and of its end.
    errors[1] += 1e-7
    errors[3] += 1e-6 / kappa
    return "scipy", fine, errors


def main(seed, count):
    taylors = {law: Taylor(law, QUADRUPLE, 8, 1e-22, 1e-28) for law in ("slip", "aging")}
    for law, b, stiffness, mass in sample(seed, count):
        try:
            program, shown, errors = reference(taylors, law, b, stiffness, mass)
        except (ArithmeticError, ValueError, KeyError, IndexError) as failure:
            print(f"# no reference: {law},{b},{stiffness},{mass}: {failure}", flush=True)
            continue
        values = ",".join(f"{value:.15g},{error:.1e}" for value, error in zip(shown, errors, strict=True))
        print(f"{law},{b},{stiffness},{mass},{program},{values}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
