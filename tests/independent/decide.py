"""Compares the recorded verdict of one formula with its truth at random points and at the printed counter-example."""

from dataclasses import dataclass
from fractions import Fraction
from random import Random

from arithmetic import Inexact, NoValue, Unclear, exactly
from claims import OTHER, printed_point
from language import Behaviour, Unreadable
from names import Point
from points import Ambiguous, Sampler, words
from truth import changes, exact_only, formula_truth, meets, truth

CANDIDATES = 60


@dataclass
class Tally:
    """What was found of one formula."""

    tried: int = 0
    true: int = 0
    false: int = 0
    place: str = ""
    contradiction: str = ""
    remark: str = ""

    @property
    def decided(self):
        return self.true + self.false


def compare(formula, names, count, seed):
    """The tally of a formula."""
    random = Random(f"{seed} {formula.id} {formula.text}")
    tally = Tally()
    try:
        sampler = Sampler(formula, names, random)
    except Ambiguous as error:
        tally.remark = str(error)
        return tally
    if formula.verdict not in ("holds", "fails"):
        tally.remark = f"no verdict to compare with ({formula.verdict})"
        return tally
    if formula.verdict == "fails" and printed_point(formula.counter_example):
        at_printed_point(formula, sampler, tally)
        return tally
    for point in sampler.points(count):
        try_point(formula, sampler, point, tally)
        if tally.contradiction or tally.false and formula.verdict == "fails":
            break
    conclude(formula, tally)
    return tally


def try_point(formula, sampler, point, tally):
    tally.tried += 1
    try:
        found = there_is(formula, sampler, point) if formula.there_is else truth(point, formula.statement, sampler.conditions, sampler.random)
    except NoValue as error:
        tally.contradiction = f"it has no value at {words(point)}: {error}" * (formula.verdict == "holds")
        return
    tally.true += found is True
    tally.false += found is False
    if found is False and not tally.place:
        tally.place = words(point)


def conclude(formula, tally):
    """What the truth at the points says of a verdict without a printed point."""
    exists = isinstance(formula.statement, Behaviour) and formula.statement.kind == "depends"
    if formula.verdict == "holds":
        if exists and tally.decided and not tally.true:
            tally.contradiction = f"the variable changes nothing at {tally.false} points"
        if not exists and tally.false:
            tally.contradiction = f"it is false at {tally.place}"
    elif exists and tally.true:
        tally.contradiction = "the variable changes the side"
    elif not tally.false:
        tally.remark = "no point refutes it"


def there_is(formula, sampler, point):
    """Whether the witness does, or else one of many candidates.

    No success decides nothing where several variables are to be found. Of one variable, the candidates lie on and beside all edges.
    """
    found = []
    for values in candidates(formula, sampler, point):
        place = point.moved(values)
        try:
            allowed = [name for name in formula.there_is if name not in sampler.names.positive or place.get(name) > 0]
            met = len(allowed) == len(formula.there_is) and meets(place, sampler.conditions)
            found.append(met and truth(place, formula.statement, sampler.conditions, sampler.random))
        except (Unclear, Inexact, NoValue):
            continue
        if found[-1] and is_certain(formula, sampler, place):
            return True
        found[-1] = None if found[-1] else found[-1]
    return None if None in found or len(formula.there_is) > 1 else False


def is_certain(formula, sampler, place):
    """Whether a formula that digits make true is true without them."""
    if "=" not in formula.text.replace("!=", ""):
        return True
    try:
        with exact_only():
            return truth(place, formula.statement, sampler.conditions, sampler.random) is True
    except (Unclear, Inexact, NoValue):
        return False


def candidates(formula, sampler, point):
    """The witness, then values on and beside the edges, then random ones."""
    if formula.witness:
        yield {name: lambda tree=tree: point.value(tree) for name, tree in formula.witness.items()}
    for index in range(CANDIDATES):
        values = {name: sampler.value(name, index % 4) for name in formula.there_is}
        drawn = Point(sampler.names, point.values | values)
        edge = sampler.on_edge(drawn, index // 2, formula.there_is) if index % 2 else None
        yield {name: (edge or drawn).values[name] for name in formula.there_is}


def at_printed_point(formula, sampler, tally):
    """The printed counter-example must meet the conditions, and the formula must be false there."""
    values, said = printed_point(formula.counter_example)
    known = sampler.values(0) | {name: value for name, value in values.items() if name in sampler.variables}
    point = Point(sampler.names, known)
    tally.tried = 1
    solved = [name for name in values if name in sampler.solved]
    with exactly():
        try:
            wrong = [name for name in solved if point.get(name) != values[name]]
        except Inexact:
            wrong = []
    if wrong:
        tally.contradiction = f"the printed point has another {wrong[0]} than the conditions: {formula.counter_example}"
        return
    met = meets(point, sampler.wanted())
    found = refuted(formula, sampler, point, said)
    if met is False:
        tally.contradiction = f"the printed point does not meet the conditions: {formula.counter_example}"
    elif found is True:
        tally.contradiction = f"it is true at the printed point: {formula.counter_example}"
    tally.true, tally.false = int(found is True), int(found is False)


def refuted(formula, sampler, point, said):
    """The truth of the formula at a printed point, whose words may name a second point."""
    statement = formula.statement
    try:
        if formula.there_is:
            return there_is(formula, sampler, point)
        if not isinstance(statement, Behaviour):
            return formula_truth(point, statement)
        if statement.kind == "does not depend" and (other := OTHER.search(said)):
            moved = point.moved({other.group(1): Fraction(other.group(2))})
            change = changes(point, moved, statement.side)
            return None if change is None or not meets(moved, sampler.conditions) else change == 0
        if statement.kind in ("rises", "falls"):
            at = point.values[statement.variable]
            moved = point.moved({statement.variable: at + (abs(at) or 1) * Fraction(1, 10**9)})
            change = changes(point, moved, statement.side)
            return None if change is None else change == (1 if statement.kind == "rises" else -1)
        return truth(point, statement, sampler.conditions, sampler.random)
    except NoValue as error:
        raise Unreadable(f"{formula.id}: no value at the printed point {formula.counter_example}: {error}") from error
