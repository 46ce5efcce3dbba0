//! A (V0, σ) grid at fixed material and machine: signs and slip modes are decided by polynomials in σ along a row of constant V0.
//!
//! Row after row the 64-bit [filter](ModeFilter) decides nearly every point, rationals the rest.

use rug::Rational;

use super::mode_filter::{ModeFilter, ModeLoop};
use super::{GridCell, PrecisionCounts, SignPair};
use crate::friction::{Groups, Parameters, Slider};
use crate::number::dispatch::run_on_widest_unit;
use crate::number::{Ball, Field};
use crate::roots::PrecisionLevel;
use crate::stability::{InertialThreshold, boundary_sign, slip_mode, transition_sign};

/// Precision of a row's coefficients before they are rounded to f64: room for a cancellation of 100 bits and more.
const ROW_BITS: u32 = 192;

/// What the rows of a grid share: the slider, the threshold and the scaled σ.
///
/// ```
/// use slipmode_core::stability::InertialThreshold;
/// use slipmode_core::stability::batch::{GridCell, GridKernel, SignPair};
/// # use slipmode_core::{friction::{SlipMode, Slider}, number::parse_decimal};
/// # let number = |text| parse_decimal(text).unwrap();
/// # let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(number));
/// // One row: V0 = 10 µm/s under three normal stresses in Pa.
/// let kernel = GridKernel::new(&slider, &InertialThreshold::default(), &[1e3, 1e5, 1e7]).unwrap();
/// let mut row = [GridCell::new(SignPair::new(0, 0), SlipMode::StickSlip); 3];
/// kernel.classify_row(1e-5, &mut row).unwrap();
/// assert_eq!(row.map(|cell| cell.signs().transition_sign()), [1, -1, -1]);
/// ```
#[derive(Debug, Clone)]
pub struct GridKernel {
    slider: Slider<Rational>,
    threshold: InertialThreshold,
    squared_ratio: Ball,
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
    pub fn new(
        slider: &Slider<Rational>,
        threshold: &InertialThreshold,
        normal_stresses_pa: &[f64],
    ) -> Option<Self> {
        if !normal_stresses_pa.iter().all(is_positive) {
            return None;
        }
        let largest = normal_stresses_pa.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let (_, stress_exponent) = libm::frexp(largest);
        let ball = |value: &Rational| Ball::from_rational(value, ROW_BITS);
        Some(Self {
            threshold: threshold.clone(),
            squared_ratio: ball(threshold.squared_ratio()),
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

    /// The number of σ.
    pub(crate) const fn width(&self) -> usize {
        self.scaled_stresses.len()
    }

    /// Classifies the row of this V0 (m/s) exactly; `None` unless it is positive and finite and `cells` has one entry per σ.
    #[must_use]
    pub fn classify_row(
        &self,
        loading_velocity_m_per_s: f64,
        cells: &mut [GridCell],
    ) -> Option<PrecisionCounts> {
        if !is_positive(&loading_velocity_m_per_s) || cells.len() != self.width() {
            return None;
        }
        let filter = self.filter(loading_velocity_m_per_s);
        run_on_widest_unit(ModeLoop { filter: &filter, stresses: &self.scaled_stresses, cells });
        Some(self.decide_the_rest(loading_velocity_m_per_s, cells))
    }

    /// The filter of a row, from a, a − b, K·D_c and M·V0²/D_c.
    fn filter(&self, loading_velocity_m_per_s: f64) -> ModeFilter {
        let velocity = Ball::from(loading_velocity_m_per_s).with_precision(ROW_BITS);
        let inertia = velocity.square() * &self.mass_over_length;
        let balls = [&self.direct_effect, &self.effect_difference, &self.spring, &inertia];
        ModeFilter::new(balls, &self.squared_ratio, self.stress_exponent)
    }

    /// Decides the points that the filter left open: so few that their modes all go to rationals.
    fn decide_the_rest(&self, loading_velocity_m_per_s: f64, cells: &mut [GridCell]) -> PrecisionCounts {
        let mut counts = PrecisionCounts::default();
        for (index, cell) in cells.iter_mut().enumerate() {
            if *cell != GridCell::UNDECIDED {
                counts.f64 += 1;
                continue;
            }
            let groups = self.point(loading_velocity_m_per_s, index).groups();
            let signs = exact_signs(&groups);
            *cell = GridCell::new(signs, slip_mode(&groups, signs.spectral_class(), &self.threshold));
            counts.count(PrecisionLevel::Exact);
        }
        counts
    }

    /// The point at this V0 and the σ of this index.
    fn point(&self, loading_velocity_m_per_s: f64, index: usize) -> Parameters<Rational> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::dispatch::Kernel;
    use crate::stability::classify;
    use crate::stability::fixtures::with_effects;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_cell_has_the_signs_and_the_mode_of_its_point(
            velocity in -12f64..3.0, stress in -3f64..12.0, spread in 0f64..3.0, swap in prop::bool::ANY, ratio in 1i64..1000,
        ) {
            let (small, large) = (Rational::from((4, 1000)), Rational::from((6, 1000)));
            let fixed = if swap { with_effects(large, small) } else { with_effects(small, large) };
            let threshold = InertialThreshold::from_squared_ratio(Rational::from((ratio, 1000))).unwrap();
            let stresses = [0.0, 0.1, 0.3, 0.7, 1.0].map(|x| libm::exp10(stress + x * spread));
            let kernel = GridKernel::new(&fixed, &threshold, &stresses).unwrap();
            for x in [0.0, 0.3, 1.0] {
                let velocity = libm::exp10(velocity + x * spread);
                let mut cells = [GridCell::UNDECIDED; 5];
                kernel.classify_row(velocity, &mut cells).unwrap();
                for (index, cell) in cells.iter().enumerate() {
                    let found = classify(&kernel.point(velocity, index), &threshold);
                    prop_assert_eq!(cell.signs().transition_sign(), found.transition_sign);
                    prop_assert_eq!(cell.signs().boundary_sign(), found.boundary_sign);
                    prop_assert_eq!(cell.slip_mode(), found.slip_mode);
                }
            }
        }
    }

    #[test]
    fn a_point_exactly_on_the_threshold_or_on_the_cusp_is_decided_by_rationals() {
        // K = K_c and η = 1, where (ω/ω_n)² = 1/2: β = 2, κ = (β − 1)(1 + η) = 2, at V = 1 and σ = 1.
        let mut fixed = with_effects(Rational::from(1), Rational::from(2));
        fixed.critical_slip_distance_m = Rational::from(1);
        fixed.mass_per_area_kg_per_m2 = Rational::from(1);
        fixed.stiffness_pa_per_m = Rational::from(2);
        let threshold = InertialThreshold::default();
        let kernel = GridKernel::new(&fixed, &threshold, &[1.0, 2.0]).unwrap();
        let mut cells = [GridCell::UNDECIDED; 2];
        let counts = kernel.classify_row(1.0, &mut cells).unwrap();
        assert_eq!((counts.exact, counts.f64), (1, 1));
        let mode = crate::stability::SlipMode::NonInertialUnderdampedOscillation;
        assert_eq!(cells[0], GridCell::new(super::super::SignPair::new(0, -1), mode));
        assert!(kernel.classify_row(f64::NAN, &mut cells).is_none());
        assert!(kernel.classify_row(1.0, &mut cells[..1]).is_none());
    }

    #[test]
    fn vector_units_and_the_baseline_leave_the_same_bits() {
        let fixed = with_effects(Rational::from((6, 1000)), Rational::from((4, 1000)));
        let stresses: Vec<f64> = (0..1003).map(|i| libm::exp10(2.0 + 7.0 * f64::from(i) / 1002.0)).collect();
        let kernel = GridKernel::new(&fixed, &InertialThreshold::default(), &stresses).unwrap();
        for exponent in -7..2 {
            let filter = kernel.filter(libm::exp10(f64::from(exponent)));
            let mut cells = [vec![GridCell::UNDECIDED; 1003], vec![GridCell::UNDECIDED; 1003]];
            let [plain, vector] = &mut cells;
            let stresses = &kernel.scaled_stresses;
            ModeLoop { filter: &filter, stresses, cells: plain }.run();
            run_on_widest_unit(ModeLoop { filter: &filter, stresses, cells: vector });
            assert_eq!(plain, vector);
        }
    }

    #[test]
    fn a_grid_point_exactly_on_the_boundary_or_on_the_cusp_is_decided_as_zero() {
        let signs = |mass: i32, stiffness: i32, stresses: &[f64]| {
            // a = b = D_c = V = 1.
            let mut fixed = with_effects(Rational::from(1), Rational::from(1));
            fixed.critical_slip_distance_m = Rational::from(1);
            fixed.mass_per_area_kg_per_m2 = Rational::from(mass);
            fixed.stiffness_pa_per_m = Rational::from(stiffness);
            let kernel = GridKernel::new(&fixed, &InertialThreshold::default(), stresses).unwrap();
            let mut cells = vec![GridCell::UNDECIDED; stresses.len()];
            let counts = kernel.classify_row(1.0, &mut cells).unwrap();
            (cells.iter().map(|cell| cell.signs().boundary_sign()).collect::<Vec<_>>(), counts)
        };
        // The cusp η = M V²/σ = 1/8, κ = K/σ = 27/8 at σ = 8.
        let (boundary, counts) = signs(1, 27, &[8.0, 9.0]);
        assert_eq!((boundary[0], counts.exact, counts.f64), (0, 1, 1));
        // η = 3/32, κ = 125/32 at σ = 32: the double root −5.
        let beside = 32.0 * f64::EPSILON;
        let (boundary, counts) = signs(3, 125, &[32.0 - beside, 32.0, 32.0 + beside, 40.0]);
        assert_eq!(boundary, [-1, 0, 1, -1]);
        assert_eq!((counts.f64, counts.exact), (1, 3));
    }

    #[test]
    fn values_that_are_not_positive_and_finite_are_refused() {
        let (fixed, threshold) = (crate::stability::fixtures::paper(), InertialThreshold::default());
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(GridKernel::new(&fixed, &threshold, &[bad]).is_none());
            let kernel = GridKernel::new(&fixed, &threshold, &[1.0]).unwrap();
            assert!(kernel.classify_row(bad, &mut [GridCell::UNDECIDED]).is_none());
        }
    }
}
