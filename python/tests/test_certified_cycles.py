"""Cycles that the program certifies, proved again by proofs/certified_cycle.py in another arithmetic, and planted faults."""

import csv
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

# The checker computes with it.
pytest.importorskip("flint")
CHECKER = Path(__file__).parents[2] / "proofs/certified_cycle.py"
REPORT = CHECKER.parents[1] / "reports/im-avouac"
specification = importlib.util.spec_from_file_location("certified_cycle", CHECKER)
checker = importlib.util.module_from_spec(specification)
sys.modules["certified_cycle"] = checker
specification.loader.exec_module(checker)

SLIDER = ["0.004", "0.006", "10e-6", "10e6", "1000"]
# Near the transition and away from it; the last one sticks, at eta = 0.1.
POINTS = [
    ("26250", "0.001", "slip"),
    ("32500", "0.001", "aging"),
    ("32500", "0.001", "slip"),
    ("90909", "0.000603", "aging"),
]
BOUNDS = ["peak_velocity_{}_m_per_s", "period_{}_s", "stress_drop_{}_pa"]


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    folder = tmp_path_factory.mktemp("certified")
    with open(folder / "points.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([*checker.INPUTS, "law"])
        writer.writerows([*SLIDER, *point] for point in POINTS)
    command = [sys.executable, "-m", "slipmode", "simulate", "--certify", "--points", "points.csv", "-o", "out.csv"]
    subprocess.run(command, cwd=folder, check=True)
    with open(folder / "out.csv", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture(scope="module")
def proved(rows):
    return checker.prove(rows[0])


@pytest.mark.parametrize("index", range(len(POINTS)))
def test_a_certified_cycle_is_proved_again_and_its_bounds_hold(rows, index):
    assert rows[index]["certificate"] == "cycle"
    assert checker.verdict(rows[index]) == ""
    for name in BOUNDS:
        low, high = (float(rows[index][name.format(end)]) for end in ("low", "high"))
        assert 0 < low < high < low * (1 + 1e-6)


@pytest.mark.parametrize("name", BOUNDS)
@pytest.mark.parametrize("factor", [1 - 1e-9, 1 + 1e-9])
def test_shifted_bounds_are_refused(rows, proved, name, factor):
    shifted = {name.format(end): repr(float(rows[0][name.format(end)]) * factor) for end in ("low", "high")}
    assert len(checker.faults(rows[0] | shifted, *proved)) == 1


def test_another_law_another_mass_and_a_stiffness_above_critical_are_refused(rows):
    assert "here" in checker.verdict(rows[0] | {"law": "aging"})
    # eta differs by 1e-9.
    assert "here" in checker.verdict(rows[0] | {"mass_per_area_kg_per_m2": "1000.000001"})
    assert "not proved" in checker.verdict(rows[0] | {"stiffness_pa_per_m": "12e6"})


@pytest.mark.parametrize("law, other, number", [("slip", "aging", 14), ("slip", "aging", 181), ("aging", "slip", 77)])
def test_certificates_of_the_report_are_proved_again_and_those_of_another_law_are_not(law, other, number):
    with open(REPORT / f"vectors/certified-{law}.csv", newline="") as file:
        row = list(csv.DictReader(file))[number - 1]
    assert (row["certificate"], row["law"]) == ("cycle", law)
    slider, proved = checker.prove(row)
    assert checker.faults(row, slider, proved) == []
    with open(REPORT / f"vectors/certified-{other}.csv", newline="") as file:
        assert len(checker.faults(list(csv.DictReader(file))[number - 1], slider, proved)) == 3


def test_bistability_is_proved_again_and_faults_are_refused():
    with open(REPORT / "published/tables/bistability-certified.csv", newline="") as file:
        (row,) = (row for row in csv.DictReader(file) if row["inertial_parameter"] == "0.1")
    assert checker.is_bistable(row)
    peaks = checker.prove_three(row)
    assert checker.faults_of_three(row, peaks) == []
    assert peaks["unstable"] < peaks["stable"]
    for name in ("stable", "unstable"):
        low, high = (float(row[f"{name}_log_peak_{end}"]) for end in ("low", "high"))
        assert 0 < high - low < 1e-8
        shifted = {f"{name}_log_peak_{end}": repr(float(row[f"{name}_log_peak_{end}"]) + 1e-8) for end in ("low", "high")}
        assert len(checker.faults_of_three(row | shifted, peaks)) == 1
    # Below K_c sliding repels; and the small cycle does not attract.
    assert "sliding" in checker.verdict(row | {"stiffness_group": "0.5499"})
    slider = checker.Slider.of_groups("aging", *(row[name] for name in ("inertial_parameter", "stiffness_group", "effect_ratio")))
    with pytest.raises(checker.NotProved, match="attract"):
        checker.cycle(slider, checker.ball(row["unstable_y"]), checker.ball(row["unstable_zeta"]))
