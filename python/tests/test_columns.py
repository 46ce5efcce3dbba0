"""Columns in, columns out: arrays that broadcast, frames of several packages, missing values, errors and units."""

import pickle
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import slipmode

VALUES = {"a": 0.009, "b": 0.0126, "d_c": 8e-6, "k": 2e9, "m": 2400.0, "sigma": 5e6, "v": 1e-5}
STRESSES = [1e5, 5e6, 2e7]
SLIDER = slipmode.Slider(a="0.009", b="0.0126", d_c="8um", k="2MPa/mm", m="12kg/50cm2")


def modes_of(stresses):
    return [slipmode.classify(**VALUES | {"sigma": stress}).slip_mode for stress in stresses]


def test_seven_arrays_broadcast_and_each_row_is_its_point():
    random = np.random.default_rng(5)
    columns = {name: value * 10 ** random.uniform(-0.5, 0.5, 40) for name, value in VALUES.items()}
    found = slipmode.classify(**columns)
    for row in range(40):
        point = slipmode.classify(**{name: float(array[row]) for name, array in columns.items()})
        assert point == found[row] and point.growth_rate == found.growth_rate[row]
        exact = slipmode.classify(**{name: Fraction(float(array[row])) for name, array in columns.items()})
        assert exact.slip_mode == point.slip_mode and exact.transition_sign == point.transition_sign
    assert [point.slip_mode for point in found] == np.asarray(found.slip_mode).tolist() and len(found) == 40
    grid = slipmode.classify(**VALUES | {"a": np.array([[0.008], [0.009]]), "sigma": STRESSES})
    assert grid.shape == (2, 3) and np.asarray(grid.slip_mode)[1].tolist() == modes_of(STRESSES)
    assert grid[1, 2] == grid[1][2] and len(grid[:, 1:]) == 2 and pickle.loads(pickle.dumps(grid))[1, 2] == grid[1, 2]
    with pytest.raises(slipmode.SlipmodeError, match=r"a has \(2,\), sigma has \(3,\)"):
        slipmode.classify(**VALUES | {"a": [0.008, 0.009], "sigma": STRESSES})
    with pytest.raises(slipmode.SlipmodeError, match="^m, v: missing"):
        slipmode.classify(**{name: VALUES[name] for name in ("a", "b", "d_c", "k", "sigma")})


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_exact_numbers_stay_exact_in_arrays():
    # K_c = (b − a)·(σ + M V0²/a) = 0.11; the decimals are no 64-bit numbers.
    exact = {"a": "0.1", "b": Decimal("0.2"), "d_c": 1, "k": [Fraction(11, 100), "0.11", 0.11], "m": "0.01", "sigma": 1, "v": 1}
    assert slipmode.classify(**exact).transition_sign.tolist() == [0, 0, 1]
    assert slipmode.classify(**exact)[1].details["transition_sign"] == 0


#: One more than a 64-bit number: with K = σ + 1/10^200 between them, K_c > K, and 64-bit numbers would be equal.
LARGE = 2**53 + 1


def large_columns():
    """Return columns of LARGE and a missing value, by kind."""
    columns = {
        "int64": np.array([LARGE, 1]),
        "uint64": np.array([LARGE, 1], dtype=np.uint64),
        "negative stride": np.array([1, LARGE])[::-1],
        "masked": np.ma.array([LARGE, 1], mask=[False, True]),
        "list": [LARGE, None],
        "with a float": [LARGE, 1.0],
        "numbers of NumPy": [np.int64(LARGE), np.float64("nan")],
        "longdouble": np.array([np.longdouble(LARGE), np.longdouble("nan")]),
    }
    for package in ("pandas", "polars", "pyarrow"):
        library = pytest.importorskip(package)
        if package == "pandas":
            columns |= {"pandas": library.Series([LARGE, 1]), "Int64": library.Series([LARGE, None], dtype="Int64")}
        else:
            columns[package] = library.Series([LARGE, None]) if package == "polars" else library.array([LARGE, None])
    return columns


@pytest.mark.filterwarnings("ignore::slipmode.SlipmodeWarning")
def test_integers_and_long_numbers_are_not_rounded():
    # K_c = σ + M V0²/a is a little greater than σ; K = σ.
    point = {"a": 1, "b": 2, "d_c": 1, "m": "1e-200", "v": 1, "k": str(LARGE)}
    assert slipmode.classify(**point, sigma=LARGE).transition_sign == -1
    for kind, column in large_columns().items():
        found = slipmode.classify(**point, sigma=column)
        signs = found.transition_sign if isinstance(found, slipmode.Classifications) else found["transition_sign"]
        assert list(signs)[0] == -1 or signs[0].as_py() == -1, kind
    for one in (np.array(LARGE), np.array([[LARGE]]), [[LARGE, 0.5]], [np.array([LARGE]), np.array([0.5])]):
        assert slipmode.classify(**point, sigma=one).transition_sign.flat[0] == -1
    long = np.longdouble(1) + np.longdouble(2) ** -60
    if long != 1:
        same = point | {"k": str(Fraction(2**60 + 1, 2**60))}
        assert slipmode.classify(**same, sigma=long).transition_sign == -1
        assert slipmode.classify(**same, sigma=[long, 1.0]).transition_sign[0] == -1
        assert slipmode.classify(**same, sigma=np.array([long])).transition_sign[0] == -1
    assert slipmode.classify(**point | {"k": LARGE - 1}, sigma=np.array([LARGE - 1])).inputs["normal_stress_pa"].dtype == np.float64
    pint = pytest.importorskip("pint")
    stress = np.array([LARGE, 5_000_000]) * pint.UnitRegistry().MPa
    assert slipmode.classify(**point | {"k": f"{LARGE}MPa/m"}, sigma=stress).transition_sign[0] == -1


def test_arrays_of_results_do_not_change():
    found = slipmode.classify(**VALUES | {"sigma": [1e5, None, 2e7]})
    arrays = [found.growth_rate, found.transition_sign, found.slip_mode.codes, found[:2].frequency, found[[0, 2]].growth_rate]
    arrays += [found.inputs["normal_stress_pa"], found[[0, 2]].inputs["normal_stress_pa"], np.ma.getmaskarray(found.transition_sign)]
    arrays += [slipmode.roots(**VALUES | {"sigma": STRESSES}), SLIDER.boundary(n=3)["normal_stress_pa"]]
    own = np.array(STRESSES)
    table = slipmode.classify({**VALUES, "sigma": own})
    arrays += [*table.values(), SLIDER.map(("1MPa", "2MPa", 3), ("1um/s", "2um/s", 3)).growth_rate]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array.flat[0] = array.flat[0]
    own[0] = 7.0
    assert table["sigma"].tolist() == STRESSES
    frame = found.to_pandas() if pytest.importorskip("pandas") else None
    frame.loc[0, "max_real_per_s"] = 7.0
    assert found.growth_rate[0] != 7.0 and found[0].growth_rate != 7.0


def test_missing_values_stay_missing():
    masked = np.ma.array([1e5, 5e6, 2e7], mask=[False, True, False])
    for stresses in (masked, [1e5, None, 2e7], np.array([1e5, np.nan, 2e7]), ["1e5", None, "2e7"]):
        found = slipmode.classify(**VALUES | {"sigma": stresses})
        assert found[1] is None and np.ma.getmaskarray(found.transition_sign).tolist() == [False, True, False]
        assert np.isnan(found.growth_rate).tolist() == [False, True, False]
        assert [np.asarray(found.slip_mode)[row] for row in (0, 2)] == modes_of([1e5, 2e7])
    assert np.isnan(slipmode.roots(**VALUES | {"sigma": masked})).all(axis=1).tolist() == [False, True, False]


#: The questions of points, and what else they are asked.
QUESTIONS = {
    "classify": (slipmode.classify, {}, "frequency_hz"),
    "roots": (slipmode.roots, {}, "root_1_re_per_s"),
    "distance": (slipmode.distance, {}, "transition_normal_stress"),
    "solve": (lambda frame=None, **values: slipmode.solve("k", frame, **values), {"transition": True}, "solution_1"),
    "simulate": (slipmode.simulate, {"law": "slip", "rtol": "1e-4"}, "peak_velocity_m_per_s"),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_a_missing_value_is_a_missing_result_of_every_question(question):
    call, asked, name = QUESTIONS[question]
    whole = call({**VALUES, "sigma": STRESSES, "v": [1e-5] * 3}, **asked)
    assert isinstance(whole, slipmode.Table)
    for missing in (np.ma.array(STRESSES, mask=[False, True, False]), np.array([1e5, np.nan, 2e7]), [1e5, None, 2e7]):
        found = call({**VALUES, "sigma": missing, "sample": ["x", "y", "z"]}, **asked)
        assert list(found)[: len(VALUES) + 1] == [*VALUES, "sample"] and found["sample"].tolist() == ["x", "y", "z"]
        numbers = found[name].astype(float)
        assert np.isnan(numbers).tolist() == [False, True, False]
        assert numbers[::2].tolist() == whole[name][::2].tolist()
        if question == "classify":
            assert np.ma.getmaskarray(found["transition_sign"]).tolist() == [False, True, False]
            assert pytest.importorskip("pandas").isna(found.to_pandas()["transition_sign"]).tolist() == [False, True, False]


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("package", ["pandas", "polars", "pyarrow", "xarray"])
def test_every_question_of_a_frame_has_a_frame_of_its_package(package, question):
    library = pytest.importorskip(package)
    call, asked, name = QUESTIONS[question]
    columns = {own: [value] * 3 for own, value in VALUES.items()} | {"sigma": STRESSES, "sample": ["x", "y", "z"]}
    frames = {
        "pandas": lambda: library.DataFrame(columns, index=[7, 8, 9]),
        "polars": lambda: library.DataFrame(columns),
        "pyarrow": lambda: library.table(columns),
        "xarray": lambda: library.Dataset({own: ("x", column) for own, column in columns.items()}),
    }
    frame = frames[package]()
    found = call(frame, **asked)
    assert type(found) is type(frame) and np.asarray(found["sample"]).tolist() == ["x", "y", "z"]
    assert np.asarray(found[name]).tolist() == call(columns, **asked)[name].tolist()
    if package == "pandas":
        assert found.index.equals(frame.index)


@pytest.mark.parametrize("package", ["pandas", "polars", "pyarrow"])
def test_a_frame_gives_a_frame_of_its_package(package):
    library = pytest.importorskip(package)
    columns = {"sample": ["x", "y", "z"], "Dc [um]": [8.0, 8.0, 8.0], "K_MPa_per_mm": [2.0, 2.0, None]}
    columns |= {name: [VALUES[name]] * 3 for name in ("a", "b", "m", "v")} | {"sigma": STRESSES}
    frame = library.table(columns) if package == "pyarrow" else library.DataFrame(columns)
    if package == "pandas":
        frame.index = ["p", "q", "r"]
    found = slipmode.classify(frame)
    assert type(found) is type(frame) and len(found) == 3
    assert list(getattr(found, "column_names", found.columns))[: len(columns)] == list(columns)
    words = found["slip_mode"].to_pylist() if package == "pyarrow" else list(found["slip_mode"])
    assert words[:2] == modes_of(STRESSES[:2]) and words[2] in (None, "") or words[2] != words[2]
    if package == "pandas":
        assert found.index.equals(frame.index) and found["transition_sign"].isna().tolist() == [False, False, True]
    series = slipmode.classify(**VALUES | {"sigma": frame["sigma"]})
    assert len(series) == 3 and "frequency_hz" in getattr(series, "column_names", series.columns)
    with_errors = slipmode.classify(
        {name: column for name, column in columns.items() if name != "sample"} | {"a_err": [0.0, 0.001, None]}
    )
    assert with_errors["certain"].tolist()[:2] == [True, False]
    assert "stick-slip" in with_errors["slip_modes"][1] and with_errors["slip_modes"][0] == modes_of(STRESSES)[0]


def test_columns_of_pandas_keep_their_index_and_arguments_add_columns():
    pandas = pytest.importorskip("pandas")
    stress = pandas.Series(STRESSES, index=[10, 20, 30])
    found = slipmode.classify(**VALUES | {"sigma": stress})
    assert found.index.equals(stress.index) and found["slip_mode"].tolist() == modes_of(STRESSES)
    assert found["normal_stress_pa"].tolist() == STRESSES
    frame = pandas.DataFrame({name: [VALUES[name]] * 3 for name in ("a", "b", "d_c", "k", "m")})
    assert slipmode.classify(frame, sigma=STRESSES, v="10um/s")["slip_mode"].tolist() == modes_of(STRESSES)
    with pytest.raises(slipmode.SlipmodeError, match="different indices"):
        slipmode.classify(**VALUES | {"sigma": stress, "v": pandas.Series([1e-5] * 3)})
    with pytest.raises(slipmode.SlipmodeError, match=r"d_c_errr|d_c"):
        slipmode.classify(frame.rename(columns={"d_c": "dcrit"}), sigma=STRESSES, v=1e-5)
    with pytest.raises(slipmode.SlipmodeError, match=r"^a\[1\] = -1e0: must be > 0"):
        slipmode.classify(frame.assign(a=[0.009, -1.0, 0.009]), sigma=STRESSES, v=1e-5)
    nullable = frame.assign(a=pandas.array([0.009, None, 0.009], dtype="Float64"))
    assert slipmode.classify(nullable, sigma=STRESSES, v=1e-5)["slip_mode"].isna().tolist() == [False, True, False]


def test_arrays_of_xarray_give_a_data_set():
    xarray = pytest.importorskip("xarray")
    stress = xarray.DataArray(STRESSES, dims="stress", coords={"stress": STRESSES})
    velocity = xarray.DataArray([1e-6, 1e-5], dims="velocity")
    found = slipmode.classify(**VALUES | {"sigma": stress, "v": velocity})
    assert found["slip_mode"].dims == ("stress", "velocity") and found["stress"].values.tolist() == STRESSES
    assert found["slip_mode"].isel(velocity=1).values.tolist() == modes_of(STRESSES)


def test_other_questions_take_arrays_and_frames():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({name: [value] * 3 for name, value in VALUES.items()} | {"sigma": STRESSES}, index=list("xyz"))
    roots = slipmode.roots(**VALUES | {"sigma": STRESSES})
    assert roots.shape == (3, 3)
    for row, stress in enumerate(STRESSES):
        wanted = sorted(map(complex, SLIDER.roots(stress, 1e-5)), key=lambda s: (abs(s.imag) > 0, s.real, s.imag))
        np.testing.assert_allclose(roots[row], wanted, rtol=1e-14)
    assert slipmode.roots(frame)["root_3_im_per_s"].tolist() == roots[:, 2].imag.tolist()
    assert slipmode.roots(**VALUES | {"d_c": "8um", "sigma": STRESSES})[1] == pytest.approx(roots[1], rel=1e-14)
    stiffness = slipmode.solve("k", frame.drop(columns="k"), transition=True)
    assert stiffness.index.equals(frame.index)
    for stress, value in zip(STRESSES, stiffness["solution_1"]):
        (alone,) = SLIDER.solve("stiffness", sigma=stress, v=1e-5, transition=True)
        assert float(alone) == pytest.approx(value, rel=1e-12)
    runs = slipmode.simulate(frame.assign(law=["slip", "aging", "slip"]), rtol="1e-6")
    assert runs["mode"].tolist() == ["decaying", "periodic", "periodic"] and runs.index.equals(frame.index)
    far = slipmode.distance(frame)
    alone = SLIDER.distance(5e6, "10um/s")
    assert far["transition_normal_stress"].iloc[1] == pytest.approx(alone.transition_normal_stress, abs=1e-9)
    own = {name: VALUES[name] for name in ("b", "d_c", "k", "m")}
    table = slipmode.tolerance(a=[0.008, 0.009], **own, errors=["0.01"])
    assert table["row"].tolist() == [0] * 4 + [1] * 4
    assert set(slipmode.boundary(a=[0.008, 0.009], **own, n=3)["row"]) == {0, 1}


@pytest.mark.parametrize("package", ["pandas", "polars", "pyarrow", "xarray"])
def test_boundaries_and_tolerances_of_a_frame_are_a_frame_of_its_package(package):
    library = pytest.importorskip(package)
    columns = {name: [VALUES[name]] * 3 for name in ("b", "k", "m")} | {"a": [0.008, None, 0.009], "Dc [um]": [8.0] * 3}
    frames = {
        "pandas": lambda: library.DataFrame(columns, index=["p", "q", "r"]),
        "polars": lambda: library.DataFrame(columns),
        "pyarrow": lambda: library.table(columns),
        "xarray": lambda: library.Dataset({name: ("x", column) for name, column in columns.items()}),
    }
    frame = frames[package]()
    own = {name: VALUES[name] for name in ("b", "k", "m")}
    for call, asked in ((slipmode.boundary, {"n": 3}), (slipmode.tolerance, {"errors": ["0.01"]})):
        found = call(frame, **asked)
        assert type(found) is type(frame)
        wanted = call(a=[0.008, 0.009], d_c="8um", **own, **asked)
        rows = [{0: 0, 2: 1}[row] for row in np.asarray(found["row"]).tolist()]
        assert rows == wanted["row"].tolist()
        name = "normal_stress_pa" if call is slipmode.boundary else "limit"
        assert np.asarray(found[name]).tolist() == wanted[name].tolist()
        if package == "pandas":
            assert found.index.unique().tolist() == ["p", "r"] and list(call(frame.iloc[1:2], **asked).columns) == ["row"]
    if package == "pandas":
        assert len(slipmode.boundary(frame, n=3)) == len(slipmode.boundary(frame.assign(sigma=5e6, sigma_err=1e3), n=3))
        with pytest.raises(slipmode.SlipmodeError, match="stiffness_pa_per_m: missing"):
            slipmode.boundary(frame.drop(columns="k"))
        with pytest.raises(slipmode.SlipmodeError, match="without error bars"):
            slipmode.tolerance(frame.assign(a_err=0.001))


def test_a_frame_with_the_interchange_protocol_alone_gives_one_of_pandas():
    pandas = pytest.importorskip("pandas")

    class Frame:
        def __dataframe__(self, **options):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return pandas.DataFrame({name: [value] * 2 for name, value in VALUES.items()}).__dataframe__(**options)

    found = slipmode.classify(Frame())
    assert isinstance(found, pandas.DataFrame) and found["slip_mode"].tolist() == modes_of([VALUES["sigma"]] * 2)
    with pytest.raises(slipmode.InputError, match="no frame"):
        slipmode.classify(7)


def test_a_data_set_of_xarray_gives_a_data_set():
    xarray = pytest.importorskip("xarray")
    columns = {name: ("sample", [value] * 3) for name, value in VALUES.items()} | {"sigma": ("sample", STRESSES)}
    found = slipmode.classify(xarray.Dataset(columns, coords={"sample": ["x", "y", "z"]}))
    assert found["slip_mode"].values.tolist() == modes_of(STRESSES) and found["sample"].values.tolist() == ["x", "y", "z"]


def test_quantities_have_their_unit_and_their_error():
    text = SLIDER.replace(a="0.009±0.001")
    assert SLIDER.replace(a=(0.009, "0.001")) != text and SLIDER.replace(a=("0.009", "0.001")) == text
    assert SLIDER.replace(d_c="8 um") == SLIDER and hash(SLIDER.replace(d_c="0.000008")) == hash(SLIDER)
    with pytest.raises(slipmode.SlipmodeError, match="an array is a list"):
        SLIDER.replace(a=(1, 2, 3))


def test_numbers_of_uncertainties_are_values_with_errors():
    uncertainties = pytest.importorskip("uncertainties")
    slider = SLIDER.replace(a=uncertainties.ufloat(0.0078125, 0.0009765625))
    assert slider == SLIDER.replace(a="0.0078125±0.0009765625") and slider.is_uncertain


def test_quantities_of_pint_have_their_unit():
    pint = pytest.importorskip("pint")
    units = pint.UnitRegistry()
    assert SLIDER.replace(d_c=8 * units.um, k=2 * units.MPa / units.mm, m=2400 * units.kg / units.m**2) == SLIDER
    stresses = np.array([0.1, 5.0, 20.0]) * units.MPa
    found = slipmode.classify(**VALUES | {"sigma": stresses})
    assert np.asarray(found.slip_mode).tolist() == modes_of(STRESSES)
    with pytest.raises(slipmode.SlipmodeError, match='^d_c = "8 s": s is a time'):
        SLIDER.replace(d_c=8 * units.s)


def test_a_slider_does_not_change():
    assert pickle.loads(pickle.dumps(SLIDER)) == SLIDER and {SLIDER: 1}[SLIDER.replace()] == 1
    assert (SLIDER.a, SLIDER.d_c, SLIDER.replace(b=0.02).b) == ("0.009", "8um", 0.02)
    for change in (lambda: setattr(SLIDER, "b", "0.02"), lambda: delattr(SLIDER, "b"), lambda: setattr(SLIDER, "x", 1)):
        with pytest.raises(AttributeError, match="does not change"):
            change()
    point = slipmode.OperatingPoint(sigma="5MPa", v="10um/s")
    assert SLIDER.classify(point) == SLIDER.classify("5MPa", "10um/s") and point != SLIDER
    assert "5MPa" in point._repr_html_() and "8um" in SLIDER._repr_html_()
    assert point.replace(sigma=1e6).sigma == 1e6 and pickle.loads(pickle.dumps(point)) == point


def test_records_have_tables_and_plots_return_axes():
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib").use("Agg")
    from matplotlib import pyplot

    assert SLIDER.classify(5e6, 1e-5).to_pandas()["slip_mode"] == "stick-slip"
    (place,) = SLIDER.solve("k", sigma="5MPa", v="10um/s", transition=True)
    for record in (place, SLIDER.distance(5e6, 1e-5), SLIDER.roots(5e6, 1e-5)[0]):
        assert record.to_pandas().to_dict() == vars(record) and str([*vars(record)][0]) in record._repr_html_()
    run = SLIDER.simulate("5MPa", "10um/s", law="slip", rtol="1e-6")
    assert run.to_pandas()["mode"] == "periodic"
    _, ax = pyplot.subplots()
    found = SLIDER.map(("10kPa", "100MPa", 11), ("1um/s", "1cm/s", 9))
    for drawn in (found.plot(ax=ax), SLIDER.boundary(n=5).plot(), run.trajectory(samples=50).plot()):
        assert drawn.get_xlabel() and drawn.get_ylabel()
    assert found.plot(ax) is ax
    pyplot.close("all")


def test_a_table_that_lacks_columns_is_refused_by_name():
    with pytest.raises(slipmode.SlipmodeError, match="evolution_effect"):
        slipmode.compare({"a": [1]})
    with pytest.warns(slipmode.SlipmodeWarning, match="^sigma = 5: looks like MPa.*every row") as warned:
        slipmode.classify(**VALUES | {"sigma": np.full(280, 5.0)})
    assert len(warned) == 1 and warned[0].filename == __file__
