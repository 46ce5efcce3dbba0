//! By how much the regularised friction law μ = a asinh(V/(2V0) exp((μ0 + b ln(V0θ/D_c))/a)) changes the linear analysis.

use rug::Rational;
use rug::ops::Pow;

use crate::stated_proofs::add_block;
use slipmode_algebra::{Domain, Expression, Proof, Refutation};

/// By how much the regularised law changes the linear analysis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RegularisedDifference {
    /// The relative change of a and of b (equivalently of σ) is positive and less than 10 to this power.
    pub log10_bound: i32,
    /// The proof.
    pub proof: Proof,
}

/// A certified bound of the relative difference 1 − φ < 2 e^(−2μ0/a) for these numbers, φ = u/√(1 + u²) with u = e^(μ0/a)/2.
///
/// # Errors
/// When a step does not hold.
pub fn bound(
    reference_friction: &Rational,
    direct_effect: &Rational,
) -> Result<RegularisedDifference, Refutation> {
    let exponent = Rational::from(reference_friction * 2) / direct_effect;
    // A whole exponent and 2.718 < e keep the bound a rational number.
    let whole = exponent.clone().floor().numer().to_u32().unwrap_or(0).min(MAX_EXPONENT);
    let bound = Rational::from(2) / Rational::from((2_718, 1_000)).pow(whole);
    let log10_bound = power_of_ten_above(&bound);
    let margin = Expression::Number(Rational::from(10).pow(log10_bound) - bound);
    let statement = format!(
        "The factor φ of the regularised law differs from 1 by less than 10^{log10_bound} for μ0 = {reference_friction} and a = {direct_effect}."
    );
    let says = format!(
        "10^{log10_bound} exceeds 2/2.718^{whole} > 2 e^(−2μ0/a) for μ0 = {reference_friction}, a = {direct_effect}"
    );
    let proof = Proof::new("difference-of-the-regularised-law", statement);
    let proof = add_block(proof, "factor-of-the-regularised-law")?;
    let proof = proof.positive(&says, &[], &margin, &Domain::default())?;
    Ok(RegularisedDifference { log10_bound, proof })
}

/// The largest exponent of e that the bound uses: enough for a difference far below anything measurable.
const MAX_EXPONENT: u32 = 2_000;

/// The least n with value < 10^n, for 0 < value.
fn power_of_ten_above(value: &Rational) -> i32 {
    let mut power = 1;
    while Rational::from(10).pow(power - 1) > *value {
        power -= 1;
    }
    power
}
