//! Signs and slip modes of the rows of a grid: the vectorised filter first, rationals for what it leaves open.

use rug::Rational;

use super::dispatch::run_on_widest_unit;
use super::grid::{GridKernel, ROW_BITS, exact_signs};
use super::mode_filter::{ModeFilter, ModeLoop};
use super::{GridCell, PrecisionCounts};
use crate::friction::Slider;
use crate::number::Ball;
use crate::roots::PrecisionLevel;
use crate::stability::{InertialThreshold, slip_mode};

/// What the rows of a grid share.
#[derive(Debug, Clone)]
pub struct ModeKernel {
    grid: GridKernel,
    threshold: InertialThreshold,
    squared_ratio: Ball,
}

impl ModeKernel {
    /// Prepares a grid over these σ (Pa); `None` unless all are positive and finite.
    #[must_use]
    pub fn new(
        slider: &Slider<Rational>,
        threshold: &InertialThreshold,
        normal_stresses_pa: &[f64],
    ) -> Option<Self> {
        Some(Self {
            grid: GridKernel::new(slider, normal_stresses_pa)?,
            threshold: threshold.clone(),
            squared_ratio: Ball::from_rational(threshold.squared_ratio(), ROW_BITS),
        })
    }

    /// The number of σ.
    #[must_use]
    pub fn width(&self) -> usize {
        self.grid.scaled_stresses().len()
    }

    /// Classifies the row of this V0 (m/s) exactly; `None` unless it is positive and finite and `cells` has one entry per σ.
    #[must_use]
    pub fn classify_row(
        &self,
        loading_velocity_m_per_s: f64,
        cells: &mut [GridCell],
    ) -> Option<PrecisionCounts> {
        if !self.grid.accepts(loading_velocity_m_per_s, cells.len()) {
            return None;
        }
        let filter = self.filter(loading_velocity_m_per_s);
        run_on_widest_unit(ModeLoop { filter: &filter, stresses: self.grid.scaled_stresses(), cells });
        Some(self.decide_the_rest(loading_velocity_m_per_s, cells))
    }

    fn filter(&self, loading_velocity_m_per_s: f64) -> ModeFilter {
        let inertia = self.grid.inertia(loading_velocity_m_per_s);
        let signs = self.grid.row_filter(&inertia);
        ModeFilter::new(signs, self.grid.balls(&inertia), &self.squared_ratio, self.grid.stress_exponent())
    }

    /// Decides the points that the filter left open: so few that their modes all go to rationals.
    fn decide_the_rest(&self, loading_velocity_m_per_s: f64, cells: &mut [GridCell]) -> PrecisionCounts {
        let mut counts = PrecisionCounts::default();
        for (index, cell) in cells.iter_mut().enumerate() {
            if *cell != GridCell::UNDECIDED {
                counts.f64 += 1;
                continue;
            }
            let groups = self.grid.point(loading_velocity_m_per_s, index).groups();
            let signs = exact_signs(&groups);
            *cell = GridCell::new(signs, slip_mode(&groups, signs.spectral_class(), &self.threshold));
            counts.count(PrecisionLevel::Exact);
        }
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::super::dispatch::Kernel;
    use super::*;
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
            let kernel = ModeKernel::new(&fixed, &threshold, &stresses).unwrap();
            for x in [0.0, 0.3, 1.0] {
                let velocity = libm::exp10(velocity + x * spread);
                let mut cells = [GridCell::UNDECIDED; 5];
                kernel.classify_row(velocity, &mut cells).unwrap();
                for (index, cell) in cells.iter().enumerate() {
                    let found = classify(&kernel.grid.point(velocity, index), &threshold);
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
        let kernel = ModeKernel::new(&fixed, &threshold, &[1.0, 2.0]).unwrap();
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
        let kernel = ModeKernel::new(&fixed, &InertialThreshold::default(), &stresses).unwrap();
        for exponent in -7..2 {
            let filter = kernel.filter(libm::exp10(f64::from(exponent)));
            let mut cells = [vec![GridCell::UNDECIDED; 1003], vec![GridCell::UNDECIDED; 1003]];
            let [plain, vector] = &mut cells;
            let stresses = kernel.grid.scaled_stresses();
            ModeLoop { filter: &filter, stresses, cells: plain }.run();
            run_on_widest_unit(ModeLoop { filter: &filter, stresses, cells: vector });
            assert_eq!(plain, vector);
        }
    }
}
