"""FLINT (python-flint): certified roots of integer cubics, and the boundary at given normal stress."""

from decimal import Decimal
from fractions import Fraction
from math import lcm

import flint
from common import FOLDER, best_of, main, row
from flint import acb, arb, ctx, fmpz_poly


def bits(digits):
    """Binary digits for decimal ones."""
    return int(digits * 3.3219281) + 8


def certified(cubic, digits):
    """Isolated roots whose radius is below the wanted digits: the precision is raised until it is."""
    wanted = bits(digits)
    precision = wanted
    while True:
        ctx.prec = precision
        roots = cubic.complex_roots()
        if all(root.rel_accuracy_bits() >= wanted - 8 for root, _ in roots):
            return roots
        precision += precision // 2


def read_reference(path):
    """Pairs of decimals as exact balls."""
    return [acb(arb(re), arb(im)) for re, im in (line.split() for line in path.read_text().splitlines())]


def roots(which):
    """The error is the largest distance of any point of an enclosure from the reference, relative."""
    digits, _, family = which.partition("-")
    digits = int(digits)
    ctx.prec = bits(digits + 20)
    reference = read_reference(FOLDER / f"roots-{family}-{digits}.txt")
    lines = (FOLDER / f"roots-{family}.txt").read_text().splitlines()[: len(reference) // 3]
    cubics = [fmpz_poly([int(cell) for cell in line.split()]) for line in lines]
    rounds = 5 if digits <= 100 else 1
    seconds, found = best_of(2, lambda: [certified(cubic, digits) for _ in range(rounds) for cubic in cubics])
    ctx.prec = bits(digits + 20)
    worst = arb(0)
    for isolated, expected in zip(found, chunks(reference)):
        for root, _ in isolated:
            distances = [(abs(root - other) / abs(other)).abs_upper() for other in expected]
            worst = worst.max(distances[0].min(distances[1]).min(distances[2]))
    row(f"roots-{which}", "flint-complex_roots", rounds * len(cubics), seconds, worst.str(3, radius=False))


def chunks(roots_of_all):
    """Three roots at a time."""
    return [roots_of_all[i : i + 3] for i in range(0, len(roots_of_all), 3)]


def discriminant_in_eta(kappa, beta):
    """The discriminant of eta p^3 + (1 + eta) p^2 + c p + kappa as an integer polynomial in eta."""
    c = kappa + 1 - beta
    coefficients = [
        c**2 - 4 * kappa,
        2 * c**2 + 18 * c * kappa - 4 * c**3 - 12 * kappa,
        c**2 + 18 * c * kappa - 12 * kappa - 27 * kappa**2,
        -4 * kappa,
    ]
    scale = lcm(*(value.denominator for value in coefficients))
    return fmpz_poly([int(value * scale) for value in coefficients])


def velocities(stress):
    """V0 of every crossing at this normal stress, for the paper's slider, from positive roots in eta."""
    direct, evolution, distance = Fraction("0.004"), Fraction("0.006"), Fraction("1e-5")
    polynomial = discriminant_in_eta(10**7 * distance / (direct * stress), evolution / direct)
    scale = stress * direct * distance / 1000
    ratio = arb(scale.numerator) / scale.denominator
    return [(root.real * ratio).sqrt() for root, _ in certified(polynomial, 50) if root.imag == 0 and root.real > 0]


def boundary(_):
    """All normal stresses of the input; the reference is the enclosed V0."""
    lines = [line.split() for line in (FOLDER / "boundary.txt").read_text().splitlines()]
    stresses = [Fraction(Decimal(stress)) for stress, _ in lines]
    seconds, found = best_of(3, lambda: [velocities(stress) for _ in range(5) for stress in stresses])
    ctx.prec = bits(60)
    worst, wrong = 0.0, 0
    for several, (_, expected) in zip(found, lines):
        distances = [float((abs(one - arb(expected)) / arb(expected)).abs_upper()) for one in several]
        wrong += not distances
        worst = max([worst, min(distances, default=0.0)])
    row("boundary-section", "flint-complex_roots", 5 * len(stresses), seconds, worst, wrong)


main({"roots": roots, "boundary": boundary}, f"python-flint {flint.__version__} (FLINT {flint.__FLINT_VERSION__})")
