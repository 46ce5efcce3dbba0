"""heyoka: two hundred samples where nothing is stiff, by its Taylor method; compiling the integrator is not timed."""

import heyoka
import numpy
from common import best_of, main, model_lines, row

SAMPLES = 200


def equations(law, eta, kappa, beta):
    """The slider in x, y and zeta."""
    x, y, z = heyoka.make_vars("x", "y", "z")
    u = heyoka.exp(x)
    evolution = heyoka.exp(-y) - u if law == "aging" else -u * (x + y)
    return [(x, (z - x - beta * y) * heyoka.exp(-x) / eta), (y, evolution), (z, kappa * (1.0 - u))]


def smooth(_):
    """Every case at every tolerance."""
    for name, law, numbers in model_lines("smooth.txt"):
        start, until, end = numbers[3:6], numbers[6], numpy.array(numbers[7:10])
        times = numpy.linspace(0.0, until, SAMPLES + 1)
        for exponent in range(3, 17):
            integrator = heyoka.taylor_adaptive(equations(law, *numbers[:3]), start, tol=10.0**-exponent)

            def run():
                integrator.time = 0.0
                integrator.state[:] = start
                return integrator.propagate_grid(times)[-1]

            seconds, samples = best_of(9, run)
            finished = samples.shape == (SAMPLES + 1, 3)
            error = float(numpy.abs(samples[-1] - end).max()) if finished else None
            row(f"smooth-{name}", "heyoka-taylor", 1, seconds, error, int(not finished), 10.0**-exponent)


main({"smooth": smooth}, f"heyoka {heyoka.__version__}")
