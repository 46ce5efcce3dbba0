"""Numbers with exactly their value, with units and errors."""

from __future__ import annotations

import math
from decimal import Decimal
from numbers import Rational, Real
from typing import Any, Protocol, Union

from slipmode._errors import InputError


class WithError(Protocol):
    """A number of ``uncertainties``."""

    @property
    def nominal_value(self) -> float: ...
    @property
    def std_dev(self) -> float: ...


class WithUnit(Protocol):
    """A quantity of ``pint``."""

    @property
    def magnitude(self) -> Any: ...
    @property
    def units(self) -> Any: ...


#: A number: texts, ``Decimal``, ``Fraction`` and ``int`` are exact, floats are the exact binary numbers that they are. A tuple is a
#: value with its error. Numbers of ``uncertainties`` and quantities of ``pint`` have their error and their unit.
Number = Union[str, int, float, Decimal, Rational, Real, tuple[Any, Any], WithError, WithUnit]


def given(value: Number) -> str | float:
    """Return a float as it is, and any other number as a text that has exactly its value."""
    kind = type(value)
    if kind is float or kind is str:
        return value  # type: ignore[return-value]
    return float(value) if isinstance(value, float) else exact(value)


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
        return finite(value)
    if isinstance(value, Real):
        return finite(Decimal(float(value)))
    if isinstance(value, tuple):
        return with_error(value)
    if is_of("pint", value, "magnitude"):
        return f"{exact(value.magnitude)} {unit(value)}".rstrip()  # type: ignore[union-attr]
    if is_of("uncertainties", value, "nominal_value"):
        return with_error((value.nominal_value, value.std_dev))  # type: ignore[union-attr]
    raise TypeError(f"{value!r} is no number: write a text, Decimal, Fraction, int or float")


def finite(decimal: Decimal) -> str:
    """Return the digits of a number."""
    if not math.isfinite(decimal):
        raise InputError(f"{decimal}: out of range (allowed: finite numbers)")
    return str(decimal)


def with_error(pair: tuple[Any, ...]) -> str:
    """Return a value with its error."""
    if len(pair) != 2:
        raise InputError(f"{pair!r}: a tuple is a value and its error (an array is a list or an array of NumPy)")
    value, error = pair
    return f"{exact(value)}±{exact(error)}"


def is_of(package: str, value: object, attribute: str) -> bool:
    """Return whether a value is of a package, which is not imported."""
    return hasattr(value, attribute) and any(base.__module__.partition(".")[0] == package for base in type(value).__mro__)


def unit(quantity: Any) -> str:
    """Return the unit of a quantity of pint as the command line writes it."""
    return format(quantity.units, "~C").replace("**", "^")
