//! By how much the regularised friction law μ = a asinh(V/(2V0) exp((μ0 + b ln(V0θ/D_c))/a)) changes the linear analysis.

use rug::Rational;
use rug::ops::Pow;

use crate::notation::{any, formula, given_positive, in_parameters};
use slipmode_algebra::{Certificate, Domain, Expression, Proof, Refutation};

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
    let gap = formula("1 - (1 - z/2)^2*(1 + z)");
    let below_three = given_positive(Domain::positive("z"), "3 - z", &[]);
    let domain = in_parameters(below_three, &[("z", "3/(1 + w)", "w", "(3 - z)/z")]);
    let exponent = Rational::from(reference_friction * 2) / direct_effect;
    // A whole exponent and 2.718 < e keep the bound a rational number.
    let whole = exponent.clone().floor().numer().to_u32().unwrap_or(0).min(MAX_EXPONENT);
    let bound = Rational::from(2) / Rational::from((2_718, 1_000)).pow(whole);
    let log10_bound = power_of_ten_above(&bound);
    let margin = Expression::Number(Rational::from(10).pow(log10_bound) - bound);
    let terms = formula("1 + y + y^2/2 + y^3/6 + y^4/24 + y^5/120 + y^6/720");
    let e = terms.with("y", &formula("1")) - formula("2718/1000");
    let rest = formula("exp(y)") - terms;
    let statement = format!(
        "The factor φ of the regularised law differs from 1 by less than 10^{log10_bound} for μ0 = {reference_friction} and a = {direct_effect}."
    );
    let proof = Proof::new("difference-of-the-regularised-law", statement)
        .identity(
            "φ² = 1/(1 + z) with z = 1/u²",
            &[],
            &formula("(u/sqrt(1 + u^2))^2"),
            &formula("1/(1 + 1/u^2)"),
            &Domain::positive("u"),
        )?
        .identity(
            "z = 4 e^(−2μ0/a) at u = e^(μ0/a)/2",
            &[],
            &formula("1/u^2").with("u", &formula("exp(mu_0/a)/2")),
            &formula("4/exp(mu_0/a)^2"),
            &any(),
        )?
        .positive("1/√(1 + z) > 1 − z/2 for 0 < z < 3, squared: 1 − (1 − z/2)²(1 + z)", &[], &gap, &domain)?
        .growth("e^y exceeds its first seven terms for y > 0", &[], (&rest, "y", 7), &Domain::positive("y"))?
        .positive("these terms at y = 1 exceed 2.718: so e does", &[], &e, &Domain::default())?
        .certify(
            &format!(
                "10^{log10_bound} exceeds 2/2.718^{whole} > 2 e^(−2μ0/a) for μ0 = \
             {reference_friction}, a = {direct_effect}"
            ),
            &[],
            Certificate::Sign { expression: margin, sign: 1, domain: Domain::default() },
        )?;
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
