//! Exact signs of many unrelated points, given as seven columns.

use super::parallel;
use super::{PrecisionCounts, SignPair};
use crate::friction::Parameters;
use crate::number::Dd;
use crate::number::dispatch::{Kernel, run_on_widest_unit};
use crate::roots::PrecisionLevel;
use crate::stability::certain_signs::{self, BoundedGroups};
use crate::stability::integer_cubic::IntegerCubic;

/// Points handled at a time: their columns stay in the first-level cache.
const BLOCK: usize = 1024;

/// Both signs of the points whose seven inputs (SI) stand in seven columns of equal length.
///
/// `None` when the columns differ in length or hold a value that is not positive and finite.
#[must_use]
pub fn signs_of_points(columns: &Parameters<&[f64]>) -> Option<(Vec<SignPair>, PrecisionCounts)> {
    let count = joint_length(columns)?;
    let mut cells = vec![SignPair::UNDECIDED; count];
    let blocks = cells.chunks_mut(BLOCK).enumerate().collect();
    let counts = parallel::map(blocks, |(block, cells): (usize, &mut [SignPair])| {
        let first = block * BLOCK;
        let columns = columns.map(|column| &column[first..first + cells.len()]);
        run_on_widest_unit(PointLoop { columns: &columns, cells });
        decide_the_rest(&columns, cells)
    })
    .into_iter()
    .collect::<Option<Vec<PrecisionCounts>>>()?;
    let mut total = PrecisionCounts::default();
    counts.into_iter().for_each(|block| total += block);
    Some((cells, total))
}

/// The length of the columns, if all have the same.
fn joint_length(columns: &Parameters<&[f64]>) -> Option<usize> {
    let count = columns.slider.direct_effect.len();
    columns_of(columns).into_iter().all(|column| column.len() == count).then_some(count)
}

/// Whether the seven inputs of a point are positive and finite.
fn is_valid(columns: &Parameters<&[f64]>, index: usize) -> bool {
    columns_of(columns).into_iter().all(|column| column[index] > 0.0 && column[index].is_finite())
}

fn columns_of<'a>(columns: &Parameters<&'a [f64]>) -> [&'a [f64]; 7] {
    columns.clone().into()
}

/// Hands the points that the filter left open to the higher precision levels.
///
/// A value that is not positive and finite lies outside the filter's range, so that it is found here, at no cost to the rest.
fn decide_the_rest(columns: &Parameters<&[f64]>, cells: &mut [SignPair]) -> Option<PrecisionCounts> {
    let mut counts = PrecisionCounts::default();
    for (index, cell) in cells.iter_mut().enumerate() {
        if *cell != SignPair::UNDECIDED {
            counts.f64 += 1;
            continue;
        }
        if !is_valid(columns, index) {
            return None;
        }
        let (signs, precision_level) = decide_above_64_bit(&columns.map(|column| column[index]))?;
        *cell = signs;
        counts.count(precision_level);
    }
    Some(counts)
}

/// Both signs by double-double, else by integers.
fn decide_above_64_bit(point: &Parameters<f64>) -> Option<(SignPair, PrecisionLevel)> {
    let in_double_double = BoundedGroups::of_parameters(&point.map(|value| Dd::from(*value)));
    Some(match in_double_double.and_then(|groups| groups.signs_below_exact()) {
        Some(signs) => (SignPair::new(signs.transition, signs.boundary), PrecisionLevel::DoubleDouble),
        None => {
            let [transition, boundary] = IntegerCubic::of(point)?.signs();
            (SignPair::new(transition, boundary), PrecisionLevel::Exact)
        }
    })
}

/// The inner loop over a block of points.
struct PointLoop<'a> {
    columns: &'a Parameters<&'a [f64]>,
    cells: &'a mut [SignPair],
}

impl Kernel for PointLoop<'_> {
    #[inline(always)]
    fn run(self) {
        let count = self.cells.len();
        // One slice each of the same length: the compiler then sees that no index can be out of bounds.
        let columns = self.columns.map(|column| &column[..count]);
        for index in 0..count {
            let point = columns.map(|column| column[index]);
            self.cells[index] = match certain_signs::filter(&point) {
                (true, stable, real) => SignPair::from_decided(stable, real),
                (false, ..) => SignPair::UNDECIDED,
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::exact;
    use super::*;
    use crate::stability::{boundary_sign, transition_sign};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_point_has_the_exact_signs(exponents in prop::collection::vec(prop::array::uniform7(-12f64..12.0), 1..40)) {
            let column = |k: usize| exponents.iter().map(|e| libm::exp10(e[k])).collect::<Vec<f64>>();
            let columns: Vec<Vec<f64>> = (0..7).map(column).collect();
            let points = Parameters::from([&columns[0][..], &columns[1][..], &columns[2][..], &columns[3][..], &columns[4][..], &columns[5][..], &columns[6][..]]);
            let (cells, counts) = signs_of_points(&points).unwrap();
            prop_assert_eq!(counts.f64 + counts.double_double + counts.exact, cells.len() as u64);
            for (index, cell) in cells.iter().enumerate() {
                let groups = points.map(|column| exact(column[index])).groups();
                prop_assert_eq!(cell.transition_sign(), transition_sign(&groups));
                prop_assert_eq!(cell.boundary_sign(), boundary_sign(&groups));
            }
            let mut plain = vec![SignPair::UNDECIDED; cells.len()];
            let mut vector = plain.clone();
            PointLoop { columns: &points, cells: &mut plain }.run();
            run_on_widest_unit(PointLoop { columns: &points, cells: &mut vector });
            prop_assert_eq!(plain, vector);
        }
    }

    fn all_one_but_stress<'a>(one: &'a [f64], stress: &'a [f64]) -> Parameters<&'a [f64]> {
        Parameters::from([one, one, one, one, one, stress, one])
    }

    #[test]
    fn columns_of_unequal_length_and_values_out_of_range_are_refused() {
        let classify = |stress: &[f64]| signs_of_points(&all_one_but_stress(&[1.0], stress));
        assert!(classify(&[1.0]).is_some());
        assert!(classify(&[1.0, 2.0]).is_none());
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(classify(&[bad]).is_none());
        }
    }
}
