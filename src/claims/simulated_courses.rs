//! What the runs of fig 6c show on either side of the frequency threshold.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::experiments::trajectories::{Course, DRAWING_TOLERANCE, TrajectoryRun};
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_core::stability::SlipMode;

/// The points of the scene that stand for fig 6c.
const POINTS: &str = "6c";

/// Smallest deviation from V_l, in V_l, that a reader sees as a peak or trough.
const VISIBLE: f64 = 0.01;

pub(super) fn visible_peaks(context: &Context) -> Result<Finding, Finding> {
    let scene = context.outcome.intrinsically_stable();
    let runs = scene.and_then(|scene| scene.trajectories.as_ref());
    let runs = runs.ok_or_else(|| Finding::not_checked("The report follows no run with a > b."))?;
    let runs = || runs.iter().filter(|run| run.point.id.starts_with(POINTS));
    let of = |mode: SlipMode| runs().filter(|run| run.theory.slip_mode == mode).collect::<Vec<_>>();
    let slow = of(SlipMode::NonInertialUnderdampedOscillation);
    let fast = of(SlipMode::InertialUnderdampedOscillation);
    let (few, many) = (swings(&slow)?, swings(&fast)?);
    let first = |found: &[Vec<f64>]| found.iter().filter_map(|one| one.first().copied()).fold(0.0, f64::max);
    let remark = format!(
        "The first peak is not what separates the two: it is up to {} V_l in non-inertial and up to {} V_l in inertial motion. The troughs and later peaks do.",
        round_digits(first(&few), 3),
        round_digits(first(&many), 3)
    );
    let non_inertial = evidence("Non-inertial", &slow, &few)
        .require(few.iter().all(|one| one.len() <= 2), || "V turns more than twice".into())
        .on(format!("{} runs of the report at assumed points", slow.len()));
    let inertial = evidence("Inertial", &fast, &many)
        .require(many.iter().all(|one| one.len() > 2), || "V turns at most twice".into())
        .on(format!("{} runs of the report at assumed points", fast.len()));
    let written = Draft::new("peaks and troughs of V that differ from V_l by at least 1 %")
        .part("non-inertial underdamped motion has at most one peak and one trough", non_inertial)
        .part("inertial underdamped motion goes on oscillating", inertial);
    Ok(of_readings([written]).remark(remark))
}

/// V/V_l at the visible peaks and troughs of each run, in order of time.
fn swings(runs: &[&TrajectoryRun]) -> Result<Vec<Vec<f64>>, Finding> {
    let failed = |_| Finding::not_checked("A run of fig 6c has no result.");
    runs.iter().map(|run| run.course.as_ref().map(turns).map_err(failed)).collect()
}

fn turns(course: &Course) -> Vec<f64> {
    let velocities: Vec<f64> =
        course.moments.iter().map(|moment| libm::exp(moment.log_velocity_ratio)).collect();
    let turn = |three: &[f64]| {
        let [before, here, after] = three else { return None };
        ((here - before) * (after - here) < 0.0 && (here - 1.0).abs() >= VISIBLE).then_some(*here)
    };
    velocities.windows(3).filter_map(turn).collect()
}

fn evidence(name: &str, runs: &[&TrajectoryRun], found: &[Vec<f64>]) -> Finding {
    let place = |run: &&TrajectoryRun| rational_to_decimal(&run.point.loading_velocity_m_per_s, 4);
    let turns = |one: &Vec<f64>| one.iter().map(|turn| round_digits(*turn, 3)).collect::<Vec<_>>().join(", ");
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "{name} runs at V_l = {} m/s: V/V_l at successive peaks and troughs",
            runs.iter().map(place).collect::<Vec<_>>().join(", ")
        ),
        value: found.iter().map(turns).collect::<Vec<_>>().join("; "),
        error: format!("{DRAWING_TOLERANCE} of the largest V"),
        runs: runs.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::trajectories::Moment;

    #[test]
    fn only_visible_turns_count() {
        let moment =
            |ratio: f64| Moment { time_s: 0.0, log_velocity_ratio: libm::log(ratio), stress_change_pa: 0.0 };
        let moments = [0.1, 1.5, 0.9, 1.005, 1.0].map(moment).to_vec();
        let found = turns(&Course { moments, sampled: 5, free_residual_pa: 0.0 });
        assert_eq!(found.len(), 2);
        assert!((found[0] - 1.5).abs() < 1e-12 && (found[1] - 0.9).abs() < 1e-12, "{found:?}");
    }
}
