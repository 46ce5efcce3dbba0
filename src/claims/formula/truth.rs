//! Formulas that are true or false at each point.

use std::cell::RefCell;

use slipmode_algebra::{
    Certificate, Comparison, Domain, Expression, Function, Literal, Proof, Sign, SignFormula,
};

use super::lowering::{Lowered, words};
use super::points::{self, Point, Points};
use super::prover::{Draft, Prover, certify_all};
use super::{Problem, no_point};
use crate::claims::Finding;
use crate::scene::{Formula, MOST_CLAUSES, Premises};

/// Points that are looked at before a proof is sought. Their neighbours on the edges of the literals are looked at after it: where the
/// formula is true, they cost more than its proof.
const FIRST_POINTS: usize = 64;

impl Problem<'_> {
    /// The finding on a formula for all points that meet the conditions.
    pub(super) fn for_all(&self, formula: &Formula, lowered: &Lowered) -> Finding {
        let expressions = lowered.expressions();
        let points = self.points(&expressions);
        let prover = self.prover(&points);
        if prover.domain(&self.premises, &[]).is_none() {
            return no_point();
        }
        let (conditions, negated) = (&self.premises.conditions, lowered.signs.negated());
        let refuted = |point: Option<Point>| self.refuted(formula, lowered, &point?);
        if let Some(found) = refuted(among(&points, conditions, &negated, FIRST_POINTS)) {
            return found;
        }
        let tried = match self.proved(formula, lowered, &prover) {
            Ok(proof) => return Finding::from_proof(Ok(proof)),
            Err(tried) => tried,
        };
        let on_edges = refuted(on_edges(&points, conditions, &negated, FIRST_POINTS));
        let refuted = on_edges.or_else(|| refuted(among(&points, conditions, &negated, Points::MOST)));
        refuted.or_else(|| self.enclosed(lowered)).unwrap_or_else(|| {
            let (points, help) = (Points::MOST, help(formula, &lowered.expressions()));
            Finding::not_checked(format!(
                "Not decided: {tried}, and no counter-example among {points} points. {help}"
            ))
        })
    }

    /// The proof that the formula is true at all points that meet the conditions, or what was tried.
    pub(super) fn proved(
        &self,
        formula: &Formula,
        lowered: &Lowered,
        prover: &Prover<'_>,
    ) -> Result<Proof, String> {
        let start = self.start(prover)?;
        let domain = prover.domain(&self.premises, &[]).unwrap_or_default();
        if let Formula::Compare(left, Comparison::Equal, right) = formula {
            let [left, right] = [left, right].map(|side| self.put_in(side));
            let same = start.clone().identity("both sides", &self.numbers(), &left, &right, &domain);
            if let Ok(proof) = same {
                return Ok(proof);
            }
        }
        let start = self.with_lemmas(start, lowered, &domain)?;
        self.with_signs(start, &lowered.signs, &self.premises, prover)
    }

    /// The general lemmas that the predicates rest on, and the coefficients of their polynomials.
    pub(super) fn with_lemmas(
        &self,
        start: Proof,
        lowered: &Lowered,
        domain: &Domain,
    ) -> Result<Proof, String> {
        let start = lowered.lemmas.iter().cloned().fold(start, Proof::using);
        let polynomials = lowered.polynomials.iter().try_fold(start, |proof, (says, left, right)| {
            proof.identity(says, &self.numbers(), left, right, domain)
        });
        polynomials.map_err(|error| error.to_string())
    }

    /// Adds the steps that signs are true everywhere under the premises.
    pub(super) fn with_signs(
        &self,
        start: Proof,
        signs: &SignFormula,
        premises: &Premises,
        prover: &Prover<'_>,
    ) -> Result<Proof, String> {
        let domain = prover.domain(premises, &[]).ok_or("no point meets the conditions")?;
        let known: RefCell<Vec<Draft>> = RefCell::default();
        let is_known = |literal: &Literal| {
            let (truth, says, certificate) = certain(literal, &domain)?;
            let mut known = known.borrow_mut();
            if !known.iter().any(|(_, other)| *other == certificate) {
                known.push((says.into(), certificate));
            }
            Some(truth)
        };
        let single = matches!(signs, SignFormula::Literal(_));
        let clauses = signs.clauses(&|one| if single { None } else { is_known(one) }, MOST_CLAUSES);
        let clauses = clauses.ok_or_else(|| format!("it has more than {MOST_CLAUSES} clauses"))?;
        let count = clauses.len();
        let mut steps = known.into_inner();
        for (clause, number) in clauses.iter().zip(1..) {
            let found = prover.clause(premises, clause);
            steps.extend(found.ok_or_else(|| {
                let words =
                    if count == 1 { String::new() } else { format!(" for clause {number} of {count}") };
                let most = Prover::MOST;
                let all =
                    if prover.attempts() < most { String::new() } else { format!(" in {most} attempts") };
                format!("no proof was found{words}{all}")
            })?);
        }
        certify_all(start, "", &self.numbers(), steps).map_err(|error| error.to_string())
    }

    /// The finding that the formula is false at a point.
    fn refuted(&self, formula: &Formula, lowered: &Lowered, point: &Point) -> Option<Finding> {
        let full = self.full(point);
        let place = points::place(&full);
        let side = |side: &Expression| points::value(&self.put_in(side), point);
        let words = match formula {
            Formula::Compare(left, Comparison::Equal, right) => {
                format!("{place}{} on the left, {} on the right", side(left)?, side(right)?)
            }
            Formula::Compare(left, _, right) => {
                format!("{place}left minus right is {}", side(&(left.clone() - right.clone()))?)
            }
            _ => format!("{place}{}", truths(lowered, point)),
        };
        let values = || self.values_at(point, &lowered.signs.negated(), lowered)?.ok();
        let deciding = lowered.signs.literals().into_iter().chain(&self.premises.conditions);
        let is_rational = deciding.into_iter().all(|one| one.expression.rational_value(point).is_some());
        self.is_allowed(&full).then(|| {
            let found = match values() {
                Some(proof) => Finding::from_disproof(Ok(proof), &words),
                None => Finding::failing(words).enclosed_unless(is_rational),
            };
            found.seen_at([points::named(&full)])
        })
    }
}

/// What was tried on a formula in these expressions, and what may help.
fn help(formula: &Formula, expressions: &[Expression]) -> String {
    let mut ways = vec!["a further condition in `given`"];
    if !matches!(formula, Formula::Compare(..)) {
        ways.push("one part for each clause");
    }
    if expressions.iter().any(|one| one.calls(Function::Sqrt)) {
        ways.push("a parameter r for a root, with r^2 = ... in `given`");
    }
    let tried = "signs of terms, sums of squares, conditions solved for variables";
    format!("Tried: {tried}. What may help: {}.", ways.join("; "))
}

/// Which comparisons and predicates are true at a point.
pub(super) fn truths(lowered: &Lowered, point: &Point) -> String {
    let atoms = lowered.atoms.iter().map(|(atom, signs)| {
        let truth = signs.truth(&|literal| literal.holds_at(point));
        let truth = truth.map_or("open", |truth| if truth { "true" } else { "false" });
        format!("{} is {truth}", words(atom))
    });
    atoms.collect::<Vec<_>>().join(", ")
}

/// A point that meets the conditions and at which the signs are true, among so many points and on the edges next to the first ones.
pub(super) fn found(
    points: &Points,
    conditions: &[Literal],
    signs: &SignFormula,
    count: usize,
) -> Option<Point> {
    among(points, conditions, signs, count).or_else(|| on_edges(points, conditions, signs, count))
}

/// A point that meets the conditions and at which the signs are true, among so many points.
fn among(points: &Points, conditions: &[Literal], signs: &SignFormula, count: usize) -> Option<Point> {
    points.meeting(conditions, count).find(|point| is_found(point, conditions, signs))
}

/// The same on the edges of the literals next to the first points.
fn on_edges(points: &Points, conditions: &[Literal], signs: &SignFormula, count: usize) -> Option<Point> {
    let expressions: Vec<Expression> =
        signs.literals().into_iter().map(|literal| literal.expression.clone()).collect();
    let mut first = points.meeting(conditions, count.min(FIRST_POINTS));
    first
        .find_map(|point| points.edges(&point, &expressions).find(|point| is_found(point, conditions, signs)))
}

fn is_found(point: &Point, conditions: &[Literal], signs: &SignFormula) -> bool {
    signs.truth(&|literal| literal.holds_at(point)) == Some(true)
        && conditions.iter().all(|one| one.holds_at(point) == Some(true))
}

/// Whether the conditions fix the truth of a literal, with the certificate.
fn certain(literal: &Literal, domain: &Domain) -> Option<(bool, &'static str, Certificate)> {
    let Literal { expression, sign } = literal;
    let left = expression.clone();
    if let Some(value) = domain.rational_function(expression).ok()?.as_constant() {
        let (truth, right, domain) = (sign.admits(value.cmp0()), Expression::Number(value), domain.clone());
        return Some((truth, "a number", Certificate::Identity { left, right, domain }));
    }
    let found = domain.sign(expression).ok()??;
    let truth = match sign {
        Sign::Positive | Sign::NonNegative => found > 0,
        Sign::Zero => false,
        Sign::NonZero => true,
    };
    let certificate = Certificate::Sign { expression: left, sign: found, domain: domain.clone() };
    Some((truth, "a sign that the conditions fix", certificate))
}
