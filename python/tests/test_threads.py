"""Several threads of Python at once: the same answers, and no lock of Python where the interpreter has none."""

import os
import subprocess
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import numpy as np
import pytest
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


#: A parent that has used all threads, and a child that asks the same questions.
FORKED = """
import os, sys
sys.path.insert(0, sys.argv[1])
from test_threads import answers, grid
before, ours = grid(), answers()
child = os.fork()
if child == 0:
    os._exit(0 if (grid(), answers()) == (before, ours) else 3)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""


def grid():
    """Ask questions that use all threads: a map, a range over error bars, and rows with errors."""
    cells = SLIDER.map(("10kPa", "100MPa", 60), ("1um/s", "1cm/s", 60)).growth_rate.tobytes()
    wide = SLIDER.replace(a="0.009±0.0001").simulate("5MPa", "10um/s", law="slip", rtol="1e-3").ranges
    return cells, wide


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes that fork")
def test_a_forked_child_has_the_answers_of_its_parent():
    program = [sys.executable, "-W", "ignore", "-c", FORKED, os.path.dirname(__file__)]
    assert subprocess.run(program, timeout=120).returncode == 0
