"""The slider: exact numbers, roots, boundary, inverse questions, simulations."""

import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import slipmode

SLIDER = slipmode.Slider(a="0.009", b="0.0126", d_c="8um", k="2MPa/mm", m="12kg/50cm2")


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_texts_decimals_and_fractions_are_exact_and_floats_binary():
    texts = slipmode.Slider(a="0.3", b="0.9", d_c="1", k="1", m="1")
    exact = slipmode.Slider(a=Decimal("0.3"), b=Fraction(9, 10), d_c=1, k=Decimal("1E+0"), m=1)
    floats = slipmode.Slider(a=0.3, b=0.9, d_c=1.0, k=1.0, m=1.0)
    ask = {"v": "0.1", "transition": True, "digits": 60}
    assert texts.solve("normal_stress", **ask) == exact.solve("normal_stress", **ask)
    assert texts.solve("normal_stress", **ask) != floats.solve("normal_stress", **ask)
    # K_c = (b − a)·(σ + M V0²/a): σ = K/(b − a) − M V0²/a, with the exact values of the binary numbers.
    a, b = Fraction(0.3), Fraction(0.9)
    wanted = 1 / (b - a) - Fraction("0.01") / a
    (found,) = floats.solve("normal_stress", **ask)
    assert abs(Fraction(found.value) - wanted) < Fraction(1, 10**58)
    third = slipmode.Slider(a=Fraction(1, 3), b=1, d_c=1, k=1, m=1)
    (found,) = third.solve("normal_stress", v="0.1", transition=True)
    assert found.value == Decimal("1.47") and found.is_exact


def test_bad_values_raise_the_messages_of_the_command_line():
    with pytest.raises(slipmode.InputError) as raised:
        slipmode.Slider(a="x", b=-1, d_c="8 Pa", k=1e301, m=1)
    lines = str(raised.value).splitlines()
    assert [line.split(" = ")[0] for line in lines] == ["a", "b", "d_c", "k"]
    with pytest.raises(slipmode.InputError, match="must be > 0"):
        SLIDER.roots(-1, 1e-5)
    with pytest.raises(slipmode.InputError, match="^sigma = NaN: out of range"):
        SLIDER.classify(float("nan"), 1e-5)
    with pytest.raises(ValueError, match="^law = slipp: unknown"):
        SLIDER.simulate(5e6, 1e-5, law="slipp")
    with pytest.raises(slipmode.InputError, match="^a = True: no number"):
        slipmode.Slider(a=True, b=1, d_c=1, k=1, m=1)
    with pytest.warns(slipmode.SlipmodeWarning, match="^sigma = 5: looks like MPa"):
        SLIDER.classify(5, 1e-5)


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_a_point_is_what_the_command_line_prints():
    random = np.random.default_rng(3)
    for decades in random.uniform([-3, -3, -6, 5, 1, 2, -8], [-1, -1, -3, 10, 5, 9, 0], (50, 7)):
        texts = [f"{10**decade:.5g}" for decade in decades]
        point = slipmode.Slider(**dict(zip(("a", "b", "d_c", "k", "m"), texts))).classify(*texts[5:])
        options = [f"-{letter}{text}" for letter, text in zip("abdkmsv", texts)]
        code, output, _ = slipmode._slipmode.call(["classify", *options, "--json"])
        printed = json.loads(output)
        assert code == 0 and point.details == printed
        fields = ("transition_sign", "boundary_sign", "spectral_class", "slip_mode")
        assert all(getattr(point, name) == printed[name] for name in fields)
        numbers = (point.growth_rate, point.angular_frequency, point.frequency)
        assert numbers == tuple(printed[name] for name in ("max_real_per_s", "max_imaginary_per_s", "frequency_hz"))
        assert pickle.loads(pickle.dumps(point)) == point != SLIDER.classify("5MPa", "10um/s")


def test_a_warning_names_the_line_that_called():
    table_top = slipmode.Slider(a="0.009", b="0.0126", d_c="8um", k="2MPa/mm", m="5")
    for call in (
        lambda: table_top.classify("5MPa", "10um/s"),
        lambda: table_top.map(("10kPa", "100MPa", 2), ("1um/s", "1cm/s", 2)),
    ):
        with pytest.warns(slipmode.SlipmodeWarning, match="looks like kg") as warned:
            call()
        assert {warning.filename for warning in warned} == {__file__}


def test_roots_have_the_digits_and_a_radius():
    roots = SLIDER.roots("5MPa", "10um/s", digits=80)
    assert len(roots) == 3 and all(len(root.re.as_tuple().digits) == 80 for root in roots)
    assert all(0 < root.radius < abs(root.re) * Decimal("1e-78") for root in roots)
    found = SLIDER.classify("5MPa", "10um/s")
    assert complex(roots[1]).real == found.growth_rate
    assert abs(complex(roots[1]).imag) == found.angular_frequency


def test_a_point_on_the_boundary_and_on_the_transition_is_one():
    boundary = SLIDER.boundary(n=7, digits=40)
    assert "<svg" in boundary.svg and boundary._repr_svg_() == boundary.svg
    stress, velocity = boundary["normal_stress_pa"], boundary["loading_velocity_m_per_s"]
    assert len(stress) > 14 and boundary["double_root"].dtype == object
    # The discriminant changes its sign across the boundary.
    near = [f"{Fraction(stress[2]) * (1 + Fraction(d))}" for d in ("-1e-30", "1e-30")]
    assert sorted(SLIDER.classify(text, velocity[2]).boundary_sign for text in near) == [-1, 1]
    transition = SLIDER.transition(np.array([1e-6, 1e-3]))
    for stress, velocity in zip(transition["normal_stress_pa"], transition["loading_velocity_m_per_s"]):
        around = SLIDER.classify(np.array([stress * (1 - 1e-12), stress * (1 + 1e-12)]), velocity)
        assert around.transition_sign.tolist() == [1, -1]
    assert len(SLIDER.transition()["normal_stress_pa"]) >= 50
    assert SLIDER.boundary(n=3)["relative_error"].dtype == np.float64


def test_on_the_line_of_a_frequency_ratio_the_pair_of_roots_has_it():
    line = SLIDER.boundary(n=9, frequency_ratio="0.6")
    assert list(line["transition_sign"]).count(0) == 1
    points = {"sigma": line["normal_stress_pa"], "v": line["loading_velocity_m_per_s"]}
    found = slipmode.roots(a="0.009", b="0.0126", d_c="8um", k="2MPa/mm", m="12kg/50cm2", **points)
    natural = np.sqrt(2e9 / (12 / 50e-4))
    assert np.abs(np.abs(found.imag).max(axis=-1) / natural - 0.6).max() < 1e-7
    # Through each point of the line the normal stress is a solution of the inverse question.
    middle = {name: float(column[4]) for name, column in points.items()}
    solutions = SLIDER.solve("sigma", v=middle["v"], frequency_ratio="0.6")
    assert min(abs(float(one.value) / middle["sigma"] - 1) for one in solutions) < 1e-9
    assert SLIDER.boundary(n=2, digits=30, frequency_ratio="0.6")["real_part"].dtype == object
    with pytest.raises(slipmode.InputError, match="frequency_ratio = 1"):
        SLIDER.boundary(frequency_ratio=1)


def test_a_solution_has_what_was_asked_for():
    (solution,) = SLIDER.solve("stiffness", sigma="5MPa", v="10um/s", transition=True)
    stiffness = {"d_c": "8um", "m": "12kg/50cm2", "a": "0.009", "b": "0.0126"}
    on_it = slipmode.Slider(k=solution.value, **stiffness)
    assert (solution.value, solution.is_exact) == (Decimal("2250001500"), True)
    assert on_it.classify("5MPa", "10um/s").transition_sign == 0
    for solution in SLIDER.solve("normal_stress", v="10um/s", frequency="0.1", digits=50):
        frequency = SLIDER.classify(solution.value, "10um/s").frequency
        assert abs(frequency - 0.1) <= np.spacing(0.1)
    with pytest.raises(slipmode.InputError):
        SLIDER.solve("stiffness", sigma="5MPa", v="10um/s")


def test_error_bars_give_what_is_possible():
    slider = slipmode.Slider(a="0.009±0.001", b="0.0126", d_c="8um", k="2MPa/mm", m="12kg/50cm2")
    found = slider.classify("5MPa", "10um/s")
    assert slider.is_uncertain and not found.certain and "stick-slip" in found.slip_modes
    for mode, witness in zip(found.slip_modes, found.witnesses):
        a, b, d_c, k, m, sigma, v = (witness[name] for name in NAMES)
        assert slipmode.Slider(a=a, b=b, d_c=d_c, k=k, m=m).classify(sigma, v).slip_mode == mode
    rows = slider.classify(np.array([5e6, 1e3]), "10um/s")
    assert rows["certain"].tolist() == [False, True] and rows["slip_modes"][0] == ";".join(found.slip_modes)
    assert [rows["frequency_hz_low"][0], rows["frequency_hz_high"][0]] == found.details["frequency_hz"]
    with pytest.raises(slipmode.InputError, match="error bars"):
        slider.tolerance("0.01")
    with pytest.raises(slipmode.InputError, match="`slipmode boundary`"):
        slider.boundary(n=2)
    for unsure, v in ((slider, "10um/s"), (SLIDER, "10±1um/s")):
        with pytest.raises(slipmode.InputError, match="`slipmode solve`"):
            unsure.solve("normal_stress", transition=True, v=v)


def test_error_bars_give_the_ranges_of_runs():
    values = {"a": "0.009", "d_c": "8um", "k": "1.5MPa/mm", "m": "2400"}
    slider = slipmode.Slider(b="0.0126±0.0004", **values)
    run = slider.simulate("5MPa", "10um/s", law="slip")
    middle = slipmode.Slider(b="0.0126", **values).simulate("5MPa", "10um/s", law="slip")
    assert middle.ranges is None and run.period == middle.period
    ends = [slipmode.Slider(b=b, **values).simulate("5MPa", "10um/s", law="slip").period for b in ("0.0122", "0.013")]
    low, high = run.ranges["period_s"]
    assert low == pytest.approx(ends[0].value, rel=1e-7) and high == pytest.approx(ends[1].value, rel=1e-7)
    assert low <= ends[0].value and ends[1].value <= high
    assert run.details["within_error_bars"]["strength"] == "sampled" and "sampled" in run._repr_html_()
    refusal = "without an error bar; .* `classify`"
    with pytest.raises(slipmode.InputError, match=refusal):
        slider.roots("5MPa", "10um/s")
    with pytest.raises(slipmode.InputError, match=refusal):
        slider.map(("1MPa", "2MPa", 3), ("1um/s", "2um/s", 3))
    pytest.importorskip("pandas")
    frame = slider.simulate(np.array([5e6]), 1e-5, law="slip").to_dataframe()
    assert [frame["period_s_low"][0], frame["period_s_high"][0]] == pytest.approx([low, high])


NAMES = [
    "direct_effect",
    "evolution_effect",
    "critical_slip_distance_m",
    "stiffness_pa_per_m",
    "mass_per_area_kg_per_m2",
    "normal_stress_pa",
    "loading_velocity_m_per_s",
]


def test_the_limits_of_a_range_may_be_floats():
    of_float, of_text = (SLIDER.simulate(1e7, 1e-5, law="slip", rtol=rtol) for rtol in (1e-2, "1e-2"))
    assert of_float.mode == of_text.mode
    assert SLIDER.map(sigma=(1e-300, 1e300, 3), v=(1e-300, 1e300, 3)).shape == (3, 3)
    assert SLIDER.replace(a=1e300).a == 1e300


def test_observables_have_errors_that_hold():
    run = SLIDER.simulate("5MPa", "10um/s", law="slip", rtol="1e-6")
    finer = SLIDER.simulate("5MPa", "10um/s", law="slip", rtol="1e-11")
    for name in ("peak_velocity", "period", "frequency", "stress_drop", "minimum_velocity_log10_ratio"):
        ours, reference = getattr(run, name), getattr(finer, name)
        assert 0 < ours.error and abs(ours.value - reference.value) <= ours.error + reference.error, name
    trajectory = run.trajectory(samples=500)
    assert trajectory.rows == 500 and "<svg" in trajectory.svg
    assert trajectory["velocity_m_per_s"].max() <= run.peak_velocity.value * 1.001
    assert "period" in run._repr_html_()


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_runs_of_arrays_keep_their_order_and_name_failures():
    runs = SLIDER.simulate(np.array([1e6, 5e6]), 1e-5, law="aging")
    assert [run.mode for run in runs] == ["decaying", "periodic"] and "decaying" in runs._repr_html_()
    alone = SLIDER.simulate(5e6, 1e-5, law="aging")
    assert runs[1] == alone
    failed = slipmode.Slider(a="1e-200", b="2e-200", d_c=1, k=1, m=1).simulate(np.array([1.0]), 1.0, law="aging")
    assert isinstance(failed[0], slipmode.Failed) and failed[0].reason.startswith("the simulation failed: ")


def test_a_map_has_the_points_of_its_axes_and_a_picture():
    found = SLIDER.map(("10kPa", "100MPa", 5), (1e-6, 1e-2, 9))
    assert found.shape == (5, 9) and "<svg" in found._repr_svg_()
    assert found.normal_stress[:, 0].tolist() == pytest.approx([1e4, 1e5, 1e6, 1e7, 1e8])
    assert found.loading_velocity[0, -1] == 1e-2
    pytest.importorskip("xarray")
    assert found.to_xarray()["slip_mode"].dims == ("normal_stress_pa", "loading_velocity_m_per_s")


def test_tolerances_are_those_of_the_command_line():
    found = SLIDER.tolerance("0.01")
    assert found["formula"].tolist() == ["eq15", "eq16", "eq18", "eq20"]
    assert found["relative_error"].tolist() == [0.01] * 4
    assert np.all(found["limit"] > 0)


def test_control_c_stops_the_waiting():
    # A command that has written a file leaves signals to Python.
    SLIDER.boundary(n=3)
    # A million digits take seconds.
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        SLIDER.roots("5MPa", "10um/s", digits=1_000_000)
    assert time.monotonic() - start < 1.5


def test_the_command_line_comes_with_the_package():
    options = "classify -a 0.009 -b 0.0126 -d 8um -k 2MPa/mm -m 12kg/50cm2 -s 5MPa -v 10um/s --json".split()
    done = subprocess.run([sys.executable, "-m", "slipmode", *options], capture_output=True, check=True)
    assert json.loads(done.stdout) == SLIDER.classify("5MPa", "10um/s").details
    wrong = subprocess.run([sys.executable, "-m", "slipmode", "classify", "-a", "x"], capture_output=True)
    assert wrong.returncode == 2 and b"not a decimal number" in wrong.stderr
    version = subprocess.run([sys.executable, "-m", "slipmode", "-V"], capture_output=True, text=True)
    assert version.stdout.split() == ["slipmode", slipmode.__version__]
