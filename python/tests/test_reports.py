"""Comparisons and reports."""

import shutil
from pathlib import Path

import numpy as np
import pytest
import slipmode

REPOSITORY = Path(__file__).parents[2]
VALUES = {
    "direct_effect": "0.009",
    "evolution_effect": "0.0126",
    "critical_slip_distance_m": "8e-6",
    "stiffness_pa_per_m": "2e9",
    "mass_per_area_kg_per_m2": "2400",
    "normal_stress_pa": "5e6",
    "loading_velocity_m_per_s": "1e-5",
}


def runs_of_another_program(factor: float) -> list[dict[str, str]]:
    slider = slipmode.Slider(a="0.009", b="0.0126", d_c="8e-6", k="2e9", m="2400")
    run = slider.simulate("5e6", "1e-5", law="slip")
    found = {"peak_velocity_m_per_s": run.peak_velocity.value * factor, "period_s": run.period.value}
    return [VALUES | {"law": "slip"} | {name: repr(value) for name, value in found.items()}]


def test_a_run_that_agrees_agrees_and_another_does_not():
    agreeing = runs_of_another_program(1.0)
    assert slipmode.compare(agreeing, tolerance="1e-4").agrees
    assert slipmode.compare({name: [cell] for name, cell in agreeing[0].items()}, tolerance="1e-4").agrees
    other = slipmode.compare(runs_of_another_program(1.5), tolerance="1e-4")
    assert not other.agrees and [run["verdict"] for run in other.runs] == ["differs"]
    with pytest.raises(slipmode.InputError, match="missing"):
        slipmode.compare([{"a": "1"}])


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_a_report_is_computed_and_a_changed_copy_is_noticed(tmp_path):
    folder = tmp_path / "reports" / SMALL
    shutil.copytree(REPOSITORY / "reports" / SMALL, folder)
    found = slipmode.verify(folder, tmp_path / "out")
    assert found.is_unchanged and found.page.exists() and found.verdicts
    (folder / "published" / "ledger.json").write_text("{}")
    changed = slipmode.verify(folder, tmp_path / "out")
    assert changed.is_unchanged is False and changed.verdicts == found.verdicts
    assert "ledger.json" in changed.text
    with pytest.raises(slipmode.InputError):
        slipmode.report(tmp_path / "nowhere")


#: The report that takes the least time.
SMALL = "rice-ruina-1983"


def test_comparisons_and_reports_have_tables():
    pytest.importorskip("pandas")
    frame = slipmode.compare(runs_of_another_program(1.0), tolerance="1e-4").to_dataframe()
    assert {"row", "observable", "verdict"} <= set(frame.columns)
    slider = slipmode.Slider(a="0.009", b="0.0126", d_c="8e-6", k="2e9", m="2400")
    frame = slider.simulate(np.array([1e6, 5e6]), 1e-5, law="slip").to_dataframe()
    assert frame["mode"].tolist() == ["decaying", "periodic"]
