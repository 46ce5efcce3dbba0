//! What README.md, docs/guide.md and docs/from-pandas-or-matlab.md show is what the program prints.

use std::path::Path;
use std::process::Command;

use crate::harness::Workplace;

const README: &str = include_str!("../../README.md");
const GUIDE: &str = include_str!("../../docs/guide.md");
const TABLES: &str = include_str!("../../docs/from-pandas-or-matlab.md");
const PROMPT: &str = "$ slipmode ";
/// Stands for any lines on a line of its own, and for any rest at the end of a line.
const LEFT_OUT: &str = "…";

/// Command line and printed text of every example: a fenced block that begins with the prompt.
fn examples(text: &str) -> Vec<(String, String)> {
    text.split("```\n")
        .filter_map(|block| block.strip_prefix(PROMPT)?.split_once('\n'))
        .map(|(arguments, output)| (arguments.to_string(), output.to_string()))
        .collect()
}

/// What an example prints, run in a folder.
fn printed(arguments: &str, folder: &Path) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipmode"));
    let output = command.args(arguments.split_whitespace()).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Whether a text is as shown, but for what the shown text leaves out.
fn is_as_shown(printed: &str, shown: &str) -> bool {
    let mut printed = printed.lines();
    let mut skipping = false;
    for line in shown.lines() {
        if line == LEFT_OUT {
            skipping = true;
            continue;
        }
        let fits = |printed: &str| match line.strip_suffix(LEFT_OUT) {
            Some(start) => printed.starts_with(start),
            None => printed == line,
        };
        let found = if skipping { printed.any(fits) } else { printed.next().is_some_and(fits) };
        if !found {
            return false;
        }
        skipping = false;
    }
    skipping || printed.next().is_none()
}

#[test]
fn every_example_of_the_readme_prints_what_it_shows() {
    let examples = examples(README);
    assert!(!examples.is_empty());
    for (arguments, shown) in examples {
        assert_eq!(printed(&arguments, Path::new(".")), shown, "slipmode {arguments}");
    }
}

#[test]
fn the_guide_works_as_written_from_an_empty_folder() {
    let place = Workplace::new();
    let runs = GUIDE.split("```csv\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    place.write("runs.csv", runs);
    let examples = examples(GUIDE);
    assert_eq!(examples.len(), 15);
    for (arguments, shown) in examples {
        let printed = printed(&arguments, &place.path(""));
        assert!(is_as_shown(&printed, &shown), "slipmode {arguments} printed:\n{printed}");
    }
    assert!(place.read("target/report/lab/index.html").contains("<html"));
    let text = place.read("target/report/lab/report.md");
    let answer = "For all values within the error bars, the slider is linearly stable for some values and not for others, \
        and the possible slip modes are";
    assert!(
        text.contains(answer) && text.contains("every claim about runs holds for the middle values"),
        "{text}"
    );
    assert!(place.read("lab/prose/introduction.md").contains("| 7.8e-6 to 8.2e-6 | m |"));
    assert!(place.read("lab/scenes/lab.toml").contains("direct_effect = \"0.009±0.0002\"  #"));
    assert!(place.read("target/report/lab/figures/fig-1.svg").contains("boundary-band"));
}

#[test]
fn the_commands_for_pandas_and_matlab_work_as_written() {
    let place = Workplace::new();
    for name in ["lab.csv", "run.csv"] {
        let block = TABLES.split(&format!("`{name}`:\n\n```csv\n")).nth(1).unwrap();
        place.write(name, block.split("```").next().unwrap());
    }
    let examples = examples(TABLES);
    assert_eq!(examples.len(), 4);
    for (arguments, shown) in examples {
        let printed = printed(&arguments, &place.path(""));
        assert!(is_as_shown(&printed, &shown), "slipmode {arguments} printed:\n{printed}");
    }
    let rows = place.read("classified.csv");
    let mode = rows.lines().next().unwrap().split(',').position(|name| name == "slip_mode").unwrap();
    let modes: Vec<&str> = rows.lines().skip(1).map(|row| row.split(',').nth(mode).unwrap()).collect();
    assert_eq!(modes, ["stick-slip", "non-inertial-underdamped-oscillation", "stick-slip"]);
    assert!(place.read("simulated.csv").lines().skip(1).all(|row| row.ends_with(",ok")));
}

#[test]
fn what_is_left_out_is_only_what_the_mark_stands_for() {
    assert!(is_as_shown("a\nb\nc 1\n", "a\n…\nc…\n"));
    assert!(is_as_shown("a\nb\n", "…\n") && is_as_shown("a\n", "a\n"));
    for wrong in ["a\n", "b\nc 1\n", "a\n…\nd\n", "a\nb\nc…\nd\n"] {
        assert!(!is_as_shown("a\nb\nc 1\n", wrong), "{wrong}");
    }
}
