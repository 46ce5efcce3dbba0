//! What the maps of the (V, σ) plane read out at a point: slip mode, frequency, and how far the nearest asymptote is off.

use crate::plot::Readout;
use crate::stability::SlipMode;
use crate::stability::boundary::BoundaryPoint;
use crate::study::{BoundaryOutcome, Grid, MapPoint};

/// Points read out along each axis: a page holds them all.
const POINTS: usize = 25;

/// The words at a coarse part of the map's grid.
pub(super) fn readout(map: &Grid<MapPoint>, boundary: &BoundaryOutcome) -> Readout {
    let (velocities, stresses) = (&map.loading_velocity_m_per_s, &map.normal_stress_pa);
    let places: Vec<Place<'_>> = boundary.points.iter().map(Place::of).collect();
    let mut cells = Vec::new();
    for row in chosen(stresses.len()) {
        for column in chosen(velocities.len()) {
            let Some(point) = map.values.get(row * velocities.len() + column) else { continue };
            let mode = SlipMode::ALL.iter().position(|mode| *mode == point.slip_mode).unwrap_or(0);
            let frequency = point.max_imaginary_per_s.to_f64().unwrap_or(0.0);
            let nearest = nearest(&places, velocities[column], stresses[row]);
            cells.push((mode, format!("{}~{nearest}", three_digits(frequency))));
        }
    }
    let text = |values: &[f64]| chosen(values.len()).map(|index| three_digits(values[index])).collect();
    let modes = SlipMode::ALL.iter().map(|mode| mode.as_str().replace('-', " "));
    Readout { columns: text(velocities), rows: text(stresses), cells, shared: modes.collect() }
}

/// Evenly spaced places among `count`, the first and the last among them.
fn chosen(count: usize) -> impl Iterator<Item = usize> {
    let (shown, last) = (count.min(POINTS), count.saturating_sub(1));
    (0..shown).map(move |index| index * last / (shown.max(2) - 1))
}

/// A point of the boundary on the logarithmic plane.
struct Place<'b> {
    point: &'b BoundaryPoint,
    logarithms: (f64, f64),
}

impl<'b> Place<'b> {
    fn of(point: &'b BoundaryPoint) -> Self {
        let (velocity, stress) = (point.loading_velocity_m_per_s.to_f64(), point.normal_stress_pa.to_f64());
        Self { point, logarithms: (libm::log10(velocity), libm::log10(stress)) }
    }
}

/// The asymptote that is nearest at the boundary's nearest point, and its error there in percent.
fn nearest(places: &[Place<'_>], velocity: f64, stress: f64) -> String {
    let here = (libm::log10(velocity), libm::log10(stress));
    let distance = |place: &Place<'_>| {
        let (dx, dy) = (place.logarithms.0 - here.0, place.logarithms.1 - here.1);
        dx * dx + dy * dy
    };
    let found = places.iter().min_by(|one, two| distance(one).total_cmp(&distance(two)));
    found.map_or_else(String::new, |place| {
        let percent = 100.0 * place.point.relative_error.to_f64();
        format!("{}~{}", place.point.asymptote.as_str().replace("eq", "eq "), three_digits(percent))
    })
}

/// A number to three digits; zero is exact.
fn three_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let short = format!("{value:.2e}");
    match short.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()) {
        Some(exponent @ -2..=3) => format!("{value:.*}", usize::try_from(2 - exponent).unwrap_or(0)),
        _ => short,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits_and_zero_is_zero() {
        let all = [0.0, 12.345, -0.012345, 4321.0, 1e-9, 2.5e7].map(three_digits);
        assert_eq!(all, ["0", "12.3", "-0.0123", "4321", "1.00e-9", "2.50e7"]);
    }

    #[test]
    fn the_chosen_points_reach_from_the_first_to_the_last() {
        assert_eq!(chosen(241).collect::<Vec<_>>(), (0..25).map(|i| i * 10).collect::<Vec<_>>());
        assert_eq!(chosen(3).collect::<Vec<_>>(), [0, 1, 2]);
        assert_eq!((chosen(1).count(), chosen(0).count()), (1, 0));
    }
}
