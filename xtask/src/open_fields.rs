//! `cargo xtask open-fields`: what only a person can state about the program and its paper, and has not stated yet.

use crate::failure::Failure;
use crate::repository;

/// Precedes such a field.
const MARK: &str = "OPEN FIELD: ";
/// The files that have such fields.
const FILES: [&str; 3] = ["metadata.toml", "paper.md", "paper.bib"];

/// Lists the open fields with file and line.
///
/// # Errors
/// When a file cannot be read.
pub fn run() -> Result<(), Failure> {
    let mut fields = Vec::new();
    for path in FILES {
        let text = std::fs::read_to_string(repository::root().join(path));
        let text = text.map_err(|error| Failure::bad_input(format!("{path}: {error}")))?;
        fields.extend(open(path, &text));
    }
    println!("{}\n{} open fields", fields.join("\n"), fields.len());
    Ok(())
}

fn open(path: &str, text: &str) -> Vec<String> {
    let lines = (1..).zip(text.lines());
    let marked = lines.filter_map(|(number, line)| Some((number, line.split_once(MARK)?.1)));
    let bare = |text: &str| text.trim_end_matches(['"', '}', ',']).trim_end_matches(" -->").to_string();
    marked.map(|(number, field)| format!("{path}:{number}: {}", bare(field))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_marked_field_is_named_with_its_line() {
        let text = "a\n  # OPEN FIELD: the DOI\nname = \"OPEN FIELD: who\",\n<!-- OPEN FIELD: thanks -->\nopen field\n";
        assert_eq!(open("f", text), ["f:2: the DOI", "f:3: who", "f:4: thanks"]);
    }
}
