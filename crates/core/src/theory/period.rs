//! The natural angular frequency and period with rational bounds of π.

use rug::Rational;

use super::Equations;
use super::notation::formula;
use slipmode_algebra::{Domain, Expression, Proof, Refutation, Symbol};

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
    equations: &Equations,
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
    let [low, high] = pi_bounds().map(Expression::Number);
    let statement = format!(
        "ω_n = {natural} /s, and the natural period lies between {} and {} s.",
        Expression::Number(period_s[0].clone()),
        Expression::Number(period_s[1].clone())
    );
    let slope = |terms| formula("1/(1 + x^2)") - partial_sum(terms).derivative(&Symbol::from("x"));
    let positive = Domain::positive("x");
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
            &formula("(5 + i)^4*(239 - i)"),
            &formula("114244*(1 + i)"),
            &Domain::default(),
        )?
        .positive(
            "arctan x minus 8 terms of its series is zero at 0 and has this slope",
            &[],
            &slope(8),
            &positive,
        )?
        .negative("minus 7 terms: this slope, so that both sums enclose arctan x", &[], &slope(7), &positive)?
        .positive("lower bound of π less its own bound", &[], &(machin(8, 7) - low), &Domain::default())?
        .positive("bound of π less its upper bound", &[], &(high - machin(7, 8)), &Domain::default())?;
    Ok(NaturalPeriod {
        natural_angular_frequency_per_s: natural,
        period_s,
        proof: Proof { statement, ..proof },
    })
}

/// Rational bounds of π by Machin's formula, rounded outward to nine decimals.
fn pi_bounds() -> [Rational; 2] {
    let scale = Rational::from(1_000_000_000);
    let value = |sum: Expression| Domain::default().rational_function(&sum).ok()?.as_constant();
    // A sum of numbers has a value; the certificates of both bounds would refuse any other.
    let [low, high] = [machin(8, 7), machin(7, 8)].map(|sum| value(sum).unwrap_or_default() * &scale);
    [low.floor() / &scale, high.ceil() / &scale]
}

/// 16 arctan(1/5) − 4 arctan(1/239), each by so many terms of its series.
fn machin(terms_of_first: i32, terms_of_second: i32) -> Expression {
    let at = |terms, place: &str| partial_sum(terms).with("x", &formula(place));
    formula("16") * at(terms_of_first, "1/5") - formula("4") * at(terms_of_second, "1/239")
}

/// The first terms of arctan x = Σ (−1)^k x^(2k+1)/(2k+1): an even number of them is a lower bound for x > 0.
fn partial_sum(terms: i32) -> Expression {
    (0..terms).fold(formula("0"), |sum, k| {
        let term = Expression::variable("x").power(2 * k + 1) / Expression::integer(2 * k + 1);
        if k % 2 == 0 { sum + term } else { sum - term }
    })
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
