"""Makes groups-hard.txt and classification-hard.txt with two programs that know nothing of slipmode.

Every expected value is computed by PARI/GP and again by FLINT (python-flint); a disagreement stops the program.
README.md beside this file tells the method. Usage: python3 generate.py, in this folder.
"""

import random
import subprocess
from decimal import ROUND_HALF_EVEN, Context, Decimal
from math import lcm

from flint import arb, ctx, fmpq, fmpz_poly

import cases

DIGITS = 30
STABLE_REAL = {False: "overdamped-stable-sliding", True: "overdamped-oscillation"}
UNDERDAMPED = {False: "non-inertial-underdamped-oscillation", True: "inertial-underdamped-oscillation"}
ctx.prec = 4000

GP = r"""
default(realprecision, 600);
mode(T, D, lower, above, b) = {
  if(T < 0, return(if(D >= 0 || !above, "stick-slip", "harmonic-vibration")));
  if(T > 0 && D >= 0, return(if(b < 1 && !lower, "overdamped-oscillation", "overdamped-stable-sliding")));
  if(above, "inertial-underdamped-oscillation", "non-inertial-underdamped-oscillation");
}
hard(e, k, b, rate) = {
  my(F, S, D, R, re, at, im, T, g, above, lower, class);
  F = e*x^3 + (1 + e)*x^2 + (k + 1 - b)*x + k;
  S = F / gcd(F, F');
  D = sign(poldisc(F));
  R = polroots(S);
  re = vecmax(real(R), &at);
  im = if(D < 0, vecmax(imag(R)), 0);
  /* On K = K_c the polynomial has the factor p^2 + b - 1; elsewhere the sign of the largest real part is numerical. */
  T = if(b > 1 && F % (x^2 + b - 1) == 0, 0, -sign(re));
  if(T == 0, re = 0);
  lower = vecmax(real(R)) < -1;
  /* The product of y^2 - (p_i - p_j)^2 over the pairs; a pair with Im = w gives the one real zero y^2 = -4 w^2. */
  g = polresultant(F, subst(F, x, x + y), x) / y^3;
  g = g / polcoef(g, 6, y);
  above = D < 0 && sum(i = 0, 3, polcoef(g, 2*i, y) * (-2*k/e)^i) > 0;
  class = if(T == 0, "neutral", Str(if(T > 0, "stable", "unstable"), if(D < 0, "-complex", "-real")));
  print(T, ",", D, ",", class, ",", mode(T, D, lower, above, b), ",", 1.*re*rate, ",", abs(R[at])*rate, ",", 1.*im*rate);
}
"""


def pari(rows):
    """Expected values of rows (eta, kappa, beta, rate) as PARI/GP finds them."""
    calls = "".join(f"hard({e}, {k}, {b}, {rate});\n" for e, k, b, rate in rows)
    script = GP.replace("\n  ", " ").replace("\n}", " }") + calls
    done = subprocess.run(["gp", "-q", "-f", "-s", "1000000000"], input=script, capture_output=True, text=True, check=True)
    lines = done.stdout.replace(" ", "").splitlines()
    if done.stderr or len(lines) != len(rows):
        raise SystemExit(f"PARI/GP: {done.stderr or done.stdout[-2000:]}")
    return [line.split(",") for line in lines]


def flint(eta, kappa, beta, rate):
    """Signs, mode and extreme parts as FLINT encloses them; signs by counting certified roots."""
    coefficients = [kappa, kappa + 1 - beta, 1 + eta, eta]
    scale = lcm(*(int(c.q) for c in coefficients))
    roots = fmpz_poly([int((c * scale).p) for c in coefficients]).complex_roots()
    pairs = [root for root, _ in roots if root.imag > 0]
    multiple = any(multiplicity > 1 for _, multiplicity in roots)
    boundary_sign = -1 if pairs else 0 if multiple else 1
    real_parts = [root.real for root, _ in roots]
    largest = real_parts[0]
    for part in real_parts[1:]:
        largest = largest.max(part)
    transition_sign = 0 if largest.contains(0) else -1 if largest > 0 else 1
    imaginary = pairs[0].imag if pairs else arb(0)
    above = imaginary**2 > arb(kappa / (2 * eta))
    mode = slip_mode(transition_sign, boundary_sign, above, largest < -1, beta)
    modulus = next(abs(root) for root, _ in roots if root.real.overlaps(largest))
    return [str(transition_sign), str(boundary_sign), mode], [part * arb(rate) for part in (largest, modulus, imaginary)]


def slip_mode(transition_sign, boundary_sign, above, lower, beta):
    """The name of the mode: `above` the inertial threshold; `lower` when every root is below -1."""
    if boundary_sign >= 0:
        return "stick-slip" if transition_sign < 0 else STABLE_REAL[beta < 1 and not lower]
    if transition_sign < 0:
        return "harmonic-vibration" if above else "stick-slip"
    return UNDERDAMPED[above]


def rounded(text):
    """A decimal of PARI/GP to 30 significant digits, without trailing zeros."""
    value = Context(prec=DIGITS, rounding=ROUND_HALF_EVEN, Emax=10**6, Emin=-(10**6)).create_decimal(text)
    return cases.plain(*fraction(value))


def fraction(value):
    """Integer and exponent of ten of a Decimal."""
    sign, digits, exponent = value.as_tuple()
    return (-1) ** sign * int("".join(map(str, digits))), exponent


def close(text, enclosure):
    """Whether a rounded decimal and an enclosure agree to all but the last of the digits."""
    value = arb(text)
    if enclosure.contains(0):
        return value == 0
    return abs(value - enclosure) < abs(enclosure) * arb(10) ** (1 - DIGITS)


def expected(rows):
    """Seven texts for each row, after both programs agree."""
    answers = []
    for row, found in zip(rows, pari(rows), strict=True):
        verdicts, parts = flint(*row)
        texts = [rounded(text) for text in found[4:]]
        if verdicts != [found[0], found[1], found[3]] or not all(map(close, texts, parts)):
            raise SystemExit(f"the two programs disagree at {row}: {found[:4]}, {texts}")
        answers.append([*found[:4], *texts])
    return answers


def write(path, about, columns, families, texts, rows):
    """One line a case, `#` lines before each family."""
    answers = iter(expected(rows))
    inputs = iter(texts)
    with open(path, "w", encoding="utf-8") as file:
        file.write("".join(f"# {line}\n" for line in about))
        file.write(",".join(columns) + "\n")
        for title, count in families:
            file.write(f"# {title}\n")
            for _ in range(count):
                file.write(",".join([*next(inputs), *next(answers)]) + "\n")


def main():
    random.seed(20261121)
    groups = cases.group_families()
    points = [point for _, family in groups for point in family]
    write(
        "groups-hard.txt",
        cases.ABOUT_GROUPS,
        ["eta", "kappa", "beta", *cases.EXPECTED_GROUPS],
        [(title, len(family)) for title, family in groups],
        [[cases.shortest(value) for value in point] for point in points],
        [(*point, fmpq(1)) for point in points],
    )
    inputs = cases.parameter_families()
    points = [point for _, family in inputs for point in family]
    write(
        "../../reports/im-avouac/timings/classification-hard.txt",
        cases.ABOUT_PARAMETERS,
        [*cases.PARAMETERS, *cases.EXPECTED_PARAMETERS],
        [(title, len(family)) for title, family in inputs],
        [[cases.decimal(value) for value in point] for point in points],
        [(*cases.groups(*point), point[6] / point[2]) for point in points],
    )


if __name__ == "__main__":
    main()
