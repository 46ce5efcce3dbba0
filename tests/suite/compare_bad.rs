//! `compare` on input at fault: runs files, trajectories, and units that are off by a power of ten.

use serde_json::Value;

use crate::harness::{HEADER, ROW, Workplace};

const NAMES: &str = "time_s,velocity_m_per_s";

/// Compares one run whose trajectory is this text, and checks that it is refused.
fn refuse_trajectory(text: &str, parts: &[&str]) {
    let place = Workplace::new();
    place.write("runs.csv", format!("{HEADER},trajectory\n{ROW},t.csv\n"));
    place.write("t.csv", text);
    place.run(["compare", "--runs", "runs.csv", "-o", "out.csv", "--report", "out"]).expect_refusal(parts);
    assert_eq!(place.names(), ["runs.csv", "t.csv"]);
}

fn refuse_runs(text: &str, more: &[&str], parts: &[&str]) {
    let place = Workplace::new();
    place.write("runs.csv", text);
    place.run(["compare", "--runs", "runs.csv"].iter().chain(more).copied()).expect_refusal(parts);
}

/// Even samples of an oscillation about 1e-3 m/s.
fn wave(times: impl Iterator<Item = f64>) -> String {
    let line = |time: f64| format!("{time},{}\n", 1e-3 * (24.0 * time).sin().exp());
    format!("{NAMES}\n{}", times.map(line).collect::<String>())
}

#[test]
fn the_header_is_a_contract() {
    let needs = "header, column peak_velocity_m_per_s: missing (allowed: at least one of the columns peak_velocity_m_per_s, period_s, stress_drop_pa, frequency_hz, mode, trajectory)";
    refuse_runs(&format!("{HEADER}\n{ROW}\n"), &[], &[needs]);
    refuse_runs(
        &format!("{HEADER},period_ms\n{ROW},1\n"),
        &[],
        &["runs.csv:1: header, column period_ms: unknown unit (allowed: `period_s`, in SI)"],
    );
    refuse_runs(
        &format!("{HEADER},peak_velocity_m_per_s,peak_velocity_mm_per_s\n{ROW},0.009,77\n"),
        &[],
        &[
            "column peak_velocity_mm_per_s: `peak_velocity_m_per_s` gives peak_velocity_m_per_s too; keep one of them",
        ],
    );
    refuse_runs(
        &format!("{HEADER},freqency_hz,mode\n{ROW},1,periodic\n"),
        &[],
        &["column frequency_hz: missing column; did you mean it by `freqency_hz`?"],
    );
    refuse_runs(
        &format!("{HEADER},law,mode,verdict\n{ROW},slip,periodic,1\n"),
        &["--law", "slip"],
        &["column law: needs no --law together with it", "column verdict: a column of the output"],
    );
    refuse_runs("", &[], &["runs.csv: empty file (wanted: a header line with the columns direct_effect, "]);
    refuse_runs(
        &format!("{HEADER},mode\n"),
        &["--tolerance", "2"],
        &["--tolerance = 2: out of range (allowed: 1e-13 to 0.5)"],
    );
    refuse_runs(&format!("{HEADER},mode\n"), &["--json", "-o", "-"], &["--output = -: needs a file"]);
}

#[test]
fn cells_at_fault_are_named_all_at_once() {
    let rows = format!(
        "{HEADER},law,start,tolerance,mode,period_s,trajectory\n{},slip,steady,1e-20,periodic-ish,-1,../t.csv\n",
        ROW.replace("1e7", "0")
    );
    refuse_runs(
        &rows,
        &[],
        &[
            "runs.csv:2: row 1, column stiffness_pa_per_m = 0: must be > 0 (allowed: 1e-300 to 1e300)",
            "runs.csv:2: row 1, column start = steady: unknown",
            "runs.csv:2: row 1, column tolerance = 1e-20: out of range (allowed: 1e-13 to 0.5)",
            "runs.csv:2: row 1, column mode = periodic-ish: unknown",
            "runs.csv:2: row 1, column period_s = -1: must be > 0",
            "runs.csv:2: row 1, column trajectory = ../t.csv: a name does not start with `.` or `-`",
        ],
    );
}

#[test]
fn a_trajectory_lies_beside_its_runs_file() {
    let place = Workplace::new();
    place.write("outside.csv", "x");
    place.write("in/t.csv", "x");
    let refuse = |name: &str, parts: &[&str]| {
        place.write("in/runs.csv", format!("{HEADER},trajectory\n{ROW},{name}\n"));
        place.run(["compare", "--runs", "in/runs.csv"]).expect_refusal(parts);
    };
    refuse("none.csv", &["in/runs.csv:2: row 1, column trajectory = none.csv: cannot be read: "]);
    refuse("/t.csv", &["a name has 1 to 100 characters"]);
    refuse("a\\b.csv", &["a name consists of"]);
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(place.path("outside.csv"), place.path("in/link.csv")).unwrap();
        refuse("link.csv", &["column trajectory = link.csv: is a link that leads out of in"]);
    }
    refuse("t.csv", &["in/t.csv:1: header, column time_s: missing column"]);
}

#[test]
fn a_trajectory_has_to_be_one() {
    refuse_trajectory(
        "",
        &["t.csv: empty file (wanted: a header line with the columns time_s, velocity_m_per_s"],
    );
    refuse_trajectory(&format!("{NAMES}\n0,1e-3\n"), &["t.csv: 1 samples (allowed: at least 8)"]);
    refuse_trajectory(&format!("{NAMES}\n"), &["t.csv: 0 samples"]);
    refuse_trajectory(
        "time_s,velocity_mm,shear_stress_mm\n0,1,1\n",
        &[
            "t.csv:1: header, column velocity_mm: mm is a length; velocity is m/s (allowed: velocity_m_per_s;",
            "t.csv:1: header, column shear_stress_mm: mm is a length; stress is Pa (allowed: shear_stress_pa;",
        ],
    );
    refuse_trajectory(
        &wave((0..4000).map(|i| f64::from(i) * 1e-3))
            .replace(NAMES, "time_s,velocity_m_per_s,velocity_mm_per_s"),
        &[
            "t.csv:1: header, column velocity_mm_per_s: `velocity_m_per_s` gives velocity_m_per_s too; keep one of them",
        ],
    );
    let reversed = |i: usize| {
        let angle = i as f64 * 0.1;
        format!("{angle},{},{}\n", 1e-3 * libm::exp(libm::sin(angle)), libm::cos(angle) * -1e3)
    };
    refuse_trajectory(
        &format!("{NAMES},shear_stress_pa\n{}", (0..400).map(reversed).collect::<String>()),
        &[
            "t.csv: column shear_stress_pa: the stress falls below V0 and rises above it, so the sign convention seems reversed",
        ],
    );
    refuse_trajectory(
        &format!("{NAMES}\n0,1e-3\n1,0\n1,1e-3\n0.5,nan\n2\n3,\n"),
        &[
            "t.csv:3: column velocity_m_per_s: 1 of 3 velocities are zero or negative (rows: 2; least: 0 m/s), and the friction law needs ln V; none exceeds V0",
            "t.csv:5: row 4, column velocity_m_per_s = nan: not a decimal number",
            "t.csv:6: row 5: 1 cells, where the header has 2",
            "t.csv:7: row 6, column velocity_m_per_s = \"\": not a decimal number",
        ],
    );
}

#[test]
fn velocities_that_are_not_positive_are_explained_in_one_message() {
    let rows = |velocity: &dyn Fn(usize) -> f64| -> String {
        let row = |i: usize| format!("{},{:e}\n", i as f64 * 0.01, velocity(i));
        format!("{NAMES}\n{}", (0..60).map(row).collect::<String>())
    };
    let wave = |i: usize| 1e-3 * libm::exp(libm::sin(i as f64 * 0.7));
    // The loading velocity is 1 mm/s.
    refuse_trajectory(
        &rows(&|i| if (10..14).contains(&i) || i == 30 { -2e-7 } else { wave(i) }),
        &[
            "t.csv:12: column velocity_m_per_s: 5 of 60 velocities are zero or negative (rows: 11-14, 31; least: -2e-7 m/s), and the friction law needs ln V; none exceeds V0 in size, as with the noise or the resolution of a sensor",
        ],
    );
    refuse_trajectory(
        &rows(&|i| if i % 5 == 0 { 1e-6 } else { -wave(i) }),
        &[
            "t.csv:3: column velocity_m_per_s: 48 of 60 velocities",
            "(rows: 2-5, 7-10,",
            ", and more;",
            "the sign convention seems reversed: multiply the column by -1",
        ],
    );
    refuse_trajectory(
        &rows(&|i| if i == 20 { -5e-2 } else { wave(i) }),
        &["1 of 60 velocities", "the slider moved back faster than V0, which needs another law"],
    );
}

#[test]
fn time_has_to_increase() {
    let steps = [0.0, 0.1, 0.2, 0.15, 0.3, 0.3, 0.4, 0.5, 0.6, 0.7];
    refuse_trajectory(
        &wave(steps.into_iter()),
        &[
            "t.csv:5: row 4, column time_s = 0.15: time does not increase (allowed: more than 2e-1, the time of the row before)",
            "t.csv:7: row 6, column time_s = 0.3: time does not increase (allowed: more than 3e-1",
        ],
    );
}

#[test]
fn a_gap_is_named_with_its_line() {
    let times = (0..4000).map(|i| f64::from(i) * 1e-3).filter(|time| !(2.0..2.9).contains(time));
    refuse_trajectory(
        &wave(times),
        &[
            "t.csv:2002: column time_s: a gap of 9.0100e-1 s before this row, where the usual step takes 1.0000e-3 s",
        ],
    );
}

#[test]
fn of_many_faults_of_a_trajectory_the_first_are_told() {
    let place = Workplace::new();
    place.write("runs.csv", format!("{HEADER},trajectory\n{ROW},t.csv\n"));
    place.write("t.csv", format!("{NAMES}\n{}", "x,1\n".repeat(9000)));
    let ended = place.run(["compare", "--runs", "runs.csv"]);
    assert!(ended.code == 2 && ended.stderr.chars().count() < 1_500, "{}", ended.stderr);
    assert!(ended.stderr.contains("t.csv:6") && ended.stderr.contains("more like these"), "{}", ended.stderr);
}

/// What `compare` says of one row with the period, peak velocity and stress drop of the paper's slider at 0.1 MPa and 1 mm/s.
fn reason(row: &str, values: &str) -> (String, Vec<Value>) {
    let rows = format!("{HEADER},period_s,peak_velocity_m_per_s,stress_drop_pa\n{row},{values}\n");
    let ended = Workplace::new().run_with_input(["compare", "--runs", "-", "--json"], &rows);
    assert_eq!(ended.code, 1);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    let row = &found["rows"][0];
    (row["reason"].as_str().unwrap().to_string(), row["warnings"].as_array().unwrap().clone())
}

#[test]
fn units_are_told_from_what_fits() {
    let values = "0.2614008,0.009124622,1828.848";
    let (found, warnings) = reason(&ROW.replace("1e5", "0.1"), values);
    assert_eq!(
        found,
        "normal stress looks like MPa (wanted: Pa): all 3 numbers of the run fit with it times 1e6, and not as written"
    );
    // Outside the tested range as it stands, which is named.
    assert!(
        warnings[1]
            .as_str()
            .unwrap()
            .starts_with("kappa = K D_c/(a sigma) is 250000, outside the tested range")
    );
    let cases = [
        (ROW.replace(",1e-3", ",1"), values.to_string(), "loading velocity looks like mm/s (wanted: m/s)"),
        (ROW.replace(",1e-3", ",1000"), values.to_string(), "loading velocity looks like um/s (wanted: m/s)"),
        (ROW.replace("1e-5", "10"), values.to_string(), "critical slip distance looks like um (wanted: m)"),
        (ROW.into(), values.replace("0.009", "9."), "peak velocity looks like mm/s (wanted: m/s)"),
        (ROW.into(), values.replace("1828.848", "1828848000"), "stress drop"),
        (ROW.into(), values.replace("0.2614008", "261.4008"), "period looks like ms (wanted: s)"),
    ];
    for (row, values, wanted) in cases {
        let (found, _) = reason(&row, &values);
        let is_unexplained = wanted == "stress drop";
        assert!(
            if is_unexplained { found == "stress drop: differs" } else { found.starts_with(wanted) },
            "{found}"
        );
    }
}

#[test]
fn a_velocity_scale_is_told_from_a_trajectory() {
    let place = Workplace::new();
    let point = ["-s", "1e5", "-v", "1e-3", "--law", "slip", "--trajectory", "t.csv"];
    place.run(["simulate"].iter().chain(&crate::harness::SLIDER).chain(&point).copied()).expect_success();
    place.write("runs.csv", format!("{HEADER},trajectory\n{},t.csv\n", ROW.replace(",1e-3", ",1")));
    let looks = |wanted: &str| {
        let ended = place.run(["compare", "--runs", "runs.csv"]);
        assert_eq!(ended.code, 1);
        assert!(ended.stdout.contains(wanted), "{}", ended.stdout);
    };
    looks("loading velocity looks like mm/s (wanted: m/s)");
    // Times in ms.
    place.write("runs.csv", format!("{HEADER},trajectory\n{ROW},t.csv\n"));
    let slower = |line: &str| {
        let (time, rest) = line.split_once(',').unwrap();
        time.parse().map_or(line.into(), |time: f64| format!("{},{rest}", 1e3 * time))
    };
    place.write("t.csv", place.read("t.csv").lines().map(slower).collect::<Vec<String>>().join("\n") + "\n");
    looks("period looks like ms (wanted: s)");
}
