//! Scenes that are at fault: every row names file, line, key and range; nothing is written.

use crate::harness::Workplace;

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [map]\nloading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 5 }\n\
    normal_stress_pa = { from = 1e2, to = 1e8, points = 5 }\n";

fn refuse(content: impl AsRef<[u8]>, parts: &[&str]) {
    let place = Workplace::new();
    place.write("s.toml", content);
    place.run(["run", "s.toml", "-o", "out"]).expect_refusal(parts);
    assert_eq!(place.names(), ["s.toml"]);
}

#[test]
fn every_way_to_get_a_scene_wrong_is_named() {
    let cases = [
        (
            "direct_effect = 0.004",
            "direct_effect = -1",
            "s.toml:4: parameters.direct_effect = -1: must be > 0",
        ),
        ("direct_effect = 0.004", "direct_effect = 0", "parameters.direct_effect = 0: must be > 0"),
        (
            "direct_effect = 0.004",
            "direct_effect = nan",
            "parameters.direct_effect = nan: not a decimal number",
        ),
        (
            "direct_effect = 0.004",
            "direct_effect = inf",
            "parameters.direct_effect = inf: not a decimal number",
        ),
        (
            "direct_effect = 0.004",
            "direct_effect = 1e400",
            "direct_effect = 1e400: out of range (allowed: 1e-300 to 1e300)",
        ),
        ("direct_effect = 0.004", "direct_effect = 1e-400", "direct_effect = 1e-400: out of range"),
        ("direct_effect = 0.004", "direct_effect = true", "must be a number, not true or false"),
        ("direct_effect = 0.004", "direct_effect = [1]", "must be a number, not a list"),
        (
            "direct_effect = 0.004",
            "sigmaa = 1",
            "s.toml:4: parameters.sigmaa: unknown key (allowed: direct_effect",
        ),
        ("direct_effect = 0.004", "direct_efect = 1", "unknown key; did you mean `direct_effect`?"),
        (
            "direct_effect = 0.004",
            "",
            "s.toml:3: parameters.direct_effect: missing (allowed: a positive number)",
        ),
        ("from = 1e-6", "from = 0", "map.loading_velocity_m_per_s.from = 0: must be > 0"),
        ("from = 1e-6", "from = 1", "map.loading_velocity_m_per_s: reversed range"),
        ("from = 1e-6", "from = 0.1", "map.loading_velocity_m_per_s: empty range"),
        ("points = 5", "points = 0", "map.loading_velocity_m_per_s.points = 0: out of range"),
        ("points = 5", "points = 1", "out of range (allowed: a whole number, 2 or more"),
        ("points = 5", "points = 4000", "limit of 4194304 (--max-points N raises it)"),
        ("points = 5", "points = 9223372036854775807", "limit of 4194304 (--max-points N raises it)"),
        (
            "name = \"s\"",
            "name = \"../../x\"",
            "s.toml:1: name = \"../../x\": a name consists of A-Z a-z 0-9 . _ - only",
        ),
        ("name = \"s\"", "name = \"-rf\"", "a name does not start with `.` or `-`"),
        ("name = \"s\"", "name = \"CON\"", "reserved by Windows"),
        ("name = \"s\"", "name = \"a\\u0000b\"", "character U+0000 is not allowed"),
        ("name = \"s\"", "name = 3", "name = 3: must be a text in quotes, not a number"),
        ("title = \"S\"", "name = \"t\"", "not valid TOML: duplicate key"),
        ("title = \"S\"", "title = \"\u{202e}S\"", "s.toml:2: character U+202E is not allowed"),
        ("title = \"S\"", "title = ", "s.toml:2: not valid TOML"),
    ];
    for (from, to, message) in cases {
        refuse(SCENE.replace(from, to), &[message]);
    }
}

#[test]
fn files_that_are_no_scenes_are_refused() {
    let place = Workplace::new();
    place.run(["run", "none.toml", "-o", "out"]).expect_refusal(&["none.toml: cannot be read"]);
    place.run(["run", ".", "-o", "out"]).expect_refusal(&[".: is a folder"]);
    refuse(vec![b' '; (1 << 20) + 1], &["1048577 bytes (allowed: at most 1048576)"]);
    refuse(b"\xff\xfen\0", &["s.toml:1: UTF-16 text (wanted: UTF-8"]);
    refuse(format!("a = {}", "[".repeat(100_000)), &["s.toml:1: not valid TOML"]);
    let sweep = "name = \"s\"\ntitle = \"S\"\n[[swept.sweep]]\nname = \"none\"\nversion = \"1\"\nmachine = \"m\"\n\
        core_seconds = 1\npeak_memory_mib = 1\n";
    refuse(format!("{sweep}scene_sha256 = \"{}\"\n", "0".repeat(64)), &["none.toml: cannot be read"]);
}

#[test]
fn all_faults_of_a_scene_are_told_at_once() {
    let place = Workplace::new();
    place.write("s.toml", SCENE.replace("1e7", "-1e7").replace("= 5", "= 0").replace("title", "titel"));
    let ended = place.run(["run", "s.toml"]);
    assert_eq!(ended.stderr.lines().count(), 5, "{}", ended.stderr);
    ended.expect_refusal(&["titel: unknown key; did you mean `title`?", "title: missing"]);
    assert_eq!(place.names(), ["s.toml"]);
}

#[test]
fn the_limit_on_points_can_be_lifted_or_lowered() {
    let place = Workplace::new();
    place.write("s.toml", SCENE);
    place
        .run(["run", "s.toml", "-o", "out", "--max-points", "24"])
        .expect_refusal(&["25 points exceed the limit of 24"]);
    place.run(["run", "s.toml", "-o", "out", "--max-points", "25"]).expect_success();
    place.run(["run", "s.toml", "-o", "out", "--max-points", "x"]).expect_refusal(&["--max-points = x"]);
}
