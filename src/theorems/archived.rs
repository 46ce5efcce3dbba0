//! The theorems of one report as an archive holds them: Coq checks them with the library, and without this program.

use std::collections::{BTreeMap, BTreeSet};

use super::{Published, STEPS_FILE, files};
use crate::claims::{ACCEPTED, LIBRARY, sha256_hex};

/// What checks the folder. It is the same in every archive.
const CHECK: &str = include_str!("../../proofs/check.sh");

/// What the folder is, and what a reader can trust.
const README: &str = include_str!("../../proofs/archive.md");

/// The library, the theorems of the report, what was accepted, what has no theorem, and how all of it is checked, by path.
///
/// # Errors
/// When the ledger cannot be read.
pub fn archived(report: &Published) -> Result<BTreeMap<String, String>, String> {
    let mut archived = of_report(report)?;
    let mut left_out = without_theorem(&archived.remove(STEPS_FILE).unwrap_or_default());
    // A published report has files that Coq did not accept: they are no theorems.
    let accepted: BTreeSet<&str> = ACCEPTED.lines().filter_map(|line| line.split(' ').next()).collect();
    if accepted.iter().any(|path| path.starts_with(&format!("{}/", report.name))) {
        let refused = archived.extract_if(.., |path, _| !accepted.contains(path.as_str()));
        left_out.extend(refused.map(|(path, _)| format!("{path}: Coq did not accept it\n")));
    }
    archived.extend(library());
    let digests = archived.iter().map(|(path, text)| format!("{}  {path}\n", sha256_hex(text)));
    let digests: String = digests.collect();
    let others = [
        ("files.txt", digests.as_str()),
        ("accepted.txt", ACCEPTED),
        ("check.sh", CHECK),
        ("left-out.txt", left_out.as_str()),
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
    let of_reports = of_reports.into_iter().flatten().filter(|(path, _)| path != STEPS_FILE);
    Ok(library().chain(of_reports).map(line).collect())
}

/// A line for each step and formula of the list of steps that has no theorem, with the reason.
fn without_theorem(steps: &str) -> String {
    let lines = steps.lines().skip(1).filter_map(|line| match line.split('\t').collect::<Vec<_>>()[..] {
        [_, claim, proof, step, .., obstacle] if !obstacle.is_empty() => {
            let place = [claim, proof, step].into_iter().filter(|word| !word.is_empty());
            Some(format!("{}: {obstacle}\n", place.collect::<Vec<_>>().join(", ")))
        }
        _ => None,
    });
    lines.collect()
}

/// The theorems of a report in the files of its archive, and the list of its steps.
fn of_report(report: &Published) -> Result<BTreeMap<String, String>, String> {
    let mut made = files(std::slice::from_ref(report), ("", Vec::new()))?;
    made.retain(|path, _| path == STEPS_FILE || !path.ends_with("_faults.v"));
    Ok(made)
}

fn library() -> impl Iterator<Item = (String, String)> {
    LIBRARY.iter().map(|(name, text)| (format!("library/{name}.v"), (*text).to_owned()))
}
