//! Rules for every text file: clean line ends, and nothing that belongs to one machine.

use super::source::Source;
use crate::prelude::*;

/// First folders of absolute paths that exist on one machine only; the checkout's own path is another.
const MACHINE_FOLDERS: [&str; 3] = ["root", "home", "Users"];

/// The source of every package in the lock file.
const LOCK_SOURCE: &str = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";

/// Files that programs or other people have written.
const GENERATED: &str = "/published/ tests/golden/ proptest-regressions /snapshots/ LICENSE- COPYING";

/// Checks all rules of this file; written-by-program files are exempt where it says so.
pub fn check(file: &Source, found: &mut Vec<String>) {
    let is_lock = file.path == "Cargo.lock" || file.path.ends_with("/Cargo.lock");
    let is_ours = !is_lock && !GENERATED.split(' ').any(|part| file.path.contains(part));
    let folders = machine_folders();
    // Not `lines()`, which would hide a carriage return.
    for (index, line) in file.text.split('\n').enumerate() {
        let mut complain = |message: &str| found.push(file.complaint(index + 1, message));
        if is_ours && line.contains('\t') {
            complain("a tab: indent with spaces");
        } else if is_ours && line.ends_with([' ', '\r']) {
            complain("trailing whitespace");
        }
        if is_lock && line.starts_with("source = ") && line != LOCK_SOURCE {
            complain("a package from elsewhere than the default registry");
        }
        if let Some(folder) = folders.iter().find(|folder| !is_lock && is_absolute_below(line, folder)) {
            complain(&format!("an absolute path of one machine, below `{folder}`"));
        }
    }
    if is_ours && !file.text.is_empty() && (!file.text.ends_with('\n') || file.text.ends_with("\n\n")) {
        found.push(file.complaint(0, "a text file ends with exactly one line break"));
    }
}

/// These folders; the root of a checkout may be the machine's.
fn machine_folders() -> Vec<String> {
    let checkout = root().to_string_lossy().trim_matches('/').to_string();
    let folders = MACHINE_FOLDERS.map(String::from).into_iter().chain([checkout]);
    folders.filter(|folder| !folder.is_empty()).collect()
}

/// Whether the line has a path that begins at the root with this folder and goes on.
fn is_absolute_below(line: &str, folder: &str) -> bool {
    let pattern = format!("/{folder}/");
    line.match_indices(&pattern).any(|(at, _)| {
        let follows_a_path = line[..at].ends_with(|c: char| c.is_alphanumeric() || "._-~}".contains(c));
        let goes_on = line[at + pattern.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '.');
        !follows_a_path && goes_on
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::{lines_of, words};

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, |file, found| {
            check(file, found);
            words::check(file, found);
        })
    }

    #[test]
    fn clean_text_passes() {
        let [word, folder] = [words::of("drop it"), MACHINE_FOLDERS[0]];
        let good = format!(
            "a/{folder}/x {word}S to-do ~/{folder}/x $HOME/.cache \"https://a.org/{folder}/x\"\n\nend\n"
        );
        assert_eq!(complaints("README.md", &good), [0; 0]);
    }

    #[test]
    fn tabs_trailing_blanks_and_line_ends_are_refused() {
        assert_eq!(complaints("a.toml", "a\tb\nc \nd\r\ne"), [1, 2, 3, 0]);
        assert_eq!(complaints("a.toml", "a\n\n"), [0]);
        assert_eq!(complaints("tests/golden/a.csv", "a\tb\nc \nd"), [0; 0]);
    }

    #[test]
    fn unfinished_words_machine_paths_and_hosts_are_refused() {
        let [word, host] = [words::of("drop it"), words::of("registry")];
        for bad in [format!("// {word}: x\n"), format!("// see {host}\n")] {
            assert_eq!(complaints("a.rs", &bad), [1], "{bad}");
        }
        for folder in machine_folders() {
            assert_eq!(complaints("a.rs", &format!("end\n(/{folder}/.cargo)\n")), [2], "{folder}");
            assert_eq!(
                complaints("reports/a/published/b.json", &format!("\"/{folder}/x\"\n")),
                [1],
                "{folder}"
            );
        }
    }

    #[test]
    fn a_foreign_source_in_the_lock_file_is_refused() {
        assert_eq!(complaints("Cargo.lock", &format!("{LOCK_SOURCE}\n")), [0; 0]);
        assert_eq!(complaints("Cargo.lock", "source = \"registry+https://elsewhere/index\"\n"), [1]);
        assert_eq!(complaints("fuzz/Cargo.lock", "source = \"registry+https://elsewhere/index\"\n"), [1]);
    }
}
