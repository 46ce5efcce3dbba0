//! `classify` with error bars: what is certain, what is possible and where, as text, JSON and rows.

use serde_json::Value;

use crate::harness::{HEADER, Workplace};

const OPTIONS: [&str; 7] = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"];
/// A laboratory slider at 5 MPa and 10 µm/s.
const POINT: [&str; 7] = ["0.009", "0.0126", "8e-6", "2e9", "2400", "5e6", "1e-5"];

/// The options of the point with some values replaced.
fn with<'a>(changes: &[(&str, &'a str)]) -> Vec<&'a str> {
    let value = |option: &str, value: &'static str| {
        changes.iter().find(|(changed, _)| *changed == option).map_or(value, |(_, text)| *text)
    };
    OPTIONS.into_iter().zip(POINT).flat_map(|(option, text)| [option, value(option, text)]).collect()
}

fn json(changes: &[(&str, &str)]) -> Value {
    let arguments = ["classify", "--json"].into_iter().chain(with(changes));
    serde_json::from_str(&Workplace::new().run(arguments).expect_success()).unwrap()
}

fn modes(found: &Value) -> Vec<&str> {
    found["slip_modes"].as_array().unwrap().iter().map(|mode| mode["mode"].as_str().unwrap()).collect()
}

#[test]
fn a_box_without_a_limit_in_it_is_certain() {
    let found = json(&[("-a", "0.009±0.0001"), ("-b", "0.0126+-0.0001")]);
    assert_eq!((&found["certain"], modes(&found)), (&true.into(), vec!["stick-slip"]));
    assert_eq!(
        (&found["undecided_share"], &found["transition_signs"]),
        (&0.0.into(), &serde_json::json!([-1, -1]))
    );
    let text = Workplace::new().run(["classify"].into_iter().chain(with(&[("-a", "[0.0089, 0.0091]")])));
    assert!(text.expect_success().contains("certain: all values within the error bars"));
}

#[test]
fn each_possible_mode_has_a_witness_that_classify_gives_the_same_name() {
    // K_c is 2.25e9 ± 20 % and K is 2e9.
    let found = json(&[("-b", "0.0126±0.0007"), ("-s", "5e6±1e5")]);
    assert_eq!(found["certain"], false);
    assert_eq!(modes(&found), ["non-inertial-underdamped-oscillation", "stick-slip"]);
    let range = found["critical_stiffness_pa_per_m"].as_array().unwrap();
    let [least, greatest] = [0, 1].map(|end| range[end].as_f64().unwrap());
    assert!((least / (0.0029 / 8e-6 * 4.9e6) - 1.0).abs() < 1e-6, "{least}");
    assert!((greatest / (0.0043 / 8e-6 * 5.1e6) - 1.0).abs() < 1e-6, "{greatest}");
    for possible in found["slip_modes"].as_array().unwrap() {
        let witness = possible["witness"].as_object().unwrap();
        let keys = ["direct_effect", "evolution_effect", "critical_slip_distance_m", "stiffness_pa_per_m"];
        let more = ["mass_per_area_kg_per_m2", "normal_stress_pa", "loading_velocity_m_per_s"];
        let values = keys.into_iter().chain(more).map(|key| witness[key].as_str().unwrap());
        let point = OPTIONS.into_iter().zip(values).flat_map(|(option, value)| [option, value]);
        let output = Workplace::new().run(["classify", "--json"].into_iter().chain(point)).expect_success();
        let again: Value = serde_json::from_str(&output).unwrap();
        assert_eq!(again["slip_mode"], possible["mode"]);
    }
}

#[test]
fn faulty_error_bars_are_all_reported_at_once() {
    let faulty = [
        ("-a", "0.009±0.01"),
        ("-b", "[0.02, 0.01]"),
        ("-d", "8e-6±x"),
        ("-k", "[1e9 2e9]"),
        ("-m", "2400+--1"),
        ("-s", "[0, 5e6±1e5]"),
        ("-v", "[0, 1e-5]"),
    ];
    Workplace::new().run(["classify"].into_iter().chain(with(&faulty))).expect_refusal(&[
        "--direct-effect = \"0.009±0.01\": the error is not smaller than the value",
        "(allowed: 1e-300 to 1e300)",
        "--evolution-effect = \"[0.02, 0.01]\": reversed range",
        "--critical-slip-distance-m = \"8e-6±x\": the error is no number",
        "--stiffness-pa-per-m = \"[1e9 2e9]\": a range has the form [lower, upper]",
        "--mass-per-area-kg-per-m2 = 2400+--1: the error is negative",
        "--normal-stress-pa = \"[0, 5e6±1e5]\": not a decimal number",
        "--loading-velocity-m-per-s = \"[0, 1e-5]\": must be > 0",
    ]);
    let threshold = with(&[("-a", "0.009±0.001")]).into_iter().chain(["--inertial-threshold", "0.4"]);
    Workplace::new()
        .run(["classify"].into_iter().chain(threshold))
        .expect_refusal(&["--inertial-threshold = 0.4: out of range", "sqrt(1/5)"]);
}

#[test]
fn a_row_names_undecided_modes_without_a_mark_and_has_their_share() {
    let values = "0.00426557±0.00012%,0.0700703,7.45722e-07±99.99999999%,9.73816e+11,211471±99.99999999%,6362,8.21826e-08";
    let certain = "0.004,0.006,1e-5,1e7,1000,1e5,1e-3";
    let rows = format!("{HEADER}\n{values}\n{certain}\n");
    let out = Workplace::new().run_with_input(["classify", "--points", "-"], &rows).expect_success();
    let lines: Vec<&str> = out.lines().collect();
    assert!(lines[0].ends_with(",undecided_share") && lines[2].ends_with(",0"), "{out}");
    assert!(lines[1].contains(";stick-slip;harmonic-vibration,\"["), "{out}");
    let share = lines[1].rsplit(',').next().unwrap();
    assert!((0.0..0.005).contains(&share.parse::<f64>().unwrap()) && share != "0", "{share}");
    let options = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"].into_iter().zip(values.split(','));
    let words = options.flat_map(|(option, value)| [option, value]);
    let object = Workplace::new().run(["classify", "--json"].into_iter().chain(words)).expect_success();
    let object: Value = serde_json::from_str(&object).unwrap();
    assert_eq!(object["undecided_share"], share.parse::<f64>().unwrap());
    assert_eq!(object["undecided"][0]["mode"], "harmonic-vibration");
}

#[test]
fn rows_take_error_bars_in_cells_and_in_columns_of_errors() {
    let place = Workplace::new();
    let point = POINT.join(",");
    let range = point.replace("0.0126", "\"[0.0119, 0.0133]\"");
    let cells = format!("{HEADER}\n{point}\n{}\n{range}\n", point.replace("0.0126", "0.0126±0.0007"));
    place.write("cells.csv", cells);
    let rows = place.run(["classify", "--points", "cells.csv"]).expect_success();
    place.write("points.csv", format!("{HEADER}\n{point}\n"));
    let alone = place.run(["classify", "--points", "points.csv"]).expect_success();
    assert!(rows.starts_with(&alone), "a row without error bars has the same bytes");
    let [uncertain, range] = [2, 3].map(|line| rows.lines().nth(line).unwrap());
    let words =
        ",-1;0;1,-1,stable-complex;unstable-complex;neutral,non-inertial-underdamped-oscillation;stick-slip,";
    let results = &uncertain[uncertain.find(words).expect("signs, classes and modes")..];
    assert!(range.ends_with(results), "{uncertain} {range}");
    let object = json(&[("-b", "0.0126±0.0007")]);
    let ends = |key: &str| {
        let end = |i: usize| object[key][i].as_f64().unwrap();
        assert!(end(0) < end(1), "{key}");
        [end(0), end(1)]
    };
    let keys = ["max_real_per_s", "max_imaginary_per_s", "frequency_hz", "critical_stiffness_pa_per_m"];
    let cells: Vec<&str> = results.split('"').collect();
    assert_eq!([cells[0], cells[2], cells[4], cells[6], cells[8]], [words, ",", ",exact,", ",", ",,,0"]);
    for (cell, key) in cells.iter().skip(1).step_by(2).zip(keys) {
        let numbers = cell.strip_prefix('[').and_then(|cell| cell.strip_suffix(']')).unwrap().split(", ");
        // The reader of JSON may err by one unit in the last place.
        for (number, end) in numbers.zip(ends(key)) {
            assert!((number.parse::<f64>().unwrap() / end - 1.0).abs() <= f64::EPSILON, "{key}: {cell}");
        }
    }
    let columns = format!("{HEADER},evolution_effect_error\n{point},0.0007\n{point},\n");
    place.write("columns.csv", columns);
    let ended = place.run(["classify", "--points", "columns.csv"]);
    assert_eq!(ended.stderr, "in SI: column evolution_effect_error: error of evolution_effect\n");
    let columns = ended.stdout;
    let [uncertain, certain] = [1, 2].map(|line| columns.lines().nth(line).unwrap().to_string());
    assert!(uncertain.ends_with(results), "{uncertain}");
    let values = alone.lines().nth(1).unwrap().strip_prefix(&point).unwrap();
    assert!(certain.ends_with(values), "{certain}");
    place.write(
        "twice.csv",
        format!("{HEADER},evolution_effect_error\n{},1e-4\n", point.replace("0.0126", "0.0126±0.0007")),
    );
    place
        .run(["classify", "--points", "twice.csv"])
        .expect_refusal(&["row 1, column evolution_effect_error", "given twice"]);
}

#[test]
fn shares_by_samples_stand_apart_from_what_is_certain() {
    let changes = [("-b", "0.0126±0.0007"), ("-s", "5e6±1e5")];
    let run = |more: &[&'static str]| {
        let arguments = ["classify", "--json"].into_iter().chain(with(&changes)).chain(more.iter().copied());
        let output = Workplace::new().run(arguments).expect_success();
        serde_json::from_str::<Value>(&output).unwrap()
    };
    let mut sampled = run(&["--distribution", "uniform", "--samples", "2000"]);
    let shares = sampled["sampled"].take();
    assert_eq!(sampled, run(&[]), "nothing else changes");
    assert_eq!((&shares["distribution"], &shares["samples"]), (&"uniform".into(), &2000.into()));
    let share = |mode: &str| {
        let all = shares["shares"].as_array().unwrap();
        let found = all.iter().find(|share| share["mode"] == mode).unwrap();
        [&found["share"], &found["sampling_error"]].map(|value| value.as_f64().unwrap())
    };
    // K < K_c where (b − a) σ > 16e3 Pa but for the inertia: 0.0126 ± 0.0007 at 5 MPa, above 0.0122.
    let [slip, error] = share("stick-slip");
    assert!((slip - 11.0 / 14.0).abs() < 0.01 + 4.0 * error, "{slip} ± {error}");
    assert!((slip + share("non-inertial-underdamped-oscillation")[0] - 1.0).abs() < 1e-12);
    assert_ne!(run(&["--distribution", "normal"])["sampled"]["shares"], shares["shares"]);
    let text = ["classify"].into_iter().chain(with(&changes)).chain(["--distribution", "normal"]);
    assert!(Workplace::new().run(text).expect_success().contains("of 10000 random points, normal"));
    let faulty = ["classify"].into_iter().chain(with(&[])).chain(["--distribution", "normal"]);
    Workplace::new().run(faulty).expect_refusal(&["--distribution = normal", "values with error bars"]);
    let faulty =
        ["classify"].into_iter().chain(with(&changes)).chain(["--distribution", "flat", "--samples", "9"]);
    Workplace::new().run(faulty).expect_refusal(&[
        "--distribution = flat",
        "--samples = 9",
        "100 to 100000000",
    ]);
}

#[test]
fn the_least_stiffness_that_is_stable_for_a_box_is_where_classify_changes_its_mind() {
    let bars = [("-a", "0.009±0.0003"), ("-b", "0.0126±0.0007"), ("-d", "8e-6±3e-7"), ("-s", "5e6±1e5")];
    let given =
        || with(&bars).chunks(2).filter(|pair| pair[0] != "-k").flatten().copied().collect::<Vec<_>>();
    let question = ["solve", "--json", "--for", "stiffness", "--stable-for-box", "--digits", "30"];
    let output = Workplace::new().run(question.into_iter().chain(given())).expect_success();
    let answer: Value = serde_json::from_str(&output).unwrap();
    let found = &answer["solutions"][0];
    let value = found["value"].as_str().unwrap();
    let signs = |stiffness: &str| {
        let mut bars = bars.to_vec();
        bars.push(("-k", stiffness));
        json(&bars)["transition_signs"].clone()
    };
    assert_eq!(signs(value), serde_json::json!([1, 1]), "rounded up");
    let below = format!("{:e}", value.parse::<f64>().unwrap() * (1.0 - 1e-12));
    assert_eq!(signs(&below), serde_json::json!([-1, 1]));
    assert_eq!(found["witness"]["direct_effect"], "0.0087");
    assert_eq!((&found["is_exact"], &answer["solved_for"]), (&false.into(), &"stiffness_pa_per_m".into()));
    let none = ["solve", "--for", "stiffness", "--stable-for-box"];
    let strengthening = with(&[("-b", "[0.007, 0.009]")]);
    let strengthening = strengthening.chunks(2).filter(|pair| pair[0] != "-k").flatten().copied();
    let text = Workplace::new().run(none.into_iter().chain(strengthening)).expect_success();
    assert!(text.starts_with("every stiffness"), "{text}");
    let faulty = ["solve", "--for", "mass", "--stable-for-box"].into_iter().chain(with(&[("-a", "1±2")]));
    Workplace::new().run(faulty).expect_refusal(&[
        "--stable-for-box",
        "--for stiffness",
        "--stiffness-pa-per-m = 2e9",
        "--direct-effect = \"1±2\": the error is not smaller than the value",
    ]);
}

#[test]
fn ranges_hold_the_values_of_the_corners_and_are_attained() {
    let ends = [("-b", ["0.0119", "0.0133"]), ("-s", ["4.9e6", "5.1e6"]), ("-v", ["9e-6", "1.1e-5"])];
    let bars = ends.map(|(option, [low, high])| (option, format!("[{low}, {high}]")));
    let found = json(&bars.each_ref().map(|(option, text)| (*option, text.as_str())));
    let keys = ["max_real_per_s", "max_imaginary_per_s", "frequency_hz"];
    let range = |from: &Value, key: &str| [0, 1].map(|end| from[key][end].as_f64().unwrap());
    for corner in 0..8 {
        let point = std::array::from_fn::<_, 3, _>(|i| (ends[i].0, ends[i].1[corner >> i & 1]));
        let at_corner = json(&point);
        for key in keys {
            let ([low, high], value) = (range(&found, key), at_corner[key].as_f64().unwrap());
            assert!(low <= value && value <= high, "{key}: {value} in {low} to {high}");
        }
    }
    for key in keys {
        let (enclosed, attained) = (range(&found, key), range(&found["attained"], key));
        for end in 0..2 {
            assert!((enclosed[end] / attained[end] - 1.0).abs() < 1e-8, "{key}");
        }
    }
}

#[test]
fn ranges_in_words_hold_those_of_the_json() {
    let names = ["max Re(s)", "max Im(s)", "frequency", "K_c"];
    let keys = ["max_real_per_s", "max_imaginary_per_s", "frequency_hz", "critical_stiffness_pa_per_m"];
    for bars in ["0.0126±0.0007", "0.0126±1e-6%", "0.0126±1e-12%"] {
        let found = json(&[("-b", bars)]);
        let text =
            Workplace::new().run(["classify"].into_iter().chain(with(&[("-b", bars)]))).expect_success();
        for (name, key) in names.into_iter().zip(keys) {
            let line = text.lines().find_map(|line| line.strip_prefix(name)).unwrap();
            let words: Vec<&str> = line.split_whitespace().collect();
            let [least, most] = [0, 2].map(|at| words[at].parse::<f64>().unwrap());
            let [low, high] = [0, 1].map(|end| found[key][end].as_f64().unwrap());
            // The ends of K_c are rational, and those of the JSON the next numbers of 64 bits.
            let holds = least <= low.next_up() && high.next_down() <= most;
            assert!(holds && words[1] == "to", "{bars}: {low} to {high} as{line}");
            assert!(
                most - least <= 1.5 * (high - low) + 1e-15 * most.abs(),
                "{bars}: {low} to {high} as{line}"
            );
        }
    }
}

/// The options of the point without one of them.
fn without<'a>(option: &str, bars: &[(&str, &'a str)]) -> Vec<&'a str> {
    let all = with(bars);
    all.chunks(2).filter(|pair| pair[0] != option).flatten().copied().collect()
}

#[test]
fn solutions_over_error_bars_enclose_those_of_corners() {
    let bars = [("-a", "[0.0089, 0.0091]"), ("-b", "[0.0125, 0.0127]")];
    for (target, unknown, option) in [
        (&["--transition"][..], "normal-stress", "-s"),
        (&["--boundary"], "loading-velocity", "-v"),
        (&["--frequency", "0.1"], "normal-stress", "-s"),
        (&["--frequency", "0.1"], "mass", "-m"),
        (&["--growth-rate", "0.05"], "stiffness", "-k"),
    ] {
        let solve = |bars: &[(&str, &str)]| -> Vec<Value> {
            let question = ["solve", "--json", "--for", unknown].into_iter().chain(target.iter().copied());
            let output = Workplace::new().run(question.chain(without(option, bars))).expect_success();
            let answer: Value = serde_json::from_str(&output).unwrap();
            assert_eq!(answer["schema"], 1);
            answer["solutions"].as_array().unwrap().clone()
        };
        let ranges: Vec<[f64; 2]> = solve(&bars)
            .iter()
            .map(|found| [0, 1].map(|end| found["range"][end].as_f64().unwrap_or(f64::INFINITY)))
            .collect();
        let mut met = vec![false; ranges.len()];
        for corner in [["0.0089", "0.0125"], ["0.0089", "0.0127"], ["0.0091", "0.0125"], ["0.0091", "0.0127"]]
        {
            for solution in solve(&[("-a", corner[0]), ("-b", corner[1])]) {
                let value: f64 = solution["value"].as_str().unwrap().parse().unwrap();
                let index = ranges.iter().position(|[low, high]| *low <= value && value <= *high);
                met[index.unwrap_or_else(|| panic!("{target:?} {unknown}: {value} in {ranges:?}"))] = true;
            }
        }
        assert!(met.iter().all(|met| *met), "{target:?} {unknown}: {ranges:?}");
    }
    let fast = ["solve", "--for", "normal-stress", "--frequency", "160"].into_iter();
    let none = Workplace::new().run(fast.chain(without("-s", &bars))).expect_success();
    assert!(none.starts_with("none: no normal stress"), "{none}");
}

#[test]
fn rows_with_error_bars_are_solved_as_ranges() {
    let place = Workplace::new();
    let point = POINT.join(",");
    place.write("rows.csv", format!("{HEADER}\n{point}\n{}\n", point.replace("0.0126", "0.0126±0.0007")));
    let rows = |question: &[&str]| {
        let output = place.run(question.iter().copied().chain(["--points", "rows.csv"])).expect_success();
        output.lines().skip(1).map(str::to_string).collect::<Vec<_>>()
    };
    let found = rows(&["solve", "--for", "normal-stress", "--transition"]);
    // K D_c/(b − a) less M V0²/(a D_c), which is 3.3 Pa.
    assert!(found[0].ends_with(",1,4.4444411111111111e6,,,,solved"), "{}", found[0]);
    let range = found[1].split('"').nth(1).unwrap().trim_matches(['[', ']']).to_string();
    let ends: Vec<f64> = range.split(", ").map(|end| end.parse().unwrap()).collect();
    for (end, expected) in ends.iter().zip([16e3 / 0.0043 - 10.0 / 3.0, 16e3 / 0.0029 - 10.0 / 3.0]) {
        assert!((end / expected - 1.0).abs() < 1e-9, "{range}");
    }
    let stable = rows(&["solve", "--for", "stiffness", "--stable-for-box", "--digits", "6"]);
    for (row, least) in stable.iter().zip([450.0, 537.5].map(|slope| slope * (5e6 + 10.0 / 3.0))) {
        let value = row.strip_suffix(",,,,solved").and_then(|row| row.rsplit(',').next()).unwrap();
        let excess = value.parse::<f64>().unwrap() / least - 1.0;
        assert!((0.0..2e-5).contains(&excess), "{row}");
    }
}

/// The limits of eqs 15, 16, 18 and 20 for 1 %.
fn limits(a: &str, b: &str, d: &str, k: &str, m: &str) -> Vec<Value> {
    let slider = ["-a", a, "-b", b, "-d", d, "-k", k, "-m", m];
    let arguments = ["tolerance", "--json", "-e", "0.01"].into_iter().chain(slider);
    let found: Value = serde_json::from_str(&Workplace::new().run(arguments).expect_success()).unwrap();
    found["formulas"].as_array().unwrap().clone()
}

#[test]
fn a_formula_is_good_for_all_values_up_to_the_limit_of_the_worst_corner() {
    let over_box = limits("0.009±0.0005", "[0.0119, 0.0133]", "[7e-6, 9e-6]", "2e9±1e8", "2400±100");
    // V0 below, V0 below, σ above, σ below: the corners with the least, least, greatest and least limit.
    let worst = [
        limits("0.0085", "0.0133", "7e-6", "1.9e9", "2500"),
        limits("0.0085", "0.0133", "7e-6", "1.9e9", "2500"),
        limits("0.0095", "0.0119", "9e-6", "2.1e9", "2400"),
        limits("0.0095", "0.0133", "7e-6", "1.9e9", "2400"),
    ];
    let middle = limits("0.009", "0.0126", "8e-6", "2e9", "2400");
    for (index, row) in over_box.iter().enumerate() {
        assert_eq!(row["limit"], worst[index][index]["limit"], "{row}");
        let (key, certain) = row["limit"].as_object().unwrap().iter().next().unwrap();
        let [certain, middle, best] = [certain, &middle[index]["limit"][key], &row["farthest_limit"][key]]
            .map(|it| it.as_f64().unwrap());
        let order = if index == 2 { [best, middle, certain] } else { [certain, middle, best] };
        assert!(order.is_sorted(), "{row}");
        assert_eq!(row["reason"], Value::Null);
    }
    let straddling = limits("0.009±0.002", "0.01", "8e-6", "2e9", "2400");
    for (row, exists) in straddling.iter().zip([false, true, false, true]) {
        assert_eq!(row["reason"].is_null(), exists, "{row}");
        assert_eq!(row["limit"].as_object().unwrap().values().all(Value::is_null), !exists);
    }
    let text = ["tolerance", "-a", "0.009±0.002", "-b", "0.01", "-d", "8e-6", "-k", "2e9", "-m", "2400"];
    let text = Workplace::new().run(text).expect_success();
    assert!(text.contains("a = b lies within the error bars") && text.contains("σ = "), "{text}");
    for a in ["0.004", "0.004±1%"] {
        let close = ["tolerance", "-a", a, "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000"];
        let error = ["-e", "0.99999999999999"];
        let text = Workplace::new().run(close.into_iter().chain(error)).expect_success();
        let line = text.lines().find(|line| line.starts_with("eq18")).unwrap();
        assert!(line.contains(" 0.99999999999999 σ above"), "{line}");
    }
}
