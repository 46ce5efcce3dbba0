"""Makes the example of `slipmode compare`: runs of a spring-slider by SciPy's Radau method, which shares no code with slipmode.

The equations are eqs 1 to 4 of the paper with x = ln(V/V_l), y = ln(theta V_l/D_c) and the spring's stress above that of
steady sliding, z in Pa. Run it in this folder: `python3 make.py` (written with Python 3 and SciPy 1.17.1).
"""

import csv
import math

import numpy
from scipy.integrate import solve_ivp

A, B, D, K, M = 0.004, 0.006, 1e-5, 1e7, 1000.0
HEADER = [
    "direct_effect", "evolution_effect", "critical_slip_distance_m", "stiffness_pa_per_m", "mass_per_area_kg_per_m2",
    "normal_stress_pa", "loading_velocity_m_per_s", "law", "mode", "peak_velocity_m_per_s", "period_s",
    "stress_drop_pa", "frequency_hz", "trajectory",
]


def solve(stress, loading, law, until, times=None):
    """Runs from steady sliding at V_l/10."""

    def rate(_, state):
        x, y, z = state
        velocity = loading * math.exp(x)
        friction = stress * (A * x + B * y)
        if law == "slip":
            y_rate = -velocity / D * (x + y)
        else:
            y_rate = math.exp(-y) * loading / D - velocity / D
        return [(z - friction) / (M * velocity), y_rate, K * (loading - velocity)]

    x = -math.log(10.0)
    start = [x, -x, stress * (A * x - B * x)]
    passage = lambda _, state: state[0]
    passage.direction = 1
    return solve_ivp(rate, (0.0, until), start, method="Radau", rtol=1e-9, atol=[1e-11, 1e-11, 1e-9 * A * stress],
                     t_eval=times, dense_output=True, events=passage)


def last_cycle(run, loading):
    """Peak, period and stress drop between the last two upward passages of V_l, from 20 000 points of the dense output."""
    begin, end = run.t_events[0][-2:]
    states = run.sol(numpy.linspace(begin, end, 20001))
    return loading * math.exp(states[0].max()), end - begin, states[2].max() - states[2].min()


def main():
    rows = []
    slider = [A, B, D, K, M]
    # A limit cycle, given as its trajectory: 300 samples a period, ten periods.
    times = numpy.linspace(0.0, 2.6, 3001)
    run = solve(1e5, 1e-3, "slip", 2.6, times)
    with open("stick-slip.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["time_s", "velocity_m_per_s", "shear_stress_pa"])
        for time, x, z in zip(times, run.y[0], run.y[2]):
            writer.writerow([f"{time:.9g}", f"{1e-3 * math.exp(x):.9g}", f"{z:.9g}"])
    rows.append([*slider, "1e5", "1e-3", "slip", "stick-slip", "", "", "", "", "stick-slip.csv"])
    # The same slider under the aging law, given by its numbers.
    run = solve(1e5, 1e-3, "aging", 6.0)
    peak, period, drop = last_cycle(run, 1e-3)
    rows.append([*slider, "1e5", "1e-3", "aging", "periodic", f"{peak:.7g}", f"{period:.7g}", f"{drop:.7g}", "", ""])
    # Below the critical normal stress: a decaying oscillation, given by its frequency.
    run = solve(1e4, 1e-5, "aging", 100.0)
    passages = run.t_events[0]
    rows.append([*slider, "1e4", "1e-5", "aging", "decaying", "", "", "", f"{1 / (passages[5] - passages[4]):.7g}", ""])
    with open("runs.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows(rows)


if __name__ == "__main__":
    main()
