//! Where the complex pair has a stated damping ratio ζ = −Re(s)/|s|.
//!
//! D = A⁴·Π((sᵢ + sⱼ)² − 4ζ²sᵢsⱼ) is a polynomial in the coefficients and in 1 − 4ζ². At ζ = 0 it is the square of the transition, and at
//! ζ = ±1 the discriminant. For 0 < |ζ| < 1 and real roots it is not zero. For roots −q, x ± iy it is zero where −x/r = ±ζ with r = |x + iy|,
//! and where r = q and −x/r = 2ζ² − 1, which is no solution. The sign of ζ is that of K − K_c.

use rug::{Complete, Rational};

use crate::number::Field;
use crate::stability::inverse::family::Family;
use crate::stability::inverse::root::Root;

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
