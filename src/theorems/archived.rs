//! The theorems of one report as an archive holds them: Coq checks them with the library, and without this program.

use std::collections::BTreeMap;

use super::{Published, files};
use crate::claims::{ACCEPTED, LIBRARY, sha256_hex};

/// What checks the folder. It is the same in every archive.
const CHECK: &str = include_str!("../../proofs/check.sh");

/// What the folder is, and what a reader can trust.
const README: &str = include_str!("../../proofs/archive.md");

/// The library, the theorems of the report, what was accepted, and how all of it is checked, by path.
///
/// # Errors
/// When the ledger cannot be read.
pub fn archived(report: &Published) -> Result<BTreeMap<String, String>, String> {
    let mut archived = of_report(report)?;
    archived.extend(library());
    let digests = archived.iter().map(|(path, text)| format!("{}  {path}\n", sha256_hex(text)));
    let digests: String = digests.collect();
    let others = [
        ("files.txt", digests.as_str()),
        ("accepted.txt", ACCEPTED),
        ("check.sh", CHECK),
        ("README.md", README),
    ];
    archived.extend(others.map(|(path, text)| (path.to_owned(), text.to_owned())));
    Ok(archived)
}

/// A line for each file of the archives of these reports: its path, its SHA-256, and the names of the theorems that it states.
///
/// # Errors
/// When a ledger cannot be read.
pub fn file_list(reports: &[Published]) -> Result<String, String> {
    let line = |(path, text): (String, String)| {
        let names = text.lines().filter_map(|line| line.strip_prefix("Theorem ")?.split([' ', ':']).next());
        let names: Vec<&str> = if path.starts_with("library/") { Vec::new() } else { names.collect() };
        format!("{path}\t{}\t{}\n", sha256_hex(&text), names.join(" "))
    };
    let of_reports = reports.iter().map(of_report).collect::<Result<Vec<_>, _>>()?;
    Ok(library().chain(of_reports.into_iter().flatten()).map(line).collect())
}

/// The theorems of a report in the files of its archive.
fn of_report(report: &Published) -> Result<BTreeMap<String, String>, String> {
    let mut made = files(std::slice::from_ref(report), ("", Vec::new()))?;
    made.retain(|path, _| path.ends_with(".v") && !path.ends_with("_faults.v"));
    Ok(made)
}

fn library() -> impl Iterator<Item = (String, String)> {
    LIBRARY.iter().map(|(name, text)| (format!("library/{name}.v"), (*text).to_owned()))
}
