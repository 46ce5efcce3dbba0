"""The schemas of ``docs/schema`` accept what commands print for other inputs than those that made the schemas."""

import json
import random
from pathlib import Path

import jsonschema
import pytest
from slipmode import _slipmode

REPOSITORY = Path(__file__).parents[2]
SCHEMAS = {path.stem: json.loads(path.read_text()) for path in (REPOSITORY / "docs" / "schema").glob("*.json")}
OPTIONS = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"]
#: Decades of the seven values: those of laboratories and faults, and almost all that are allowed.
DECADES = [[(-3, -1), (-3, -1), (-7, 1), (3, 12), (-1, 8), (2, 9), (-12, 1)], [(-300, 299)] * 7]
SEED = 20261129


def check(name, arguments):
    """Compare what a command prints with its schema, or with that of errors if there is no answer; return whether there is one."""
    code, output, messages = _slipmode.call([*arguments, "--json"])
    found = json.loads(output) if output else pytest.fail(f"{arguments}: {messages}")
    is_answer = "errors" not in found
    assert is_answer or code != 0
    errors = jsonschema.Draft202012Validator(SCHEMAS[name if is_answer else "errors"]).iter_errors(found)
    assert [(error.json_path, error.message) for error in errors] == [], arguments
    return is_answer


def sliders(count, spread=""):
    """Random values as options; where there is a spread, some have an error bar."""
    numbers = random.Random(SEED)
    for number in range(count):
        values = []
        # Some questions about error bars take minutes at the ends of what is allowed.
        for low, high in DECADES[0 if spread else number % 2]:
            value = f"{numbers.uniform(1, 10):.3f}e{numbers.randint(low, high - 1)}"
            values.append(value + spread if numbers.random() < 0.5 else value)
        if not spread and number % 4 == 3:
            values[1] = values[0]
        if spread and not any(value.endswith(spread) for value in values[:5]):
            values[0] += spread
        yield values


def options(values, count=7, without=""):
    pairs = zip(OPTIONS[:count], values, strict=False)
    return [word for option, value in pairs if option != without for word in (option, value)]


def test_the_schemas_are_schemas():
    assert len(SCHEMAS) == 31
    for schema in SCHEMAS.values():
        jsonschema.Draft202012Validator.check_schema(schema)


@pytest.mark.parametrize("spread", ["", "±0", "±1e-15%", "±10%"])
def test_answers_for_random_sliders_have_the_schemas(spread):
    # An error of 0 is none.
    bars = "-error-bars" if spread.endswith("%") else ""
    answers = 0
    for values in sliders(60, spread):
        five, six = options(values, 5), options(values, 6)
        answers += check(f"classify{bars}", ["classify", *options(values)])
        answers += check(f"boundary{bars}", ["boundary", *five, "--points", "2"])
        ratio = "boundary-error-bars" if bars else "boundary-frequency-ratio"
        answers += check(ratio, ["boundary", *five, "--points", "2", "--frequency-ratio", "0.6"])
        if not bars:
            answers += check("boundary-damping-ratio", ["boundary", *five, "--points", "2", "--damping-ratio", "0.3"])
        answers += check(f"tolerance{bars}", ["tolerance", *five, "-e", "0.2"])
        question = ["--for", "loading-velocity", "--boundary"]
        answers += check(f"solve{bars}", ["solve", *six, *question])
        stable = ["solve", *options(values, without="-k"), "--for", "stiffness", "--stable-for-box"]
        answers += check("solve-stable-for-box", stable)
        if not bars:
            answers += check("roots", ["roots", *options(values), "--digits", "30"])
    assert answers > 300


def test_simulations_of_random_sliders_have_the_schema():
    laboratories = list(sliders(12))[::2] + [[*values[:5], values[5] + "±1%", values[6]] for values in list(sliders(6))[::2]]
    for values in laboratories:
        for law in ("slip", "aging"):
            check("simulate", ["simulate", *options(values), "--law", law, "--box-runs", "0", "--certify"])


def test_faults_have_the_schema_of_errors(tmp_path):
    broken = tmp_path / "broken.toml"
    broken.write_text("[[claim]]\nid = 1\n")
    faults = [
        ["classify", "-a", "x"],
        ["classify", *options(["0"] * 7)],
        ["simulate", "--law", "none"],
        ["solve", "--for", "mass"],
        ["nothing"],
        ["check", str(broken)],
        ["check", str(tmp_path)],
        ["compare", "--runs", str(broken)],
        ["fit", str(broken)],
        ["verify", str(tmp_path)],
    ]
    assert not any(check("", fault) for fault in faults)


@pytest.mark.parametrize("change", [{"schema": 2}, {"slip_mode": None}, {"unknown": 1}])
def test_a_changed_object_is_refused(change):
    slider = ["4e-3", "6e-3", "1e-5", "1e7", "1000", "1e5", "1e-3"]
    found = json.loads(_slipmode.call(["classify", *options(slider), "--json"])[1])
    validator = jsonschema.Draft202012Validator(SCHEMAS["classify"])
    assert validator.is_valid(found) and not validator.is_valid(found | change)
