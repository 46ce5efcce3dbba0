//! Claims that a report states as formulas: decided by a certificate, by an exact counter-example, or not at all.

mod points;
mod substitutions;

use std::collections::BTreeMap;

use slipmode_core::polynomial::{
    Certificate, Domain, Expression, Proof, RationalFunction, Refutation, Relation, Symbol, Toward,
};
use slipmode_core::theory::Equations;

use crate::claims::Finding;
use crate::claims::reading::{Draft, of_readings};
use crate::scene::{ClaimFormula, Comparison, Names, StatedClaim, Statement};
use points::{Point, Points};
use substitutions::domains;

/// The finding on a claim: one formula decides it, or all its parts.
pub(super) fn decide(id: &str, stated: &StatedClaim, equations: &Equations) -> Finding {
    match &stated.parts[..] {
        [(words, formula)] => decide_formula(id, words, formula, equations),
        parts => {
            let all =
                parts.iter().zip(1..).fold(Draft::new("all parts"), |draft, ((words, formula), number)| {
                    draft.part(words, decide_formula(&format!("{id}-{number}"), words, formula, equations))
                });
            of_readings([all])
        }
    }
}

/// What the formulas of a claim ask for, in one line.
pub(super) fn criterion(stated: &StatedClaim) -> String {
    let one = |(_, formula): &(String, ClaimFormula)| {
        let given: Vec<&str> = formula.given.iter().map(|condition| condition.text.as_str()).collect();
        let given = if given.is_empty() { String::new() } else { format!(" for all {}", given.join(", ")) };
        format!("{}{given}", formula.text)
    };
    format!("{}.", stated.parts.iter().map(one).collect::<Vec<_>>().join("; and "))
}

fn decide_formula(id: &str, words: &str, formula: &ClaimFormula, equations: &Equations) -> Finding {
    let names = Names::of(equations);
    let points = Points::new(formula, &names, equations);
    let Some(example) = points.iter().next() else {
        return Finding::not_checked(format!(
            "None of {} points meets the conditions, so that they may be impossible.",
            Points::MOST
        ));
    };
    let domain = example.iter().fold(formula.domain(equations), |domain, (name, value)| {
        domain.example(name.as_str(), Expression::Number(value.clone()))
    });
    let sides = formula.statement.sides();
    let mut numbers: Vec<&str> = sides.iter().flat_map(|side| names.equations_of(side)).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let attempt = Attempt {
        proof: Proof::new(&format!("formula-{}", id.to_lowercase()), words),
        numbers,
        domains: domains(&domain, &sides.iter().map(|side| names.resolved(side)).collect::<Vec<_>>()),
        points,
    };
    let resolved = |expression: &Expression| names.resolved(expression);
    match &formula.statement {
        Statement::Compare(left, comparison, right) => {
            attempt.compare(&resolved(left), *comparison, &resolved(right))
        }
        Statement::Monotone(_, _, variable) if !one_interval(&domain, variable) => {
            Finding::not_checked(format!(
                "Not decided: a condition that is not linear in {variable} may allow separate ranges of it, between which a slope says nothing."
            ))
        }
        Statement::Monotone(expression, comparison, variable) => {
            let slope = resolved(expression).derivative(&Symbol::new(variable));
            attempt.sign(&slope, *comparison, Strictness::OppositeOnly, &format!("its slope in {variable}"))
        }
        Statement::Limit(expression, value, variable, toward) => {
            attempt.limit(&resolved(expression), &resolved(value), variable, *toward)
        }
        Statement::Depends(expression, depends, variable) => {
            attempt.depends(&resolved(expression), *depends, variable)
        }
    }
}

/// Of how many points each is compared with each other one.
const FIRST_POINTS: usize = 64;

/// Whether the conditions allow one interval of a variable: each that contains it is linear in it, and no inequality of the kind ≠.
fn one_interval(domain: &Domain, variable: &str) -> bool {
    let name = Symbol::new(variable);
    domain.conditions().iter().filter(|condition| condition.expression.variables().contains(&name)).all(
        |condition| {
            let slope = domain.rational_function(&condition.expression.derivative(&name));
            let is_constant = |slope: RationalFunction| !Expression::from(&slope).variables().contains(&name);
            condition.relation == Relation::Positive && slope.is_ok_and(is_constant)
        },
    )
}

/// What the decision of one formula works with.
struct Attempt<'a> {
    proof: Proof,
    /// The equations that the formula names.
    numbers: Vec<&'a str>,
    /// The conditions, as they are and with substitutions that reach every point of them.
    domains: Vec<Domain>,
    points: Points,
}

/// Which values refute a sign.
#[derive(Clone, Copy, PartialEq)]
enum Strictness {
    /// Zero and the opposite sign.
    ZeroToo,
    /// The opposite sign: a function with a slope of zero at one point may be strictly monotone.
    OppositeOnly,
}

impl Attempt<'_> {
    /// The first of the domains in which the proof succeeds.
    fn proved(&self, prove: impl Fn(Proof, &Domain) -> Result<Proof, Refutation>) -> Option<Finding> {
        let proof = self.domains.iter().find_map(|domain| prove(self.proof.clone(), domain).ok())?;
        Some(Finding::from_proof(Ok(proof)))
    }

    fn undecided(&self, tried: &str) -> Finding {
        Finding::not_checked(format!(
            "Not decided: {tried} in {} forms of the conditions, and {} points do not refute it.",
            self.domains.len(),
            Points::MOST
        ))
    }

    fn compare(&self, left: &Expression, comparison: Comparison, right: &Expression) -> Finding {
        let difference = left.clone() - right.clone();
        if comparison != Comparison::Equal {
            return self.sign(&difference, comparison, Strictness::ZeroToo, "left minus right");
        }
        let equal =
            |proof: Proof, domain: &Domain| proof.identity("both sides", &self.numbers, left, right, domain);
        if let Some(found) = self.proved(equal) {
            return found;
        }
        let refuted = self.points.iter().find_map(|point| {
            let [left, right] = [left, right].map(|side| points::value(side, &point));
            let (left, right) = (left?, right?);
            (left != right)
                .then(|| format!("at {}: {left} on the left, {right} on the right", points::text(&point)))
        });
        refuted.map_or_else(|| self.undecided("the sides were not found equal"), Finding::failing)
    }

    fn sign(
        &self,
        expression: &Expression,
        wanted: Comparison,
        strictness: Strictness,
        says: &str,
    ) -> Finding {
        let opposite = -expression.clone();
        let positive = |expression: &Expression| {
            self.proved(|proof, domain| proof.positive(says, &self.numbers, expression, domain))
        };
        let found = match wanted {
            Comparison::Greater => positive(expression),
            Comparison::Less => positive(&opposite),
            Comparison::Unequal | Comparison::Equal => positive(expression).or_else(|| positive(&opposite)),
        };
        if let Some(found) = found {
            return found;
        }
        let refutes = |sign: std::cmp::Ordering| match wanted {
            Comparison::Greater => sign.is_lt() || sign.is_eq() && strictness == Strictness::ZeroToo,
            Comparison::Less => sign.is_gt() || sign.is_eq() && strictness == Strictness::ZeroToo,
            Comparison::Unequal | Comparison::Equal => sign.is_eq(),
        };
        let refuted = self.points.iter().find_map(|point| {
            let value = points::value(expression, &point)?;
            refutes(value.cmp0()).then(|| format!("at {}: {says} is {value}", points::text(&point)))
        });
        refuted.map_or_else(|| self.undecided("coefficients of one sign were not found"), Finding::failing)
    }

    fn limit(&self, expression: &Expression, value: &Expression, variable: &str, toward: Toward) -> Finding {
        let prove = |domain: &Domain| {
            let proof = self.proof.clone();
            proof.limit("the limit", &self.numbers, expression, (variable, toward), value, domain)
        };
        let mut other = None;
        for domain in &self.domains {
            match prove(domain) {
                Ok(proof) => return Finding::from_proof(Ok(proof)),
                // A limit that was computed and is another one has a point at which the two differ.
                Err(refutation) => other = other.or(refutation.counter_example.map(|_| refutation.remainder)),
            }
        }
        match other {
            Some(remainder) => Finding::failing(format!("the limit minus the value claimed is {remainder}")),
            None => Finding::not_checked(format!(
                "Not decided: no finite limit was found in {} forms of the conditions.",
                self.domains.len()
            )),
        }
    }

    fn depends(&self, expression: &Expression, claimed: bool, variable: &str) -> Finding {
        let (name, other) = (Symbol::new(variable), Expression::variable("other_value"));
        let changed = expression.with(variable, &other);
        let same = self.proved(|proof, domain| {
            let domain = domain.clone().and_positive("other_value");
            proof.identity(&format!("with another {variable}"), &self.numbers, expression, &changed, &domain)
        });
        if let Some(same) = same {
            let never = format!("it is the same for every {variable}");
            return if claimed { same.refuted(never) } else { same };
        }
        // A point, and the same point with the variable's value of another one.
        let pair = self.points.iter().take(FIRST_POINTS).find_map(|point| {
            let value = points::value(expression, &point)?;
            let changed = self.points.iter().take(FIRST_POINTS).find_map(|other| {
                let mut moved = point.clone();
                moved.insert(name.clone(), other.get(&name)?.clone());
                let changed = points::value(expression, &moved).filter(|changed| *changed != value)?;
                self.points.meets(&moved).then(|| (moved[&name].clone(), changed))
            })?;
            Some((point, value, changed))
        });
        let Some((point, value, (moved, changed_value))) = pair else {
            return self.undecided("no identity was found");
        };
        let words =
            format!("at {}: {value}, and {changed_value} with {variable} = {moved}", points::text(&point));
        if !claimed {
            return Finding::failing(words);
        }
        let mut listed: Vec<(String, Expression)> =
            point.iter().map(|(name, value)| (name.to_string(), Expression::Number(value.clone()))).collect();
        listed.push(("other_value".into(), Expression::Number(moved)));
        let values = [value, changed_value].map(Expression::Number);
        let certificate =
            Certificate::Difference { left: expression.clone(), right: changed, point: listed, values };
        Finding::from_proof(self.proof.clone().certify(&words, &self.numbers, certificate))
    }
}

/// Values by name, for a substitution.
fn expressions(point: &Point) -> BTreeMap<Symbol, Expression> {
    point.iter().map(|(name, value)| (name.clone(), Expression::Number(value.clone()))).collect()
}
