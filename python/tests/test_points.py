"""Arrays of points: the same as the rows of the command line, at a comparable speed."""

import csv
import os
import signal
import subprocess
import sys
import threading
import time
from decimal import Decimal

import numpy as np
import pytest
import slipmode

#: Points of the comparison; the whole of it takes 1 000 000.
POINTS = int(os.environ.get("SLIPMODE_TEST_POINTS", "20000"))
VALUES = {"a": "0.009", "b": "0.0126", "d_c": "8e-6", "k": "2e9", "m": "2400"}
SLIDER = slipmode.Slider(**VALUES)
COLUMNS = "a,b,d_c,k,m,sigma,v0"


def random_points(count: int) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(1)
    return 10 ** random.uniform(3, 9, count), 10 ** random.uniform(-8, 1, count)


def rows_of_command_line(folder, stresses, velocities):
    """Classify the points by ``slipmode classify --points``; a binary number is written with all digits of its exact value."""
    points, found = folder / "points.csv", folder / "found.csv"
    slider = ",".join(VALUES.values())
    with points.open("w") as stream:
        stream.write(COLUMNS + "\n")
        for stress, velocity in zip(stresses.tolist(), velocities.tolist()):
            stream.write(f"{slider},{Decimal(stress)},{Decimal(velocity)}\n")
    command = [sys.executable, "-m", "slipmode", "classify", "--points", points, "-o", found]
    subprocess.run(command, check=True, capture_output=True)
    with found.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: [row[name] for row in rows] for name in rows[0]}


def test_arrays_are_bit_for_bit_the_rows_of_the_command_line(tmp_path):
    stresses, velocities = random_points(POINTS)
    # On the transition, one neighbour away from it, and at the ends of the allowed range.
    edge = np.array([np.nextafter(5e6, 0), 5e6, 2e-300, 9e299, 1e-290, 1e290])
    stresses, velocities = np.append(stresses, edge), np.append(velocities, edge[::-1])
    ours = SLIDER.classify(stresses, velocities)
    rows = rows_of_command_line(tmp_path, stresses, velocities)
    assert ours.transition_sign.tolist() == [int(text) for text in rows["transition_sign"]]
    assert ours.boundary_sign.tolist() == [int(text) for text in rows["boundary_sign"]]
    assert np.asarray(ours.spectral_class).tolist() == rows["spectral_class"]
    assert np.asarray(ours.slip_mode).tolist() == rows["slip_mode"]
    results = ours.results()
    assert [*results, "undecided_share"] == list(rows)[len(COLUMNS.split(",")) :] and set(rows["undecided_share"]) == {"0"}
    assert np.asarray(results["rung"]).tolist() == rows["rung"]
    assert np.array_equal(results["frequency_hz"], ours.frequency, equal_nan=True)
    for column in ("critical_stiffness_pa_per_m", "stiffness_over_critical", "frequency_hz", "frequency_over_natural"):
        theirs = [float(text) if text else None for text in rows[column]]
        assert [None if x != x else x for x in results[column].tolist()] == theirs
    for column, numbers in (("max_real_per_s", ours.growth_rate), ("max_imaginary_per_s", ours.angular_frequency)):
        theirs, beyond = np.array([float(text) for text in rows[column]]), np.isnan(numbers)
        assert beyond.sum() <= len(edge)
        assert np.array_equal(numbers[~beyond].view(np.int64), theirs[~beyond].view(np.int64))
        least = np.finfo(np.float64).smallest_normal
        assert np.all(np.isinf(theirs[beyond]) | (np.abs(theirs[beyond]) < least)), "NaN: beyond 64-bit numbers only"


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_the_exact_transition_is_neutral_and_next_to_it_is_not():
    # a = 1, b = 2, D_c = 1, M = 1: K_c = (1 + V0²/σ)·σ = 2 at σ = 1, V0 = 1.
    slider = slipmode.Slider(a=1, b=2, d_c=1, k=2, m=1)
    found = slider.classify(np.array([1.0, np.nextafter(1, 2), np.nextafter(1, 0)]), 1.0)
    assert found.transition_sign.tolist() == [0, -1, 1]
    assert found.slip_mode[0] == "neutral" and found.spectral_class[0] == "neutral"
    assert found.transition_sign.dtype == np.int8


def test_inputs_broadcast_and_a_point_is_its_entry():
    stresses, velocities = np.array([[1e5], [5e6]]), np.array([1e-6, 1e-5, 1e-3])
    found = SLIDER.classify(stresses, velocities)
    assert found.shape == (2, 3)
    one = SLIDER.classify(5e6, 1e-5)
    assert (one.slip_mode, one.growth_rate) == (found.slip_mode[1, 1], found.growth_rate[1, 1])
    assert one.frequency == found.frequency[1, 1]
    assert SLIDER.classify(np.array([]), 1e-5).shape == (0,)


def test_a_bad_point_is_named_with_its_index():
    stresses = np.full(5000, 1e6)
    stresses[4321] = -1
    with pytest.raises(slipmode.InputError, match=r"^sigma\[4321\] = -1e0: must be > 0 \(allowed: 1e-300 to"):
        SLIDER.classify(stresses, 1e-5)
    with pytest.raises(slipmode.InputError, match="^v = NaN: out of range"):
        SLIDER.classify(np.array([1e6]), np.nan)


def test_another_thread_runs_meanwhile():
    stresses, velocities = random_points(200_000)
    counts, done = [0], threading.Event()

    def count() -> None:
        while not done.is_set():
            counts[0] += 1

    other = threading.Thread(target=count)
    other.start()
    before = counts[0]
    SLIDER.classify(stresses, velocities)
    meanwhile = counts[0] - before
    done.set()
    other.join()
    assert meanwhile > 10_000


#: On the transition every row needs exact arithmetic; a run takes milliseconds.
ONE = dict(zip(("a", "b", "d_c", "k", "m", "v"), (1.0, 2.0, 1.0, 2.0, 1.0, 1.0)))
LONG = {
    "classify": lambda: slipmode.classify(**ONE, sigma=np.full(3_000_000, 1.0)),
    "simulate": lambda: slipmode.simulate(**ONE, sigma=np.full(100_000, 1.0), law="slip"),
    "map": lambda: [SLIDER.map(("10kPa", "100MPa", 2000), ("0.1um/s", "10cm/s", 2000)) for _ in range(20)],
    "errors": lambda: slipmode.classify({**ONE, "sigma": np.full(10**6, 1.0), "a_err": np.full(10**6, 0.1)}),
    "compare": lambda: slipmode.compare([ONE | {"sigma": 1.0, "peak_velocity_m_per_s": 2.0}] * 20_000, law="slip"),
}


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("work", LONG)
def test_control_c_ends_long_work(work):
    sent, done = [], threading.Event()

    def interrupt():
        # The interpreter loses one that comes during a callback, such as that of a weak set: then there is another one.
        for pause in (0.5, 1.5):
            if not done.wait(pause):
                sent.append(time.monotonic())
                os.kill(os.getpid(), signal.SIGINT)

    other = threading.Thread(target=interrupt)
    other.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            LONG[work]()
        ended = time.monotonic()
    finally:
        done.set()
        other.join()
    # 0.2 s on a machine that does nothing else.
    assert ended - sent[-1] < 1.0


def test_frames_have_the_names_of_the_command_line():
    pandas = pytest.importorskip("pandas")
    found = SLIDER.classify(np.array([[1e5], [5e6]]), np.array([1e-6, 1e-5, 1e-3]))
    frame = found.to_dataframe()
    assert len(frame) == 6 and isinstance(frame["slip_mode"].dtype, pandas.CategoricalDtype)
    assert frame["slip_mode"].tolist() == np.asarray(found.slip_mode).ravel().tolist()
    data = found.to_xarray()
    assert data["transition_sign"].dims == ("normal_stress_pa", "loading_velocity_m_per_s")
    assert data["loading_velocity_m_per_s"].values.tolist() == [1e-6, 1e-5, 1e-3]
