"""FLINT from Python (python-flint): certified roots of integer cubics, and the boundary at given normal stress.

The polynomials are ready. The package has a newer FLINT than many systems; a call of it from Python takes about a microsecond more
than one from C.
"""

import flint
from common import FOLDER, best_of, main, row
from flint import acb, arb, ctx, fmpq, fmpz, fmpz_poly

METHOD = "python-flint-complex_roots"
OPTIONS = "fmpz_poly.complex_roots;polynomials~ready"


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
    row(f"roots-{which}", METHOD, OPTIONS, rounds * len(cubics), seconds, worst.str(3, radius=False))


def chunks(roots_of_all):
    """Three roots at a time."""
    return [roots_of_all[i : i + 3] for i in range(0, len(roots_of_all), 3)]


def velocities(polynomial, scale, digits):
    """V0 of every crossing: the square root of scale times a positive root."""
    found = certified(polynomial, digits)
    return [(root.real * scale).sqrt() for root, _ in found if root.imag == 0 and root.real > 0]


def boundary(which):
    """All normal stresses of the input; the reference is the enclosed V0."""
    digits = int(which)
    ctx.prec = bits(digits + 10)
    inputs, expected = [], []
    for line in (FOLDER / f"boundary-{which}.txt").read_text().splitlines():
        _, *cubic, scale, velocity = line.split()
        numerator, _, denominator = scale.partition("/")
        scale = arb(fmpq(fmpz(numerator), fmpz(denominator or "1")))
        inputs.append((fmpz_poly([int(cell) for cell in cubic]), scale))
        expected.append(arb(velocity))
    seconds, found = best_of(3, lambda: [velocities(*one, digits) for _ in range(5) for one in inputs])
    ctx.prec = bits(digits + 10)
    worst, wrong = arb(0), 0
    for several, velocity in zip(found, expected):
        distances = [(abs(one - velocity) / velocity).abs_upper() for one in several]
        wrong += not distances
        worst = worst.max(min(distances)) if distances else worst
    error = worst.str(3, radius=False)
    row(f"boundary-{which}", METHOD, OPTIONS, 5 * len(inputs), seconds, error, wrong)


main({"roots": roots, "boundary": boundary}, f"python-flint {flint.__version__} (FLINT {flint.__FLINT_VERSION__})")
