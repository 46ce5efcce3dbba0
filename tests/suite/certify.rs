//! `simulate --certify`: columns, keys and text; the same bytes on any number of threads; proofs against the simulator's numbers.

use serde_json::Value;

use crate::harness::{HEADER, SLIDER, Workplace};
use crate::simulate::NAMES;

/// The columns behind those of `simulate`.
const COLUMNS: [&str; 7] = [
    "peak_velocity_low_m_per_s",
    "peak_velocity_high_m_per_s",
    "period_low_s",
    "period_high_s",
    "stress_drop_low_pa",
    "stress_drop_high_pa",
    "certificate",
];

/// Vibration with both laws, and a decay.
const ROWS: &str = "slip,0.004,0.006,1e-5,1e7,1000,1e4,1e-2
aging,0.004,0.006,1e-5,1e7,1000,1e4,1e-2
slip,0.004,0.006,1e-5,1e7,1000,1e3,3e-4
";

#[test]
fn rows_are_certified_and_their_bounds_hold_what_simulate_finds() {
    let place = Workplace::new();
    place.write("in.csv", format!("law,{HEADER}\n{ROWS}"));
    for threads in ["1", "2"] {
        let out = format!("out-{threads}.csv");
        place
            .run(["simulate", "--certify", "--points", "in.csv", "-o", &out, "--threads", threads])
            .expect_success();
    }
    let written = place.read("out-1.csv");
    assert_eq!(place.read("out-2.csv"), written);
    let mut lines = written.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(header[8..], [&NAMES[..], &COLUMNS].concat());
    let lines: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let words: Vec<&str> = lines.iter().map(|cells| *cells.last().unwrap()).collect();
    assert_eq!(words, ["cycle", "cycle", "decay"]);
    for cells in &lines {
        let of = |name: &str| cells[header.iter().position(|other| *other == name).unwrap()];
        let number = |name: &str| of(name).parse::<f64>().unwrap();
        for (found, low, high) in [
            ("peak_velocity_m_per_s", COLUMNS[0], COLUMNS[1]),
            ("period_s", COLUMNS[2], COLUMNS[3]),
            ("stress_drop_pa", COLUMNS[4], COLUMNS[5]),
        ] {
            // Of a decay no period is proved.
            if found == "period_s" && cells.last() == Some(&"decay") {
                assert_eq!([of(low), of(high)], ["", ""]);
                continue;
            }
            let (value, low, high) = (number(found), number(low), number(high));
            assert!(low <= high && high / low - 1.0 < 1e-8, "{found} {low} {high}");
            let error = 1e-6 * value;
            assert!(low <= value + error && value - error <= high, "{found} {value} {low} {high}");
        }
    }
}

#[test]
fn one_point_states_its_proof_as_text_and_as_keys() {
    let place = Workplace::new();
    let asked = ["-s", "1e4", "-v", "1e-2", "--law", "slip", "--certify"];
    let point: Vec<&str> = SLIDER.into_iter().chain(asked).collect();
    let text = place.run(["simulate"].iter().chain(&point).copied()).expect_success();
    assert!(text.contains("certificate") && text.contains("cycle") && text.contains("(enclosed)"), "{text}");
    let json = place.run(["simulate", "--json"].iter().chain(&point).copied()).expect_success();
    let object: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(object["certificate"], "cycle");
    let proof = &object["proof"];
    assert!(proof["contraction_factor"].as_f64().unwrap() < 1.0);
    let ends: Vec<f64> =
        proof["log_state_box"].as_array().unwrap().iter().map(|end| end.as_f64().unwrap()).collect();
    assert!(ends[0] < ends[1] && ends[1] - ends[0] < 1e-8);
    assert_eq!(
        (proof["second_coordinate"].as_str(), &proof["section_log_velocity"]),
        (Some("force"), &0.0.into())
    );
}

/// Error bars in cells and in an option: the proof holds for all values within them, the simulation beside it for the middle ones.
#[test]
fn values_within_error_bars_are_certified_together() {
    let place = Workplace::new();
    let cells = |stress: &str, error: &str| format!("slip,0.004,0.006,1e-5,1e7,1000,{stress},1e-3,{error}\n");
    let rows = cells("3e4", "3e-5") + &cells("3e4±3e-5", "") + &cells("3e4", "") + &cells("3e4", "3e3");
    place.write("in.csv", format!("law,{HEADER},normal_stress_pa_error\n{rows}"));
    let ended = place.run(["simulate", "--certify", "--points", "in.csv", "-o", "out.csv"]);
    assert_eq!(ended.stderr, "in SI: column normal_stress_pa_error: error of normal_stress_pa\n");
    let written = place.read("out.csv");
    let lines: Vec<Vec<&str>> = written.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|other| *other == name).unwrap();
    let peaks = [COLUMNS[0], COLUMNS[1]].map(column);
    let ends = |row: usize| peaks.map(|at| lines[row][at].parse::<f64>().unwrap());
    // All that follows the inputs is the same, however the error bar is written.
    assert_eq!(lines[1][9..], lines[2][9..]);
    let ([low, high], [least, largest]) = (ends(1), ends(3));
    assert!(low < least && largest < high && high / low - 1.0 < 1e-4, "{low} {least} {largest} {high}");
    assert!(lines[4].last().unwrap().starts_with("none: "), "{:?}", lines[4]);
    let simulated = column("mode")..peaks[0];
    assert_eq!(lines[4][simulated.clone()], lines[3][simulated]);

    let asked = ["-s", "3e4±3e-5", "-v", "1e-3", "--law", "slip", "--json", "--certify"];
    let point: Vec<&str> = ["simulate"].into_iter().chain(SLIDER).chain(asked).collect();
    let json = place.run(point).expect_success();
    let object: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(object["inputs"]["normal_stress_pa"], serde_json::json!([29_999.999_97, 30_000.000_03]));
    // Texts: reading a number back may change its last digit.
    assert!(json.contains(lines[1][peaks[1]]), "{json}");
    // The sampled range lies within the enclosure, but for the estimated errors.
    let range = &object["within_error_bars"]["peak_velocity_m_per_s"];
    let [least, largest] = [0, 1].map(|end| range[end].as_f64().unwrap());
    assert!(low * (1.0 - 1e-7) < least && largest < high * (1.0 + 1e-7), "{least} {largest} {low} {high}");
}
