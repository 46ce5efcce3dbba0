"""The slider, a, b, D_c, K and M, and the operating point, σ and V0."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from slipmode import _slipmode
from slipmode import _curves as curves
from slipmode import _questions as questions
from slipmode._classified import BoundaryTable, Classification, Classifications, Map, Possibilities
from slipmode._exact import Number, exact, fault, given
from slipmode._frames import array_of
from slipmode._questions import Distance, Root, Solution
from slipmode._rows import NAMES, Arrays, Rows, Value
from slipmode._run import in_python, remark
from slipmode._simulated import Simulation, Simulations
from slipmode._table import Table, html_table

S = TypeVar("S", bound="Frozen")


class Frozen:
    """Named numbers that do not change; equal if all their exact values are."""

    __slots__ = ("_exact", "_values")
    _names: tuple[str, ...]
    _values: dict[str, Any]
    _exact: tuple[str, ...]

    def _set(self, values: dict[str, Number]) -> None:
        kept = {name: given(value, name) for name, value in values.items()}
        texts = [exact(value, name) for name, value in kept.items()]
        found = _slipmode.exact_values(list(kept), texts, NAMES.index(self._names[0]))
        object.__setattr__(self, "_values", kept)
        object.__setattr__(self, "_exact", tuple(found))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{name}: a {type(self).__name__} does not change; `replace({name}=...)` makes another one")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{name}: a {type(self).__name__} does not change")

    @property
    def is_uncertain(self) -> bool:
        """Whether a value has an error bar."""
        return any(text.startswith("[") for text in self._exact)

    def replace(self: S, **changes: Number) -> S:
        """Return the same with other values."""
        return type(self)(**{**self._values, **changes})

    def __iter__(self) -> Iterator[Any]:
        return iter(self._values.values())

    def __eq__(self, other: object) -> bool:
        return self._exact == other._exact if isinstance(other, Frozen) and type(other) is type(self) else NotImplemented

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._exact))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_make, (type(self), self._values))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._values.items())})"

    def _repr_html_(self) -> str:
        return html_table(["quantity", "value"], [[name, str(value)] for name, value in self._values.items()])


def _make(kind: type[S], values: dict[str, str | float]) -> S:
    return kind(**values)


class OperatingPoint(Frozen):
    """The normal stress ``sigma`` (σ, Pa) and the loading velocity ``v`` (V0, m/s), numbers as those of :class:`Slider`."""

    __slots__ = ()
    _names = NAMES[5:]

    def __init__(self, *, sigma: Number, v: Number) -> None:
        self._set({"sigma": sigma, "v": v})

    @property
    def sigma(self) -> str | float:
        """σ as it was given: a float, or a text with exactly the value."""
        found: str | float = self._values["sigma"]
        return found

    @property
    def v(self) -> str | float:
        """V0 as it was given."""
        found: str | float = self._values["v"]
        return found


class Slider(Frozen):
    """A spring-slider with rate-and-state friction.

    ``a`` and ``b`` are the direct and the evolution effect of eq 1, ``d_c`` the critical slip distance D_c in m, ``k`` the
    stiffness K in Pa/m, and ``m`` the mass per area of contact M in kg/m².

    Texts, ``Decimal``, ``Fraction`` and whole numbers are exact: ``"0.004"`` is 1/250. A float is the exact binary number that it
    is: ``0.004`` is not 1/250 but differs from it by less than 1e-18. Texts may have a unit (``"8um"``, ``"2MPa/mm"``) and an error
    bar (``"0.009±0.001"``, ``"[0.008, 0.010]"``); ``(0.009, 0.001)`` is a value with its error. Numbers of ``uncertainties`` and
    quantities of ``pint`` are taken with their error and their unit.

    A slider does not change. Sliders with the same exact values are equal.
    """

    __slots__ = ()
    _names = NAMES[:5]

    def __init__(self, *, a: Number, b: Number, d_c: Number, k: Number, m: Number) -> None:
        self._set({"a": a, "b": b, "d_c": d_c, "k": k, "m": m})

    @property
    def a(self) -> str | float:
        """The direct effect as it was given: a float, or a text with exactly the value."""
        found: str | float = self._values["a"]
        return found

    @property
    def b(self) -> str | float:
        """The evolution effect as it was given."""
        found: str | float = self._values["b"]
        return found

    @property
    def d_c(self) -> str | float:
        """D_c as it was given."""
        found: str | float = self._values["d_c"]
        return found

    @property
    def k(self) -> str | float:
        """K as it was given."""
        found: str | float = self._values["k"]
        return found

    @property
    def m(self) -> str | float:
        """M as it was given."""
        found: str | float = self._values["m"]
        return found

    @overload
    def classify(self, sigma: OperatingPoint, v: None = None, *, inertial_threshold: Number | None = None) -> Classification | Possibilities: ...
    @overload
    def classify(self, sigma: Number, v: Number, *, inertial_threshold: Number | None = None) -> Classification | Possibilities: ...
    @overload
    def classify(self, sigma: Arrays, v: Value, *, inertial_threshold: Number | None = None) -> Classifications: ...
    @overload
    def classify(self, sigma: Number, v: Arrays, *, inertial_threshold: Number | None = None) -> Classifications: ...
    def classify(self, sigma: Any, v: Any = None, *, inertial_threshold: Number | None = None) -> Any:
        """Decide stability and slip mode at ``sigma`` (Pa) and ``v`` (m/s), or at an :class:`OperatingPoint`.

        Two numbers give a :class:`Classification`, or :class:`Possibilities` if a value has an error bar; arrays and columns give
        what :func:`slipmode.classify` gives. The values are bit for bit those of ``slipmode classify --points``.
        """
        return questions.classify(**self._at(sigma, v), inertial_threshold=inertial_threshold)

    def _at(self, sigma: Any, v: Any) -> dict[str, Any]:
        if isinstance(sigma, OperatingPoint):
            sigma, v = sigma
        return {**self._values, "sigma": sigma, "v": v}

    def map(
        self,
        sigma: tuple[Number, Number, int] = ("10kPa", "100MPa", 200),
        v: tuple[Number, Number, int] = ("0.1um/s", "10cm/s", 200),
        *,
        inertial_threshold: Number | None = None,
    ) -> Map:
        """Classify a grid with equal logarithmic steps, each axis given as (from, to, number of coordinates), and draw it."""
        axes = []
        for name, axis in (("v", v), ("sigma", sigma)):
            if not isinstance(axis, (tuple, list)) or len(axis) != 3:
                raise fault(name, repr(axis), "not allowed (allowed: from, to, and the number of coordinates)")
            axes.append(f"{exact(axis[0], name)}:{exact(axis[1], name)}:{axis[2]}")
        threshold = None if inertial_threshold is None else exact(inertial_threshold, "inertial_threshold")
        texts = [exact(value) for value in self]
        code, messages, grid = _slipmode.draw_grid(texts, axes, threshold)
        remark(code, in_python(messages))
        assert grid is not None  # A command without a result has raised.
        velocity, stress = np.meshgrid(*(np.frombuffer(axis, "<f8").astype(np.float64) for axis in grid[:2]))
        found = questions.classify_rows(Rows.of(None, self._at(stress, velocity)), threshold)
        fields = {each.name: getattr(found, each.name) for each in dataclasses.fields(found)}
        return Map(**fields, svg=grid[2])

    @overload
    def roots(self, sigma: OperatingPoint, v: None = None, *, digits: int = 50) -> list[Root]: ...
    @overload
    def roots(self, sigma: Number, v: Number, digits: int = 50) -> list[Root]: ...
    @overload
    def roots(self, sigma: Arrays, v: Value) -> NDArray[np.complex128]: ...
    @overload
    def roots(self, sigma: Number, v: Arrays) -> NDArray[np.complex128]: ...
    def roots(self, sigma: Any, v: Any = None, digits: int = 50) -> Any:
        """Compute the three roots s of eq 8, 1/s, as :func:`slipmode.roots`."""
        return questions.roots(**self._at(sigma, v), digits=digits)

    @overload
    def distance(self, sigma: OperatingPoint, v: None = None) -> Distance: ...
    @overload
    def distance(self, sigma: Number, v: Number) -> Distance: ...
    @overload
    def distance(self, sigma: Arrays, v: Value) -> Table: ...
    @overload
    def distance(self, sigma: Number, v: Arrays) -> Table: ...
    def distance(self, sigma: Any, v: Any = None) -> Any:
        """Compute the distances to the transition and to the boundary, as :func:`slipmode.distance`."""
        return questions.distance(**self._at(sigma, v))

    def boundary(
        self, n: int = 200, digits: int | None = None, frequency_ratio: Number | None = None
    ) -> BoundaryTable:
        """Compute the exact boundary max Im(s) = 0, or the line of an ω/ω_n, as :func:`slipmode.boundary`."""
        found: BoundaryTable = curves.boundary(**self._values, n=n, digits=digits, frequency_ratio=frequency_ratio)
        return found

    def transition(self, v: float | Arrays | None = None) -> Table:
        """Compute the transition K = K_c: the normal stress at each loading velocity, where there is one.

        Without ``v``, at 200 velocities with equal logarithmic steps over those of the boundary.
        """
        if v is None:
            velocity = self.boundary(n=2)["loading_velocity_m_per_s"].astype(np.float64)
            v = np.geomspace(velocity.min(), velocity.max(), 200)
        velocities = array_of(np.atleast_1d(v), "v").ravel()
        # With its unit, no velocity of the curve looks like another unit's.
        texts = np.array([f"{exact(each)}m/s" for each in velocities.tolist()], dtype=object)
        found = questions.solve("sigma", **self._values, v=texts, transition=True)
        known = found["solutions"] > 0
        return Table({"loading_velocity_m_per_s": velocities[known], "normal_stress_pa": found["solution_1"][known]})

    def tolerance(self, *errors: Number) -> Table:
        """Compute where each formula of the paper may be used, for these relative errors; 0.1, 0.01 and 0.001 without any."""
        found: Table = curves.tolerance(**self._values, errors=errors)
        return found

    def solve(
        self,
        unknown: str,
        *,
        sigma: Value | None = None,
        v: Value | None = None,
        frequency: Number | None = None,
        angular_frequency: Number | None = None,
        growth_rate: Number | None = None,
        frequency_ratio: Number | None = None,
        transition: bool = False,
        boundary: bool = False,
        digits: int = 17,
    ) -> list[Solution] | Any:
        """Solve for ``unknown``, as :func:`slipmode.solve`; the slider's own value of it is not used."""
        return questions.solve(
            unknown,
            **self._values,
            sigma=sigma,
            v=v,
            frequency=frequency,
            angular_frequency=angular_frequency,
            growth_rate=growth_rate,
            frequency_ratio=frequency_ratio,
            transition=transition,
            boundary=boundary,
            digits=digits,
        )

    @overload
    def simulate(
        self, sigma: OperatingPoint, v: None = None, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulation: ...
    @overload
    def simulate(
        self, sigma: Number, v: Number, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulation: ...
    @overload
    def simulate(
        self, sigma: Arrays, v: Value, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulations: ...
    @overload
    def simulate(
        self, sigma: Number, v: Arrays, *, law: str, rtol: Number = "1e-8", start: str = "steady-at-velocity"
    ) -> Simulations: ...
    def simulate(
        self,
        sigma: Any,
        v: Any = None,
        *,
        law: str,
        rtol: Number = "1e-8",
        start: str = "steady-at-velocity",
    ) -> Any:
        """Simulate the nonlinear slider, as :func:`slipmode.simulate`."""
        return questions.simulate(**self._at(sigma, v), law=law, rtol=rtol, start=start)
