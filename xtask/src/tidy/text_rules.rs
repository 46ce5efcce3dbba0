//! Rules for every text file: clean line ends, no notes to oneself, nothing that belongs to one machine.

use super::{Complaint, TextFile};
use crate::prelude::*;

const UNFINISHED_WORDS: [&str; 4] = ["TODO", "FIXME", "XXX", "HACK"];

/// First folders of absolute paths that exist on one machine only; the checkout's own path is another.
const MACHINE_FOLDERS: [&str; 3] = ["root", "home", "Users"];

/// Hosts of package registries: a mirror's name belongs to a machine, and the default needs no mention.
const REGISTRY_HOSTS: [&str; 5] = ["crates.io", "pypi.org", "npmjs", "proxy.golang", "artifactory"];

/// The source of every package in the lock file.
const LOCK_SOURCE: &str = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";

/// Files that programs or other people have written.
const GENERATED: [&str; 6] =
    ["/published/", "tests/golden/", "proptest-regressions", "/snapshots/", "LICENSE-", "COPYING"];

/// Checks all rules of this file; written-by-program files and this rule's own words are exempt where it says so.
pub fn check(file: &TextFile, found: &mut Vec<Complaint>) {
    let is_lock = file.path == "Cargo.lock" || file.path.ends_with("/Cargo.lock");
    let is_ours = !is_lock && !GENERATED.iter().any(|part| file.path.contains(part));
    let holds_the_words = file.path == "xtask/src/tidy/text_rules.rs";
    // Not `lines()`, which would hide a carriage return.
    for (index, line) in file.text.split('\n').enumerate() {
        let message = if is_lock {
            let is_foreign = line.starts_with("source = ") && line != LOCK_SOURCE;
            is_foreign.then(|| "a package from elsewhere than the default registry".into())
        } else if holds_the_words {
            None
        } else {
            unfinished_word(line).or_else(|| machine_path(line))
        };
        let space = whitespace(line).filter(|_| is_ours).map(String::from);
        found.extend(space.into_iter().chain(message).map(|message| file.complaint(index + 1, message)));
    }
    if is_ours && !file.text.is_empty() && (!file.text.ends_with('\n') || file.text.ends_with("\n\n")) {
        found.push(file.complaint(0, "a text file ends with exactly one line break"));
    }
}

fn whitespace(line: &str) -> Option<&'static str> {
    match line {
        _ if line.contains('\t') => Some("a tab: indent with spaces"),
        _ if line.ends_with([' ', '\r']) => Some("trailing whitespace"),
        _ => None,
    }
}

fn unfinished_word(line: &str) -> Option<String> {
    let words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
    let word = UNFINISHED_WORDS.iter().find(|unfinished| words.clone().any(|word| word == **unfinished))?;
    Some(format!("`{word}`: do it or drop it"))
}

fn machine_path(line: &str) -> Option<String> {
    if let Some(host) = REGISTRY_HOSTS.iter().find(|host| line.contains(**host)) {
        return Some(format!("a registry's host, `{host}`"));
    }
    let folder = machine_folders().into_iter().find(|folder| is_absolute_below(line, folder))?;
    Some(format!("an absolute path of one machine, below `{folder}`"))
}

fn machine_folders() -> Vec<String> {
    let checkout = root().to_string_lossy().trim_matches('/').to_string();
    let mut folders = Vec::from(MACHINE_FOLDERS.map(String::from));
    folders.extend((!checkout.is_empty()).then_some(checkout));
    folders
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

    fn complaints(path: &str, text: &str) -> Vec<usize> {
        let file = TextFile { path: path.into(), text: text.into() };
        let mut found = Vec::new();
        check(&file, &mut found);
        found.iter().map(|complaint| complaint.line).collect()
    }

    #[test]
    fn clean_text_passes() {
        let [word, folder] = [UNFINISHED_WORDS[0], MACHINE_FOLDERS[0]];
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
        let [word, host] = [UNFINISHED_WORDS[0], REGISTRY_HOSTS[0]];
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
