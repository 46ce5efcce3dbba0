"""The forward model of a record: a spring slider with one state variable, integrated by LSODA of SciPy.

It shares no code with slipmode. Variables are x = ln(V/V0), z = ln(theta V0/D_c) and q = (tau/sigma - mu_0)/a. Without mass,
q = x + (b/a) z, and two equations remain. The load-point velocity and the normal stress are constant within an interval.
"""

import csv
import warnings
from dataclasses import dataclass, field, replace
from math import exp

import numpy as np
from scipy.integrate import ODEintWarning, odeint

NAMES = {
    "a": "direct_effect",
    "b": "evolution_effect",
    "d_c": "critical_slip_distance_m",
    "k": "stiffness_pa_per_m",
    "mu_0": "reference_friction",
    "drift": "drift_per_m",
}
TOLERANCES = ((1e-11, 1e-12), (1e-10, 1e-11), (1e-9, 1e-10))  # Of the integration, relative and absolute, for logarithms of order one.
SAME = 1e-6  # Velocities from differences of displacements with rounding errors are equal within this relative difference.


class Failed(Exception):
    """The integration did not end, or a record cannot be read."""


@dataclass(frozen=True)
class Parameters:
    """a, b, D_c (m), K (Pa/m), friction at the first velocity, drift of friction (1/m), mass per area (kg/m2), law."""

    a: float
    b: float
    d_c: float
    k: float
    mu_0: float
    drift: float = 0.0
    mass: float = 0.0
    law: str = "aging"

    def of(self, **changed):
        return replace(self, **changed)


@dataclass(frozen=True)
class Drive:
    """What the laboratory imposes: times (s), load-point velocity (m/s) and normal stress (Pa) from each time on."""

    time: np.ndarray
    velocity: np.ndarray
    normal_stress: np.ndarray
    pieces: list = field(init=False)
    displacement: np.ndarray = field(init=False)

    def __post_init__(self):
        moved = np.concatenate([[0.0], np.cumsum(self.velocity[:-1] * np.diff(self.time))])
        object.__setattr__(self, "displacement", moved)
        object.__setattr__(self, "pieces", list(pieces(self.time, self.velocity, self.normal_stress)))


def pieces(time, velocity, normal_stress):
    """Ranges (first, last, mean velocity) in which velocity and normal stress are constant; the last row only ends one."""
    first, rows = 0, len(velocity)
    for row in range(1, rows):
        changes = abs(velocity[row] - velocity[first]) > SAME * abs(velocity[first]) or normal_stress[row] != normal_stress[first]
        if row == rows - 1 or changes:
            steps = np.diff(time[first : row + 1])
            yield first, row, float(velocity[first:row] @ steps / steps.sum())
            first = row


def slow(x, z, law):
    """dz/dt times D_c/V0."""
    return exp(-z) - exp(x) if law == "aging" else -exp(x) * (x + z)


def slopes_of(x, z, law):
    """Derivatives of `slow` by x and z."""
    v = exp(x)
    return (-v, -exp(-z)) if law == "aging" else (-v * (x + z + 1), -v)


def without_mass(p, rate, loading, drive):
    """Two equations for (x, z): `loading` is K/(sigma a), `rate` is V0/D_c."""
    law, ratio, v_0 = p.law, p.b / p.a, drive[0]
    relative = drive[1] / v_0

    def slope(y, _):
        x, z = y.tolist()
        dz = rate * slow(x, z, law)
        return loading * v_0 * (relative - exp(x)) - ratio * dz, dz

    def jacobian(y, _):
        x, z = y.tolist()
        by_x, by_z = slopes_of(x, z, law)
        return [[-loading * v_0 * exp(x) - ratio * rate * by_x, -ratio * rate * by_z], [rate * by_x, rate * by_z]]

    return slope, jacobian


def with_mass(p, rate, loading, drive, sigma):
    """Three equations for (x, z, q)."""
    law, ratio, v_0 = p.law, p.b / p.a, drive[0]
    relative, push = drive[1] / v_0, p.a * sigma / (p.mass * v_0)

    def slope(y, _):
        x, z, q = y.tolist()
        v = exp(x)
        return push * (q - x - ratio * z) / v, rate * slow(x, z, law), loading * v_0 * (relative - v)

    def jacobian(y, _):
        x, z, q = y.tolist()
        v = exp(x)
        by_x, by_z = slopes_of(x, z, law)
        net = push * (q - x - ratio * z) / v
        return [[-net - push / v, -push * ratio / v, push / v], [rate * by_x, rate * by_z, 0.0], [-loading * v_0 * v, 0.0, 0.0]]

    return slope, jacobian


def integrated(equations, start, times):
    """States at all times but the first, with the smallest of the tolerances that LSODA reaches: stiff motions limit it."""
    slope, jacobian = equations
    for relative, absolute in TOLERANCES:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ODEintWarning)
            try:
                found, report = odeint(
                    slope, start, times - times[0], Dfun=jacobian, rtol=relative, atol=absolute, mxstep=20000, full_output=True
                )
            except (OverflowError, ValueError) as error:
                raise Failed(str(error)) from error
        if report["message"] == "Integration successful." and np.all(np.isfinite(found)):
            return found[1:]
    raise Failed(report["message"])


def friction(p, drive):
    """Spring stress over normal stress at each row, drift included."""
    tau = np.empty(len(drive.time))
    tau[0] = drive.normal_stress[0] * p.mu_0
    x = z = 0.0
    v_0 = drive.pieces[0][2]
    rate, ratio = v_0 / p.d_c, p.b / p.a
    for first, last, velocity in drive.pieces:
        sigma = float(drive.normal_stress[first])
        q = float(tau[first] / sigma - p.mu_0) / p.a
        loading, both = p.k / (sigma * p.a), (v_0, velocity)
        times = drive.time[first : last + 1]
        if p.mass:
            states = integrated(with_mass(p, rate, loading, both, sigma), (x, z, q), times)
            x, z, q = states[-1]
            level = states[:, 2]
        else:
            states = integrated(without_mass(p, rate, loading, both), (q - ratio * z, z), times)
            x, z = states[-1]
            level = states[:, 0] + ratio * states[:, 1]
        tau[first + 1 : last + 1] = sigma * (p.mu_0 + p.a * level)
    return tau / drive.normal_stress + p.drift * drive.displacement


@dataclass(frozen=True)
class Record:
    """A file: what was imposed, what was observed, and whether that is the shear stress (else friction)."""

    drive: Drive
    observed: np.ndarray
    is_stress: bool

    def modelled(self, p):
        found = friction(p, self.drive)
        return found * self.drive.normal_stress if self.is_stress else found


def read(path, normal_stress_pa=None):
    """A record from its CSV file."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    time = columns["time_s"]
    if "load_point_velocity_m_per_s" in columns:
        velocity = columns["load_point_velocity_m_per_s"]
    else:
        slopes = np.diff(columns["load_point_displacement_m"]) / np.diff(time)
        velocity = np.append(slopes, slopes[-1])
    given = np.full(len(time), 1.0 if normal_stress_pa is None else normal_stress_pa)
    normal_stress = columns.get("normal_stress_pa", given)
    is_stress = "shear_stress_pa" in columns
    return Record(Drive(time, velocity, normal_stress), columns["shear_stress_pa" if is_stress else "friction"], is_stress)
