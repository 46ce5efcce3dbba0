//! Outputs that cannot be finished: a clear message, exit code 2, and nothing left behind.

#![cfg(target_os = "linux")]

use std::fs::OpenOptions;
use std::process::{Command, Stdio};

use crate::harness::{Ended, HEADER, ROW, SLIDER, Workplace};

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [boundary]\npoints = 40\ndigits = 20\n";

fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("in.csv", format!("{HEADER}\n{}", format!("{ROW}\n").repeat(100)));
    place.write("s.toml", SCENE);
    place
}

/// Runs the binary where no file may grow beyond 512 bytes or a kibibyte (the shells differ): a full disk without needing one.
fn run_on_a_full_disk(place: &Workplace, arguments: &[&str]) -> Ended {
    let command = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
    let output = Command::new("sh")
        .args(["-c", command, env!("CARGO_BIN_EXE_slipmode")])
        .args(arguments)
        .current_dir(place.path(""))
        .output()
        .unwrap();
    Ended::from(output)
}

#[test]
fn a_full_disk_leaves_nothing_half_written() {
    let place = workplace();
    place.write("kept.csv", "earlier");
    let points = ["classify", "--points", "in.csv", "-o", "kept.csv"];
    run_on_a_full_disk(&place, &points).expect_refusal(&["kept.csv: cannot be written: File too large"]);
    let boundary: Vec<&str> =
        ["boundary"].iter().chain(&SLIDER).copied().chain(["-o", "curve.csv"]).collect();
    run_on_a_full_disk(&place, &boundary).expect_refusal(&["curve.csv: cannot be written: File too large"]);
    run_on_a_full_disk(&place, &["run", "s.toml", "-o", "out"])
        .expect_refusal(&["out/", "cannot be written"]);
    assert_eq!(place.names(), ["in.csv", "kept.csv", "s.toml"]);
    assert_eq!(place.read("kept.csv"), "earlier", "an earlier output survives");
    place.run(points).expect_success();
    assert_eq!(place.read("kept.csv").lines().count(), 101, "with room again the same command does its work");
}

#[test]
fn a_full_standard_output_is_an_error() {
    let place = workplace();
    for arguments in [&["classify", "--points", "in.csv"][..], &["run", "s.toml", "-o", "out"]] {
        let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_slipmode"))
            .args(arguments)
            .current_dir(place.path(""))
            .stdout(Stdio::from(full))
            .output()
            .unwrap();
        Ended::from(output).expect_refusal(&["standard output: No space left on device"]);
    }
}

#[test]
fn a_folder_that_takes_no_files_is_named() {
    let place = workplace();
    // No user can create files there.
    place
        .run(["classify", "--points", "in.csv", "-o", "/proc/out.csv"])
        .expect_refusal(&["/proc/", "cannot be created"]);
    place.run(["run", "s.toml", "-o", "/proc/out"]).expect_refusal(&["/proc/out", "cannot be written"]);
    assert_eq!(place.names(), ["in.csv", "s.toml"]);
}
