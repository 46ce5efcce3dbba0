//! What an archive asks for is limited: each kind of input is refused by name, at once, and `--budget` lifts the limit.

use std::time::{Duration, Instant};

use slipmode::archive::{Budget, Caps, Files, ReleaseTime, pack, sha256_hex};

use crate::archive::archived;
use crate::harness::Workplace;

const SLIDER: &str = "name = \"a\"\ntitle = \"A\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";
const AXES: &str = "loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 1000 }\n\
    normal_stress_pa = { from = 1e2, to = 1e8, points = 1000 }\n";

/// Replaces the scene of the small report's archive.
fn asking(scene: &str) -> Workplace {
    let place = archived();
    let container = std::fs::read(place.path("small.zip")).unwrap();
    let (mut files, time): (Files, ReleaseTime) =
        slipmode::archive::unpack(&container, &Caps::default()).unwrap();
    files.insert("input/scenes/a.toml".into(), scene.as_bytes().to_vec());
    files.remove("SHA256SUMS");
    let sums: String = files.iter().map(|(path, bytes)| format!("{}  {path}\n", sha256_hex(bytes))).collect();
    files.insert("SHA256SUMS".into(), sums.into_bytes());
    place.write("asking.zip", pack(&files, time).unwrap());
    place
}

/// Replays such an archive, which is refused at once with this message.
#[track_caller]
fn refuse(scene: &str, options: &[&str], parts: &[&str]) {
    let place = asking(scene);
    let started = Instant::now();
    let ended = place.run(["replay", "asking.zip"].into_iter().chain(options.iter().copied()));
    assert!(started.elapsed() < Duration::from_secs(30), "{:?}", started.elapsed());
    ended.expect_refusal(&[parts, &["error: asking.zip: ", "--budget FACTOR lifts it"]].concat());
}

#[test]
fn two_million_simulations_at_1e_15_are_refused() {
    let scene = format!("{SLIDER}[simulations]\n{AXES}laws = [\"slip\", \"aging\"]\ntolerance = 1e-15\n");
    refuse(
        &scene,
        &[],
        &["scenes/a.toml: simulations: 2000000 simulations at tolerance 1e-15", "s of work on one core"],
    );
}

#[test]
fn a_million_digits_and_four_million_boundary_points_are_refused() {
    refuse(
        &format!("{SLIDER}[boundary]\npoints = 8\ndigits = 1000000\n"),
        &[],
        &["scenes/a.toml: boundary: 16 points of 1000000 digits (budget: 20000 digits of a result)"],
    );
    refuse(
        &format!("{SLIDER}[boundary]\npoints = 4000000\ndigits = 20\n"),
        &[],
        &["boundary: 8000000 points", "MiB of memory"],
    );
}

#[test]
fn grids_are_refused_by_their_sum() {
    let axes = AXES.replace("1000", "2000");
    let scene = format!("{SLIDER}[map]\n{axes}[zones]\n{axes}");
    refuse(&scene, &["--budget", "0.1"], &["scenes/a.toml: ", "4000000 points", "MiB of memory"]);
}

#[test]
fn a_parameter_of_five_thousand_digits_is_refused() {
    let scene = format!(
        "{}[boundary]\npoints = 8\ndigits = 30\n",
        SLIDER.replace("0.004", &format!("0.004{}", "1".repeat(5000)))
    );
    refuse(&scene, &[], &["input/scenes/a.toml:4: a number of 5004 digits (budget: 1000)"]);
    let longer = scene.replacen(&"1".repeat(5000), &"1".repeat(1100), 1);
    let ended = asking(&longer).run(["replay", "asking.zip", "--budget", "2"]);
    assert_eq!(ended.code, 1, "with twice the budget it is computed, and differs: {}", ended.stderr);
}

#[cfg(target_os = "linux")]
#[test]
fn memory_is_measured_and_the_message_says_what_was_asked_for() {
    let place = asking(&format!("{SLIDER}[boundary]\npoints = 10000\ndigits = 90\n"));
    // 61.44 MiB: twice what the program takes to read the inputs, less than it takes to compute.
    let ended = place.run(["replay", "asking.zip", "--budget", "0.03"]);
    ended.expect_refusal(&[
        "asking.zip: stopped after 61.44 MiB of memory (budget); the largest request is scenes/a.toml: boundary: 20000 points of 90 digits",
        "--budget FACTOR lifts it",
    ]);
    assert!(!place.path("out").exists());
}

#[test]
fn the_help_states_the_limits_and_the_factor_is_checked() {
    let place = Workplace::new();
    let help = place.run(["replay", "--help"]).expect_success();
    let help: String = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains(&Budget::default().text()), "{help}");
    place.run(["replay", "x.zip", "--budget", "0"]).expect_refusal(&["--budget = 0", "1e-6 to 1e6"]);
}
