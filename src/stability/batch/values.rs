//! Growth rate and frequency over a (V0, σ) grid, to 1e-14.

use rayon::prelude::*;

use super::grid::exact;
use crate::friction::Parameters;
use crate::number::{Dd, Rational, Wide};
use crate::stability::ladder::BoundedGroups;
use crate::stability::spectrum::LargestParts;
use crate::stability::{InertialThreshold, classify};

/// The largest real and imaginary part of the exponents of one point, with the accuracy of
/// [`Classification`](crate::stability::Classification).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestPartsPerS {
    /// Largest Re(s), 1/s.
    pub real: Wide,
    /// Largest Im(s), 1/s; exactly 0 when no root is complex.
    pub imaginary: Wide,
}

/// The values at every point of the grid, row after row (σ runs fastest); V0 in m/s and σ in Pa, the rest from `fixed`.
///
/// `None` unless every V0 and σ is positive and finite.
#[must_use]
pub fn grid_values(
    fixed: &Parameters<Rational>,
    loading_velocities_m_per_s: &[f64],
    normal_stresses_pa: &[f64],
) -> Option<Vec<LargestPartsPerS>> {
    let mut inputs = loading_velocities_m_per_s.iter().chain(normal_stresses_pa);
    if !inputs.all(|&x| x > 0.0 && x.is_finite()) {
        return None;
    }
    let approximate = fixed.map(Dd::from_rational);
    let row = |&velocity: &f64| {
        let mut point = approximate.clone();
        point.loading_velocity_m_per_s = Dd::from(velocity);
        normal_stresses_pa.iter().map(move |&stress| {
            point.normal_stress_pa = Dd::from(stress);
            by_double_double(&point).unwrap_or_else(|| exactly(fixed, velocity, stress))
        })
    };
    Some(loading_velocities_m_per_s.par_iter().flat_map_iter(row).collect())
}

/// The values when double-double's error bounds allow.
fn by_double_double(point: &Parameters<Dd>) -> Option<LargestPartsPerS> {
    let groups = BoundedGroups::of_parameters(point)?;
    let transition_sign = groups.certain_transition_sign()?;
    let parts = LargestParts::of_bounded(&groups.cubic().spectrum(), transition_sign)?;
    let LargestParts { real, imaginary } = parts.times_rate(point.rate_per_s())?;
    Some(LargestPartsPerS { real, imaginary })
}

/// The values by way of rationals.
fn exactly(fixed: &Parameters<Rational>, velocity: f64, stress: f64) -> LargestPartsPerS {
    let point = Parameters {
        loading_velocity_m_per_s: exact(velocity),
        normal_stress_pa: exact(stress),
        ..fixed.clone()
    };
    let found = classify(&point, &InertialThreshold::default());
    LargestPartsPerS { real: found.max_real_per_s, imaginary: found.max_imaginary_per_s }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_a_grid_are_those_of_its_points() {
        let fixed = crate::stability::fixtures::paper();
        let axis = |from: f64, to: f64| {
            (0..40).map(|i| libm::exp10(from + (to - from) * f64::from(i) / 39.0)).collect()
        };
        let (velocities, stresses): (Vec<f64>, Vec<f64>) = (axis(-9.0, 2.0), axis(1.0, 9.0));
        let values = grid_values(&fixed, &velocities, &stresses).unwrap();
        for (index, found) in values.iter().enumerate() {
            let exact = exactly(&fixed, velocities[index / 40], stresses[index % 40]);
            // Two values, each within 1e-14 of the same truth; the real part relative to a modulus of at least itself.
            let (x, y) = (found.imaginary.to_f64().unwrap(), exact.imaginary.to_f64().unwrap());
            assert!((x - y).abs() <= 2e-14 * y);
            let (p, q) = (found.real.to_f64().unwrap(), exact.real.to_f64().unwrap());
            assert!((p - q).abs() <= 2e-14 * (q * q + y * y).sqrt());
        }
    }
}
