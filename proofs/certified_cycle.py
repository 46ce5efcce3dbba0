"""Proves a limit cycle of a slider in ball arithmetic, and compares it with the bounds that slipmode states.

It shares no code with slipmode: Arb's balls through python-flint, other equations (the spring stress is a state), another
order, another section (V = V_l, where the velocity rises) and another form of the enclosure. See docs/certified.md.

It takes seconds to minutes a cycle. It does not reach cycles that stop abruptly, by many orders of magnitude of velocity, at
large inertia.
"""
import argparse
import csv
import sys
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, arb_series, ctx, fmpq

ctx.prec = 192
ORDER, DERIVATIVE_ORDER = 30, 16
LOCAL_ERROR = arb(2) ** -100
RADIUS = arb(2) ** -40
# Newton's last step, whose error is about the square.
CLOSE = arb(2) ** -25
MOST_STEPS = 3000
# The widest tube of the centre and of the box, and how small eta e^x is, for steps along the slow manifold.
CENTRE_TUBE, TUBE, OFF_MANIFOLD, SLOW = arb(2) ** -50, arb(2) ** -20, arb(2) ** -20, arb(2) ** -7
MOST_LAPS, NEWTON_STEPS = 60, 20
UNIT = arb(0, 1)
WHOLE = arb(0.5, 0.5)


class NotProved(Exception):
    """A step of the proof failed; says which."""


def ball(text):
    """A decimal number as a ball that contains it."""
    value = Fraction(text)
    return arb(fmpq(value.numerator, value.denominator))


def hull(*balls):
    result = balls[0]
    for one in balls[1:]:
        result = result.union(one)
    return result


class Slider:
    """The equations in x = ln(V/V_l), y = ln(theta V_l/D_c), z (spring stress over a sigma), and time over D_c/V_l."""

    def __init__(self, law, a, b, d_c_m, k_pa_per_m, m_kg_per_m2, normal_stress_pa, loading_velocity_m_per_s):
        a, b, d_c, k, m, sigma, v = map(
            ball, (a, b, d_c_m, k_pa_per_m, m_kg_per_m2, normal_stress_pa, loading_velocity_m_per_s)
        )
        self.law = law
        self.eta, self.kappa, self.beta = m * v**2 / (sigma * a * d_c), k * d_c / (a * sigma), b / a
        self.velocity, self.time, self.stress = v, d_c / v, a * sigma

    @classmethod
    def of_groups(cls, law, eta, kappa, beta):
        """The slider with these groups and with a, D_c, the normal stress and V_l equal to 1."""
        return cls(law, "1", beta, "1", kappa, eta, "1", "1")

    def rate(self, state):
        """The time derivative of a state of balls or series."""
        x, y, z = state
        faster, slower = x.exp(), (-x).exp()
        force = z - x - self.beta * y
        ageing = (-y).exp() - faster if self.law == "aging" else -faster * (x + y)
        return [force * slower * (1 / self.eta), ageing, self.kappa * (1 - faster)]

    def jacobian(self, state):
        """The rows of the derivative of the rate by the state."""
        x, y, z = state
        faster, slower = x.exp(), (-x).exp() * (1 / self.eta)
        force = z - x - self.beta * y
        if self.law == "aging":
            row = [-faster, -(-y).exp(), 0 * x]
        else:
            row = [-faster * (x + y + 1), -faster, 0 * x]
        return [[-slower * (force + 1), -self.beta * slower, slower], row, [-self.kappa * faster, 0 * x, 0 * x]]


def series(start, terms):
    return arb_series([start, *terms], len(terms) + 1)


def solution(slider, start, order):
    """The Taylor coefficients of the solution through a state; each round of Picard's iteration adds one."""
    curves = [arb_series([value], 1) for value in start]
    known = 1
    while known <= order:
        ctx.cap = known
        rates = slider.rate(curves)
        known += 1
        ctx.cap = known
        curves = [arb_series([s], known) + rate.integral() for s, rate in zip(start, rates)]
    return curves


def derivative_solution(slider, curves, start, order):
    """The Taylor coefficients of the derivative of the flow along a solution, from a matrix at the start."""
    ctx.cap = order + 1
    jacobian = slider.jacobian(curves)
    columns = []
    for j in range(3):
        column = [arb_series([start[i][j]], 1) for i in range(3)]
        for known in range(1, order + 1):
            ctx.cap = known
            rates = [sum((jacobian[i][k] * column[k] for k in range(3)), arb_series([0])) for i in range(3)]
            ctx.cap = known + 1
            column = [arb_series([start[i][j]], known + 1) + rates[i].integral() for i in range(3)]
        columns.append(column)
    return columns


def coefficients(curve, count):
    """The first coefficients of a series, which has to be known so far."""
    if curve.prec < count:
        raise ValueError(f"a series of {curve.prec} coefficients has no {count}")
    found = curve.coeffs()[:count]
    return found + [arb(0)] * (count - len(found))


def value(terms, time):
    """A polynomial at a time."""
    result = arb(0)
    for term in reversed(terms):
        result = result * time + term
    return result


def zero_of(terms, length):
    """The time before `length` at which a polynomial changes its sign; nothing about it is proved."""
    low, high = arb(0), length
    rising = value(terms, high) > 0
    for _ in range(60):
        middle = ((low + high) / 2).mid()
        low, high = (low, middle) if (value(terms, middle) > 0) == rising else (middle, high)
    slope = [k * t for k, t in enumerate(terms)][1:]
    for _ in range(4):
        middle = (middle - value(terms, middle).mid() / value(slope, middle).mid()).mid()
    return middle


def around(balls, radius):
    return [one + UNIT * radius for one in balls]


def largest(balls):
    return max((one.abs_upper() for one in balls), key=float)


def product(matrix, vector):
    return [sum((m * v for m, v in zip(row, vector)), arb(0)) for row in matrix]


def matrix_product(left, right):
    columns = [product(left, column) for column in zip(*right)]
    return [list(row) for row in zip(*columns)]


IDENTITY = [[arb(int(i == j)) for j in range(3)] for i in range(3)]


def near_identity(slider, passed, length):
    """Bounds of the derivative of the flow over any shorter time, while every solution stays in a box."""
    # In units of 1, 1 and sqrt(kappa eta) the entries of the Jacobian are alike.
    unit = [arb(1), arb(1), (slider.kappa * slider.eta).sqrt()]
    rows = [[j * w / own for j, w in zip(row, unit)] for row, own in zip(slider.jacobian(passed), unit)]
    steepest = max((sum(entry.abs_upper() for entry in row) for row in rows), key=float)
    spread = (length * steepest).expm1().abs_upper()
    return [
        [one + UNIT * (spread * unit[i] / unit[j]).abs_upper() for j, one in enumerate(row)]
        for i, row in enumerate(IDENTITY)
    ]


class Enclosure:
    """All solutions that start in a box of the section: centre + derivative * p + errors, with |p| <= RADIUS."""

    def __init__(self, slider, y, z, radius):
        self.slider = slider
        self.radii = [radius, radius * z.abs_upper()]
        self.centre = [arb(0), y, z]
        self.derivative = [[arb(0), arb(0)], [arb(1), arb(0)], [arb(0), arb(1)]]
        self.errors = [arb(0)] * 3
        self.time = arb(0)

    def box(self):
        spread = product(self.derivative, [UNIT * radius for radius in self.radii])
        return [c + s + UNIT * e for c, s, e in zip(self.centre, spread, self.errors)]

    def after(self, length, ends, errors, derivative):
        """The enclosure after a step, from the centre's ends, further errors and the derivative of the flow."""
        after = Enclosure.__new__(Enclosure)
        after.slider, after.radii, after.time = self.slider, self.radii, self.time + length
        after.centre = [end.mid() for end in ends]
        after.errors = [(end.rad() + e).abs_upper() for end, e in zip(ends, errors)]
        after.derivative = derivative
        return after

    def centre_box(self):
        return [c + UNIT * e for c, e in zip(self.centre, self.errors)]


class Step:
    """A step of the enclosure: the Taylor polynomial of the centre, and proved bounds of every solution on the step."""

    def __init__(self, enclosure):
        self.start = enclosure
        slider = enclosure.slider
        self.curves = solution(slider, enclosure.centre, ORDER)
        self.terms = [coefficients(curve, ORDER + 1) for curve in self.curves]
        last = largest([terms[ORDER] for terms in self.terms] + [terms[ORDER - 1] for terms in self.terms])
        self.longest = ((LOCAL_ERROR / last).root(ORDER)).mid() if last > 0 else arb(1)

    def taken(self, length):
        """The enclosure after a time, and what every solution passes; none where the bounds do not close."""
        start, slider = self.start, self.start.slider
        self.boxes = [coefficients(curve, ORDER + 1) for curve in solution(slider, start.box(), ORDER)]
        guess = LOCAL_ERROR
        passed = [value(t[:ORDER], length * WHOLE) + UNIT * guess for t in self.boxes]
        curves = solution(slider, passed, ORDER)
        remainders = [coefficients(c, ORDER + 1)[ORDER] * length**ORDER * UNIT for c in curves]
        self.velocity = self.boxes[0][:ORDER] + [coefficients(curves[0], ORDER + 1)[ORDER]]
        if not all(one.is_finite() and one.abs_upper() < guess for one in remainders):
            return None
        flow = self.flow(length, passed, curves)
        ends = [value(t[:ORDER], length) + r for t, r in zip(self.terms, remainders)]
        carried = product([[f.abs_upper() for f in row] for row in flow], start.errors)
        return start.after(length, ends, carried, matrix_product(flow, start.derivative)), passed

    def during(self, length, order):
        """The derivative of x of this order on the step, for every solution: its series, with the last term over all that is passed."""
        terms = self.velocity
        for _ in range(order):
            terms = [k * t for k, t in enumerate(terms)][1:]
        return value(terms, length * WHOLE)

    def flow(self, length, passed, curves):
        """The derivative of the flow over the step, for every solution."""
        slider, order = self.start.slider, DERIVATIVE_ORDER
        between = near_identity(slider, passed, length)
        short = [arb_series(t[: order + 1], order + 1) for t in self.boxes]
        polynomials = derivative_solution(slider, short, IDENTITY, order - 1)
        short = [arb_series(coefficients(c, ORDER + 1)[: order + 1], order + 1) for c in curves]
        remainders = derivative_solution(slider, short, between, order)
        return [
            [
                value(coefficients(polynomials[j][i], order), length)
                + coefficients(remainders[j][i], order + 1)[order] * length**order
                for j in range(3)
            ]
            for i in range(3)
        ]

class StickStep:
    """A step along the slow manifold, where friction balances the spring and eta e^x is small.

    The polynomials x, y, z solve eta e^x x' = z - x - beta y and the other two equations up to defects that are bounded.
    `distances` bounds how far a solution is from them. The derivative of the flow is enclosed in the same way: its equations
    have the same form.
    """

    def __init__(self, enclosure):
        self.start = enclosure
        slider = enclosure.slider
        x, y, z = enclosure.centre
        ctx.cap = ORDER + 1
        curves = [arb_series([z - slider.beta * y]), arb_series([y]), arb_series([z])]
        for _ in range(2 * ORDER):
            inertia = slider.eta * curves[0].exp() * curves[0].derivative()
            curves = self.improved((y, z), slider.rate(curves)[1:], lambda y, z: z - y * slider.beta - inertia)
        self.terms = [coefficients(curve, ORDER + 1) for curve in curves]
        last = largest([terms[k] for terms in self.terms for k in (ORDER - 1, ORDER)])
        self.longest = (LOCAL_ERROR / last).root(ORDER).mid()

    @staticmethod
    def improved(starts, rates, balance):
        """The next iterate of the polynomials; nothing about it is proved."""
        y, z = (arb_series([s]) + rate.integral() for s, rate in zip(starts, rates))
        return [arb_series([t.mid() for t in curve.coeffs()], ORDER + 1) for curve in (balance(y, z), y, z)]

    def derivatives(self):
        """The polynomials of the derivative along the slow manifold, by y and by z at the start."""
        slider, curves = self.start.slider, [arb_series(terms, ORDER + 1) for terms in self.terms]
        ctx.cap = ORDER + 1
        jacobian, inertia = slider.jacobian(curves), slider.eta * curves[0].exp()
        force = 1 + inertia * curves[0].derivative()
        columns = []
        for starts in ((1, 0), (0, 1)):
            column = [arb_series([one]) for one in (starts[1] - slider.beta * starts[0], *starts)]
            for _ in range(2 * ORDER):
                change = inertia * column[0].derivative()
                rates = [jacobian[1][0] * column[0] + jacobian[1][1] * column[1], jacobian[2][0] * column[0]]
                column = self.improved(starts, rates, lambda y, z: (z - y * slider.beta - change) / force)
            columns.append([coefficients(curve, ORDER + 1) for curve in column])
        return columns

    def bounds(self, defects, length):
        """Bounds during the step of functions whose Taylor coefficients at or in a time are given."""
        here, anywhere = defects(arb(0)), defects(length * WHOLE)
        low = [sum((d[k].abs_upper() * length**k for k in range(ORDER - 1)), arb(0)) for d in here]
        return [bound + d[ORDER - 1].abs_upper() * length ** (ORDER - 1) for bound, d in zip(low, anywhere)]

    def defects(self, time):
        """The Taylor coefficients of the three defects of the polynomials at a time or in a range of times."""
        slider, (x, y, z) = self.start.slider, self.at(self.terms, time)
        rates = slider.rate([x, y, z])
        balance = z - x - slider.beta * y - slider.eta * x.exp() * x.derivative()
        return [coefficients(d, ORDER) for d in (balance, y.derivative() - rates[1], z.derivative() - rates[2])]

    def derivative_defects(self, column, time):
        """The same for a column of the derivative."""
        slider, curves, (u, y, z) = self.start.slider, self.at(self.terms, time), self.at(column, time)
        jacobian, inertia = slider.jacobian(curves), slider.eta * curves[0].exp()
        balance = z - slider.beta * y - (1 + inertia * curves[0].derivative()) * u - inertia * u.derivative()
        rates = [jacobian[1][0] * u + jacobian[1][1] * y, jacobian[2][0] * u]
        return [coefficients(d, ORDER) for d in (balance, y.derivative() - rates[0], z.derivative() - rates[1])]

    @staticmethod
    def at(terms, time):
        # One more than the defects have: their derivative loses one.
        ctx.cap = ORDER + 1
        return [value(one, arb_series([time, 1])) for one in terms]

    def distances(self, length, starts, defects):
        """Bounds of the distances from the polynomials during the step and at its end, from those at its start.

        The distance d of x obeys eta e^x d' = -(1 + f) d + r with |f| <= `margin`, where |r| is at most the first defect and
        the distances of z and of beta y. So d is at most that bound over 1 - margin, and the start's part, which shrinks at
        the rate (1 - margin) / (eta e^x). The distances of y and z grow by what x adds only, because the slopes of y' by y
        and of z' by z are not positive.
        """
        beta, settling = self.start.slider.beta, 1 - self.margin
        rate = (settling / self.inertia).lower()
        coupling = self.push + beta * self.pull
        free = defects[0] + starts[2] + length * defects[2] + beta * (starts[1] + length * defects[1])
        share = 1 - coupling * length / settling
        if not share > 0:
            return None
        settled = (free + coupling * starts[0] / rate) / share / settling
        added = length * settled + starts[0] / rate
        slow = zip(starts[1:], (self.pull, self.push), defects[1:])
        ends = [start + by_x * added + length * defect for start, by_x, defect in slow]
        during = [one.abs_upper() for one in (settled + starts[0], *ends)]
        return during, [one.abs_upper() for one in (settled + (-rate * length).exp() * starts[0], *ends)]

    def taken(self, length):
        """The enclosure after a time, and what every solution passes; none where the bounds do not close."""
        start, slider = self.start, self.start.slider
        defects = self.bounds(self.defects, length)
        curve = [value(terms, length * WHOLE) for terms in self.terms]
        slope = value([k * t for k, t in enumerate(self.terms[0])][1:], length * WHOLE).abs_upper()
        passed = around(curve, TUBE)
        jacobian = slider.jacobian(passed)
        self.inertia = (slider.eta * passed[0].exp()).upper()
        self.pull, self.push = jacobian[1][0].abs_upper(), jacobian[2][0].abs_upper()
        # The force z - x - beta y, which is eta e^x x', differs from the polynomials' by less than TUBE times its slopes.
        self.margin = (self.inertia * slope + (2 + slider.beta) * TUBE + defects[0]).upper()
        if not (all(d.is_finite() for d in defects) and self.margin < arb(0.5) and passed[0] < 0):
            return None
        gaps = [abs(c - t[0]).abs_upper() for c, t in zip(start.centre, self.terms)]
        spread = [(b - c).abs_upper() for b, c in zip(start.box(), start.centre)]
        near = self.distances(length, [(g + e).abs_upper() for g, e in zip(gaps, start.errors)], defects)
        wide = self.distances(length, [(g + s).abs_upper() for g, s in zip(gaps, spread)], defects)
        if near is None or not (largest(wide[0]) < TUBE and largest(near[1]) < CENTRE_TUBE):
            return None
        derivative = self.derivative(length, curve, wide[0], defects[0])
        if derivative is None:
            return None
        ends = [value(terms, length).mid() for terms in self.terms]
        rounded = [(value(terms, length) - end).abs_upper() for terms, end in zip(self.terms, ends)]
        errors = [(e + r).abs_upper() for e, r in zip(near[1], rounded)]
        return start.after(length, ends, errors, derivative), passed

    def derivative(self, length, curve, wide, defect):
        """The derivative after the step: on the slow manifold by y and z, and what is left of the distance from it."""
        slider, before = self.start.slider, self.start.derivative
        # How far the coefficients of the linear equations differ from those along the polynomials.
        states = [arb_series([c + UNIT * w, UNIT * w], 2) for c, w in zip(curve, wide)]
        ctx.cap = 2
        changes = [[coefficients(entry, 2)[1].abs_upper() for entry in row] for row in slider.jacobian(states)[1:]]
        force = wide[2] + wide[0] + slider.beta * wide[1] + defect
        polynomials, columns = self.derivatives(), []
        for column in polynomials:
            defects = self.bounds(lambda time: self.derivative_defects(column, time), length)
            u, y, _ = (value(terms, length * WHOLE).abs_upper() for terms in column)
            bend = value([k * t for k, t in enumerate(column[0])][1:], length * WHOLE).abs_upper()
            defects[0] += force * u + self.inertia * wide[0].expm1() * bend
            defects[1] += changes[0][0] * u + changes[0][1] * y
            defects[2] += changes[1][0] * u
            found = self.distances(length, [arb(0)] * 3, defects)
            columns.append([value(terms, length) + UNIT * e for terms, e in zip(column, found[1])])
        left = [UNIT * e for e in self.distances(length, [arb(1), arb(0), arb(0)], [arb(0)] * 3)[1]]
        starts = [column[0][0] for column in polynomials]
        off = [x - starts[0] * y - starts[1] * z for x, y, z in zip(*before)]
        if not largest([left[i] * o for i in (1, 2) for o in off]) < OFF_MANIFOLD:
            return None
        return [
            [columns[0][i] * y + columns[1][i] * z + left[i] * o for y, z, o in zip(before[1], before[2], off)]
            for i in range(3)
        ]


@dataclass
class Cycle:
    """A cycle that exists, is the only one through its box, and attracts."""

    period: arb
    peak: arb
    highest_stress: arb
    lowest_stress: arb
    start: list
    steps: int


class Turn:
    """Follows a box of the section until it returns, and what is seen on the way.

    The section is V = V_l with rising velocity. As z' has the sign of -x, the spring stress is largest there, and least
    where the velocity falls through V_l: it is proved that each happens once.
    """

    def __init__(self, slider, y, z, radius):
        self.slider, self.at = slider, Enclosure(slider, y, z, radius)
        self.landed, self.fallen, self.steps, self.length, self.wait = "section", False, 0, arb(1), 0
        self.peak_low, self.peak_high, self.lowest = arb(-(10**9)), arb(-(10**9)), None
        while self.landed != "section" or self.steps == 0:
            self.advance()
        self.map, self.map_derivative, self.end = self.crossed()

    def landing(self, step, length):
        """The first event of the centre within a length, and its time."""
        x = step.terms[0]
        rate = [k * t for k, t in enumerate(x)][1:]
        found, time = None, length
        if self.landed != "peak" and rate[0] > 0 and value(rate, time) < 0:
            found, time = "peak", zero_of(rate, time)
        sign = -1 if self.fallen else 1
        if self.landed not in ("falling", "section") and sign * x[0] > 0 and sign * value(x, time) < 0:
            found, time = ("section" if self.fallen else "falling"), zero_of(x, time)
        return found, time

    def advance(self):
        self.steps += 1
        if self.steps > MOST_STEPS:
            raise NotProved(f"more than {MOST_STEPS} steps: too stiff for explicit steps")
        before = self.landed
        self.wait -= 1
        if self.wait < 0 and is_slow(self.at):
            step = StickStep(self.at)
            for length in (step.longest, step.longest / 2, step.longest / 4):
                taken = step.taken(length.mid())
                if taken is not None:
                    self.at, self.landed = taken[0], None
                    return
            self.wait = 10
        step = Step(self.at)
        length = min(step.longest, self.length * arb(1.25), key=float).mid()
        while True:
            landed, time = self.landing(step, length)
            taken = step.taken(time)
            if taken is not None and self.is_clear(step, *taken, time, landed, before):
                break
            length = (length * arb(0.7)).mid()
            if length < arb(2) ** -80:
                raise NotProved(f"the step became too short after {self.steps} steps")
        self.at, self.landed, self.length = taken[0], landed, length
        if landed == "falling":
            self.fallen = True
            self.lowest = self.crossed()[2][2]

    def is_clear(self, step, after, passed, time, landed, before):
        """Whether a step leaves no doubt about crossings of V = V_l and about peaks; the bounds of a peak are noted."""
        if passed[0] < 0:
            return True
        rate, bend = step.during(time, 1), step.during(time, 2)
        turns = not (rate > 0 or rate < 0)
        if turns and passed[0].contains(0):
            return False
        tops = [state.box() for state, name in ((after, landed), (self.at, before)) if name == "peak"]
        if turns and not bend > 0 and not (bend < 0 and tops):
            return False
        for top in tops:
            self.peak_low = max(self.peak_low, top[0].lower(), key=float)
            rate_there = self.slider.rate(top)[0]
            beyond = rate_there * rate_there / (-2 * bend) if turns and bend < 0 else arb(0)
            self.peak_high = max(self.peak_high, (top[0] + beyond).upper(), key=float)
        return True

    def crossed(self):
        """The crossing of V = V_l next to the last step's end: the map at the centre, its derivative, and all solutions."""
        box, slider = self.at.box(), self.slider
        near = around(box, LOCAL_ERROR)
        rates = slider.rate(near)
        wait = -box[0] / rates[0]
        near = [b + 2 * w * r * UNIT for b, w, r in zip(near, [wait] * 3, rates)]
        rates = slider.rate(near)
        wait = -box[0] / rates[0]
        if not all(n.contains_interior(b + UNIT * (wait * r).abs_upper()) for n, b, r in zip(near, box, rates)):
            raise NotProved("the crossing of V = V_l is not isolated")
        centre = self.at.centre_box()
        wait_of_centre = -centre[0] / rates[0]
        image = [c + wait_of_centre * r for c, r in zip(centre, rates)]
        rows = matrix_product(near_identity(slider, near, wait.abs_upper()), self.at.derivative)
        derivative = [[rows[i][j] - rates[i] / rates[0] * rows[0][j] for j in range(2)] for i in (1, 2)]
        self.time = self.at.time + wait
        return image[1:], derivative, [arb(0)] + [b + wait * r for b, r in zip(box, rates)][1:]


def settled(slider):
    """A point of the section next to the cycle that a start at V_l/10 approaches; nothing about it is proved."""
    tenth = arb(10).log()
    at = Enclosure(slider, tenth, (slider.beta - 1) * tenth, arb(0))
    at.centre[0] = -tenth
    laps, steps, wait = [], 0, 0
    while len(laps) < MOST_LAPS:
        steps, wait = steps + 1, wait - 1
        if steps > 4 * MOST_STEPS:
            raise NotProved(f"more than {4 * MOST_STEPS} steps before a cycle: too stiff for explicit steps")
        step = Step(at)
        if wait < 0 and is_slow(at):
            slow = StickStep(at)
            if (slow.terms[0][0] - at.centre[0]).abs_upper() < CENTRE_TUBE:
                step = slow
            else:
                wait = 5
        terms, length = step.terms, step.longest
        if terms[0][0] < -TUBE and value(terms[0], length) > 0:
            length = zero_of(terms[0], length)
            laps.append([value(t, length).mid() for t in terms[1:]])
            if len(laps) > 1 and largest([p - q for p, q in zip(*laps[-2:])]) < arb(2) ** -20:
                break
        at.centre = [value(t, length).mid() for t in terms]
    return laps[-1]


def is_slow(at):
    """Whether a step along the slow manifold is worth a trial."""
    return at.centre[0] < 0 and at.slider.eta * at.centre[0].exp() < SLOW


def newton(turn, y, z):
    """The centre moved by Newton's step for a fixed point of the map."""
    (a, b), (c, d) = turn.map_derivative
    a, d = 1 - a, 1 - d
    determinant = a * d - b * c
    if determinant.contains(0):
        raise NotProved("the derivative of the map has the eigenvalue 1 within its bounds")
    e, f = turn.map[0] - y, turn.map[1] - z
    return y + (d * e + b * f) / determinant, z + (c * e + a * f) / determinant


def enclosed(slider, y, z):
    """One cycle through a box around a point of the section, if Newton's operator maps the box into itself."""
    for _ in range(NEWTON_STEPS):
        moved = newton(Turn(slider, y, z, arb(0)), y, z)
        change = max((moved[0] - y).abs_upper(), (moved[1] - z).abs_upper(), key=float)
        y, z = (one.mid() for one in moved)
        if change < CLOSE:
            break
    turn = Turn(slider, y, z, RADIUS)
    image = newton(turn, y, z)
    boxes = [y + UNIT * RADIUS, z + UNIT * RADIUS * z.abs_upper()]
    if not all(box.contains_interior(one) for box, one in zip(boxes, image)):
        raise NotProved("the box is not mapped into itself by Newton's operator")
    return turn, image


def observed(slider, turn, image):
    """What the cycle shows: it lies in Newton's image of the box, which is far smaller, and is followed from there once more."""
    y, z = (one.mid() for one in image)
    seen = Turn(slider, y, z, max((image[0].rad(), image[1].rad() / abs(z)), key=float).upper())
    peak = hull(seen.peak_low, seen.peak_high)
    return Cycle(seen.time, peak, image[1], seen.lowest, image, turn.steps)


def cycle(slider, y, z):
    """Proves a cycle near a point of the section, and that it attracts."""
    turn, image = enclosed(slider, y, z)
    (a, b), (c, d) = turn.map_derivative
    trace, determinant = a + d, a * d - b * c
    # Both eigenvalues lie within the unit circle (Jury's criterion of degree 2).
    if not (abs(determinant) < 1 and abs(trace) < 1 + determinant):
        raise NotProved("the cycle is not proved to attract")
    return observed(slider, turn, image)


def unstable_cycle(slider, y, z):
    """Proves a cycle near a point of the section, and that it repels."""
    turn, image = enclosed(slider, y, z)
    (a, b), (c, d) = turn.map_derivative
    # The polynomial of the eigenvalues is negative at 1, so that one of them is above 1.
    if not (1 - a) * (1 - d) - b * c < 0:
        raise NotProved("the cycle is not proved to repel")
    return observed(slider, turn, image)


def attracts_at_rest(slider):
    """Routh and Hurwitz for steady sliding: all roots of s^3 + p s^2 + q s + r have negative real parts."""
    (j11, j12, j13), (j21, j22, _), (j31, _, _) = slider.jacobian([arb(0)] * 3)
    p = -(j11 + j22)
    q = j11 * j22 - j12 * j21 - j13 * j31
    r = j13 * j31 * j22
    return p > 0 and r > 0 and p * q > r


INPUTS = (
    "direct_effect",
    "evolution_effect",
    "critical_slip_distance_m",
    "stiffness_pa_per_m",
    "mass_per_area_kg_per_m2",
    "normal_stress_pa",
    "loading_velocity_m_per_s",
)


def stated_bounds(slider, proved):
    """The columns that slipmode states for a cycle, in SI, from the bounds that are proved here."""
    drop = proved.highest_stress - proved.lowest_stress
    return {
        "peak_velocity_{}_m_per_s": slider.velocity * proved.peak.exp(),
        "period_{}_s": slider.time * proved.period,
        "stress_drop_{}_pa": slider.stress * drop,
    }


def prove(row):
    """The slider of a row of `slipmode simulate --certify`, and its cycle; NotProved where none is found."""
    slider = Slider(row["law"], *(row[name] for name in INPUTS))
    return slider, cycle(slider, *settled(slider))


def faults(row, slider, proved):
    """The bounds of a row that do not hold what is proved here."""
    found = []
    for name, inside in stated_bounds(slider, proved).items():
        low, high = (row[name.format(end)] for end in ("low", "high"))
        if not (ball(low) <= inside and inside <= ball(high)):
            found.append(f"{name.format('low')} {low}, {name.format('high')} {high}, but here {inside.str(20)}")
    return found


def is_bistable(row):
    """Whether a row is one of the table bistability-certified."""
    return "unstable_y" in row


def prove_three(row):
    """ln(V_peak/V_l) of both cycles of a row of the table bistability-certified; NotProved unless sliding attracts and both exist."""
    slider = Slider.of_groups("aging", row["inertial_parameter"], row["stiffness_group"], row["effect_ratio"])
    if not attracts_at_rest(slider):
        raise NotProved("steady sliding is not proved to attract")
    point = [ball(row[name]).mid() for name in ("unstable_y", "unstable_zeta")]
    return {"stable": cycle(slider, *settled(slider)).peak, "unstable": unstable_cycle(slider, *point).peak}


def faults_of_three(row, peaks):
    """The bounds of such a row that do not hold what is proved here."""
    found = []
    for name, peak in peaks.items():
        low, high = (row[f"{name}_log_peak_{end}"] for end in ("low", "high"))
        if not (ball(low) <= peak and peak <= ball(high)):
            found.append(f"{name} cycle from {low} to {high}, but here {peak.str(20)}")
    return found


def verdict(row):
    """Empty when all that the row states is proved and its bounds hold it, else the reason."""
    try:
        if is_bistable(row):
            return "; ".join(faults_of_three(row, prove_three(row)))
        return "; ".join(faults(row, *prove(row)))
    except NotProved as reason:
        return f"not proved: {reason}"


def main():
    parser = argparse.ArgumentParser(description="Proves the cycles of slipmode simulate --certify, or of the table bistability-certified, again.")
    parser.add_argument("file")
    parser.add_argument("--law", choices=("slip", "aging"), help="the law of rows without a column law")
    parser.add_argument("--rows", type=lambda text: set(map(int, text.split(","))), help="only these, such as 30,45")
    arguments = parser.parse_args()
    passed = failed = 0
    with open(arguments.file, newline="") as file:
        for number, row in enumerate(csv.DictReader(file), 1):
            states_a_cycle = is_bistable(row) or row["certificate"] == "cycle"
            if not states_a_cycle or number not in (arguments.rows or (number,)):
                continue
            reason = verdict({"law": arguments.law} | row)
            passed, failed = passed + (not reason), failed + bool(reason)
            print(f"row {number}: {reason or 'proved, and inside the stated bounds'}", flush=True)
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
