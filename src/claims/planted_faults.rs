//! Wrong equations planted on purpose, and the claims that notice: how much a verdict of this ledger is worth.

use std::collections::BTreeSet;

use rayon::prelude::*;

use super::alterations::{Alteration, alterations};
use crate::claims::{Check, Evidence, Finding, Verdict, checks};
use crate::experiments::Context;
use slipmode_core::theory::Equation;

/// What became of the wrong versions of one equation.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PlantedFaults {
    /// The equation's number.
    pub equation: String,
    /// How many wrong versions were planted.
    pub planted: usize,
    /// How many of them changed the verdict on a claim or on a part of it, or were refused when they were read.
    pub noticed: usize,
    /// How many versions say the same in other words, and are no faults.
    pub harmless: usize,
    /// The claims that noticed first, in the order of the ledger.
    pub noticed_by: Vec<&'static str>,
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

/// Plants faults in every numbered equation, one at a time, and decides the claims of linear theory again each time.
///
/// Claims about simulations stay out: what they rest on was computed without the paper's equations. So do our own, which are not the
/// paper's.
#[must_use]
pub fn plant_faults(context: &Context) -> Vec<PlantedFaults> {
    let theory: Vec<&'static Check> = checks().filter(|check| !check.id.starts_with(['N', 'X'])).collect();
    let sound: Vec<Sound> = theory.into_par_iter().map(|check| Sound::of(check, context)).collect();
    let numbered: Vec<&Equation> =
        context.equations.iter().filter(|equation| equation.number.parse::<u32>().is_ok()).collect();
    numbered.into_par_iter().map(|equation| plant(equation, context, sound.clone())).collect()
}

/// A claim as the paper's own equations decide it.
#[derive(Clone)]
struct Sound {
    check: &'static Check,
    verdicts: Vec<Verdict>,
    /// The equations that its proofs name.
    equations: BTreeSet<String>,
}

impl Sound {
    fn of(check: &'static Check, context: &Context) -> Self {
        let finding = (check.decide)(context);
        let verdicts = verdicts(&finding);
        let steps = finding.evidence.into_iter().flat_map(|evidence| match evidence {
            Evidence::Proof { proof, .. } => proof.steps,
            _ => Vec::new(),
        });
        Self { check, verdicts, equations: steps.flat_map(|step| step.equations).collect() }
    }

    fn notices(&self, altered: &Context) -> bool {
        verdicts(&(self.check.decide)(altered)) != self.verdicts
    }
}

/// The verdict on a claim and those on its parts.
fn verdicts(finding: &Finding) -> Vec<Verdict> {
    let parts = finding.readings.iter().flat_map(|reading| &reading.parts).map(|part| part.verdict);
    std::iter::once(finding.verdict).chain(parts).collect()
}

fn plant(equation: &Equation, context: &Context, mut sound: Vec<Sound>) -> PlantedFaults {
    // The claims whose proofs name the equation come first: one of them notices.
    sound.sort_by_key(|sound| !sound.equations.contains(&equation.number));
    let mut found = PlantedFaults { equation: equation.number.clone(), ..PlantedFaults::default() };
    for Alteration { kind, text, says_the_same } in alterations(equation) {
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
        let altered = Context::new(&equations, context.outcome);
        match sound.iter().position(|sound| sound.notices(&altered)) {
            Some(at) => {
                found.noticed += 1;
                // A claim that noticed one fault of an equation is tried on the next one first.
                sound[..=at].rotate_right(1);
                found.noticed_by.push(sound[0].check.id);
            }
            None => found.survivors.push(Survivor { kind, text }),
        }
    }
    found.noticed_by = checks().map(|check| check.id).filter(|id| found.noticed_by.contains(id)).collect();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::Outcome;
    use crate::scene::read_equations;

    #[test]
    fn wrong_equations_are_noticed_by_the_claims_that_rest_on_them() {
        let text = include_str!("../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", text.as_bytes()).unwrap();
        let nothing = Outcome::default();
        let context = Context::new(&equations, &nothing);
        let found = plant_faults(&context);
        assert_eq!(found.len(), 23);
        for one in &found {
            assert!(one.noticed > 0, "{one:#?}");
            assert_eq!(one.planted, one.noticed + one.survivors.len());
        }
        let sum = |count: fn(&PlantedFaults) -> usize| found.iter().map(count).sum::<usize>();
        assert_eq!((sum(|one| one.planted), sum(|one| one.noticed)), (209, 209));
        let of = |number: &str| found.iter().find(|one| one.equation == number).unwrap();
        assert!(of("9").noticed_by.contains(&"S1") && of("16").noticed_by.contains(&"B2"), "{found:#?}");
        // Eqs 15, 16 and 18 are symmetric in a and b, and the ± of eq 23 has no first sign; eq 13 has no such freedom.
        let harmless: Vec<(&str, usize)> = found
            .iter()
            .filter(|one| one.harmless > 0)
            .map(|one| (one.equation.as_str(), one.harmless))
            .collect();
        assert_eq!(harmless, [("15", 1), ("16", 1), ("18", 1), ("23", 1)]);
    }

    #[test]
    fn every_claim_that_the_equations_decide_notices_a_fault_of_its_own() {
        let text = include_str!("../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", text.as_bytes()).unwrap();
        let nothing = Outcome::default();
        let context = Context::new(&equations, &nothing);
        let altered: Vec<_> = equations
            .iter()
            .flat_map(|one| alterations(one).into_iter().map(|change| (one.number.as_str(), change)))
            .filter(|(_, change)| !change.says_the_same)
            .filter_map(|(number, change)| Some((number, equations.altered(number, &change.text).ok()?)))
            .collect();
        let decided: Vec<Sound> = checks()
            .map(|check| Sound::of(check, &context))
            .filter(|sound| sound.verdicts[0] != Verdict::NotChecked)
            .collect();
        assert!(decided.len() > 30, "{}", decided.len());
        let blind = decided.into_par_iter().filter(|sound| {
            let is_named = |(number, _): &&(&str, _)| sound.equations.contains(*number);
            let (likely, other): (Vec<_>, Vec<_>) = altered.iter().partition(is_named);
            let unseen = |(_, altered): &&_| !sound.notices(&Context::new(altered, &nothing));
            likely.iter().all(unseen) && other.iter().all(unseen)
        });
        assert_eq!(blind.map(|sound| sound.check.id).collect::<Vec<_>>(), Vec::<&str>::new());
    }
}
