//! Eqs 5 and 6 combined into one equation of third order (eq 7).

use super::notation::{any, formula, rational};
use super::{Equation, Equations};
use crate::polynomial::{Expression, Proof, Refutation, Symbol};

/// The order of the derivative of Δθ in each term, first term first, and whether the equation follows from eqs 5 and 6.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DerivativeOrders {
    /// As the equation is meant.
    pub derived: Vec<usize>,
    /// As the page at hand shows them, when it shows something else.
    pub printed: Option<Vec<usize>>,
}

/// Eliminating Δδ from eqs 5 and 6 gives eq 7 (claim L2); Δδ' obeys the same equation.
///
/// # Errors
/// When the elimination gives another equation.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let eq7 = &equations.equation("7").residual();
    combine(
        equations,
        eq7,
        "third-order-equation",
        "Eqs 5 and 6 combine into eq 7, of orders 3, 2, 1 and 0 in Δθ.",
    )
}

/// The refutation of eq 7 as the page at hand shows it; `None` when the file records no other reading.
#[must_use]
pub fn refute_printed(equations: &Equations) -> Option<Refutation> {
    let (left, right) = equations.equation("7").printed.clone()?;
    combine(
        equations,
        &(left - right),
        "third-order-equation-as-printed",
        "Eq 7 as printed follows from eqs 5 and 6.",
    )
    .err()
}

/// The orders of eq 7's terms, as meant and as printed.
#[must_use]
pub fn orders(equations: &Equations) -> DerivativeOrders {
    let Equation { left, printed, .. } = equations.equation("7");
    DerivativeOrders {
        derived: term_orders(left),
        printed: printed.as_ref().map(|(left, _)| term_orders(left)),
    }
}

fn term_orders(left: &Expression) -> Vec<usize> {
    let terms = if let Expression::Sum(terms) = left { terms.clone() } else { vec![left.clone()] };
    let order = |term: &Expression| term.variables().iter().map(Symbol::derivative_order).max().unwrap_or(0);
    terms.iter().map(order).collect()
}

fn combine(equations: &Equations, eq7: &Expression, id: &str, statement: &str) -> Result<Proof, Refutation> {
    let proof = Proof::new(id, statement);
    let moving = ["Delta_delta", "Delta_theta"];
    let velocity = slip_rate(equations, &proof)?;
    let acceleration = velocity.time_derivative(&moving);
    let jerk = acceleration.time_derivative(&moving);
    let eliminated = equations
        .residual("5")
        .time_derivative(&moving)
        .with("Delta_delta'''", &jerk)
        .with("Delta_delta''", &acceleration)
        .with("Delta_delta'", &velocity);
    proof
        .identity(
            "eq 6 solved for Δδ'",
            &["6"],
            &equations.residual("6").with("Delta_delta'", &velocity),
            &formula("0"),
            &any(),
        )?
        .identity(
            "time derivative of eq 5 with Δδ', Δδ'', Δδ''' from eq 6, against −V_0 times eq 7",
            &["5", "6", "7"],
            &eliminated,
            &(formula("-V_0") * eq7.clone()),
            &any(),
        )
}

/// Eq 6 solved for Δδ'.
fn slip_rate(equations: &Equations, proof: &Proof) -> Result<Expression, Refutation> {
    let name = Symbol::new("Delta_delta'");
    let residual = rational(proof, &["6"], &equations.residual("6"), &any())?;
    let slope = residual.derivative(&name);
    let rest = rational(proof, &["6"], &equations.residual("6").with("Delta_delta'", &formula("0")), &any())?;
    let solved = (-rest).checked_div(&slope).filter(|solved| !solved.numerator().variables().contains(&name));
    solved.map(|solved| Expression::from(&solved)).ok_or_else(|| {
        proof.refute("eq 6 can be solved for Δδ'", &["6"], "Δδ' does not occur linearly in eq 6")
    })
}
