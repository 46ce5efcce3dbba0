"""When does a slider with rate-and-state friction stick, creep, oscillate or vibrate?

Start from :class:`Slider`, or from :func:`fit` with a record of velocity steps. Numbers may be texts, ``Decimal``, ``Fraction``
(exact) or floats (the exact binary numbers that they are). All units are those of SI.
"""

from slipmode._classified import BoundaryTable, Categories, Classification, Classifications, Map, Possibilities
from slipmode._fit import Fit, FittedValue, LawComparison, Residuals, fit
from slipmode._reports import Comparison, Report, compare, report, verify
from slipmode._run import SlipmodeWarning
from slipmode._simulated import Failed, Observable, Simulation, Simulations, Trajectory
from slipmode._slider import Root, Slider, Solution
from slipmode._slipmode import VERSION as __version__
from slipmode._slipmode import CheckFailed, InputError
from slipmode._table import Table

__all__ = [
    "BoundaryTable",
    "Categories",
    "CheckFailed",
    "Classification",
    "Classifications",
    "Comparison",
    "Failed",
    "Fit",
    "FittedValue",
    "InputError",
    "LawComparison",
    "Map",
    "Observable",
    "Possibilities",
    "Report",
    "Residuals",
    "Root",
    "Simulation",
    "Simulations",
    "Slider",
    "SlipmodeWarning",
    "Solution",
    "Table",
    "Trajectory",
    "__version__",
    "compare",
    "fit",
    "report",
    "verify",
]
