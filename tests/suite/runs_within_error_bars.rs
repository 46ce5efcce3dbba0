//! `simulate`, `compare` and `sweep` with error bars: ranges over runs at the middle, at every corner and at points between.

use serde_json::Value;

use crate::harness::{HEADER, Workplace};

/// A laboratory slider at 5 MPa and 10 µm/s whose K is two thirds of K_c.
const POINT: [&str; 7] = ["0.009", "0.0126", "8e-6", "1.5e9", "2400", "5e6", "1e-5"];
const OPTIONS: [&str; 7] = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"];
const BARS: [(&str, &str); 2] = [("-a", "0.009±0.0002"), ("-b", "0.0126±0.0004")];
const RANGES: [&str; 5] =
    ["peak_velocity_m_per_s", "minimum_velocity_log10_ratio", "period_s", "stress_drop_pa", "frequency_hz"];

fn with(changes: &[(&str, &str)]) -> Vec<String> {
    let value = |option: &str, value: &str| {
        let changed = changes.iter().find(|(changed, _)| *changed == option);
        changed.map_or(value, |(_, text)| *text).to_string()
    };
    OPTIONS.into_iter().zip(POINT).flat_map(|(option, text)| [option.into(), value(option, text)]).collect()
}

fn simulate(changes: &[(&str, &str)], more: &[&str]) -> String {
    let given = with(changes);
    let arguments = ["simulate", "--law", "slip"].iter().chain(more).copied();
    Workplace::new().run(arguments.chain(given.iter().map(String::as_str))).expect_success()
}

fn json(changes: &[(&str, &str)], more: &[&str]) -> Value {
    serde_json::from_str(&simulate(changes, &[&["--json"], more].concat())).unwrap()
}

fn ends(range: &Value) -> [f64; 2] {
    [0, 1].map(|end| range[end].as_f64().unwrap())
}

/// The row of [`POINT`] with other values of a and b.
fn row(a: &str, b: &str) -> String {
    format!("{a},{b},{}", POINT[2..].join(","))
}

#[test]
fn the_middle_run_stays_and_ranges_hold_all_corners_with_their_errors() {
    let mut found = json(&BARS, &[]);
    let within = found["within_error_bars"].take();
    let middle = json(&[], &[]);
    for (key, value) in middle.as_object().unwrap() {
        assert!(key == "inputs" || found[key] == *value, "{key}");
    }
    assert_eq!(found["inputs"]["direct_effect"], serde_json::json!([0.0088, 0.0092]));
    for (key, wanted) in [("strength", "sampled"), ("mode", "periodic"), ("slip_mode", "stick-slip")] {
        assert_eq!(within[key], wanted);
    }
    for (key, wanted) in [("runs", 37), ("corners", 4), ("spread_points", 32), ("failed", 0)] {
        assert_eq!(within[key], wanted, "{key}");
    }
    let corners = [("0.0088", "0.0122"), ("0.0088", "0.013"), ("0.0092", "0.0122"), ("0.0092", "0.013")];
    let corners = corners.map(|(a, b)| json(&[("-a", a), ("-b", b)], &[]));
    for key in RANGES {
        let [low, high] = ends(&within[key]);
        let values = corners.each_ref().map(|corner| corner[key].as_f64().unwrap());
        let [least, greatest] = [
            values.iter().copied().fold(f64::MAX, f64::min),
            values.iter().copied().fold(f64::MIN, f64::max),
        ];
        assert!(low < least && greatest < high, "{key}: errors are added");
        // Each of these rises or falls with a and with b, so that corners are extreme.
        assert!(least - low < 1e-7 * least.abs() && high - greatest < 1e-7 * greatest.abs(), "{key}");
    }
    assert_eq!(within["linear_theory"]["certain"], true);
    assert_eq!(within["linear_theory"]["slip_modes"][0]["mode"], "stick-slip");
}

#[test]
fn more_runs_never_narrow_a_range_and_threads_do_not_matter() {
    let [few, many] = ["0", "50"].map(|runs| json(&BARS, &["--box-runs", runs]));
    assert_eq!(few["within_error_bars"]["runs"], 5);
    assert_eq!(many["within_error_bars"]["runs"], 55);
    for key in RANGES {
        let ([least, largest], [low, high]) =
            (ends(&few["within_error_bars"][key]), ends(&many["within_error_bars"][key]));
        assert!(low <= least && largest <= high, "{key}");
    }
    assert_eq!(simulate(&BARS, &["--threads", "1"]), simulate(&BARS, &["--threads", "2"]));
    let given = with(&[]);
    let refused = ["simulate", "--law", "slip", "--box-runs", "5"].into_iter();
    Workplace::new()
        .run(refused.chain(given.iter().map(String::as_str)))
        .expect_refusal(&["--box-runs = 5", "values with error bars"]);
}

#[test]
fn a_box_across_the_transition_has_both_modes_and_the_theory_decides_exactly() {
    let bars = [BARS[0], BARS[1], ("-k", "2e9")];
    let within = json(&bars, &[])["within_error_bars"].take();
    assert_eq!(within["mode"], "decaying;periodic");
    let runs = within["modes"].as_array().unwrap().iter().map(|mode| mode["runs"].as_u64().unwrap());
    assert_eq!(runs.sum::<u64>(), 37);
    assert_eq!(within["linear_theory"]["certain"], false);
    let text = simulate(&bars, &[]);
    for part in [
        "the middle of the error bars:",
        "all values within the error bars, sampled:",
        "37  (the middle, 4 corners and 32 points)",
        "cycles and decays together",
        "linear theory, all values within the error bars, exact:",
        "possible slip mode",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn rows_have_ranges_in_their_cells_and_other_rows_the_same_bytes() {
    let place = Workplace::new();
    let plain = row("0.009", "0.0126");
    place.write("plain.csv", format!("{HEADER}\n{plain}\n"));
    let alone = place.run(["simulate", "--law", "slip", "--points", "plain.csv"]).expect_success();
    let rows = [plain.clone(), row("0.009±0.0002", "0.0126±0.0004")].join("\n");
    place.write("cells.csv", format!("{HEADER}\n{rows}\n"));
    let cells = place.run(["simulate", "--law", "slip", "--points", "cells.csv"]).expect_success();
    assert!(cells.starts_with(&alone));
    let columns = format!("{HEADER},a_std,evolution_effect_error\n{plain},0.0002,0.0004\n");
    place.write("columns.csv", columns);
    let ended = place.run(["simulate", "--law", "slip", "--points", "columns.csv"]);
    assert_eq!(ended.code, 0);
    let within = json(&BARS, &[])["within_error_bars"].take();
    for (text, skipped) in [(cells, 1), (ended.stdout, 0)] {
        let mut reader = csv_rows(&text);
        let header = reader.remove(0);
        let row = &reader[skipped];
        let of = |name: &str| &row[header.iter().position(|other| other == name).unwrap()];
        assert_eq!((of("mode").as_str(), of("slip_mode").as_str()), ("periodic", "stick-slip"));
        assert_eq!(of("status"), "sampled: 37 runs");
        for key in RANGES {
            let cell = of(key).strip_prefix('[').and_then(|cell| cell.strip_suffix(']')).unwrap();
            let numbers: Vec<f64> = cell.split(", ").map(|end| end.parse().unwrap()).collect();
            for (number, end) in numbers.into_iter().zip(ends(&within[key])) {
                // The reader of JSON may err by one unit in the last place.
                assert!((number / end - 1.0).abs() <= f64::EPSILON, "{key}");
            }
        }
    }
}

/// The cells of lines without doubled quotation marks.
fn csv_rows(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| {
        let mut cells = vec![String::new()];
        let mut is_quoted = false;
        for character in line.chars() {
            match character {
                '"' => is_quoted = !is_quoted,
                ',' if !is_quoted => cells.push(String::new()),
                other => cells.last_mut().unwrap().push(other),
            }
        }
        cells
    };
    text.lines().map(row).collect()
}

/// The verdicts of rows with a period, a peak and a mode, and the exit code.
fn compared(place: &Workplace, rows: &[(String, &str)], more: &[&str]) -> (Value, i32) {
    let lines: String = rows.iter().map(|(row, values)| format!("{row},{values}\n")).collect();
    place.write("runs.csv", format!("{HEADER},period_s,peak_velocity_m_per_s,mode\n{lines}"));
    let arguments = ["compare", "--json", "--runs", "runs.csv"].into_iter().chain(more.iter().copied());
    let ended = place.run(arguments);
    (serde_json::from_str(&ended.stdout).unwrap_or_else(|_| panic!("{}", ended.stderr)), ended.code)
}

#[test]
fn a_run_agrees_within_the_error_bars_of_its_parameters() {
    let place = Workplace::new();
    let bars = || row("0.009±0.0002", "0.0126±0.0004");
    // The middle run has 28.80108 s and 0.0803359 m/s; the error bars reach from 23.7 to 33.7 s and from 0.055 to 0.103 m/s.
    let rows = [
        (row("0.009", "0.0126"), "28.9,0.0803,periodic"),
        (bars(), "28.9,0.0803,periodic"),
        (bars(), "26,0.07,periodic"),
        (row("0.009", "0.0126"), "26,0.07,periodic"),
        (bars(), "33.9,0.0803,periodic"),
        (bars(), "40,0.0803,periodic"),
        (bars(), "26,0.07,decaying"),
    ];
    let (found, code) = compared(&place, &rows, &[]);
    let verdicts: Vec<&str> =
        found["rows"].as_array().unwrap().iter().map(|row| row["verdict"].as_str().unwrap()).collect();
    let within = "agrees-within-error-bars";
    assert_eq!(verdicts, ["agrees", "agrees", within, "differs", within, "differs", "differs"]);
    assert_eq!((code, &found["agree"], &found["agree_within_error_bars"]), (1, &4.into(), &2.into()));
    let finding = |row: usize, name: &str| {
        let findings = found["rows"][row]["findings"].as_array().unwrap();
        findings.iter().find(|finding| finding["observable"] == name).unwrap().clone()
    };
    let period = finding(2, "period_s");
    assert_eq!((&period["verdict"], &period["difference"]), (&within.into(), &0.0.into()));
    let [low, high] = ends(&period["range"]);
    assert!(23.0 < low && low < 24.0 && 33.0 < high && high < 34.0, "{low} {high}");
    assert!(
        period["reason"].as_str().unwrap().contains("the sampled range of 37 runs within the error bars")
    );
    assert_eq!(finding(1, "period_s").get("range"), None, "the middle run decides");
    // 33.9 s is above the range by less than the tolerance.
    let difference = finding(4, "period_s")["difference"].as_f64().unwrap();
    assert!(difference > 0.0 && difference < 0.01, "{difference}");
    let mode = finding(6, "mode");
    assert_eq!(mode["reason"], "decaying in 0 of 37 sampled runs within the error bars");
    assert_eq!(finding(3, "period_s").get("range"), None);
    let few = compared(&place, &rows[2..3], &["--box-runs", "0"]);
    assert_eq!((few.1, &few.0["rows"][0]["verdict"]), (0, &within.into()));
    assert!(few.0["rows"][0]["reason"].as_str().unwrap().contains("of 5 runs"));
}

#[test]
fn the_page_and_the_rows_say_that_the_range_is_sampled() {
    let place = Workplace::new();
    let rows = [(row("0.009±0.0002", "0.0126±0.0004"), "26,0.07,periodic")];
    let (_, code) = compared(&place, &rows, &["--report", "page"]);
    assert_eq!(code, 0);
    let page = place.read("page/report.md");
    assert!(page.contains("1 of them only within the error bars of their parameters, sampled"), "{page}");
    assert!(
        page.contains("The range is sampled")
            && page.contains("the sampled range of 37 runs within the error bars")
    );
    let text = place.run(["compare", "--runs", "runs.csv"]).expect_success();
    assert!(text.contains("1 row: 1 agree (1 within their error bars, sampled), 0 differ"), "{text}");
    let csv = place.run(["compare", "--runs", "runs.csv", "-o", "-"]).expect_success();
    assert!(csv.contains(",agrees-within-error-bars,") && csv.contains("is the sampled range of"), "{csv}");
}

/// A scene of a sweep over the normal stress, with these parameters and this work.
fn sweep(work: &str, a: &str) -> String {
    let [_, b, d, k, m, _, v] = POINT;
    format!(
        "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = {a}\nevolution_effect = {b}\n\
         critical_slip_distance_m = {d}\nstiffness_pa_per_m = {k}\nmass_per_area_kg_per_m2 = {m}\n\
         loading_velocity_m_per_s = {v}\n[sweep]\n{work}\n[sweep.grid]\n\
         normal_stress_pa = {{ from = 1e6, to = 5e6, points = 2 }}\n"
    )
}

#[test]
fn sweeps_use_the_error_bars_of_scenes_and_of_lists() {
    let place = Workplace::new();
    place.write("classes.toml", sweep("work = \"classify\"", "\"0.009±0.0002\""));
    place.write(
        "runs.toml",
        sweep("work = \"simulate\"\nlaws = [\"slip\"]\ntolerance = 1e-8", "\"0.009±0.0002\""),
    );
    for (scene, folder) in [("classes.toml", "classes"), ("runs.toml", "runs")] {
        place.run(["sweep", scene, "--out", folder]).expect_success();
        place.run(["merge", folder, "-o", &format!("{folder}.csv")]).expect_success();
    }
    let row = |stress: &str| POINT.join(",").replace("0.009", "0.009±0.0002").replace("5e6", stress);
    place.write("in.csv", format!("{HEADER}\n{}\n{}\n", row("1e6"), row("5e6")));
    let classes = place.run(["classify", "--points", "in.csv"]).expect_success();
    let runs = place.run(["simulate", "--law", "slip", "--points", "in.csv"]).expect_success();
    for (swept, rows, columns) in [("classes.csv", classes, 7), ("runs.csv", runs, 13)] {
        let own = |text: &str, from: usize| -> Vec<Vec<String>> {
            let rows = csv_rows(text).into_iter().skip(1);
            rows.map(|row| row[from..from + columns].to_vec()).collect()
        };
        let from = if swept == "runs.csv" { 2 } else { 1 };
        assert_eq!(own(&place.read(swept), from), own(&rows, 7), "{swept}");
    }
    let low =
        sweep("work = \"classify\"", "\"0.009±0.0002\"") + "[inertial_threshold]\nfrequency_ratio = 0.4\n";
    place.write("low.toml", low);
    place.run(["sweep", "low.toml", "--out", "low"]).expect_refusal(&["inertial_threshold", "sqrt(1/5)"]);
    place.write("boundary.toml", sweep("work = \"boundary\"", "\"0.009±0.0002\""));
    place
        .run(["sweep", "boundary.toml", "--out", "boundary"])
        .expect_refusal(&["sweep: needs values without error bars", "classify or simulate"]);

    let list = "name = \"s\"\ntitle = \"S\"\n[sweep]\nwork = \"simulate\"\nlaws = [\"slip\"]\ntolerance = 1e-8\n\
        [sweep.list]\nfile = \"in.csv\"\n";
    place.write("list.toml", list);
    place.run(["sweep", "list.toml", "--out", "list"]).expect_success();
    place.run(["merge", "list", "-o", "list.csv"]).expect_success();
    assert!(place.read("list.csv").contains("sampled: 35 runs"));
}

#[test]
fn a_command_for_one_point_names_those_that_take_error_bars() {
    let given = with(&BARS);
    Workplace::new().run(["roots"].into_iter().chain(given.iter().map(String::as_str))).expect_refusal(&[
        "--direct-effect",
        "a value without an error bar",
        "`classify`",
        "`simulate`",
    ]);
}
