"""mpmath: roots of integer cubics by polyroots, not certified."""

import mpmath
from common import FOLDER, best_of, main, row
from mpmath import mp, mpc, mpf


def solve(cubic, digits):
    """Roots at the working precision, or None where the iteration gives up."""
    try:
        return mpmath.polyroots(cubic[::-1], maxsteps=200, extraprec=digits * 4)
    except mpmath.libmp.NoConvergence:
        return None


def roots(which):
    """Few cubics: it is slow."""
    digits, _, family = which.partition("-")
    digits = int(digits)
    mp.dps = digits + 20
    lines = (FOLDER / f"roots-{family}-{digits}.txt").read_text().splitlines()
    reference = [mpc(mpf(re), mpf(im)) for re, im in (line.split() for line in lines)]
    count = min(len(reference) // 3, 40 if digits <= 100 else 4)
    lines = (FOLDER / f"roots-{family}.txt").read_text().splitlines()[:count]
    cubics = [[int(cell) for cell in line.split()] for line in lines]
    mp.dps = digits
    seconds, found = best_of(1, lambda: [solve(cubic, digits) for cubic in cubics])
    mp.dps = digits + 20
    worst, wrong = mpf(0), 0
    for index, solved in enumerate(found):
        if solved is None:
            wrong += 1
            continue
        expected = reference[3 * index : 3 * index + 3]
        for root in solved:
            worst = max(worst, min(abs(root - other) / abs(other) for other in expected))
    row(f"roots-{which}", "mpmath-polyroots", "maxsteps=200;extraprec=4*digits", count, seconds, mpmath.nstr(worst, 3), wrong)


main({"roots": roots}, f"mpmath {mpmath.__version__}")
