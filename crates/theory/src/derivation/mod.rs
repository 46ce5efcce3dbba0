//! Derivations that a file of equations asks for by name: `characteristic(aging, s)`.
//!
//! Each gives an expression and a proof of what the expression is. Two routes meet in it where that is cheap: a determinant by
//! elimination is compared with the one written out, a solution is put back.

mod algebra;
mod calculus;
mod form;
mod system;
#[cfg(test)]
mod tests;
mod work;

pub(super) use calculus::exchanged;
pub use form::{Form, Operation};
pub(super) use form::{NOT_A_NAME, is_name, read_condition, read_name};
pub(super) use system::MOST_STATES;
pub use system::System;
pub(super) use work::Work;

use slipmode_algebra::{Expression, Extent, Symbol};

/// What a definition may come to when it is multiplied out.
const LARGEST: Extent = Extent { terms: 1000, degree: 64, bits: 4096 };

/// Works out a form whose expressions are in variables only.
///
/// # Errors
/// Why it cannot be derived under the assumptions.
pub(super) fn derive(form: &Form, system: Option<&System>, work: &mut Work) -> Result<Expression, String> {
    for argument in form.all_expressions() {
        argument.check_extent(LARGEST).map_err(|error| format!("'{argument}' is too large: {error}"))?;
    }
    let (expressions, variables) = (&form.expressions[..], &form.variables[..]);
    let found = match (form.operation, expressions, variables, system) {
        (None, [f], ..) => Ok(f.clone()),
        (Some(Operation::Characteristic), _, [s], Some(system)) => {
            system.rest(work)?;
            system.characteristic(s, work)
        }
        (Some(Operation::Linearised), _, [rate, by], Some(system)) => {
            let place = |name: &Symbol| {
                let found = system.state.iter().position(|state| state == name);
                found.ok_or_else(|| format!("{name} is no state of {}", system.name))
            };
            let [rate, by] = [place(rate)?, place(by)?];
            system.rest(work)?;
            system.slope(rate, by, work)
        }
        (Some(Operation::Rate), [f], _, Some(system)) => system.rate(f, work),
        (Some(operation @ (Operation::Coefficient | Operation::Leading)), [p], [s], _) => {
            algebra::coefficient(p, s, (form.whole, operation == Operation::Leading), work)
        }
        (Some(Operation::Discriminant), [p], [s], _) => algebra::discriminant_of(p, s, work),
        (Some(Operation::Hurwitz), [p], [s], _) => algebra::hurwitz(p, s, form.whole, work),
        (Some(Operation::Eliminate), [p, q], [x], _) => algebra::eliminate(p, q, x, work),
        (Some(Operation::Solve), [f], [x], _) => algebra::solve(f, x, work),
        (Some(Operation::Derivative), [f], [x], _) => calculus::derivative(f, x, work),
        (Some(Operation::Limit), [f], [x], _) => calculus::limit(f, x, form.toward, work),
        (Some(Operation::Series), [f], [x], _) => calculus::series(f, x, form.whole, work),
        (Some(Operation::Exchange), [f], [x, y], _) => calculus::exchange(f, [x, y], work),
        (Some(Operation::At), [f], ..) => calculus::at(f, &form.values, work),
        _ => Err("the arguments do not fit".to_owned()),
    }?;
    found.check_extent(LARGEST).map_err(|error| format!("the result is too large: {error}"))?;
    Ok(found)
}
