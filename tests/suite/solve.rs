//! `solve`: certified values, put back into `roots`; none where there is none; rows of a file.

use serde_json::Value;
use slipmode_core::number::{Rational, parse_decimal};

use crate::harness::{HEADER, ROW, SLIDER, Workplace};

fn solved(more: &[&str]) -> Value {
    let arguments = [&["solve", "--json"], &SLIDER[..], more].concat();
    serde_json::from_str(&Workplace::new().run(arguments).expect_success()).unwrap()
}

/// The values of the solutions.
fn values(answer: &Value) -> Vec<String> {
    let solutions = answer["solutions"].as_array().unwrap();
    solutions.iter().map(|solution| solution["value"].as_str().unwrap().to_string()).collect()
}

/// max Im(s) and max Re(s) by `roots` with 60 digits.
fn extremes(more: &[&str]) -> [Rational; 2] {
    let arguments = [&["roots", "--json", "--digits", "60"], &SLIDER[..], more].concat();
    let roots: Vec<Value> = serde_json::from_str(&Workplace::new().run(arguments).expect_success()).unwrap();
    ["im", "re"].map(|part| {
        let part = |root: &Value| parse_decimal(root[part].as_str().unwrap()).unwrap();
        roots.iter().map(part).max().unwrap()
    })
}

/// The decimals one unit in the last digit of `value` below and above it.
fn neighbours(value: &str) -> [String; 2] {
    let (mantissa, exponent) = value.split_once('e').unwrap_or((value, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let digits: i128 = mantissa.replace('.', "").parse().unwrap();
    let exponent: i64 = exponent.parse::<i64>().unwrap() - i64::try_from(places).unwrap();
    [digits - 1, digits + 1].map(|digits| format!("{digits}e{exponent}"))
}

#[test]
fn solutions_put_back_straddle_the_target_to_the_last_digit() {
    // 20π to 40 digits.
    let twenty_pi = "62.83185307179586476925286766559005768394";
    for (option, unknown, rest) in [
        ("-s", "normal-stress", ["-v", "1e-3"]),
        ("-v", "loading-velocity", ["-s", "1e5"]),
        ("-k", "stiffness", ["-s", "1e5"]),
    ] {
        let mut given: Vec<&str> = rest.to_vec();
        if option == "-k" {
            given.extend(["-v", "1e-3"]);
        }
        let question = [&["--for", unknown, "--frequency", "10", "--digits", "30"], &given[..]].concat();
        let slider: Vec<&str> =
            SLIDER.chunks(2).filter(|pair| pair[0] != option).flatten().copied().collect();
        let place = Workplace::new();
        let run = |arguments: Vec<&str>| -> Value {
            serde_json::from_str(&place.run(arguments).expect_success()).unwrap()
        };
        let answer = run([&["solve", "--json"], &slider[..], &question].concat());
        let found = values(&answer);
        assert!(!found.is_empty(), "{unknown}");
        for value in found {
            let sides = neighbours(&value).map(|beside| {
                let back = [&["roots", "--json", "--digits", "60"], &slider[..], &given, &[option, &beside]];
                let roots = run(back.concat());
                let part = |root: &Value| parse_decimal(root["im"].as_str().unwrap()).unwrap();
                let largest = roots.as_array().unwrap().iter().map(part).max().unwrap();
                largest > parse_decimal(twenty_pi).unwrap()
            });
            assert_ne!(sides[0], sides[1], "{unknown} = {value}");
        }
    }
}

#[test]
fn a_growth_rate_is_reached_and_the_transition_is_exact() {
    let transition = solved(&["--for", "normal-stress", "-v", "1e-3", "--transition"]);
    assert_eq!(values(&transition), ["25000"]);
    assert_eq!(transition["solutions"][0]["is_exact"], true);
    assert_eq!(transition["solutions"][0]["transition_sign"], 0);
    assert_eq!(transition["inputs"]["critical_slip_distance_m"], 1e-5);
    assert_eq!(transition["schema"], 1);
    assert_eq!(transition["solved_for"], "normal_stress_pa");
    let growing = solved(&["--for", "normal-stress", "-v", "1e-3", "--growth-rate", "2"]);
    for value in values(&growing) {
        let [_, re] = extremes(&["-v", "1e-3", "-s", &value]);
        let difference = (re - Rational::from(2)).abs();
        assert!(difference < parse_decimal("1e-13").unwrap(), "{value}");
    }
    assert_eq!(values(&growing).len(), 1);
}

#[test]
fn none_is_said_where_no_value_gives_the_target() {
    let none = |more: &[&str]| {
        let arguments = [&["solve"], &SLIDER[..], more].concat();
        Workplace::new().run(arguments).expect_success()
    };
    // ω_n/2π = 15.9 Hz.
    let text = none(&["--for", "normal-stress", "-v", "1e-3", "--frequency", "16"]);
    assert_eq!(text, "none: no normal stress gives a frequency of 16 Hz (exact)\n");
    let text = none(&["--for", "loading-velocity", "-s", "1e5", "--transition"]);
    assert!(text.starts_with("none: no loading velocity gives the transition"), "{text}");
}

#[test]
fn what_is_missing_or_has_no_effect_is_refused() {
    let refused = |more: &[&str], parts: &[&str]| {
        let arguments = [&["solve"], &SLIDER[..], more].concat();
        Workplace::new().run(arguments).expect_refusal(parts);
    };
    refused(&["--for", "normal-stress", "-v", "1"], &["--transition", "--frequency"]);
    refused(&["--for", "stress", "-v", "1", "--boundary"], &["--for = stress: unknown", "normal-stress"]);
    let own = ["--for", "normal-stress", "-v", "1", "-s", "1", "--boundary"];
    refused(&own, &["--normal-stress-pa = 1: needs another --for"]);
    refused(&["--for", "normal-stress", "--boundary"], &["--loading-velocity-m-per-s: missing"]);
    refused(&["--for", "normal-stress", "-v", "1", "--frequency", "0"], &["--frequency = 0: must be > 0"]);
    refused(
        &["--for", "normal-stress", "-v", "1", "--growth-rate", "x"],
        &["--growth-rate = x: not a decimal"],
    );
}

#[test]
fn every_row_of_a_file_is_solved_and_its_column_of_the_unknown_is_not_used() {
    let place = Workplace::new();
    place.write("in.csv", format!("{HEADER}\n{ROW}\n{}\n", ROW.replace("1e5", "")));
    let header = HEADER.replace(",normal_stress_pa", "");
    place.write("without.csv", format!("{header}\n{}\n", ROW.replace(",1e5", "")));
    let rows = |name: &str| {
        let question = ["solve", "--for", "normal-stress", "--transition", "--points", name];
        place.run(question).expect_success()
    };
    let with = rows("in.csv");
    let lines: Vec<&str> = with.lines().collect();
    assert!(lines[0].ends_with(",solutions,solution_1,solution_2,solution_3,solution_4,status"));
    assert!(
        lines[1].ends_with("1e5,1e-3,1,25000,,,,solved") && lines[2].ends_with(",,1e-3,1,25000,,,,solved")
    );
    assert!(rows("without.csv").ends_with(",1e-3,1,25000,,,,solved\n"));
}
