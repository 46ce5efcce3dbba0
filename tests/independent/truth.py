"""Whether a formula is true at a point: True, False, or None where the digits do not decide.

A quantity is computed with fractions where that is possible. Otherwise it is computed with 50 and with 80 digits. Their difference
estimates the error of the first; the sign counts only where the quantity exceeds it a thousand times, and the quantity counts as
zero only where 80 digits bring it 20 orders of magnitude below that error, and where it comes from numbers below 10^20: beside
larger ones a difference of any size may be below the last digit.
"""

from contextlib import contextmanager
from fractions import Fraction

from mpmath import mp, mpf

import arithmetic
from arithmetic import Inexact, NoValue, Unclear, digits, exactly
from language import Behaviour, Comparison, Crossing, Joined, Roots

FEW, MANY = 50, 80
TINY = mpf(10) ** -20
LARGEST = mpf(10) ** 20


is_exact_only = False


@contextmanager
def exact_only():
    """What has no exact sign has none: a difference too small for the digits, such as exp(-10^4), is no zero."""
    global is_exact_only
    before, is_exact_only = is_exact_only, True
    try:
        yield
    finally:
        is_exact_only = before


def sign(quantity):
    """The sign of the first of what a computation gives, beside the size of what it was computed from."""
    try:
        with exactly():
            value = quantity()[0]
            return (value > 0) - (value < 0)
    except Inexact:
        if is_exact_only:
            return None
    with digits(FEW):
        few, size = quantity()
    with digits(MANY):
        many = quantity()[0]
        is_zero = lambda error: abs(many) <= TINY * error and size < LARGEST
        error = max(abs(few - many), size * mpf(10) ** (5 - FEW))
        if not mp.isfinite(error):
            return None
        if not arithmetic.is_real(many):
            return 1 if abs(many) > 1000 * error else 0 if is_zero(error) else None
        many = many.real
        if abs(many) > 1000 * error:
            return 1 if many > 0 else -1
        return 0 if is_zero(error) else None


def difference(point, left, right):
    def quantity():
        one, other = point.value(left), point.value(right)
        return one - other, abs(one) + abs(other)

    return quantity


HOLDS = {"=": (0,), "!=": (1, -1), "<": (-1,), ">": (1,), "<=": (-1, 0), ">=": (1, 0)}


def compares(point, one):
    found = sign(difference(point, one.left, one.right))
    return None if found is None else found in HOLDS[one.mark]


def roots_of(point, tree, s):
    """The roots at the digits at hand, from coefficients that are exact where that is possible."""
    key = ("roots", tree, s, mp.dps)
    if key not in point.known:
        point.known[key] = computed_roots(point, tree, s)
    return point.known[key]


def computed_roots(point, tree, s):
    function = point.along(tree, s)
    try:
        with exactly():
            found = arithmetic.coefficients(function)
    except Inexact:
        found = arithmetic.coefficients(function)
    return arithmetic.roots(found)


def located(point, one):
    """stable, unstable or all_real."""

    def quantity():
        if arithmetic.exact:
            raise Inexact("roots")
        found = roots_of(point, one.polynomial, one.variable)
        size = max(abs(root) for root in found)
        return max(abs(root.imag) if one.kind == "all_real" else root.real for root in found), size

    found = sign(quantity)
    return None if found is None else found == {"stable": -1, "unstable": 1, "all_real": 0}[one.kind]


def crosses(point, one):
    """Two roots lie at ±i times the frequency, no other one on the axis, and the real part has a slope in the parameter."""
    critical = lambda: point.value(one.critical)
    there = point.moved({one.parameter: critical})
    if one.parameter in point.names.positive and sign(lambda: (critical(), abs(critical()))) != 1:
        return None

    def nearest(place, wanted):
        return min(roots_of(place, one.polynomial, one.variable), key=lambda root: abs(root - wanted))

    def frequency():
        if arithmetic.exact:
            raise Inexact("roots")
        return point.value(one.frequency)

    def off(direction):
        wanted = mp.mpc(0, direction) * frequency()
        return nearest(there, wanted) - wanted, abs(wanted)

    def others():
        wanted = abs(frequency())
        rest = sorted(roots_of(there, one.polynomial, one.variable), key=lambda root: abs(abs(root.imag) - wanted) + abs(root.real))
        return min((abs(root.real) for root in rest[2:]), default=wanted), wanted

    def slope():
        wanted, at = mp.mpc(0, 1) * frequency(), critical()
        scale = abs(at) if at else mpf(1)
        with digits(mp.dps + mp.dps // 2):
            step = scale * mpf(10) ** (-mp.dps // 4)
            ends = [nearest(point.moved({one.parameter: at + way * step}), wanted) for way in (1, -1)]
        if max(abs(end - wanted) for end in ends) > abs(wanted) / 100:
            raise Unclear("a pair that moves far with a small step")
        return (ends[0].real - ends[1].real) / (2 * step), abs(wanted) / scale

    found = [sign(lambda: (frequency(), abs(frequency()))), sign(others), sign(slope), sign(lambda: off(1)), sign(lambda: off(-1))]
    true = [value if value is None else bool(value) for value in found[:3]]
    return every(true + [None if value is None else value == 0 for value in found[3:]])


def every(truths):
    return False if False in truths else None if None in truths else True


def opposite(truth):
    return None if truth is None else not truth


def joined(point, formula):
    parts = [formula_truth(point, part) for part in formula.parts]
    if formula.word == "not":
        return opposite(parts[0])
    if formula.word == "and":
        return every(parts)
    if formula.word == "or":
        return opposite(every([opposite(part) for part in parts]))
    if formula.word == "implies":
        return opposite(every([parts[0], opposite(parts[1])]))
    return None if None in parts else parts[0] == parts[1]


def formula_truth(point, formula):
    """The truth of a formula that speaks of one point."""
    kinds = {Joined: joined, Comparison: compares, Roots: located, Crossing: crosses}
    try:
        return kinds[type(formula)](point, formula)
    except Unclear:
        return None


def meets(point, conditions):
    """Whether conditions are true; one without a value is not."""
    try:
        return every([formula_truth(point, one) for one in conditions])
    except NoValue:
        return False


# Statements on how a side behaves as a variable moves.

DISTANCES = (10, 20, 40, 80)


def tends(point, said):
    """Whether the side comes closer to the value, or grows, at four distances from the end of the variable's range."""
    ends = [1] if said.variable in point.names.positive or said.toward == "infinity" else [1, -1]
    return every([tends_from(point, said, way) for way in ends])


def tends_from(point, said, way):
    with digits(6 * DISTANCES[-1]):
        places = [way * mpf(10) ** (distance if said.toward == "infinity" else -distance) for distance in DISTANCES]
        found = [point.with_moved(said.side, said.variable)(at) for at in places]
        if said.beyond:
            return goes_beyond([said.beyond * one for one in found])
        value = point.value(said.value)
        off = [abs(one - value) for one in found]
        if off[-1] <= mpf(10) ** -30 * abs(value) or off[-1] <= off[-2] * 1e-4 <= off[-3] * 1e-8:
            return True
        settled = abs(found[-1] - found[-2]) <= off[-1] / 1000
        return False if settled or abs(found[-1]) > 1e6 * abs(found[-2]) else None


def goes_beyond(found):
    """Whether values grow beyond all bounds: what a logarithm gains doubles from one distance to the next, beside a constant of any size."""
    if not all(arithmetic.is_real(one) for one in found):
        return None
    gains = [later - one for one, later in zip(found, found[1:])]
    grows = lambda way: way * gains[0] > 0 and all(way * (later - 1.5 * one) > 0 for one, later in zip(gains, gains[1:]))
    if grows(1):
        return True
    stays = all(abs(later) <= abs(one) * mpf(0.75) for one, later in zip(gains, gains[1:]))
    return False if stays or grows(-1) else None


def moved_pairs(point, said, conditions, random):
    """Points with the variable elsewhere, under the same conditions."""
    at = point.get(said.variable)
    factors = [Fraction(1001, 1000), Fraction(2), Fraction(1, 3), Fraction(100), Fraction(random.randint(1, 1000), 100)]
    places = [at * factor for factor in factors]
    if said.variable not in point.names.positive:
        places += [at + 1, at - Fraction(1, 7), -at]
    for place in places:
        moved = point.moved({said.variable: place})
        if place != at and meets(moved, conditions):
            yield place > at, moved


def changes(point, moved, tree):
    """The sign of what a tree gains from one point to another."""

    def quantity():
        before, after = point.value(tree), moved.value(tree)
        return after - before, abs(before) + abs(after)

    return sign(quantity)


def behaves(point, said, conditions, random):
    """The truth of a statement on how a side behaves, from this point to others."""
    try:
        if said.kind == "tends":
            return tends(point, said)
        with exactly():
            pairs = list(moved_pairs(point, said, conditions, random))
        found = [(up, changes(point, moved, said.side)) for up, moved in pairs]
    except (Unclear, Inexact):
        return None
    if not found or None in [change for _, change in found]:
        return None
    if said.kind in ("rises", "falls"):
        wanted = 1 if said.kind == "rises" else -1
        return all(change == (wanted if up else -wanted) for up, change in found)
    return all(change == 0 for _, change in found) == (said.kind == "does not depend")


def truth(point, said, conditions, random):
    if isinstance(said, Behaviour):
        return behaves(point, said, conditions, random)
    return formula_truth(point, said)
