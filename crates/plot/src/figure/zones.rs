//! Outlines of the regions of a grid of classes, so that a map of decisions becomes a zone map.

use super::{Axis, contour};

/// Outlines, in axis values, of the region of each class `0 .. count` in a grid of decisions.
///
/// The grid lies as in [`super::HeatMap`]: `columns` points in each row, rows from `y.min` upwards. The edge between
/// two classes lies half-way between grid points; where more than two regions meet, one of them has the area between.
#[must_use]
pub fn zones_of_grid(
    x: &Axis,
    y: &Axis,
    columns: usize,
    classes: &[usize],
    count: usize,
) -> Vec<Vec<Vec<(f64, f64)>>> {
    let between = contour::areas_between(classes, columns);
    let place = |&(u, v): &(f64, f64)| Some((x.value_at(u)?, y.value_at(v)?));
    (0..count)
        .map(|class| {
            let inside: Vec<f64> = classes.iter().map(|&found| f64::from(u8::from(found == class))).collect();
            let outlines = contour::outlines(&inside, columns, &|value| value > 0.5, &|_, _| 0.5);
            let between = between.iter().filter(|(of, _)| *of == class).map(|(_, outline)| outline);
            outlines.iter().chain(between).map(|outline| outline.iter().filter_map(place).collect()).collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area, positive where the outline turns to the left.
    fn turned(outline: &[(f64, f64)]) -> f64 {
        let ends = outline.iter().zip(outline.iter().cycle().skip(1));
        ends.map(|(one, other)| one.0 * other.1 - other.0 * one.1).sum()
    }

    #[test]
    fn the_zones_of_any_grid_cover_the_plane_once() {
        let (x, y) = (Axis::linear("x", "", 0.0, 1.0), Axis::linear("y", "", 0.0, 1.0));
        let mut seed = 1_u64;
        for count in 2..6 {
            let mut class = || {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (seed >> 33) as usize % count
            };
            let classes: Vec<usize> = (0..42).map(|_| class()).collect();
            let zones = zones_of_grid(&x, &y, 7, &classes, count);
            let covered: f64 = zones.iter().flatten().map(|outline| turned(outline)).sum();
            assert!((covered - 2.0).abs() < 1e-12, "{covered} {classes:?}");
        }
    }
}
