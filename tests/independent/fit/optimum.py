"""An independent fit of a record: the optimum of least squares near the true parameters, by SciPy.

    python3 tests/independent/fit/optimum.py RECORD.csv [the options of `slipmode fit`] [--profile] [--against FITTED.json]

The parameters at which the search starts are those of manifest.json beside the record, which records.py wrote. The answer on
standard output has the same names as `slipmode fit --json`. With --profile it has 95 % intervals by profile likelihood, else those
of the quadratic approximation. --against compares with an answer of slipmode and exits with 1 when an estimate differs.
Differences are relative for a, b, D_c and K, in units of a for mu_0 and in units of a/D_c for the drift.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student

from model import NAMES, Failed, Parameters, read

TOLERANCE = 1e-6  # Of the comparison with another program's optimum.
STEP = 5e-4  # Of the differences, in the same units as SETTLED; the noise of the integration is below 1e-9.
SETTLED = 5e-9  # Largest last step, in logarithms and in the units of mu_0 and the drift.
LOGARITHMIC = ("a", "b", "d_c", "k")
WIDEST = 60.0  # A bound of an interval is searched up to this many standard errors.


class Problem:
    """Residuals of a record and their derivatives, in logarithms of a, b, D_c, K, in mu_0/a and in drift D_c/a (a, D_c: start)."""

    def __init__(self, record, start, names):
        self.record, self.start, self.names = record, start, names
        self.units = {"mu_0": start.a, "drift": start.a / start.d_c}

    def vector(self, p):
        return np.array([np.log(getattr(p, name)) if name in LOGARITHMIC else getattr(p, name) / self.units[name] for name in self.names])

    def value(self, name, x):
        return float(np.exp(x) if name in LOGARITHMIC else x * self.units[name])

    def parameters(self, vector):
        return self.start.of(**{name: self.value(name, x) for name, x in zip(self.names, vector)})

    def residuals(self, vector):
        return self.record.modelled(self.parameters(vector)) - self.record.observed

    def derivatives(self, vector, of=None, precise=True):
        """Columns for the parameters with these indices, by differences of fourth order or of second order."""
        columns = []
        for index in range(len(vector)) if of is None else of:
            shift = np.zeros(len(vector))
            shift[index] = STEP
            across = [self.residuals(vector + n * shift) - self.residuals(vector - n * shift) for n in ((1, 2) if precise else (1,))]
            columns.append((8 * across[0] - across[1]) / (12 * STEP) if precise else across[0] / (2 * STEP))
        return np.array(columns).T

    def minimum(self):
        """The optimum and its derivatives: least squares of SciPy, then steps of Gauss and Newton until they are below SETTLED."""
        found = least_squares(self.residuals, self.vector(self.start), jac=self.derivatives, x_scale="jac", max_nfev=60)
        if found.status <= 0:
            raise Failed("least squares did not converge")
        vector, slopes = found.x, found.jac
        for _ in range(20):
            step = np.linalg.lstsq(slopes, -self.residuals(vector), rcond=None)[0]
            vector = vector + step
            slopes = self.derivatives(vector)
            if np.max(np.abs(step)) < SETTLED:
                return vector, slopes, float(np.max(np.abs(step)))
        raise Failed(f"the last step towards the optimum is {np.max(np.abs(step)):.1e}")

    def least_along(self, start, fixed, variance):
        """The least sum of squares with one parameter held, from a start near it; the derivatives are computed once."""
        free = [index for index in range(len(start)) if index != fixed]
        vector, residuals = np.array(start), self.residuals(start)
        inverse = np.linalg.pinv(self.derivatives(vector, free, precise=False))
        squares = residuals @ residuals
        for _ in range(12):
            vector[free] -= inverse @ residuals
            residuals = self.residuals(vector)
            before, squares = squares, residuals @ residuals
            if abs(before - squares) < 1e-5 * variance:
                return squares
        raise Failed("the profile likelihood did not converge")


class Fit:
    """The optimum of a problem with its covariance."""

    def __init__(self, problem):
        self.problem = problem
        self.vector, slopes, self.last_step = problem.minimum()
        residuals = problem.residuals(self.vector)
        self.squares = float(residuals @ residuals)
        self.freedom = len(problem.record.observed) - len(self.vector)
        self.variance = self.squares / self.freedom
        self.covariance = np.linalg.inv(slopes.T @ slopes) * self.variance
        self.errors = np.sqrt(np.diag(self.covariance))
        self.quantile = float(student.ppf(0.975, self.freedom))

    def root(self, index, offset):
        """Root of the likelihood ratio with a parameter held at `offset` standard errors: |offset| if the model were linear."""
        start = self.vector + offset * self.covariance[:, index] / self.errors[index]
        squares = self.problem.least_along(start, index, self.variance)
        return np.sqrt(max(squares - self.squares, 0.0) / self.variance)

    def bound(self, index, sign):
        """One end of the 95 % interval by profile likelihood; infinite if the likelihood does not fall enough."""
        offset = self.quantile
        try:
            while offset < WIDEST:
                root = self.root(index, sign * offset)
                if abs(root - self.quantile) < 1e-3:
                    return self.vector[index] + sign * offset * self.errors[index]
                offset *= self.quantile / max(root, self.quantile / 2)
        except Failed:
            pass
        return sign * np.inf

    def answer(self, profile):
        """The members that `slipmode fit --json` has, too."""
        problem, best = self.problem, self.problem.parameters(self.vector)
        found = {"law": best.law}
        for index, name in enumerate(problem.names):
            offsets = [-self.quantile * self.errors[index], self.quantile * self.errors[index]]
            ends = [self.bound(index, sign) for sign in (-1, 1)] if profile else [self.vector[index] + offset for offset in offsets]
            low, high = (problem.value(name, end) for end in ends)
            value = getattr(best, name)
            error = self.errors[index] * (value if name in LOGARITHMIC else problem.units[name])
            found[NAMES[name]] = {"value": value, "error": error, "low": low, "high": high}
        matrix = self.covariance / np.outer(self.errors, self.errors)
        names = [NAMES[name] for name in problem.names]
        correlations = {f"{names[j]},{names[i]}": matrix[i, j] for i in range(len(names)) for j in range(i)}
        closing = {"correlations": correlations, "rows": len(problem.record.observed), "residual_sum_of_squares": self.squares}
        return found | {"residual_standard_deviation": float(np.sqrt(self.variance)), **closing, "last_step": self.last_step}


def parser():
    found = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    found.add_argument("record", type=Path)
    found.add_argument("--law", choices=("slip", "aging"), default="aging")
    found.add_argument("--normal-stress-pa", type=float)
    found.add_argument("--stiffness-pa-per-m", type=float)
    found.add_argument("--mass-per-area-kg-per-m2", type=float, default=0.0)
    found.add_argument("--drift", action="store_true")
    found.add_argument("--json", action="store_true", help="the only output; accepted because slipmode has this option")
    found.add_argument("--profile", action="store_true")
    found.add_argument("--against", type=Path)
    return found


def true_parameters(given):
    manifest = json.loads((given.record.parent / "manifest.json").read_text())
    entry = next(one for one in manifest["records"] if one["file"] == given.record.name)
    values = {name: entry["truth"].get(long, 0.0) for name, long in NAMES.items()}
    values["k"] = given.stiffness_pa_per_m or values["k"]
    return Parameters(**values, mass=given.mass_per_area_kg_per_m2, law=given.law)


def fitted_names(given):
    chosen = {"k": given.stiffness_pa_per_m is None, "drift": given.drift}
    return [name for name in NAMES if chosen.get(name, True)]


def differences(answer, other, start):
    """Each estimate's difference from the other program's, in the units of the comparison."""
    units = {"mu_0": start.a, "drift": start.a / start.d_c}
    pairs = ((name, answer[long]["value"], other[long]["value"]) for name, long in NAMES.items() if long in answer)
    return {NAMES[name]: abs(mine - theirs) / units.get(name, abs(mine)) for name, mine, theirs in pairs}


def main():
    given = parser().parse_args()
    begin = time.process_time()
    start = true_parameters(given)
    problem = Problem(read(given.record, given.normal_stress_pa), start, fitted_names(given))
    answer = Fit(problem).answer(given.profile)
    answer["cpu_seconds"] = time.process_time() - begin
    if given.against:
        answer["differences"] = differences(answer, json.loads(given.against.read_text()), start)
    print(json.dumps(answer, indent=1))
    return int(any(not one <= TOLERANCE for one in answer.get("differences", {}).values()))


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Failed, OSError, KeyError, StopIteration) as error:
        print(f"error: {error!r}", file=sys.stderr)
        sys.exit(2)
