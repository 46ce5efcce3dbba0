//! `slipmode verify DIR --claim ID`: one claim decided again, with nothing computed that it does not need.

use std::slice;

use slipmode::claims::{Entry, Evidence, Ledger, Part, Verdict, verdict_words};
use slipmode::report::{Folder, decide};
use slipmode::scene::{ClaimEntry, first_lines, library_ids, nearest};

use crate::cli::failure::Failure;
use crate::cli::progress::Progress;
use crate::cli::terminal;

/// Decides one claim of a report, prints how, and holds the verdict against the recorded one.
///
/// # Errors
/// When the report does not list the claim, or its verdict is not the recorded one.
pub fn verify_claim(folder: &Folder, id: &str, progress: &Progress) -> Result<(), Failure> {
    let text = slice::from_ref(listed("report", &folder.claims, id)?);
    let (ledger, _) = progress.items(|progress| decide(folder, text, progress));
    print_warnings(&ledger);
    terminal::print(&ledger.claims.iter().map(account).collect::<String>())?;
    Failure::check_none(problems(&ledger))
}

/// The errors of the program, and the claims whose verdict is not the recorded one.
pub fn problems(ledger: &Ledger) -> Vec<String> {
    contradictions(ledger).into_iter().chain(drift(ledger)).collect()
}

/// The claims whose verdict is not the recorded one, with both, and those whose theorems are about something else.
fn drift(ledger: &Ledger) -> Vec<String> {
    let verdict = |entry: &Entry| {
        let [recorded, now] = [entry.expected, entry.finding.verdict].map(Verdict::as_str);
        format!("{}: recorded {recorded}, now {now}", entry.id)
    };
    let untied = ledger.claims.iter().filter_map(|entry| entry.untied.clone());
    ledger.drift().map(verdict).chain(untied).collect()
}

/// The errors of the program that its last gate found: two of its evaluations of one claim contradict each other.
fn contradictions(ledger: &Ledger) -> Vec<String> {
    let line = |(id, contradiction)| {
        format!(
            "error of slipmode: {id}: {contradiction} The claim has no verdict. Please report this with claims.toml and equations.toml."
        )
    };
    ledger.contradictions().map(line).collect()
}

/// Refuses a ledger with an error of the program.
///
/// # Errors
/// When the last gate found one.
pub fn refuse_contradictions(ledger: &Ledger) -> Result<(), Failure> {
    let found = contradictions(ledger);
    if found.is_empty() { Ok(()) } else { Err(Failure::Check(found.join("\n"))) }
}

/// Prints the warnings about the formulas of claims on standard error.
pub fn print_warnings(ledger: &Ledger) {
    let of = |entry: &Entry| {
        entry.warnings().map(|warning| format!("warning: {}: {warning}", entry.id)).collect::<Vec<_>>()
    };
    warn(ledger.claims.iter().flat_map(of));
}

/// Warns of verdicts that are not the recorded ones.
pub fn warn_of_drift(ledger: &Ledger) {
    let lines = drift(ledger).into_iter();
    warn(lines.map(|line| format!("warning: {line}; `verify` and `replay` exit with 1")));
}

fn warn(lines: impl Iterator<Item = String>) {
    let lines = first_lines(lines, |more| format!("warning: and {more} more like these"));
    lines.iter().for_each(|line| terminal::message(line));
}

/// The claim of a report or file with this id.
///
/// # Errors
/// When there is none.
pub fn listed<'c>(list: &str, claims: &'c [ClaimEntry], id: &str) -> Result<&'c ClaimEntry, Failure> {
    claims.iter().find(|claim| claim.id == id).ok_or_else(|| {
        let near = match nearest(id, claims.iter().map(|claim| claim.id.as_str())) {
            _ if list == "report" && library_ids().any(|known| known == id) => {
                "; it is a claim of the paper that claims.toml leaves out".into()
            }
            near => near.map(|near| format!("; did you mean {near}?")).unwrap_or_default(),
        };
        Failure::Refused(format!("--claim = {id}: the {list} lists no such claim{near}"))
    })
}

/// How a claim was decided, with the steps of its proofs.
pub fn account(entry: &Entry) -> String {
    let finding = &entry.finding;
    let mut lines = vec![
        ("claim", format!("{} ({}): {}", entry.id, entry.place, entry.words)),
        ("holds if", entry.criterion.to_string()),
        ("verdict", verdict_words(finding.verdict, finding.strength)),
    ];
    lines.extend(finding.limit.iter().map(|limit| ("limit", limit.clone())));
    lines.extend(finding.counter_example.iter().map(|example| ("counter-example", example.clone())));
    for (number, reading) in (1..).zip(&finding.readings) {
        let verdict = verdict_words(reading.verdict, reading.strength);
        lines.push(("reading", format!("{number}. {}: {verdict}", reading.words)));
        lines.extend(reading.parts.iter().map(|part| ("  part", part_line(part))));
    }
    lines.extend(finding.evidence.iter().map(|evidence| ("evidence", evidence_lines(evidence))));
    lines.extend(finding.remarks.iter().map(|remark| ("remark", remark.clone())));
    lines.push(("not established", entry.not_established.to_string()));
    lines.iter().map(|(name, value)| format!("{name:<16} {value}\n")).collect()
}

fn part_line(part: &Part) -> String {
    let verdict = verdict_words(part.verdict, part.strength);
    let separator = if part.result().is_empty() { "" } else { ": " };
    format!("{}: {verdict}{separator}{}", part.words, part.result())
}

fn evidence_lines(evidence: &Evidence) -> String {
    match evidence {
        Evidence::Proof { proof } => format!("proof, checked again: {}", proof.to_string().trim_end()),
        Evidence::Enclosure { quantity, value, .. } | Evidence::Sample { quantity, value, .. } => {
            format!("{quantity}: {value}")
        }
        Evidence::Simulation { quantity, value, error, runs } => {
            format!("{quantity}: {value} ({runs} runs; error {error})")
        }
    }
}
