"""heyoka: two hundred samples where nothing is stiff, by its Taylor method; compiling the integrator is not timed.

exp(-x) is written as a function of its own and as 1/exp(x). A set of runs goes through the scalar integrator in turn, and through
the integrator of eight lanes, eight runs at a time.
"""

import heyoka
import numpy
from common import TOLERANCES, best_of, main, model_lines, row

SAMPLES = 200
LANES = 8
FORMS = {"heyoka-taylor": "exp(-x)=1/exp(x)", "heyoka-taylor-exp": "exp(-x)~as~a~function"}


def equations(law, form):
    """The slider in x, y and zeta; eta, kappa and beta are parameters of the run."""
    x, y, z = heyoka.make_vars("x", "y", "z")
    eta, kappa, beta = (heyoka.par[i] for i in range(3))
    u = heyoka.exp(x)
    force = z - x - beta * y
    acceleration = force / (u * eta) if form == "heyoka-taylor" else force * heyoka.exp(-x) / eta
    evolution = heyoka.exp(-y) - u if law == "aging" else -u * (x + y)
    return [(x, acceleration), (y, evolution), (z, kappa * (1.0 - u))]


def samples_of(integrator, numbers):
    """A run of the scalar integrator: its samples."""
    integrator.time = 0.0
    integrator.state[:] = numbers[3:6]
    integrator.pars[:] = numbers[:3]
    return integrator.propagate_grid(numpy.linspace(0.0, numbers[6], SAMPLES + 1))[-1]


def error_of(samples, end):
    """The largest error of the last sample; None when the run did not get there."""
    return float(numpy.abs(samples[-1] - end).max()) if samples.shape == (SAMPLES + 1, 3) else None


def smooth(_):
    """Every case at every tolerance."""
    lines = list(model_lines("smooth.txt"))
    for law in sorted({law for _, law, _ in lines}):
        for form, words in FORMS.items():
            for tolerance in TOLERANCES:
                integrator = heyoka.taylor_adaptive(equations(law, form), [0.0] * 3, tol=tolerance)
                for name, _, numbers in (line for line in lines if line[1] == law):
                    seconds, samples = best_of(9, lambda: samples_of(integrator, numbers))
                    error = error_of(samples, numbers[7:10])
                    row(f"smooth-{name}", form, words, 1, seconds, error, int(error is None), tolerance)


def samples_of_lanes(integrator, lanes):
    """Eight runs at once: their samples, run by run."""
    integrator.set_time(0.0)
    integrator.state[:] = lanes[:, 3:6].T
    integrator.pars[:] = lanes[:, :3].T
    grid = numpy.linspace(0.0, 1.0, SAMPLES + 1)[:, None] * lanes[:, 6]
    return numpy.moveaxis(integrator.propagate_grid(grid)[1], 2, 0)


def throughput(_):
    """Each set of runs, one at a time and in lanes."""
    lines = list(model_lines("throughput.txt"))
    for name in dict.fromkeys(name for name, _, _ in lines):
        law = next(law for other, law, _ in lines if other == name)
        runs = numpy.array([numbers for other, _, numbers in lines if other == name])
        lanes = runs.reshape(-1, LANES, runs.shape[1])
        for tolerance in TOLERANCES:
            scalar = heyoka.taylor_adaptive(equations(law, "heyoka-taylor"), [0.0] * 3, tol=tolerance)
            batch = heyoka.taylor_adaptive_batch(
                equations(law, "heyoka-taylor"), numpy.zeros((3, LANES)), tol=tolerance, force_avx512=True
            )
            ways = {
                "heyoka-taylor": ("one~run~at~a~time", lambda: [samples_of(scalar, run) for run in runs]),
                "heyoka-taylor-batch": (
                    "8~lanes;force_avx512",
                    lambda: [run for eight in lanes for run in samples_of_lanes(batch, eight)],
                ),
            }
            for method, (options, work) in ways.items():
                seconds, found = best_of(5, work)
                errors = [error_of(samples, run[7:10]) for samples, run in zip(found, runs)]
                failed = sum(error is None or not numpy.isfinite(error) for error in errors)
                worst = max((error for error in errors if error is not None), default=None)
                work_name = f"throughput-{name}"
                row(work_name, method, options, len(runs), seconds, worst, failed, tolerance)


main({"smooth": smooth, "throughput": throughput}, f"heyoka {heyoka.__version__}")
