//! The claims of a new report: those of the paper that speak of sliders like this one, each with its computed verdict.

use std::collections::BTreeSet;

use slipmode::claims::{Entry, Verdict, procedures};
use slipmode::report::{self, Folder};
use slipmode::scene::{ClaimEntry, Faults, Sliders, read_claims, read_equations};

use crate::cli::claim::refuse_contradictions;
use crate::cli::failure::Failure;
use crate::cli::folder::EQUATIONS;
use crate::cli::progress::Progress;

/// The claims of the paper's own report, for their words.
const PAPER: &str = include_str!("../../../reports/im-avouac/claims.toml");

/// What was found.
#[derive(Debug)]
pub struct Decided {
    /// The claims, each with what was found.
    claims: Vec<(ClaimEntry, Entry)>,
    /// How many simulations have no result.
    pub gaps: usize,
}

/// The claims to decide, in the order of the paper's report.
///
/// # Errors
/// When the list of the paper's claims is at fault.
pub fn candidates(sliders: Sliders) -> Result<Vec<ClaimEntry>, Faults> {
    let equations = read_equations("equations.toml", EQUATIONS.as_bytes())?;
    let mut entries = read_claims("claims.toml", PAPER.as_bytes(), &procedures(), Some(&equations))?;
    let listed = entries.iter().filter(|entry| entry.sliders.contains(&sliders));
    let kept = with_premises(listed.map(|entry| entry.id.clone()).collect(), &entries);
    entries.retain(|entry| kept.contains(entry.id.as_str()));
    Ok(entries)
}

/// These claims with all that they rest on: a claim whose premise is not checked would hold of changed equations too.
fn with_premises(ids: Vec<String>, entries: &[ClaimEntry]) -> BTreeSet<String> {
    let mut open = ids;
    let mut kept = BTreeSet::new();
    while let Some(id) = open.pop() {
        if kept.insert(id.clone()) {
            let presupposed = entries.iter().filter(|entry| entry.id == id).flat_map(|entry| &entry.rests_on);
            open.extend(presupposed.cloned());
        }
    }
    kept
}

/// A list whose verdicts stand for nothing yet.
pub fn undecided(entries: &[ClaimEntry]) -> String {
    entries.iter().map(|entry| section(entry, Verdict::NotChecked)).collect()
}

/// Computes what the claims of a folder need, and decides them.
///
/// # Errors
/// When a verdict does not pass the last gate.
pub fn decide(folder: &Folder, progress: Progress) -> Result<Decided, Failure> {
    let (ledger, outcome) = progress.items(|progress| report::decide(folder, &folder.claims, progress));
    refuse_contradictions(&ledger)?;
    let claims = folder.claims.iter().cloned().zip(ledger.claims).collect();
    let grids = outcome.scenes.iter().flat_map(|scene| &scene.simulations).flat_map(|runs| &runs.grids);
    let points = grids.flat_map(|(_, grid)| &grid.values);
    Ok(Decided { claims, gaps: points.filter(|point| point.simulation.is_err()).count() })
}

impl Decided {
    /// The text of `claims.toml`.
    pub fn text(&self, name: &str) -> String {
        let reason =
            |found: &Entry| format!("# Left out: {}. {}\n", found.id, found.finding.remarks.join(" "));
        let left_out: String = self.left_out().map(reason).collect();
        let listed = self.claims.iter().filter(|(_, found)| found.finding.verdict != Verdict::NotChecked);
        let sections: String = listed.map(|(entry, found)| section(entry, found.finding.verdict)).collect();
        format!(
            "# The paper's claims that apply to sliders like this one, each with the verdict that was computed when \
                this file was\n# written. `slipmode verify {name}` computes them again and exits with 1 if one \
                differs; `--claim ID` decides one.\n{left_out}{sections}"
        )
    }

    /// A chapter's prose without the lines that place a claim which the report does not list.
    pub fn without_those_left_out(&self, prose: &str) -> String {
        let without = |text: String, claim: &Entry| text.replace(&format!("\n[[claim:{}]]\n", claim.id), "");
        self.left_out().fold(prose.to_string(), without)
    }

    fn left_out(&self) -> impl Iterator<Item = &Entry> {
        let found = self.claims.iter().map(|(_, found)| found);
        found.filter(|found| found.finding.verdict == Verdict::NotChecked)
    }
}

fn section(entry: &ClaimEntry, verdict: Verdict) -> String {
    let ClaimEntry { id, place, words, .. } = entry;
    let expected = verdict.as_str();
    format!("\n[[claim]]\nid = {id:?}\nplace = {place:?}\nwords = {words:?}\nexpected = \"{expected}\"\n")
}
