"""The hard cases: where they lie, as exact rationals. Nothing here computes an expected value."""

import random
from fractions import Fraction
from math import lcm

from flint import fmpq

PARAMETERS = [
    "direct_effect",
    "evolution_effect",
    "critical_slip_distance_m",
    "stiffness_pa_per_m",
    "mass_per_area_kg_per_m2",
    "normal_stress_pa",
    "loading_velocity_m_per_s",
]
VERDICTS = ["expected_transition_sign", "expected_boundary_sign", "expected_spectral_class", "expected_slip_mode"]
EXPECTED_GROUPS = [*VERDICTS, "expected_max_real", "its_modulus", "expected_max_imaginary"]
EXPECTED_PARAMETERS = [*VERDICTS, "expected_max_real_per_s", "its_modulus_per_s", "expected_max_imaginary_per_s"]

ABOUT = [
    "Made by generate.py with PARI/GP 2.15.2 and python-flint 0.9.0, which agree on every value; see README.md.",
    "Signs are exact; maxima have 30 significant digits; the inertial threshold is (omega/omega_n)^2 > 1/2.",
    "its_modulus is that of the root with the largest real part: the measure of that part's error.",
]
ABOUT_GROUPS = ["Hard cases in the dimensionless groups, exact rationals; exponents p in the unit V0/D_c.", *ABOUT]
ABOUT_PARAMETERS = ["Hard cases in the seven inputs, SI, exact decimals: a CSV once the # lines are taken out.", *ABOUT]

NEAR = [fmpq(1, 10**3), fmpq(1, 10**18), fmpq(1, 10**30)]
LADDER = [fmpq(1, 10**exponent) for exponent in (3, 6, 9, 12, 15, 18, 24, 30)]


def q(text):
    """The rational that a fraction or decimal says."""
    value = Fraction(text)
    return fmpq(value.numerator, value.denominator)


def power(exponent):
    """A power of ten."""
    return fmpq(10) ** exponent


def on_boundary(r, beta):
    """The point of the discriminant's curve with double root r."""
    eta = (beta - (r + 1) ** 2) / (2 * r * (r + 1) ** 2)
    kappa = r * ((2 * r + 1) * beta - (r + 1) ** 2) / (2 * (r + 1) ** 2)
    assert eta > 0 and kappa > 0 and beta > 0
    return eta, kappa, beta


def on_cusp(r):
    """The point with triple root r < -1."""
    return -1 / (3 * r + 1), r**3 / (3 * r + 1), (r + 1) ** 3 / (3 * r + 1)


def on_transition(eta, beta):
    """The point of K = K_c."""
    return eta, (beta - 1) * (1 + eta), beta


def on_threshold(t, x):
    """The point whose real root is t and whose pair is x +- i w with w^2 = kappa/(2 eta) exactly; -2 < t < -1."""
    w_squared = -x * x * t / (t + 2)
    eta = -1 / (t + 2 * x + 1)
    kappa = 2 * w_squared * eta
    beta = kappa + 1 - eta * (2 * t * x + x * x + w_squared)
    assert eta > 0 and kappa > 0 and beta > 0
    return eta, kappa, beta


def beside(point, index, distances=NEAR):
    """The point itself and its neighbours at some distances, on both sides, in one coordinate."""
    neighbours = [point]
    for distance in distances:
        for sign in (1, -1):
            moved = list(point)
            moved[index] *= 1 + sign * distance
            neighbours.append(tuple(moved))
    return neighbours


def around(points, index):
    """All points and their neighbours."""
    return [neighbour for point in points for neighbour in beside(point, index)]


BOUNDARY_UPPER = [("1/5", "3/2"), ("3", "50"), ("-1/10", "2/3"), ("-3/5", "1/7")]
BOUNDARY_LOWER = [("-3", "3/2"), ("-100", "7/3"), ("-7/2", "1"), ("-2", "1/2"), ("-1.001", "1e-7")]
FAR_ON_BOUNDARY = [
    ("1e-20", "2"), ("1e20", "1e50"), ("-1e-20", "1/2"), ("-1e20", "3"), ("-1e20", "1e30"),
    ("0.0000000001", "1.000000001"), ("-1.0000000001", "1e-21"),
]  # fmt: skip
CUSPS = ["-3", "-3/2", "-10", "-1.000001", "-1000000"]
TRANSITION = [("1/8", "3/2"), ("1", "3/2"), ("7", "1.000001"), ("1e-20", "3"), ("1e20", "1e6")]
THRESHOLDS = [("-3/2", "-1/2"), ("-3/2", "1/8"), ("-1.9", "-3"), ("-1.01", "0.001")]


def nearly_equal_effects():
    """a -> b from both sides, on both arcs, at the cusp's neighbourhood and on K = K_c."""
    points = []
    for exponent in (-3, -18, -30):
        small = power(exponent)
        points += [on_boundary(small / 5, 1 + small), on_boundary(-small / 5, 1 - small)]
        points += [on_boundary(q("-5/2"), 1 + small), on_boundary(q("-5/2"), 1 - small)]
        points += [on_transition(q("1/3"), 1 + small), (q("1/3"), small, 1 - small), (q("1/8"), q("27/8"), 1 + small)]
    return points


def extreme_groups():
    """Every combination of tiny, ordinary and huge groups, to 1e-30 and 1e30."""
    ladder = [power(-30), power(-12), q("1.25"), power(12), power(30)]
    betas = [power(-30), q("0.75"), q("1.5"), power(30)]
    chosen = [(eta, kappa, beta) for eta in ladder for kappa in ladder for beta in betas]
    return [point for number, point in enumerate(chosen) if number % 2 == 0 or point[0] in (ladder[0], ladder[4])]


def beyond_binary64():
    """Points whose groups, and roots, no 64-bit number holds."""
    tiny, huge = power(-400), power(400)
    chosen = [(tiny, huge, q("1.5")), (huge, tiny, q("0.75")), (huge, q(2), huge), (tiny, tiny, huge), (tiny, q(2), tiny)]
    return [*chosen, on_transition(huge, q("1.5"))]


def group_families():
    """Families of (eta, kappa, beta)."""
    upper = [on_boundary(q(r), q(beta)) for r, beta in BOUNDARY_UPPER]
    lower = [on_boundary(q(r), q(beta)) for r, beta in BOUNDARY_LOWER]
    return [
        ("upper arc: exactly on it (double root), then kappa times 1 +- 1e-3, 1e-18, 1e-30", around(upper, 1)),
        ("lower arc: the same, eta moved", around(lower, 0)),
        ("far out on the arcs: exactly on them, roots up to 40 orders of magnitude apart",
         [on_boundary(q(r), q(beta)) for r, beta in FAR_ON_BOUNDARY]),
        ("cusp: triple root, then beta moved", around([on_cusp(q(r)) for r in CUSPS], 2)),
        ("K = K_c exactly, then kappa moved; the second point is on the inertial threshold too",
         around([on_transition(q(eta), q(beta)) for eta, beta in TRANSITION], 1)),
        ("(omega/omega_n)^2 = 1/2 exactly, then kappa moved",
         around([on_threshold(q(t), q(x)) for t, x in THRESHOLDS], 1)),
        ("a -> b: beta = 1 +- 1e-3, 1e-18, 1e-30 on both arcs, on K = K_c, and a = b's cusp beside", nearly_equal_effects()),
        ("groups from 1e-30 to 1e30", extreme_groups()),
        ("groups and exponents beyond the range of binary64", beyond_binary64()),
    ]  # fmt: skip


def odd_part(value):
    """What is left of an integer without its factors 2 and 5."""
    for prime in (2, 5):
        while value % prime == 0:
            value //= prime
    return value


def realise(point, scale):
    """Seven terminating decimals with exactly these groups; scale = (a, D_c, sigma, V0) before a and sigma are adapted."""
    eta, kappa, beta = point
    direct, distance, stress, velocity = map(q, scale)
    direct *= odd_part(int(beta.q))
    stress *= lcm(odd_part(int((kappa * direct).q)), odd_part(int((eta * direct).q)))
    stiffness = kappa * direct * stress / distance
    mass = eta * stress * direct * distance / velocity**2
    found = (direct, beta * direct, distance, stiffness, mass, stress, velocity)
    assert groups(*found) == point
    return found


def groups(direct, evolution, distance, stiffness, mass, stress, velocity):
    """eta, kappa, beta of seven inputs."""
    direct_stress = direct * stress
    return mass * velocity**2 / (direct_stress * distance), stiffness * distance / direct_stress, evolution / direct


def random_decimal(digits, low, high):
    """A random decimal with this many digits, its size uniform in the logarithm."""
    exponent = random.randint(low, high)
    return random.randint(10 ** (digits - 1), 10**digits - 1) * power(exponent - digits + 1)


def random_parameters(digits):
    """Inputs as laboratories and faults have them, b/a from 0.05 to 20."""
    direct = random_decimal(digits, -4, -3)
    ratio = random_decimal(digits, -2, 0) * 2
    return (
        direct, direct * ratio, random_decimal(digits, -7, -3), random_decimal(digits, 4, 11),
        random_decimal(digits, -2, 6), random_decimal(digits, 2, 8), random_decimal(digits, -9, 0),
    )  # fmt: skip


def papers_map():
    """The paper's values with V0 and sigma over its map and beyond, where closed formulas paint false frequencies."""
    fixed = [q(text) for text in ("0.004", "0.006", "1e-5", "1e7", "1000")]
    pairs = [(s, v) for v in (-12, -9, -7, -5, -4, -3, -1, 1) for s in (1, 3, 5, 7, 9, 11)]
    swapped = [q(text) for text in ("0.006", "0.004", "1e-5", "1e7", "1000")]
    chosen = [(*fixed, power(s), power(v)) for s, v in pairs]
    return chosen + [(*swapped, power(s), power(v)) for s, v in pairs[::3]]


def overflowing():
    """Ordinary groups from inputs whose products leave the range of binary64."""
    scales = [("1e-200", "1e150", "1e250", "1e140"), ("1e180", "1e-170", "1e-190", "1e-160"), ("1e-280", "1e-30", "1e220", "1e-35")]
    points = [on_boundary(q("-3"), q("3/2")), on_transition(q("1/8"), q("3/2")), (q("0.3"), q("0.2"), q("4/3"))]
    return [realise(point, scale) for scale in scales for point in points]


def ladders():
    """Double roots on both arcs and triple roots, each at eight distances on both sides."""
    ordinary = ("0.004", "1e-5", "1e4", "1e-4")
    doubles = [on_boundary(q("-3"), q("3/2")), on_boundary(q("1/5"), q("3/2"))]
    triples = [on_cusp(q("-3")), on_cusp(q("-10"))]
    return [
        [realise(near, ordinary) for point in doubles for near in beside(point, 1, LADDER)],
        [realise(near, ordinary) for point in triples for near in beside(point, 2, LADDER)],
    ]


def subnormal():
    """Ordinary groups from inputs below the normal range of binary64: M; then a and b; then D_c and V0."""
    scales = [("0.004", "1e-5", "1e-300", "1"), ("1e-310", "1e-5", "1e4", "1e-4"), ("0.004", "1e-312", "1e-300", "1e-312")]
    points = [on_boundary(q("-3"), q("3/2")), on_cusp(q("-3/2")), on_transition(q("1/8"), q("3/2")), (q("0.3"), q("0.2"), q("4/3"))]
    return [realise(point, scale) for scale in scales for point in points]


def vanishing_inertia():
    """eta -> 0 on K = K_c exactly, and where the pair is slow and the third root fast without limit."""
    scale = ("0.004", "1e-5", "1e6", "1e-6")
    etas = [power(-exponent) for exponent in (6, 12, 16, 20, 30, 60, 150, 300)]
    places = [on_transition(eta, q("3/2")) for eta in etas] + [(eta, q("1/10"), q("3/2")) for eta in etas]
    return [realise(place, scale) for place in places]


def parameter_families():
    """Families of the seven inputs."""
    doubles, triples = ladders()
    far = [realise(on_boundary(q(r), q(beta)), ("0.004", "1e-5", "1e4", "1e-4")) for r, beta in FAR_ON_BOUNDARY]
    extreme = [realise(point, ("0.004", "1e-5", "1e4", "1e-4")) for point in extreme_groups()[::3]]
    ordinary, vibrating = ("0.004", "1e-5", "1e4", "1e-4"), ("0.01", "1e-6", "1e6", "0.1")
    upper = [on_boundary(q(r), q(beta)) for r, beta in BOUNDARY_UPPER[::2]]
    lower = [on_boundary(q(r), q(beta)) for r, beta in BOUNDARY_LOWER[::2]]
    transition = [on_transition(q(eta), q(beta)) for eta, beta in TRANSITION[:4:2]]
    threshold = [on_threshold(q(t), q(x)) for t, x in THRESHOLDS[:2]]
    return [
        ("the paper's values over its map and beyond; then a and b exchanged", papers_map()),
        ("upper arc: exactly on it, then K moved by 1e-3, 1e-18, 1e-30",
         [realise(point, ordinary) for point in around(upper, 1)]),
        ("lower arc: the same, M moved", [realise(point, vibrating) for point in around(lower, 0)]),
        ("cusp: triple root, then b moved", [realise(point, ordinary) for point in around([on_cusp(q("-3/2"))], 2)]),
        ("K = K_c exactly, then K moved", [realise(point, vibrating) for point in around(transition, 1)]),
        ("(omega/omega_n)^2 = 1/2 exactly, then K moved", [realise(point, ordinary) for point in around(threshold, 1)]),
        ("a -> b", [realise(point, ordinary) for point in nearly_equal_effects()]),
        ("products that leave the range of binary64", overflowing()),
        ("random inputs with 3 digits", [random_parameters(3) for _ in range(20)]),
        ("random inputs with 40 digits", [random_parameters(40) for _ in range(10)]),
        ("double roots: exactly, then K moved by 1e-3 to 1e-30", doubles),
        ("triple roots: exactly, then b moved by 1e-3 to 1e-30", triples),
        ("exactly on the arcs far out, roots up to 40 orders of magnitude apart", far),
        ("groups from 1e-30 to 1e30", extreme),
        ("inputs below the normal range of binary64", subnormal()),
        ("eta -> 0, on K = K_c and beside it", vanishing_inertia()),
    ]  # fmt: skip


def shortest(value):
    """A rational as a fraction or, where that is shorter, as a decimal."""
    texts = [str(value)] + ([decimal(value)] if odd_part(int(value.q)) == 1 else [])
    return min(texts, key=len)


def decimal(value):
    """A rational with a terminating decimal, written exactly."""
    denominator = int(value.q)
    exponent = 0
    while denominator % 10 == 0:
        denominator //= 10
        exponent -= 1
    numerator = int(value.p)
    while denominator != 1:
        factor = 2 if denominator % 5 == 0 else 5
        assert denominator % 2 == 0 or denominator % 5 == 0
        numerator, denominator, exponent = numerator * factor, denominator * factor // 10, exponent - 1
    return plain(numerator, exponent)


def plain(integer, exponent):
    """integer * 10^exponent in the grammar of scene files: plain when short, else with an exponent."""
    if integer == 0:
        return "0"
    sign, digits = ("-", str(-integer)) if integer < 0 else ("", str(integer))
    stripped = digits.rstrip("0")
    exponent += len(digits) - len(stripped)
    leading = exponent + len(stripped) - 1
    if 0 <= exponent and leading < 7:
        return sign + stripped + "0" * exponent
    if -5 < leading < 7:
        point = len(stripped) + exponent
        return sign + (stripped[:point] + "." + stripped[point:] if point > 0 else "0." + "0" * -point + stripped)
    return f"{sign}{stripped[0]}{'.' if stripped[1:] else ''}{stripped[1:]}e{leading}"
