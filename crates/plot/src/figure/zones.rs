//! Outlines of the regions of a grid of classes, so that a map of decisions becomes a zone map.

use super::{Axis, contour};

/// Outlines, in axis values, of the region of each class `0 .. count` in a grid of decisions.
///
/// The grid lies as in [`super::HeatMap`]: `columns` points in each row, rows from `y.min` upwards. The edge between
/// two classes lies half-way between grid points.
#[must_use]
pub fn zones_of_grid(
    x: &Axis,
    y: &Axis,
    columns: usize,
    classes: &[usize],
    count: usize,
) -> Vec<Vec<Vec<(f64, f64)>>> {
    (0..count)
        .map(|class| {
            let inside: Vec<f64> = classes.iter().map(|&found| f64::from(u8::from(found == class))).collect();
            let outlines = contour::outlines(&inside, columns, &|value| value > 0.5, &|_, _| 0.5);
            outlines.into_iter().map(|outline| to_values(x, y, &outline)).collect()
        })
        .collect()
}

fn to_values(x: &Axis, y: &Axis, outline: &[(f64, f64)]) -> Vec<(f64, f64)> {
    outline.iter().filter_map(|&(u, v)| Some((x.value_at(u)?, y.value_at(v)?))).collect()
}
