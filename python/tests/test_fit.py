"""Fits of velocity steps."""

import json
import os
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import slipmode

RECORD = Path(__file__).parents[2] / "tests" / "data" / "records" / "basalt-step.csv"
GIVEN = {"normal_stress_pa": "19.967MPa", "drift": True}
NAMES = ("time_s", "load_point_velocity_m_per_s", "friction")
COLUMNS = dict(zip(NAMES, np.loadtxt(RECORD, delimiter=",", skiprows=1, unpack=True)))
FIT = slipmode.fit(COLUMNS, **GIVEN)


def changed(name: str, row: int, value: object) -> dict[str, list[object]]:
    """Return the record with another cell; rows count from 1."""
    columns: dict[str, list[object]] = {column: numbers.tolist() for column, numbers in COLUMNS.items()}
    columns[name][row - 1] = value
    return columns


def test_a_fit_is_that_of_the_command_line():
    options = ["--normal-stress-pa=19.967MPa", "--drift", "--json"]
    command = [sys.executable, "-m", "slipmode", "fit", os.fspath(RECORD), *options]
    printed = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    assert FIT.to_dict() == printed and FIT.law == printed["law"]
    for name in ("direct_effect", "evolution_effect", "critical_slip_distance_m", "stiffness_pa_per_m", "drift_per_m"):
        value = getattr(FIT, name)
        assert {key: getattr(value, key) for key in ("value", "error", "low", "high")} == printed[name]
        assert value.low < value.value < value.high and " ± " in str(value)
    assert {",".join(pair): value for pair, value in FIT.correlations.items()} == printed["correlations"]
    assert next(iter(FIT.correlations)) == ("direct_effect", "evolution_effect")
    assert FIT.residuals.variance_inflation > 1 and any("correlated" in remark for remark in FIT.remarks)
    assert {FIT.law, FIT.law_comparison.other_law} == {"slip", "aging"} and FIT.slip_modes is None
    # The values of the independent fit (tests/data/records/README.md) for the slip law.
    slip = slipmode.fit(COLUMNS, law="slip", **GIVEN)
    values = (slip.direct_effect, slip.evolution_effect, slip.critical_slip_distance_m)
    assert [value.value for value in values] == pytest.approx([0.00959, 0.00956, 8e-6], rel=2e-3)
    assert slip.law_comparison is None


def test_a_path_columns_and_frames_give_the_same_fit():
    same = [slipmode.fit(RECORD, **GIVEN), slipmode.fit({k: list(v) for k, v in COLUMNS.items()}, **GIVEN)]
    for package in ("pandas", "polars"):
        same.append(slipmode.fit(pytest.importorskip(package).DataFrame(COLUMNS), **GIVEN))
    assert same == [FIT] * 4 and pickle.loads(pickle.dumps(FIT)) == FIT
    micrometres = dict(COLUMNS) | {"load_point_velocity_um_per_s": COLUMNS[NAMES[1]] * 1e6}
    del micrometres[NAMES[1]]
    assert slipmode.fit(micrometres, **GIVEN).direct_effect.value == pytest.approx(FIT.direct_effect.value, rel=1e-6)


def test_the_fitted_curve_and_its_pictures_belong_to_the_record():
    assert FIT.fitted.rows == len(COLUMNS["friction"]) and np.array_equal(FIT.fitted["friction"], COLUMNS["friction"])
    residuals = FIT.fitted["residual"]
    np.testing.assert_allclose(FIT.fitted["friction"] - FIT.fitted["fitted_friction"], residuals, atol=1e-15)
    assert np.std(residuals) == pytest.approx(FIT.residuals.standard_deviation, rel=0.01)
    assert "<svg" in FIT.svg and "D_c" not in FIT._repr_html_() and "direct_effect" in FIT._repr_html_()
    pytest.importorskip("matplotlib").use("Agg")
    upper, lower = FIT.plot()
    assert [line.get_label() for line in upper.lines] == ["measured", f"fitted, {FIT.law} law"]
    assert np.array_equal(lower.lines[0].get_ydata(), residuals)


def test_a_slider_has_the_intervals_as_error_bars():
    stiffness, point = 1.39e11, ("19.967MPa", "10um/s")
    fit = slipmode.fit(
        COLUMNS,
        stiffness_pa_per_m=stiffness,
        mass_per_area_kg_per_m2="12kg/50cm2",
        loading_velocity_m_per_s=point[1],
        **GIVEN,
    )
    assert fit.stiffness_pa_per_m is None and sum(fit.slip_modes.values()) == pytest.approx(1)
    found = fit.slider().classify(*point)
    assert set(fit.slip_modes) <= set(found.slip_modes)
    ends = [f"[{fit.direct_effect.low!r}, {fit.direct_effect.high!r}]", f"'{stiffness!r}'", "'2400.0'"]
    assert all(end in repr(fit.slider()) for end in ends)
    with pytest.raises(slipmode.InputError, match="needs mass_per_area_kg_per_m2"):
        FIT.slider()


@pytest.mark.parametrize(
    ("record", "given", "message"),
    [
        (changed("friction", 17, "0.61x"), GIVEN, "^record: row 17, column friction = 0.61x"),
        (changed("friction", 17, np.nan), GIVEN, "^record: row 17, column friction = nan"),
        (changed("time_s", 42, 0.0), GIVEN, "^record: row 42, column time_s"),
        ({"time_s": [1.0], "friction": [0.6]}, GIVEN, "^record: .*load_point_displacement_m"),
        ({"time_s": [1.0, 2.0], "friction": [0.6]}, GIVEN, "time_s has 2, friction has 1"),
        (COLUMNS, {}, "argument normal_stress_pa"),
        (COLUMNS, {"normal_stress_pa": "-1"}, "^argument normal_stress_pa = -1: "),
        (COLUMNS, {"normal_stress_pa": 2e7, "law": "rate"}, "^argument law = rate: "),
        (COLUMNS, {"normal_stress_pa": 2e7, "stiffness_pa_per_m": "2MPa"}, "^argument stiffness_pa_per_m = 2MPa: "),
        (COLUMNS, {"normal_stress_pa": 2e7, "loading_velocity_m_per_s": 1e-5}, "need mass_per_area_kg_per_m2"),
        ("nowhere.csv", GIVEN, "^nowhere.csv: "),
        ("-", GIVEN, "^record = -: "),
    ],
)
def test_messages_name_what_python_calls_it(record, given, message):
    with pytest.raises(slipmode.InputError, match=message) as raised:
        slipmode.fit(record, **given)
    assert "--" not in str(raised.value) and "/record.csv" not in str(raised.value)


def test_a_value_without_a_bound_makes_no_slider():
    value = slipmode.FittedValue(1.0, 0.1, "", None, 1.2)
    assert str(value) == "1 ± 0.1 (95 %: no bound to 1.2)"
    with pytest.raises(slipmode.InputError, match="does not bound direct_effect"):
        slipmode._fit.interval("direct_effect", value)


def test_peaks_are_those_of_the_command_line():
    table = RECORD.parents[1] / "peaks.csv"
    options = ["--peaks", "--effect-ratio=[1.4, 1.6]", "-k=1e7", "-m=1000", "-s=1e6", "--json"]
    command = [sys.executable, "-m", "slipmode", "fit", os.fspath(table), *options]
    printed = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    columns = np.genfromtxt(table, delimiter=",", names=True)
    frame = {name: columns[name] for name in columns.dtype.names}
    given = {"stiffness_pa_per_m": 1e7, "mass_per_area_kg_per_m2": 1000, "normal_stress_pa": 1e6}
    for source in (table, frame):
        found = slipmode.fit_peaks(source, effect_ratio="[1.4, 1.6]", **given)
        assert found.to_dict() == printed
    assert found.law == printed["law"] and found.laws[found.law].value == found.twice_v18_m_per_s.value
    assert str(found.effect_difference).endswith("(95 %: 0.00388 to 0.00668)") and found.distinguishes_laws is False
    assert found.error_parts_m_per_s["noise"] == tuple(printed["error_parts_m_per_s"]["noise"])
    with pytest.raises(slipmode.InputError, match="argument effect_ratio"):
        slipmode.fit_peaks(frame, effect_ratio=1.1)
    assert slipmode.fit_peaks(frame, effect_ratio=1.2).to_dict() == slipmode.fit_peaks(frame, effect_ratio="1.2").to_dict()
