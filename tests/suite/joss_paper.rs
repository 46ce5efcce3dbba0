//! `paper.md`: the form that the Journal of Open Source Software asks for, and numbers that the repository has measured.

use std::fs;
use std::path::Path;

const SECTIONS: [&str; 8] = [
    "Summary",
    "Statement of need",
    "State of the field",
    "Software design",
    "Research impact statement",
    "AI usage disclosure",
    "Acknowledgements",
    "References",
];

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn the_draft_has_the_sections_of_the_journal_in_its_length() {
    let paper = read("paper.md");
    let (_, rest) = paper.split_once("---\n").unwrap();
    let (head, body) = rest.split_once("\n---\n").unwrap();
    for key in ["title:", "tags:", "authors:", "affiliations:", "date:", "bibliography: paper.bib"] {
        assert!(head.lines().any(|line| line.starts_with(key)), "{key}");
    }
    let sections: Vec<&str> = body.lines().filter_map(|line| line.strip_prefix("# ")).collect();
    assert_eq!(sections, SECTIONS);
    let words = body.split_whitespace().count();
    assert!((750..=1750).contains(&words), "{words} words");
}

#[test]
fn every_citation_has_an_entry_and_every_entry_is_cited() {
    let (paper, bibliography) = (read("paper.md"), read("paper.bib"));
    let is_key = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let cited = paper.split('@').skip(1).map(|rest| rest.split(|c| !is_key(c)).next().unwrap_or_default());
    let mut cited: Vec<&str> = cited.collect();
    let entries = bibliography.split("@article{").skip(1);
    let mut entries: Vec<&str> = entries.map(|rest| rest.split(',').next().unwrap_or_default()).collect();
    cited.sort_unstable();
    cited.dedup();
    entries.sort_unstable();
    assert_eq!(cited, entries);
}

#[test]
fn the_numbers_are_those_of_the_repository() {
    let (paper, measured) = (read("paper.md"), read("crates/bench/results/peers.md"));
    let rows: Vec<&str> = paper.lines().filter(|line| line.starts_with("| ")).collect();
    assert!(rows.len() > 10);
    for row in rows {
        assert!(measured.lines().any(|line| line == row), "not measured: {row}");
    }
}
