//! Derivatives, limits, series, and symbols exchanged or replaced.

use std::collections::BTreeMap;

use super::work::Work;
use slipmode_algebra::{Certificate, Condition, End, Expression, Relation, Symbol, Toward};

/// A derivative, the other variables fixed.
pub(super) fn derivative(f: &Expression, x: &Symbol, work: &mut Work) -> Result<Expression, String> {
    let raw = work.derivative("it", f, x)?;
    work.simplified(&format!("its derivative in {x}"), &raw)
}

/// A limit, the other variables fixed.
pub(super) fn limit(
    f: &Expression,
    x: &Symbol,
    toward: Toward,
    work: &mut Work,
) -> Result<Expression, String> {
    let found = finite(f, x, toward, work)?;
    tends(&format!("its limit as {x} -> {toward}"), f, (x, toward), &found, work)?;
    Ok(found)
}

/// The finite limit in normal form.
fn finite(f: &Expression, x: &Symbol, toward: Toward, work: &Work) -> Result<Expression, String> {
    match work.domain.end(f, x, toward)? {
        End::Finite(value) => Ok(Expression::from(&work.rational(&value)?)),
        End::Infinite(_) => Err(format!("{f} has no finite limit in {x}")),
    }
}

/// Σ c_k·x^k up to the order n: what f differs by from it, over x^n, tends to 0.
pub(super) fn series(
    f: &Expression,
    x: &Symbol,
    order: usize,
    work: &mut Work,
) -> Result<Expression, String> {
    let variable = Expression::Variable(x.clone());
    let power = |exponent: usize| variable.clone().power(exponent as i32);
    let mut sum = Expression::integer(0);
    for exponent in 0..=order {
        let rest = (f.clone() - sum.clone()) / power(exponent);
        let next = finite(&rest, x, Toward::Zero, work)?;
        sum = sum + next * power(exponent);
    }
    let rest = (f.clone() - sum.clone()) / power(order);
    let says = format!("what it leaves out is small against {x}^{order}");
    tends(&says, &rest, (x, Toward::Zero), &Expression::integer(0), work)?;
    Ok(sum)
}

/// Adds the step that an expression tends to a value.
fn tends(
    says: &str,
    f: &Expression,
    (x, toward): (&Symbol, Toward),
    value: &Expression,
    work: &mut Work,
) -> Result<(), String> {
    let (expression, variable, value) = (f.clone(), x.clone(), value.clone());
    let certificate = Certificate::Limit { expression, variable, toward, value, domain: work.domain.clone() };
    work.step(|proof, equations, _| proof.certify(says, equations, certificate))
}

/// Two symbols exchanged, both at once.
pub(super) fn exchange(f: &Expression, [x, y]: [&Symbol; 2], work: &mut Work) -> Result<Expression, String> {
    if work.domain.is_positive(x) != work.domain.is_positive(y) {
        return Err(format!("one of {x} and {y} is positive and the other is not"));
    }
    work.simplified(&format!("{x} and {y} exchanged"), &exchanged(f, [x, y]))
}

/// The expression with two variables exchanged.
pub(crate) fn exchanged(f: &Expression, [x, y]: [&Symbol; 2]) -> Expression {
    let [to_x, to_y] = [x, y].map(Expression::variable);
    f.substitute(&BTreeMap::from([(x.clone(), to_y), (y.clone(), to_x)]))
}

/// Values put in, all at once.
pub(super) fn at(
    f: &Expression,
    values: &[(Symbol, Expression)],
    work: &mut Work,
) -> Result<Expression, String> {
    for (name, value) in values.iter().filter(|(name, _)| work.domain.is_positive(name)) {
        let condition = Condition { expression: value.clone(), relation: Relation::NonNegative };
        if work.domain.proves(&condition) != Ok(true) {
            return Err(format!(
                "{name} is positive, and the value {value} in its place may be negative: add what excludes this to `given`"
            ));
        }
    }
    let listed: Vec<String> = values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    work.simplified(&format!("at {}", listed.join(", ")), &f.substitute(&values.iter().cloned().collect()))
}
