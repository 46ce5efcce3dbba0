//! Files of the proofs: the library in the order of its imports, and the generated ones.

use crate::prelude::*;
use crate::repository::texts;
use crate::tidy::comment_length;

/// Name and text of each module of the library.
pub type Library = Vec<(String, String)>;

/// Words that let a file state what it does not prove.
const FORBIDDEN: &str = "Admitted admit Axiom Axioms Parameter Parameters Conjecture Hypothesis Declare";

/// The library's modules, each after those that it imports.
pub fn library(folder: &Path) -> Result<Library> {
    in_order(texts(folder, ".v")?)
}

fn in_order(mut waiting: Library) -> Result<Library> {
    let mut ordered = Library::new();
    while !waiting.is_empty() {
        let is_known = |name: &&str| ordered.iter().any(|(known, _)| known == name);
        let next = waiting.iter().position(|(_, text)| imports(text).iter().all(is_known));
        let next =
            next.ok_or_else(|| Failure::check("proofs/: a module imports one that is missing or itself"))?;
        ordered.push(waiting.remove(next));
    }
    Ok(ordered)
}

/// The text of all modules of the library, in its order, on which a text rests.
pub fn imported(library: &Library, text: &str) -> String {
    let (mut wanted, mut found) = (imports(text), Vec::new());
    // A module stands after those that it imports.
    for (name, text) in library.iter().rev() {
        if wanted.contains(&name.as_str()) {
            wanted.extend(imports(text));
            found.push(text.as_str());
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
pub fn check_text(name: &str, text: &str) -> Result {
    let is_inner = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let is_forbidden = |word: &&str| FORBIDDEN.split(' ').any(|forbidden| forbidden == *word);
    let plain = without_comments(text);
    let found = plain.split(|c| !is_inner(c)).find(is_forbidden);
    found.map_or(Ok(()), |word| Err(Failure::check(format!("{name}: has the word {word}"))))
}

/// The text without its comments, which may lie in each other.
fn without_comments(text: &str) -> String {
    let (mut plain, mut rest) = (String::new(), text);
    while let Some((before, _)) = rest.split_once("(*") {
        plain += before;
        rest = &rest[before.len()..];
        rest = &rest[comment_length(rest, ["(*", "*)"])..];
    }
    plain + rest
}

/// The names after this word at the beginning of a line.
pub fn names<'t>(text: &'t str, word: &'t str) -> impl Iterator<Item = &'t str> {
    text.lines().filter_map(move |line| line.strip_prefix(word)?.split_whitespace().next())
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
