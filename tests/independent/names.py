"""What the names of a file of equations mean, and their values at a point: every derivation is a computation with numbers."""

from fractions import Fraction

from mpmath import mp, mpf

import arithmetic
from arithmetic import Inexact, NoValue, Unclear, number
from language import Unreadable, declared, definition, expression, names_in, values_at_zero


# Which argument of a derivation is a name that stands for any value.
BINDS = {"coefficient": 1, "discriminant": 1, "hurwitz": 1, "eliminate": 2, "solve": 1, "solved": 1, "limit": 1}


class Names:
    """Variables, definitions and systems of `equations.toml`."""

    def __init__(self, content):
        declared.clear()
        declared.update(one["name"] for one in content.get("function", ()))
        assumptions = content.get("assumptions", {})
        self.positive = set(assumptions.get("positive", ()))
        self.conditions = list(assumptions.get("conditions", ()))
        self.systems = {one["name"]: one for one in content.get("system", ())}
        self.definitions = {one["name"]: definition(one["is"]) for one in content.get("definition", ())}
        self.solved, self.reaches = {}, {}
        assumed = self.positive | set(assumptions.get("free", ()))
        assumed |= {state for one in self.systems.values() for state in one["state"]}
        assumed |= {tree[2][1] for tree in self.definitions.values() if tree[:2] == ("derived", "characteristic")}
        for name, one in self.systems.items():
            for key in ("rates", "steady"):
                one[key] = [expression(text) for text in one.get(key, ())]
            self.definitions[f"slopes of {name}"] = ("derived", "slopes", (name,))
            if len(one["rates"]) != len(one["state"]):
                raise Unreadable(f"system {name}: as many rates as states are needed")
        self.add_equations(content.get("equation", ()), assumed)

    def add_equations(self, equations, assumed):
        """A name alone on the left of one equation, and left_N, right_N and residual_N of each."""
        read = [(one["number"], *map(expression, one["equation"].split("=", 1))) for one in equations]
        alone = [(left[1], right) for _, left, right in read if left[0] == "name" and left[1] not in assumed]
        by_name = {name: [right for other, right in alone if other == name] for name, _ in alone}
        single = {name: all_of[0] for name, all_of in by_name.items() if len(all_of) == 1 and "pm" not in names_in(all_of[0])}
        for number_of, left, right in read:
            if left[0] == "name" and left[1] in single:
                left = ("name", f"{left[1]} itself")  # A side of an equation is not what the equation defines.
            word = number_of.replace("-", "_").replace(".", "_")
            self.definitions |= {f"left_{word}": left, f"right_{word}": right, f"residual_{word}": ("sub", left, right)}
        self.definitions |= single
        self.find_reaches()
        for name in [name for name in single if name in self.reach_of(single[name])]:
            del self.definitions[name]
        self.find_reaches()

    def with_solved(self, solved):
        """The same names, where some variables are what solves a condition, each in terms of those that are solved for later."""
        other = object.__new__(Names)
        other.__dict__ |= self.__dict__
        other.solved, other.definitions = solved, self.definitions | solved
        other.find_reaches()
        earlier = set()
        for name in solved:
            other.reaches[name] -= earlier
            earlier.add(name)
        return other

    def find_reaches(self):
        """All names on which the value of each definition may depend, itself too."""
        self.reaches = {name: {name} for name in self.definitions}
        changed = True
        while changed:
            found = {name: {name} | self.reach_of(tree) for name, tree in self.definitions.items()}
            changed, self.reaches = found != self.reaches, found

    def reach(self, name):
        return self.reaches.get(name, {name})

    def reach_of(self, tree):
        """All names on which the value of a tree may depend, but for those that are bound in it."""
        if tree[0] != "derived":
            return set().union(*map(self.reach, names_in(tree)))
        word, given = tree[1:]
        if word == "at":
            inner = self.reach_of(given[0]) - {name for _, name, _ in given[1:]}
            return inner.union(*(self.reach_of(value) for _, _, value in given[1:]))
        names = {part for part in given if isinstance(part, str) and part not in self.systems}
        found = set().union(*(self.reach_of(part) for part in given if isinstance(part, tuple)), *map(self.reach, names))
        for system in (self.systems[part] for part in given if isinstance(part, str) and part in self.systems):
            found |= {system["name"]}.union(system["state"], *map(self.reach_of, system["rates"]))
            if word != "rate":
                found = (found - set(system["state"])).union(*map(self.reach_of, system["steady"]))
        return found - {given[BINDS[word]]} if word in BINDS else found

    def variables_of(self, trees):
        """The variables on which trees may depend."""
        reached = set().union(*(self.reach_of(tree) for tree in trees))
        others = {"infinity", "i"} | set(self.systems) | set(self.definitions)
        return sorted(name for name in reached - others if not name.isdigit())


class Point:
    """Values of variables, some of them as computations in the values of the point around it.

    A variable that solves a condition moves with others where a claim moves them, not where a definition does.
    """

    def __init__(self, names, values, around=None, moves=True):
        self.names, self.values, self.around, self.moves, self.known = names, values, around, moves, {}

    def inside(self, values):
        """The same point with other values of some variables, for a definition."""
        return Point(self.names, values, self, False)

    def moved(self, values):
        """The same point with other values of some variables, for a claim."""
        return Point(self.names, values, self)

    def get(self, name):
        if self.around is not None and name not in self.values and self.is_outer(name):
            return self.around.get(name)
        key = (name, arithmetic.mode())
        if key not in self.known:
            self.known[key] = self.find(name)
        return self.known[key]

    def is_outer(self, name):
        """Whether the values here leave a name as it is around."""
        if name in self.names.solved and not self.moves or self.names.reach(name).isdisjoint(self.values):
            return True
        point = self.around
        while point is not None and name not in point.values:
            point = point.around
        return point is not None

    def find(self, name):
        if name in self.values:
            value = self.values[name]
            value = value() if callable(value) else value
            if arithmetic.exact and not isinstance(value, Fraction):
                raise Inexact(name)
            return number(value) if isinstance(value, Fraction) else value
        if name in self.names.definitions:
            return self.value(self.names.definitions[name])
        if name == "i":
            if arithmetic.exact:
                raise Inexact("i")
            return mp.mpc(0, 1)
        if self.around is None:
            raise Unreadable(f"'{name}' is no variable and no defined name")
        return self.around.get(name)

    def value(self, tree):
        """The value of a tree here."""
        word = tree[0]
        if word == "number":
            return number(tree[1])
        if word == "name":
            return self.get(tree[1])
        if word == "function":
            return arithmetic.taylor([self.get(name) for name in values_at_zero(tree[1])], self.value(tree[2]))
        if word == "call":
            return arithmetic.apply(tree[1], self.value(tree[2]))
        if word == "power":
            return arithmetic.power(self.value(tree[1]), tree[2])
        if word == "derived":
            return DERIVED[tree[1]](self, *tree[2])
        if word == "neg":
            return -self.value(tree[1])
        left, right = self.value(tree[1]), self.value(tree[2])
        if word == "div":
            return arithmetic.quotient(left, right)
        return left + right if word == "add" else left - right if word == "sub" else left * right

    def along(self, tree, name):
        """A tree as a function of one variable, for a definition."""
        return lambda value: self.inside({name: value}).value(tree)

    def with_moved(self, tree, name):
        """A tree as a function of one variable, for a claim."""
        return lambda value: self.moved({name: value}).value(tree)

    def at_rest(self, system):
        """This point with a system in its steady state."""
        states = self.names.systems[system]
        if not states["steady"]:
            raise Unreadable(f"the system {system} states no steady state")
        return self.inside({name: lambda tree=tree: self.value(tree) for name, tree in zip(states["state"], states["steady"])})


def slope(point, tree, name):
    """A derivative with the other variables fixed."""
    at = point.get(name)
    return arithmetic.derivative(point.along(tree, name), at, abs(at) if at else 1)


def slopes(point, system):
    """The matrix of the slopes of a system's rates at its steady state."""
    states, rest = point.names.systems[system], point.at_rest(system)
    return [[slope(rest, rate, state) for state in states["state"]] for rate in states["rates"]]


def linearised(point, system, rate, by):
    state = point.names.systems[system]["state"]
    return point.get(f"slopes of {system}")[state.index(rate)][state.index(by)]


def characteristic(point, system, s):
    """det(s - J) at the value of s."""
    matrix, s = point.get(f"slopes of {system}"), point.get(s)
    return arithmetic.determinant(
        [[(s if row == column else s * 0) - one for column, one in enumerate(line)] for row, line in enumerate(matrix)]
    )


def rate(point, tree, system):
    """The slope of a tree along the motion through the point: one difference in the direction of all rates."""
    states = point.names.systems[system]
    pace = {name: point.value(rate_of) for name, rate_of in zip(states["state"], states["rates"])}
    spans = [abs(point.get(name) / one) for name, one in pace.items() if one and point.get(name)]
    moved = lambda time: point.inside({name: point.get(name) + time * one for name, one in pace.items()}).value(tree)
    return arithmetic.derivative(moved, 0 * next(iter(pace.values())), min(spans, default=1))


def polynomial(point, tree, s):
    return arithmetic.coefficients(point.along(tree, s))


def coefficient(point, tree, s, power):
    found = polynomial(point, tree, s)
    return found[int(power)] if int(power) < len(found) else number(Fraction(0))


def inexact_roots(point, tree, s):
    """The leading coefficient and the roots."""
    if arithmetic.exact:
        raise Inexact("roots")
    found = polynomial(point, tree, s)
    return found[-1], arithmetic.roots(found)


def discriminant(point, tree, s):
    """The product of the squared differences of the roots."""
    leading, found = inexact_roots(point, tree, s)
    value = leading ** (2 * len(found) - 2)
    for place, one in enumerate(found):
        for other in found[:place]:
            value *= (one - other) ** 2
    return value.real


def hurwitz(point, tree, s, order):
    found, order = polynomial(point, tree, s), int(order)
    degree = len(found) - 1
    entry = lambda place: found[place] if 0 <= place <= degree else number(Fraction(0))
    return arithmetic.determinant([[entry(degree + row - 2 * column - 1) for column in range(order)] for row in range(order)])


def eliminate(point, tree, other, s):
    """The resultant: the values of the second polynomial at the roots of the first, multiplied."""
    leading, found = inexact_roots(point, tree, s)
    second = polynomial(point, other, s)
    value = leading ** (len(second) - 1)
    for root in found:
        value *= mp.polyval(second[::-1], root)
    return value.real


def solve(point, tree, x):
    return arithmetic.zero(point.along(tree, x), x in point.names.positive)


def solved(point, tree, x, branch="0"):
    """The value of a variable that solves a condition of a claim."""
    return arithmetic.zero(point.with_moved(tree, x), x in point.names.positive, int(branch))


def limit(point, tree, x, toward):
    """The value so close to the end that what is left of any power of x is below the last digit, compared with half as close."""
    if arithmetic.exact:
        raise Inexact("a limit")
    count = mp.dps
    with arithmetic.digits(4 * count + 20):
        near = mpf(10) ** (3 * count // 2 * (1 if toward == "infinity" else -1))
        function = point.along(tree, x)
        found, before = function(near), function(mp.sqrt(near))
    if abs(found - before) > mpf(10) ** (-count // 2) * max(abs(found), abs(before)) and abs(found) > mpf(10) ** (-count):
        raise Unclear("no limit")
    return +found


def series(point, tree, x, order):
    """The polynomial through points so close to zero that its coefficients are those of the series."""
    if arithmetic.exact:
        raise Inexact("a series")
    count, order, at = mp.dps, int(order), point.get(x)
    with arithmetic.digits(3 * count * (order + 2)):
        unit = mpf(10) ** (-2 * count)
        found = arithmetic.interpolated(point.along(tree, x), [unit * place for place in range(1, order + 2)])
    return sum((coefficient * at**place for place, coefficient in enumerate(found)), number(Fraction(0)))


def exchange(point, tree, x, y):
    return point.inside({x: lambda: point.get(y), y: lambda: point.get(x)}).value(tree)


def at(point, tree, *values):
    return point.inside({name: lambda inner=inner: point.value(inner) for _, name, inner in values}).value(tree)


DERIVED = {
    "slopes": slopes, "linearised": linearised, "characteristic": characteristic, "rate": rate, "coefficient": coefficient,
    "discriminant": discriminant, "hurwitz": hurwitz, "eliminate": eliminate, "solve": solve, "solved": solved, "derivative": slope,
    "limit": limit, "series": series, "exchange": exchange, "at": at,
}
