//! What README.md, docs/guide.md, docs/claims.md, docs/fit.md and docs/from-pandas-or-matlab.md show is what the program prints.

use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use crate::harness::Workplace;

const README: &str = include_str!("../../README.md");
const GUIDE: &str = include_str!("../../docs/guide.md");
const TABLES: &str = include_str!("../../docs/from-pandas-or-matlab.md");
const FITS: &str = include_str!("../../docs/fit.md");
const FIT_PICTURE: &str = include_str!("../../docs/fit.svg");
const PEAK_PICTURE: &str = include_str!("../../docs/fit-peaks.svg");
const BASALT: &str = include_str!("../data/records/basalt-step.csv");
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

/// The file that a sentence before a block names, and whether the block is added to it.
fn file_of(before: &str) -> Option<(&str, bool)> {
    let sentence = before.trim_end().strip_suffix("`:")?;
    let (verb, file) = sentence.rsplit_once(" `")?;
    [("This is", false), ("Add to", true)]
        .into_iter()
        .find_map(|(words, adds)| verb.ends_with(words).then_some((file, adds)))
}

/// Follows a text in a new folder: writes the files that it shows, runs its examples, this many, and compares what they print with
/// what it shows.
pub fn check_examples(text: &str, count: usize, place: &Workplace) {
    assert_eq!(examples(text).len(), count);
    let parts: Vec<&str> = text.split("```").collect();
    for pair in parts.chunks_exact(2) {
        let (before, (_, block)) = (pair[0], pair[1].split_once('\n').unwrap());
        if let Some((arguments, shown)) = block.strip_prefix(PROMPT).and_then(|it| it.split_once('\n')) {
            let printed = printed(arguments, &place.path(""));
            assert!(is_as_shown(&printed, shown), "slipmode {arguments} printed:\n{printed}");
        } else if let Some((file, adds)) = file_of(before) {
            let earlier = if adds { place.read(file) + "\n" } else { String::new() };
            place.write(file, earlier + block);
        }
    }
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
    place.write("basalt-step.csv", BASALT);
    check_examples(GUIDE, 21, &place);
    assert!(place.read("basalt/scenes/basalt.toml").contains("direct_effect = \"[0.00899"));
    assert!(place.read("target/report/lab/index.html").contains("<html"));
    let text = place.read("target/report/lab/ledger.md");
    let answer = "1. At 5 MPa and 10 µm/s, the slip mode is non-inertial underdamped oscillation or stick-slip, \
        depending on the values within the error bars.";
    assert!(text.contains(answer), "{text}");
    let settled = "a measurement of evolution effect b as 0.0126 ± 0.00011 would settle the mode.";
    assert!(text.contains(settled), "{text}");
    states_for_which_values_each_verdict_was_decided(&place.read("target/report/lab/ledger.json"), &text);
    assert!(place.read("lab/prose/introduction.md").contains("| 7.8e-6 to 8.2e-6 | m |"));
    assert!(place.read("lab/scenes/lab.toml").contains("direct_effect = \"0.009±0.0002\"  #"));
    assert!(place.read("target/report/lab/figures/operating-map.svg").contains("boundary-band"));
}

/// What rests on runs or points of the middle values says so, and what is proved does not.
fn states_for_which_values_each_verdict_was_decided(ledger: &str, text: &str) {
    let ledger: Value = serde_json::from_str(ledger).unwrap();
    let point = &ledger["operating_points"][0];
    assert_eq!((&point["certain"], &point["transition_signs"]), (&json!(false), &json!([-1, 1])));
    assert_eq!(point["slip_modes"], json!(["non-inertial-underdamped-oscillation", "stick-slip"]));
    let claims = ledger["claims"].as_array().unwrap();
    let decided_for = |id: &str| &claims.iter().find(|claim| claim["id"] == id).unwrap()["error_bars"];
    for (id, values) in
        [("S1", "all-values"), ("L1", "all-values"), ("N1", "middle-values"), ("N5", "middle-values")]
    {
        assert_eq!(decided_for(id), values, "{id}");
    }
    for claim in claims {
        let is_computed = ["certified", "converged", "sampled"].iter().any(|it| claim["strength"] == *it);
        assert!(!is_computed || claim["error_bars"] == "middle-values", "{claim}");
    }
    let of = |values: &str| claims.iter().filter(|claim| claim["error_bars"] == values).count();
    let said = |words: &str| text.matches(words).count();
    assert_eq!(said("Error bars: the verdict holds for all values within them"), of("all-values"));
    assert_eq!(said("the verdict was decided for the middle values"), of("middle-values"));
}

#[test]
fn the_commands_for_pandas_and_matlab_work_as_written() {
    let place = Workplace::new();
    for name in ["lab.csv", "run.csv"] {
        let block = TABLES.split(&format!("`{name}`:\n\n```csv\n")).nth(1).unwrap();
        place.write(name, block.split("```").next().unwrap());
    }
    check_examples(TABLES, 4, &place);
    let rows = place.read("classified.csv");
    let mode = rows.lines().next().unwrap().split(',').position(|name| name == "slip_mode").unwrap();
    let modes: Vec<&str> = rows.lines().skip(1).map(|row| row.split(',').nth(mode).unwrap()).collect();
    assert_eq!(modes, ["stick-slip", "non-inertial-underdamped-oscillation", "stick-slip"]);
    assert!(place.read("simulated.csv").lines().skip(1).all(|row| row.ends_with(",ok")));
}

#[test]
fn the_pictures_of_fits_are_what_their_commands_draw() {
    let place = Workplace::new();
    place.write("basalt-step.csv", BASALT);
    place.write("peaks.csv", include_str!("../data/peaks.csv"));
    check_examples(FITS, 2, &place);
    for (name, picture) in [("fit.svg", FIT_PICTURE), ("fit-peaks.svg", PEAK_PICTURE)] {
        assert!(place.read(name) == picture, "docs/{name} is not what the example of docs/fit.md draws");
    }
}

#[test]
fn what_is_left_out_is_only_what_the_mark_stands_for() {
    assert!(is_as_shown("a\nb\nc 1\n", "a\n…\nc…\n"));
    assert!(is_as_shown("a\nb\n", "…\n") && is_as_shown("a\n", "a\n"));
    for wrong in ["a\n", "b\nc 1\n", "a\n…\nd\n", "a\nb\nc…\nd\n"] {
        assert!(!is_as_shown("a\nb\nc 1\n", wrong), "{wrong}");
    }
}
