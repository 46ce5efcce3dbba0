//! The 64-bit filter of slip modes along one grid row: three more polynomials in σ in addition to the two signs.
//!
//! With k, m and δ as in [`row_filter`](super::row_filter) and T = (ω/ω_n)² of the threshold, the pair oscillates above the
//! threshold where h = m·Δ + 4Tk·(c₂² − 3c₁m + 4Tkm)² < 0, Δ being the discriminant of (k, c₁, c₂, m) = (k, k + δσ, aσ + m, m):
//! −4ω² is a root of the equation of squared differences, as in [`InertialThreshold`](crate::stability::InertialThreshold),
//! whose left side at −4Tk/m is −h up to a positive factor. Like Δ, h is a quartic in σ, so the same bound holds.
//!
//! Real roots of a > b lie in the lower area where aσ > 2m and (a + b)σ < k + m. For a ≤ b there is no upper area, which two
//! constants say.

use super::GridCell;
use super::row_filter::{BoundedPolynomial, RowFilter, boundary_quartic};
use crate::number::dispatch::Kernel;
use crate::number::{Ball, Field};

/// h by ascending power of σ.
fn threshold_quartic<R: Field>(a: &R, difference: &R, k: &R, m: &R, squared_ratio: &R) -> [R; 5] {
    let integer = R::from;
    let discriminant = boundary_quartic(a, difference, k, m);
    let four_t = integer(4) * squared_ratio;
    let constant = (m.clone() + (four_t.clone() - integer(3)) * k) * m;
    let linear = (integer(2) * a - integer(3) * difference) * m;
    let leading = a.square();
    let squared = [
        constant.square(),
        integer(2) * &constant * &linear,
        linear.square() + integer(2) * &constant * &leading,
        integer(2) * &linear * &leading,
        leading.square(),
    ];
    let weight = four_t * k;
    let mut terms = discriminant.into_iter().zip(squared);
    std::array::from_fn(|_| match terms.next() {
        Some((discriminant, squared)) => discriminant * m + squared * &weight,
        None => integer(0),
    })
}

/// The polynomials of a row that give signs and slip modes.
#[derive(Debug, Clone, Copy)]
pub(super) struct ModeFilter {
    signs: RowFilter,
    threshold: BoundedPolynomial<5>,
    lower_area: [BoundedPolynomial<2>; 2],
}

impl ModeFilter {
    /// The filter for a, δ, k and m as balls, T, and σ scaled by 2^-`stress_exponent`.
    pub(super) fn new([a, difference, k, m]: [&Ball; 4], squared_ratio: &Ball, stress_exponent: i32) -> Self {
        let threshold = threshold_quartic(a, difference, k, m, squared_ratio);
        let has_upper_area = difference.lower() > 0;
        let integer = Ball::from;
        let lower_area = if has_upper_area {
            let both_effects = integer(2) * a - difference;
            [[-(integer(2) * m), a.clone()], [k.clone() + m, -both_effects]]
        } else {
            std::array::from_fn(|_| [integer(1), integer(0)])
        };
        Self {
            signs: RowFilter::new(a, difference, k, m, stress_exponent),
            threshold: BoundedPolynomial::scaled(&threshold, stress_exponent),
            lower_area: lower_area.map(|line| BoundedPolynomial::scaled(&line, stress_exponent)),
        }
    }
}

/// The inner loop over the scaled σ of a row.
pub(super) struct ModeLoop<'a> {
    pub(super) filter: &'a ModeFilter,
    pub(super) stresses: &'a [f64],
    pub(super) cells: &'a mut [GridCell],
}

impl Kernel for ModeLoop<'_> {
    #[inline(always)]
    fn run(self) {
        let filter = *self.filter;
        for (cell, &x) in self.cells.iter_mut().zip(self.stresses) {
            let (boundary, boundary_bound) = filter.signs.boundary.at(x);
            let (transition, transition_bound) = filter.signs.transition.at(x);
            let (threshold, threshold_bound) = filter.threshold.at(x);
            let (first, first_bound) = filter.lower_area[0].at(x);
            let (second, second_bound) = filter.lower_area[1].at(x);
            let (stable, real) = (transition > 0.0, boundary > 0.0);
            let signs_certain = (boundary.abs() > boundary_bound) & (transition.abs() > transition_bound);
            let area_certain = (first.abs() > first_bound) & (second.abs() > second_bound);
            let upper = !((first > 0.0) & (second > 0.0));
            // Each question counts only where the mode depends on it.
            let certain = signs_certain
                & ((threshold.abs() > threshold_bound) | real)
                & (area_certain | !(real & stable));
            let decided = GridCell::from_decided(stable, real, threshold < 0.0, upper);
            *cell = if certain { decided } else { GridCell::UNDECIDED };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Groups;
    use crate::number::Rational;
    use crate::roots::Depressed;
    use crate::stability::InertialThreshold;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_quartic_is_negative_exactly_above_the_threshold(
            values in prop::array::uniform4(1i64..1000), s in 1i64..10, tenths in 1i64..10,
        ) {
            let ([a, b, k, m], s) = (values.map(Rational::from), Rational::from(s));
            let squared_ratio = Rational::from((tenths, 10));
            let threshold = InertialThreshold::from_squared_ratio(squared_ratio.clone()).unwrap();
            let quartic = threshold_quartic(&a, &(a.clone() - &b), &k, &m, &squared_ratio);
            let value = quartic.into_iter().rev().fold(Rational::new(), |sum, q| sum * &s + q);
            let weight = a.clone() * &s;
            let groups = Groups {
                inertial_parameter: m / &weight,
                stiffness_group: k / weight,
                effect_ratio: b / a,
            };
            let cubic = Depressed::of(&groups.characteristic_cubic()).unwrap();
            // At zero the filter is never certain.
            prop_assert!(value.is_zero() || (value < 0) == threshold.exceeded_by(&cubic));
        }
    }
}
