//! The linearisation of eqs 1-4 about steady sliding (eqs 5 and 6).

use super::Equations;
use super::notation::{any, formula};
use super::steady_state;
use crate::friction::EvolutionLaw;
use crate::polynomial::{Expression, Proof, Refutation, Symbol};

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
    let steady = moving.iter().map(|(name, value, _)| (Symbol::new(name), value.clone())).collect();
    let term = |(name, _, perturbation): &(&str, Expression, &str)| {
        residual.derivative(&Symbol::new(name)).substitute(&steady) * formula(perturbation)
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

/// How fast the residual of eq 4 grows along δ = V_0 t + δ_0 at constant friction; its linear part is silent on where the load
/// point goes.
fn pull_along_steady_sliding(equations: &Equations) -> Expression {
    let sliding = equations.residual("4").with("delta", &formula("V_0*t + delta_0"));
    sliding.with("delta''", &formula("0")).derivative(&Symbol::new("t"))
}

/// Both evolution laws have the same linearisation about steady state (claim F2).
///
/// # Errors
/// When they differ.
pub fn laws_agree(equations: &Equations) -> Result<Proof, Refutation> {
    let [aging, slip] = EvolutionLaw::ALL.map(|law| linearised(equations, &evolution(equations, law)));
    let proof = Proof::new(
        "laws-agree-near-steady-state",
        "The aging law and the slip law have the same steady state, and the same linearisation about it.",
    );
    steady_state::laws_rest(proof, equations)?.identity(
        "linear parts of eqs 2 and 3 at θ = D_c/V_0",
        &["2", "3", "steady-state"],
        &aging,
        &slip,
        &any(),
    )
}

/// Eqs 5 and 6 are the linearisation of eqs 1, 2 or 3, and 4 about steady sliding (claim L1).
///
/// # Errors
/// When a linear part is another one.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let motion = linearised(equations, &motion(equations, &equations.right("1")));
    let proof = Proof::new(
        "linearisation",
        "About steady sliding, eq 5 is the linear part of eq 4 with friction by eq 1; eq 6 is the linear part of \
             eq 2 and of eq 3.",
    );
    let mut proof = steady_state::laws_rest(proof, equations)?
        .positive(
            "one position of the load point balances the friction of steady sliding: the slope of eq 4 in δ",
            &["4"],
            &equations.residual("4").derivative(&Symbol::new("delta")),
            &any(),
        )?
        .identity(
            "along steady sliding at V_0 the spring's force stays the same: the slope of eq 4 in t",
            &["4"],
            &pull_along_steady_sliding(equations),
            &formula("0"),
            &any(),
        )?
        .identity(
            "eq 4 with eq 1 in Δδ and Δθ",
            &["1", "4", "5", "steady-state"],
            &motion,
            &equations.residual("5"),
            &any(),
        )?;
    for law in EvolutionLaw::ALL {
        let evolution = linearised(equations, &evolution(equations, law));
        let says = format!("{} law in Δδ and Δθ", law.as_str());
        proof = proof.identity(
            &says,
            &[law.equation(), "6", "steady-state"],
            &evolution,
            &equations.residual("6"),
            &any(),
        )?;
    }
    Ok(proof)
}
