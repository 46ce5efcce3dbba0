"""Numbers as texts that have exactly their value."""

from __future__ import annotations

import math
from decimal import Decimal
from numbers import Rational, Real
from typing import Union

from slipmode._slipmode import InputError

#: A number: texts, ``Decimal`` and ``Fraction`` are exact, floats are the exact binary numbers that they are.
Number = Union[str, int, float, Decimal, Rational, Real]


def exact(value: Number) -> str:
    """Return a text that has exactly the value of a number; a text stays as it is."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        raise TypeError("a truth value is no number")
    if isinstance(value, Rational):
        numerator, denominator = int(value.numerator), int(value.denominator)
        return str(numerator) if denominator == 1 or numerator < 0 else f"{numerator}/{denominator}"
    if isinstance(value, Decimal):
        decimal = value
    elif isinstance(value, Real):
        decimal = Decimal(float(value))
    else:
        raise TypeError(f"{value!r} is no number: write a text, Decimal, Fraction, int or float")
    if not math.isfinite(decimal):
        raise InputError(f"{value}: out of range (allowed: finite numbers)")
    return str(decimal)
