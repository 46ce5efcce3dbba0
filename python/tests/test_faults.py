"""Every error is a `SlipmodeError` that names its argument, and says nothing of the command line or of files of ours."""

from decimal import Decimal

import numpy as np
import pytest
import slipmode

VALUES = {"a": 0.009, "b": 0.0126, "d_c": 8e-6, "k": 2e9, "m": 2400.0, "sigma": 5e6, "v": 1e-5}
SLIDER = slipmode.Slider(**{name: VALUES[name] for name in ("a", "b", "d_c", "k", "m")})
POINT = {"sigma": 5e6, "v": 1e-5}
NAN = float("nan")
NOT_FINITE = "out of range .allowed: finite numbers"

#: Calls with a fault, and the beginning of the message.
FAULTS = {
    "no target": (lambda: SLIDER.solve("k", **POINT), "^the target is missing .allowed: one of frequency, .*, boundary.$"),
    "two targets": (lambda: SLIDER.solve("k", **POINT, transition=True, frequency=1), "^frequency, transition: more than one"),
    "unknown": (lambda: slipmode.solve(5, **VALUES, transition=True), "^unknown = 5: not allowed .allowed: normal_stress"),
    "truth of a word": (lambda: SLIDER.solve("k", **POINT, transition="no"), "^transition = 'no': not allowed .allowed: True, F"),
    "drift": (lambda: slipmode.fit({"time_s": [0.0]}, drift="no"), "^drift = 'no': not allowed"),
    "NaN frequency": (lambda: SLIDER.solve("k", **POINT, frequency=NAN), f"^frequency = NaN: {NOT_FINITE}"),
    "NaN ratio": (lambda: SLIDER.boundary(frequency_ratio=NAN), f"^frequency_ratio = NaN: {NOT_FINITE}"),
    "NaN threshold": (lambda: SLIDER.classify(**POINT, inertial_threshold=NAN), f"^inertial_threshold = NaN: {NOT_FINITE}"),
    "NaN rtol": (lambda: SLIDER.simulate(**POINT, law="slip", rtol=NAN), f"^rtol = NaN: {NOT_FINITE}"),
    "NaN of a slider": (lambda: SLIDER.replace(a=NAN), f"^a = NaN: {NOT_FINITE}"),
    "NaN of a decimal": (lambda: slipmode.classify(**VALUES | {"sigma": Decimal("sNaN")}), f"^sigma = sNaN: {NOT_FINITE}"),
    "NaN of a fit": (lambda: slipmode.fit({"time_s": [0.0]}, normal_stress_pa=NAN), f"^normal_stress_pa = NaN: {NOT_FINITE}"),
    "NaN of a map": (lambda: SLIDER.map(sigma=(NAN, 1e6, 3)), f"^sigma = NaN: {NOT_FINITE}"),
    "two of an axis": (lambda: SLIDER.map(sigma=(1e3, 1e6)), r"^sigma = \(1000.0, 1000000.0\): not allowed .allowed: from, to"),
    "infinite cell": (lambda: slipmode.classify(**VALUES | {"sigma": ["1e6", Decimal("inf")]}), r"^sigma\[1\] = Infinity: "),
    "no record": (lambda: slipmode.fit(None), "^None is no table"),
    "no runs": (lambda: slipmode.compare(None), "^None is no table"),
    "numbers as runs": (lambda: slipmode.compare([1, 2]), "^1 is no table"),
    "ragged list": (lambda: slipmode.classify(**VALUES | {"sigma": [[1e6, 2e6], [3e6]]}), r"^sigma\[0\] = \[1000000.0, 2"),
    "ragged arrays": (lambda: slipmode.classify(**VALUES | {"sigma": [np.ones((2, 2)), np.ones((2, 3))]}), "^sigma: the rows have"),
    "complex": (lambda: slipmode.classify(**VALUES | {"sigma": 1j}), "^sigma = 1j: no number"),
    "complex array": (lambda: slipmode.classify(**VALUES | {"sigma": np.array([1j])}), "^sigma: an array of complex128"),
    "bytes": (lambda: slipmode.classify(**VALUES | {"sigma": b"5"}), "^sigma.0. = b'5': no number"),
    "dates": (lambda: slipmode.classify(**VALUES | {"sigma": np.array(["2026-01-01"], "M8[D]")}), "^sigma: an array of datetime64"),
    "truth value": (lambda: SLIDER.replace(a=True), "^a = True: no number"),
    "no frame": (lambda: slipmode.classify(7), "^a int is no frame"),
    "column of runs": (lambda: slipmode.compare([VALUES], law="slip"), "^runs: header"),
    "value of a run": (
        lambda: slipmode.compare([VALUES | {"peak_velocity_m_per_s": 1e-3, "a": -1}], law="slip"),
        "^runs: row 1, column a = -1: must be > 0",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_named_as_python_names_it(fault):
    call, message = FAULTS[fault]
    with pytest.raises(slipmode.SlipmodeError, match=message) as raised:
        call()
    assert not any(word in str(raised.value) for word in ("--", "Usage", ".csv"))


def test_one_error_is_one_error():
    assert SLIDER.tolerance("0.1")["limit"].tolist() == slipmode.tolerance(**dict(zip("a b d_c k m".split(), SLIDER)), errors="0.1")[
        "limit"
    ].tolist()
