"""Wrong verdicts and wrong equations planted on purpose: how many of them does the comparison notice?"""

import copy
import re
from dataclasses import replace
from fractions import Fraction
from functools import partial
from random import Random

from claims import read_report, read_toml, sides
from decide import compare
from language import DERIVATIONS, Behaviour, Unreadable, called
from points import Sampler, words

TERM = re.compile(r" [+-] ")


def self_test(files, count, seed, pool):
    """Prints what was planted and what was noticed. It exits with 1 when a wrong verdict was not noticed."""
    missed = 0
    for claims, equations, ledger in files:
        name, report = claims.parent.name, read_report(claims, equations, ledger)
        formulas = [one for one in report.formulas if one.verdict in ("holds", "fails")]
        noticed = pool.map(partial(flip_is_noticed, report.names, count, seed), formulas, 1)
        missed += noticed.count(False)
        print_share(name, "verdicts", [one.id for one in formulas], noticed)
        altered = list(alterations(read_toml(equations)))
        noticed = pool.map(partial(alteration_is_noticed, claims, equations, ledger, count, seed), [other for _, other in altered], 1)
        print_share(name, "signs", [what for what, _ in altered], noticed)
    return 1 if missed else 0


def print_share(name, what, planted, noticed):
    unseen = [one for one, seen in zip(planted, noticed) if not seen]
    words = f", but not {'; '.join(unseen)}" if unseen else ""
    print(f"{name}: {len(planted) - len(unseen)} of {len(planted)} wrong {what} noticed{words}", flush=True)


def flip_is_noticed(names, count, seed, formula):
    return bool(compare(flipped(formula, names, seed), names, count, seed).contradiction)


def flipped(formula, names, seed):
    """The formula with the other verdict, and for `fails` a point at which it is not false."""
    if formula.verdict == "fails":
        return replace(formula, verdict="holds", counter_example="")
    sampler = Sampler(formula, names, Random(seed))
    point = next(sampler.points(1))
    said = formula.statement
    moved = isinstance(said, Behaviour) and f"1, and 2 with {said.variable} = {Fraction(5, 7)}"
    place = words(point)
    return replace(formula, verdict="fails", counter_example=f"at {place}: {moved or 'planted'}" if place else "there is none")


def alterations(content):
    """The content of `equations.toml` with another sign in front of one term, or of the whole side where there is one term only."""
    places = [("equation", "equation", "number"), ("definition", "is", "name")]
    for section, key, label in places:
        for index, entry in enumerate(content.get(section, ())):
            for text in with_other_sign(entry[key], section == "equation"):
                yield f"{section} {entry[label]}: {text}", with_entry(content, section, index, key, text)
    for index, system in enumerate(content.get("system", ())):
        for key in ("rates", "steady"):
            for place, text in enumerate(system.get(key, ())):
                for other in with_other_sign(text, False):
                    changed = [*system[key][:place], other, *system[key][place + 1 :]]
                    yield f"system {system['name']}: {other}", with_entry(content, "system", index, key, changed)


def with_other_sign(text, is_equation):
    found = [text[: match.start()] + (" - " if "+" in match.group() else " + ") + text[match.end() :] for match in TERM.finditer(text)]
    if found:
        return found
    left, mark, right = text.partition("=") if is_equation else ("", "", text)
    return [f"{left}{mark} -({right.strip()})"] if right.strip() != "0" and not called(text, DERIVATIONS) else []


def with_entry(content, section, index, key, value):
    other = copy.deepcopy(content)
    other[section][index][key] = value
    return other


def alteration_is_noticed(claims, equations, ledger, count, seed, content):
    """Whether a formula that reaches what was altered contradicts its verdict."""
    try:
        before, report = read_report(claims, equations, ledger), read_report(claims, equations, ledger, content)
        old, new = before.names, report.names
        touched = {name for name, tree in new.definitions.items() if old.definitions.get(name) != tree}
        touched |= {name for name, system in new.systems.items() if old.systems[name] != system}
        reaching = [one for one in report.formulas if one not in before.formulas or touched & set().union(*(new.reach_of(tree) for tree, _ in sides(one)))]
        return any(compare(one, new, count, seed).contradiction for one in reaching)
    except Unreadable:
        return True
