//! The characteristic polynomial (eq 8), in physical and in dimensionless variables.

use std::collections::BTreeMap;

use super::Equations;
use super::linearisation::{evolution, linearised, motion};
use super::notation::{any, formula};
use super::steady_state;
use crate::friction::EvolutionLaw;
use crate::friction::Parameters;
use slipmode_algebra::{Expression, Proof, RationalFunction, Refutation, Symbol};

/// Solutions e^(st) of the linearised slider obey eq 8, for both evolution laws (claim L3).
///
/// Derived three times: from eqs 1-4 with either law as a determinant, from eqs 5 and 6, and from eq 7.
///
/// # Errors
/// When a derivation gives another polynomial.
pub fn prove(equations: &Equations) -> Result<Proof, Refutation> {
    let eq8 = equations.residual("8");
    let motion = linearised(equations, &motion(equations, &equations.right("1")));
    let proof = Proof::new(
        "characteristic-polynomial",
        "Perturbations of steady sliding proportional to e^(st) exist exactly for the roots s of eq 8, for both \
             evolution laws.",
    );
    let mut proof = steady_state::laws_rest(proof, equations)?;
    for law in EvolutionLaw::ALL {
        let evolution = linearised(equations, &evolution(equations, law));
        let says = format!("determinant of eqs 1, 4 and the {} law in (Δδ, Δθ) e^(st)", law.as_str());
        proof = proof.identity(
            &says,
            &["1", law.equation(), "4", "8"],
            &determinant(&motion, &evolution),
            &eq8,
            &any(),
        )?;
    }
    let pair = determinant(&equations.residual("5"), &equations.residual("6"));
    let third_order = exponential(&equations.residual("7")).with("Delta_theta", &formula("1"));
    proof.identity("determinant of eqs 5 and 6", &["5", "6", "8"], &pair, &eq8, &any())?.identity(
        "eq 7 with Δθ = e^(st)",
        &["7", "8"],
        &third_order,
        &eq8,
        &any(),
    )
}

/// Eq 8 in p = s·D_c/V_0 is η p³ + (1 + η) p² + (κ + 1 − β) p + κ: three numbers are all there is.
///
/// The right side is the cubic that the rest of the program computes with, run on symbols.
///
/// # Errors
/// When eq 8 is another polynomial.
pub fn dimensionless(equations: &Equations) -> Result<Proof, Refutation> {
    let parameters = symbolic_parameters();
    let scaled = equations.residual("8").with("s", &formula("p*V_0/D_c")) * formula("D_c^2/(a*V_0)");
    let groups = parameters.groups();
    let cubic = polynomial(&groups.characteristic_cubic(), "p");
    let physical = polynomial(&parameters.characteristic_cubic_per_s(), "s");
    let named = formula("eta*p^3 + (1 + eta)*p^2 + (kappa + 1 - beta)*p + kappa")
        .with("eta", &Expression::from(&groups.inertial_parameter))
        .with("kappa", &Expression::from(&groups.stiffness_group))
        .with("beta", &Expression::from(&groups.effect_ratio));
    Proof::new(
        "dimensionless-groups",
        "With s = p V_0/D_c, η = M V_0²/(σ a D_c), κ = K D_c/(a σ) and β = b/a, eq 8 is η p³ \
             + (1 + η) p² + (κ + 1 − β) p + κ = 0.",
    )
    .identity(
        "η of the text",
        &["inertial-parameter"],
        &Expression::from(&groups.inertial_parameter),
        &equations.right("inertial-parameter"),
        &any(),
    )?
    .identity(
        "eq 8 times D_c²/(a V_0) against the program's dimensionless cubic",
        &["8"],
        &scaled,
        &cubic,
        &any(),
    )?
    .identity("the same cubic written in η, κ, β", &["8"], &scaled, &named, &any())?
    .identity(
        "eq 8 times σ against the program's cubic in s",
        &["8"],
        &(equations.residual("8") * formula("sigma")),
        &physical,
        &any(),
    )
}

/// The parameters as symbols.
pub(super) fn symbolic_parameters() -> Parameters<RationalFunction> {
    Parameters::from(["a", "b", "D_c", "K", "M", "sigma", "V_0"].map(RationalFunction::variable))
}

/// Σ coefficients[k]·variable^k.
fn polynomial(coefficients: &[RationalFunction], variable: &'static str) -> Expression {
    let term = |(power, coefficient): (usize, &RationalFunction)| {
        Expression::from(coefficient) * Expression::variable(variable).power(power as i32)
    };
    coefficients.iter().enumerate().map(term).fold(Expression::integer(0), |sum, part| sum + part)
}

/// The determinant of two equations that are linear in Δδ and Δθ and their derivatives, on solutions e^(st).
fn determinant(first: &Expression, second: &Expression) -> Expression {
    let entry = |equation: &Expression, kept: &'static str, dropped: &'static str| {
        exponential(equation).with(kept, &formula("1")).with(dropped, &formula("0"))
    };
    let (position, state) = ("Delta_delta", "Delta_theta");
    entry(first, position, state) * entry(second, state, position)
        - entry(first, state, position) * entry(second, position, state)
}

/// Derivatives of perturbations proportional to e^(st): every prime is a factor s.
fn exponential(equation: &Expression) -> Expression {
    let primed: BTreeMap<Symbol, Expression> = equation
        .variables()
        .into_iter()
        .filter(|name| name.derivative_order() > 0)
        .map(|name| {
            let factor = Expression::variable("s").power(name.derivative_order() as i32);
            let base = Expression::Variable(name.undifferentiated());
            (name, factor * base)
        })
        .collect();
    equation.substitute(&primed)
}
