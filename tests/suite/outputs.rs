//! Outputs: complete or absent, never over foreign files, and silent when the reader is gone.

use std::fs;
use std::process::{Command, Stdio};

use crate::harness::{Ended, HEADER, ROW, SLIDER, Workplace};

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n\
    [boundary]\npoints = 3\ndigits = 20\n";

fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("in.csv", format!("{HEADER}\n{ROW}\n"));
    place.write("s.toml", SCENE);
    place
}

#[test]
fn a_file_is_written_only_where_a_file_may_be() {
    let place = workplace();
    fs::create_dir(place.path("folder")).unwrap();
    let points = |out: &'static str| ["classify", "--points", "in.csv", "-o", out];
    place.run(points("folder")).expect_refusal(&["folder: is a folder; name a file"]);
    place.run(points("missing/out.csv")).expect_refusal(&["missing/out.csv: cannot be created"]);
    place.run(points("..")).expect_refusal(&["is a folder; name a file"]);
    assert_eq!(place.names(), ["folder", "in.csv", "s.toml"]);
}

#[cfg(unix)]
#[test]
fn links_and_devices_are_left_alone() {
    use std::os::unix::fs::symlink;
    let place = workplace();
    place.write("elsewhere.csv", "precious");
    symlink(place.path("elsewhere.csv"), place.path("link.csv")).unwrap();
    fs::create_dir(place.path("other")).unwrap();
    symlink(place.path("other"), place.path("link")).unwrap();
    place.run(["classify", "--points", "in.csv", "-o", "link.csv"]).expect_refusal(&["is a symbolic link"]);
    place
        .run(["classify", "--points", "in.csv", "-o", "/dev/null"])
        .expect_refusal(&["is not a regular file"]);
    place.run(["run", "s.toml", "-o", "link"]).expect_refusal(&["is a symbolic link"]);
    place.run(["run", "s.toml", "-o", "link/"]).expect_refusal(&["is a symbolic link"]);
    assert_eq!(place.read("elsewhere.csv"), "precious");
    assert_eq!(place.names(), ["elsewhere.csv", "in.csv", "link", "link.csv", "other", "s.toml"]);
}

#[test]
fn a_folder_replaces_an_earlier_output_and_nothing_else() {
    let place = workplace();
    place.write("theirs/letter.txt", "precious");
    place.run(["run", "s.toml", "-o", "theirs"]).expect_refusal(&["is not empty and not an earlier output"]);
    place.run(["run", "s.toml", "-o", "in.csv"]).expect_refusal(&["is a file; name a folder"]);
    place.run(["run", "s.toml", "-o", "."]).expect_refusal(&["is not a name that can be written"]);
    fs::create_dir(place.path("out")).unwrap();
    let first = place.run(["run", "s.toml", "-o", "out"]).expect_success();
    assert!(first.contains("out/tables/boundary.csv"), "{first}");
    place.write("out/tables/stale.csv", "old");
    assert_eq!(place.run(["run", "s.toml", "-o", "out/"]).expect_success().replace("//", "/"), first);
    assert!(!place.path("out/tables/stale.csv").exists());
    place.write("out/.t.csv.x.partial", "what a kill has left");
    place.run(["run", "s.toml", "-o", "out"]).expect_success();
    assert_eq!(place.read("theirs/letter.txt"), "precious");
    assert_eq!(place.names(), ["in.csv", "out", "s.toml", "theirs"]);
}

/// What others have put into a folder stays there, whatever file of ours the folder has as well.
#[test]
fn a_folder_with_files_of_others_is_never_replaced() {
    let place = workplace();
    let run = || place.run(["run", "s.toml", "-o", "out"]);
    run().expect_success();
    let ours = place.read("out/environment.json");
    let cases = [
        ("out/environment.json", "out: is not empty and not an earlier output"),
        ("out/notes.md", "notes.md"),
        ("out/.git/HEAD", ".git/"),
        ("out/tables/old/t.csv", "tables/old/"),
        ("out/tables/t.xlsx", "tables/t.xlsx"),
        ("out/figures/\u{e4}.svg", "figures/\u{e4}.svg"),
        ("out/index.html", "index.html"),
    ];
    for (file, named) in cases {
        fs::remove_dir_all(place.path("out")).unwrap();
        place.write("out/environment.json", &ours);
        place.write(file, "{}");
        run().expect_refusal(&[named]);
        assert_eq!(place.read(file), "{}");
    }
}

#[test]
fn outputs_have_the_same_bytes_on_any_number_of_threads() {
    let place = workplace();
    for threads in ["1", "2"] {
        let folder = format!("out-{threads}");
        place.run(["run", "s.toml", "-o", &folder, "--threads", threads]).expect_success();
        let boundary = ["boundary"].iter().chain(&SLIDER).copied().chain(["--threads", threads, "-o"]);
        place.run(boundary.chain([format!("b-{threads}.csv").as_str()])).expect_success();
    }
    assert_eq!(place.read("out-1/tables/boundary.csv"), place.read("out-2/tables/boundary.csv"));
    assert_eq!(place.read("b-1.csv"), place.read("b-2.csv"));
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_ends_the_program_quietly() {
    let place = workplace();
    place.write("long.csv", format!("{HEADER}\n{}", format!("{ROW}\n").repeat(20_000)));
    let mut child = Command::new(env!("CARGO_BIN_EXE_slipmode"))
        .args(["classify", "--points", "long.csv"])
        .current_dir(place.path(""))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert_eq!(output.status.code(), Some(0));
}

/// An output that is one of the inputs, under any of its names, is refused before anything is computed.
#[cfg(unix)]
#[test]
fn an_output_never_overwrites_an_input() {
    let place = workplace();
    place.write("runs.csv", format!("{HEADER},peak_velocity_m_per_s,trajectory\n{ROW},,t.csv\n"));
    let samples: String = (0..12).map(|row| format!("{row}.5,{}e-3\n", 1 + row % 3)).collect();
    place.write("t.csv", format!("time_s,velocity_m_per_s\n{samples}"));
    fs::hard_link(place.path("in.csv"), place.path("hard.csv")).unwrap();
    std::os::unix::fs::symlink("in.csv", place.path("soft.csv")).unwrap();
    let before: Vec<String> = ["in.csv", "runs.csv", "t.csv", "s.toml"].map(|name| place.read(name)).into();
    let law = ["--law", "slip"];
    for arguments in [
        &["classify", "--points", "in.csv", "-o", "in.csv"][..],
        &["classify", "--points", "in.csv", "-o", "./in.csv"],
        &["classify", "--points", "in.csv", "-o", "hard.csv"],
        &["classify", "--points", "soft.csv", "-o", "in.csv"],
        &["simulate", law[0], law[1], "--points", "in.csv", "-o", "in.csv"],
        &["compare", "--runs", "runs.csv", "-o", "runs.csv"],
        &["compare", "--runs", "runs.csv", "-o", "t.csv"],
        &["compare", "--runs", "runs.csv", "--keep-going", "-o", "t.csv"],
        &["explore", "s.toml", "-o", "s.toml"],
    ] {
        let ended = place.run(arguments.iter().copied());
        assert_eq!(ended.code, 2, "{arguments:?}: {}", ended.stderr);
        assert!(
            ended.stderr.contains(": is read and written by this command")
                && !ended.stderr.contains("cannot"),
            "{arguments:?}: {}",
            ended.stderr
        );
        let now: Vec<String> = ["in.csv", "runs.csv", "t.csv", "s.toml"].map(|name| place.read(name)).into();
        assert_eq!(now, before, "{arguments:?}");
    }
    let two = ["compare", "--runs", "runs.csv", "--report", "out", "-o", "out/rows.csv"];
    fs::create_dir(place.path("out")).unwrap();
    place.run(two).expect_refusal(&["is or holds another output of this command"]);
}

/// The name of a file changes no result. Only scripts need names that a shell can be given.
#[cfg(target_os = "linux")]
#[test]
fn names_that_are_not_utf8_are_read_written_and_reported() {
    use std::ffi::OsString;
    use std::os::unix::ffi::OsStringExt;
    let name = |text: &str| {
        let bytes = text.bytes().map(|byte| if byte == b'?' { 0xff } else { byte });
        OsString::from_vec(bytes.collect())
    };
    let place = crate::archive::small_report();
    crate::certificates::write_certified(&place);
    place.write("s.toml", SCENE);
    let sweep = "[sweep]\nwork = \"classify\"\nblock_points = 2\n[sweep.grid]\n\
        normal_stress_pa = { from = 1e3, to = 1e7, points = 5 }\nloading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 2 }\n";
    let sweep = SCENE.replace("[boundary]\npoints = 3\ndigits = 20\n", sweep);
    place.write("w.toml", &sweep);
    place.write("k.toml", include_str!("../../examples/check/laser.toml"));
    for (from, to) in [
        ("small", "p?"),
        ("s.toml", "s?.toml"),
        ("w.toml", "w?.toml"),
        ("k.toml", "k?.toml"),
        ("certified.toml", "f?.toml"),
    ] {
        fs::rename(place.path(from), place.path("").join(name(to))).unwrap();
    }
    let run = |arguments: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipmode"));
        command.args(arguments.split(' ').map(name)).current_dir(place.path(""));
        Ended::from(command.output().unwrap())
    };
    for arguments in [
        "explore s?.toml -o e?.html",
        "run s?.toml -o r?",
        "report p? -o o?",
        "verify p? -o o?",
        "archive p? -o a?.zip",
        "replay a?.zip",
        "diff a?.zip a?.zip",
        "check k?.toml",
        "sweep w?.toml --out b?",
        "merge b? -o m?.csv",
        "merge b? --missing",
        "certificates f?.toml",
        "certificates new.toml --law slip -o c?.csv",
        "new n --paper -o n?",
    ] {
        run(arguments).expect_warnings();
        let again = run(&format!("{} --json", arguments.replace("-o n?", "-o m?")));
        let found: serde_json::Value = serde_json::from_str(&again.expect_warnings()).unwrap();
        assert!(found["inputs"].is_object(), "{found}");
    }
    run("sweep w?.toml --out b --slurm").expect_refusal(&["a path that is not UTF-8"]);
    place.write("w.toml", sweep);
    let script = ["sweep", "w.toml", "--out", "b\ntouch x #", "--slurm", "--shards", "2"];
    place.run(script).expect_refusal(&["b\\u{a}touch x #: a script cannot contain a path", "line break"]);
}

/// Redirections hide the name of a file, and not the file.
#[cfg(unix)]
#[test]
fn a_redirected_input_is_not_overwritten() {
    let place = workplace();
    let binary = env!("CARGO_BIN_EXE_slipmode");
    for command in [
        format!("'{binary}' classify --points - -o in.csv < in.csv"),
        format!("'{binary}' classify --points in.csv >> in.csv"),
    ] {
        let output = Command::new("sh").args(["-c", &command]).current_dir(place.path("")).output().unwrap();
        let ended = Ended::from(output);
        assert_eq!(ended.code, 2, "{command}: {}", ended.stderr);
        assert!(ended.stderr.contains("is read and written by this command"), "{}", ended.stderr);
        assert_eq!(place.read("in.csv"), format!("{HEADER}\n{ROW}\n"), "{command}");
    }
}
