//! `compare`: runs of other programs get the verdicts they deserve.

use std::path::Path;

use serde_json::Value;

use crate::harness::{Ended, HEADER, ROW, Workplace, names_in};

/// What an independent program found for [`ROW`] under the slip law (examples/compare/make.py gives its trajectory).
const PERIOD: f64 = 0.26140076;
const PEAK: f64 = 0.009124622;

fn compare(rows: &str, more: &[&str]) -> Ended {
    let arguments = ["compare", "--runs", "-"];
    Workplace::new().run_with_input(arguments.iter().chain(more).copied(), rows)
}

/// The object of a comparison, and its exit code.
fn object(rows: &str, more: &[&str]) -> (Value, i32) {
    let more: Vec<&str> = more.iter().chain(&["--json"]).copied().collect();
    let ended = compare(rows, &more);
    (serde_json::from_str(&ended.stdout).unwrap_or_else(|_| panic!("{}", ended.stderr)), ended.code)
}

/// The trajectory of one run, by `simulate`, in a folder of its own with its runs file.
fn simulated(point: [&str; 7], law: &str) -> Workplace {
    simulated_with(point, law, &[])
}

/// As `simulated`, with more options of `simulate`.
fn simulated_with(point: [&str; 7], law: &str, more: &[&str]) -> Workplace {
    let place = Workplace::new();
    let options = ["-a", "-b", "-d", "-k", "-m", "-s", "-v"];
    let point_options = options.iter().zip(&point).flat_map(|(option, value)| [*option, *value]);
    let arguments = ["simulate", "--law", law, "--trajectory", "t.csv"].into_iter().chain(point_options);
    place.run(arguments.chain(more.iter().copied())).expect_success();
    place.write("runs.csv", format!("{HEADER},law,trajectory\n{},{law},t.csv\n", point.join(",")));
    place
}

#[test]
fn values_that_agree_end_with_success_and_others_with_one() {
    let rows =
        |peak: f64| format!("{HEADER},period_s,peak_velocity_m_per_s,mode\n{ROW},{PERIOD},{peak},periodic\n");
    let (found, code) = object(&rows(PEAK), &["--tolerance", "1e-6"]);
    assert_eq!((code, &found["agree"]), (0, &1.into()));
    let (found, code) = object(&rows(1.02 * PEAK), &[]);
    assert_eq!((code, &found["rows"][0]["verdict"]), (1, &"differs".into()));
    let findings = found["rows"][0]["findings"].as_array().unwrap();
    let of = |name: &str| findings.iter().find(|finding| finding["observable"] == name).unwrap();
    assert_eq!(of("period_s")["verdict"], "agrees");
    let peak = of("peak_velocity_m_per_s");
    assert_eq!(peak["verdict"], "differs");
    assert!((peak["difference"].as_f64().unwrap() - 0.02).abs() < 1e-6);
    // The same value agrees with a user who says that it is only good to three percent.
    assert_eq!(object(&rows(1.02 * PEAK), &["--tolerance", "0.03"]).1, 0);
    let stated = format!(
        "{HEADER},peak_velocity_m_per_s,tolerance\n{ROW},{},0.03\n{ROW},{},\n",
        1.02 * PEAK,
        1.02 * PEAK
    );
    let (found, _) = object(&stated, &[]);
    assert_eq!((&found["agree"], &found["differ"]), (&1.into(), &1.into()));
}

#[test]
fn the_law_is_slip_unless_it_is_stated() {
    let rows = format!("{HEADER},period_s\n{ROW},{PERIOD}\n");
    assert_eq!(compare(&rows, &[]).code, 0);
    assert_eq!(compare(&rows, &["--law", "slip"]).code, 0);
    assert_eq!(compare(&rows, &["--law", "aging"]).code, 1);
    let column = format!("{HEADER},law,period_s\n{ROW},aging,0.3955105\n{ROW},slip,{PERIOD}\n");
    assert_eq!(compare(&column, &[]).code, 0);
}

#[test]
fn a_mode_is_held_against_theory_and_simulation() {
    let mode = |word: &str| object(&format!("{HEADER},mode\n{ROW},{word}\n"), &[]);
    for word in ["periodic", "stick-slip"] {
        assert_eq!(mode(word).1, 0, "{word}");
    }
    for word in ["decaying", "harmonic-vibration"] {
        let (found, code) = mode(word);
        assert_eq!(code, 1, "{word}");
        for finding in found["rows"][0]["findings"].as_array().unwrap() {
            assert_eq!(finding["verdict"], "differs", "{finding}");
        }
    }
}

#[test]
fn frequencies_of_decays_are_held_against_the_roots() {
    let row = "0.004,0.006,1e-5,1e7,1000,1e4,1e-5";
    let (found, code) = object(&format!("{HEADER},frequency_hz\n{row},0.194973\n"), &["--tolerance", "1e-5"]);
    let findings = found["rows"][0]["findings"].as_array().unwrap();
    let references: Vec<_> = findings.iter().map(|finding| finding["reference"].as_str().unwrap()).collect();
    assert_eq!((code, references), (0, vec!["simulation", "theory"]));
    // All roots are real at K = 50 K_c: a frequency has nothing to agree with.
    let still = format!("{HEADER},frequency_hz\n0.004,0.006,1e-5,1e7,1000,1e3,1e-6,0.2\n");
    let (found, code) = object(&still, &[]);
    assert_eq!((code, &found["rows"][0]["verdict"]), (1, &"differs".into()));
}

#[test]
fn peaks_of_transients_need_a_start() {
    let row = "0.004,0.006,1e-5,1e7,1000,1e4,1e-5";
    let place = Workplace::new();
    place.write("points.csv", format!("{HEADER},law\n{row},slip\n"));
    let simulated = place.run(["simulate", "--points", "points.csv"]).expect_success();
    let peak = simulated.lines().nth(1).unwrap().split(',').nth(10).unwrap().to_string();
    let (found, code) = object(&format!("{HEADER},peak_velocity_m_per_s\n{row},{peak}\n"), &[]);
    assert_eq!((code, &found["rows"][0]["verdict"]), (1, &"not-compared".into()));
    assert!(found["rows"][0]["reason"].as_str().unwrap().contains("name it in a column `start`"));
    let with_start = |start: &str| {
        compare(&format!("{HEADER},peak_velocity_m_per_s,start\n{row},{peak},{start}\n"), &[]).code
    };
    assert_eq!((with_start("steady-at-velocity"), with_start("velocity-kick")), (0, 1));
}

#[test]
fn what_simulate_writes_agrees_with_itself() {
    let place = Workplace::new();
    place.write("points.csv", format!("{HEADER},law\n{ROW},slip\n{ROW},aging\n"));
    place.run(["simulate", "--points", "points.csv", "-o", "runs.csv"]).expect_success();
    let text = place.run(["compare", "--runs", "runs.csv", "--tolerance", "1e-7"]).expect_warnings();
    assert!(text.ends_with("2 rows: 2 agree, 0 differ, 0 not compared\n"), "{text}");
}

#[test]
fn trajectories_are_reduced_to_what_they_do_long_term() {
    let paper = ["0.004", "0.006", "1e-5", "1e7", "1000"];
    let cases = [
        // A decay dies within a few returns, which then resolve it to a percent or two.
        // Deep stick-slip, a decaying oscillation, a decay without one: what each must be compared by.
        (
            ["3162277.66", "3.16227766e-6"],
            "slip",
            ["peak_velocity_m_per_s", "period_s", "stress_drop_pa"].as_slice(),
            "1e-3",
        ),
        (["1e4", "1e-5"], "slip", &["period_s", "growth_rate_per_s"], "2e-2"),
        (["1e3", "1e-6"], "aging", &["growth_rate_per_s"], "5e-2"),
    ];
    for ([stress, velocity], law, wanted, tolerance) in cases {
        let point = [paper[0], paper[1], paper[2], paper[3], paper[4], stress, velocity];
        let ended =
            simulated(point, law).run(["compare", "--runs", "runs.csv", "--json", "--tolerance", tolerance]);
        let found: Value = serde_json::from_str(&ended.expect_success()).unwrap();
        let findings = found["rows"][0]["findings"].as_array().unwrap();
        for name in wanted {
            let of_it = findings.iter().filter(|finding| finding["observable"] == *name);
            assert!(of_it.clone().count() > 0, "{name} {stress}");
            of_it.for_each(|finding| assert_eq!(finding["verdict"], "agrees", "{finding}"));
        }
    }
}

#[test]
fn a_trajectory_that_has_not_settled_is_not_compared() {
    // 2.5 % below K_c ten periods are not enough for the way to the cycle, 1.5 % above it not enough for the decay.
    for (stress, law) in [("5.1e4", "slip"), ("4.9e4", "aging")] {
        let place = simulated(["0.004", "0.006", "1e-5", "1e7", "1000", stress, "1e-4"], law);
        let ended = place.run(["compare", "--runs", "runs.csv", "--json", "--tolerance", "1e-3"]);
        let found: Value = serde_json::from_str(&ended.stdout).unwrap();
        let findings = found["rows"][0]["findings"].as_array().unwrap();
        let numbers = findings.iter().filter(|finding| finding["observable"] != "mode");
        numbers.for_each(|finding| assert_eq!(finding["verdict"], "not-compared", "{finding}"));
        assert_eq!(found["differ"], 0);
        if law == "aging" {
            assert_eq!((ended.code, &found["not_compared"]), (1, &1.into()), "{}", ended.stdout);
            assert!(found["rows"][0]["reason"].as_str().unwrap().contains("has not converged"));
        }
    }
}

#[test]
fn a_coarse_trajectory_decides_no_more_than_it_resolves() {
    let place = simulated(["0.004", "0.006", "1e-5", "1e7", "1000", "1e5", "1e-3"], "slip");
    let whole = place.read("t.csv");
    let header = whole.lines().next().unwrap().to_string();
    let coarse: Vec<&str> = whole.lines().skip(1).step_by(32).collect();
    place.write("t.csv", format!("{header}\n{}\n", coarse.join("\n")));
    let ended = place.run(["compare", "--runs", "runs.csv", "--json", "--tolerance", "1e-6"]);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    let findings = found["rows"][0]["findings"].as_array().unwrap();
    let peak = findings.iter().find(|finding| finding["observable"] == "peak_velocity_m_per_s").unwrap();
    assert_eq!(peak["verdict"], "not-compared", "{peak}");
    // What it does resolve is within its own error of the truth.
    let error = peak["run"]["relative_error"].as_f64().unwrap();
    assert!(peak["difference"].as_f64().unwrap().abs() <= error && error < 0.5, "{peak}");
}

/// Deep stick-slip, K from 0.05 to 0.8 of K_c: at equal steps of time a slip lies between two samples.
#[test]
fn equal_steps_of_random_stick_slip_never_differ_from_itself() {
    let mut state = 1_u64;
    let mut random = |low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut compared, mut agreeing) = (0, 0);
    for (index, samples) in ["2001", "5001", "10001", "20001", "50001"].iter().cycle().take(15).enumerate() {
        let (law, a) = (["slip", "aging"][index % 2], random(0.004, 0.012));
        let (b, mut power) = (a * random(1.2, 2.5), |low, high| libm::pow(10.0, random(low, high)));
        let (d_c, v, sigma, m) = (power(-6.0, -4.5), power(-6.0, -3.0), power(5.5, 7.0), power(2.0, 4.0));
        let k = (b - a) * sigma / d_c * power(-1.3, -0.1);
        let point = [a, b, d_c, k, m, sigma, v].map(|value| format!("{value:.5e}"));
        let point = point.each_ref().map(String::as_str);
        let place = simulated_with(point, law, &["--tolerance", "1e-6", "--samples", samples]);
        for tolerance in ["1e-2", "1e-3"] {
            let ended = place.run(["compare", "--runs", "runs.csv", "--json", "--tolerance", tolerance]);
            let found: Value = serde_json::from_str(&ended.stdout).unwrap();
            for finding in found["rows"][0]["findings"].as_array().unwrap() {
                assert_ne!(finding["verdict"], "differs", "{point:?} {law} {samples}: {finding}");
                let drop = finding["observable"] == "stress_drop_pa";
                if let (true, Some(off)) = (drop, finding["difference"].as_f64()) {
                    let sides = ["run", "ours"].map(|side| finding[side]["relative_error"].as_f64().unwrap());
                    assert!(off.abs() <= sides[0] + sides[1], "{point:?} {law} {samples}: {finding}");
                    compared += 1;
                    agreeing += usize::from(finding["verdict"] == "agrees");
                }
            }
        }
    }
    assert!(compared >= 20 && agreeing >= 10, "{compared} {agreeing}");
}

#[test]
fn a_simulation_out_of_reach_is_no_verdict() {
    let rows = format!("{HEADER},period_s,tolerance\n{ROW},{PERIOD},1e-13\n");
    let (found, code) = object(&rows, &[]);
    assert_eq!((code, &found["rows"][0]["verdict"]), (1, &"not-compared".into()));
    let reason = found["rows"][0]["reason"].as_str().unwrap();
    assert!(
        reason.contains("a relative error of 1e-15 is not attainable: ") && reason.contains("was reached"),
        "{reason}"
    );
}

#[test]
fn rows_and_bytes_do_not_depend_on_the_number_of_threads() {
    let place = Workplace::new();
    let rows: String = (1..30)
        .map(|i| format!("{},{}\n", ROW.replace("1e5", &format!("{i}e4")), 0.01 * f64::from(i)))
        .collect();
    place.write("runs.csv", format!("{HEADER},period_s\n{rows}"));
    for threads in ["1", "2"] {
        let (out, report) = (format!("{threads}.csv"), format!("report-{threads}"));
        let arguments =
            ["compare", "--runs", "runs.csv", "-o", &out, "--report", &report, "--threads", threads];
        assert_eq!(place.run(arguments).code, 1);
    }
    assert_eq!(place.read("1.csv"), place.read("2.csv"));
    assert_eq!(
        place.read("report-1/figures/differences.svg"),
        place.read("report-2/figures/differences.svg")
    );
    let mut reader = csv::ReaderBuilder::new().flexible(false).from_path(place.path("1.csv")).unwrap();
    assert_eq!(reader.records().map(Result::unwrap).count(), 29);
}

#[test]
fn the_worked_example_agrees_and_makes_a_report() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/compare");
    assert_eq!(names_in(&folder), ["README.md", "make.py", "runs.csv", "stick-slip.csv"]);
    let place = Workplace::new();
    let runs = folder.join("runs.csv");
    let arguments = ["compare", "--runs", runs.to_str().unwrap(), "--tolerance", "1e-3", "--report", "out"];
    place.run(arguments).expect_success();
    let page = place.read("out/index.html");
    assert!(page.contains("3 agree") && !page.contains(place.path("").to_str().unwrap()));
    assert!(place.read("out/report.md").contains("figures/late-cycle-row-1.svg"));
    assert_eq!(place.read("out/tables/runs.csv").lines().count(), 4);
    assert_eq!(names_in(&place.path("out/figures")), ["differences.svg", "late-cycle-row-1.svg"]);
}

#[test]
fn rows_at_fault_are_told_and_passed_over_only_when_asked_and_the_page_names_its_files() {
    let place = Workplace::new();
    let faulty = ROW.replace("1e5", "-1e5");
    place.write("runs.csv", format!("{HEADER},period_s\n{faulty},{PERIOD}\n{ROW},{PERIOD}\n"));
    let stopped = place.run(["compare", "--runs", "runs.csv"]);
    assert_eq!(stopped.code, 2, "{stopped:?}");
    let ended = place.run(["compare", "--runs", "runs.csv", "--keep-going", "--json", "--report", "page"]);
    assert_eq!(ended.code, 1);
    assert!(
        ended.stderr.contains("row 1") && ended.stderr.contains("1 row passed over as invalid"),
        "{}",
        ended.stderr
    );
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!((&found["agree"], &found["at_fault"]), (&1.into(), &1.into()));
    let page = place.read("page/index.html");
    assert!(page.contains("1 further row of the file is invalid"));
    let inputs = page.split("id=\"inputs\"").nth(1).unwrap().split("</table>").next().unwrap();
    assert!(inputs.contains("<td>runs.csv</td>"), "{inputs}");
    assert!(inputs.split("<code>").nth(1).is_some_and(|rest| rest.find('<') == Some(64)), "{inputs}");
}
