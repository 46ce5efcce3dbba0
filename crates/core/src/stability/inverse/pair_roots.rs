//! The solutions at which the complex pair has a stated frequency or damping ratio.

use std::sync::Arc;

use rug::{Complete, Rational};

use super::Undecided;
use super::family::{Family, lead, skew, spread};
use super::frequency::{FrequencyCondition, squared_angular_frequency};
use super::root::Root;
use crate::number::Field;
use crate::roots;
use slipmode_algebra::MOST_BITS;

/// Precision of the first attempt, in bits.
const FIRST_BITS: u32 = 128;

impl FrequencyCondition {
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

/// Where the complex pair has a stated damping ratio ζ = −Re(s)/|s|.
///
/// D = A⁴·Π((sᵢ + sⱼ)² − 4ζ²sᵢsⱼ) is a polynomial in the coefficients and in 1 − 4ζ². At ζ = 0 it is the square of the transition, and at
/// ζ = ±1 the discriminant. For 0 < |ζ| < 1 and real roots it is not zero. For roots −q, x ± iy it is zero where −x/r = ±ζ with r = |x + iy|,
/// and where r = q and −x/r = 2ζ² − 1, which is no solution. The sign of ζ is that of K − K_c.
pub(super) fn at_squared_ratio(family: &Family, squared_ratio: &Rational) -> Vec<Root> {
    let share = Rational::from(1) - Rational::from(squared_ratio * 4_u32);
    let condition = family.along(4, |_, [e, c, b, a]| {
        let [ends, middle] = [Rational::from(a * e), Rational::from(b * c)];
        let cubes = c.square() * c * a + b.square() * b * e;
        let product = Rational::from(&ends * &middle);
        let of_share = cubes.clone() - product.clone() * 3_u32;
        ((ends.square() * &share + product) * &share + of_share) * &share + middle.square() - cubes
    });
    let square = share.square_ref().complete();
    // r = q, and c/A = (4ζ² − 1)q², b/A = (4ζ² − 1)q.
    let equal = family.along(4, |_, [e, c, b, a]| c.square() * c * a - b.square() * b * e);
    let sum =
        family.along(2, |_, [e, c, b, a]| Rational::from(b * c) - square.clone() * Rational::from(a * e));
    let spurious = equal.gcd(&sum);
    Root::all_of(&condition).into_iter().filter(|root| !root.is_root_of(&spurious)).collect()
}
