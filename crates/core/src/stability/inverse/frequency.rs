//! Where the complex pair has a stated angular frequency ω.
//!
//! R(ω) = A⁴·Π(4ω² + (sᵢ − sⱼ)²) = Δ + 4ω²H² + 32ω⁴A²H + 64ω⁶A⁴, with A the leading coefficient and H = c2² − 3c1c3. For
//! real roots R > 0. For roots −q, x ± iy it is zero at ω = y, and at ω = y/2 where also x = −q, which is no solution.

use std::sync::Arc;

use rug::Rational;

use crate::number::{Ball, Field};
use crate::roots;
use crate::stability::inverse::Undecided;
use crate::stability::inverse::family::{Family, skew, spread};
use crate::stability::inverse::root::{MOST_BITS, Root};
use slipmode_algebra::{
    IsolatingInterval, Monomial, Polynomial, Symbol, UnivariatePolynomial, discriminant, horner,
};

/// Precision of the first attempt, in bits.
const FIRST_BITS: u32 = 128;

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

    /// The solutions at ω = 2πf.
    ///
    /// Their number can change with ω² only at a zero of R's discriminant, leading or constant coefficient. These are
    /// polynomials over ℚ and not identically zero, so that none is zero at the transcendental ω². A rational below it, with
    /// no zero between the two, has the same number. For the same reason there is no zero at half the frequency: x = −q
    /// at an algebraic value of the unknown only, where ω is algebraic.
    pub(super) fn at_hertz(self, frequency: &Rational) -> Result<Vec<Root>, Undecided> {
        let changes = self.changes();
        let condition = Arc::new(self);
        let mut bits = FIRST_BITS;
        while bits <= MOST_BITS {
            let square = squared_angular_frequency(frequency, bits);
            if let Some(brackets) = condition.brackets(&changes, &square) {
                let root = |(lower, upper)| {
                    let (condition, frequency) = (Arc::clone(&condition), frequency.clone());
                    Root::AtHertz { condition, frequency, lower, upper }
                };
                return Ok(brackets.into_iter().map(root).collect());
            }
            bits *= 2;
        }
        Err(Undecided)
    }

    /// The polynomials in ω² at whose zeros the number of positive solutions can change.
    fn changes(&self) -> [UnivariatePolynomial; 3] {
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
    fn brackets(
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

/// The solutions at an ω² that depends rationally on the unknown: `scaled` is Aω². The zeros at half the frequency are left out exactly.
///
/// A·R = AΔ + 4wH² + 32w²AH + 64w³A² with w = Aω², which is linear in the coefficients of eq 8.
pub(super) fn at_square(family: &Family, scaled: impl Fn(&[Rational; 4]) -> Rational) -> Vec<Root> {
    let condition = family.along(5, |_, cubic| {
        let (lead, spread, square) = (lead(cubic), spread(cubic), scaled(cubic));
        let terms = [
            roots::discriminant(cubic) * lead,
            spread.clone().square() * &square * 4_u32,
            square.clone().square() * lead * spread * 32_u32,
            square.clone().square() * square * lead.clone().square() * 64_u32,
        ];
        terms.into_iter().fold(Rational::new(), |sum, term| sum + term)
    });
    let halved = family.along(2, |_, cubic| scaled(cubic) * lead(cubic) * 12_u32 + spread(cubic));
    let spurious = family.along(3, |_, cubic| skew(cubic)).gcd(&halved);
    Root::all_of(&condition).into_iter().filter(|root| !root.is_root_of(&spurious)).collect()
}

/// A.
fn lead([.., lead]: &[Rational; 4]) -> &Rational {
    lead
}

/// (2πf)².
pub(super) fn squared_angular_frequency(frequency: &Rational, bits: u32) -> Ball {
    (Ball::pi(bits) * Ball::from_rational(&Rational::from(frequency * 2_u32), bits)).square()
}
