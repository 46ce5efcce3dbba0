//! Values of many unrelated points: classifications of decimals, and the three roots of columns.

use thiserror::Error;

use super::parallel;
use super::values::{BLOCK, point_values};
use crate::friction::Parameters;
use crate::number::{Dd, Wide, nearest_f64};
use crate::roots::PrecisionLevel;
use crate::stability::certain_signs::InputError;
use crate::stability::point_values::{PointValues, Route};
use crate::stability::quick::{classify_quickly, clearly_in_upper_area};
use crate::stability::slip_mode::slip_mode_by;
use crate::stability::spectrum::{OfPair, clearly_inertial};
use crate::stability::three_roots::{RootsError, ThreeRoots};
use crate::stability::{Classification, InertialThreshold, SpectralClass};

/// The classification of many points whose inputs are each within a relative [`Dd::UNIT`] of the true ones.
///
/// Every sign, name and value has the guarantees of [`classify`](crate::stability::classify); `None` stands where the error
/// bounds do not allow them, and the exact inputs are needed.
///
/// ```
/// use slipmode_core::stability::InertialThreshold;
/// use slipmode_core::friction::Parameters;
/// use slipmode_core::number::parse_decimal_to_dd;
/// use slipmode_core::stability::batch::classify_points;
///
/// let point = ["0.004", "0.006", "1e-5", "1e7", "1000", "1e6", "1e-5"].map(|text| parse_decimal_to_dd(text).unwrap());
/// let found = classify_points(&[Parameters::from(point)], &InertialThreshold::default());
/// assert_eq!(found[0].as_ref().unwrap().transition_sign, -1);
/// ```
#[must_use]
pub fn classify_points(
    points: &[Parameters<Dd>],
    threshold: &InertialThreshold,
) -> Vec<Option<Classification>> {
    let limit = nearest_f64(threshold.squared_ratio());
    let of_block = |block: &[Parameters<Dd>]| -> Vec<Option<Classification>> {
        let values = point_values(block, InputError::Unit, Route::Deflation);
        let both = block.iter().zip(&values);
        both.map(|(point, values)| classified(values, limit).or_else(|| classify_quickly(point, threshold)))
            .collect()
    };
    parallel::map(points.chunks(BLOCK).collect(), of_block).into_iter().flatten().collect()
}

/// The classification where 64-bit decides both signs and both values are certain to be correctly rounded.
fn classified(values: &PointValues<f64>, limit: f64) -> Option<Classification> {
    let is_pair = values.sign < 0.0;
    let usable = values.filtered > 0.0 && values.sign != 0.0 && values.rounded > 0.0;
    // What lies far outside is left to the general way, which has a wider range.
    let in_range = |value: f64| value.abs() > 1e-250 && value.abs() < 1e250;
    let imaginary = if is_pair { values.second } else { 0.0 };
    if !(usable && in_range(values.max_real) && (!is_pair || in_range(imaginary)) && in_range(values.rate)) {
        return None;
    }
    let code = values.filtered as u8 - 1;
    let (transition_sign, boundary_sign) = (2 * (code & 1) as i8 - 1, (code & 2) as i8 - 1);
    let spectral_class = SpectralClass::from_signs(transition_sign, boundary_sign);
    let groups = values.groups();
    let slip_mode = slip_mode_by(
        spectral_class,
        || clearly_in_upper_area(&groups),
        || clearly_inertial(values.frequency, groups.natural_angular_frequency_squared(), limit),
    )?;
    Some(Classification {
        transition_sign,
        boundary_sign,
        spectral_class,
        slip_mode,
        max_real_per_s: Wide::from_f64(values.max_real)?,
        max_imaginary_per_s: Wide::from_f64(imaginary)?,
        precision_level: PrecisionLevel::F64,
        value_precision_level: PrecisionLevel::DoubleDouble,
        angular_frequency: OfPair(is_pair.then(|| values.second_bounded())),
    })
}

/// Why there are no roots of a set of points.
///
/// ```
/// use slipmode_core::friction::Parameters;
/// use slipmode_core::stability::RootsError;
/// use slipmode_core::stability::batch::{PointError, three_roots_of_points};
///
/// let one: &[f64] = &[1.0, 1.0];
/// let refused = three_roots_of_points(&Parameters::from([one, one, one, one, one, one, &[1.0, -1.0]]));
/// assert_eq!(refused.unwrap_err(), PointError::Point { index: 1, error: RootsError::NotPositive });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum PointError {
    /// The columns differ in length.
    #[error("the seven columns differ in length")]
    UnequalColumns,
    /// A point has no roots in 64-bit.
    #[error("point {index}: {error}")]
    Point {
        /// Its index.
        index: usize,
        /// Why.
        error: RootsError,
    },
}

/// The three roots of every point whose seven inputs (SI) stand in seven columns; the 64-bit numbers are taken as exact.
///
/// Each has the guarantees of [`three_roots`](crate::stability::three_roots()).
///
/// # Errors
/// When the columns differ in length; else the error of the first point that has one.
///
/// ```
/// use slipmode_core::friction::Parameters;
/// use slipmode_core::stability::batch::three_roots_of_points;
/// use slipmode_core::stability::three_roots;
///
/// let (a, b, d, k, m) = ([0.004; 2], [0.006; 2], [1e-5; 2], [1e7; 2], [1000.0; 2]);
/// let columns = Parameters::from([&a[..], &b, &d, &k, &m, &[1e6, 1e4], &[1e-5, 0.5]]);
/// let roots = three_roots_of_points(&columns).unwrap();
/// let second = Parameters::from([0.004, 0.006, 1e-5, 1e7, 1000.0, 1e4, 0.5]);
/// assert_eq!(roots[1], three_roots(&second).unwrap());
/// ```
pub fn three_roots_of_points(columns: &Parameters<&[f64]>) -> Result<Vec<ThreeRoots>, PointError> {
    let columns: [&[f64]; 7] = columns.clone().into();
    let count = columns[0].len();
    if columns.iter().any(|column| column.len() != count) {
        return Err(PointError::UnequalColumns);
    }
    let starts: Vec<usize> = (0..count).step_by(PART).collect();
    let of_part =
        |start: usize| roots_of_part(&columns.map(|column| &column[start..count.min(start + PART)]), start);
    let parts = parallel::map(starts, of_part);
    Ok(parts.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}

/// Points of a part, the unit of parallel work.
const PART: usize = 16 * BLOCK;

fn roots_of_part(columns: &[&[f64]; 7], start: usize) -> Result<Vec<ThreeRoots>, PointError> {
    let point = |index: usize| Parameters::from(columns.map(|column| column[index]));
    let count = columns[0].len();
    let doubled: Vec<Parameters<Dd>> =
        (0..count).map(|index| point(index).map(|value| Dd::from(*value))).collect();
    let values = point_values(&doubled, InputError::None, Route::Deflation);
    let mut roots: Vec<Option<ThreeRoots>> = values.iter().map(ThreeRoots::of_values).collect();
    let open: Vec<usize> = (0..count).filter(|index| roots[*index].is_none()).collect();
    let again: Vec<Parameters<Dd>> = open.iter().map(|index| doubled[*index].clone()).collect();
    for (index, values) in open.iter().zip(point_values(&again, InputError::None, Route::Shift)) {
        roots[*index] = ThreeRoots::of_values(&values);
    }
    let or_exactly = |(index, found): (usize, Option<ThreeRoots>)| {
        let found = found.map_or_else(|| ThreeRoots::beyond_double_double(&point(index)), Ok);
        found.map_err(|error| PointError::Point { index: start + index, error })
    };
    roots.into_iter().enumerate().map(or_exactly).collect()
}

#[cfg(test)]
mod tests;
