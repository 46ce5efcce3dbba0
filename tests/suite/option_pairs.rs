//! Every option acts or is refused: all pairs of options of every command are tried.
//!
//! A pair passes when it is refused, or when each of the two changes what the command writes while the other is given.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::path::Path;

use crate::harness::{HEADER, ROW, Workplace};

/// An option with its value, and the name that `--help` gives it.
type Choice = (&'static str, &'static [&'static str]);

/// A command with what it is given in any case, in one or more situations, and its options.
struct Command {
    bases: &'static [&'static [&'static str]],
    options: &'static [Choice],
}

const POINT: [&str; 15] = [
    "classify", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s", "1e5", "-v",
    "1e-3",
];
/// With error bars.
const BOX: [&str; 15] = [
    "classify",
    "-a",
    "0.004±0.0002",
    "-b",
    "0.006±0.0005",
    "-d",
    "1e-5",
    "-k",
    "1e7",
    "-m",
    "1000",
    "-s",
    "1e5",
    "-v",
    "1e-3",
];
const GRID: [&str; 15] = [
    "classify",
    "-a",
    "0.004",
    "-b",
    "0.006",
    "-d",
    "1e-5",
    "-k",
    "1e7",
    "-m",
    "1000",
    "--grid-loading-velocity",
    "1e-5:1e-1:7",
    "--grid-normal-stress",
    "1e3:1e7:9",
];

const SLIDER: [Choice; 7] = [
    ("--direct-effect", &["-a", "0.003"]),
    ("--evolution-effect", &["-b", "0.007"]),
    ("--critical-slip-distance-m", &["-d", "2e-5"]),
    ("--stiffness-pa-per-m", &["-k", "2e7"]),
    ("--mass-per-area-kg-per-m2", &["-m", "2000"]),
    ("--normal-stress-pa", &["-s", "2e5"]),
    ("--loading-velocity-m-per-s", &["-v", "2e-3"]),
];

const COMMANDS: &[Command] = &[
    Command {
        bases: &[&POINT, &BOX, &["classify", "--points", "in.csv"], &GRID, &["classify"]],
        options: &[
            SLIDER[0],
            SLIDER[1],
            SLIDER[2],
            SLIDER[3],
            SLIDER[4],
            SLIDER[5],
            SLIDER[6],
            ("--inertial-threshold", &["--inertial-threshold", "0.01"]),
            ("--grid-loading-velocity", &["--grid-loading-velocity", "1e-6:1:5"]),
            ("--grid-normal-stress", &["--grid-normal-stress", "1e2:1e8:5"]),
            ("--distribution", &["--distribution", "uniform"]),
            ("--samples", &["--samples", "200"]),
            ("--svg", &["--svg", "out.svg"]),
            ("--json", &["--json"]),
            ("--points", &["--points", "in.csv"]),
            ("--output", &["-o", "out.csv"]),
            ("--keep-going", &["--keep-going"]),
            ("--delimiter", &["--delimiter", ";"]),
            ("--decimal", &["--decimal", ","]),
        ],
    },
    Command {
        bases: &[
            &[
                "roots", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s", "1e5",
                "-v", "1e-3",
            ],
            &["roots"],
        ],
        options: &[
            SLIDER[0],
            SLIDER[1],
            SLIDER[2],
            SLIDER[3],
            SLIDER[4],
            SLIDER[5],
            SLIDER[6],
            ("--digits", &["--digits", "5"]),
            ("--json", &["--json"]),
        ],
    },
    Command {
        bases: &[
            &["boundary", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000"],
            &["boundary"],
        ],
        options: &[
            SLIDER[0],
            SLIDER[1],
            SLIDER[2],
            SLIDER[3],
            SLIDER[4],
            ("--points", &["--points", "5"]),
            ("--digits", &["--digits", "6"]),
            ("--frequency-ratio", &["--frequency-ratio", "0.7"]),
            ("--damping-ratio", &["--damping-ratio", "0.2"]),
            ("--at-velocity", &["--at-velocity", "1e-3"]),
            ("--at-normal-stress", &["--at-normal-stress", "1e3"]),
            ("--max-points", &["--max-points", "3"]),
            ("--json", &["--json"]),
            ("--svg", &["--svg", "out.svg"]),
            ("--output", &["-o", "out.csv"]),
        ],
    },
    Command {
        bases: &[
            &[
                "solve",
                "--for",
                "normal-stress",
                "--frequency",
                "10",
                "-a",
                "0.004",
                "-b",
                "0.006",
                "-d",
                "1e-5",
                "-k",
                "1e7",
                "-m",
                "1000",
                "-v",
                "1e-3",
            ],
            &["solve", "--for", "normal-stress", "--points", "in.csv", "--frequency", "10"],
            &[
                "solve",
                "--for",
                "stiffness",
                "-a",
                "0.0037",
                "-b",
                "0.0061",
                "-d",
                "1e-5",
                "-m",
                "1000",
                "-s",
                "1e5",
                "-v",
                "1e-3",
            ],
        ],
        options: &[
            SLIDER[0],
            SLIDER[1],
            SLIDER[2],
            SLIDER[3],
            SLIDER[4],
            SLIDER[5],
            SLIDER[6],
            ("--for", &["--for", "stiffness"]),
            ("--transition", &["--transition"]),
            ("--stable-for-box", &["--stable-for-box"]),
            ("--boundary", &["--boundary"]),
            ("--frequency", &["--frequency", "11"]),
            ("--angular-frequency", &["--angular-frequency", "12"]),
            ("--frequency-ratio", &["--frequency-ratio", "0.7"]),
            ("--growth-rate", &["--growth-rate", "-1"]),
            ("--digits", &["--digits", "5"]),
            ("--json", &["--json"]),
            ("--points", &["--points", "in.csv"]),
            ("--output", &["-o", "out.csv"]),
            ("--keep-going", &["--keep-going"]),
            ("--delimiter", &["--delimiter", ";"]),
            ("--decimal", &["--decimal", ","]),
        ],
    },
    Command {
        bases: &[
            &[
                "simulate", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000", "-s",
                "1e5", "-v", "1e-3", "--law", "slip",
            ],
            &["simulate", "--points", "in.csv", "--law", "slip"],
            &["simulate", "--points", "in.csv"],
            &[
                "simulate",
                "-a",
                "0.004",
                "-b",
                "0.006",
                "-d",
                "1e-5",
                "-k",
                "1e7",
                "-m",
                "1000",
                "-s",
                "1e5",
                "-v",
                "1e-3±1e-4",
                "--law",
                "slip",
            ],
            &["simulate", "--points", "bars.csv", "--law", "slip"],
            &["simulate", "--points", "bars.csv"],
        ],
        options: &[
            SLIDER[0],
            SLIDER[5],
            ("--box-runs", &["--box-runs", "3"]),
            ("--law", &["--law", "aging"]),
            ("--tolerance", &["--tolerance", "1e-5"]),
            ("--start", &["--start", "velocity-kick"]),
            ("--smallest-kick", &["--smallest-kick"]),
            ("--certify", &["--certify"]),
            ("--json", &["--json"]),
            ("--trajectory", &["--trajectory", "t.csv"]),
            ("--svg", &["--svg", "out.svg"]),
            ("--duration-s", &["--duration-s", "0.01"]),
            ("--samples", &["--samples", "9"]),
            ("--points", &["--points", "in.csv"]),
            ("--output", &["-o", "out.csv"]),
            ("--keep-going", &["--keep-going"]),
            ("--delimiter", &["--delimiter", ";"]),
            ("--decimal", &["--decimal", ","]),
        ],
    },
    Command {
        bases: &[
            &["tolerance", "-a", "0.004", "-b", "0.006", "-d", "1e-5", "-k", "1e7", "-m", "1000"],
            &["tolerance", "-a", "0.004", "-b", "0.006±0.001", "-d", "1e-5", "-k", "1e7", "-m", "1000"],
            &["tolerance"],
        ],
        options: &[
            SLIDER[0],
            SLIDER[1],
            SLIDER[2],
            SLIDER[3],
            SLIDER[4],
            ("--relative-error", &["-e", "0.2"]),
            ("--json", &["--json"]),
        ],
    },
    Command {
        bases: &[&["certificates", "certified.toml"]],
        options: &[
            ("--law", &["--law", "aging"]),
            ("--output", &["-o", "out.csv"]),
            ("--json", &["--json"]),
            ("--max-points", &["--max-points", "2"]),
        ],
    },
    Command {
        bases: &[
            &["compare", "--runs", "runs.csv"],
            &["compare", "--runs", "faulty.csv"],
            &["compare", "--runs", "bar-runs.csv"],
        ],
        options: &[
            ("--box-runs", &["--box-runs", "3"]),
            ("--law", &["--law", "aging"]),
            ("--tolerance", &["--tolerance", "0.3"]),
            ("--keep-going", &["--keep-going"]),
            ("--delimiter", &["--delimiter", ";"]),
            ("--decimal", &["--decimal", ","]),
            ("--json", &["--json"]),
            ("--output", &["-o", "out.csv"]),
            ("--report", &["--report", "out"]),
        ],
    },
    Command {
        bases: &[&["explore", "s.toml"], &["explore", "s.toml", "-s", "1e5"]],
        options: &[("--output", &["-o", "x.html"]), ("--json", &["--json"]), SLIDER[5], SLIDER[6]],
    },
    Command {
        bases: &[&["run", "s.toml"]],
        options: &[
            ("--output", &["-o", "out"]),
            ("--json", &["--json"]),
            ("--max-points", &["--max-points", "2"]),
        ],
    },
    Command {
        bases: &[&["report", "small"]],
        options: &[
            ("--output", &["-o", "out"]),
            ("--for-publication", &["--for-publication"]),
            ("--json", &["--json"]),
            ("--max-points", &["--max-points", "2"]),
        ],
    },
    Command {
        bases: &[&["verify", "small"]],
        options: &[
            ("--output", &["-o", "out"]),
            ("--for-publication", &["--for-publication"]),
            ("--json", &["--json"]),
            ("--max-points", &["--max-points", "2"]),
            ("--claim", &["--claim", "S1"]),
            ("--planted-faults", &["--planted-faults"]),
            ("--junit", &["--junit", "out.xml"]),
        ],
    },
    Command {
        bases: &[&["check", "statements.toml"]],
        options: &[("--claim", &["--claim", "B1"]), ("--json", &["--json"])],
    },
    Command {
        bases: &[&["archive", "small"]],
        options: &[
            ("--output", &["-o", "out.zip"]),
            ("--codecheck", &["--codecheck"]),
            ("--with-sources", &["--with-sources", "sources.tar.xz"]),
            ("--json", &["--json"]),
            ("--max-points", &["--max-points", "2"]),
        ],
    },
    Command {
        bases: &[&["sweep", "sweep.toml"]],
        options: &[
            ("--shard", &["--shard", "0/2"]),
            ("--out", &["--out", "out"]),
            ("--plan", &["--plan"]),
            ("--slurm", &["--slurm"]),
            ("--minutes", &["--minutes", "1"]),
            ("--shards", &["--shards", "2"]),
            ("--json", &["--json"]),
        ],
    },
    Command {
        bases: &[&["merge", "blocks"], &["merge", "fewer"]],
        options: &[
            ("--output", &["-o", "out.csv"]),
            ("--missing", &["--missing"]),
            ("--shards", &["--shards", "2"]),
            ("--json", &["--json"]),
        ],
    },
];

/// Options that change no result, and those that end the command at once.
const WITHOUT_EFFECT: [&str; 4] = ["--threads", "--quiet", "--help", "--version"];

/// A plan tells minutes apart only where a shard takes some: [`minutes_decide_how_many_shards_a_plan_has`].
const WITH_A_TEST_OF_ITS_OWN: (&str, &str) = ("--plan", "--minutes");

/// Commands without options of their own, and those whose options need hours, archives or reports, which tests of their own walk.
const ELSEWHERE: [&str; 7] = ["new", "fit", "replay", "diff", "help", "completions", "man"];

const SCENE: &str = "name = \"s\"\ntitle = \"S\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";

/// A scene with a sweep over a grid.
fn sweep(points: u32, block_points: u32) -> String {
    format!(
        "{SCENE}[sweep]\nwork = \"classify\"\nblock_points = {block_points}\n[sweep.grid]\n\
         normal_stress_pa = {{ from = 1e3, to = 1e7, points = {points} }}\n\
         loading_velocity_m_per_s = {{ from = 1e-6, to = 1e-1, points = {points} }}\n"
    )
}

fn workplace() -> Workplace {
    let place = Workplace::new();
    place.write("in.csv", format!("{HEADER}\n{ROW}\n"));
    place.write("faulty.csv", format!("{HEADER},peak_velocity_m_per_s\n{ROW},1.2e-2\n0,{ROW}\n"));
    place.write("runs.csv", format!("{HEADER},peak_velocity_m_per_s\n{ROW},1.2e-2\n"));
    // The period is beyond every tolerance of the middle value, 0.26 s, and within the error bars.
    let bars = ROW.replace(",1e-3", ",1e-3±5e-4");
    place.write("bars.csv", format!("{HEADER}\n{bars}\n"));
    place.write("bar-runs.csv", format!("{HEADER},period_s\n{bars},0.42\n"));
    place.write("s.toml", format!("{SCENE}[boundary]\npoints = 3\ndigits = 20\n"));
    place.write("statements.toml", include_str!("../../examples/check/brusselator.toml"));
    place.write("sweep.toml", sweep(8, 10));
    place.write("sources.tar.xz", b"\xfd7zXZ\0");
    for folder in ["blocks", "fewer"] {
        place.run(["sweep", "sweep.toml", "--out", folder]).expect_success();
    }
    fs::remove_file(place.path("fewer/block-000000002.csv")).unwrap();
    crate::certificates::write_certified(&place);
    place.write(
        "small/report.toml",
        "name = \"small\"\ntitle = \"Small\"\nscenes = [\"s\"]\n[[chapter]]\nid = \"c\"\ntitle = \"C\"\nprose = \"c.md\"\n",
    );
    place.write("small/scenes/s.toml", format!("{SCENE}[boundary]\npoints = 3\ndigits = 20\n"));
    place.write("small/prose/c.md", "Words.\n\n[[table:boundary]]\n");
    place.write(
        "small/claims.toml",
        "[[claim]]\nid = \"S1\"\nplace = \"eq 9\"\nwords = \"W\"\nexpected = \"holds\"\n",
    );
    place.write("small/equations.toml", include_str!("../../reports/im-avouac/equations.toml"));
    place
}

/// What a run did, apart from times.
#[derive(Debug, PartialEq)]
struct Deed {
    code: i32,
    stdout: String,
    stderr: String,
    files: BTreeMap<String, Vec<u8>>,
}

/// What the lines of a plan begin with that follow from measured times, in text and in JSON.
const TIMES: [&str; 7] = [
    "core-hours",
    "a point",
    "a block",
    "\"core_hours\"",
    "\"point_seconds\"",
    "\"block_seconds\"",
    "\"shard_minutes\"",
];

/// Runs a command and removes what it wrote.
fn deed(place: &Workplace, kept: &BTreeSet<String>, arguments: &[&str]) -> Deed {
    let ended = place.run(arguments.iter().copied());
    let mut files = BTreeMap::new();
    collect(&place.path(""), "", &mut files);
    files.retain(|name, _| !kept.contains(name));
    for name in files.keys() {
        fs::remove_file(place.path(name)).unwrap();
    }
    for folder in ["out", "target"] {
        let _ = fs::remove_dir_all(place.path(folder));
    }
    files.retain(|name, _| !name.ends_with("environment.json") && !name.ends_with(".timings.json"));
    // Of a plan, what follows from measured times differs from run to run: only the number of shards counts.
    let without_times = |line: &str| match line.split_once("  (about ") {
        Some((count, _)) => count.to_string(),
        None if TIMES.iter().any(|name| line.trim_start().starts_with(name)) => String::new(),
        None => line.to_string(),
    };
    let stdout = ended.stdout.lines().map(without_times).collect::<Vec<_>>().join("\n");
    Deed { code: ended.code, stdout, stderr: ended.stderr, files }
}

fn collect(folder: &Path, prefix: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type().unwrap().is_dir() {
            collect(&entry.path(), &format!("{name}/"), files);
        } else {
            files.insert(name, fs::read(entry.path()).unwrap());
        }
    }
}

/// The long options that the help of a command lists.
fn listed(place: &Workplace, command: &str) -> BTreeSet<String> {
    let help = place.run([command, "--help"]).expect_success();
    let first_word = |line: &str| -> Option<String> {
        let indented = line;
        let line = line.trim_start();
        // Deeper lines go on with what an option does.
        if indented.len() - line.len() > 6 {
            return None;
        }
        let line = line
            .strip_prefix('-')
            .filter(|rest| !rest.starts_with('-'))
            .map_or(line, |rest| rest.split_once(", ").map_or("", |(_, long)| long));
        line.starts_with("--").then(|| line.split([' ', '.']).next().unwrap_or_default().to_string())
    };
    help.lines().filter_map(first_word).collect()
}

#[test]
fn every_option_of_a_pair_acts_or_the_pair_is_refused() {
    let place = workplace();
    let mut kept = BTreeMap::new();
    collect(&place.path(""), "", &mut kept);
    let kept: BTreeSet<String> = kept.into_keys().collect();
    let (mut runs, mut pairs) = (0, 0);
    for command in COMMANDS {
        let mut done: BTreeMap<Vec<&str>, Deed> = BTreeMap::new();
        let mut acts =
            |base: &[&'static str], with: &[&'static str], without: &[&'static str]| -> (bool, bool) {
                let mut of = |more: &[&'static str]| -> Vec<&'static str> {
                    let arguments = [base, more].concat();
                    if !done.contains_key(&arguments) {
                        runs += 1;
                        done.insert(arguments.clone(), deed(&place, &kept, &arguments));
                    }
                    arguments
                };
                let (with, without) = (of(with), of(without));
                (done[&with].code == 2, done[&with] != done[&without])
            };
        for (index, (name, one)) in command.options.iter().enumerate() {
            for (other_name, other) in &command.options[index + 1..] {
                if (*name, *other_name) == WITH_A_TEST_OF_ITS_OWN {
                    continue;
                }
                pairs += 1;
                let both = [*one, *other].concat();
                let mut found = Vec::new();
                for base in
                    command.bases.iter().filter(|base| !base.contains(&one[0]) && !base.contains(&other[0]))
                {
                    let (refused, one_acts) = acts(base, &both, other);
                    let (_, other_acts) = acts(base, &both, one);
                    found.push((refused, one_acts, other_acts));
                }
                let accepted: Vec<_> = found.iter().filter(|(refused, ..)| !refused).collect();
                let what = format!("{} {name} {other_name}", command.bases[0][0]);
                assert!(
                    accepted.is_empty() || accepted.iter().any(|(_, acts, _)| *acts),
                    "{what}: {name} is ignored"
                );
                assert!(
                    accepted.is_empty() || accepted.iter().any(|(_, _, acts)| *acts),
                    "{what}: {other_name} is ignored"
                );
            }
        }
    }
    let _ = writeln!(std::io::stderr(), "option pairs: {pairs} pairs in {runs} runs");
}

#[test]
fn the_pairs_are_those_of_all_options_that_the_help_lists() {
    let place = Workplace::new();
    let help = place.run(["--help"]).expect_success();
    let commands = help.split_once("Commands:\n").unwrap().1.split_once("\nOptions:").unwrap().0;
    let commands = commands.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    for command in commands.filter_map(|line| line.split_whitespace().next()) {
        if ELSEWHERE.contains(&command) {
            continue;
        }
        let known = COMMANDS.iter().filter(|known| known.bases[0][0] == command).flat_map(|known| {
            let in_bases = known.bases.iter().flat_map(|base| base.iter().copied());
            known.options.iter().map(|(name, _)| *name).chain(in_bases)
        });
        let known: BTreeSet<&str> = known.chain(WITHOUT_EFFECT).collect();
        let slider: BTreeSet<&str> = SLIDER.iter().map(|(name, _)| *name).collect();
        for option in listed(&place, command) {
            let is_known = known.contains(option.as_str()) || slider.contains(option.as_str());
            assert!(is_known, "{command} {option} is not in the table of pairs");
        }
    }
}

#[test]
fn minutes_decide_how_many_shards_a_plan_has() {
    let place = Workplace::new();
    place.write("large.toml", sweep(200_000, 1_000_000));
    let shards = |minutes: &str| {
        let plan = place.run(["sweep", "large.toml", "--plan", "--minutes", minutes]).expect_success();
        let line = plan.lines().find(|line| line.starts_with("shards")).unwrap().to_string();
        line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap()
    };
    assert!(shards("10") > 3 * shards("1000"));
}
