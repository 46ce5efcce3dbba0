"""Numbers with exactly their value, with units and errors."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
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


def given(value: Number, name: str) -> str | float:
    """Return a float as it is, and any other number as a text that has exactly its value; messages have the name."""
    kind = type(value)
    if kind is float or kind is str:
        return value  # type: ignore[return-value]
    return float(value) if isinstance(value, float) else exact(value, name)


def exact(value: Number, name: str = "") -> str:
    """Return a text that has exactly the value of a number; a text stays as it is. Messages have the name."""
    if isinstance(value, str):
        return value
    if isinstance(value, Rational) and not isinstance(value, bool):
        numerator, denominator = int(value.numerator), int(value.denominator)
        return str(numerator) if denominator == 1 or numerator < 0 else f"{numerator}/{denominator}"
    if isinstance(value, Decimal):
        return finite(value, name)
    if isinstance(value, Real) and not isinstance(value, bool):
        near = float(value)
        if near == value or not math.isfinite(near):
            return finite(Decimal(near), name)
        if hasattr(value, "as_integer_ratio"):
            return exact(Fraction(*value.as_integer_ratio()), name)
    if isinstance(value, tuple):
        return with_error(value, name)
    if is_of("pint", value, "magnitude"):
        return f"{exact(value.magnitude, name)} {unit(value)}".rstrip()  # type: ignore[union-attr]
    if is_of("uncertainties", value, "nominal_value"):
        return with_error((value.nominal_value, value.std_dev), name)  # type: ignore[union-attr]
    raise fault(name, repr(value), "no number (write a text, Decimal, Fraction, int or float; a range is a text, '[1.2, 5]')")


def flag(value: object, name: str) -> bool:
    """Return a truth value."""
    if type(value).__name__ not in ("bool", "bool_"):
        raise fault(name, repr(value), "not allowed (allowed: True, False)")
    return bool(value)


def fault(name: str, value: object, problem: str) -> InputError:
    """Return the error of an argument."""
    return InputError(f"{name} = {value}: {problem}" if name else f"{value}: {problem}")


def finite(decimal: Decimal, name: str) -> str:
    """Return the digits of a number."""
    if not decimal.is_finite():
        raise fault(name, decimal, "out of range (allowed: finite numbers)")
    return str(decimal)


def with_error(pair: tuple[Any, ...], name: str) -> str:
    """Return a value with its error."""
    if len(pair) != 2:
        raise fault(name, repr(pair), "a tuple is a value and its error (an array is a list or an array of NumPy)")
    value, error = pair
    return f"{exact(value, name)}±{exact(error, name)}"


def is_of(package: str, value: object, attribute: str) -> bool:
    """Return whether a value is of a package, which is not imported."""
    return hasattr(value, attribute) and any(base.__module__.partition(".")[0] == package for base in type(value).__mro__)


def unit(quantity: Any) -> str:
    """Return the unit of a quantity of pint as the command line writes it."""
    return format(quantity.units, "~C").replace("**", "^")
