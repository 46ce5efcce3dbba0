//! Formulas of comparisons and of predicates on roots as theorems: Coq proves the same formula over the signs of expressions, which come
//! from the steps of the ledger's proof.

use std::collections::BTreeMap;

use slipmode_algebra::coq;
use slipmode_algebra::{Certificate, Comparison, Domain, Expression, Proof, Sign, SignFormula, Symbol};
use slipmode_core::number::Rational;
use slipmode_theory::root_location::{self, RootStatement};

use super::{Stated, Steps, same_sides};
use crate::claims::formula::lowering::{Lowered, located};
use crate::claims::formula::points::Point;
use crate::claims::formula::prover::open_absolutes;
use crate::scene::{Formula, Scope};

/// A formula as Coq reads it, each of its comparisons and predicates as `atom` writes it.
fn proposition(
    formula: &Formula,
    atom: &mut dyn FnMut(&Formula) -> Result<String, String>,
) -> Result<String, String> {
    let inner = |part: &Formula| {
        let text = proposition(part, atom)?;
        let is_atom = matches!(part, Formula::Compare(..) | Formula::Roots(..) | Formula::Crossing(_));
        Ok::<_, String>(if is_atom { text } else { format!("({text})") })
    };
    let (parts, joint) = match formula {
        Formula::Not(part) => return Ok(format!("~ ({})", proposition(part, atom)?)),
        Formula::All(parts) => (&parts[..], " /\\ "),
        Formula::Any(parts) => (&parts[..], " \\/ "),
        Formula::Implies(both) => (&both[..], " -> "),
        Formula::Iff(both) => (&both[..], " <-> "),
        Formula::Compare(..) | Formula::Roots(..) | Formula::Crossing(_) => return atom(formula),
    };
    Ok(parts.iter().map(inner).collect::<Result<Vec<_>, _>>()?.join(joint))
}

/// Signs as Coq reads them.
fn signs_text(signs: &SignFormula) -> String {
    let joined = |parts: &[SignFormula], joint: &str, none: &str| match parts {
        [] => none.to_owned(),
        [one] => signs_text(one),
        _ => parts.iter().map(|part| format!("({})", signs_text(part))).collect::<Vec<_>>().join(joint),
    };
    match signs {
        SignFormula::All(parts) => joined(parts, " /\\ ", "True"),
        SignFormula::Any(parts) => joined(parts, " \\/ ", "False"),
        SignFormula::Literal(literal) => {
            let text = coq::text(&literal.expression);
            match literal.sign {
                Sign::Positive => format!("0 < {text}"),
                Sign::NonNegative => format!("0 <= {text}"),
                Sign::Zero => format!("{text} = 0"),
                Sign::NonZero => format!("{text} < 0 \\/ 0 < {text}"),
            }
        }
    }
}

fn list(coefficients: &[Expression]) -> String {
    format!("[{}]", coefficients.iter().map(coq::text).collect::<Vec<_>>().join("; "))
}

/// Values in the place of variables.
type Values = BTreeMap<Symbol, Expression>;

/// An expression with these values; the number that it comes to where they are numbers.
fn valued(expression: &Expression, values: &Values) -> Expression {
    let there = expression.substitute(values);
    match there.rational_value(&Point::new()) {
        Some(number) if !values.is_empty() => Expression::Number(number),
        _ => there,
    }
}

impl Stated {
    /// What a formula says, or its negation: first what the coefficients of the polynomials are of whose roots it speaks. The lemmas on
    /// roots are those of `proofs/HalfPlane.v`.
    pub(super) fn by_signs(&mut self, formula: &Formula, is_negated: bool) -> Result<String, String> {
        let mut polynomials: Vec<String> = Vec::new();
        let text = proposition(formula, &mut |atom| match atom {
            Formula::Compare(left, comparison, right) => {
                let is_strict =
                    matches!(comparison, Comparison::Less | Comparison::Greater | Comparison::Unequal);
                if !is_strict && self.shown(left)? == self.shown(right)? {
                    return Err(same_sides());
                }
                self.compared(left, *comparison, right)
            }
            Formula::Roots(statement, written, variable) => {
                let (_, coefficients) = located(written, &self.names, variable, &self.premises)?;
                let list = list(&coefficients);
                let polynomial = self.polynomial(written, variable, &coefficients)?;
                let says =
                    format!("(forall {0} : R, {polynomial} = horner {list} {0}) /\\ ", shown(variable));
                if !polynomials.contains(&says) {
                    polynomials.push(says);
                }
                let (most, predicate) = match statement {
                    RootStatement::Stable => (4, "all_left"),
                    RootStatement::Unstable => (4, "one_right"),
                    RootStatement::AllReal => (3, "all_real"),
                };
                match coefficients.len() - 1 {
                    degree if degree > most => {
                        Err(format!("a statement on the roots of a polynomial of degree {degree}"))
                    }
                    _ => Ok(format!("{predicate} {list}")),
                }
            }
            _ => Err("a statement on a pair of roots that crosses the axis".into()),
        })?;
        let text = match is_negated {
            true => format!("~ ({text})"),
            false if polynomials.is_empty() => text,
            false => format!("({text})"),
        };
        Ok(polynomials.concat() + &text)
    }

    /// A polynomial as it is written; the variables of it and of its coefficients are noted, but for its own.
    fn polynomial(
        &mut self,
        written: &Expression,
        variable: &Symbol,
        coefficients: &[Expression],
    ) -> Result<String, String> {
        let known = self.variables.contains(variable);
        let side = self.names.resolved_but(written, variable).substitute(&self.premises.values);
        let text = self.noted(&side)?;
        for one in coefficients {
            self.noted(one)?;
        }
        if known {
            return Err(format!("a condition contains {variable}, of which there is a polynomial"));
        }
        self.variables.remove(variable);
        Ok(text)
    }
}

pub(super) fn shown(variable: &Symbol) -> String {
    coq::text(&Expression::Variable(variable.clone()))
}

/// What is wanted of the values of variables: what is assumed of them, and the formula.
pub(super) fn wanted(formula: &Formula, scope: &Scope, stated: &Stated) -> Formula {
    let compared = |name: &Symbol, comparison: Comparison, value: &Rational| {
        Formula::Compare(Expression::Variable(name.clone()), comparison, Expression::Number(value.clone()))
    };
    let listed = || scope.there_is.iter();
    let positive = listed().filter(|name| stated.names.is_positive(name));
    let positive = positive.map(|name| compared(name, Comparison::Greater, &Rational::new()));
    let within = scope.within.iter().filter(|(name, _)| scope.there_is.contains(name));
    let within = within.flat_map(|(name, [low, high])| {
        [compared(name, Comparison::AtLeast, low), compared(name, Comparison::AtMost, high)]
    });
    let given = scope.given.iter().filter(|condition| stated.is_wanted(&condition.sides));
    let given = given.map(|condition| {
        let [left, right] = condition.sides.clone();
        Formula::Compare(left, condition.comparison, right)
    });
    Formula::All(positive.chain(within).chain(given).chain([formula.clone()]).collect())
}

/// The point at which a proof evaluates expressions, if it is such a proof.
pub(super) fn point_of(proof: &Proof) -> Option<Point> {
    let mut certificates = proof.steps.iter().filter_map(|step| step.certificate.as_ref());
    certificates.find_map(|one| match one {
        Certificate::Value { point, .. } | Certificate::Difference { point, .. } => {
            let value = |value: &Expression| value.rational_value(&Point::new());
            point.iter().map(|(name, one)| Some((name.clone(), value(one)?))).collect()
        }
        _ => None,
    })
}

impl Steps<'_> {
    /// The tactics for a formula, or for its negation, at this point, which meets the conditions.
    pub(super) fn at_point(
        &mut self,
        formula: &Formula,
        mut point: Point,
        is_negated: bool,
    ) -> Result<String, String> {
        let stated = self.stated;
        for solved in stated.premises.solved.iter().rev() {
            let value =
                solved.value.rational_value(&point).ok_or("the point has a value that is not rational")?;
            point.insert(solved.variable.clone(), value);
        }
        let value = |name: &Symbol| point.get(name).cloned().unwrap_or_else(|| Rational::from(1));
        let values = stated.variables.iter().map(|name| (name.clone(), Expression::Number(value(name))));
        let values: Values = values.collect();
        let named: Vec<String> = values.values().map(coq::text).collect();
        let conditions = "split; [ met | ]; ".repeat(stated.hypotheses.len());
        Ok(format!(
            "exists {}; {conditions}{}",
            named.join(", "),
            self.by_signs(formula, &values, is_negated)?
        ))
    }

    /// The tactics for the existence of values: the witness, or the values at the point of the proof.
    pub(super) fn at_witness(
        &mut self,
        formula: &Formula,
        scope: &Scope,
        point: Option<Point>,
    ) -> Result<String, String> {
        let stated = self.stated;
        let witness = scope.witness.iter().map(|(name, value)| (name.clone(), self.put_in(value)));
        let values: Values = match point {
            None => witness.collect(),
            Some(point) => point.into_iter().map(|(name, value)| (name, Expression::Number(value))).collect(),
        };
        let named: Option<Vec<String>> =
            stated.there_is.iter().map(|name| values.get(name).map(coq::text)).collect();
        let named = named.ok_or("the proof names no value")?.join(", ");
        Ok(format!("exists {named}; {}", self.by_signs(&wanted(formula, scope, stated), &values, false)?))
    }

    /// The tactics for a formula over signs, or for its negation, with these values in the place of variables, and with every step of
    /// the proof that says a sign as a fact.
    pub(super) fn by_signs(
        &mut self,
        formula: &Formula,
        values: &Values,
        is_negated: bool,
    ) -> Result<String, String> {
        let stated = self.stated;
        let lowered = Lowered::new(formula, &stated.names, &stated.premises)?;
        let mut tactics = String::new();
        let mut polynomials = Vec::new();
        for atom in formula.atoms() {
            let Formula::Roots(_, written, variable) = atom else { continue };
            let (left, coefficients) = located(written, &stated.names, variable, &stated.premises)?;
            if !polynomials.contains(&(left.clone(), variable)) {
                let right = root_location::polynomial(&coefficients, variable);
                let mut renamed: Vec<(Symbol, String)> =
                    values.iter().map(|(name, value)| (name.clone(), coq::text(value))).collect();
                renamed.push((variable.clone(), "s'".to_owned()));
                let fact = self.fact(&renamed, |one| {
                    matches!(one, Certificate::Identity { left: one, right: other, .. } if *one == left && *other == right)
                })?;
                tactics += &format!("split; [ intros s'; cbn [horner]; {fact}stated h' | ");
                polynomials.push((left, variable));
            }
        }
        let over_signs = proposition(formula, &mut |atom| {
            let known = lowered.atoms.iter().find(|(known, _)| known == atom);
            let there =
                |signs: &SignFormula| format!("({})", signs_text(&signs.map(&|one| valued(one, values))));
            known.map(|(_, signs)| there(signs)).ok_or_else(|| "a predicate without signs".to_owned())
        })?;
        let over_signs = if is_negated { format!("~ ({over_signs})") } else { over_signs };
        tactics += &format!("apply (fun same => from_signs _ ({over_signs}) same); [ by_signs | ");
        let mut zeros = String::new();
        if let Some(inner) = self.divided(&lowered, !values.is_empty()) {
            return Err(format!("no tactic for the cases of the absolute value of {inner}"));
        }
        // At a point the values alone decide.
        let is_point = !values.is_empty() && stated.there_is.is_empty();
        let facts = if is_point { Vec::new() } else { self.facts() };
        for (certificate, number) in facts.iter().zip(1..) {
            let Ok(applied) = self.applied(certificate, &[]) else { continue };
            tactics +=
                &format!("pose proof {applied} as f'{number}; assumed f'{number}; sign_of f'{number}; ");
            if let Some((name, value)) = solved(certificate) {
                zeros += &format!("try case_of_zero f'{number} {} {}; ", shown(name), coq::text(&value));
            }
        }
        if !is_point {
            tactics += &self.opposites(&lowered);
        }
        let cases = if zeros.is_empty() {
            "by_cases".to_owned()
        } else {
            format!("first [ solve [by_cases] | {zeros}by_cases ]")
        };
        Ok(tactics + &cases + " ]" + &" ]".repeat(polynomials.len()))
    }

    /// What has an absolute value although its sign is open, at a point or in cases of the proof by that sign.
    fn divided(&self, lowered: &Lowered, is_point: bool) -> Option<Expression> {
        let domain = self.stated.premises.domain();
        let domains = || self.proof.steps.iter().filter_map(|step| step.certificate.as_ref()?.domain());
        let assumed = |one: &Expression| {
            domains().flat_map(Domain::conditions).any(|condition| condition.expression == *one)
        };
        let expressions = lowered.expressions();
        let mut open = expressions.iter().flat_map(|one| open_absolutes(one, &domain));
        open.find(|inner| is_point || assumed(inner) || assumed(&-inner.clone()))
    }

    /// Which expressions are the opposites of others.
    fn opposites(&self, lowered: &Lowered) -> String {
        let domain = self.stated.premises.domain();
        let mut found: Vec<Expression> = Vec::new();
        let mut tactics = String::new();
        for expression in lowered.expressions() {
            let is_opposite = |other: &&Expression| {
                domain.difference(&expression, &-(*other).clone()).is_ok_and(|rest| rest.is_zero())
            };
            let plain = !matches!(expression, Expression::Negation(_) | Expression::Number(_));
            if plain && !found.contains(&expression) {
                if let Some(other) = found.iter().find(is_opposite) {
                    let [one, other] = [&expression, other].map(coq::text);
                    tactics += &format!("assert ({one} = - {other}) by same_value; ");
                }
                found.push(expression);
            }
        }
        tactics
    }

    /// The steps on the variables of the statement that say what sign an expression has, or that two are equal.
    fn facts(&self) -> Vec<Certificate> {
        let is_solved =
            |name: &Symbol| self.stated.premises.solved.iter().any(|solved| solved.variable == *name);
        let is_known = |name: &Symbol| self.stated.variables.contains(name) && !is_solved(name);
        let of_statement = |one: &Expression| one.variables().iter().all(is_known);
        let mut found: Vec<Certificate> = Vec::new();
        for certificate in self.proof.steps.iter().filter_map(|step| step.certificate.as_ref()) {
            let is_fact = match certificate {
                Certificate::Sign { expression, .. } | Certificate::Growth { expression, .. } => {
                    of_statement(expression)
                }
                Certificate::Identity { left, right, .. } => of_statement(left) && of_statement(right),
                _ => false,
            };
            if is_fact && !found.contains(certificate) {
                found.push(certificate.clone());
            }
        }
        found
    }
}

/// The variable that is solved for in a step, and its value.
fn solved(certificate: &Certificate) -> Option<(&Symbol, Expression)> {
    let Certificate::Identity { right: Expression::Sum(parts), .. } = certificate else { return None };
    let [Expression::Variable(name), rest @ ..] = &parts[..] else { return None };
    let value = match rest {
        [Expression::Negation(value)] => (**value).clone(),
        _ => -Expression::Sum(rest.to_vec()),
    };
    (!value.variables().contains(name)).then_some((name, value))
}
