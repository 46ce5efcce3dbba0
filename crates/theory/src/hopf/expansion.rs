//! Taylor parts of expressions, and unknown coefficients found by the conditions that something vanishes.

use crate::notation::{formula, rational};
use slipmode_algebra::{
    Domain, Expression, Function, Polynomial, Proof, RationalFunction, Refutation, Symbol,
};

/// The homogeneous part of this degree of the Taylor series about zero, as derived: Euler's relation
/// k T_k(f) = Σ x_j T_(k−1)(∂f/∂x_j) gives it from derivatives.
pub(crate) fn taylor_part(expression: &Expression, variables: &[&'static str], degree: i32) -> Expression {
    if degree == 0 {
        let origin = variables.iter().map(|name| (Symbol::from(*name), Expression::integer(0))).collect();
        return expression.substitute(&origin);
    }
    let term = |name: &&'static str| {
        let slope = expression.derivative(&Symbol::from(*name));
        formula(name) * taylor_part(&slope, variables, degree - 1)
    };
    let sum = variables.iter().map(term).fold(Expression::integer(0), |sum, part| sum + part);
    sum / Expression::integer(degree)
}

/// Σ e_n·vector[n]: one equation between such sums with free symbols e_n says that the vectors agree.
pub(crate) fn in_basis(vector: &[Expression]) -> Expression {
    let term = |(index, part): (usize, &Expression)| formula(&format!("e_{}", index + 1)) * part.clone();
    vector.iter().enumerate().map(term).fold(Expression::integer(0), |sum, part| sum + part)
}

/// Conditions that determine unknown coefficients.
pub(crate) struct Conditions<'c> {
    /// What must vanish; linear in the unknowns.
    pub vanishing: &'c [Expression],
    /// The symbols in which it must vanish identically.
    pub identically_in: &'c [&'static str],
    /// The names of the unknowns.
    pub unknowns: &'c [&'static str],
}

/// The domain with the values of the unknowns.
///
/// # Errors
/// A refutation with the condition that no values meet, or the unknown that stays open.
pub(crate) fn solve(
    proof: &Proof,
    equations: &[&str],
    conditions: &Conditions,
    domain: Domain,
) -> Result<Domain, Refutation> {
    let vanishing = conditions.vanishing.iter();
    let parts = vanishing.map(|one| Ok(rational(proof, equations, one, &domain)?.numerator().clone()));
    let mut parts = parts.collect::<Result<Vec<_>, Refutation>>()?;
    for name in conditions.identically_in {
        parts = parts.iter().flat_map(|part| part.coefficients(&Symbol::from(*name))).collect();
    }
    let unknowns: Vec<Symbol> = conditions.unknowns.iter().copied().map(Symbol::from).collect();
    let rows = parts.iter().filter(|part| !part.is_zero()).map(|part| row(part, &unknowns)).collect();
    // Two forms of one number, such as w^2*m and k with a root w, are one number in the rows.
    let reduced = |entry: RationalFunction| {
        let above = Expression::from(entry.numerator());
        let above = above.calls(Function::Sqrt).then(|| domain.rational_function(&above).ok()).flatten();
        let below = RationalFunction::from(entry.denominator().clone());
        above.and_then(|above| above.checked_div(&below)).unwrap_or(entry)
    };
    let values = eliminate(rows, unknowns.len(), reduced)
        .map_err(|rest| proof.refute("unknown coefficients can be found", equations, rest))?;
    let values = unknowns.iter().zip(values.iter().map(Expression::from));
    Ok(values.fold(domain, |domain, (name, value)| domain.with(name, value)))
}

/// The coefficients of the unknowns, then the constant part, of a polynomial linear in the unknowns.
fn row(part: &Polynomial, unknowns: &[Symbol]) -> Vec<RationalFunction> {
    let slopes = unknowns.iter().map(|name| part.derivative(name));
    let constant =
        unknowns.iter().fold(part.clone(), |rest, name| rest.substitute(name, &Polynomial::zero()));
    slopes.chain([constant]).map(RationalFunction::from).collect()
}

/// Gauss and Jordan: the unknowns for which every row vanishes, or what cannot vanish.
fn eliminate(
    mut rows: Vec<Vec<RationalFunction>>,
    count: usize,
    reduced: impl Fn(RationalFunction) -> RationalFunction,
) -> Result<Vec<RationalFunction>, String> {
    let mut solved: Vec<Option<Vec<RationalFunction>>> = vec![None; count];
    loop {
        rows.retain(|row| row.iter().any(|entry| !entry.is_zero()));
        // The row with the fewest unknowns keeps the fractions small.
        rows.sort_by_key(|row| row[..count].iter().filter(|entry| !entry.is_zero()).count());
        if rows.is_empty() {
            break;
        }
        let row = rows.remove(0);
        let Some(column) = row[..count].iter().position(|entry| !entry.is_zero()) else {
            return Err(Expression::from(&row[count]).to_string());
        };
        let pivot = row[column].clone();
        let unit: Vec<_> = row.iter().map(|entry| entry / &pivot).collect();
        for other in rows.iter_mut().chain(solved.iter_mut().flatten()) {
            let factor = other[column].clone();
            if !factor.is_zero() {
                let less = |(entry, part): (&RationalFunction, _)| reduced(entry - &(&factor * part));
                *other = other.iter().zip(&unit).map(less).collect();
            }
        }
        solved[column] = Some(unit);
    }
    solved
        .into_iter()
        .map(|row| row.map(|row| -row[count].clone()).ok_or_else(|| "an unknown stays open".to_owned()))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn same(left: &Expression, right: &str) -> bool {
        Domain::positive("eta").difference(left, &formula(right)).expect("rational").is_zero()
    }

    #[test]
    fn taylor_parts_of_an_exponential_and_a_logarithm() {
        let product = formula("exp(x)*ln(1 + y)");
        assert!(same(&taylor_part(&product, &["x", "y"], 2), "x*y - y^2/2"));
        assert!(same(&taylor_part(&product, &["x", "y"], 3), "x^2*y/2 - x*y^2/2 + y^3/3"));
    }

    #[test]
    fn contradicting_conditions_and_open_unknowns_are_refuted() {
        let proof = Proof::new("unknowns", "");
        let attempt = |vanishing: &[Expression], unknowns: &[&'static str]| {
            let conditions = Conditions { vanishing, identically_in: &["i"], unknowns };
            solve(&proof, &[], &conditions, Domain::default())
        };
        let values = attempt(&[formula("(1 + i)*(f + i*g) - 2*i")], &["f", "g"]).expect("1 + i");
        assert!(values.substitutions().iter().all(|(_, value)| same(value, "1")));
        let contradiction =
            attempt(&[formula("f - eta"), formula("f")], &["f"]).expect_err("f = η and f = 0");
        assert!(contradiction.remainder.contains("eta"));
        assert!(attempt(&[formula("f - g")], &["f", "g"]).is_err());
    }
}
