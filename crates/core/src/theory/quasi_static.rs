//! The slider without inertia: eqs 12 and 14-16.

use super::Equations;
use super::notation::{any, coefficients, formula, neutral, strengthening, weakening};
use crate::polynomial::{Expression, Proof, Refutation};

/// Eq 8 at M = 0 is eq 14; its roots are imaginary where K is the quasi-static critical stiffness.
///
/// # Errors
/// When eq 14 is another equation.
pub fn reduced_equation(equations: &Equations) -> Result<Proof, Refutation> {
    let massless = equations.residual("8").with("M", &formula("0"));
    let proof = Proof::new(
        "quasi-static-equation",
        "Eq 8 at M = 0 is eq 14, whose roots are imaginary exactly at K = K_c,qs.",
    )
    .identity("eq 8 at M = 0", &["8", "14"], &massless, &equations.residual("14"), &any())?;
    let [_, middle, _]: [Expression; 3] = coefficients(&proof, &["14"], &massless, "s")?;
    let at_critical = middle.with("K", &equations.right("10"));
    proof.identity("the middle coefficient at K = K_c,qs", &["10", "14"], &at_critical, &formula("0"), &any())
}

/// For M = 0 the roots are complex exactly between the normal stresses of eqs 16 and 15 (claim B2).
///
/// # Errors
/// When the discriminant vanishes elsewhere.
pub fn vanishing_frequency(equations: &Equations) -> Result<Proof, Refutation> {
    let (upper, lower) = (equations.right("15"), equations.right("16"));
    let proof = Proof::new(
        "quasi-static-boundary",
        "For M = 0 the discriminant in s vanishes at the normal stresses of eqs 15 and 16 and \
             nowhere else; the roots are complex exactly between them. For a = b there is no \
             upper one: complex for every σ above eq 16.",
    )
    .using(reduced_equation(equations)?);
    let [c0, c1, c2]: [Expression; 3] =
        coefficients(&proof, &["8"], &equations.residual("8").with("M", &formula("0")), "s")?;
    let discriminant = (c1.power(2) - formula("4") * c2 * c0) * formula("sigma^2*D_c^2");
    let between = |upper: &Expression, lower: &Expression| {
        formula("(b - a)^2") * (formula("sigma") - upper.clone()) * (formula("sigma") - lower.clone())
    };
    let single = formula("4*a*K*D_c") * (lower.clone() - formula("sigma"));
    let used = ["8", "15", "16"];
    let product = between(&upper, &lower);
    proof
        .identity("discriminant times (σ D_c)² for a < b", &used, &discriminant, &product, &weakening())?
        .identity("the same for a > b", &used, &discriminant, &product, &strengthening())?
        .identity(
            "the same for a = b",
            &["8", "16"],
            &discriminant.with("b", &formula("a")),
            &single.with("b", &formula("a")),
            &neutral(),
        )?
        .positive("eq 15 lies above eq 16", &["15", "16"], &(upper - lower), &weakening())
}
