//! `simulate` of one point: what it ends in, the digits that it may print, its trajectory, and every way to ask wrongly.

use serde_json::Value;

use crate::harness::{Ended, SLIDER, Workplace};

/// Runs `simulate` on the paper's slider at a point of operation.
fn run(place: &Workplace, stress: &str, velocity: &str, more: &[&str]) -> Ended {
    let point = ["-s", stress, "-v", velocity];
    place.run(["simulate"].iter().chain(&SLIDER).chain(&point).chain(more).copied())
}

fn json(stress: &str, velocity: &str, more: &[&str]) -> Value {
    let more: Vec<_> = more.iter().chain(&["--json"]).copied().collect();
    serde_json::from_str(&run(&Workplace::new(), stress, velocity, &more).expect_success()).unwrap()
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name}: {value}"))
}

/// σ = 10^6.5 Pa and V_l = 10^-5.5 m/s: deep stick-slip.
const STICK_SLIP: [&str; 2] = ["3162277.6601683793", "3.1622776601683793e-6"];

/// The names of the object and of the appended columns.
pub const NAMES: [&str; 13] = [
    "mode",
    "slip_mode",
    "peak_velocity_m_per_s",
    "minimum_velocity_log10_ratio",
    "period_s",
    "stress_drop_pa",
    "frequency_hz",
    "peak_relative_error",
    "period_relative_error",
    "steps",
    "evaluations",
    "outside_tested_range",
    "status",
];

#[test]
fn deep_stick_slip_is_periodic_under_both_laws_to_the_stated_errors() {
    let [stress, velocity] = STICK_SLIP;
    for law in ["slip", "aging"] {
        let found = json(stress, velocity, &["--law", law]);
        let mut names: Vec<_> = found.as_object().unwrap().keys().map(String::as_str).collect();
        let further = ["schema", "inputs", "law", "start", "tolerance"];
        let errors = ["minimum_velocity_log10_error", "stress_drop_relative_error"];
        let mut wanted = [&NAMES[..], &further, &errors].concat();
        names.sort_unstable();
        wanted.sort_unstable();
        assert_eq!(names, wanted);
        assert_eq!((&found["mode"], &found["slip_mode"]), (&"periodic".into(), &"stick-slip".into()));
        assert_eq!(found["status"], "ok");
        let finer = json(stress, velocity, &["--law", law, "--tolerance", "1e-11"]);
        for (name, error) in
            [("peak_velocity_m_per_s", "peak_relative_error"), ("period_s", "period_relative_error")]
        {
            let (value, reference) = (number(&found, name), number(&finer, name));
            let stated = number(&found, error) + number(&finer, error);
            assert!(number(&found, error) <= 1e-8 && number(&finer, error) <= 1e-11);
            assert!((value / reference - 1.0).abs() <= stated, "{law} {name}: {value} {reference}");
        }
        // In a cycle the spring loses what loading gives while the slider sticks: nearly K V_l T, and not more.
        let loaded = 1e7 * 3.162277660168379e-6 * number(&found, "period_s");
        let drop = number(&found, "stress_drop_pa") / loaded;
        assert!((0.9..1.0).contains(&drop), "{drop}");
        assert!((number(&found, "frequency_hz") * number(&found, "period_s") - 1.0).abs() < 1e-15);
    }
}

#[test]
fn long_term_oscillations_have_the_period_of_the_linear_theory() {
    // K > K_c at σ = 10^4 Pa: the pair's Im(s) and the late period are computed by parts that share nothing.
    for law in ["slip", "aging"] {
        let found = json("1e4", "1e-5", &["--law", law]);
        assert_eq!(found["mode"], "decaying");
        assert_eq!(found["slip_mode"], "non-inertial-underdamped-oscillation");
        let linear = Workplace::new()
            .run(["classify", "--json"].iter().chain(&SLIDER).chain(&["-s", "1e4", "-v", "1e-5"]).copied());
        let linear: Value = serde_json::from_str(&linear.expect_success()).unwrap();
        let period = std::f64::consts::TAU / number(&linear, "max_imaginary_per_s");
        assert!((number(&found, "period_s") / period - 1.0).abs() < number(&found, "period_relative_error"));
    }
}

#[test]
fn an_overdamped_run_has_no_period() {
    let found = json("1e3", "1e-5", &["--law", "aging"]);
    assert_eq!(
        (&found["mode"], &found["slip_mode"]),
        (&"decaying".into(), &"overdamped-stable-sliding".into())
    );
    for name in ["period_s", "frequency_hz", "period_relative_error"] {
        assert!(found[name].is_null(), "{name}");
    }
    assert!(number(&found, "peak_velocity_m_per_s") > 1e-5);
    let text = run(&Workplace::new(), "1e3", "1e-5", &["--law", "aging"]).expect_success();
    assert!(text.contains("\nperiod                     none  (nothing oscillates)\n"), "{text}");
    // It rises from the stress of V0/10, or falls to that of V0.
    assert!(text.contains("\nstress range ") && !text.contains("stress drop"), "{text}");
}

#[test]
fn the_text_prints_certain_digits_only() {
    let [stress, velocity] = STICK_SLIP;
    let reference = json(stress, velocity, &["--law", "slip", "--tolerance", "1e-11"]);
    let lines = [
        ("peak velocity", "peak_velocity_m_per_s"),
        ("stress drop", "stress_drop_pa"),
        ("period", "period_s"),
    ];
    for tolerance in ["1e-2", "1e-4", "1e-8"] {
        let more = ["--law", "slip", "--tolerance", tolerance];
        let text = run(&Workplace::new(), stress, velocity, &more).expect_success();
        let shown = |name: &str| {
            let line = text.lines().find(|line| line.starts_with(name)).unwrap();
            line[27..].split(' ').next().unwrap().to_string()
        };
        for (line, name) in lines {
            let printed = shown(line);
            let digits = printed.split('e').next().unwrap().trim_start_matches("0.").replace('.', "");
            let value = number(&reference, name);
            // Rounding the reference to as many digits gives the same text.
            let rounded: f64 = format!("{value:.*e}", digits.len() - 1).parse().unwrap();
            assert_eq!(printed.parse::<f64>().unwrap(), rounded, "{tolerance} {line}: {printed} of {value}");
        }
        let lowest = number(&reference, "minimum_velocity_log10_ratio");
        let printed = shown("log10 of minimum");
        let places = printed.split('.').nth(1).map_or(0, str::len);
        assert_eq!(format!("{lowest:.places$}"), printed, "{tolerance}");
    }
}

#[test]
fn the_start_matters_to_the_transient_and_not_to_the_cycle() {
    let starts = [
        "steady-at-velocity",
        "steady-state-spring-at-loading",
        "velocity-step-in-equilibrium",
        "velocity-kick",
    ];
    let [stress, velocity] = STICK_SLIP;
    let cycles = starts.map(|start| json(stress, velocity, &["--law", "slip", "--start", start]));
    let period = number(&cycles[0], "period_s");
    for cycle in &cycles {
        let difference = (number(cycle, "period_s") / period - 1.0).abs();
        assert!(
            difference
                <= number(cycle, "period_relative_error") + number(&cycles[0], "period_relative_error")
        );
    }
    let transients = starts.map(|start| json("1e4", "1e-5", &["--law", "slip", "--start", start]));
    let mut peaks = transients.map(|found| number(&found, "peak_velocity_m_per_s"));
    peaks.sort_by(f64::total_cmp);
    assert!(peaks.windows(2).all(|pair| pair[1] > pair[0] * (1.0 + 1e-6)), "{peaks:?}");
}

#[test]
fn a_trajectory_begins_at_a_tenth_and_its_time_increases() {
    let place = Workplace::new();
    let [stress, velocity] = STICK_SLIP;
    let more = ["--law", "aging", "--json", "--trajectory", "run.csv"];
    let found: Value = serde_json::from_str(&run(&place, stress, velocity, &more).expect_success()).unwrap();
    assert_eq!(place.names(), ["run.csv"]);
    let text = place.read("run.csv");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("time_s,velocity_m_per_s,state_variable_s,shear_stress_pa,slip_m"));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert_eq!(rows[0][0], 0.0);
    assert!((rows[0][1] / 3.162277660168379e-7 - 1.0).abs() < 1e-8);
    assert!((rows[0][1] * rows[0][2] / 1e-5 - 1.0).abs() < 1e-8, "a steady state: V θ = D_c");
    assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    assert!(rows.iter().all(|row| row[1] > 0.0 && row[2] > 0.0));
    let end = rows.last().unwrap()[0];
    assert!((end / (10.0 * number(&found, "period_s")) - 1.0).abs() < 1e-12, "ten periods");
    // Samples need not hit the peak; none exceeds it, and one in every cycle comes near. The late half is on the cycle.
    let peak = number(&found, "peak_velocity_m_per_s");
    let long_term = rows.iter().filter(|row| row[0] > 0.5 * end).map(|row| row[1]).fold(0.0, f64::max);
    assert!(long_term <= peak * (1.0 + 1e-7) && long_term > 0.95 * peak, "{long_term} {peak}");
}

#[test]
fn the_length_of_a_trajectory_is_an_option() {
    let place = Workplace::new();
    let more = ["--law", "slip", "--trajectory", "run.csv", "--duration-s", "2.5"];
    run(&place, "1e4", "1e-5", &more).expect_success();
    assert!(place.read("run.csv").lines().last().unwrap().starts_with("2.5,"));
}

#[test]
fn wrong_requests_are_refused_all_faults_at_once() {
    let place = Workplace::new();
    run(&place, "1e5", "1e-3", &["--law", "agin", "--tolerance", "1e-16", "--start", "kick"]).expect_refusal(
        &[
            "--law = agin: unknown; did you mean `aging`? (allowed: slip, aging)",
            "--tolerance = 1e-16: out of range (allowed: 1e-15 to 1e-2)",
            "--start = kick: unknown (allowed: steady-at-velocity, ",
        ],
    );
    run(&place, "-1", "1e-3", &["--tolerance", "nan"]).expect_refusal(&[
        "--normal-stress-pa = -1: must be > 0",
        "--tolerance = nan: not a decimal number",
        "--law: missing (allowed: slip, aging)",
    ]);
    run(&place, "1e5", "1e-3", &["--law", "slip", "--trajectory", "-", "--json"])
        .expect_refusal(&["--trajectory = -: needs a file"]);
    run(&place, "1e5", "1e-3", &["--law", "slip", "--trajectory", "missing/run.csv"])
        .expect_refusal(&["cannot be created"]);
    run(&place, "1e5", "1e-3", &["--law", "slip", "--duration-s", "5"]).expect_refusal(&["--trajectory"]);
    assert!(place.names().is_empty());
}

#[test]
fn a_tolerance_out_of_reach_fails_and_says_what_was_reached() {
    let place = Workplace::new();
    let more = ["--law", "slip", "--tolerance", "1e-15", "--json", "--trajectory", "run.csv"];
    let ended = run(&place, "1e5", "1e-3", &more);
    assert_eq!(ended.code, 1);
    let message = "the simulation failed: a relative error of 1e-15 is not attainable: ";
    assert!(ended.stderr.contains(message) && ended.stderr.contains(" was reached"), "{}", ended.stderr);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert!(found["status"].as_str().unwrap().starts_with("a relative error of 1e-15"));
    assert!(found["mode"].is_null() && found["peak_velocity_m_per_s"].is_null());
    assert!(place.names().is_empty());
}

#[test]
fn large_effect_ratios_are_as_accurate_as_stated_and_do_not_warn() {
    let place = Workplace::new();
    for b in ["0.008", "0.012", "0.02"] {
        for (stress, velocity) in [("1e6", "1e-5"), ("1e4", "1e-2"), ("1e3", "1e-3")] {
            for law in ["slip", "aging"] {
                let found = |tolerance: &str| -> Value {
                    let slider = [
                        "simulate", "-a", "0.004", "-b", b, "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s",
                        stress,
                    ];
                    let rest = ["-v", velocity, "--law", law, "--tolerance", tolerance, "--json"];
                    serde_json::from_str(&place.run([&slider[..], &rest].concat()).expect_success()).unwrap()
                };
                let (coarse, fine) = (found("1e-6"), found("1e-10"));
                assert_eq!(
                    (&coarse["mode"], &coarse["outside_tested_range"]),
                    (&fine["mode"], &false.into())
                );
                for (name, error) in
                    [("peak_velocity_m_per_s", "peak_relative_error"), ("period_s", "period_relative_error")]
                {
                    let difference = number(&coarse, name) / number(&fine, name) - 1.0;
                    let stated = number(&coarse, error) + number(&fine, error);
                    assert!(difference.abs() <= stated, "{b} {stress} {velocity} {law} {name}: {difference}");
                }
            }
        }
    }
    let beyond = place.run([
        "simulate", "-a", "0.004", "-b", "0.021", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s", "1e4", "-v",
        "1e-2", "--law", "slip",
    ]);
    assert!(
        beyond.stderr.contains("beta = b/a is 5.25, outside the tested range 0.66 to 5"),
        "{}",
        beyond.stderr
    );
    let help = place.run(["simulate", "--help"]).expect_success();
    for range in ["from 5e-10 to 8e5", "from 0.0005 to 80", "from 0.66 to 5"] {
        assert!(help.split_whitespace().collect::<Vec<_>>().join(" ").contains(range), "{range}: {help}");
    }
}

#[test]
fn suspicious_values_get_a_warning() {
    let ended = run(&Workplace::new(), "5", "1e-3", &["--law", "slip"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(ended.stderr.contains("warning: normal_stress_pa = 5: looks like MPa"));
    assert!(ended.stderr.contains("kappa = K D_c/(a sigma) is 5000, outside the tested range 0.0005 to 80"));
    assert!(ended.stdout.starts_with("mode "));
}

#[test]
fn a_slider_outside_the_tested_ranges_carries_a_mark() {
    for (stress, outside) in [("1e5", false), ("5", true)] {
        // The warning stands on standard error.
        let ended = run(&Workplace::new(), stress, "1e-3", &["--law", "slip", "--json"]);
        let found: Value = serde_json::from_str(&ended.stdout).unwrap();
        assert_eq!(found["outside_tested_range"], outside, "{stress}");
    }
}
