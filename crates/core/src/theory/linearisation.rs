//! The linearisation of eqs 1-4 about steady sliding.

use super::Equations;
use super::notation::formula;
use crate::friction::EvolutionLaw;
use slipmode_algebra::{Expression, Symbol};

/// The moving variables, their steady values, and the names of their perturbations.
fn perturbations(equations: &Equations) -> [(&'static str, Expression, &'static str); 5] {
    let steady = equations.right("steady-state").with("V", &formula("V_0"));
    [
        ("delta", formula("V_0*t + delta_0"), "Delta_delta"),
        ("delta'", formula("V_0"), "Delta_delta'"),
        ("delta''", formula("0"), "Delta_delta''"),
        ("theta", steady, "Delta_theta"),
        ("theta'", formula("0"), "Delta_theta'"),
    ]
}

/// The part of a residual that is linear in the perturbations of steady sliding at velocity V_0.
pub(super) fn linearised(equations: &Equations, residual: &Expression) -> Expression {
    let moving = perturbations(equations);
    let steady = moving.iter().map(|(name, value, _)| (Symbol::from(*name), value.clone())).collect();
    let term = |(name, _, perturbation): &(&'static str, Expression, &str)| {
        residual.derivative(&Symbol::from(*name)).substitute(&steady) * formula(perturbation)
    };
    moving.iter().map(term).fold(Expression::integer(0), |sum, part| sum + part)
}

/// Eq 4 with a friction law put in, as left − right in δ and θ.
pub(super) fn motion(equations: &Equations, friction: &Expression) -> Expression {
    let velocity = formula("delta'");
    equations.residual("4").with("mu", &friction.with("V", &velocity))
}

/// Eq 2 or 3 as left − right in δ and θ.
pub(super) fn evolution(equations: &Equations, law: EvolutionLaw) -> Expression {
    equations.residual(law.equation()).with("V", &formula("delta'"))
}
