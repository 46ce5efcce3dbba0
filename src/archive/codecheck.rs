//! `codecheck.yml` and `LICENSE`: what an author prepares for a CODECHECK certificate.
//!
//! The file follows the author's part of the CODECHECK configuration file specification, version 1.0. What nobody has stated is marked.

use std::fmt::Write;

use crate::scene::{Author, Paper};

use super::{Files, Parts, REPORT_FOLDER, below};

/// The file with manifest, title and authors.
pub const CODECHECK_FILE: &str = "codecheck.yml";
/// The file with the licences of all files.
pub(super) const LICENCE_FILE: &str = "LICENSE";
pub(super) const LICENCES: &str = "\
All files of this archive are licensed under MIT (LICENSE-MIT) or Apache-2.0 (LICENSE-APACHE), at your option.
NOTICE.md names the licences of the libraries that a binary of slipmode contains.
";

const SPECIFICATION: &str = "https://codecheck.org.uk/spec/config/1.0/";
/// Precedes what a person has to fill in.
const OPEN: &str = "OPEN FIELD: ";

/// What the paper's section of `report.toml` leaves open, each as a key and what belongs there.
#[must_use]
pub fn open_fields(paper: &Paper) -> Vec<String> {
    let mut open = Vec::new();
    if paper.reference.is_none() {
        open.push("paper.reference: the address or identifier of the paper".to_string());
    }
    if paper.authors.is_empty() {
        open.push("paper.author[1].name: the corresponding author".to_string());
    }
    let authors = (1..).zip(&paper.authors).filter(|(_, author)| author.orcid.is_none());
    open.extend(authors.map(|(number, author)| format!("paper.author[{number}].orcid: of {}", author.name)));
    open
}

/// The text of the file; the manifest has every file of the report.
pub(super) fn codecheck(parts: &Parts<'_>, paper: &Paper, files: &Files) -> String {
    let mut text = format!("%YAML 1.1\n---\nversion: {SPECIFICATION}\n\nmanifest:\n");
    for (path, made, _) in below(files, REPORT_FOLDER) {
        item(&mut text, "file", path);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "    comment: {}", quoted(&comment(made)));
    }
    let title = paper.title.as_deref().unwrap_or(parts.title);
    let _ = write!(text, "\npaper:\n  title: {}\n  authors:\n", quoted(title));
    let unknown = [Author { name: format!("{OPEN}the corresponding author"), orcid: None }];
    let authors = if paper.authors.is_empty() { &unknown[..] } else { &paper.authors };
    for Author { name, orcid } in authors {
        item(&mut text, "name", name);
        let _ = match orcid {
            Some(orcid) => writeln!(text, "    ORCID: {orcid}"),
            None => writeln!(text, "    # {OPEN}ORCID"),
        };
    }
    let _ = match &paper.reference {
        Some(reference) => writeln!(text, "  reference: {}", quoted(reference)),
        None => writeln!(text, "  # {OPEN}reference"),
    };
    text
}

fn item(text: &mut String, key: &str, value: &str) {
    let _ = writeln!(text, "  - {key}: {}", quoted(value));
}

/// What a file of the report is.
fn comment(path: &str) -> String {
    let name = path.rsplit('/').next().unwrap_or(path);
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    match path.split_once('/') {
        Some(("tables", _)) => format!("table {stem}"),
        Some(("figures", _)) => format!("figure {stem}"),
        Some((folder, _)) => format!("{folder}: {stem}"),
        None => match path {
            "index.html" => "the report as one page".into(),
            "report.md" => "the reader's edition: answer, verdicts, figures".into(),
            "ledger.md" => "the whole report in Markdown".into(),
            "ledger.json" => "every claim with its verdict and evidence".into(),
            _ => stem.into(),
        },
    }
}

/// A text as YAML between double quotes, whose escapes include those of JSON.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
