"""Synthetic records of velocity steps with known parameters, by an integration that shares no code with slipmode.

    python3 tests/independent/fit/records.py FOLDER [--records N] [--seed N] [--jobs N]

FOLDER gets one CSV file per record and manifest.json with the true parameters, the options for `slipmode fit` and the kind of
each record. The same seed gives the same files with the same versions of numpy and SciPy. Record i does not depend on N.

A record must determine what is fitted from it. The Fisher information at the true parameters gives the expected standard errors of
ln a, ln b, ln D_c and ln K. If one exceeds LARGEST_ERROR, K is given instead of fitted; if one still does, the parameters are drawn
again. This choice does not look at the noise, so it leaves the coverage of intervals unchanged.
"""

import argparse
import csv
import json
import sys
from functools import partial
from itertools import pairwise
from math import exp, log, pi, sqrt
from multiprocessing import Pool
from pathlib import Path

import numpy as np

from model import NAMES, Drive, Failed, Parameters, Record
from optimum import LOGARITHMIC, Problem

LARGEST_ERROR = 0.15  # Of the logarithm of a parameter that is fitted.
NOISE_CLASSES = ((0.5, "0.1-0.5 %"), (2.0, "0.5-2 %"), (5.0, "2-5 %"))
NEAR = 3.0  # Displacement (D_c) with the full sampling after a step. Afterwards, there are 1 to 8 points per D_c.
TRIES = 200


def between(random, low, high):
    """Uniform in the logarithm."""
    return exp(random.uniform(log(low), log(high)))


def velocities(random):
    """One to three steps by factors of 3 to 30, up and down; the first may be either."""
    found = [between(random, 1e-7, 1e-5)]
    for _ in range(random.integers(1, 4)):
        factor = between(random, 3, 30)
        up = found[-1] / found[0] < 5 and (found[-1] / found[0] < 0.2 or random.random() < 0.5)
        found.append(found[-1] * factor if up else found[-1] / factor)
    return found


def slider(random, index, fastest):
    """Parameters of record `index`, and K as a multiple of the reference stiffness, and eta at the highest velocity."""
    a, sigma, d_c = between(random, 0.002, 0.02), between(random, 1e5, 2e7), between(random, 1e-6, 1e-4)
    b = a * random.uniform(0.3, 1.8)
    inertia = between(random, 1e-8, 1.0) if index // 2 % 2 else 0.0
    stiffness = between(random, 1.3, 100.0)
    reference = max(b - a, 0.2 * a) * sigma / d_c * (1 + inertia)  # K_c, or a stiffness of that order if b - a < 0.2 a.
    mass = inertia * a * sigma * d_c / fastest**2
    law = ("aging", "slip")[index % 2]
    found = Parameters(a, b, d_c, stiffness * reference, random.uniform(0.4, 0.8), 0.0, mass, law)
    return found, sigma, stiffness, inertia


def decay_distance(p, sigma, velocity):
    """Displacement over which a small disturbance of steady sliding falls by e."""
    if p.mass:
        h, k = p.mass * velocity**2 / (sigma * p.d_c), p.k * p.d_c / sigma
        roots = np.roots([h, h + p.a, p.a + k - p.b, k])
    else:
        k = p.k * p.d_c / sigma
        roots = np.roots([p.a, p.a + k - p.b, k])
    slowest = max(root.real for root in roots)
    if slowest >= 0:
        raise Failed("steady sliding is unstable")
    return p.d_c / -slowest


def spacings(p, sigma, velocity, points, far):
    """Displacements between rows after a step: fine near the step, growing afterwards."""
    length = min(max(8 * decay_distance(p, sigma, velocity), 15 * p.d_c), 80 * p.d_c)
    fine = p.d_c / points
    coarse = max(fine, p.d_c / far)
    found, reached = [], 0.0
    while reached < length:
        step = fine if reached < NEAR * p.d_c else min(found[-1] * 1.03, coarse)
        found.append(step)
        reached += step
    return found


def drive(random, p, sigma, steps, points):
    """Times, velocities and normal stresses of the rows: steady sliding, then each step."""
    far = between(random, 1, 8)
    moves = [(steps[0], [p.d_c / min(points, 20.0)] * 30)] + [(v, spacings(p, sigma, v, points, far)) for v in steps[1:]]
    velocity = np.concatenate([np.full(len(rows), v) for v, rows in moves] + [[steps[-1]]])
    distance = np.concatenate([rows for _, rows in moves])
    time = np.concatenate([[0.0], np.cumsum(distance / velocity[:-1])])
    normal_stress = np.full(len(time), sigma)
    if random.random() < 0.15:
        blocks = np.array_split(np.arange(30, len(time)), 8)
        for rows in blocks[1:]:
            normal_stress[rows] = sigma * (1 + random.uniform(-0.01, 0.01))
    return Drive(time, velocity, normal_stress)


def resolves_stiffness(p, sigma, fastest, points):
    """Whether rows resolve the elastic loading after a step and, with mass, the vibration."""
    loading = p.a * sigma / p.k
    wave = 2 * pi * fastest * sqrt(p.mass / p.k)
    spacing = p.d_c / points
    return loading > 2 * spacing and (wave == 0 or wave > 6 * spacing or p.k * p.mass * fastest**2 < 0.05 * (p.a * sigma) ** 2)


def expected_errors(p, ideal, names, deviation):
    """Standard errors of the logarithms of a, b, D_c and, if it is fitted, K, from the Fisher information."""
    problem = Problem(ideal, p, names)
    slopes = problem.derivatives(problem.vector(p)) / deviation
    covariance = np.linalg.inv(slopes.T @ slopes)
    return {name: float(sqrt(covariance[i, i])) for i, name in enumerate(names) if name in LOGARITHMIC}


def chosen(p, ideal, deviation, has_drift, may_fit_stiffness):
    """Names that are fitted and their expected errors; none if the record does not determine them."""
    for fits_stiffness in (True, False) if may_fit_stiffness else (False,):
        left_out = {"k": not fits_stiffness, "drift": not has_drift}
        names = [name for name in NAMES if not left_out.get(name, False)]
        errors = expected_errors(p, ideal, names, deviation)
        if max(errors.values()) <= LARGEST_ERROR:
            return names, errors
    return None


def attempt(random, index):
    """One draw: parameters, record with noise, and its entry in the manifest; none if it does not determine the parameters."""
    steps = velocities(random)
    fastest = max(steps)
    p, sigma, stiffness, inertia = slider(random, index, fastest)
    points = between(random, 5, 500)
    imposed = drive(random, p, sigma, steps, points)
    has_drift, is_stress, wants_stiffness = random.random() < 0.2, random.random() < 0.5, random.random() < 0.6
    if has_drift:
        p = p.of(drift=random.uniform(-1, 1) * p.a / imposed.displacement[-1])
    noise = between(random, 0.1, 5.0)
    largest = max(abs(log(after / before)) for before, after in pairwise(steps))
    deviation = noise / 100 * p.a * largest * (sigma if is_stress else 1.0)
    ideal = Record(imposed, np.zeros(len(imposed.time)), is_stress)
    found = chosen(p, ideal, deviation, has_drift, wants_stiffness and resolves_stiffness(p, sigma, fastest, points))
    if found is None:
        return None
    names, errors = found
    observed = ideal.modelled(p) + random.normal(0.0, deviation, len(imposed.time))
    kind = {
        "law": p.law,
        "mass": bool(p.mass),
        "noise_percent": noise,
        "noise_class": next(name for most, name in NOISE_CLASSES if noise <= most),
        "points_per_slip_distance": points,
        "stiffness_ratio": stiffness,
        "inertial_parameter": inertia,
        "steps": len(steps) - 1,
        "fits_stiffness": "k" in names,
        "drift": has_drift,
        "rows": len(observed),
        "expected_errors": {NAMES[name]: error for name, error in errors.items()},
    }
    return p, Record(imposed, observed, is_stress), names, kind


def table(random, record):
    """The columns of the file."""
    imposed = record.drive
    load = {"load_point_velocity_m_per_s": imposed.velocity}
    if random.random() < 0.5:
        load = {"load_point_displacement_m": imposed.displacement}
    columns = {"time_s": imposed.time, **load, "shear_stress_pa" if record.is_stress else "friction": record.observed}
    varies = len(set(imposed.normal_stress)) > 1
    if varies or random.random() < 0.2:
        columns["normal_stress_pa"] = imposed.normal_stress
    return columns


def options(p, names, columns, sigma):
    """Options of `slipmode fit` for this record."""
    found = ["--law", p.law]
    found += [] if "normal_stress_pa" in columns else ["--normal-stress-pa", repr(float(sigma))]
    found += [] if "k" in names else ["--stiffness-pa-per-m", repr(p.k)]
    found += ["--mass-per-area-kg-per-m2", repr(p.mass)] if p.mass else []
    return found + (["--drift"] if "drift" in names else [])


def write(folder, seed, index):
    """Writes one record and returns its entry."""
    random = np.random.default_rng([seed, index])
    for redrawn in range(TRIES):
        try:
            found = attempt(random, index)
        except (Failed, np.linalg.LinAlgError):
            found = None
        if found:
            break
    else:
        raise Failed(f"record {index}: no draw of {TRIES} determines its parameters")
    p, record, names, kind = found
    columns = table(random, record)
    name = f"{index:04}.csv"
    with open(folder / name, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in zip(*columns.values()))
    truth = {NAMES[name]: getattr(p, name) for name in NAMES if name != "drift" or p.drift}
    fitted = [NAMES[name] for name in names]
    given = options(p, names, columns, record.drive.normal_stress[0])
    return {"file": name, "options": given, "truth": truth, "fitted": fitted, **kind, "redrawn": redrawn}


def main():
    given = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    given.add_argument("folder", type=Path)
    given.add_argument("--records", type=int, default=500)
    given.add_argument("--seed", type=int, default=1)
    given.add_argument("--jobs", type=int, default=2)
    given = given.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    with Pool(given.jobs) as pool:
        entries = pool.map(partial(write, given.folder, given.seed), range(given.records), chunksize=1)
    (given.folder / "manifest.json").write_text(json.dumps({"seed": given.seed, "records": entries}, indent=1) + "\n")
    print(f"{len(entries)} records, {sum(one['redrawn'] for one in entries)} draws rejected")


if __name__ == "__main__":
    sys.exit(main())
