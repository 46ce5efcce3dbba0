//! Files of the proofs: the library in the order of its imports, and the generated ones.

use std::path::Path;

use crate::failure::Failure;
use crate::repository::{below, read};

/// Words that let a file state what it does not prove.
const FORBIDDEN: [&str; 9] = [
    "Admitted",
    "admit",
    "Axiom",
    "Axioms",
    "Parameter",
    "Parameters",
    "Conjecture",
    "Hypothesis",
    "Declare",
];

/// The library's modules, each after those that it imports.
pub fn library(folder: &Path) -> Result<Vec<(String, String)>, Failure> {
    let mut waiting = Vec::new();
    for path in below(folder)? {
        if let Some(name) = path.strip_suffix(".v") {
            waiting.push((name.to_owned(), read(&folder.join(&path))?));
        }
    }
    in_order(waiting)
}

fn in_order(mut waiting: Vec<(String, String)>) -> Result<Vec<(String, String)>, Failure> {
    let mut ordered: Vec<(String, String)> = Vec::new();
    while !waiting.is_empty() {
        let ready = |(_, text): &(String, String)| {
            imports(text).iter().all(|name| ordered.iter().any(|(known, _)| known == name))
        };
        let next = waiting.iter().position(ready);
        let next =
            next.ok_or_else(|| Failure::check("proofs/: a module imports one that is missing or itself"))?;
        ordered.push(waiting.remove(next));
    }
    Ok(ordered)
}

/// The text of all modules of the library, in its order, on which a text rests.
pub fn imported(library: &[(String, String)], text: &str) -> String {
    let mut wanted: Vec<&str> = imports(text);
    let mut found: Vec<&str> = Vec::new();
    // A module stands after those that it imports.
    for (name, text) in library.iter().rev() {
        if wanted.contains(&name.as_str()) {
            wanted.extend(imports(text));
            found.push(text);
        }
    }
    found.into_iter().rev().collect()
}

/// The modules of the library that a text imports.
fn imports(text: &str) -> Vec<&str> {
    let lines = text.lines().filter_map(|line| line.strip_prefix("From Slipmode Require "));
    let names = lines.flat_map(|line| line.trim_end_matches('.').split_whitespace());
    names.filter(|name| !matches!(*name, "Import" | "Export")).collect()
}

/// Refuses a text that assumes what it should prove.
pub fn check_text(name: &str, text: &str) -> Result<(), Failure> {
    let is_inner = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let plain = without_comments(text);
    match plain.split(|c| !is_inner(c)).find(|word| FORBIDDEN.contains(word)) {
        Some(word) => Err(Failure::check(format!("{name}: has the word {word}"))),
        None => Ok(()),
    }
}

/// The text without its comments, which may lie in each other.
fn without_comments(text: &str) -> String {
    let (mut plain, mut depth, mut rest) = (String::new(), 0_usize, text);
    while let Some(first) = rest.chars().next() {
        let step = if rest.starts_with("(*") {
            depth += 1;
            2
        } else if depth > 0 && rest.starts_with("*)") {
            depth -= 1;
            2
        } else {
            if depth == 0 {
                plain.push(first);
            }
            first.len_utf8()
        };
        rest = &rest[step..];
    }
    plain
}

/// The names after this word at the beginning of a line.
pub fn names(text: &str, word: &str) -> Vec<String> {
    let lines = text.lines().filter_map(|line| line.strip_prefix(word));
    lines.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_come_after_their_imports_and_a_circle_is_refused() {
        let module =
            |name: &str, import: &str| (name.to_owned(), format!("From Slipmode Require Import {import}.\n"));
        let base = ("Base".to_owned(), "From Coq Require Import Reals.\n".to_owned());
        let ordered =
            in_order(vec![module("Alpha", "Middle"), module("Middle", "Base"), base]).expect("no circle");
        assert_eq!(
            ordered.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
            ["Base", "Middle", "Alpha"]
        );
        assert!(in_order(vec![module("Alpha", "Middle"), module("Middle", "Alpha")]).is_err());
        let rests_on = imported(&ordered, "From Slipmode Require Import Middle.\n");
        assert!(
            rests_on.contains("Import Reals")
                && rests_on.contains("Import Base")
                && !rests_on.contains("Import Middle")
        );
    }

    #[test]
    fn a_text_that_assumes_is_refused_and_a_comment_is_not() {
        assert!(check_text("a", "Lemma x : True. Proof. Admitted.").is_err());
        assert!(check_text("a", "Axiom x : False.").is_err());
        assert!(check_text("a", "(* no Axiom (* nor *) Admitted *) Lemma x : True. exact I. Qed.").is_ok());
    }
}
