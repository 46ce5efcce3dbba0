"""The language of claims, read by a parser of its own: expressions, formulas, derivations (docs/claims-forms.md, docs/claims-derivations.md)."""

import re
from dataclasses import dataclass
from fractions import Fraction


class Unreadable(Exception):
    """A text that is not of the language, or a file that does not fit together."""


FUNCTIONS = ("ln", "sqrt", "abs", "exp", "asinh", "sin", "cos")
declared = set()  # The names of the functions that `equations.toml` declares; primes at them are derivatives.
COEFFICIENTS = 14  # A declared function is a polynomial by so many values at 0: of itself and of its derivatives.
DERIVATIONS = {  # What each argument is: a system, an expression, a name, a word that stays as it is, or values.
    "characteristic": "sn", "linearised": "snn", "rate": "es", "coefficient": "enw", "discriminant": "en", "hurwitz": "enw",
    "eliminate": "een", "solve": "en", "derivative": "en", "limit": "enw", "series": "enw", "exchange": "enn", "at": "ev",
}
ROOTS = ("stable", "unstable", "all_real")
TOKEN = re.compile(r"\s*(?:(\d+\.?\d*|\.\d+)|([A-Za-z][A-Za-z0-9_]*'*)|(.))", re.S)
PIECE = re.compile(r"(?<![\w'])(?:not|and|or|implies|iff)(?![\w'])|[\[\]]")
COMPARISON = re.compile(r"<=|>=|!=|=|<|>")


class Reader:
    """Recursive descent over the tokens of an expression: trees are tuples such as ("add", left, right)."""

    def __init__(self, text):
        self.text = text
        self.tokens = [match.groups() for match in TOKEN.finditer(text.strip())]

    def fail(self, message):
        raise Unreadable(f"'{self.text.strip()}': {message}")

    def next_is(self, *marks):
        return bool(self.tokens) and self.tokens[0][2] in marks

    def take(self):
        return self.tokens.pop(0)[2]

    def whole(self):
        tree = self.sum()
        if self.tokens:
            self.fail(f"unexpected '{''.join(part or '' for part in self.tokens[0])}'")
        return tree

    def sum(self):
        tree = self.product()
        while self.next_is("+", "-"):
            tree = ("add" if self.take() == "+" else "sub", tree, self.product())
        return tree

    def product(self):
        tree = self.signed()
        while self.next_is("*", "/"):
            tree = ("mul" if self.take() == "*" else "div", tree, self.signed())
        return tree

    def signed(self):
        if self.next_is("-", "+", "±"):
            mark = self.take()
            inner = self.signed()
            return {"-": ("neg", inner), "+": inner, "±": ("mul", ("name", "pm"), inner)}[mark]
        return self.power()

    def power(self):
        base = self.atom()
        if not self.next_is("^"):
            return base
        self.take()
        sign = -1 if self.next_is("-") else 1
        if sign < 0:
            self.take()
        if not (self.tokens and self.tokens[0][0] and self.tokens[0][0].isdigit()):
            self.fail("expected a whole exponent")
        return ("power", base, sign * int(self.tokens.pop(0)[0]))

    def atom(self):
        if not self.tokens:
            self.fail("unexpected end")
        number, name, _ = self.tokens[0]
        if number:
            self.tokens.pop(0)
            return ("number", Fraction(number))
        if name:
            self.tokens.pop(0)
            if not self.next_is("("):
                return ("name", name)
            if name.rstrip("'") in declared:
                return ("function", name, self.bracketed())
            if name not in FUNCTIONS:
                self.fail(f"'{name}' is not a function")
            return ("call", name, self.bracketed())
        return self.bracketed()

    def bracketed(self):
        if not self.next_is("("):
            self.fail("expected a number, a name or '('")
        self.take()
        tree = self.sum()
        if not self.next_is(")"):
            self.fail("expected ')'")
        self.take()
        return tree


def expression(text):
    """The tree of an expression."""
    return Reader(text).whole()


def arguments(text):
    """The texts between the commas outside brackets."""
    parts, depth = [""], 0
    for character in text:
        depth += (character == "(") - (character == ")")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def called(text, words):
    """The word and the arguments of a text that is one call of one of these words, or None."""
    word, _, rest = text.strip().partition("(")
    if word.strip() not in words or not rest.endswith(")"):
        return None
    return word.strip(), arguments(rest[:-1])


def definition(text):
    """The tree of a definition: an expression, or a derivation as ("derived", word, arguments)."""
    call = called(text, DERIVATIONS)
    if call is None:
        return expression(text)
    word, given = call
    kinds = DERIVATIONS[word]
    if len(given) != len(kinds) and not (kinds[-1] == "v" and len(given) > 1):
        raise Unreadable(f"'{text}': {word} has {len(kinds)} arguments")
    found = []
    for kind, argument in zip(kinds.ljust(len(given), "v"), given):
        if kind == "e":
            found.append(expression(argument))
        elif kind == "v":
            name, _, value = argument.partition("=")
            found.append(("value", name.strip(), expression(value)))
        else:
            found.append(argument)
    return ("derived", word, tuple(found))


def values_at_zero(function):
    """The names of the values at 0 of a declared function and of its derivatives."""
    first = function.count("'")
    return [f"{function.rstrip(chr(39))}{chr(39) * order}(0)" for order in range(first, COEFFICIENTS)]


def names_in(tree):
    """The names that occur in a tree: variables, definitions, systems, and the values at 0 of functions."""
    word = tree[0]
    if word == "name":
        return {tree[1]}
    if word == "function":
        return names_in(tree[2]).union(values_at_zero(tree[1]))
    if word == "number":
        return set()
    if word == "value":
        return {tree[1]} | names_in(tree[2])
    parts = tree[2] if word == "derived" else tree[1:]
    names = {part for part in parts if isinstance(part, str) and word == "derived"}
    return names.union(*(names_in(part) for part in parts if isinstance(part, tuple)))


@dataclass(frozen=True)
class Comparison:
    left: tuple
    mark: str
    right: tuple


@dataclass(frozen=True)
class Roots:
    kind: str
    polynomial: tuple
    variable: str


@dataclass(frozen=True)
class Crossing:
    polynomial: tuple
    variable: str
    parameter: str
    critical: tuple
    frequency: tuple


@dataclass(frozen=True)
class Joined:
    """`not`, `and`, `or`, `implies` or `iff` of formulas."""

    word: str
    parts: tuple


@dataclass(frozen=True)
class Behaviour:
    """A limit, a rise, a fall or a dependence, as the variable moves."""

    kind: str
    side: tuple
    variable: str
    value: tuple = None
    toward: str = None
    beyond: int = 0  # Of a limit beyond all bounds: its sign.


def comparison(text):
    """Two sides with one comparison between them."""
    marks = COMPARISON.findall(text)
    if len(marks) != 1:
        raise Unreadable(f"'{text}' is not one comparison")
    left, right = text.split(marks[0])
    return Comparison(expression(left), marks[0], expression(right))


def atom(text):
    """A comparison or a predicate."""
    call = called(text, (*ROOTS, "pair_crosses"))
    if call is None:
        return comparison(text)
    word, given = call
    if word in ROOTS and len(given) == 2:
        return Roots(word, expression(given[0]), given[1])
    if word == "pair_crosses" and len(given) == 5:
        return Crossing(expression(given[0]), given[1], given[2], expression(given[3]), expression(given[4]))
    raise Unreadable(f"'{text}': {word} has another number of arguments")


class FormulaReader:
    """Binds in the order not, and, or, implies, iff; brackets group."""

    def __init__(self, text):
        self.text, self.pieces, start = text, [], 0
        for match in PIECE.finditer(text):
            self.pieces += [text[start : match.start()].strip(), match.group()]
            start = match.end()
        self.pieces = [piece for piece in [*self.pieces, text[start:].strip()] if piece]

    def whole(self):
        formula = self.level(0)
        if self.pieces:
            raise Unreadable(f"'{self.text}': unexpected '{self.pieces[0]}'")
        return formula

    def level(self, depth):
        words = ("iff", "implies", "or", "and")
        if depth == len(words):
            return self.negated()
        parts = [self.level(depth + 1)]
        while self.pieces and self.pieces[0] == words[depth] and not (depth < 2 and len(parts) == 2):
            self.pieces.pop(0)
            parts.append(self.level(depth + 1))
        return parts[0] if len(parts) == 1 else Joined(words[depth], tuple(parts))

    def negated(self):
        if not self.pieces:
            raise Unreadable(f"'{self.text}': unexpected end")
        piece = self.pieces.pop(0)
        if piece == "not":
            return Joined("not", (self.negated(),))
        if piece != "[":
            return atom(piece)
        formula = self.level(0)
        if not self.pieces or self.pieces.pop(0) != "]":
            raise Unreadable(f"'{self.text}': expected ']'")
        return formula


LIMIT = re.compile(r"(.*?)->(.*) as (.*)->\s*(0|infinity)\s*", re.S)
MOVES = re.compile(r"(.*?) (rises with|falls with|does not depend on|depends on) (.*)", re.S)


def statement(text):
    """The tree of a formula."""
    if match := LIMIT.fullmatch(text):
        side, value, variable, toward = match.groups()
        beyond = {"infinity": 1, "-infinity": -1}.get(value.strip(), 0)
        value = None if beyond else expression(value)
        return Behaviour("tends", expression(side), variable.strip(), value, toward, beyond)
    if match := MOVES.fullmatch(text):
        side, kind, variable = match.groups()
        return Behaviour(kind.split(" with")[0].removesuffix(" on"), expression(side), variable.strip())
    return FormulaReader(text).whole()


def atoms(formula):
    """The comparisons and predicates of a formula."""
    return [atom for part in formula.parts for atom in atoms(part)] if isinstance(formula, Joined) else [formula]
