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
