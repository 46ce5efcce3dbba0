//! The polynomial equations for the double root, in every number type.

use crate::number::{Ball, Field};
use crate::stability::Arc;

/// Which group is given; the value is passed separately, in the number type of the moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::stability) enum GivenGroup {
    /// κ = K D_c/(aσ): the line has one σ.
    StiffnessGroup,
    /// g = η/κ = (V0/D_c)²·M/K: the line has one V0.
    VelocitySquared,
}

impl GivenGroup {
    /// η from the value given and the unknown, g at given κ or 1/κ at given g.
    pub(super) fn inertial_parameter(self, value: &Ball, unknown: &Ball) -> Ball {
        match self {
            Self::StiffnessGroup => value.clone() * unknown,
            Self::VelocitySquared => value.clone() / unknown,
        }
    }
}

/// The coefficients of F by ascending power of x, with e = β − 1:
///
/// | arc | κ given | g given |
/// |---|---|---|
/// | upper, x = r | −x³ + 2(e−κ)x² + (e−4κ)x − 2κ | −gx⁴ + 2gex³ + (ge+1)x² + 2x − e |
/// | lower, x = −1−r | x³ + (1+2β−2κ)x² + 3βx + β | gx⁴ + 2g(1+β)x³ + (g(1+5β)−1)x² + 4gβx + β(1+g) |
///
/// F is 2u²(κ(r) − κ) for given κ, and ±∂κ/∂r times r(e−r)u(1+gr²)/κ for given g.
pub(super) fn coefficients<R: Field>(
    arc: Arc,
    given: GivenGroup,
    value: &R,
    effect_ratio: &R,
    excess: &R,
) -> Vec<R> {
    let twice = |x: &R| x.clone() + x;
    let one = || R::from(1);
    match (arc, given) {
        (Arc::Upper, GivenGroup::StiffnessGroup) => {
            let double = twice(value);
            vec![-double.clone(), excess.clone() - twice(&double), twice(excess) - double, R::from(-1)]
        }
        (Arc::Upper, GivenGroup::VelocitySquared) => {
            let product = excess.clone() * value;
            vec![-excess.clone(), R::from(2), product.clone() + one(), twice(&product), -value.clone()]
        }
        (Arc::Lower, GivenGroup::StiffnessGroup) => {
            let double = twice(effect_ratio);
            vec![effect_ratio.clone(), double.clone() + effect_ratio, double + one() - twice(value), one()]
        }
        (Arc::Lower, GivenGroup::VelocitySquared) => {
            let product = effect_ratio.clone() * value;
            let fourfold = twice(&twice(&product));
            vec![
                product.clone() + effect_ratio,
                fourfold.clone(),
                fourfold + &product + value - one(),
                twice(&(product + value)),
                value.clone(),
            ]
        }
    }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::roots::discriminant;
    use crate::stability::ArcFrame;

    /// At a rational √β every point of the boundary with rational λ satisfies all of it exactly.
    #[test]
    fn the_double_root_of_the_rational_curve_solves_both_equations_of_its_arc() {
        for (q, numerator) in [(2, 3), (2, 30), (7, 1), (1, 5)] {
            let root_ratio = Rational::from((q, 3));
            let effect_ratio = root_ratio.clone().square();
            let excess = Rational::from(&effect_ratio - 1);
            let frame = ArcFrame::new(excess.clone(), root_ratio);
            for arc in [Arc::Upper, Arc::Lower] {
                let place = frame.point(arc, &Rational::from((numerator, 4)));
                let r = place.double_root.clone();
                let x = if arc == Arc::Upper { r.clone() } else { -(r.clone() + 1_u32) };
                for (given, value) in [
                    (GivenGroup::StiffnessGroup, &place.groups.stiffness_group),
                    (GivenGroup::VelocitySquared, &place.velocity_squared),
                ] {
                    let all = coefficients(arc, given, value, &effect_ratio, &excess);
                    let sum = all.iter().rev().fold(Rational::new(), |sum, c| sum * &x + c);
                    assert_eq!(sum, 0, "{q} {numerator} {arc:?} {given:?}");
                }
                assert_eq!(place.groups.effect_ratio, effect_ratio);
                assert_eq!(discriminant(&place.groups.characteristic_cubic()), 0);
            }
        }
    }
}
