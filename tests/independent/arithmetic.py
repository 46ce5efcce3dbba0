"""Numbers in one of two modes: rational and exact, or real and complex with so many digits."""

from contextlib import contextmanager
from fractions import Fraction
from itertools import islice
from math import isqrt

from mpmath import mp, mpf


class NoValue(Exception):
    """A division by zero, or a function outside its domain."""


class Inexact(Exception):
    """What has no rational value, or none that is computed exactly."""


class Unclear(Exception):
    """What these digits do not decide, or a computation that did not converge."""


exact = False


@contextmanager
def exactly():
    """All numbers are fractions."""
    global exact
    before, exact = exact, True
    try:
        yield
    finally:
        exact = before


@contextmanager
def digits(count):
    """All numbers have so many decimal digits."""
    global exact
    before, exact = exact, False
    try:
        with mp.workdps(count):
            yield
    finally:
        exact = before


def mode():
    """What a stored value depends on besides its name."""
    return 0 if exact else mp.dps


def number(value):
    """A fraction in the mode at hand."""
    return value if exact else mpf(value.numerator) / value.denominator


def is_real(value):
    return value.imag == 0


def quotient(above, below):
    if below == 0:
        raise NoValue("a division by zero")
    return above / below


def power(base, exponent):
    if exponent <= 0 and base == 0:
        raise NoValue("a power of zero")
    return base**exponent


def taylor(values, at):
    """The value of the polynomial with these values at 0 of itself and of its derivatives."""
    found = number(Fraction(0))
    for place in range(len(values) - 1, -1, -1):
        found = values[place] + (found * at / (place + 1) if found else found)
    return found


def apply(word, value):
    """One of the functions of the language."""
    value = value.real if is_real(value) else value
    if word in ("ln", "sqrt") and is_real(value) and (value < 0 or word == "ln" and value == 0):
        if not exact and abs(value) < mpf(10) ** (-mp.dps // 2):
            raise Unclear("zero or a small negative number")
        raise NoValue(f"{word} of a number that is not positive")
    if exact:
        return apply_exactly(word, value)
    return {"ln": mp.ln, "sqrt": mp.sqrt, "abs": abs, "exp": mp.exp, "asinh": mp.asinh, "sin": mp.sin, "cos": mp.cos}[word](value)


def apply_exactly(word, value):
    if word == "abs":
        return abs(value)
    if word == "sqrt":
        roots = isqrt(value.numerator), isqrt(value.denominator)
        if roots[0] ** 2 == value.numerator and roots[1] ** 2 == value.denominator:
            return Fraction(*roots)
    elif value == (1 if word == "ln" else 0):
        return Fraction(int(word in ("exp", "cos")))
    raise Inexact(word)


def derivative(function, at, scale):
    """A slope by central differences: the step is the scale times 10^(-2/3 of twice the digits)."""
    if exact:
        raise Inexact("a slope")
    count = mp.dps
    with digits(2 * count + 10):
        step = scale * mpf(10) ** (-(4 * count) // 3 // 2)
        found = (function(at + step) - function(at - step)) / (2 * step)
    return +found


def interpolated(function, nodes):
    """The coefficients, by ascending power, of the polynomial through the values at the nodes (Newton's form)."""
    values = [function(node) for node in nodes]
    for order in range(1, len(nodes)):
        for place in range(len(nodes) - 1, order - 1, -1):
            values[place] = (values[place] - values[place - 1]) / (nodes[place] - nodes[place - order])
    found = [values[-1]]
    for node, value in zip(nodes[-2::-1], values[-2::-1]):
        shifted = [value * 0, *found]
        for power_of, coefficient in enumerate(found):
            shifted[power_of] -= node * coefficient
        shifted[0] += value
        found = shifted
    return found


def coefficients(function, most=12):
    """The coefficients of a polynomial of unknown degree, without leading zeros; one that is none is refused."""
    for degree in (min(most, 4), most):
        found, tiny = through_points(function, degree + 2)
        if abs(found[-1]) <= tiny:
            break
    else:
        raise Unclear("no polynomial of small degree")
    while found and abs(found[-1]) <= tiny:
        found.pop()
    return found


def through_points(function, count):
    """The polynomial through so many points, and what counts as zero among its coefficients."""
    if exact:
        return interpolated(function, [Fraction(node) for node in range(1, count + 1)]), 0
    before = mp.dps
    with digits(before + 40):
        found = interpolated(function, [mpf(node) for node in range(1, count + 1)])
        return found, max(abs(one) for one in found) * mpf(10) ** (-before - 15)


def roots(given):
    """The complex roots of the polynomial with these coefficients, in units in which their product is 1."""
    given = list(given)
    zeros = 0
    while given and given[0] == 0:
        given.pop(0)
        zeros += 1
    if len(given) < 2:
        if not given or not zeros:
            raise Unclear("a constant has no roots")
        return [mp.mpc(0)] * zeros
    given = [number(one) if isinstance(one, Fraction) else one for one in given]
    degree = len(given) - 1
    unit = abs(given[0] / given[-1]) ** (mpf(1) / degree)
    scaled = [one * unit**place for place, one in enumerate(given)]
    largest = max(abs(one) for one in scaled)
    try:
        found = mp.polyroots([one / largest for one in reversed(scaled)], maxsteps=300, extraprec=2 * mp.prec)
    except mp.NoConvergence as error:
        raise Unclear("roots that are nearly equal") from error
    return [mp.mpc(0)] * zeros + [unit * mp.mpc(one) for one in found]


def determinant(rows):
    """By elimination with the largest pivot."""
    rows = [list(row) for row in rows]
    value = number(Fraction(1))
    while rows:
        pivot = max(range(len(rows)), key=lambda place: abs(rows[place][0]))
        if rows[pivot][0] == 0:
            return value * 0
        first = rows.pop(pivot)
        value *= first[0] * (-1) ** pivot
        rows = [[one - first_one * row[0] / first[0] for one, first_one in zip(row[1:], first[1:])] for row in rows]
    return value


def zero(function, positive, branch=0):
    """Where a function of one variable is zero: linear or quadratic by its values, else a change of sign on a grid.

    The branch chooses among several zeros.
    """
    try:
        found = coefficients(function, 3)
    except (NoValue, Unclear):
        found = []
    if len(found) == 2:
        return -found[0] / found[1]
    if len(found) == 3:
        root = apply("sqrt", found[1] ** 2 - 4 * found[2] * found[0])
        both = [(-found[1] + sign * root) / (2 * found[2]) for sign in (1, -1)]
        wanted = [one for one in both if one > 0] if positive else both
        if not wanted:
            raise Unclear("no positive zero")
        return wanted[branch % len(wanted)]
    if exact:
        raise Inexact("a zero")
    found = list(islice(searched(function, positive), branch + 1))
    if not found:
        raise Unclear("no zero on the grid")
    return found[branch % len(found)]


def searched(function, positive):
    """Zeros between two points of a logarithmic grid at which the signs differ."""
    real = lambda at: function(at).real
    for sign in (1,) if positive else (1, -1):
        before = None
        for place in range(-16, 17):
            at = sign * mpf(10) ** (mpf(place) / 2)
            try:
                value = function(at)
            except (NoValue, Unclear):
                before = None
                continue
            if not is_real(value):
                break
            value = value.real
            if value == 0:
                yield at
            elif before and before[1] != 0 and (before[1] > 0) != (value > 0):
                try:
                    found = mp.findroot(real, (before[0], at), solver="anderson", maxsteps=60, verify=False)
                    if abs(function(found)) < abs(value) * mpf(10) ** (-mp.dps // 2):
                        yield found
                except (ValueError, ZeroDivisionError, NoValue, Unclear):
                    pass
            before = (at, value)
