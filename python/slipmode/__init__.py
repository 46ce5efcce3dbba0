"""When does a slider with rate-and-state friction stick, creep, oscillate or vibrate?

Start from :class:`Slider`, from :func:`classify` with columns of points, or from :func:`fit` with a record of velocity steps.
``str``, ``Decimal``, ``Fraction`` and ``int`` are exact; floats are the exact binary numbers that they are. All units are those of
SI.
"""

from slipmode._classified import BoundaryTable, Classification, Classifications, Map, Possibilities
from slipmode._curves import boundary, tolerance
from slipmode._errors import CheckFailed, InputError, SlipmodeError, SlipmodeWarning
from slipmode._fit import Fit, FittedValue, LawComparison, PeakFit, Residuals, fit, fit_peaks
from slipmode._frames import Categories
from slipmode._questions import (
    Distance,
    Root,
    Solution,
    classify,
    distance,
    roots,
    simulate,
    solve,
)
from slipmode._reports import Comparison, Report, compare, report, verify
from slipmode._simulated import Failed, Observable, Simulation, Simulations, Trajectory
from slipmode._slider import OperatingPoint, Slider
from slipmode._slipmode import VERSION as __version__
from slipmode._table import Table

__all__ = [
    "BoundaryTable",
    "Categories",
    "CheckFailed",
    "Classification",
    "Classifications",
    "Comparison",
    "Distance",
    "Failed",
    "Fit",
    "FittedValue",
    "InputError",
    "LawComparison",
    "Map",
    "Observable",
    "OperatingPoint",
    "PeakFit",
    "Possibilities",
    "Report",
    "Residuals",
    "Root",
    "Simulation",
    "Simulations",
    "Slider",
    "SlipmodeError",
    "SlipmodeWarning",
    "Solution",
    "Table",
    "Trajectory",
    "__version__",
    "boundary",
    "classify",
    "compare",
    "distance",
    "fit",
    "fit_peaks",
    "report",
    "roots",
    "simulate",
    "solve",
    "tolerance",
    "verify",
]
