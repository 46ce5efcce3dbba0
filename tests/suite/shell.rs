//! What shells, `man` and people ask of the program itself: completions, manual pages, versions, exit codes, colours.

use std::io::Write;
use std::process::{Command, Stdio};

use crate::certificates::write_certified;
use crate::harness::{HEADER, Workplace};
use crate::sweep::SCENE;

/// The commands that `--help` lists.
fn commands(place: &Workplace) -> Vec<String> {
    let help = place.run(["--help"]).expect_success();
    let listed = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap().to_owned();
    let indented = listed.lines().filter_map(|line| line.strip_prefix("  "));
    indented
        .filter(|line| !line.starts_with(' '))
        .filter_map(|line| Some(line.split(' ').next()?.into()))
        .collect()
}

#[test]
fn the_help_of_a_command_begins_with_what_the_list_says_of_it() {
    let place = Workplace::new();
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let list = words(&place.run(["--help"]).expect_success());
    for command in commands(&place).iter().filter(|command| *command != "help") {
        let help = place.run([command, "--help"]).expect_success();
        let first = words(help.split("\n\n").next().unwrap());
        assert!(list.contains(&format!(" {command} {first} ")), "{command}: {first}");
    }
}

#[test]
fn completion_scripts_know_every_command() {
    let place = Workplace::new();
    let commands = commands(&place);
    assert!(commands.len() > 15, "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = place.run(["completions", shell]).expect_success();
        for command in &commands {
            assert!(script.contains(command), "{shell}: {command}");
        }
    }
    let script = place.run(["completions", "bash"]).expect_success();
    let mut bash = Command::new("bash").arg("-n").stdin(Stdio::piped()).spawn().unwrap();
    bash.stdin.take().unwrap().write_all(script.as_bytes()).unwrap();
    assert!(bash.wait().unwrap().success());
    place.run(["completions", "tcsh"]).expect_refusal(&["tcsh"]);
}

#[test]
fn every_command_has_a_manual_page_with_its_options() {
    let place = Workplace::new();
    let whole = place.run(["man"]).expect_success();
    assert!(
        whole.starts_with(".ie") && whole.contains(".TH slipmode 1") && whole.contains("Exit codes:"),
        "{whole}"
    );
    for command in commands(&place).iter().filter(|command| *command != "help") {
        let page = place.run(["man", command]).expect_success();
        let heading = format!(".TH slipmode-{command} 1");
        assert!(page.contains(&heading) && page.contains(".SH OPTIONS"), "{page}");
    }
    place.run(["man", "clasify"]).expect_refusal(&["COMMAND = clasify: is no command (allowed: classify, "]);
}

#[test]
fn the_example_of_every_command_runs() {
    let place = Workplace::new();
    write_certified(&place);
    place.write("scene.toml", place.read("certified.toml"));
    place.write("sweep.toml", SCENE);
    place.write("statements.toml", include_str!("../../examples/check/brusselator.toml"));
    place.write("record.csv", include_str!("../data/bad_records/good.csv"));
    let run = "0.009,0.0126,8e-6,2e9,2400,3e6,1e-5,decaying";
    place.write("runs.csv", format!("{HEADER},mode\n{run}\n"));
    place.run(["new", "--paper", "lab"]).expect_success();
    for archive in ["lab.zip", "revised.zip"] {
        place.run(["archive", "lab", "-o", archive]).expect_success();
    }
    for command in commands(&place).iter().filter(|command| *command != "help") {
        let help = place.run([command, "--help"]).expect_success();
        let example = help.split("Example:\n  slipmode ").nth(1).unwrap_or_else(|| panic!("{help}"));
        // What an example writes is not there yet.
        let place = if command == "new" { &Workplace::new() } else { &place };
        if command == "archive" {
            std::fs::remove_file(place.path("lab.zip")).unwrap();
        }
        assert_eq!(example.lines().count(), 1, "{example}");
        let ended = place.run(example.split_whitespace());
        assert_eq!(ended.code, 0, "{ended:?}");
    }
}

#[test]
fn no_line_of_help_is_longer_than_a_page_of_text() {
    let place = Workplace::new();
    for command in commands(&place).iter().filter(|command| *command != "help") {
        let help = place.run([command, "--help"]).expect_success();
        let mut lines = help.lines().filter(|line| !line.starts_with("Usage: "));
        assert!(lines.all(|line| line.chars().count() <= 110), "{help}");
    }
}

#[test]
fn versions_name_the_libraries_and_the_digest_of_the_sources() {
    let place = Workplace::new();
    let said = place.run(["--version"]).expect_success();
    let lines: Vec<&str> = said.lines().collect();
    let [program, gmp, mpfr, mpc, compiler, sources] = lines[..] else { panic!("{said}") };
    assert_eq!(program, concat!("slipmode ", env!("CARGO_PKG_VERSION")));
    assert!(
        gmp.starts_with("GMP ")
            && mpfr.starts_with("MPFR ")
            && mpc.starts_with("MPC ")
            && compiler.contains("rustc")
    );
    let digest = sources.strip_prefix("sources ").unwrap();
    assert!(digest.len() == 64 && digest.bytes().all(|byte| byte.is_ascii_hexdigit()), "{digest}");
    assert_eq!(place.run(["-V"]).expect_success(), format!("{program}\n"));
}

#[test]
fn no_color_leaves_colours_out() {
    let help = |variables: &[(&str, &str)]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipmode"));
        command.arg("--help").env_remove("NO_COLOR").envs(variables.iter().copied());
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    let forced = ("CLICOLOR_FORCE", "1");
    assert!(help(&[forced]).contains('\u{1b}') && !help(&[]).contains('\u{1b}'));
    assert!(!help(&[forced, ("NO_COLOR", "1")]).contains('\u{1b}'));
}
