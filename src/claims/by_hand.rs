//! Claims that theorems written by hand state whole. A row of `proofs/claims.csv` ties a claim to its theorems. It has the digest of
//! the claim as resolved, and a digest of that, of what was found, and of the theorems' statements with their definitions. A change of
//! one of them ends the tie.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use slipmode_theory::Equations;

use super::{Finding, Part, Reading, Verdict, sha256_hex};

/// The modules of the hand-written library with their texts, in the order of their names.
pub const LIBRARY: &[(&str, &str)] = &include!(concat!(env!("OUT_DIR"), "/library.rs"));

/// What Coq has accepted, one line each: a theorem's name, and the digest of what it states.
pub const ACCEPTED: &str = include_str!("../../proofs/accepted.txt");

/// A claim with the theorems that state it together.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tie {
    /// The report for which the theorems were written. A claim of another report with the same digests is tied too.
    pub report: String,
    /// The claim's id.
    pub claim: String,
    /// The digest of the claim as resolved.
    pub claim_digest: String,
    /// The digest of the claim as resolved, of what was found, and of the theorems.
    pub digest: String,
    /// The theorems as `Module.name`, with a space between two of them.
    pub theorems: String,
    /// What they say, in words.
    pub says: String,
}

/// A claim of a ledger as a tie sees it.
#[derive(Debug, Clone)]
pub struct Tied<'e> {
    /// The claim's id.
    pub claim: &'e str,
    /// The digest of the claim as resolved.
    pub digest: &'e str,
    /// What was found.
    pub conclusion: Conclusion,
}

/// What was found on a claim, without the evidence: the theorems have to state it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Conclusion {
    verdict: Verdict,
    limit: Option<String>,
    counter_example: Option<String>,
    #[serde(default)]
    readings: Vec<ConcludedReading>,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct ConcludedReading {
    words: String,
    verdict: Verdict,
    parts: Vec<ConcludedPart>,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct ConcludedPart {
    words: String,
    verdict: Verdict,
}

impl From<&Finding> for Conclusion {
    fn from(finding: &Finding) -> Self {
        let part = |part: &Part| ConcludedPart { words: part.words.clone(), verdict: part.verdict };
        let reading = |reading: &Reading| ConcludedReading {
            words: reading.words.clone(),
            verdict: reading.verdict,
            parts: reading.parts.iter().map(part).collect(),
        };
        Self {
            verdict: finding.verdict,
            limit: finding.limit.clone(),
            counter_example: finding.counter_example.clone(),
            readings: finding.readings.iter().map(reading).collect(),
        }
    }
}

/// The rows of `proofs/claims.csv`.
pub static TIES: LazyLock<Vec<Tie>> = LazyLock::new(|| rows(include_str!("../../proofs/claims.csv")));

/// The definitions that state an equation, with its number and its side.
static STATED: LazyLock<Vec<[String; 6]>> =
    LazyLock::new(|| rows(include_str!("../../proofs/equations.csv")));

/// The rows of a table; a test reads them all.
fn rows<T: for<'de> Deserialize<'de>>(text: &str) -> Vec<T> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().filter_map(Result::ok).collect()
}

impl Tie {
    /// The names of the theorems.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.theorems.split_whitespace()
    }

    /// The digest of a claim with its result and these theorems; none when a theorem or an equation is missing.
    pub(crate) fn digest_of(&self, tied: &Tied<'_>, equations: &Equations) -> Option<String> {
        let mut all = vec![tied.digest.to_owned(), serde_json::to_string(&tied.conclusion).ok()?];
        for name in self.names() {
            let (module, _) = name.split_once('.')?;
            all.push(statement(name)?.to_owned());
            all.extend(definitions(module).into_iter().map(str::to_owned));
            let is_own = |[file, _, report, ..]: &&[String; 6]| file == module && *report == self.report;
            for [file, _, _, number, side, _] in STATED.iter().filter(is_own) {
                let equation = equations.iter().find(|equation| equation.number == *number)?;
                let text = if side == "left" { &equation.left } else { &equation.right };
                all.push(format!("{file} {number} {side}: {text}"));
            }
        }
        serde_json::to_string(&all).ok().map(|json| sha256_hex(&json))
    }

    /// Whether its theorems are about this claim with this result.
    pub(crate) fn is_about(&self, tied: &Tied<'_>, equations: &Equations) -> bool {
        self.claim == tied.claim
            && self.claim_digest == tied.digest
            && self.digest_of(tied, equations).is_some_and(|digest| digest == self.digest)
    }
}

/// The tie of a claim, if Coq has accepted its theorems.
pub(super) fn accepted_tie(tied: &Tied<'_>, equations: &Equations) -> Option<&'static Tie> {
    static LINES: LazyLock<BTreeSet<&str>> = LazyLock::new(|| ACCEPTED.lines().collect());
    tie_in(&TIES, &LINES, tied, equations)
}

/// The same among these ties, with this list of accepted theorems.
fn tie_in<'t>(
    ties: &'t [Tie],
    lines: &BTreeSet<&str>,
    tied: &Tied<'_>,
    equations: &Equations,
) -> Option<&'t Tie> {
    let is_accepted =
        |tie: &Tie| tie.names().all(|name| lines.contains(format!("{name} {}", tie.digest).as_str()));
    ties.iter().find(|tie| is_accepted(tie) && tie.is_about(tied, equations))
}

/// Why the theorems that are tied to this claim of a report are about another one; none where they are about it, or there are none.
pub(super) fn untied(report: &str, tied: &Tied<'_>, equations: &Equations) -> Option<String> {
    untied_in(&TIES, report, tied, equations)
}

fn untied_in(ties: &[Tie], report: &str, tied: &Tied<'_>, equations: &Equations) -> Option<String> {
    let own = |tie: &&Tie| tie.report == report && tie.claim == tied.claim;
    if ties.iter().any(|tie| tie.is_about(tied, equations)) {
        return None;
    }
    let same_claim = ties.iter().filter(own).find(|tie| tie.claim_digest == tied.digest);
    let tie = same_claim.or_else(|| ties.iter().find(own))?;
    let (id, theorems) = (tied.claim, &tie.theorems);
    let why = match same_claim {
        None => "the theorem is about other equations, definitions or words",
        Some(_) => "the theorem is about another result, or its statement is another one",
    };
    Some(format!("{id}: {why} than when proofs/claims.csv tied {theorems} to the claim"))
}

/// The statement of a theorem given as `Module.name`.
#[must_use]
pub fn statement(name: &str) -> Option<&'static str> {
    let (module, name) = name.split_once('.')?;
    let of_theorem = |sentence: &&str| {
        let rest = sentence.strip_prefix("Theorem ").and_then(|rest| rest.strip_prefix(name));
        rest.is_some_and(|rest| rest.starts_with([' ', '\n']))
    };
    sentences(text(module)?).into_iter().find(of_theorem)
}

/// The variables, hypotheses and definitions of a module, and the definitions of those that it imports.
#[must_use]
pub fn definitions(module: &str) -> Vec<&'static str> {
    let mut waiting = vec![module];
    let (mut seen, mut found) = (BTreeSet::new(), Vec::new());
    while let Some(next) = waiting.pop() {
        let Some(text) = text(next).filter(|_| seen.insert(next)) else { continue };
        let words: &[&str] =
            if next == module { &["Variable", "Hypothes", "Let ", "Definition "] } else { &["Definition "] };
        let is_one = |sentence: &&str| {
            words.iter().any(|word| sentence.starts_with(word))
                && (!sentence.starts_with("Let ") || sentence.contains(":="))
        };
        found.extend(sentences(text).into_iter().filter(is_one));
        let imports = text.lines().filter_map(|line| line.strip_prefix("From Slipmode Require Export "));
        waiting.extend(imports.flat_map(|line| line.trim_end_matches('.').split_whitespace()));
    }
    found
}

/// The text of a module.
fn text(module: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(name, _)| *name == module).map(|(_, text)| *text)
}

/// What begins at the beginning of a line with a capital letter and ends with a full stop at the end of one.
fn sentences(text: &str) -> Vec<&str> {
    let starts = text.match_indices('\n').map(|(at, _)| at + 1);
    let starts = starts.filter(|at| text[*at..].starts_with(|c: char| c.is_ascii_uppercase()));
    starts.filter_map(|at| Some(&text[at..at + text[at..].find(".\n")? + 1])).collect()
}

#[cfg(test)]
mod tests;
