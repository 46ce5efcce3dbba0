"""The claims of a report with the verdicts that its ledger records."""

import json
import re
import tomllib
from dataclasses import dataclass
from fractions import Fraction
from math import factorial
from pathlib import Path

from arithmetic import coefficients, exactly
from language import Behaviour, Comparison, Unreadable, atoms, comparison, expression, statement, values_at_zero
from names import Names, Point


# The keys of what decides a part that is no formula.
NO_FORMULA = ("proofs", "premises", "check")


@dataclass
class Formula:
    """One formula with its scope, and what the ledger says of it."""

    id: str
    text: str
    statement: object
    given: list
    there_is: list
    witness: dict
    box: dict
    at: dict
    moves: object
    verdict: str
    counter_example: str = ""


@dataclass
class Report:
    """What is compared: the names, the formulas with verdicts, and how many claims are not of this kind."""

    names: Names
    formulas: list
    skipped: dict


def read_toml(path):
    try:
        return tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise Unreadable(f"{path}: {error}") from error


def read_ledger(path):
    """The ledger's entries by the id of their claim."""
    try:
        entries = json.loads(Path(path).read_text(encoding="utf-8"))["claims"]
        return {entry["id"]: entry for entry in entries}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Unreadable(f"{path}: {error}") from error


def library():
    """The formulas that decide a claim which a report lists by its id alone."""
    path = Path(__file__).resolve().parents[2] / "reports/im-avouac/claims.toml"
    return {claim["id"]: claim for claim in read_toml(path)["claim"]} if path.exists() else {}


def is_stated(claim):
    return any(key in claim for key in ("formula", "rows", "motion", "part", "reading", *NO_FORMULA))


def read_report(claims_path, equations_path, ledger_path=None, content=None):
    """Reads all files of a report; other equations may stand in the place of the file's."""
    try:
        names = Names(content or read_toml(equations_path))
    except (KeyError, ValueError, TypeError, Unreadable) as error:
        raise Unreadable(f"{equations_path}: {error}") from error
    ledger = read_ledger(ledger_path) if ledger_path else {}
    known, report = library(), Report(names, [], {"rows": 0, "motion": 0, "proofs, premises and procedures": 0, "out of reach": 0})
    for claim in read_toml(claims_path).get("claim", ()):
        if not is_stated(claim) and "reason" not in claim:
            claim = known.get(claim["id"], {}) | {"expected": claim.get("expected"), "id": claim["id"]}
        try:
            add_claim(report, claim, ledger.get(claim["id"], {}))
        except (KeyError, ValueError, TypeError, Unreadable) as error:
            raise Unreadable(f"{claims_path}: claim {claim.get('id')}: {error}") from error
    report.formulas += [formula for system in names.systems.values() for formula in steady_formulas(names, system)]
    return report


def steady_formulas(names, system):
    """That the rates of a system are zero at its steady state, which every claim on its linearisation presupposes."""
    values = tuple(("value", name, tree) for name, tree in zip(system["state"], system["steady"]))
    for name, rate in zip(system["state"], system["rates"] if values else ()):
        said = Comparison(("derived", "at", (rate, *values)), "=", ("number", Fraction(0)))
        given = [comparison(text) for text in names.conditions]
        yield Formula(f"system {system['name']}, rate of {name}", "", said, given, [], {}, {}, {}, None, "holds")


def add_claim(report, claim, entry):
    """Adds the formulas of a claim, each beside the ledger's verdict on its part."""
    if not is_stated(claim):
        report.skipped["out of reach"] += 1
        return
    if any(key in claim for key in NO_FORMULA):
        # The procedure that decides a whole claim may find parts of its own.
        report.skipped["proofs, premises and procedures"] += 1
        return
    readings = claim.get("reading") or [{"part": claim.get("part")}]
    whole = {"verdict": entry.get("verdict", claim.get("expected")), "counter_example": entry.get("counter_example")}
    holds = str(whole["verdict"]).startswith("holds")
    for which, reading in enumerate(readings, 1):
        parts = reading.get("part") or [claim]
        decided = [part for one in entry.get("readings", ())[which - 1 : which] for part in one["parts"]]
        if entry and decided and len(decided) != len(parts):
            raise Unreadable(f"the ledger has {len(decided)} parts, not {len(parts)}")
        for place, part in enumerate(parts, 1):
            label = "".join([f", reading {which}" if len(readings) > 1 else "", f", part {place}" if len(parts) > 1 else ""])
            known = decided[place - 1] if decided else whole if len(parts) == len(readings) == 1 or holds and which == 1 else {}
            add_part(report, claim["id"] + label, part, known)


def add_part(report, label, part, decided):
    for key in ("rows", "motion"):
        if key in part:
            report.skipped[key] += 1
            return
    if any(key in part for key in NO_FORMULA):
        report.skipped["proofs, premises and procedures"] += 1
        return
    verdict = decided.get("verdict")
    inside = "holds" if verdict == "holds-within" else verdict
    report.formulas.append(read_formula(report.names, label, part, inside, decided.get("counter_example") or ""))
    if "outside" in part:
        # What is true outside the limit is decided together with it.
        outside = inside if inside == "holds" else None
        report.formulas.append(read_formula(report.names, f"{label}, outside", part["outside"], outside, ""))


def read_formula(names, label, part, verdict, counter_example):
    conditions = [comparison(text) for text in [*names.conditions, *part.get("given", ())]]
    numbers = lambda given: Fraction(str(given))
    return Formula(
        id=label,
        text=part["formula"],
        statement=statement(part["formula"]),
        given=conditions,
        there_is=list(part.get("there_is", ())),
        witness={name: expression(str(text)) for name, text in part.get("witness", {}).items()},
        box={name: tuple(map(numbers, ends)) for name, ends in part.get("box", {}).items()},
        at={name: numbers(value) for name, value in part.get("at", {}).items()},
        moves=part.get("moves"),
        verdict=verdict,
        counter_example=counter_example,
    )


PLACE = re.compile(r"(?:^|: )at ((?:(?:[A-Za-z][\w']*(?:\(0\))? = -?[\d/]+|[A-Za-z]\w*\([a-z]\) = [-+*/^\d a-z]+)(?:, )?)+): (.*)", re.S)
OTHER = re.compile(r"with ([A-Za-z][\w']*) = (-?[\d/]+)")


def printed_point(text):
    """The point of a counter-example, and the words behind it; None without a point."""
    match = PLACE.search(text)
    if not match:
        return None
    values = {}
    for name, value in (pair.split(" = ") for pair in match.group(1).rstrip(", ").split(", ")):
        is_function = name.endswith(")") and not name.endswith("(0)")
        values |= printed_function(name, value) if is_function else {name: Fraction(value)}
    return values, match.group(2)


def printed_function(name, text):
    """The values at 0 of a printed polynomial such as `f(x) = 3 - x` and of its derivatives."""
    function, letter = name.rstrip(")").split("(")
    tree, names = expression(text), values_at_zero(function)
    with exactly():
        found = coefficients(lambda value: tree_value(tree, letter, value), len(names) - 1)
    if len(found) > len(names):
        raise Unreadable(f"'{name} = {text}' has too many terms")
    return {key: factorial(order) * (found[order] if order < len(found) else Fraction(0)) for order, key in enumerate(names)}


def tree_value(tree, letter, value):
    """The value of a printed polynomial in one letter."""
    return Point(None, {letter: value}).value(tree)


def sides(formula):
    """All trees of a formula, each with the name that is bound in it."""
    said = formula.statement
    found = [(tree, None) for one in formula.given for tree in (one.left, one.right)]
    found += [(tree, None) for tree in formula.witness.values()]
    if isinstance(said, Behaviour):
        return found + [(tree, None) for tree in (said.side, said.value) if tree]
    for atom in atoms(said):
        if isinstance(atom, Comparison):
            found += [(atom.left, None), (atom.right, None)]
        else:
            found.append((atom.polynomial, atom.variable))
            found += [(tree, None) for tree in (getattr(atom, "critical", None), getattr(atom, "frequency", None)) if tree]
    return found
