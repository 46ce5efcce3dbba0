//! The natural angular frequency and period with rational bounds of π (claim Q5).

use rug::Rational;

use super::PaperEquations;
use super::notation::formula;
use crate::polynomial::{Domain, Expression, Proof, Refutation};

/// ω_n for given K and M, and rational bounds of the natural period.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NaturalPeriod {
    /// ω_n, 1/s, when K/M is the square of a rational number.
    pub natural_angular_frequency_per_s: Expression,
    /// Bounds of 2π/ω_n, s.
    pub period_s: [Rational; 2],
    /// The proof.
    pub proof: Proof,
}

/// ω_n = √(K/M) and 2π/ω_n for a stiffness and a mass whose ratio is a square.
///
/// # Errors
/// When √(K/M) is not rational, or the text's ω_n is another expression.
pub fn natural(
    equations: &PaperEquations,
    stiffness: &Rational,
    mass: &Rational,
) -> Result<NaturalPeriod, Refutation> {
    let proof = Proof::new("natural-period", "");
    let frequency = equations
        .right("natural-frequency")
        .with("K", &Expression::Number(stiffness.clone()))
        .with("M", &Expression::Number(mass.clone()));
    let value = super::notation::rational(&proof, &["natural-frequency"], &frequency, &Domain::default())?;
    let Some(omega) = value.as_constant().filter(Rational::is_positive) else {
        return Err(proof.refute(
            "√(K/M) is rational",
            &["natural-frequency"],
            Expression::from(&value).to_string(),
        ));
    };
    let period_s = pi_bounds().map(|pi| Rational::from(2) * pi / &omega);
    let natural = Expression::Number(omega);
    let squared = formula("K/M")
        .with("K", &Expression::Number(stiffness.clone()))
        .with("M", &Expression::Number(mass.clone()));
    let arctangents = formula("(5 + i)^4*(239 - i)");
    let statement = format!(
        "ω_n = {natural} /s, and the natural period lies between {} and {} s.",
        Expression::Number(period_s[0].clone()),
        Expression::Number(period_s[1].clone())
    );
    let proof = proof
        .identity(
            "ω_n² = K/M",
            &["natural-frequency"],
            &natural.clone().power(2),
            &squared,
            &Domain::default(),
        )?
        .identity(
            "π/4 = 4 arctan(1/5) − arctan(1/239), from the arguments of complex numbers",
            &[],
            &arctangents,
            &formula("114244*(1 + i)"),
            &Domain::default(),
        )?
        .reason("Partial sums of the alternating series of both arctangents enclose π.");
    Ok(NaturalPeriod {
        natural_angular_frequency_per_s: natural,
        period_s,
        proof: Proof { statement, ..proof },
    })
}

/// Rational bounds of π by Machin's formula, rounded outward to nine decimals.
fn pi_bounds() -> [Rational; 2] {
    let [low_5, high_5] = arctangent_bounds(5);
    let [low_239, high_239] = arctangent_bounds(239);
    let scale = Rational::from(1_000_000_000);
    let low: Rational = low_5 * 16 - high_239 * 4;
    let high: Rational = high_5 * 16 - low_239 * 4;
    [(low * &scale).floor() / &scale, (high * &scale).ceil() / &scale]
}

/// Bounds of arctan(1/n) from two neighbouring partial sums of Σ (−1)^k/((2k+1) n^(2k+1)).
fn arctangent_bounds(n: i32) -> [Rational; 2] {
    let square = Rational::from(n) * n;
    let mut power = Rational::from((1, n));
    let mut sums = [Rational::new(), Rational::new()];
    for k in 0..8 {
        let term = Rational::from(&power / (2 * k + 1));
        let next =
            if k % 2 == 0 { Rational::from(&sums[1] + &term) } else { Rational::from(&sums[1] - &term) };
        sums = [sums[1].clone(), next];
        power /= &square;
    }
    let [before, last] = sums;
    // The last term was subtracted, so the last sum is the lower one.
    [last, before]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::nearest_f64;

    #[test]
    fn bounds_enclose_pi() {
        let [low, high] = pi_bounds();
        assert!(
            low < high
                && nearest_f64(&low) <= std::f64::consts::PI
                && std::f64::consts::PI <= nearest_f64(&high)
        );
        assert!(nearest_f64(&(high - low)) < 3e-9);
    }
}
