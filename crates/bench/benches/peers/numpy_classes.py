"""NumPy: class of many points by batched eigenvalues of companion matrices."""

import numpy
from common import FOLDER, best_of, main, row

BATCH = 60_000


def roots(columns):
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


def classes(family):
    """Signs of K - K_c and of the discriminant, read off the roots; largest parts where both are right."""
    table = numpy.fromfile(FOLDER / f"{family}.f64").reshape(12, -1)
    # A spread of the points, not the first ones: a grid begins in one corner.
    table = table[:, :: max(1, table.shape[1] // BATCH)]
    seconds, found = best_of(2, lambda: roots(table[:7]))
    transition, boundary, real, modulus, imaginary = table[7:]
    found_real, found_imaginary = found.real.max(axis=1), found.imag.max(axis=1)
    right = (-numpy.sign(found_real) == transition) & (numpy.where(found_imaginary > 0, -1, 1) == boundary)
    error = (numpy.abs(found_real - real) / modulus)[right].max()
    pairs = right & (imaginary > 0)
    if pairs.any():
        error = max(error, numpy.abs(found_imaginary[pairs] / imaginary[pairs] - 1).max())
    row(f"classes-{family}", "numpy-eigvals", table.shape[1], seconds, error, int((~right).sum()))


main({"classes": classes}, f"NumPy {numpy.__version__}")
