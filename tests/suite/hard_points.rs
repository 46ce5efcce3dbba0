//! The hard cases again, through `classify --points`: what is printed keeps what the library promises.

use std::io::Write;
use std::process::{Command, Stdio};

use crate::hard_cases::{PARAMETERS, PROMISE, assert_within, decimal, rows};

/// Runs `classify --points` on standard streams and returns the rows it prints.
fn classify_points(csv: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
        .args(["classify", "--points", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let csv = csv.to_string();
    let writer = std::thread::spawn(move || input.write_all(csv.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_command_line_is_right_on_every_hard_point_of_the_inputs() {
    let csv: String =
        PARAMETERS.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    let answer = classify_points(&csv);
    let mut answers = rows(&answer);
    let header = answers.next().unwrap();
    let cell =
        |row: &[&str], name: &str| row[header.iter().position(|column| *column == name).unwrap()].to_string();
    let mut count = 0;
    for row in answers {
        let point = row[..7].join(",");
        for name in ["transition_sign", "boundary_sign", "spectral_class", "slip_mode"] {
            assert_eq!(cell(&row, name), cell(&row, &format!("expected_{name}")), "{name} of {point}");
        }
        let real = cell(&row, "expected_max_real_per_s");
        let modulus = cell(&row, "its_modulus_per_s");
        assert_within(&decimal(&cell(&row, "max_real_per_s")), &real, &modulus, PROMISE, &point);
        let imaginary = cell(&row, "expected_max_imaginary_per_s");
        assert_within(&decimal(&cell(&row, "max_imaginary_per_s")), &imaginary, &imaginary, PROMISE, &point);
        count += 1;
    }
    assert_eq!(count, 321, "every case is tried");
}
