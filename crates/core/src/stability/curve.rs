//! The boundary max Im(s) = 0 as a rational curve: the groups at which eq 8 has a given double root.

use crate::number::Field;

/// A connected piece of the boundary in the (V0, σ) plane.
///
/// ```
/// use slipmode_core::{Arc, Asymptote};
///
/// assert_eq!(Asymptote::quasi_static(Arc::Lower).as_str(), "eq16");
/// assert_eq!(Asymptote::InertialUpper.arc(), Arc::Upper);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Arc {
    /// From eq 15 (V0 → 0) to eq 18 (V0 → ∞), around the area of high normal stress; none for a = b.
    ///
    /// The double root lies between 0 and √β − 1: positive (unstable) for a < b, negative (stable) for a > b.
    Upper,
    /// From eq 16 (V0 → 0) through the cusp to eq 20 (σ → 0), around the area of low normal stress.
    ///
    /// The double root is below −1 − √β, so that this arc is stable.
    Lower,
}

impl Arc {
    /// `upper` or `lower`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Upper => "upper",
            Self::Lower => "lower",
        }
    }
}

/// η at which p = r is a double root of eq 8: η(r) = (β − (r+1)²)/(2r(r+1)²).
#[must_use]
pub fn inertial_parameter<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    (effect_ratio.clone() - &square) / (R::from(2) * double_root * &square)
}

/// κ at which p = r is a double root of eq 8: κ(r) = r((2r+1)β − (r+1)²)/(2(r+1)²).
#[must_use]
pub fn stiffness_group<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    double_root.clone() * (stretched(double_root, effect_ratio) - &square) / (R::from(2) * &square)
}

/// The third root next to the double root r: t(r) = ((2r+1)β − (r+1)²)/((r+1)² − β).
#[must_use]
pub fn third_root<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    let square = (double_root.clone() + R::from(1)).square();
    (stretched(double_root, effect_ratio) - &square) / (square - effect_ratio)
}

/// (2r+1)β.
fn stretched<R: Field>(double_root: &R, effect_ratio: &R) -> R {
    (R::from(2) * double_root + R::from(1)) * effect_ratio
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;
    use crate::friction::Groups;

    proptest! {
        #[test]
        fn the_cubic_on_the_curve_is_the_product_of_its_factors(
            numerator in -400_i32..400, denominator in 1_i32..50, beta in 1_i32..4_000,
        ) {
            let r = Rational::from((numerator, denominator));
            let beta = Rational::from((beta, 100));
            let shifted = Rational::from(&r + 1).square();
            prop_assume!(r != 0 && shifted != 0 && shifted != beta);
            let t = third_root(&r, &beta);
            let groups = Groups {
                inertial_parameter: inertial_parameter(&r, &beta),
                stiffness_group: stiffness_group(&r, &beta),
                effect_ratio: beta,
            };
            let [c0, c1, c2, c3] = groups.characteristic_cubic();
            // (p − r)²(p − t)·η, coefficient by coefficient.
            prop_assert_eq!(c0, -(r.clone().square() * &t) * &c3);
            prop_assert_eq!(c1, (r.clone().square() + Rational::from(2) * &r * &t) * &c3);
            prop_assert_eq!(c2, -(Rational::from(2) * &r + &t) * &c3);
        }
    }
}
