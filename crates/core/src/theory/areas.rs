//! How many areas of the (V, σ) plane have max Im(s) = 0, and which of the four kinds of area exist.

use super::boundary::cubic_discriminant;
use super::notation::{any, formula, in_groups};
use super::real_roots::{by_roots, case, lower_area, upper_area};
use super::{Equations, boundary, transition};
use slipmode_algebra::{Domain, Expression, Proof, Refutation};

slipmode_algebra::named! {
    /// Which of a and b is the larger one.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Effects {
        /// a < b: velocity weakening.
        Weakening = "a < b",
        /// a = b: velocity neutral.
        Neutral = "a = b",
        /// a > b: velocity strengthening.
        Strengthening = "a > b",
    }
}

/// The areas of one case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Areas {
    /// Which of a and b is larger.
    pub effects: Effects,
    /// The number of separate areas in which all roots are real.
    pub real_areas: usize,
    /// How many of them are unstable.
    pub unstable_real_areas: usize,
    /// Which of the paper's areas (i)-(iv) exist, in that order.
    pub exists: [bool; 4],
    /// The proof.
    pub proof: Proof,
}

/// Counts the areas max Im(s) = 0 and finds which of (i)-(iv) exist (claims B1 and B9).
///
/// # Errors
/// When eq 8 does not have the form that the count rests on.
pub fn count(equations: &Equations, effects: Effects) -> Result<Areas, Refutation> {
    let id = format!("areas-for-{}", format!("{effects:?}").to_lowercase());
    let proof = by_roots(Proof::new(&id, ""), equations)?;
    let proof = upper_area(lower_area(proof, equations)?, equations, effects)?;
    let proof = complex_points(plane(separate(proof)?, equations)?, equations, effects)?;
    let (upper, unstable) = (effects != Effects::Neutral, effects == Effects::Weakening);
    let kind = match effects {
        Effects::Weakening => "and an unstable one at high σ",
        Effects::Neutral => "and none at high σ",
        Effects::Strengthening => "and a stable one at high σ",
    };
    let real_areas = 1 + usize::from(upper);
    let statement = format!(
        "For {} the (V, σ) plane has {real_areas} separate area(s) with max Im(s) = 0: a \
             stable one at low σ, {kind}. Of the areas (i)-(iv), {} exist.",
        effects.as_str(),
        if unstable { "all" } else { "only (i) and (ii)" }
    );
    Ok(Areas {
        effects,
        real_areas,
        unstable_real_areas: usize::from(unstable),
        exists: [true, true, unstable, unstable],
        proof: Proof { statement, ..proof },
    })
}

/// F'(−1) and F''(−1) are positive in the lower area; in the upper one they are not both: open sets without a common point.
fn separate(proof: Proof) -> Result<Proof, Refutation> {
    let pairs = formula("x_1*x_2 + x_1*x_3 + x_2*x_3");
    let upper =
        |expression: &Expression| expression.with("x_1", &formula("-y_1")).with("x_2", &formula("-y_2"));
    let lower = Domain::positive("x_1 x_2 x_3");
    proof
        .positive(
            "F''(−1)/(2η) = x_1 + x_2 + x_3 in the lower area",
            &[],
            &formula("x_1 + x_2 + x_3"),
            &lower,
        )?
        .positive("F'(−1)/η = x_1 x_2 + x_1 x_3 + x_2 x_3 there", &[], &pairs, &lower)?
        .identity(
            "−F'(−1)/η in the upper area by F''(−1)/(2η) = x_3 − y_1 − y_2",
            &[],
            &(-upper(&pairs)),
            &formula("(y_1 + y_2)*(x_3 - y_1 - y_2) + (y_1^2 + y_1*y_2 + y_2^2)"),
            &Domain::default(),
        )?
        .positive(
            "its last term: F'(−1) < 0 there where F''(−1) ≥ 0",
            &[],
            &formula("y_1^2 + y_1*y_2 + y_2^2"),
            &Domain::positive("y_1 y_2"),
        )
}

/// The quadrants of (V0, σ) and of (η, κ) are mapped onto each other, continuously both ways.
fn plane(proof: Proof, equations: &Equations) -> Result<Proof, Refutation> {
    let (stress, velocity) = (formula("K*D_c/(a*kappa)"), formula("D_c*sqrt(eta*K/(kappa*M))"));
    let groups = Domain::positive("a D_c K M eta kappa");
    let [eta, kappa] = [equations.right("inertial-parameter"), formula("K*D_c/(a*sigma)")];
    let group = |group: &Expression| group.with("sigma", &stress).with("V_0", &velocity);
    let back = velocity.with("eta", &eta).with("kappa", &kappa);
    proof
        .identity("κ at σ = K D_c/(aκ)", &[], &group(&kappa), &formula("kappa"), &groups)?
        .identity(
            "η at this σ and V0 = D_c √(ηK/(κM))",
            &["inertial-parameter"],
            &group(&eta),
            &formula("eta"),
            &groups,
        )?
        .identity("and V0 from its η and κ", &[], &back, &formula("V_0"), &any())
}

/// Points with a complex pair: a stable one always, an unstable one for a < b. Transition and discriminant.
fn complex_points(proof: Proof, equations: &Equations, effects: Effects) -> Result<Proof, Refutation> {
    let discriminant = Expression::from(&cubic_discriminant(equations)?).with("eta", &formula("1"));
    let domain = case(effects);
    let complex = |proof: Proof, says: &str, kappa: &str| {
        proof.negative(says, &["8"], &discriminant.with("kappa", &formula(kappa)), &domain)
    };
    if effects != Effects::Weakening {
        let proof = proof.using(transition::intrinsically_stable(equations)?);
        return complex(proof, "the discriminant at η = κ = 1: a stable complex pair", "1");
    }
    let margin = formula("kappa") - in_groups(&equations.right("9")).with("eta", &formula("1"));
    let at = |kappa: &str| margin.with("kappa", &formula(kappa));
    let proof = proof.using(transition::stability(equations)?).using(boundary::transition_avoids(equations)?);
    let proof = complex(proof, "the discriminant at η = 1, κ = 3(β − 1): a complex pair", "3*(beta - 1)")?
        .positive("K − K_c there: stable", &["9"], &at("3*(beta - 1)"), &domain)?;
    complex(proof, "the discriminant at η = 1, κ = β − 1: a complex pair", "beta - 1")?.negative(
        "K − K_c there: unstable",
        &["9"],
        &at("beta - 1"),
        &domain,
    )
}
