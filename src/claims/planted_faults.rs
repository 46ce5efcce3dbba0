//! Wrong equations planted on purpose, and the claims that notice: how much a verdict of this ledger is worth.

use std::collections::BTreeSet;

use crate::parallel;

use super::alterations::{Alteration, alike, alterations};
use crate::claims::{Evidence, Finding, Verdict, computed, formula, resolved_formula, sha256_hex};
use crate::experiments::Context;
use crate::scene::{ClaimEntry, ClaimFormula, Source};
use slipmode_algebra::Symbol;
use slipmode_theory::Equation;

/// What became of the wrong versions of one equation.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PlantedFaults {
    /// The equation's number or name.
    pub equation: String,
    /// How many wrong versions were planted.
    pub planted: usize,
    /// How many of them changed the verdict on a claim or on a part of it, or were refused when they were read.
    pub noticed: usize,
    /// How many versions say the same in other words, and are no faults.
    pub harmless: usize,
    /// The claims that noticed first, in the order of the report.
    pub noticed_by: Vec<String>,
    /// The wrong versions that no claim noticed.
    pub survivors: Vec<Survivor>,
}

/// A wrong equation that no claim noticed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Survivor {
    /// What was done to the equation.
    pub kind: &'static str,
    /// The wrong equation.
    pub text: String,
}

/// Plants faults in every equation of a report, one at a time, and decides the report's claims about the equations again each time.
///
/// Claims about simulations stay out: what they rest on was computed without the equations. So do the program's own, which are not the
/// paper's.
#[must_use]
pub fn plant_faults(context: &Context) -> Vec<PlantedFaults> {
    let sound = sound_claims(context);
    let pairs = alike(context.equations);
    let all: Vec<&Equation> = context.equations.iter().collect();
    parallel::map(&all, |equation| plant(equation, &pairs, context, sound.clone()))
}

/// The claims about the equations, decided.
fn sound_claims<'c>(context: &Context<'c>) -> Vec<Sound<'c>> {
    let claims = context.claims.iter().filter(|claim| claim.sentence.source != Source::Result);
    let sound: Vec<Sound> = claims.flat_map(Sound::parts_of).collect();
    parallel::map(&sound, |sound| sound.clone().decided(context))
}

/// A part of a claim as the report's own equations decide it.
#[derive(Clone)]
struct Sound<'c> {
    claim: &'c ClaimEntry,
    /// The id of its proof and its words, as in the ledger: what decided the claim there is known.
    id: String,
    words: &'c str,
    part: &'c ClaimFormula,
    verdicts: Vec<Verdict>,
    /// The equations that its proofs name.
    equations: BTreeSet<String>,
    /// Its digest: an alteration that leaves the claim as resolved as it is cannot change the verdict.
    digest: String,
    /// How long its proofs are: the short ones are tried first.
    steps: usize,
}

impl<'c> Sound<'c> {
    fn parts_of(claim: &'c ClaimEntry) -> Vec<Self> {
        let of = |(id, (words, part)): (String, &'c (String, ClaimFormula))| Self {
            claim,
            id,
            words,
            part,
            verdicts: Vec::new(),
            equations: BTreeSet::new(),
            digest: String::new(),
            steps: 0,
        };
        let parts = claim.stated.iter().flat_map(|stated| formula::parts(&claim.id, stated));
        let is_of_equations = |(_, (_, part)): &(String, &(String, ClaimFormula))| {
            part.rows.is_none() && !part.computed().is_some_and(computed::is_of_runs)
        };
        parts.filter(is_of_equations).map(of).collect()
    }

    fn finding(&self, context: &Context) -> Finding {
        let context = context.with_kind(self.claim.sentence.kind);
        formula::decide_part(&self.id, self.words, self.part, &context)
    }

    fn decided(mut self, context: &Context) -> Self {
        let finding = self.finding(context);
        self.verdicts = verdicts(&finding);
        let proofs = finding.evidence.iter().filter_map(Evidence::proof);
        let steps: Vec<_> = proofs.flat_map(|proof| &proof.steps).collect();
        self.steps = steps.len();
        self.equations = steps.iter().flat_map(|step| step.equations.iter().cloned()).collect();
        self.digest = self.digest_in(context);
        self
    }

    fn digest_in(&self, context: &Context) -> String {
        sha256_hex(&resolved_formula(self.part, context.equations))
    }

    fn notices(&self, altered: &Context) -> bool {
        self.digest_in(altered) != self.digest && verdicts(&self.finding(altered)) != self.verdicts
    }
}

/// The verdict on a claim and those on its parts.
fn verdicts(finding: &Finding) -> Vec<Verdict> {
    let parts = finding.readings.iter().flat_map(|reading| &reading.parts).map(|part| part.verdict);
    std::iter::once(finding.verdict).chain(parts).collect()
}

fn plant(
    equation: &Equation,
    pairs: &[[Symbol; 2]],
    context: &Context,
    mut sound: Vec<Sound>,
) -> PlantedFaults {
    // The claims whose proofs name the equation come first, those with short proofs before others: one of them notices.
    sound.sort_by_key(|sound| (!sound.equations.contains(&equation.number), sound.steps));
    let mut found = PlantedFaults { equation: equation.number.clone(), ..PlantedFaults::default() };
    let mut first = BTreeSet::new();
    for Alteration { kind, text, says_the_same } in alterations(equation, pairs) {
        if says_the_same {
            found.harmless += 1;
            continue;
        }
        found.planted += 1;
        let Ok(equations) = context.equations.altered(&equation.number, &text) else {
            // A version without a value, such as the root of a negative number, is refused before a claim is decided.
            found.noticed += 1;
            continue;
        };
        let altered = Context::new(&equations, context.outcome).ungated();
        match sound.iter().position(|sound| sound.notices(&altered)) {
            Some(at) => {
                found.noticed += 1;
                // A claim that noticed one fault of an equation is tried on the next one first.
                sound[..=at].rotate_right(1);
                first.insert(sound[0].claim.id.as_str());
            }
            None => found.survivors.push(Survivor { kind, text }),
        }
    }
    let ids = context.claims.iter().map(|claim| claim.id.as_str());
    found.noticed_by = ids.filter(|id| first.contains(id)).map(str::to_owned).collect();
    found
}

#[cfg(test)]
mod tests;
