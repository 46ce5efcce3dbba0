//! Growth rate and frequency over a (V0, σ) grid and of unrelated points, to two units in the last place.
//!
//! A kernel without branches ([`value_kernel`](super::value_kernel)) proves nearly all of them, eight at a time where the machine
//! has such vectors; what it leaves open goes to the root finder in double-double, whose error bounds follow its branches, and
//! then to enclosures. 64-bit arithmetic alone could certify none: rounding the coefficients costs more than two units.

use super::dispatch::run_on_widest_unit;
use super::grid::exact;
use super::parallel;
use super::points::{BLOCK, is_valid, joint_length};
use super::value_kernel::{PartColumns, PointValueLoop, TOLERANCE, ValueLoop, ValueTerms};
use crate::friction::{Parameters, Slider};
use crate::number::{Dd, Rational, Wide};
use crate::stability::binary64::short_cubic;
use crate::stability::certain_signs::BoundedGroups;
use crate::stability::spectrum::LargestParts;

/// The largest real and imaginary part of the exponents of one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LargestPartsPerS {
    /// Largest Re(s), 1/s, to two units in the last place of that root's modulus.
    pub real: Wide,
    /// Largest Im(s), 1/s, to two units in the last place; exactly 0 when no root is complex.
    pub imaginary: Wide,
}

/// The values at every point of the grid, row after row (σ runs fastest); V0 in m/s and σ in Pa, the rest from `slider`.
///
/// `None` unless every V0 and σ is positive and finite.
#[must_use]
pub fn grid_values(
    slider: &Slider<Rational>,
    loading_velocities_m_per_s: &[f64],
    normal_stresses_pa: &[f64],
) -> Option<Vec<LargestPartsPerS>> {
    let mut inputs = loading_velocities_m_per_s.iter().chain(normal_stresses_pa);
    if !inputs.all(|&x| x > 0.0 && x.is_finite()) {
        return None;
    }
    let (approximate, terms) = (slider.map(Dd::from_rational), ValueTerms::new(slider));
    let approximate = &approximate;
    let row = |&velocity: &f64| {
        let [mut real, mut imaginary] = [(); 2].map(|()| vec![0.0; normal_stresses_pa.len()]);
        let (row, stresses) = (terms.row(velocity), normal_stresses_pa);
        let parts = PartColumns { real: &mut real, imaginary: &mut imaginary };
        run_on_widest_unit(ValueLoop { row: &row, stresses, parts });
        let parts = stresses.iter().zip(real.into_iter().zip(imaginary));
        parts.map(move |(&stress, (real, imaginary))| {
            certified(real, imaginary)
                .or_else(|| by_double_double(&approximate.at(Dd::from(stress), Dd::from(velocity))))
                .unwrap_or_else(|| exactly(&slider.at(exact(stress), exact(velocity))))
        })
    };
    let rows = parallel::map(loading_velocities_m_per_s.iter().collect(), |velocity| {
        row(velocity).collect::<Vec<_>>()
    });
    Some(rows.concat())
}

/// The values of the points whose seven inputs (SI) stand in seven columns of equal length, in their order.
///
/// `None` when the columns differ in length or hold a value that is not positive and finite.
#[must_use]
pub fn point_values(columns: &Parameters<&[f64]>) -> Option<Vec<LargestPartsPerS>> {
    let count = joint_length(columns)?;
    let block = |first: usize| {
        let columns = columns.map(|column| &column[first..count.min(first + BLOCK)]);
        let [mut real, mut imaginary] = [[0.0; BLOCK]; 2];
        let parts = PartColumns { real: &mut real, imaginary: &mut imaginary };
        run_on_widest_unit(PointValueLoop { columns: &columns, parts });
        let value = |index: usize| {
            certified(real[index], imaginary[index]).or_else(|| {
                let point = columns.map(|column| column[index]);
                let above = || {
                    by_double_double(&point.map(|value| Dd::from(*value)))
                        .or_else(|| by_short_integers(&point))
                        .unwrap_or_else(|| exactly(&point.map(|value| exact(*value))))
                };
                is_valid(&columns, index).then(above)
            })
        };
        (0..columns.slider.direct_effect.len()).map(value).collect::<Option<Vec<_>>>()
    };
    let starts: Vec<usize> = (0..count).step_by(BLOCK).collect();
    let blocks = parallel::map(starts, block).into_iter().collect::<Option<Vec<_>>>()?;
    Some(blocks.concat())
}

/// The values that the kernel proved, if it did.
fn certified(real: f64, imaginary: f64) -> Option<LargestPartsPerS> {
    // Far inside f64's range nothing was lost to underflow.
    let usable = real.abs() > 1e-250 && (imaginary > 1e-250 || imaginary == 0.0);
    let (real, imaginary) = usable.then_some((real, imaginary))?;
    Some(LargestPartsPerS { real: Wide::from_f64(real)?, imaginary: Wide::from_f64(imaginary)? })
}

/// The values when double-double's error bounds allow: at most half a unit in the last place before the rounding to 64 bits,
/// which adds as much, and the product with V0/D_c before that far less.
fn by_double_double(point: &Parameters<Dd>) -> Option<LargestPartsPerS> {
    let groups = BoundedGroups::of_parameters(point)?;
    let transition_sign = groups.certain_transition_sign()?;
    let parts = LargestParts::of_bounded_within(&groups.cubic().spectrum(), transition_sign, TOLERANCE)?;
    let LargestParts { real, imaginary } = parts.times_rate(point.rate_per_s())?;
    Some(LargestPartsPerS { real, imaginary })
}

/// The values by integers of fixed length, which keep what cancels next to the boundary and the transition.
fn by_short_integers(point: &Parameters<f64>) -> Option<LargestPartsPerS> {
    let cubic = short_cubic(point)?;
    let parts = LargestParts::of_bounded_within(&cubic.spectrum()?, cubic.hurwitz_sign(), TOLERANCE)?;
    let LargestParts { real, imaginary } =
        parts.times_rate(point.map(|value| Dd::from(*value)).rate_per_s())?;
    Some(LargestPartsPerS { real, imaginary })
}

/// The values by way of rationals.
fn exactly(point: &Parameters<Rational>) -> LargestPartsPerS {
    let LargestParts { real, imaginary } =
        LargestParts::exactly(&point.groups()).times_rate(&point.rate_per_s());
    LargestPartsPerS { real, imaginary }
}

#[cfg(test)]
mod tests;
