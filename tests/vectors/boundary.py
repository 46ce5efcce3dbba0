"""Boundary points, cusps, corner errors, limits and frequencies by mpmath and sympy, from eq 8 and eqs 15-20 only.

The boundary is where the discriminant of eq 8 vanishes (sympy's discriminant of the polynomial, mpmath's polyroots at 120
digits); neither the rational curve nor its parameter is used.
"""
import sympy as sp
from mpmath import mp, mpf, polyroots, sqrt, log10, findroot, nstr
mp.dps = 120
p, E, k, be = sp.symbols("p E k be")
D = sp.Poly(sp.discriminant(E*p**3+(1+E)*p**2+(k+1-be)*p+k, p), E, k, be)

def real_positive(coefficients):
    while coefficients and coefficients[0] == 0: coefficients = coefficients[1:]
    roots = polyroots([mpf(c.p)/c.q if hasattr(c,'p') else c for c in coefficients], maxsteps=2000, extraprec=1200)
    return sorted(r.real for r in roots if abs(r.imag) < mpf(10)**-90*abs(r) and r.real > 0)

R = sp.Rational
def at_velocity(a,b,Dc,K,M,V):
    g = V**2*M/(K*Dc**2)
    poly = sp.Poly(D.as_expr().subs({E: g*k, be: b/a}), k)
    ks = real_positive(poly.all_coeffs())
    kap = [K*Dc/a]
    return sorted(mpf(kap[0].p)/kap[0].q/x for x in ks)
def at_stress(a,b,Dc,K,M,s):
    kk = K*Dc/(a*s)
    poly = sp.Poly(D.as_expr().subs({k: kk, be: b/a}), E)
    sc = s*a*Dc/M
    return sorted(sqrt(x*sc.p/sc.q) for x in real_positive(poly.all_coeffs()))
def line(*fields): print(",".join(str(f) for f in fields))
def show(xs): return " ".join(nstr(x, 60, min_fixed=1, max_fixed=0) for x in xs)
print("# Where the boundary max Im(s) = 0 is, from eq 8 alone. Made by tests/vectors/boundary.py")
print("# (sympy %s discriminant over Q, mpmath %s polyroots at 120 digits); 60 digits are printed." % (sp.__version__, __import__('mpmath').__version__))
line("section","direct_effect","evolution_effect","critical_slip_distance_m","stiffness_pa_per_m","mass_per_area_kg_per_m2","given","found")
cases = [("0.004","0.006","1e-5","1e7","1000"),("0.006","0.004","1e-5","1e7","1000"),("0.005","0.005","1e-5","1e7","1000"),
 ("0.004","0.000004","1e-5","1e7","1000"),("0.004","4","1e-5","1e7","1000"),("0.01","0.0100000001","3e-6","2.5e9","40")]
for c in cases:
    q = [R(x) for x in c]
    for V in ["1e-7","3e-5","1.2e-4","1.5e-4","1.596e-4","2e-3","0.7"]:
        line("velocity",*c,V,show(at_velocity(*q,R(V))))
    for s in ["3","700","4900","5857","6e5","4e6","1e9"]:
        line("normal_stress",*c,s,show(at_stress(*q,R(s))))
# From here on a = D_c = K = M = 1, so that b = beta, sigma = 1/kappa and V0^2 = eta/kappa.
Dl = sp.lambdify((E, k, be), D.as_expr(), "mpmath")
def kappas(g, b):
    """Positive roots in kappa of the discriminant along eta = g kappa, by interpolation of its values."""
    xs = [mpf(i) for i in range(5)]; ys = [Dl(g*x, x, b) for x in xs]
    A = mp.matrix(5, 5); B = mp.matrix(5, 1)
    for i, x in enumerate(xs):
        B[i] = ys[i]
        for j in range(5): A[i, j] = x**j
    c = mp.lu_solve(A, B)
    return real_positive([c[j] for j in range(4, -1, -1)])
def log_distance(kap, g, b, arc):
    s15 = 1/(sqrt(b) - 1)**2 if arc == "upper" else 1/(sqrt(b) + 1)**2
    w = abs(b - 1) if arc == "upper" else mpf(1)
    sig, V = 1/kap, sqrt(g)
    return min(abs(log10(sig/s15)), abs(log10(V/(w*sig/2))))
def cusp(target):
    """The triple root by Newton from a = b (r = -3), in 300 geometric steps of beta."""
    point = (mpf(-3), mpf(1)/8, mpf(27)/8)
    for step in range(1, 301):
        b = target**(mpf(step)/300)
        F = lambda x, e, kk: e*x**3 + (1+e)*x**2 + (kk+1-b)*x + kk
        point = tuple(findroot(lambda x, e, kk: (F(x,e,kk), 3*e*x**2+2*(1+e)*x+kk+1-b, 6*e*x+2*(1+e)), point, tol=mpf(10)**-200, maxsteps=200))
    assert point[0] < -1 and point[1] > 0 and point[2] > 0
    return point
def double_root(kap, g, b):
    """The mean of the two nearest roots of eq 8."""
    roots = sorted((x.real for x in polyroots([g*kap, 1+g*kap, kap+1-b, kap], maxsteps=2000, extraprec=1200)))
    i = min(range(2), key=lambda i: roots[i+1]-roots[i])
    return (roots[i]+roots[i+1])/2
for text in ["0.001", "0.03", "0.5", "0.999", "1.5", "7", "1000"]:
    b = mpf(R(text).p)/R(text).q
    r, e, kk = cusp(b)
    line("cusp", 1, text, 1, 1, 1, "", show([1/kk, sqrt(e/kk), r]))
    vu = abs(b-1)/(sqrt(b)-1)**2/2; vl = 1/(sqrt(b)+1)**2/2
    ku = [x for x in kappas(vu**2, b) if double_root(x, vu**2, b) > -1]
    up = log_distance(ku[0], vu**2, b, "upper")
    cand = [log_distance(x, vl**2, b, "lower") for x in kappas(vl**2, b) if double_root(x, vl**2, b) < -1]
    cand.append(log_distance(kk, e/kk, b, "lower"))
    line("worst", 1, text, 1, 1, 1, "", show([up, max(cand)]))
