//! Where the complex pair has a stated angular frequency ω.
//!
//! R(ω) = A⁴·Π(4ω² + (sᵢ − sⱼ)²) = Δ + 4ω²H² + 32ω⁴A²H + 64ω⁶A⁴, with A the leading coefficient and H = c2² − 3c1c3. For
//! real roots R > 0. For roots −q, x ± iy it is zero at ω = y, and at ω = y/2 where also x = −q, which is no solution.

use rug::Rational;

use super::Target;
use crate::number::{Ball, Field, Interval};
use crate::roots;
use crate::stability::inverse::family::{Family, lead, spread};
use slipmode_algebra::{
    IsolatingInterval, Monomial, Polynomial, Symbol, UnivariatePolynomial, discriminant, horner,
};

/// R as a polynomial in ω², each coefficient a polynomial in the unknown.
#[derive(Debug)]
pub(super) struct FrequencyCondition {
    by_power: [UnivariatePolynomial; 4],
}

impl FrequencyCondition {
    pub(super) fn new(family: &Family) -> Self {
        let by_power = [
            family.along(4, |_, cubic| roots::discriminant(cubic)),
            family.along(4, |_, cubic| spread(cubic).square() * 4_u32),
            family.along(4, |_, cubic| lead(cubic).square() * spread(cubic) * 32_u32),
            family.along(4, |_, cubic| lead(cubic).square().square() * 64_u32),
        ];
        Self { by_power }
    }

    /// R at this ω².
    pub(super) fn at(&self, square: &Rational) -> UnivariatePolynomial {
        self.by_power.iter().rev().fold(UnivariatePolynomial::from_integers(&[]), |sum, coefficient| {
            sum.scaled(square).plus(coefficient)
        })
    }

    /// The coefficients of R at an enclosed ω².
    pub(super) fn enclosed(&self, square: &Ball) -> Vec<Ball> {
        let bits = square.precision_bits();
        let length = self.by_power.iter().map(|part| part.coefficients().len()).max().unwrap_or(0);
        let coefficient = |power: usize| {
            let parts = self.by_power.iter().map(|part| part.coefficients().get(power));
            horner(
                parts
                    .map(|part| part.map_or(Ball::from(0), |value| Ball::from_rational(value, bits)))
                    .collect(),
                square,
            )
        };
        (0..length).map(coefficient).collect()
    }

    /// The polynomials in ω² at whose zeros the number of positive solutions can change.
    pub(super) fn changes(&self) -> [UnivariatePolynomial; 3] {
        let [solution, square] = ["x", "w"].map(Symbol::from);
        let powers = || self.by_power.iter().flat_map(|part| part.coefficients().iter().enumerate());
        // Where V0 is the unknown, only even powers occur, and V0² serves as well.
        let step = if powers().any(|(power, value)| power % 2 == 1 && *value != 0) { 1 } else { 2 };
        let mut all = Polynomial::zero();
        for (part, of_square) in self.by_power.iter().zip(0..) {
            for (value, power) in part.coefficients().iter().step_by(step).zip(0..) {
                let monomial = Monomial::power(&solution, power).times(&Monomial::power(&square, of_square));
                all = &all + &Polynomial::term(value.clone(), monomial);
            }
        }
        let ends = all.coefficients(&solution);
        let [first, last] = [ends.first(), ends.last()].map(|end| end.cloned().unwrap_or_default());
        [discriminant(&all, &solution), first, last].map(|polynomial| {
            let constant = |part: Polynomial| part.as_constant().unwrap_or_default();
            UnivariatePolynomial::new(polynomial.coefficients(&square).into_iter().map(constant).collect())
        })
    }

    /// Intervals with one solution each and none elsewhere; `None` when ω² is not known well enough.
    pub(super) fn brackets(
        &self,
        changes: &[UnivariatePolynomial; 3],
        square: &Ball,
    ) -> Option<Vec<(Rational, Rational)>> {
        let (below, above) = (square.lower().to_rational()?, square.upper().to_rational()?);
        if changes.iter().any(|change| change.evaluate(&below) == 0 || change.count_roots(&below, &above) > 0)
        {
            return None;
        }
        let coefficients = self.enclosed(square);
        let sign = |x: &Rational| {
            horner(coefficients.clone(), &Ball::from_rational(x, square.precision_bits())).sign()
        };
        // As many changes of sign as solutions: each interval has one.
        let bracket = |interval| match interval {
            IsolatingInterval::Between(lower, upper) => {
                let is_certain = sign(&lower)?.reverse() == sign(&upper)?;
                is_certain.then_some((lower, upper))
            }
            IsolatingInterval::Exact(_) => None,
        };
        self.at(&below).isolate_positive_roots().into_iter().map(bracket).collect()
    }
}

/// (2πf)².
pub(super) fn squared_angular_frequency(frequency: &Rational, bits: u32) -> Ball {
    (Ball::pi(bits) * Ball::from_rational(&Rational::from(frequency * 2_u32), bits)).square()
}

/// The angular frequency of a target, 1/s; 0 for the boundary.
pub(super) fn angular_frequency(target: &Target) -> Interval {
    let tau = std::f64::consts::TAU;
    match target {
        Target::AngularFrequency(frequency) => Interval::enclosing(frequency),
        Target::Frequency(frequency) => {
            Interval::enclosing(frequency) * Interval { low: tau.next_down(), high: tau.next_up() }
        }
        Target::GrowthRate(_) | Target::Boundary | Target::FrequencyRatio(_) => Interval::point(0.0),
    }
}
