"""Random points that meet the conditions of a formula, edges and near edges included."""

from fractions import Fraction

from mpmath import mp, mpf

import arithmetic
from arithmetic import Inexact, NoValue, Unclear, digits, exactly
from claims import sides
from language import Behaviour, Comparison, Joined, Roots, atoms
from names import Point
from truth import FEW, MANY, difference, meets, sign

SMALL = [Fraction(*pair) for pair in ((1, 1), (2, 1), (1, 2), (3, 1), (4, 1), (1, 4), (9, 1), (1, 9), (16, 1), (3, 2), (25, 4))]
TRIES = 40
LEAST = mpf(10) ** -30  # What is closer to zero than this is a zero with a rounding error.


class Ambiguous(Exception):
    """An equation among the conditions can be solved for several variables, and another one moves."""


def is_coefficient(name):
    """Whether a name is the value at 0 of a function or of its derivative."""
    return name.endswith("(0)")


class Sampler:
    """Points of one formula."""

    def __init__(self, formula, names, random):
        self.formula, self.random = formula, random
        self.moving = formula.statement.variable if isinstance(formula.statement, Behaviour) else None
        equal = [one for one in formula.given if one.mark == "="]
        bound = [Comparison(("name", name), mark, ("number", end)) for name, ends in formula.box.items() for mark, end in zip((">=", "<="), ends)]
        self.conditions = [one for one in formula.given if one.mark != "="] + bound
        self.names = names
        self.variables = self.names_of(sides(formula))
        self.solved = {}
        for one in equal:
            self.solve(one)
        positive = [name for name in self.solved if name in names.positive]
        self.conditions += [Comparison(("name", name), ">", ("number", Fraction(0))) for name in positive]
        self.variables = [name for name in self.variables if name not in self.solved]

    def names_of(self, trees):
        free = {name for tree, bound in trees for name in self.names.variables_of([tree]) if name != bound}
        moved = [self.moving] if self.moving else []
        return sorted(free.union(moved, self.formula.there_is, self.formula.at, self.formula.box))

    def solve(self, condition):
        """Takes the variable alone on one side, else the only one, else the first one in which the condition is linear."""
        tree = ("sub", condition.left, condition.right)
        fixed = {self.moving, *self.formula.at, *self.solved}
        moves = self.formula.moves
        alone = [side[1] for side in (condition.left, condition.right) if side[0] == "name" and side[1] in self.variables]
        listed = [moves] if isinstance(moves, str) else list(moves or ())
        wanted = [name for name in [*listed, *alone, *self.names.variables_of([tree])] if name not in fixed and not is_coefficient(name)]
        found = [name for name in dict.fromkeys(wanted) if self.is_linear(tree, name)]
        if not found:
            raise Ambiguous(f"'{condition.left} = {condition.right}' is linear in no variable")
        if self.moving and self.moving in self.names.reach_of(tree) and len(found) > 1 and found[0] not in [*listed, *alone]:
            raise Ambiguous("several variables may move with the one that moves")
        self.solved[found[0]] = ("derived", "solved", (tree, found[0]))
        self.names = self.names.with_solved(self.solved)

    def is_linear(self, tree, name):
        """Whether the values at some points are those of a polynomial of degree 1."""
        for _ in range(8):
            point = Point(self.names, self.values(0))
            try:
                with digits(30):
                    return len(arithmetic.coefficients(point.with_moved(tree, name), 2)) == 2
            except Unclear:
                return False
            except NoValue:
                continue
        return False

    def values(self, kind):
        return {name: self.value(name, kind) for name in self.variables}

    def value(self, name, kind):
        """A number of one kind: small and rational, or spread over 2, 6 or 12 decades."""
        random, formula = self.random, self.formula
        if name in formula.at:
            return formula.at[name]
        if name == "pm":
            return Fraction(random.choice((1, -1)))
        if name in formula.box:
            low, high = formula.box[name]
            return low + (high - low) * random.choice((Fraction(0), Fraction(1), Fraction(random.randint(0, 10**6), 10**6)))
        if is_coefficient(name):
            degree = random.choice((1, 1, 2, 3, 6))
            return Fraction(random.randint(-9, 9), random.randint(1, 4)) if name.count("'") <= degree else Fraction(0)
        if kind == 0:
            size = random.choice(SMALL)
        else:
            size = Fraction(round(1000 * 10 ** random.uniform(0, 1)), 1000) * Fraction(10) ** random.randint(*((-1, 0), (-3, 2), (-6, 5))[kind - 1])
        return size if name in self.names.positive else size * random.choice((1, 1, -1, -1, 0))

    def drawn(self, index):
        """A point that meets the conditions, or None: variables of a condition that is not met are drawn again."""
        kind = index % 4
        values = self.values(kind)
        for _ in range(TRIES):
            point = Point(self.names, values)
            broken = [one for one in self.wanted() if not self.met(point, one)]
            if not broken:
                return point
            among = [name for name in self.names.variables_of([broken[0].left, broken[0].right]) if name in values]
            if not among:
                return None
            name = self.random.choice(among)
            values = values | {name: self.value(name, self.random.randint(0, 2) if kind else 0)}
        return None

    def wanted(self):
        """The conditions on the variables that are not to be found."""
        own = set(self.formula.there_is)
        return [one for one in self.conditions if not own & (self.names.reach_of(one.left) | self.names.reach_of(one.right))]

    def met(self, point, one):
        return meets(point, [one]) is True

    def on_edge(self, point, index, only=()):
        """The point with one variable moved onto an equality of a comparison, or close beside it; None where that is not possible."""
        edges = [*self.compared(), *self.conditions]
        if not edges:
            return None
        edge = edges[index % len(edges)]
        tree = ("sub", edge.left, edge.right)
        fixed = {"pm", *self.formula.at}
        names = [name for name in self.names.variables_of([tree]) if name in point.values and name not in fixed]
        names = [name for name in names if not only or name in only]
        if not names or not self.is_off(point, edge):
            return None
        name = self.random.choice(names)
        branch = str(index // len(edges) % 3)
        zero = lambda: point.value(("derived", "solved", (tree, name, branch)))
        beside = self.random.choice((0, 0, 1, -1))
        place = zero if not beside else self.beside(zero, beside * Fraction(1, 10 ** self.random.randint(1, 12)))
        try:
            self.rational(zero)  # A zero that is a rounding error has no points beside it either.
            moved = Point(self.names, point.values | {name: self.rational(place)})
            positive = name not in self.names.positive or sign(lambda: (moved.get(name), 1)) == 1
            return moved if positive and meets(moved, self.wanted()) else None
        except (Unclear, NoValue):
            return None

    @staticmethod
    def is_off(point, edge):
        """Whether the point is certainly off the edge; two sides that are equal everywhere have none."""
        try:
            return sign(difference(point, edge.left, edge.right)) in (1, -1)
        except (Unclear, NoValue):
            return False

    def compared(self):
        said = self.formula.statement
        if isinstance(said, Behaviour) or isinstance(said, Comparison) and said.mark == "=":
            return []  # An equation that holds everywhere has no edge.
        return [one for one in atoms(said) if isinstance(one, Comparison)]

    @staticmethod
    def beside(zero, part):
        def place():
            at = zero()
            return at + arithmetic.number(part) * (at if at else 1)

        return place

    @staticmethod
    def rational(place):
        """A value as a fraction, where it is one."""
        try:
            with exactly():
                return place()
        except Inexact:
            found = []
            for count in (FEW, MANY):
                with digits(count):
                    found.append(place())
            off = abs(found[0] - found[1])
            if not all(map(arithmetic.is_real, found)) or off > abs(found[1]) * mpf(10) ** (-FEW // 2) or abs(found[1]) < LEAST:
                raise Unclear("no zero that more digits confirm")
            return place

    def points(self, count):
        """So many points, where that many are found; every third on or beside an edge."""
        found = 0
        for index in range(6 * count):
            point = self.drawn(index)
            if point is not None and index % 3 == 2:
                point = self.on_edge(point, index // 3) or point
            if point is not None:
                found += 1
                yield point
            if found == count:
                return


def words(point):
    """A point for people."""
    shown = {}
    for name, value in sorted(point.values.items()):
        with digits(20):
            shown[name] = str(value) if isinstance(value, Fraction) else mp.nstr(value() if callable(value) else value, 17)
    return ", ".join(f"{name} = {value}" for name, value in shown.items())
