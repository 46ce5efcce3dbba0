//! What README.md shows is what the program prints.

use std::process::Command;

const README: &str = include_str!("../../README.md");
const PROMPT: &str = "$ slipmode ";

/// Command line and printed text of every example: a fenced block that begins with the prompt.
fn examples() -> Vec<(String, String)> {
    README
        .split("```\n")
        .filter_map(|block| block.strip_prefix(PROMPT)?.split_once('\n'))
        .map(|(arguments, output)| (arguments.to_string(), output.to_string()))
        .collect()
}

#[test]
fn every_example_of_the_readme_prints_what_it_shows() {
    let examples = examples();
    assert!(!examples.is_empty());
    for (arguments, shown) in examples {
        let mut command = Command::new(env!("CARGO_BIN_EXE_slipmode"));
        let output = command.args(arguments.split_whitespace()).output().unwrap();
        assert!(output.status.success(), "{arguments}");
        assert_eq!(String::from_utf8(output.stdout).unwrap(), shown, "slipmode {arguments}");
    }
}
