//! The discriminant of a cubic: its sign says whether the roots are real, and whether two coincide.

use crate::number::Field;

/// Δ = c3⁴·Π(rᵢ − rⱼ)² = 18c3c2c1c0 − 4c2³c0 + c2²c1² − 4c3c1³ − 27c3²c0².
///
/// Positive when the three roots are real and distinct, negative for a complex pair, zero for a multiple root.
#[must_use]
#[inline(always)]
pub fn discriminant<R: Field>([c0, c1, c2, c3]: &[R; 4]) -> R {
    let outer = c0.clone() * c3;
    let inner = c1.clone() * c2;
    let mixed = R::from(18) * &outer * &inner;
    mixed + inner.square()
        - R::from(4) * (c2.square() * c2 * c0 + c1.square() * c1 * c3)
        - R::from(27) * outer.square()
}

/// The sum of the magnitudes of Δ's terms, which bounds its rounding error.
#[inline(always)]
pub(super) fn discriminant_of_magnitudes([m0, m1, m2, m3]: &[f64; 4]) -> f64 {
    let (outer, inner) = (m0 * m3, m1 * m2);
    (18.0 * outer * inner + inner * inner)
        + 4.0 * (m2 * m2 * m2 * m0 + m1 * m1 * m1 * m3)
        + 27.0 * outer * outer
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Rational;

    proptest! {
        #[test]
        fn it_is_the_product_of_squared_differences_of_the_roots(
            roots in prop::array::uniform3(-50i32..50), lead in prop_oneof![-9i32..0, 1i32..9],
        ) {
            let [a, b, c] = roots.map(Rational::from);
            let lead = Rational::from(lead);
            let cubic = [
                -lead.clone() * &a * &b * &c,
                (a.clone() * &b + b.clone() * &c + c.clone() * &a) * &lead,
                -(a.clone() + &b + &c) * &lead,
                lead.clone(),
            ];
            let differences = (a.clone() - &b) * (b - &c) * (c - &a);
            prop_assert_eq!(discriminant(&cubic), differences.square() * lead.square().square());
        }
    }
}
