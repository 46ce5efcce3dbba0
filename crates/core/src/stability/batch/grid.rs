//! A (V0, σ) grid at fixed material and machine: both decisions are polynomials in σ along a row of constant V0.
//!
//! Row after row the 64-bit [filter](RowFilter) decides nearly every point; the rest is decided at a higher precision level.

use rug::Rational;

use super::dispatch::run_on_widest_unit;
use super::parallel;
use super::row_filter::{RowFilter, RowLoop};
use super::{PrecisionCounts, SignPair};
use crate::friction::{Groups, Parameters, Slider};
use crate::number::{Ball, Field};
use crate::stability::{boundary_sign, certain_signs, transition_sign};

/// Precision of a row's coefficients before they are rounded to f64: room for a cancellation of 100 bits and more.
pub(super) const ROW_BITS: u32 = 192;

/// The signs of every point of a grid, row after row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Grid {
    /// One entry per point; the σ index runs fastest.
    pub cells: Vec<SignPair>,
    /// How many points each precision level decided.
    pub counts: PrecisionCounts,
}

/// Classifies every point of the grid exactly; V0 in m/s and σ in Pa are taken from the slices, the rest from `slider`.
///
/// `None` unless every V0 and σ is positive and finite.
///
/// ```
/// use slipmode_core::stability::batch::classify_grid;
/// # use slipmode_core::{Slider, parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// // Two velocities in m/s by three normal stresses in Pa.
/// let grid = classify_grid(&slider, &[1e-5, 0.1], &[1e3, 1e5, 1e7]).unwrap();
/// assert_eq!(grid.cells.len(), 6);
/// assert_eq!(grid.cells[0].transition_sign(), 1);
/// assert_eq!(grid.cells[2].transition_sign(), -1);
/// ```
#[must_use]
pub fn classify_grid(
    slider: &Slider<Rational>,
    loading_velocities_m_per_s: &[f64],
    normal_stresses_pa: &[f64],
) -> Option<Grid> {
    let kernel = GridKernel::new(slider, normal_stresses_pa)?;
    let width = normal_stresses_pa.len();
    let mut cells = vec![SignPair::UNDECIDED; width * loading_velocities_m_per_s.len()];
    let rows = cells.chunks_mut(width.max(1)).zip(loading_velocities_m_per_s).collect();
    let counts = parallel::map(rows, |(row, &velocity)| kernel.classify_row(velocity, row));
    let mut total = PrecisionCounts::default();
    for count in counts {
        total += count?;
    }
    Some(Grid { cells, counts: total })
}

/// What the rows of a grid share: the slider and the scaled σ.
#[derive(Debug, Clone)]
pub struct GridKernel {
    slider: Slider<Rational>,
    direct_effect: Ball,
    effect_difference: Ball,
    spring: Ball,
    mass_over_length: Ball,
    normal_stresses_pa: Vec<f64>,
    scaled_stresses: Vec<f64>,
    stress_exponent: i32,
}

fn is_positive(value: &f64) -> bool {
    *value > 0.0 && value.is_finite()
}

impl GridKernel {
    /// Prepares a grid over these σ (Pa); `None` unless all are positive and finite.
    #[must_use]
    pub fn new(slider: &Slider<Rational>, normal_stresses_pa: &[f64]) -> Option<Self> {
        if !normal_stresses_pa.iter().all(is_positive) {
            return None;
        }
        let largest = normal_stresses_pa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let (_, stress_exponent) = libm::frexp(largest);
        let ball = |value: &Rational| Ball::from_rational(value, ROW_BITS);
        Some(Self {
            direct_effect: ball(&slider.direct_effect),
            effect_difference: -ball(&slider.effect_difference()),
            spring: ball(&slider.stiffness_stress_pa()),
            mass_over_length: ball(
                &(slider.mass_per_area_kg_per_m2.clone() / &slider.critical_slip_distance_m),
            ),
            scaled_stresses: normal_stresses_pa.iter().map(|&s| libm::ldexp(s, -stress_exponent)).collect(),
            normal_stresses_pa: normal_stresses_pa.to_vec(),
            stress_exponent,
            slider: slider.clone(),
        })
    }

    /// Classifies the row of this V0 (m/s) exactly; `None` unless it is positive and finite and `cells` has one entry per σ.
    #[must_use]
    pub fn classify_row(
        &self,
        loading_velocity_m_per_s: f64,
        cells: &mut [SignPair],
    ) -> Option<PrecisionCounts> {
        if !self.accepts(loading_velocity_m_per_s, cells.len()) {
            return None;
        }
        let filter = self.row_filter(&self.inertia(loading_velocity_m_per_s));
        run_on_widest_unit(RowLoop { filter: &filter, stresses: &self.scaled_stresses, cells });
        Some(self.decide_the_rest(loading_velocity_m_per_s, cells))
    }

    /// Whether a row can be classified: V0 positive and finite, one cell per σ.
    pub(super) fn accepts(&self, loading_velocity_m_per_s: f64, cells: usize) -> bool {
        is_positive(&loading_velocity_m_per_s) && cells == self.scaled_stresses.len()
    }

    /// M·V0²/D_c of a row.
    pub(super) fn inertia(&self, loading_velocity_m_per_s: f64) -> Ball {
        let velocity = Ball::from(loading_velocity_m_per_s).with_precision(ROW_BITS);
        velocity.square() * &self.mass_over_length
    }

    /// a, a − b, K·D_c and M·V0²/D_c of a row, given the last.
    pub(super) fn balls<'a>(&'a self, inertia: &'a Ball) -> [&'a Ball; 4] {
        [&self.direct_effect, &self.effect_difference, &self.spring, inertia]
    }

    /// The filter of the row with this M·V0²/D_c.
    pub(super) fn row_filter(&self, inertia: &Ball) -> RowFilter {
        let [a, difference, k, m] = self.balls(inertia);
        RowFilter::new(a, difference, k, m, self.stress_exponent)
    }

    /// The σ times a power of two, in (0, 1].
    pub(super) fn scaled_stresses(&self) -> &[f64] {
        &self.scaled_stresses
    }

    /// The exponent of that power, negated.
    pub(super) const fn stress_exponent(&self) -> i32 {
        self.stress_exponent
    }

    /// Hands the points that the filter left open to the higher precision levels.
    fn decide_the_rest(&self, loading_velocity_m_per_s: f64, cells: &mut [SignPair]) -> PrecisionCounts {
        let mut counts = PrecisionCounts::default();
        for (index, cell) in cells.iter_mut().enumerate() {
            if *cell != SignPair::UNDECIDED {
                counts.f64 += 1;
                continue;
            }
            let (signs, precision_level) = decide_above_filter(&self.point(loading_velocity_m_per_s, index));
            *cell = signs;
            counts.count(precision_level);
        }
        counts
    }

    /// The point at this V0 and the σ of this index.
    pub(super) fn point(&self, loading_velocity_m_per_s: f64, index: usize) -> Parameters<Rational> {
        self.slider.at(exact(self.normal_stresses_pa[index]), exact(loading_velocity_m_per_s))
    }
}

/// A finite f64 as the rational that it is (zero otherwise, which the callers' checks exclude).
pub(super) fn exact(value: f64) -> Rational {
    Rational::from_f64(value).unwrap_or_default()
}

/// The signs of a point, by rationals.
pub(super) fn exact_signs(groups: &Groups<Rational>) -> SignPair {
    SignPair::new(transition_sign(groups), boundary_sign(groups))
}

/// The signs of a point that the 64-bit filter left open.
pub(super) fn decide_above_filter(point: &Parameters<Rational>) -> (SignPair, crate::roots::PrecisionLevel) {
    let groups = point.groups();
    let signs = certain_signs::signs_above_f64(&groups, certain_signs::BoundedGroups::of(&groups).as_ref());
    (SignPair::new(signs.transition, signs.boundary), signs.precision_level)
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::Kernel;
    use super::*;
    use crate::stability::fixtures::with_effects;
    use proptest::prelude::*;

    fn potentially_unstable() -> Slider<Rational> {
        with_effects(Rational::from((4, 1000)), Rational::from((6, 1000)))
    }

    fn intrinsically_stable() -> Slider<Rational> {
        with_effects(Rational::from((6, 1000)), Rational::from((4, 1000)))
    }

    proptest! {
        #[test]
        fn every_cell_has_the_exact_signs(
            velocity in -12f64..3.0, stress in -3f64..12.0, spread in 0f64..3.0, swap in prop::bool::ANY,
        ) {
            let fixed = if swap { intrinsically_stable() } else { potentially_unstable() };
            let velocities = [0.0, 0.3].map(|x| libm::exp10(velocity + x * spread));
            let stresses = [0.0, 0.1, 0.7, 1.0].map(|x| libm::exp10(stress + x * spread));
            let grid = classify_grid(&fixed, &velocities, &stresses).unwrap();
            let kernel = GridKernel::new(&fixed, &stresses).unwrap();
            for (index, cell) in grid.cells.iter().enumerate() {
                let groups = kernel.point(velocities[index / 4], index % 4).groups();
                prop_assert_eq!(cell.transition_sign(), transition_sign(&groups));
                prop_assert_eq!(cell.boundary_sign(), boundary_sign(&groups));
            }
        }
    }

    #[test]
    fn a_grid_point_exactly_on_the_cusp_or_on_the_transition_is_decided_as_zero() {
        let mut fixed = with_effects(Rational::from(1), Rational::from(1));
        // a = b = D_c = 1: the cusp η = M V²/σ = 1/8, κ = K/σ = 27/8 at V = 1, σ = 8.
        fixed.critical_slip_distance_m = Rational::from(1);
        fixed.mass_per_area_kg_per_m2 = Rational::from(1);
        fixed.stiffness_pa_per_m = Rational::from(27);
        let grid = classify_grid(&fixed, &[1.0], &[8.0, 9.0]).unwrap();
        assert_eq!(grid.cells[0], SignPair::new(1, 0));
        assert_eq!((grid.counts.exact, grid.counts.f64), (1, 1));
        // K = K_c: κ = (β−1)(1+η) with β = 2, σ = 1, V = 1, M = 26.
        fixed.evolution_effect = Rational::from(2);
        fixed.mass_per_area_kg_per_m2 = Rational::from(26);
        assert_eq!(classify_grid(&fixed, &[1.0], &[1.0]).unwrap().cells[0], SignPair::new(0, -1));
    }

    #[test]
    fn next_to_the_boundary_double_double_decides_and_on_it_rationals() {
        // a = b = D_c = V = 1, and η = 3/32, κ = 125/32 at σ = 32: the double root −5.
        let mut fixed = with_effects(Rational::from(1), Rational::from(1));
        fixed.critical_slip_distance_m = Rational::from(1);
        fixed.mass_per_area_kg_per_m2 = Rational::from(3);
        fixed.stiffness_pa_per_m = Rational::from(125);
        let beside = 32.0 * f64::EPSILON;
        let grid = classify_grid(&fixed, &[1.0], &[32.0 - beside, 32.0, 32.0 + beside, 40.0]).unwrap();
        let boundary: Vec<i8> = grid.cells.iter().map(|cell| cell.boundary_sign()).collect();
        assert_eq!(boundary, [-1, 0, 1, -1]);
        assert_eq!(grid.counts, PrecisionCounts { f64: 1, double_double: 2, exact: 1 });
    }

    #[test]
    fn vector_units_and_the_baseline_leave_the_same_bits() {
        let stresses: Vec<f64> = (0..1003).map(|i| libm::exp10(2.0 + 7.0 * f64::from(i) / 1002.0)).collect();
        let kernel = GridKernel::new(&potentially_unstable(), &stresses).unwrap();
        for exponent in -7..2 {
            let filter = kernel.row_filter(&kernel.inertia(libm::exp10(f64::from(exponent))));
            let mut cells = [vec![SignPair::UNDECIDED; 1003], vec![SignPair::UNDECIDED; 1003]];
            let [plain, vector] = &mut cells;
            RowLoop { filter: &filter, stresses: &kernel.scaled_stresses, cells: plain }.run();
            run_on_widest_unit(RowLoop { filter: &filter, stresses: &kernel.scaled_stresses, cells: vector });
            assert_eq!(plain, vector);
        }
    }

    #[test]
    fn values_that_are_not_positive_and_finite_are_refused() {
        let fixed = potentially_unstable();
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(classify_grid(&fixed, &[1.0], &[bad]).is_none());
            assert!(classify_grid(&fixed, &[bad], &[1.0]).is_none());
        }
        assert!(classify_grid(&fixed, &[], &[]).unwrap().cells.is_empty());
    }
}
