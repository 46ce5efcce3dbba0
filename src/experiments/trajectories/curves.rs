//! From runs to curves: series, axes that fit them, and the words for a point of the plane.

use crate::experiments::SceneOutcome;
use crate::experiments::trajectories::{Moment, TrajectoryRun};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Axis, PointMark, Series, Side};

/// The runs of one law whose point's id starts so, in the scene's order.
pub(crate) fn runs_of<'s>(
    scene: &'s SceneOutcome,
    prefix: &str,
    law: EvolutionLaw,
) -> Vec<&'s TrajectoryRun> {
    let all = scene.trajectories.iter().flatten();
    all.filter(|run| run.law == law && run.point.id.starts_with(prefix)).collect()
}

/// A run as a line; empty where it failed.
pub(crate) fn series(label: String, run: &TrajectoryRun, place: impl Fn(&Moment) -> (f64, f64)) -> Series {
    let moments = run.course.iter().flat_map(|course| &course.moments);
    Series::line(label, moments.map(place).collect())
}

/// V/V_l; zero, which a logarithmic axis leaves out, below the range of 64-bit numbers.
pub(crate) fn velocity_ratio(moment: &Moment) -> f64 {
    libm::exp(moment.log_velocity_ratio)
}

/// The least and the largest of some values.
pub(crate) fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter(|value| value.is_finite()).fold(None, |found, value| match found {
        None => Some((value, value)),
        Some((least, most)) => Some((value.min(least), value.max(most))),
    })
}

/// A linear axis a twentieth wider on either side than the values on it.
pub(crate) fn linear_axis(title: &str, unit: &str, values: impl Iterator<Item = f64>) -> Option<Axis> {
    let (least, most) = extent(values)?;
    let room = if most > least { 0.05 * (most - least) } else { 0.5 };
    Some(Axis::linear(title, unit, least - room, most + room))
}

/// Above this many Pa a stress axis counts in kPa.
const MOST_PA: f64 = 2000.0;

/// The unit of stress that keeps the labels of an axis short, and its size in Pa.
pub(crate) fn stress_unit(values: impl Iterator<Item = f64>) -> (&'static str, f64) {
    let largest = values.map(f64::abs).fold(0.0, f64::max);
    if largest > MOST_PA { ("kPa", 1000.0) } else { ("Pa", 1.0) }
}

/// A value of one or two digits as markup: `10^{−5}`, `3·10^{−4}`.
pub(crate) fn power_markup(value: f64) -> String {
    let exponent = libm::floor(libm::log10(value) + 1e-9);
    let digits = libm::round(value / libm::exp10(exponent) * 10.0) / 10.0;
    let sign = if exponent < 0.0 { "−" } else { "" };
    let power = format!("10^{{{sign}{}}}", exponent.abs());
    if digits == 1.0 { power } else { format!("{digits}·{power}") }
}

/// The slip modes of theory and simulation as a heading says them.
pub(crate) fn mode_words(run: &TrajectoryRun) -> [String; 2] {
    let theory = run.theory.slip_mode;
    let second = match &run.simulation {
        Ok(found) if found.slip_mode == theory => "by theory and by simulation".into(),
        Ok(found) => format!("by theory; simulated: {}", found.slip_mode.words()),
        Err(_) => "by theory; not simulated".into(),
    };
    [theory.words().into(), second]
}

/// The points of a scene whose id starts so, as marks over a map; `label` names them, or some of them.
pub(crate) fn point_marks(
    scene: &SceneOutcome,
    prefix: &str,
    label: impl Fn(&str) -> String,
    side: Side,
) -> Vec<PointMark> {
    let points = scene.scene.trajectories.iter().flat_map(|section| &section.points);
    points
        .filter(|point| point.id.starts_with(prefix))
        .map(|point| {
            PointMark::new(
                label(&point.id),
                (nearest_f64(&point.loading_velocity_m_per_s), nearest_f64(&point.normal_stress_pa)),
                side,
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_ten_stands_alone_and_a_multiple_has_its_digits() {
        assert_eq!(power_markup(1e-5), "10^{−5}");
        assert_eq!(power_markup(3e-4), "3·10^{−4}");
        assert_eq!(power_markup(1e6), "10^{6}");
    }
}
