//! Claims that a report states as formulas: decided by a certificate, by an exact counter-example, or not at all.

mod behaviour;
mod enclosed;
mod exists;
mod lowering;
mod motion;
mod points;
mod prover;
mod theorem;
mod truth;
mod warnings;

use slipmode_algebra::{Certificate, Expression, Literal, Proof, Symbol, within_budget};
use slipmode_theory::Equations;

use crate::claims::gate;
use crate::claims::over_rows;
use crate::claims::reading::{self, of_readings};
use crate::claims::{Evidence, Finding, Verdict, computed, resolved_formula, sha256_hex};
use crate::experiments::Context;
use crate::scene::{ClaimEntry, ClaimFormula, Names, Premises, StatedClaim, Statement, filled};
use lowering::Lowered;
use points::{Point, Points};
use prover::{Draft, Prover, certify_all};
pub use theorem::{WholeStatement, WholeTheorem, statement_digest};
pub(super) use warnings::warnings;

/// The finding on a claim: one formula decides it, or all parts of its first reading.
pub(super) fn decide(id: &str, stated: &StatedClaim, context: &Context) -> Finding {
    let found = decide_readings(id, stated, context);
    // A remark that names numbers which a statement over rows does not find is left out.
    let names_numbers = stated.parts().any(|(_, formula)| formula.rows.is_some());
    let plain = |text: &String| (!names_numbers).then(|| text.clone());
    let remark = |text: &String| filled(text, &found.numbers).ok().or_else(|| plain(text));
    let remarks: Vec<String> = stated.remarks.iter().filter_map(remark).collect();
    let found = remarks.into_iter().fold(found, Finding::remark);
    stated.argued.iter().fold(found, |found, step| found.argued(step))
}

fn decide_readings(id: &str, stated: &StatedClaim, context: &Context) -> Finding {
    let parts = parts(id, stated);
    if let [(id, (words, formula))] = &parts[..] {
        return decide_part(id, words, formula, context);
    }
    let one = stated.readings.len() == 1;
    let mut parts = parts.into_iter();
    of_readings(stated.readings.iter().map(|reading| {
        let words = if one { "all parts" } else { &reading.words };
        let of_reading = parts.by_ref().take(reading.parts.len());
        of_reading.fold(reading::Draft::new(words), |draft, (id, (words, formula))| {
            draft.part(words, decide_part(&id, words, formula, context))
        })
    }))
}

/// The parts of a claim, words and formula, with the ids of their proofs: the claim's id, then the number of the reading if there are
/// several, then that of the part.
pub(super) fn parts<'c>(id: &str, stated: &'c StatedClaim) -> Vec<(String, &'c (String, ClaimFormula))> {
    let claim = format!("formula-{}", id.to_lowercase());
    let (readings, all) = (&stated.readings, stated.parts().count());
    let mut found = Vec::new();
    for (reading, which) in readings.iter().zip(1..) {
        let reading_id = if readings.len() == 1 { claim.clone() } else { format!("{claim}-{which}") };
        for (part, number) in reading.parts.iter().zip(1..) {
            let id = if all == 1 { claim.clone() } else { format!("{reading_id}-{number}") };
            found.push((id, part));
        }
    }
    found
}

/// The parts of a claim with the ids of their proofs, what is true outside of a limit among them.
fn with_outsides<'c>(id: &str, stated: &'c StatedClaim) -> Vec<(String, &'c (String, ClaimFormula))> {
    let with_outside = |(id, part): (String, &'c (String, ClaimFormula))| {
        let outside = part.1.limit.as_ref().map(|limit| (format!("{id}-outside"), &limit.outside));
        std::iter::once((id, part)).chain(outside)
    };
    parts(id, stated).into_iter().flat_map(with_outside).collect()
}

/// The formulas of a claim as theorems, each with the id of its proof, or why it has none.
pub fn whole_theorems<'p>(
    claim: &ClaimEntry,
    equations: &Equations,
    proof: impl Fn(&str) -> Option<&'p Proof>,
) -> Vec<(String, Result<WholeTheorem, String>)> {
    let found = claim.stated.iter().flat_map(|stated| with_outsides(&claim.id, stated));
    let proved = found.filter_map(|(id, (_, formula))| Some((proof(&id)?, id, formula)));
    proved.map(|(proof, id, formula)| (id, theorem::whole_theorem(formula, equations, proof))).collect()
}

/// The formulas of a claim that are theorems which Coq has accepted, with their words.
#[must_use]
pub fn whole_statements<'c>(stated: &'c StatedClaim, equations: &Equations) -> Vec<WholeStatement<'c>> {
    let all = with_outsides("", stated).into_iter();
    all.filter_map(|(_, (words, formula))| theorem::accepted_statement(words, formula, equations)).collect()
}

/// What the formulas of a claim ask for, in one line.
pub(super) fn criterion(stated: &StatedClaim) -> String {
    let one = |(_, formula): &(String, ClaimFormula)| {
        let scope = &formula.scope;
        let mut given: Vec<String> = scope.given.iter().map(|condition| condition.text.clone()).collect();
        given.extend(scope.within.iter().map(|(name, [low, high])| format!("{low} <= {name} <= {high}")));
        given.extend(scope.at.iter().map(|(name, value)| format!("{name} = {value}")));
        let given = if given.is_empty() { String::new() } else { format!(" for all {}", given.join(", ")) };
        let some = match &scope.there_is[..] {
            [] => String::new(),
            names => {
                let names: Vec<&str> = names.iter().map(Symbol::as_str).collect();
                format!("there is {} with ", names.join(", "))
            }
        };
        format!("{some}{}{given}", formula.text)
    };
    let readings = stated
        .readings
        .iter()
        .map(|reading| reading.parts.iter().map(one).collect::<Vec<_>>().join("; and "));
    format!("{}.", readings.collect::<Vec<_>>().join("; or, read otherwise, "))
}

/// The finding on a formula: with a limit, it holds within the limit where what is said of the outside is true too.
pub(super) fn decide_part(id: &str, words: &str, formula: &ClaimFormula, context: &Context) -> Finding {
    let found = decide_formula(id, words, formula, context);
    let Some(limit) = formula.limit.as_ref().filter(|_| found.verdict == Verdict::Holds) else {
        return found;
    };
    let (words, outside) = &limit.outside;
    let outside = decide_formula(&format!("{id}-outside"), words, outside, context);
    match outside.verdict {
        Verdict::Holds => {
            let found = outside.evidence.into_iter().fold(found, Finding::with_evidence);
            found.limited(limit.words.clone()).outside(words)
        }
        Verdict::Fails => Finding::not_checked(format!(
            "What `outside` says is false: {words} ({})",
            outside.counter_example.unwrap_or_default()
        )),
        _ => Finding {
            contradictions: outside.contradictions,
            ..Finding::not_checked(format!("Not decided whether it holds outside its limit: {words}"))
        },
    }
}

fn decide_formula(id: &str, words: &str, formula: &ClaimFormula, context: &Context) -> Finding {
    if let Some(rows) = &formula.rows {
        return over_rows::decide(rows, &formula.text, context);
    }
    if let Some(part) = formula.computed() {
        let premises = part.premises.iter().map(|premise| {
            let found = decide(&premise.id, &premise.stated, context);
            premise.decided_for.iter().fold(found, |found, things| found.decided_for(things))
        });
        return computed::decide(part, premises.collect(), context);
    }
    // A claim is a premise of others, too.
    let digest = sha256_hex(&resolved_formula(formula, context.equations));
    context.once(format!("{digest} {} {id} {words}", context.is_gated), || {
        let found = decide_equations(id, words, formula, context.equations);
        let found = match found.verdict {
            Verdict::NotChecked => decide_widely(id, words, formula, context.equations).unwrap_or(found),
            _ => found,
        };
        if context.is_gated { gate::passed(formula, found, context.equations) } else { found }
    })
}

/// The most steps of algebra that the decision of one formula takes, and of a statement on motions.
const STEPS: u64 = 6_000_000;
const STEPS_OF_MOTION: u64 = 200_000_000;

/// The finding on a formula about the equations, if it takes no more steps than allowed.
pub(super) fn decide_equations(
    id: &str,
    words: &str,
    formula: &ClaimFormula,
    equations: &Equations,
) -> Finding {
    let steps = match &formula.statement {
        Statement::Motion(_) => STEPS_OF_MOTION,
        _ => STEPS,
    };
    within_budget(steps, || decide_within(id, words, formula, equations, false))
        .unwrap_or_else(|exhausted| Finding::not_checked(format!("Not decided: {exhausted}.")))
}

/// The finding of the wider search, if it finds a proof.
fn decide_widely(id: &str, words: &str, formula: &ClaimFormula, equations: &Equations) -> Option<Finding> {
    let is_about_motions = matches!(formula.statement, Statement::Motion(_));
    let decide = || decide_within(id, words, formula, equations, true);
    let found = (!is_about_motions).then(|| within_budget(STEPS, decide).ok()).flatten()?;
    Some(found).filter(|found| found.verdict != Verdict::NotChecked)
}

fn decide_within(
    id: &str,
    words: &str,
    formula: &ClaimFormula,
    equations: &Equations,
    is_wide: bool,
) -> Finding {
    let problem = match Problem::new(id, words, formula, equations) {
        Ok(problem) => Problem { is_wide, ..problem },
        Err(reason) => return Finding::not_checked(reason),
    };
    if let Some(steps) = problem.contradiction() {
        let proof = certify_all(problem.proof.clone(), "", &[], steps);
        let finding = Finding::not_checked("No point meets the conditions: they contradict each other.");
        return proof.map_or(finding.clone(), |proof| finding.with_evidence(Evidence::Proof { proof }));
    }
    match &formula.statement {
        Statement::True(said) => match Lowered::new(said, &problem.names, &problem.premises) {
            Err(reason) => Finding::not_checked(format!("Not decided: {reason}.")),
            Ok(lowered) if formula.scope.there_is.is_empty() => problem.for_all(said, &lowered),
            Ok(lowered) => problem.there_is(&lowered),
        },
        Statement::Motion(motion) => problem.motion(motion),
        Statement::Computed(_) => Finding::not_checked("No formula decides it."),
        other => problem.behaviour(other),
    }
    .with_theorem(|verdict| {
        let is_refuted = verdict == Verdict::Fails;
        Some(theorem::accepted_in(&theorem::ACCEPTED, formula, equations, is_refuted)?.0)
    })
}

/// The finding where the conditions are met by no point that was tried.
fn no_point() -> Finding {
    let none = format!("None of {} points meets the conditions", Points::MOST);
    Finding::not_checked(none + ", so that they may be impossible.")
}

/// All expressions of a formula, its conditions and its witness in one.
fn all_expressions(formula: &ClaimFormula) -> Expression {
    Expression::Sum(formula.expressions().into_iter().cloned().collect())
}

/// A formula with what it assumes.
struct Problem<'f> {
    proof: Proof,
    /// The equations that the formula names.
    numbers: Vec<String>,
    premises: Premises,
    names: Names,
    formula: &'f ClaimFormula,
    /// Whether proofs are sought in more ways than the usual ones.
    is_wide: bool,
}

impl<'f> Problem<'f> {
    fn new(id: &str, words: &str, formula: &'f ClaimFormula, equations: &Equations) -> Result<Self, String> {
        let names = Names::of(equations);
        let premises = formula.premises(equations)?;
        let sides = formula.statement.sides();
        let mut numbers: Vec<String> =
            sides.iter().flat_map(|side| names.equations_of(side)).map(str::to_owned).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let lemmas = names.proofs_of(&all_expressions(formula)).into_iter().cloned();
        let proof = lemmas.fold(Proof::new(id, words), Proof::using);
        Ok(Self { proof, numbers, premises, names, formula, is_wide: false })
    }

    /// The steps that no point meets the conditions, where that is so.
    fn contradiction(&self) -> Option<Vec<Draft>> {
        let points = self.points([]);
        let prover = self.prover(&points);
        if self.premises.conditions.is_empty() || prover.domain(&self.premises, &[]).is_some() {
            return None;
        }
        let bare = Premises { conditions: Vec::new(), ..self.premises.clone() };
        prover.contradiction(&bare, self.premises.conditions.clone(), 2)
    }

    /// A side with the definitions, values and solutions in place.
    fn put_in(&self, side: &Expression) -> Expression {
        self.premises.put_in(&self.names.resolved(side))
    }

    /// A search for certificates.
    fn prover<'p>(&self, points: &'p Points) -> Prover<'p> {
        Prover::new(points, self.is_wide)
    }

    /// The points for these expressions.
    fn points<'e>(&'e self, expressions: impl IntoIterator<Item = &'e Expression>) -> Points {
        self.points_under(&self.premises, expressions)
    }

    /// The points for these expressions under other premises.
    fn points_under<'e>(
        &self,
        premises: &'e Premises,
        expressions: impl IntoIterator<Item = &'e Expression>,
    ) -> Points {
        Points::new(premises, &self.formula.scope.within, expressions)
    }

    /// The equations that the formula names, as a proof takes them.
    fn numbers(&self) -> Vec<&str> {
        self.numbers.iter().map(String::as_str).collect()
    }

    /// The beginning of a proof: how the equations among the conditions were solved.
    fn start(&self, prover: &Prover<'_>) -> Result<Proof, String> {
        let start = self.premises.solved.iter().try_fold(self.proof.clone(), |proof, solved| {
            let name = Expression::Variable(solved.variable.clone());
            let domain = prover.domain(&self.premises, &[]).ok_or("no point meets the conditions")?;
            let left = solved.expression.clone() / solved.slope.clone();
            let right = name.clone() - solved.value.clone();
            let says = format!("the condition {} = 0 is {name} = {}", solved.expression, solved.value);
            let certificate = Certificate::Identity { left, right, domain };
            proof.certify(&says, &[], certificate).map_err(|error| error.to_string())
        })?;
        self.with_facts(start, prover)
    }

    /// Adds what follows from the assumptions and makes the sides have a value.
    fn with_facts(&self, start: Proof, prover: &Prover<'_>) -> Result<Proof, String> {
        let bare = Premises { facts: Vec::new(), ..self.premises.clone() };
        self.premises.facts.iter().try_fold(start, |proof, fact| {
            let domain = prover.domain(&bare, &[]).ok_or("no point meets the conditions")?;
            let steps = prover.fact(fact, &domain);
            let steps = steps.ok_or_else(|| format!("no certificate was found for {fact}"))?;
            certify_all(proof, "a side has a value: ", &[], steps).map_err(|error| error.to_string())
        })
    }

    /// A point of the variables that are left, with the values of the others.
    fn full(&self, point: &Point) -> Point {
        let mut full = point.clone();
        for (name, value) in &self.premises.values {
            full.extend(value.rational_value(point).map(|value| (name.clone(), value)));
        }
        for solved in self.premises.solved.iter().rev() {
            full.extend(solved.value.rational_value(&full).map(|value| (solved.variable.clone(), value)));
        }
        full
    }

    /// Whether a full point meets every assumption as it is written.
    fn is_allowed(&self, point: &Point) -> bool {
        let positive = point.iter().all(|(name, value)| !self.names.is_positive(name) || *value > 0);
        let given = self.formula.scope.given.iter().all(|condition| {
            let literal = condition.literal();
            let resolved = Literal::new(self.names.resolved(&literal.expression), literal.sign);
            resolved.holds_at(point) == Some(true)
        });
        positive && given
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod verdict_tests;
