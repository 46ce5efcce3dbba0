"""The transitions that the report on friction laws states, against cycles by harmonic balance: nothing of slipmode is used here."""

import re
from pathlib import Path

import numpy as np
import pytest

EQUATIONS = Path(__file__).parents[2] / "reports" / "friction-laws" / "equations.toml"

#: Points a law, and harmonics of a cycle.
POINTS, HARMONICS = 20, 8


def log_friction(x, y, at):
    return x + (1 + at["w"] ** 2) * y


def saturating(x, y, at):
    """The direct effect saturates above the velocity r."""
    direct = -(1 + at["r"]) / at["r"] * np.log1p((np.exp(-x) - 1) * at["r"] / (1 + at["r"]))
    return direct + (1 + at["w"] ** 2) * y


def fading(x, y, at):
    """Contacts have an age of q cut-offs in steady sliding."""
    return x + (1 + at["w"] ** 2) * (1 + at["q"]) / at["q"] * np.log1p((np.exp(y) - 1) * at["q"] / (1 + at["q"]))


def regularised(x, y, at):
    """asinh(p exp(z)), p = sinh h, from steady sliding on and over its slope there."""
    p = 1 / at["k"] - 1
    argument = np.sqrt(p) * np.exp(x + (1 + at["w"] ** 2) * y)
    # NumPy has no asinh of complex numbers next to the real axis that keeps a small imaginary part.
    return (np.log(argument + np.sqrt(argument**2 + 1)) - np.arcsinh(np.sqrt(p))) * np.sqrt((1 + p) / p)


def spanning(x, y, at):
    """(Ω^(1−ε) − Ω)/ε with Ω = exp(x + y), over exp(y)."""
    omega = np.exp(x + y)
    return (omega ** (1 - at["epsilon"]) - omega) / (at["epsilon"] * np.exp(y))


def aging(x, y, at):
    return np.exp(-y) - np.exp(x)


def slip(x, y, at):
    return -np.exp(x) * (x + y)


def any_friction(x, y, at):
    return x + at["h_2"] * x**2 / 2 + at["h_3"] * x**3 / 6 + (1 + at["w"] ** 2) * y


def any_rate(x, y, at):
    square = at["g_20"] * x**2 / 2 + at["g_11"] * x * y + at["g_02"] * y**2 / 2
    cubes = [at["g_30"] * x**3 / 6, at["g_21"] * x**2 * y / 2, at["g_12"] * x * y**2 / 2, at["g_03"] * y**3 / 6]
    return -x - y + square + sum(cubes)


#: Slopes of second and third order.
SLOPES = ("h_2", "h_3", "g_20", "g_11", "g_02", "g_30", "g_21", "g_12", "g_03")

#: By the name of the system: friction and the rate of the state.
LAWS = {
    "any_law": (any_friction, any_rate),
    "spanning": (log_friction, spanning),
    "fading_aging": (fading, aging),
    "fading_slip": (fading, slip),
    "regularised_aging": (regularised, aging),
    "regularised_slip": (regularised, slip),
    "saturating_aging": (saturating, aging),
    "saturating_slip": (saturating, slip),
}


def cycle_stiffness(law, at, amplitude):
    """The stiffness at which a cycle has this amplitude of ln(v/V) in its first harmonic, by Fourier collocation and Newton's method."""
    friction, rate = LAWS[law]
    w, eta = at["w"], at["eta"]
    count = 4 * HARMONICS
    phase = 2 * np.pi * np.arange(count) / count
    waves = np.fft.fftfreq(count, 1 / count)
    waves = np.where(np.abs(waves) < count / 2, 1j * waves, 0)
    slope = np.fft.ifft(np.fft.fft(np.eye(count), axis=0) * waves[:, None], axis=0).real
    linear = [1, -(1 - 1j * w) / (1 + w * w), 1j * w * (1 + eta)]
    start = [(amplitude * part * np.exp(1j * phase)).real for part in linear]

    def rest(values):
        x, y, force = values[: 3 * count].reshape(3, count)
        frequency, stiffness = values[3 * count :]
        return np.concatenate(
            [
                frequency * (slope @ x) * eta * np.exp(x) - (force - friction(x, y, at)),
                frequency * (slope @ y) - rate(x, y, at),
                frequency * (slope @ force) - stiffness * (1 - np.exp(x)),
                [np.cos(phase) @ x * 2 / count - amplitude, np.sin(phase) @ x * 2 / count],
            ]
        )

    values = np.concatenate([*start, [w, w * w * (1 + eta)]])
    for _ in range(30):
        # Derivatives by a step into the complex plane have the errors of rounding alone.
        columns = [rest(values + 1e-30j * unit).imag / 1e-30 for unit in np.eye(len(values))]
        step = np.linalg.lstsq(np.stack(columns, axis=1), -rest(values), rcond=None)[0]
        values = values + step
        if np.abs(step).max() < 1e-13:
            return values[-1]
    raise AssertionError(f"no cycle of {law} at {at}")


def stiffening(law, at):
    """(K/K_c − 1)/A² of small cycles by extrapolation of two amplitudes, with a bound of its error."""
    transition = at["w"] ** 2 * (1 + at["eta"])
    fine, coarse = [(cycle_stiffness(law, at, a) / transition - 1) / a**2 for a in (0.01, 0.02)]
    value = (4 * fine - coarse) / 3
    # Rounding by 1e-13 of K over A² = 1e-4, and the next order.
    return value, abs(value - fine) + 1e-9


def stated(law, at):
    """The report's N, minus which has the sign of the first Lyapunov coefficient."""
    text = EQUATIONS.read_text(encoding="utf-8")
    formulas = dict(re.findall(r'name = "([^"]+)"\nis = "([^"]+)"', text))
    formulas |= dict(re.findall(r'equation = "(\w+) = ([^"]+)"', text))

    def value(name):
        known = {one: value(one) for one in formulas if re.search(rf"\b{one}\b", formulas[name]) and one != name}
        return eval(formulas[name].replace("^", "**"), {}, {**at, **known})

    return value(f"N_{law}")


@pytest.mark.parametrize("law", LAWS)
def test_small_cycles_stand_where_the_report_says(law):
    random = np.random.default_rng(17)
    sides = []
    while len(sides) < POINTS:
        names = {"w": (0.2, 2), "eta": (1e-3, 3), "q": (0.5, 300), "r": (0.5, 300), "epsilon": (0.1, 1), "k": (0.01, 0.5)}
        at = {name: float(np.exp(random.uniform(*np.log(ends)))) for name, ends in names.items()}
        at |= {name: float(random.uniform(-2, 2)) for name in SLOPES}
        value, error = stiffening(law, at)
        if abs(value) > 3 * error:
            # A stable cycle stands below K_c, an unstable one above it.
            assert (value < 0) == (stated(law, at) > 0), (law, at, value, error)
            sides.append(value < 0)
    # A law that has both sides shows both; the slip law has the second one where w is small, and regularised beyond k = 1/2.
    assert len(set(sides)) == 2 or law in ("fading_slip", "regularised_slip")


def test_the_slip_law_with_a_cut_off_age_is_subcritical_where_friction_hardly_falls():
    at = {"w": 0.2, "eta": 1.0, "q": 0.5}
    value, error = stiffening("fading_slip", at)
    assert value > 3 * error and stated("fading_slip", at) < 0


def test_the_aging_law_with_a_cut_off_age_shows_the_order_of_experiments():
    # K = K_c along rising velocity at one normal stress: η rises as its square, the age of contacts over the cut-off falls.
    sides = [stiffening("fading_aging", {"w": 1.0, "eta": 0.02 * u * u, "q": 150 / u})[0] < 0 for u in (0.2, 1, 4)]
    assert sides == [True, False, True]
