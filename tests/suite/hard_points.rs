//! The hard cases again, through `classify --points`: what is printed keeps what the library promises.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use slipmode::scene::AllowedRange;

use crate::hard_cases::{PARAMETERS, PROMISE, assert_within, decimal, rows};

/// Runs `classify --points` on standard streams.
fn classify_points(csv: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
        .args(["classify", "--points", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let csv = csv.to_string();
    let writer = std::thread::spawn(move || input.write_all(csv.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    output
}

/// Whether the command line takes all seven inputs of a row.
fn is_in_range(line: &str) -> bool {
    line.split(',').take(7).all(|cell| AllowedRange::PHYSICAL.parse(cell).is_ok())
}

/// The header, the points that the command line takes, and those whose inputs lie beyond its range.
fn table() -> (String, Vec<&'static str>, Vec<&'static str>) {
    let mut lines = PARAMETERS.lines().filter(|line| !line.starts_with('#'));
    let header = format!("{}\n", lines.next().unwrap());
    let (taken, refused) = lines.partition(|line| is_in_range(line));
    (header, taken, refused)
}

#[test]
fn the_command_line_is_right_on_every_hard_point_of_the_inputs() {
    let (head, taken, refused) = table();
    let output = classify_points(&(head + &taken.join("\n")));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let answer = String::from_utf8(output.stdout).unwrap();
    let mut answers = rows(&answer);
    let header = answers.next().unwrap();
    let cell =
        |row: &[&str], name: &str| row[header.iter().position(|column| *column == name).unwrap()].to_string();
    let mut count = 0;
    for row in answers {
        let point = row[..7].join(",");
        for name in ["transition_sign", "boundary_sign", "spectral_class"] {
            assert_eq!(cell(&row, name), cell(&row, &format!("expected_{name}")), "{name} of {point}");
        }
        // The vectors name the mode of the undamped oscillation on K = K_c.
        let is_on_transition = cell(&row, "transition_sign") == "0";
        let mode = if is_on_transition { "neutral".into() } else { cell(&row, "expected_slip_mode") };
        assert_eq!(cell(&row, "slip_mode"), mode, "slip_mode of {point}");
        let real = cell(&row, "expected_max_real_per_s");
        let modulus = cell(&row, "its_modulus_per_s");
        assert_within(&decimal(&cell(&row, "max_real_per_s")), &real, &modulus, PROMISE, &point);
        let imaginary = cell(&row, "expected_max_imaginary_per_s");
        assert_within(&decimal(&cell(&row, "max_imaginary_per_s")), &imaginary, &imaginary, PROMISE, &point);
        count += 1;
    }
    assert_eq!((count, count + refused.len()), (taken.len(), 321), "every case is tried");
}

#[test]
fn points_beyond_the_range_of_inputs_are_refused_by_row() {
    let (head, _, refused) = table();
    assert!(!refused.is_empty());
    // One at a time, because a long list of faults is cut.
    for row in refused {
        let output = classify_points(&format!("{head}{row}"));
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{row}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            said.contains("row 1, column ") && said.contains("out of range (allowed: 1e-300 to 1e300)"),
            "{said}"
        );
    }
}
