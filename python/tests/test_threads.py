"""Several threads of Python at once: the same answers, and no lock of Python where the interpreter has none."""

import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import numpy as np
import slipmode

THREADS = 4
SLIDER = slipmode.Slider(a="0.009", b="0.0126", d_c="8um", k="2MPa/mm", m="12kg/50cm2")
STRESSES = 10 ** np.random.default_rng(7).uniform(5, 8, 5000)


def answers():
    """Ask every kind of question: arrays, points, commands, and objects that all threads share."""
    rows = SLIDER.classify(STRESSES, 1e-5)
    points = [(point.slip_mode, point.growth_rate) for point in (SLIDER.classify(stress, 1e-5) for stress in STRESSES[:300].tolist())]
    roots = SLIDER.roots(STRESSES, "10um/s").tobytes()
    curve = SLIDER.boundary(n=5)["normal_stress_pa"].tolist()
    run = SLIDER.simulate("5MPa", "10um/s", law="slip", rtol="1e-4").peak_velocity
    return rows.growth_rate.tobytes(), rows.slip_mode.codes.tobytes(), points, roots, curve, run, rows[17].details


def test_threads_that_ask_at_once_get_the_same_answers():
    alone, start = answers(), Barrier(THREADS)

    def together(_):
        start.wait()
        return [answers() for _ in range(3)]

    with ThreadPoolExecutor(THREADS) as pool:
        assert all(each == alone for found in pool.map(together, range(THREADS)) for each in found)


def test_the_module_does_not_bring_the_lock_of_python_back():
    if sysconfig.get_config_var("Py_GIL_DISABLED"):
        assert not sys._is_gil_enabled()
