//! Tables of the least friction and the least velocity along runs, and of cycles of strong vibration.

use std::f64::consts::{LN_10, PI};

use super::tables::points;
use super::{StrongVibration, VIBRATION_STEP};
use crate::experiments::shared::cells::Rounded;
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::dynamics::Estimate;
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::Table;

const NEEDS: &[Need] = &[Need::Simulations];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "run-extremes", needs: NEEDS, make: extremes },
    TableMaker { id: "strong-vibration", needs: NEEDS, make: vibrations },
];

/// Digits of values that runs have.
const DIGITS: usize = 7;

fn extremes(context: &Context) -> Option<Table> {
    let of_transition = points(context).filter(|at| at.point.course.is_some());
    table_of("run-extremes", of_transition)
        .text("scene", |at| at.scene().to_owned())
        .text("law", |at| at.law.as_str())
        .digits("normal_stress_pa", DIGITS, |at| Rounded(at.stress))
        .digits("loading_velocity_m_per_s", DIGITS, |at| Rounded(at.velocity))
        .named()
        .text("behaviour", |at| at.run.map(|run| run.behaviour.as_str()))
        .digits("inertial_parameter", DIGITS, |at| Rounded(at.point.inertial_parameter))
        .digits("direct_effect", DIGITS, |at| at.scene.slider().map(|slider| &slider.direct_effect))
        .digits("friction_least", DIGITS, |at| Some(at.point.course?.least_friction().value))
        .digits("friction_error", 2, |at| Some(at.point.course?.least_friction().error))
        .digits("exponent_largest", DIGITS, |at| Some(at.point.course?.regularisation().value))
        .digits("exponent_error", 2, |at| Some(at.point.course?.regularisation().error))
        .digits("velocity_least_log10", DIGITS, |at| {
            Some(at.run?.minimum_velocity_log10_ratio + libm::log10(at.velocity))
        })
        .digits("velocity_error", 2, |at| {
            Some(at.run?.minimum_velocity_log10_error).filter(|error| error.is_finite())
        })
        .text("failure", |at| at.point.simulation.as_ref().err().map(ToString::to_string))
        .table()
}

/// A cycle of strong vibration beside the law of its least friction.
struct Vibration<'c> {
    found: &'c StrongVibration,
    /// μ0 − μ_min over a√(4π(β − 1)√(κη)).
    ratio: f64,
    /// Its value at infinite η.
    limit: Option<Estimate>,
}

fn vibrations(context: &Context) -> Option<Table> {
    let mut rows: Vec<Vibration> = Vec::new();
    for scene in &context.outcome.scenes {
        let Some(excess) = scene.slider().map(|slider| nearest_f64(&slider.effect_ratio()) - 1.0) else {
            continue;
        };
        let start = rows.len();
        for found in scene.simulations.iter().flat_map(|found| &found.strong_vibrations) {
            let scale = (4.0 * PI * excess).sqrt() * libm::pow(found.inertial_parameter, 0.25);
            let ratio = -found.profile.least_friction.value / scale;
            let before: Vec<f64> =
                rows[start..].iter().filter(|row| row.found.law == found.law).map(|row| row.ratio).collect();
            let limit = match before[..] {
                [.., first, second] => Some(extrapolated([first, second, ratio])),
                _ => None,
            };
            rows.push(Vibration { found, ratio, limit });
        }
    }
    table_of("strong-vibration", &rows)
        .text("law", |row: &Vibration| row.found.law.as_str())
        .digits("inertial_parameter", DIGITS, |row| Rounded(row.found.inertial_parameter))
        .named()
        .digits("velocity_least_log10", 5, |row| row.found.log_trough / LN_10)
        .digits("ratio", 5, |row| row.ratio)
        .digits("limit_of_ratio", 5, |row| Some(row.limit?.value))
        .digits("limit_error", 2, |row| Some(row.limit?.error))
        .table()
}

/// Value at infinite η of a series whose corrections fall as η^(−1/6), with the change of the extrapolation as its error.
fn extrapolated([first, second, third]: [f64; 3]) -> Estimate {
    let growth = libm::pow(VIBRATION_STEP, 1.0 / 6.0) - 1.0;
    let limit = |before: f64, after: f64| after + (after - before) / growth;
    let (coarse, fine) = (limit(first, second), limit(second, third));
    Estimate { value: fine, error: (fine - coarse).abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_correction_of_the_sixth_root_is_extrapolated_away() {
        let ratio = |eta: f64| 1.0 - 3.0 * libm::pow(eta, -1.0 / 6.0);
        let Estimate { value, error } = extrapolated([1e8, 1e10, 1e12].map(ratio));
        assert!((value - 1.0).abs() < 1e-12 && error < 1e-12, "{value} {error}");
    }
}
