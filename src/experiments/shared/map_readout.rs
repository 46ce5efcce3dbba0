//! What the maps of the (V, σ) plane read out at a point: slip mode, frequency, how far the nearest asymptote is off, and
//! what was simulated there.

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::place;
use crate::experiments::simulations::run::SimulatedPoint;
use slipmode_core::dynamics::Behaviour;
use slipmode_core::stability::Classification;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::figure::{Readout, Words};

/// Points read out along each axis: a page holds them all.
const POINTS: usize = 25;

/// What is reported of theory at a point; certainty: modes and zeros are exact, numbers rounded to three digits.
const THEORY: &str = "V = {x} m/s, σ = {y} Pa: {0}; max Im(s) = {1} 1/s. Nearest asymptote: {2}, with an error of {3} % at the nearest point of the boundary.";

/// The words at a coarse part of the map's grid.
pub(crate) fn readout(map: &Grid<Classification>, boundary: &BoundaryOutcome) -> Readout {
    words(map, &boundary.points, THEORY, |_, point| theory(point).to_vec())
}

/// The words of a map of simulations: those of theory, and what the run did.
pub(crate) fn simulated_readout(grid: &Grid<SimulatedPoint>, boundary: &BoundaryOutcome) -> Readout {
    let sentence = format!("{THEORY} Simulated: {{4}}, peak {{5}} V_l.");
    words(grid, &boundary.points, &sentence, |velocity, point| {
        theory(&point.theory).into_iter().chain(simulated(velocity, point)).collect()
    })
}

fn words<T>(
    grid: &Grid<T>,
    boundary: &[BoundaryPoint],
    sentence: &str,
    fields_at: impl Fn(f64, &T) -> Vec<String>,
) -> Readout {
    let (velocities, stresses) = (&grid.loading_velocity_m_per_s, &grid.normal_stress_pa);
    let places: Vec<BoundaryPlace<'_>> =
        boundary.iter().map(|point| (point, logarithms(place(point)))).collect();
    let mut fields: Vec<Vec<String>> = Vec::new();
    for row in chosen(stresses.len()) {
        for column in chosen(velocities.len()) {
            let Some(point) = grid.values.get(row * velocities.len() + column) else { continue };
            let mut texts = fields_at(velocities[column], point);
            texts.splice(2..2, nearest(&places, velocities[column], stresses[row]));
            fields.resize(texts.len(), Vec::new());
            fields.iter_mut().zip(texts).for_each(|(field, text)| field.push(text));
        }
    }
    let text = |values: &[f64]| chosen(values.len()).map(|index| three_digits(values[index])).collect();
    Readout::Words(Words {
        columns: text(velocities),
        rows: text(stresses),
        sentence: sentence.into(),
        fields,
    })
}

fn theory(found: &Classification) -> [String; 2] {
    [found.slip_mode.words().into(), three_digits(found.max_imaginary_per_s.to_f64().unwrap_or(0.0))]
}

/// What a run did, and its largest velocity over the loading velocity.
fn simulated(velocity: f64, point: &SimulatedPoint) -> [String; 2] {
    let Ok(run) = &point.simulation else { return ["no result".into(), "–".into()] };
    let long_term = match run.behaviour {
        Behaviour::Periodic => "a limit cycle",
        Behaviour::Decaying => "ends in steady sliding",
    };
    [long_term.into(), three_digits(run.peak_velocity_m_per_s / velocity)]
}

/// Evenly spaced places among `count`, the first and the last among them.
fn chosen(count: usize) -> impl Iterator<Item = usize> {
    let (shown, last) = (count.min(POINTS), count.saturating_sub(1));
    (0..shown).map(move |index| index * last / (shown.max(2) - 1))
}

/// A point of the boundary, and where it lies on the logarithmic plane.
type BoundaryPlace<'b> = (&'b BoundaryPoint, (f64, f64));

fn logarithms((velocity, stress): (f64, f64)) -> (f64, f64) {
    (libm::log10(velocity), libm::log10(stress))
}

/// The asymptote that is nearest at the boundary's nearest point, and its error there in percent; nothing without a boundary.
fn nearest(places: &[BoundaryPlace<'_>], velocity: f64, stress: f64) -> [String; 2] {
    let here = logarithms((velocity, stress));
    let distance = |(_, there): &BoundaryPlace<'_>| {
        let (dx, dy) = (there.0 - here.0, there.1 - here.1);
        dx * dx + dy * dy
    };
    let found = places.iter().min_by(|one, two| distance(one).total_cmp(&distance(two)));
    found.map_or_else(Default::default, |(point, _)| {
        let percent = 100.0 * point.relative_error.to_f64();
        [point.asymptote.as_str().replace("eq", "eq "), three_digits(percent)]
    })
}

/// A number to three digits; zero is exact.
pub(crate) fn three_digits(value: f64) -> String {
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
