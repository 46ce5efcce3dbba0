"""An archive as its reader gets it: the program in it proves a certificate in it again, by the command of its README, and refuses a changed bound."""

import re
import shlex
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

# The program of the archive computes with it.
pytest.importorskip("flint")
EQUATIONS = Path(__file__).parents[2] / "reports/im-avouac/equations.toml"
PLAN = """\
name = "small"
title = "Small"
scenes = ["a"]
[[chapter]]
id = "c"
title = "C"
prose = "c.md"
"""
CLAIMS = """\
[[claim]]
id = "S1"
place = "eq 9"
words = "W"
expected = "holds"
"""
# One decay and three cycles; the second cycle is mild.
SCENE = """\
name = "a"
title = "A"
[parameters]
direct_effect = 0.004
evolution_effect = 0.006
critical_slip_distance_m = 1e-5
stiffness_pa_per_m = 1e7
mass_per_area_kg_per_m2 = 1000
[simulations]
loading_velocity_m_per_s = { from = 1e-3, to = 1e-2, points = 2 }
normal_stress_pa = { from = 1e3, to = 32500, points = 2 }
laws = ["slip"]
tolerance = 1e-2
"""
BOUND = "peak_velocity_high_m_per_s"


def run(*command, cwd, expected=0):
    done = subprocess.run([sys.executable, *command], cwd=cwd, capture_output=True, text=True)
    assert done.returncode == expected, done.stdout + done.stderr
    return done.stdout


def report_with_certificates(folder):
    for name in ("scenes", "prose", "vectors"):
        (folder / name).mkdir(parents=True)
    for name, text in (("report.toml", PLAN), ("claims.toml", CLAIMS), ("equations.toml", EQUATIONS.read_text())):
        (folder / name).write_text(text)
    (folder / "prose/c.md").write_text("Words.\n\n[[table:certificates]]\n")
    scene = folder / "scenes/a.toml"
    scene.write_text(SCENE)
    digest = run("-m", "slipmode", "certificates", "scenes/a.toml", "--law", "slip", "-o", "vectors/c.csv", cwd=folder)
    scene.write_text(f'{SCENE}[certificates]\nprove_again = 1\n[[certificates.file]]\nname = "c"\n{digest}')


def test_a_reader_of_an_archive_proves_a_certificate_again_and_a_changed_bound_is_refused(tmp_path):
    report_with_certificates(tmp_path / "small")
    run("-m", "slipmode", "archive", "small", "-o", "small.zip", cwd=tmp_path)
    reader = tmp_path / "reader"
    with zipfile.ZipFile(tmp_path / "small.zip") as archive:
        archive.extractall(reader)
    (command,) = re.findall(r"^    python (.*)$", (reader / "README.md").read_text(), re.MULTILINE)
    words = shlex.split(command)
    assert words == ["certified_cycle.py", "--rows", "3", "input/vectors/c.csv"]
    assert run(*words, cwd=reader) == "row 3: proved, and inside the stated bounds\n1 passed, 0 failed\n"
    certificates = reader / words[-1]
    lines = certificates.read_text().splitlines()
    column, cells = lines[0].split(",").index(BOUND), lines[3].split(",")
    # Below the lower bound.
    cells[column] = repr(float(cells[column]) * (1 - 1e-9))
    certificates.write_text("\n".join([*lines[:3], ",".join(cells), *lines[4:]]) + "\n")
    refused = run(*words, cwd=reader, expected=1)
    assert refused.startswith("row 3: peak_velocity") and refused.endswith("0 passed, 1 failed\n"), refused
