//! What is named exists, and what exists is named: links between files, and data that tests read.

use super::source::Source;
/// Folders whose every file some test has to read.
const TEST_DATA: [&str; 3] = ["tests/data/", "tests/golden/", "tests/vectors/"];

/// Complains about files of test data that no Rust file mentions, by name or by the folder that a test walks.
pub fn check_data_is_read(files: &[Source], paths: &[String], found: &mut Vec<String>) {
    let sources = || files.iter().filter(|file| file.is_rust() && !file.path.starts_with("xtask/"));
    for path in paths.iter().filter(|path| !path.ends_with(".md") && !path.ends_with(".py")) {
        let Some(inside) = TEST_DATA.iter().find_map(|folder| path.strip_prefix(folder)) else { continue };
        let (folder, name) = inside.rsplit_once('/').unwrap_or(("", inside));
        let walked = &path["tests/".len()..path.len() - "/".len() - name.len()];
        let is_mentioned = |text: &str| text.contains(name) || !folder.is_empty() && text.contains(walked);
        if !sources().any(|source| is_mentioned(&source.text)) {
            found.push(format!("{path}: no test mentions this file: read it or delete it"));
        }
    }
}

/// Complains about links in a Markdown file to files that do not exist.
pub fn check_links(file: &Source, paths: &[String], found: &mut Vec<String>) {
    if !file.path.ends_with(".md") {
        return;
    }
    // A file, or a folder on the way to one.
    let is_known = |path: &str| {
        let goes_on = |rest: &str| path.is_empty() || rest.is_empty() || rest.starts_with('/');
        paths.iter().any(|known| known.strip_prefix(path).is_some_and(goes_on))
    };
    let mut in_fence = false;
    for (index, line) in file.text.lines().enumerate() {
        in_fence ^= line.trim_start().starts_with("```");
        for target in targets(line).filter(|target| !in_fence && is_local(target)) {
            if !is_known(&resolve(&file.path, target)) {
                found.push(file.complaint(index + 1, format!("the link `{target}` leads nowhere")));
            }
        }
    }
}

/// The targets of `[text](target)`, `![text](target)` and `src="target"` in a line, code spans left out.
fn targets(line: &str) -> impl Iterator<Item = &str> {
    let code_free = line.split('`').step_by(2);
    code_free.flat_map(|part| {
        let links = part.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next());
        let images = part.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next());
        links.chain(images)
    })
}

fn is_local(target: &str) -> bool {
    let is_elsewhere = target.starts_with("mailto:") || target.contains("://");
    !target.is_empty() && !target.starts_with('#') && !is_elsewhere
}

/// The path from the root that a link in `from` means.
fn resolve(from: &str, target: &str) -> String {
    let target = target.split('#').next().unwrap_or(target);
    let mut parts: Vec<&str> = if target.starts_with('/') { Vec::new() } else { from.split('/').collect() };
    parts.pop();
    for part in target.split('/').filter(|part| !matches!(*part, "" | ".")) {
        // Above the root there is nothing: the dots stay, so that the link leads nowhere.
        if part != ".." || parts.pop().is_none() {
            parts.push(part);
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::lines_of;

    fn paths() -> Vec<String> {
        ["README.md", "docs/a.md", "tests/vectors/a.txt", "tests/golden/run/b.csv", "tests/data/wrong/c.csv"]
            .map(String::from)
            .to_vec()
    }

    fn links(path: &str, text: &str) -> Vec<usize> {
        lines_of(path, text, |file, found| check_links(file, &paths(), found))
    }

    fn unread(test: &str) -> Vec<String> {
        let mut found = Vec::new();
        check_data_is_read(&[Source::new("tests/suite/a.rs", test)], &paths(), &mut found);
        found.iter().map(|complaint| complaint.split(": ").next().unwrap().to_owned()).collect()
    }

    #[test]
    fn links_to_files_folders_and_the_web_pass() {
        let good =
            "[a](docs/a.md#x) [b](tests/vectors/) [c](https://x.org) [d](#e)\n`[x](y)`\n```\n[x](y)\n```\n";
        assert_eq!(links("README.md", good), [0; 0]);
        assert_eq!(links("docs/a.md", "[up](../README.md) [here](a.md)"), [0; 0]);
    }

    #[test]
    fn links_that_lead_nowhere_are_refused() {
        assert_eq!(links("README.md", "ok\n[a](docs/b.md) and ![c](d.svg)"), [2, 2]);
        assert_eq!(links("docs/a.md", "[up](../../README.md)\n<img src=\"x.svg\">"), [1, 2]);
    }

    #[test]
    fn test_data_has_to_be_read() {
        assert_eq!(unread(""), ["tests/vectors/a.txt", "tests/golden/run/b.csv", "tests/data/wrong/c.csv"]);
        assert_eq!(unread("../vectors/a.txt, golden/run, data/wrong"), [""; 0]);
    }
}
