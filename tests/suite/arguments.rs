//! Arguments of the command line: every way to get one wrong ends with exit code 2 and a message that helps.

use crate::harness::{SLIDER, Workplace, quoted};

/// `classify` at 0.1 MPa and 1 mm/s, with the value of one option replaced.
fn classify_with(option: &str, value: &str) -> Vec<String> {
    let mut arguments: Vec<String> = ["classify"]
        .iter()
        .chain(&SLIDER)
        .chain(&["-s", "1e5", "-v", "1e-3"])
        .map(ToString::to_string)
        .collect();
    let at = arguments.iter().position(|argument| argument == option).unwrap();
    arguments[at + 1] = value.to_string();
    arguments
}

#[test]
fn values_that_are_no_positive_numbers_are_refused_with_key_value_and_range() {
    let not_decimals = ["nan", "NaN", "inf", "-inf", "0x1p3", "1@5", "1,5", "1 1", "", "1_000", "١", "-b"];
    let cases = [
        ("0", "must be > 0"),
        ("-1e7", "must be > 0"),
        ("-.5", "must be > 0"),
        ("-0", "must be > 0"),
        ("1e400", "out of range"),
        ("1e-400", "out of range"),
        ("1e1000000000", "exponent beyond ±10000"),
        ("1/0", "a division by zero"),
    ];
    let cases = cases.into_iter().chain(not_decimals.into_iter().map(|text| (text, "not a decimal number")));
    for (value, message) in cases {
        for (option, name) in
            [("-k", "--stiffness-pa-per-m"), ("-s", "--normal-stress-pa"), ("-a", "--direct-effect")]
        {
            let arguments = classify_with(option, value);
            let key = format!("{name} = {}: ", quoted(value));
            let ended = Workplace::new().run(arguments.iter().map(String::as_str));
            // The range is stated where the size is at fault.
            let is_of_size = ["must be > 0", "out of range"].contains(&message);
            assert_eq!(
                ended.stderr.contains("(allowed: 1e-300 to 1e300)"),
                is_of_size,
                "{value}: {}",
                ended.stderr
            );
            ended.expect_refusal(&[&key, message]);
        }
    }
    let digits = format!("0.{}", "1".repeat(20_000));
    let long = classify_with("-s", &digits);
    Workplace::new().run(long.iter().map(String::as_str)).expect_refusal(&["more than 10000 digits"]);
}

#[test]
fn all_faults_of_a_command_line_are_told_at_once() {
    let ended =
        Workplace::new().run(["classify", "-a", "0", "-b", "x", "-k", "-1", "--inertial-threshold", "1"]);
    let lines: Vec<_> = ended.stderr.lines().map(str::to_string).collect();
    assert_eq!(lines.len(), 8, "{lines:#?}");
    ended.expect_refusal(&[
        "--inertial-threshold = 1: out of range (allowed: 0 < value < 1)",
        "--mass-per-area-kg-per-m2: missing (allowed: a positive number)",
    ]);
}

#[test]
fn counts_and_digits_state_their_range() {
    let cases: [(&[&str], &str); 8] = [
        (
            &["roots", "--digits", "0"],
            "--digits = 0: out of range (allowed: a whole number from 1 to 1000000)",
        ),
        (&["roots", "--digits", "4294967295"], "--digits = 4294967295: out of range"),
        (&["roots", "--digits", "-5"], "--digits = -5: out of range"),
        (&["roots", "--digits", "1.5"], "--digits = 1.5: out of range"),
        (&["roots", "--digits", "many"], "--digits = many: not a decimal number"),
        (&["boundary", "--points", "0"], "--points = 0: out of range"),
        (&["boundary", "--points", "9223372036854775807"], "limit of 4194304 (--max-points N raises it)"),
        (
            &["roots", "--threads", "0"],
            "--threads = 0: out of range (allowed: a whole number from 1 to 1024)",
        ),
    ];
    for (arguments, message) in cases {
        let point: &[&str] = if arguments[0] == "boundary" { &[] } else { &["-s", "1", "-v", "1"] };
        let slider = SLIDER.iter().chain(point);
        let ended = Workplace::new().run(arguments.iter().chain(slider).copied());
        ended.expect_refusal(&[message]);
    }
}

#[test]
fn misspelt_commands_and_options_exit_with_2_and_help_with_0() {
    let place = Workplace::new();
    for arguments in [
        vec![],
        vec!["clasify"],
        vec!["classify", "--normal-stres-pa", "1"],
        vec!["roots", "-a", "1", "-a", "2"],
    ] {
        let ended = place.run(arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{}", ended.stderr);
    }
    assert!(place.run(["classify", "--help"]).expect_success().contains("--normal-stress-pa"));
}

#[test]
fn options_that_contradict_each_other_are_refused() {
    let place = Workplace::new();
    place.write("p.csv", "");
    place
        .run(["classify", "--points", "p.csv", "-a", "1"])
        .expect_refusal(&["--direct-effect = 1: needs no --points"]);
    place.run(["classify", "--points", "p.csv", "--json"]).expect_refusal(&["--json"]);
    place.run(["classify", "--keep-going", "-a", "1"]).expect_refusal(&["--points"]);
}
