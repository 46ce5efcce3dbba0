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

use super::notation::formula;
use super::stated_proofs::{add_block, stated_domain};
use super::{Equations, Role};
use slipmode_algebra::{Expression, Proof, Refutation};
use slipmode_core::friction::EvolutionLaw;

/// The equations from which the coefficient is derived.
pub const EQUATIONS: [Role; 6] =
    [Role::Friction, Role::AgingLaw, Role::SlipLaw, Role::Motion, Role::Characteristic, Role::SteadyState];

/// The cubic coefficient on K = K_c and what follows from it, as functions of `eta` and `omega` = √(β − 1).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HopfCoefficient {
    /// Re c_1 of w' = iω w + c_1 w |w|², ω times the first Lyapunov coefficient.
    pub real_part: Expression,
    /// A²/(K/K_c − 1) to leading order, A the amplitude of ln(V/V_l) along the cycle. The cycle exists on the side of
    /// K = K_c on which A² > 0.
    pub square_amplitude: Expression,
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
    let [real, imaginary] = ["real_part", "imaginary_part"].map(|name| closed_form::stated(name, law));
    let stated = real.clone() + formula("i") * imaginary;
    let proof = proof.identity("c_1 in closed form", &used, &derived, &stated, &slider::on_transition())?;
    let proof = slider::crossing_speed(proof, equations)?;
    let (proof, cycle) = lindstedt::cycle(proof, equations, law)?;
    let proof = compare(proof, &used, law, &cycle)?;
    let proof = closed_form::sign(proof, of_law, law)?;
    Ok(HopfCoefficient {
        real_part: real,
        square_amplitude: closed_form::stated("square_amplitude", law),
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
        EvolutionLaw::Aging => {
            stated_domain("on the transition where it is not degenerate with the aging law")
        }
    };
    let lindstedt::Cycle { stiffness, frequency } = cycle;
    let square = formula("kappa") / stiffness.clone();
    let slope = formula("kappa") * frequency.clone() / stiffness.clone();
    let [stated_square, stated_slope] =
        ["square_amplitude", "frequency_slope"].map(|name| closed_form::stated(name, law));
    let routes = [
        ("(κ − κ_c)/A²: both routes agree", stiffness, closed_form::stiffness_shift(law), &domain),
        ("(Ω − ω)/A²: both routes agree", frequency, closed_form::frequency_shift(law), &domain),
        ("A²/(K/K_c − 1)", &square, stated_square, &hyperbolic),
        ("(Ω − ω)/(K/K_c − 1)", &slope, stated_slope, &hyperbolic),
    ];
    let proof = add_block(proof, "cycle-of-the-normal-form")?;
    routes.into_iter().try_fold(proof, |proof, (says, derived, stated, domain)| {
        proof.identity(says, used, derived, &stated, domain)
    })
}

#[cfg(test)]
mod tests;
