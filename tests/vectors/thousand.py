"""Makes roots-1000-digits.txt: the roots of fifty cubics, by PARI/GP and again by FLINT.

Usage: python3 thousand.py, in this folder.
"""

import subprocess
from decimal import Context, Decimal
from math import lcm

from flint import arb, ctx, fmpz_poly

import cases
from cases import power, q

DIGITS = 1000
ctx.prec = 8000
ROUND = Context(prec=DIGITS, Emax=10**6, Emin=-(10**6))

GP = r"""
default(realprecision, 2000);
roots(e, k, b) = {
  my(F, T, S, R, m);
  F = e*x^3 + (1 + e)*x^2 + (k + 1 - b)*x + k;
  T = F / gcd(F, F');
  /* With one real root the two others are a pair; the real ones are taken apart by exact Sturm sequences. */
  R = polrootsreal(T);
  S = if(#R < poldegree(T), select(z -> imag(z) > 0, polroots(T)), []);
  for(i = 1, #R, m = multiplicity(F, R[i]); print(m, ",", precision(R[i], 2000), ",0"));
  for(i = 1, #S, if(#R == 1, print(1, ",", real(S[i]), ",", imag(S[i]))));
  print("end");
}
multiplicity(F, r) = {
  my(m = 1, G = F');
  while(abs(subst(G, x, r)) < 1e-1500 * (1 + normlp(Vec(G)) * max(1, abs(r))^2), m++; G = G');
  m;
}
"""
RATIONAL_POINTS = [("7/5", "3/11", "2/9"), ("1/1000", "1/7", "3"), ("50", "1/90", "40"), ("1/9", "90", "1/2")]


def points():
    """Fifty points: on the boundary and beside it, cusps, K = K_c, extremes, and plain ones."""
    arcs = [cases.on_boundary(q(r), q(beta)) for r, beta in cases.BOUNDARY_UPPER + cases.BOUNDARY_LOWER]
    far = [cases.on_boundary(q(r), q(beta)) for r, beta in cases.FAR_ON_BOUNDARY]
    cusps = [cases.on_cusp(q(r)) for r in cases.CUSPS]
    beside = [neighbour for point in arcs[:8:3] for neighbour in cases.beside(point, 1)[1:]]
    transition = [cases.on_transition(q(eta), q(beta)) for eta, beta in cases.TRANSITION]
    extremes = [(power(30), power(-30), q("1.5")), (power(-30), power(30), q("0.75")), (power(-30), power(-12), power(30))]
    plain = [tuple(map(q, point)) for point in RATIONAL_POINTS]
    return (arcs + far + cusps + beside + transition + extremes + plain)[:50]


def pari(chosen):
    """For each point the (multiplicity, re, im) of its real roots, ascending, and of the upper root of a pair."""
    calls = "".join(f"roots({e}, {k}, {b});\n" for e, k, b in chosen)
    script = GP.replace("\n  ", " ").replace("\n}", " }") + calls
    done = subprocess.run(["gp", "-q", "-f", "-s", "1000000000"], input=script, capture_output=True, text=True, check=True)
    if done.stderr:
        raise SystemExit(f"PARI/GP: {done.stderr}")
    blocks = done.stdout.replace(" ", "").split("end\n")[:-1]
    return [[line.split(",") for line in block.splitlines()] for block in blocks]


def flint(eta, kappa, beta):
    """The same as enclosures."""
    coefficients = [kappa, kappa + 1 - beta, 1 + eta, eta]
    scale = lcm(*(int(c.q) for c in coefficients))
    roots = fmpz_poly([int((c * scale).p) for c in coefficients]).complex_roots()
    real = sorted((root for root in roots if root[0].imag == 0), key=lambda root: float_key(root[0].real))
    return real + [root for root in roots if root[0].imag > 0]


def float_key(enclosure):
    """An exact order: disjoint enclosures are ordered by their midpoints."""
    mantissa, exponent = enclosure.mid().man_exp()
    return mantissa * 2**exponent if exponent >= 0 else q(str(int(mantissa))) / q(str(2 ** int(-exponent)))


def text(value):
    """A decimal rounded to a thousand digits, without trailing zeros."""
    sign, digits, exponent = ROUND.create_decimal(value).as_tuple()
    return cases.plain((-1) ** sign * int("".join(map(str, digits))), exponent)


def agrees(value, enclosure, modulus):
    """Whether the rounded decimal is within one unit of its last digit, relative to the root's modulus."""
    return abs(arb(value) - enclosure) < modulus * arb(10) ** (1 - DIGITS)


def main():
    chosen = points()
    assert len(chosen) == len(set(map(str, chosen))) == 50
    with open("roots-1000-digits.txt", "w", encoding="utf-8") as file:
        file.write("# Roots p of eq 8 to 1 000 significant digits: real roots ascending, then the upper root of a pair.\n")
        file.write("# Made by thousand.py with PARI/GP 2.15.2 and python-flint 0.9.0, which agree on every digit.\n")
        file.write("eta,kappa,beta,multiplicity,re,im\n")
        for point, by_pari in zip(chosen, pari(chosen), strict=True):
            for (multiplicity, re, im), (root, count) in zip(by_pari, flint(*point), strict=True):
                re, im = text(re), text(im)
                modulus = abs(root)
                if int(multiplicity) != count or not (agrees(re, root.real, modulus) and agrees(im, root.imag, modulus)):
                    raise SystemExit(f"the two programs disagree at {point}")
                file.write(",".join([*map(cases.shortest, point), multiplicity, re, im]) + "\n")


if __name__ == "__main__":
    main()
