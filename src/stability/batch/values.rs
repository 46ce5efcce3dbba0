//! Growth rate and frequency over a (V0, σ) grid, to two units in the last place.
//!
//! Double-double gives nearly all of them, its error bounds being the certificate. Vector units have no part in this: the bounds
//! follow the branches of the root finder, and a 64-bit kernel could not certify its last digits.

use rayon::prelude::*;

use super::grid::exact;
use crate::friction::Parameters;
use crate::number::{Dd, Rational, Wide};
use crate::stability::ladder::BoundedGroups;
use crate::stability::spectrum::LargestParts;

/// The relative error up to which double-double values are taken: at most one unit in the last place of the part. Rounding
/// it to 64 bits adds half a unit, the product with V0/D_c before that far less than the other half.
const TOLERANCE: f64 = f64::EPSILON / 2.0;

/// The largest real and imaginary part of the exponents of one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestPartsPerS {
    /// Largest Re(s), 1/s, to two units in the last place of that root's modulus.
    pub real: Wide,
    /// Largest Im(s), 1/s, to two units in the last place; exactly 0 when no root is complex.
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
    let parts = LargestParts::of_bounded_within(&groups.cubic().spectrum(), transition_sign, TOLERANCE)?;
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
    let LargestParts { real, imaginary } =
        LargestParts::exactly(&point.groups()).times_rate(&point.rate_per_s());
    LargestPartsPerS { real, imaginary }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roots::certified_roots;
    use rug::Float;

    /// Holds a value against 60-digit roots; the largest error of the two parts, in units of the last place.
    fn error_in_units(point: &Parameters<Rational>, found: &LargestPartsPerS) -> f64 {
        let roots = certified_roots(&point.groups().characteristic_cubic(), 60).roots;
        let rate = point.rate_per_s();
        let in_si = |part: &Float| Float::with_val(200, part * &rate);
        let rightmost = roots.iter().max_by(|x, y| x.re.total_cmp(&y.re)).unwrap();
        let highest = roots.iter().max_by(|x, y| x.im.total_cmp(&y.im)).unwrap();
        let (re, im) = (in_si(&rightmost.re), in_si(&highest.im));
        let modulus = re.clone().hypot(&in_si(&rightmost.im));
        let units = |found: Wide, exact: Float, size: &Float| {
            let unit = libm::ldexp(1.0, size.get_exp().unwrap_or(0) - 53);
            (Float::with_val(200, found.to_float()) - exact).abs().to_f64() / unit
        };
        let of_imaginary = if im.is_zero() {
            if found.imaginary == Wide::ZERO { 0.0 } else { f64::INFINITY }
        } else {
            units(found.imaginary, im.clone(), &im)
        };
        of_imaginary.max(units(found.real, re, &modulus))
    }

    #[test]
    fn values_of_a_grid_are_within_two_units_in_the_last_place() {
        let fixed = crate::stability::fixtures::paper();
        let axis = |from: f64, to: f64| {
            (0..40).map(|i| libm::exp10(from + (to - from) * f64::from(i) / 39.0)).collect()
        };
        let (velocities, stresses): (Vec<f64>, Vec<f64>) = (axis(-9.0, 2.0), axis(1.0, 9.0));
        let values = grid_values(&fixed, &velocities, &stresses).unwrap();
        for (index, found) in values.iter().enumerate() {
            let (velocity, stress) = (velocities[index / 40], stresses[index % 40]);
            let point = Parameters {
                loading_velocity_m_per_s: exact(velocity),
                normal_stress_pa: exact(stress),
                ..fixed.clone()
            };
            assert!(error_in_units(&point, found) <= 2.0, "{velocity:e} {stress:e} {found:?}");
            let by_rationals = exactly(&fixed, velocity, stress);
            assert!(error_in_units(&point, &by_rationals) <= 2.0, "{velocity:e} {stress:e} {by_rationals:?}");
        }
    }
}
