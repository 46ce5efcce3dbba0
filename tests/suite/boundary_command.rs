//! `boundary`: the columns of the contract, the marked points, and points that `classify` agrees with.

use crate::harness::{SLIDER, Workplace};

const COLUMNS: &str = "arc,double_root,normal_stress_pa,loading_velocity_m_per_s,asymptote,asymptote_value,\
    relative_error,log10_distance,condition_number,mark";

fn boundary(more: &[&str]) -> Vec<Vec<String>> {
    let text = Workplace::new().run(["boundary"].iter().chain(&SLIDER).chain(more).copied()).expect_success();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    lines.map(|line| line.split(',').map(str::to_string).collect()).collect()
}

#[test]
fn both_arcs_have_the_points_asked_for_and_the_marked_ones() {
    let rows = boundary(&["--points", "7", "--digits", "30"]);
    let marks: Vec<_> = rows.iter().filter(|row| !row[9].is_empty()).map(|row| row[9].as_str()).collect();
    assert_eq!(
        marks,
        ["corner-velocity", "corner-velocity", "cusp", "corner-normal-stress", "corner-velocity"]
    );
    assert_eq!(rows.iter().filter(|row| row[9].is_empty()).count(), 14);
    let cusp = rows.iter().find(|row| row[9] == "cusp").unwrap();
    assert!(cusp[2].starts_with("5857.9") && cusp[3].starts_with("0.00015964"), "{cusp:?}");
    assert!(rows.iter().flatten().all(|cell| !cell.contains(['±', '\''])), "numbers only");
}

#[test]
fn classify_changes_its_sign_across_every_point_of_the_boundary() {
    let place = Workplace::new();
    for row in boundary(&["--at-velocity", "1e-5", "--digits", "40"]) {
        // One unit in the fortieth digit to either side.
        let cut = &row[2][..row[2].len() - 1];
        let signs = [format!("{cut}0"), format!("{}9", bumped(cut))].map(|stress| {
            let point =
                ["classify", "--json"].iter().chain(&SLIDER).copied().chain(["-s", &stress, "-v", "1e-5"]);
            let found: serde_json::Value = serde_json::from_str(&place.run(point).expect_success()).unwrap();
            found["boundary_sign"].as_i64().unwrap()
        });
        assert_eq!(signs[0] * signs[1], -1, "{row:?}");
    }
}

/// The decimal with one more in its last place.
fn bumped(digits: &str) -> String {
    let mut bytes = digits.as_bytes().to_vec();
    for byte in bytes.iter_mut().rev().filter(|byte| byte.is_ascii_digit()) {
        if *byte < b'9' {
            *byte += 1;
            break;
        }
        *byte = b'0';
    }
    String::from_utf8(bytes).unwrap()
}

#[test]
fn single_points_at_a_velocity_and_at_a_normal_stress_are_on_one_curve() {
    let [upper, ..] = &boundary(&["--at-velocity", "0.01", "--digits", "30"])[..] else { panic!("no point") };
    let back = boundary(&["--at-normal-stress", &upper[2], "--digits", "25"]);
    assert!(
        back[0][3].starts_with("0.0100000000000000000000") || back[0][3].starts_with("0.0099999999999999999")
    );
}

#[test]
fn where_the_boundary_has_no_point_there_is_a_header_and_a_word() {
    let place = Workplace::new();
    let arguments = ["boundary"].iter().chain(&SLIDER).chain(&["--at-normal-stress", "1e5"]);
    let ended = place.run(arguments.copied());
    assert_eq!((ended.code, ended.stdout.trim_end()), (0, COLUMNS));
    assert!(ended.stderr.contains("no point"));
}

#[test]
fn equal_effects_leave_the_lower_arc_alone() {
    let arguments = ["boundary", "-a", "1", "-b", "1", "-d", "1", "-k", "1", "-m", "1", "--points", "3"];
    let text = Workplace::new().run(arguments).expect_success();
    assert!(text.lines().skip(1).all(|line| line.starts_with("lower,")));
    assert!(text.contains(",cusp"));
}

#[test]
fn inputs_hundreds_of_decades_apart_get_the_working_digits_they_take() {
    let cases = [
        ["6.33144e179", "1.825e-6", "1e299", "1e-150", "1e-150"],
        ["1", "1e-300", "5e177", "4e266", "0.5"],
        ["1e-300", "6.5e-273", "70", "0.5", "2"],
    ];
    for [a, b, d, k, m] in cases {
        let slider = ["-a", a, "-b", b, "-d", d, "-k", k, "-m", m];
        for wanted in [&["--points", "3"][..], &["--at-velocity", "0.125", "--at-normal-stress", "1e-200"]] {
            let arguments =
                ["boundary", "--digits", "8"].into_iter().chain(slider).chain(wanted.iter().copied());
            let text = Workplace::new().run(arguments).expect_warnings();
            assert!(!text.contains("inf") && !text.contains('±') && text.lines().count() > 1, "{text}");
        }
    }
}

const LINE_COLUMNS: &str = "transition_sign,real_part,normal_stress_pa,loading_velocity_m_per_s,asymptote,asymptote_value,\
    relative_error,log10_distance";

fn pair_line(more: &[&str]) -> Vec<Vec<String>> {
    let text = Workplace::new().run(["boundary"].iter().chain(&SLIDER).chain(more).copied()).expect_success();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(LINE_COLUMNS));
    lines.map(|line| line.split(',').map(str::to_string).collect()).collect()
}

#[test]
fn the_line_of_a_frequency_ratio_has_the_points_asked_for_and_its_crossing_of_the_transition() {
    let rows = pair_line(&["--frequency-ratio", "sqrt(1/2)", "--points", "9", "--digits", "12"]);
    assert_eq!(rows.len(), 10);
    let crossing = rows.iter().find(|row| row[0] == "0").unwrap();
    // η = 1 on K = K_c: V0 = V_c/√2 and σ = σ_c/2.
    assert_eq!(crossing[1..4], ["0", "25000.0000000", "0.00100000000000"]);
    assert_eq!([rows[0][4].as_str(), &rows[9][4]], ["eq20", "eq18"]);
}

#[test]
fn classify_calls_an_oscillation_inertial_above_the_line_of_its_threshold() {
    let place = Workplace::new();
    for ratio in ["0.3", "0.9"] {
        let at = ["--frequency-ratio", ratio, "--at-normal-stress", "3e4", "--digits", "30"];
        for row in pair_line(&at) {
            let cut = &row[3][..row[3].len() - 1];
            let modes = [format!("{cut}0"), format!("{}9", bumped(cut))].map(|velocity| {
                let point = ["classify", "--json", "--inertial-threshold", ratio].into_iter().chain(SLIDER);
                let point = point.chain(["-s", "3e4", "-v", &velocity]);
                let found: serde_json::Value =
                    serde_json::from_str(&place.run(point).expect_success()).unwrap();
                found["slip_mode"].as_str().unwrap().to_string()
            });
            let is_inertial =
                |mode: &str| ["inertial-underdamped-oscillation", "harmonic-vibration"].contains(&mode);
            assert_eq!(modes.each_ref().map(|mode| is_inertial(mode)), [false, true], "{row:?} {modes:?}");
        }
    }
}

#[test]
fn a_frequency_ratio_that_no_oscillation_has_is_refused() {
    for ratio in ["0", "1", "-0.5", "1.5", "fast", "nan", "sqrt(2)", "sqrt(1/0)", "sqrt("] {
        let arguments = ["boundary", "--frequency-ratio", ratio].into_iter().chain(SLIDER);
        Workplace::new().run(arguments).expect_refusal(&["--frequency-ratio", "0 < value < 1"]);
    }
    let low = ["boundary", "--frequency-ratio", "0.4", "-a", "0.004±0.001", "-b", "0.006"];
    let arguments = low.iter().chain(&["-d", "1e-5", "-k", "1e7", "-m", "1000"]);
    Workplace::new().run(arguments.copied()).expect_refusal(&["--frequency-ratio = 0.4", "sqrt(1/5)"]);
}

#[test]
fn on_the_line_of_a_damping_ratio_the_roots_have_it() {
    let place = Workplace::new();
    for (ratio, expected) in
        [("0.05", 0.05), ("-0.05", -0.05), ("0.9", 0.9), ("1/2", 0.5), ("-1/3", -1.0 / 3.0)]
    {
        let rows = pair_line(&["--damping-ratio", ratio, "--points", "5"]);
        assert_eq!(rows.len(), 5);
        for row in rows {
            let point = ["roots", "--json", "--digits", "17", "-s", &row[2], "-v", &row[3]];
            // The farthest points cause warnings about units.
            let ended = place.run(point.into_iter().chain(SLIDER));
            let found: serde_json::Value = serde_json::from_str(&ended.stdout).unwrap();
            let of = |root: &serde_json::Value| {
                ["re", "im"].map(|part| root[part].as_str().unwrap().parse::<f64>().unwrap())
            };
            let [real, imaginary] = of(found.as_array().unwrap().last().unwrap());
            let found = -real / real.hypot(imaginary);
            // The point has 20 digits, the roots 17.
            assert!((found / expected - 1.0).abs() < 1e-12, "{row:?} {found}");
        }
    }
}

#[test]
fn a_damping_ratio_that_no_oscillation_has_and_error_bars_with_it_are_refused() {
    for ratio in ["0", "1", "-1", "1.5", "strong", "nan", "1e-1000000"] {
        let arguments = ["boundary", "--damping-ratio", ratio].into_iter().chain(SLIDER);
        Workplace::new().run(arguments).expect_refusal(&["--damping-ratio", "-1 < value < 1, and not 0"]);
    }
    let bars = ["boundary", "--damping-ratio", "0.4", "-a", "0.004±0.001", "-b", "0.006"];
    let arguments = bars.iter().chain(&["-d", "1e-5", "-k", "1e7", "-m", "1000"]);
    Workplace::new().run(arguments.copied()).expect_refusal(&["--damping-ratio = 0.4", "without error bars"]);
}

#[test]
fn within_error_bars_the_range_of_the_line_holds_the_points_of_the_values_in_them() {
    let arguments = ["-d", "1e-5", "-k", "1e7", "-m", "1000", "--at-velocity", "0.01", "--json"];
    let arguments = ["boundary", "--frequency-ratio", "0.8"].iter().chain(&arguments).copied();
    let object = |effects: [&str; 4]| -> serde_json::Value {
        let text = Workplace::new().run(arguments.clone().chain(effects)).expect_success();
        let found: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(found["frequency_over_natural_squared"], "0.64");
        found
    };
    let found = object(["-a", "0.004±0.0002", "-b", "0.006±0.0001"]);
    let [range] = &found["ranges"].as_array().unwrap()[..] else { panic!("{found}") };
    assert_eq!(range["line"], "frequency-ratio");
    let ends = [0, 1].map(|end| range["normal_stress_pa"][end].as_f64().unwrap());
    let mut least = f64::INFINITY;
    let mut most = 0.0_f64;
    for a in ["0.0038", "0.004", "0.0042"] {
        for b in ["0.0059", "0.006", "0.0061"] {
            let point = object(["-a", a, "-b", b]);
            let stress = point["points"][0]["normal_stress_pa"].as_f64().unwrap();
            assert!((ends[0]..=ends[1]).contains(&stress), "{stress} {ends:?}");
            (least, most) = (least.min(stress), most.max(stress));
        }
    }
    assert!((least / ends[0] - 1.0).abs() < 1e-9 && (most / ends[1] - 1.0).abs() < 1e-9, "{ends:?}");
}
