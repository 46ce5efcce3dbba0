//! Which runs a figure shows, the unit of their stress, and the words and marks for a point of the plane.

use crate::experiments::SceneOutcome;
use crate::experiments::trajectories::{TrajectoryPoint, TrajectoryRun};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{PointMark, Side};

/// The runs of one law whose point's id starts so, in the scene's order.
pub(crate) fn runs_of<'s>(
    scene: &'s SceneOutcome,
    prefix: &str,
    law: EvolutionLaw,
) -> Vec<&'s TrajectoryRun> {
    let all = scene.trajectories.iter().flatten();
    all.filter(|run| run.law == law && run.point.id.starts_with(prefix)).collect()
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

/// The points of a scene whose id starts so, as marks over a map; `label` names them, or some of them.
pub(crate) fn point_marks(
    scene: &SceneOutcome,
    prefix: &str,
    label: impl Fn(&str) -> String,
    side: Side,
) -> Vec<PointMark> {
    let points = scene.scene.trajectories.iter().flat_map(|section| &section.points);
    let mark = |point: &TrajectoryPoint| {
        let place = [&point.loading_velocity_m_per_s, &point.normal_stress_pa].map(nearest_f64);
        PointMark::new(label(&point.id), place.into(), side)
    };
    points.filter(|point| point.id.starts_with(prefix)).map(mark).collect()
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
