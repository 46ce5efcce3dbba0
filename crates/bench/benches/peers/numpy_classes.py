"""NumPy: signs, extremes and roots of many points by batched eigenvalues of companion matrices."""

import numpy
from common import FOLDER, best_of, main, row

BATCH = 60_000
OPTIONS = "linalg.eigvals;one~call~for~all~points"


def solve(columns):
    """Three roots a point, in 1/s, from the seven inputs: the work that is timed."""
    direct, evolution, distance, stiffness, mass, stress, velocity = columns
    direct_stress = direct * stress
    eta = mass * velocity**2 / (direct_stress * distance)
    kappa = stiffness * distance / direct_stress
    companion = numpy.zeros((len(eta), 3, 3))
    companion[:, 0, 0] = -(1 + eta) / eta
    companion[:, 0, 1] = -(kappa + 1 - evolution / direct) / eta
    companion[:, 0, 2] = -kappa / eta
    companion[:, 1, 0] = companion[:, 2, 1] = 1
    return numpy.linalg.eigvals(companion) * (velocity / distance)[:, None]


def read(family):
    """A spread of the points, not the first ones: a grid begins in one corner."""
    table = numpy.fromfile(FOLDER / f"points-{family}.f64").reshape(24, -1)
    return table[:, :: max(1, table.shape[1] // BATCH)]


def right_signs(found, table):
    """Where the signs of K - K_c and of the discriminant, read off the roots, are right."""
    transition, boundary = table[7:9]
    kind = numpy.where(found.imag.max(axis=1) > 0, -1, 1)
    return (-numpy.sign(found.real.max(axis=1)) == transition) & (kind == boundary)


def extreme_errors(found, table):
    """Of max Re relative to that root's modulus, and of max Im relative to itself."""
    real, modulus, imaginary = table[9:12]
    errors = numpy.abs(found.real.max(axis=1) - real) / modulus
    with numpy.errstate(divide="ignore", invalid="ignore"):
        errors_of_pairs = numpy.abs(found.imag.max(axis=1) / imaginary - 1)
    return numpy.where(imaginary > 0, numpy.maximum(errors, errors_of_pairs), errors)


def root_errors(found, table):
    """The worst distance of a root from the nearest exact one, relative to the modulus of that."""
    exact = (table[12:18:2] + 1j * table[13:18:2]).T
    distances = numpy.abs(found[:, :, None] - exact[:, None, :]) / numpy.abs(exact)[:, None, :]
    return distances.min(axis=2).max(axis=1)


def play(kind, errors_of):
    """A work of one kind; errors only where the signs are right."""

    def work(family):
        table = read(family)
        seconds, found = best_of(2, lambda: solve(table[:7]))
        right = right_signs(found, table)
        error = float(errors_of(found, table)[right].max()) if errors_of and right.any() else None
        wrong = int((~right).sum())
        row(f"{kind}-{family}", "numpy-eigvals", OPTIONS, table.shape[1], seconds, error, wrong)

    return work


WORKS = {"signs": play("signs", None), "extremes": play("extremes", extreme_errors), "cubic": play("cubic", root_errors)}
main(WORKS, f"NumPy {numpy.__version__}")
