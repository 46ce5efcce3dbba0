//! What a file assumes: positive variables, and conditions with values at which they hold.

use std::collections::{BTreeMap, BTreeSet};

use rug::Rational;

use crate::derivation::{read_condition, read_name};
use crate::{AssumptionsText, EquationFault};
use slipmode_algebra::{Condition, Domain, Expression, Sign, Symbol, unknowns};

/// The positive variables and the conditions of a file, with values at which they hold.
///
/// # Errors
/// A condition that cannot be read.
pub(crate) fn assumed(
    assumptions: &AssumptionsText,
    functions: &BTreeSet<Symbol>,
) -> Result<Domain, EquationFault> {
    let fault = |message| EquationFault { key: "assumptions.conditions".to_owned(), message };
    let conditions: Result<Vec<Condition>, String> =
        assumptions.conditions.iter().map(|text| read_condition(text, functions)).collect();
    let domain = positive(assumptions);
    with_conditions(domain, &conditions.map_err(fault)?).map_err(fault)
}

/// The domain of the positive variables of a file, those at fault left out.
pub(crate) fn positive(assumptions: &AssumptionsText) -> Domain {
    Domain::of_positive(assumptions.positive.iter().filter_map(|name| read_name(name)))
}

/// The domain with more conditions, and values at which all hold.
pub(super) fn with_conditions(domain: Domain, more: &[Condition]) -> Result<Domain, String> {
    /// Values that a variable takes in the search; the positive ones first.
    const VALUES: [(i32, i32); 8] = [(1, 1), (2, 1), (1, 2), (3, 1), (1, 10), (10, 1), (0, 1), (-1, 1)];
    const TRIED: usize = 4096;
    if more.is_empty() {
        return Ok(domain);
    }
    let add = |domain: Domain, one: &Condition| domain.given(one.expression.clone(), one.relation);
    let domain = more.iter().fold(domain.without_example(), add);
    let variables = unknowns(domain.conditions().iter().map(|condition| &condition.expression));
    let found = (0..TRIED).find_map(|index| {
        let mut rest = index;
        let point: BTreeMap<Symbol, Rational> = variables
            .iter()
            .map(|name| {
                let count = if domain.is_positive(name) { VALUES.len() - 2 } else { VALUES.len() };
                let value = Rational::from(VALUES[rest % count]);
                rest /= count;
                (name.clone(), value)
            })
            .collect();
        let holds = |condition: &Condition| {
            let value = Domain::default().rational_function(&condition.expression.at_point(&point)).ok();
            let value = value.and_then(|value| value.as_constant());
            value.is_some_and(|value| Sign::from(condition.relation).admits(value.cmp0()))
        };
        domain.conditions().iter().all(holds).then_some(point)
    });
    let Some(point) = found else {
        let all: Vec<String> = domain.conditions().iter().map(ToString::to_string).collect();
        return Err(format!("none of {TRIED} points meets {}: they may be impossible", all.join(", ")));
    };
    let example = |domain: Domain, (name, value)| domain.example(name, Expression::Number(value));
    Ok(point.into_iter().fold(domain, example))
}
