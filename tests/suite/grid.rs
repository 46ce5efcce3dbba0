//! `classify` of a grid: the counts are those of its points, on any number of threads, and all faults of axes are reported at once.

use serde_json::Value;

use crate::harness::{HEADER, SLIDER, Workplace};

const AXES: [&str; 4] = ["--grid-loading-velocity", "1e-7:10:9", "--grid-normal-stress", "100:1e9:8"];

fn grid(more: &[&str]) -> String {
    let arguments = ["classify"].iter().chain(&SLIDER).chain(&AXES).chain(more);
    Workplace::new().run(arguments.copied()).expect_success()
}

#[test]
fn a_grid_counts_what_the_rows_of_a_file_say_one_by_one() {
    let found: Value = serde_json::from_str(&grid(&["--json"])).unwrap();
    // Both axes step by whole powers of ten, so that the rows are the grid's points to the last bit of their decimals.
    let mut rows = format!("{HEADER}\n");
    for velocity in ["1e-7", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "1e-1", "1", "10"] {
        for stress in ["1e2", "1e3", "1e4", "1e5", "1e6", "1e7", "1e8", "1e9"] {
            rows += &format!("0.004,0.006,1e-5,1e7,1000,{stress},{velocity}\n");
        }
    }
    let place = Workplace::new();
    place.write("points.csv", rows);
    // Axes this long leave what laboratories have.
    let table = place.run(["classify", "--points", "points.csv"]).expect_warnings();
    for (section, column) in [("spectral_class", 9), ("slip_mode", 10)] {
        let counts = found[section].as_object().unwrap();
        assert_eq!(counts.values().map(|count| count.as_u64().unwrap()).sum::<u64>(), 72);
        for (name, count) in counts {
            let rows = table.lines().filter(|line| line.split(',').nth(column) == Some(name)).count();
            assert_eq!(count.as_u64(), Some(rows as u64), "{name}");
        }
    }
    assert_eq!((&found["points"], &found["loading_velocities"]), (&72.into(), &9.into()));
}

#[test]
fn the_counts_do_not_depend_on_the_threads() {
    let one = grid(&["--threads", "1", "--inertial-threshold", "0.9"]);
    assert_eq!(one, grid(&["--threads", "3", "--inertial-threshold", "0.9"]));
    assert!(one.starts_with(&format!("{:<37}{:>13}  (9 velocities x 8 stresses)\n", "points", 72)), "{one}");
    assert_ne!(one, grid(&[]));
}

#[test]
fn everything_wrong_with_a_grid_is_told_at_once() {
    let arguments = ["classify", "-a", "0", "-b", "1", "-k", "1", "-m", "1", "-s", "5"];
    let axes = ["--grid-loading-velocity", "-1:1e400:1", "--grid-normal-stress", "1:2"];
    let ended = Workplace::new().run(arguments.into_iter().chain(axes));
    assert_eq!(ended.stderr.lines().count(), 7, "{}", ended.stderr);
    ended.expect_refusal(&[
        "--direct-effect = 0: must be > 0",
        "--critical-slip-distance-m: missing",
        "--normal-stress-pa = 5: needs no grid: the grid's axes give this value",
        "--grid-loading-velocity, FROM = -1: must be > 0",
        "--grid-loading-velocity, TO = 1e400: out of range (allowed: 1e-300 to 1e300)",
        "--grid-loading-velocity, N = 1: out of range (allowed: a whole number from 2 to 1000000)",
        "--grid-normal-stress = \"1:2\": must be FROM:TO:N, such as 1e2:1e9:1000, not another text",
    ]);
}

#[test]
fn a_grid_needs_two_axes_that_ascend_and_no_file() {
    let refused = |more: &[&str], expected: &[&str]| {
        let arguments = ["classify"].iter().chain(&SLIDER).chain(more);
        Workplace::new().run(arguments.copied()).expect_refusal(expected);
    };
    refused(&["--grid-normal-stress", "1:2:3"], &["--grid-loading-velocity: missing"]);
    let velocity = ["--grid-loading-velocity", "1:2:3", "--grid-normal-stress"];
    refused(&[&velocity[..], &["2:1:3"]].concat(), &["= \"2:1:3\": reversed range"]);
    refused(&[&velocity[..], &["1:1.0:3"]].concat(), &["= \"1:1.0:3\": empty range"]);
    refused(&[&velocity[..], &["1:2:1000001"]].concat(), &["N = 1000001: out of range"]);
    refused(&[&velocity[..], &["a:b:c"]].concat(), &["FROM = a: not a decimal", "TO = b: ", "N = c: "]);
    refused(&["--points", "x.csv", "--grid-normal-stress", "1:2:3"], &["cannot be used with"]);
}
