//! The Hopf bifurcation on K = K_c: how the nonlinear slider leaves steady sliding, for either evolution law.
//!
//! With η = M V_0²/(σ a D_c), κ = K D_c/(a σ), β = b/a = 1 + ω² and time in D_c/V_0, K = K_c is κ_c = ω²(1 + η) and the
//! critical pair is ±iω. The normal form is w' = iω w + c_1 w |w|² with ln(V/V_l) = w + w̄ + …, and the first Lyapunov
//! coefficient is l_1 = Re c_1/ω. It is derived twice from eqs 1-4, by projection on the critical eigenvectors and by
//! the expansion of Lindstedt and Poincaré, and both are certified to agree.

mod closed_form;
mod evaluate;
pub(super) mod expansion;
mod lindstedt;
pub(super) mod projection;
mod slider;

pub use closed_form::Criticality;
pub use evaluate::{degenerate_inertial_parameter, square_amplitude};

use super::notation::{formula, given_nonzero, simplified};
use super::{Equations, Role};
use slipmode_algebra::{Domain, Expression, Proof, Refutation};
use slipmode_core::friction::EvolutionLaw;

/// The equations from which the coefficient is derived.
pub const EQUATIONS: [Role; 6] =
    [Role::Friction, Role::AgingLaw, Role::SlipLaw, Role::Motion, Role::Characteristic, Role::SteadyState];

/// The cubic coefficient on K = K_c and what follows from it, as functions of `eta` and `omega` = √(β − 1).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HopfCoefficient {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// The first Lyapunov coefficient l_1 = Re c_1/ω.
    pub expression: Expression,
    /// Re c_1 and Im c_1 of w' = iω w + c_1 w |w|².
    pub normal_form: [Expression; 2],
    /// A²/(K/K_c − 1) to leading order, A the amplitude of ln(V/V_l) along the cycle. The cycle exists on the side of
    /// K = K_c on which A² > 0.
    pub square_amplitude: Expression,
    /// (Ω − ω)/(K/K_c − 1) to leading order, Ω the angular frequency of the cycle in V_l/D_c.
    pub frequency_slope: Expression,
    /// Where l_1 is negative, zero and positive.
    pub sign_statement: &'static str,
    /// The proof of all that.
    pub proof: Proof,
}

/// Derives the coefficient from eqs 1, 4 and the law, by both routes, with its sign.
///
/// # Errors
/// When a step of the derivation fails or the coefficient is not the one stated; the refutation names the equations and
/// gives the exact difference.
pub fn coefficient(equations: &Equations, law: EvolutionLaw) -> Result<HopfCoefficient, Refutation> {
    let used = slider::cited(equations, law);
    let [of_law] = equations.numbers([Role::of_law(law)]);
    let id = format!("hopf-coefficient-{}-law", law.as_str());
    let statement = format!(
        "The first Lyapunov coefficient on K = K_c with the {} law: {}.",
        law.as_str(),
        closed_form::sign_statement(law)
    );
    let (proof, rates) = slider::derive(Proof::new(&id, statement), equations, law)?;
    let (proof, derived) = projection::coefficient(proof, &used, &slider::critical(rates))?;
    let [real, imaginary] = [closed_form::real(law), closed_form::imaginary(law)];
    let stated = real.clone() + formula("i") * imaginary.clone();
    let proof = proof.identity("c_1 in closed form", &used, &derived, &stated, &slider::on_transition())?;
    let proof = slider::crossing_speed(proof, equations)?;
    let (proof, cycle) = lindstedt::cycle(proof, equations, law)?;
    let proof = compare(proof, &used, law, &cycle)?;
    let proof = closed_form::quasi_static(closed_form::sign(proof, of_law, law)?, of_law, law)?;
    Ok(HopfCoefficient {
        law,
        expression: simplified(&proof, &used, &(real.clone() / formula("omega")), &slider::on_transition())?,
        normal_form: [real, imaginary],
        square_amplitude: closed_form::square_amplitude(law),
        frequency_slope: closed_form::frequency_slope(law),
        sign_statement: closed_form::sign_statement(law),
        proof,
    })
}

/// The two routes agree: what the normal form says of the cycle is what the expansion found.
fn compare(
    proof: Proof,
    used: &[&str],
    law: EvolutionLaw,
    cycle: &lindstedt::Cycle,
) -> Result<Proof, Refutation> {
    let domain = slider::on_transition();
    // A² follows from K where the coefficient is not zero.
    let hyperbolic = match law {
        EvolutionLaw::Slip => domain.clone(),
        EvolutionLaw::Aging => given_nonzero(domain.clone(), &["eta^2*(7 + 4*omega^2) + 6*eta - 1"], &[]),
    };
    of_normal_form(proof)?
        .identity(
            "(κ − κ_c)/A²: both routes agree",
            used,
            &cycle.stiffness,
            &closed_form::stiffness_shift(law),
            &domain,
        )?
        .identity(
            "(Ω − ω)/A²: both routes agree",
            used,
            &cycle.frequency,
            &closed_form::frequency_shift(law),
            &domain,
        )?
        .identity(
            "A²/(K/K_c − 1)",
            used,
            &(formula("kappa") / cycle.stiffness.clone()),
            &closed_form::square_amplitude(law),
            &hyperbolic,
        )?
        .identity(
            "(Ω − ω)/(K/K_c − 1)",
            used,
            &(formula("kappa") * cycle.frequency.clone() / cycle.stiffness.clone()),
            &closed_form::frequency_slope(law),
            &hyperbolic,
        )
}

/// A cycle w = r e^(iΩt) of w' = (iω + (P + iS) k) w + (C + iD) w |w|², k = κ − κ_c and P + iS = dp/dκ.
fn of_normal_form(proof: Proof) -> Result<Proof, Refutation> {
    let domain = given_nonzero(Domain::default(), &["C", "P", "k"], &[("C", "1"), ("P", "1"), ("k", "1")]);
    let on_cycle = |text: &str| formula(text).with("R", &formula("-P*k/C"));
    proof
        .identity(
            "normal form, c_1 = C + iD and dp/dκ = P + iS: |w| is constant at R = |w|² = −P (κ − κ_c)/C",
            &[],
            &on_cycle("P*k + C*R"),
            &formula("0"),
            &domain,
        )?
        .identity(
            "the amplitude of ln(V/V_l) = w + w̄ with w = r e^(iφ) is A = 2r",
            &[],
            &formula("r*(c + i*s) + r*(c - i*s)"),
            &formula("2*r*c"),
            &Domain::default(),
        )?
        .identity("(κ − κ_c)/A²", &[], &on_cycle("k/(4*R)"), &formula("-C/(4*P)"), &domain)?
        .identity(
            "(Ω − ω)/A², Ω − ω = S (κ − κ_c) + D |w|²",
            &[],
            &on_cycle("(S*k + D*R)/(4*R)"),
            &formula("S*(-C/(4*P)) + D/4"),
            &domain,
        )
}

#[cfg(test)]
mod tests;
