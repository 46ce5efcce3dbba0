//! The loop over points in vector units: what double-double says of each.

use crate::friction::Parameters;
use crate::number::Dd;
use crate::number::dispatch::{Kernel, run_on_widest_unit};
use crate::stability::certain_signs::InputError;
use crate::stability::point_values::{FIELDS, PointValues, Route};

/// Points worked on at a time: their columns stay in the first-level cache.
pub(in crate::stability) const BLOCK: usize = 64;

/// The values of at most [`BLOCK`] points, in their order.
pub(in crate::stability) fn point_values(
    points: &[Parameters<Dd>],
    input_error: InputError,
    route: Route,
) -> Vec<PointValues<f64>> {
    points.chunks(BLOCK).flat_map(|block| values_of_block(block, input_error, route)).collect()
}

fn values_of_block(
    points: &[Parameters<Dd>],
    input_error: InputError,
    route: Route,
) -> impl Iterator<Item = PointValues<f64>> + use<> {
    let count = points.len().min(BLOCK);
    let mut columns =
        Columns { high: [[1.0; BLOCK]; 7], low: [[0.0; BLOCK]; 7], values: [[0.0; BLOCK]; FIELDS] };
    for (index, point) in points.iter().take(count).enumerate() {
        let inputs: [Dd; 7] = (*point).clone().into();
        for (column, input) in inputs.iter().enumerate() {
            columns.high[column][index] = input.hi();
            columns.low[column][index] = input.lo();
        }
    }
    run_on_widest_unit(ValueLoop { columns: &mut columns, count, input_error, route });
    let values = PointValues::from(columns.values);
    (0..count).map(move |index| values.map(|column| column[index]))
}

/// A block of points, a column for each part of an input and for each value.
struct Columns {
    high: [[f64; BLOCK]; 7],
    low: [[f64; BLOCK]; 7],
    values: [[f64; BLOCK]; FIELDS],
}

/// The inner loop over a block of points.
struct ValueLoop<'a> {
    columns: &'a mut Columns,
    count: usize,
    input_error: InputError,
    route: Route,
}

impl ValueLoop<'_> {
    #[inline(always)]
    fn along(self, route: Route) {
        let Columns { high, low, values } = self.columns;
        for index in 0..self.count.min(BLOCK) {
            let input = |column: usize| Dd::from_parts(high[column][index], low[column][index]);
            let point = Parameters::from(std::array::from_fn(input));
            let found: [f64; FIELDS] = PointValues::of(&point, self.input_error, route).into();
            for (column, value) in values.iter_mut().zip(found) {
                column[index] = value;
            }
        }
    }
}

impl Kernel for ValueLoop<'_> {
    #[inline(always)]
    fn run(self) {
        // A constant route in either loop, so that neither has a branch.
        match self.route {
            Route::Deflation => self.along(Route::Deflation),
            Route::Shift => self.along(Route::Shift),
        }
    }
}

/// The values of one point, by the same instructions.
pub(in crate::stability) fn one_point(
    point: &Parameters<Dd>,
    input_error: InputError,
    route: Route,
) -> PointValues<f64> {
    let mut found = [0.0; FIELDS];
    run_on_widest_unit(OnePoint { point, input_error, route, found: &mut found });
    found.into()
}

/// A loop of one pass.
struct OnePoint<'a> {
    point: &'a Parameters<Dd>,
    input_error: InputError,
    route: Route,
    found: &'a mut [f64; FIELDS],
}

impl Kernel for OnePoint<'_> {
    #[inline(always)]
    fn run(self) {
        *self.found = PointValues::of(self.point, self.input_error, self.route).into();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn vector_units_and_the_plain_loop_give_the_same_bits(
            exponents in prop::collection::vec(prop::array::uniform7(-12f64..12.0), 1..40),
        ) {
            let points: Vec<Parameters<Dd>> =
                exponents.iter().map(|e| Parameters::from(e.map(|e| Dd::from(libm::exp10(e))))).collect();
            for route in [Route::Deflation, Route::Shift] {
                let bits = |values: &PointValues<f64>| <[f64; FIELDS]>::from(*values).map(f64::to_bits);
                let vector: Vec<_> = point_values(&points, InputError::None, route).iter().map(bits).collect();
                let plain: Vec<_> =
                    points.iter().map(|point| bits(&PointValues::of(point, InputError::None, route))).collect();
                prop_assert_eq!(vector, plain);
            }
        }
    }
}
