"""Motions of a slider by heyoka's Taylor method, in double or quadruple precision, and fixed points of returns to V = V0 upward.

Velocities are over V0, x is their logarithm, y = ln(V0 theta/D_c), stresses are over a sigma and times over D_c/V0; w + beta y is the spring stress.
"""

from fractions import Fraction

import heyoka
import numpy

QUADRUPLE = heyoka.real128
MOST_STEPS = 100_000
# Units of the stress over the loading rate, and of the time s.
LONGEST = 10


def number(value, real=QUADRUPLE):
    """A fraction in the precision of heyoka."""
    total = real(0)
    for _ in range(3):
        part = float(value)
        total, value = total + real(part), value - Fraction(part)
    return total


def fraction(value):
    """A number of heyoka as a fraction."""
    total = Fraction(0)
    for _ in range(3):
        part = float(value)
        total, value = total + Fraction(part), value - type(value)(part)
    return total


class Polynomial(dict):
    """Powers and coefficients, in u = e^x and a second variable: h = x + y under the slip law, e^-y under the aging law."""

    def add(self, other, factor):
        for powers, c in other.items():
            self[powers] = self.get(powers, 0) + factor * c
        return self

    def times(self, other):
        total = Polynomial()
        for (a, b), c in other.items():
            total.add({(a + d, b + e): f for (d, e), f in self.items()}, c)
        return total

    def by_x(self, law):
        total = Polynomial({(a, b): a * c for (a, b), c in self.items()})
        return total.add({(a, b - 1): b * c for (a, b), c in self.items() if b}, 1) if law == "slip" else total

    def by_y(self, law):
        return Polynomial({(a, b - 1) if law == "slip" else (a, b): (b if law == "slip" else -b) * c for (a, b), c in self.items() if b})

    def at(self, u, other):
        return sum(c * u**a * other**b for (a, b), c in self.items())


def manifold(law, kappa, beta, order):
    """The terms xi_k of x' = sum (eta u)^k xi_k, which a slider approaches where eta u is small."""
    g = Polynomial({(1, 1): -1} if law == "slip" else {(0, 1): 1, (1, 0): -1})
    terms = [Polynomial({(0, 0): kappa, (1, 0): -kappa}).add(g, -beta)]
    # From w - x = eta u x' and its derivative by time.
    for k in range(1, order + 1):
        term = g.times(terms[-1].by_y(law))
        for i, j in zip(range(k), reversed(range(k)), strict=True):
            term.add(terms[i].times(terms[j]), j + 1).add(terms[i].times(terms[j].by_x(law)), 1)
        terms.append(Polynomial().add(term, -1))
    return terms


def summed(terms, eta):
    """The sum of (eta u)^k xi_k."""
    total = Polynomial()
    for k, term in enumerate(terms):
        total.add({(a + k, b): c for (a, b), c in term.items()}, eta**k)
    return total


def horner(coefficients, variable):
    total = 0.0
    for power in range(max(coefficients), -1, -1):
        total = total * variable + coefficients.get(power, 0.0)
    return total


class Taylor:
    """The slider in the time s with dt = eta e^x ds, in which it is not stiff where it stops; and its slow manifold, where it sticks.

    `leaves` is the part of x' that the last terms of the manifold may have; `enters` is how far w may be from it at its entry.
    """

    def __init__(self, law, real, order, leaves, enters, tolerance=0.0):
        self.law, self.real, self.order, self.leaves, self.enters = law, real, order, leaves, enters
        x, y, w, t = heyoka.make_vars("x", "y", "w", "t")
        eta, kappa, beta = (heyoka.par[i] for i in range(3))
        u = heyoka.exp(x)
        other = x + y if law == "slip" else heyoka.exp(-y)
        g = -u * other if law == "slip" else other - u
        clock = eta * u
        whole = [(x, w - x), (y, clock * g), (w, clock * (kappa * (1.0 - u) - beta * g)), (t, clock)]
        self.powers = sorted(summed(manifold(law, 1, 2, order), 1))
        nested = {}
        for at, (a, b) in enumerate(self.powers):
            nested.setdefault(a, {})[b] = heyoka.par[at]
        rate = horner({a: horner(inner, other) for a, inner in nested.items()}, u)
        self.whole = self.integrator(whole, w - x, 3, tolerance)
        self.slow = self.integrator([(x, rate), (y, g)], rate, len(self.powers), tolerance)

    def integrator(self, system, rising, parameters, tolerance):
        """An integrator that notes where V = V0 and where `rising` changes its sign."""
        x, (up, down) = system[0][0], (heyoka.event_direction.positive, heyoka.event_direction.negative)
        events = [
            heyoka.nt_event(ex, self.note(name), direction=direction, fp_type=self.real)
            for name, ex, direction in (("rise", x, up), ("fall", x, down), ("peak", rising, down), ("trough", rising, up))
        ]
        start, pars = [self.real(0)] * len(system), [self.real(1)] * parameters
        return heyoka.taylor_adaptive(
            system, start, pars=pars, nt_events=events, fp_type=self.real, tol=self.real(tolerance), compact_mode=True
        )

    def note(self, name):
        def noted(run, time, _):
            run.update_d_output(time)
            self.found.append((time, name, [self.real(c) for c in run.d_output]))

        return noted

    def set(self, eta, kappa, beta):
        """The dimensionless groups, as fractions."""
        self.eta, self.kappa, self.beta = groups = [number(value, self.real) for value in (eta, kappa, beta)]
        terms = manifold(self.law, self.kappa, self.beta, self.order)
        self.last = [(k, Polynomial({at: float(c) for at, c in terms[k].items()})) for k in (self.order - 1, self.order)]
        self.rate = summed(terms, self.eta)
        self.whole.pars[:] = groups
        self.slow.pars[:] = [self.rate.get(powers, self.real(0)) for powers in self.powers]
        return self

    def variables(self, x, y):
        return numpy.exp(x), x + y if self.law == "slip" else numpy.exp(-y)

    def defect(self, x, y):
        """The last two terms of the manifold, as a part of the positive terms of x'."""
        u, other = (float(value) for value in self.variables(x, y))
        last = sum(abs((float(self.eta) * u) ** k * term.at(u, other)) for k, term in self.last)
        g = abs(u * other) if self.law == "slip" else u + other
        return last / (float(self.kappa) * (1 + u) + float(self.beta) * g)

    def on_manifold(self, x, y):
        u, other = self.variables(x, y)
        return [x, y, x + self.eta * u * self.rate.at(u, other)]

    def follow(self, state, is_done):
        """Follows (x, y, w) and calls is_done(name, time, state) at every event and step, until it is true."""
        self.steps, passed, sticks = 0, self.real(0), False
        while True:
            run, size = (self.slow, 2) if sticks else (self.whole, 3)
            run.time, run.state[:] = self.real(0), [*state[:size], self.real(0)][: len(run.state)]
            changes = False
            while not changes:
                self.step(run)
                until, state = run.time, [self.real(c) for c in run.state]
                if sticks and self.defect(*state) > self.leaves:
                    changes, (until, state) = True, self.last_on_manifold(run)
                for time, name, at in self.found:
                    elapsed, at = (time, self.on_manifold(*at)) if sticks else (at[3], at[:3])
                    if time <= until and is_done(name, passed + elapsed, at):
                        return
                elapsed, state = (until, self.on_manifold(*state)) if sticks else (state[3], state[:3])
                if is_done("step", passed + elapsed, state):
                    return
                changes = changes or (not sticks and self.may_enter(*state))
            passed, sticks = passed + elapsed, not sticks

    def may_enter(self, x, y, w):
        if self.eta * numpy.exp(x) > 0.1 or self.defect(x, y) > self.leaves / 4:
            return False
        return abs(w - self.on_manifold(x, y)[2]) < self.enters * (1 + abs(w))

    def last_on_manifold(self, run):
        """A time of the last step, and the state, at which the defect is at most `leaves` and not much less."""
        low, high = run.time - run.last_h, run.time
        for _ in range(60):
            until = (low + high) / 2
            run.update_d_output(until)
            state = [self.real(c) for c in run.d_output]
            defect = self.defect(*state)
            low, high = (low, until) if defect > self.leaves else (until, high)
            if self.leaves / 2 < defect <= self.leaves:
                break
        return until, state

    def step(self, run):
        self.found, self.steps = [], self.steps + 1
        # Where V is tiny its Taylor coefficients do not limit a step.
        longest = LONGEST / self.kappa if run is self.slow else self.real(LONGEST)
        outcome = run.step(max_delta_t=longest)[0]
        if self.steps > MOST_STEPS or outcome not in (heyoka.taylor_outcome.success, heyoka.taylor_outcome.time_limit):
            raise ArithmeticError("no more steps")
        self.found.sort(key=lambda event: event[0])

    def stress(self, state):
        return state[2] + self.beta * state[1]

    def back(self, crossing):
        """The next crossing (y, w) of V = V0 upward; largest and least x (where the slider does not stick), stress drop and period of the return."""
        seen = {}

        def is_done(name, time, at):
            if name == "peak":
                seen[name] = max(seen.get(name, at[0]), at[0])
            elif name == "fall" and "peak" in seen:
                seen[name] = self.stress(at)
            elif name == "trough" and "fall" in seen:
                seen[name] = min(seen.get(name, at[0]), at[0])
            elif name == "rise" and "fall" in seen:
                seen[name] = at[1:], time
                return True
            return False

        self.follow([self.real(0), *crossing], is_done)
        end, period = seen["rise"]
        return end, [seen["peak"], seen.get("trough"), self.stress([0, *end]) - seen["fall"], period]

    def vibration(self, amplitude):
        """A crossing (y, w) of V = V0 (1 + A cos omega t), with the y that follows within two returns."""
        crossing = [self.real(0), self.real(amplitude) * numpy.sqrt(self.eta * self.kappa)]
        for _ in range(2):
            crossing[0] = self.back(crossing)[0][0]
        return crossing

    def resolvent(self, point, end):
        """(1 - P')^-1 of the return P, by differences."""
        columns = []
        for i in (0, 1):
            step = self.real(1e-6 if self.real is float else 1e-12) * (1 + abs(point[i]))
            there, _ = self.back([c + step * (i == j) for j, c in enumerate(point)])
            columns.append([(there[j] - end[j]) / step for j in (0, 1)])
        (a, c), (b, d) = columns
        determinant = (1 - a) * (1 - d) - b * c
        return [[(1 - d) / determinant, b / determinant], [c / determinant, (1 - a) / determinant]]

    def fixed_point(self, point, until, inverse=None):
        """Newton's iteration on a crossing (y, w): crossing, what its return shows, the last step, and (1 - P')^-1.

        A given inverse is kept.
        """
        for _ in range(12):
            end, shown = self.back(point)
            used = inverse or self.resolvent(point, end)
            residual = [end[i] - point[i] for i in (0, 1)]
            by = [sum(self.real(c) * r for c, r in zip(row, residual, strict=True)) for row in used]
            point = [point[i] + by[i] for i in (0, 1)]
            left = float(max(abs(by[i]) / (1 + abs(point[i])) for i in (0, 1)))
            if left < until:
                return point, shown, left, used
        raise ArithmeticError("no convergence")
