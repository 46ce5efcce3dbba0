//! The friction that eq 1 reaches in runs, and where eq 1 leaves its range.

use crate::claims::computed::either;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Run, Runs, extent, grids, outcome, range, slider};
use crate::claims::{Check, Evidence, Finding};
use crate::experiments::simulations::{RunCourse, StrongVibration, VIBRATION_STEP};
use crate::experiments::{Context, Need, Outcome};
use crate::scene::cited;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use std::f64::consts::{LN_10, PI};

pub(super) const CHECKS: &[Check] = &[Check {
    name: "least-friction",
    is_of_runs: true,
    roles: &[],
    needs: &[Need::Simulations],
    decide: |context, _| either(least_friction_of_runs(context)),
}];

/// Relative difference of two numbers that 64-bit arithmetic does not resolve.
const UNRESOLVED: f64 = f64::EPSILON;

/// Whether the regularised law changes the simulations of one law, for this μ0.
fn regularised(grid: &Runs, direct_effect: f64, reference: f64) -> Finding {
    let law = grid.law.as_str();
    let courses: Option<Vec<(&Run, &RunCourse)>> =
        grid.runs.iter().map(|run| Some((run, run.course?))).collect();
    let Some(courses) = courses else {
        return Finding::not_checked(format!("The friction along a run of the {law} law is unknown."));
    };
    let friction = |course: &RunCourse| direct_effect.mul_add(course.least_friction().value, reference);
    let least = courses.iter().min_by(|one, other| friction(one.1).total_cmp(&friction(other.1)));
    let Some((run, course)) = least else { return Finding::not_checked("The grid has no run.") };
    let negative = courses.iter().filter(|(_, course)| friction(course) < 0.0).count();
    let error = courses.iter().map(|(_, course)| course.least_friction().error).fold(0.0, f64::max);
    let exponent =
        courses.iter().map(|(_, course)| course.regularisation()).fold(f64::NEG_INFINITY, f64::max);
    let log_difference = exponent - 2.0 * reference / direct_effect;
    let difference = format!("1e{}", (log_difference / LN_10).ceil());
    let finding = Finding::from_evidence(Evidence::Simulation {
        quantity: cited(&format!(
            "{law} law, μ0 = {reference}: least friction coefficient by {{friction}} in a run; runs in which it is negative; largest difference of the velocities of the two laws at the same friction and state, in V_l"
        )),
        value: format!(
            "{}; {negative} of {}; below {difference}",
            round_digits(friction(course), 4),
            courses.len()
        ),
        error: format!("{} of the friction coefficient", round_digits(direct_effect * error, 1)),
        runs: courses.len(),
    });
    finding
        .require(log_difference < libm::log(UNRESOLVED), || {
            cited(&format!(
                "{{friction}}'s friction coefficient falls to {} ({}) and is negative in {negative} of {} runs; there the velocities of the two laws differ by up to {difference} V_l",
                round_digits(friction(course), 4),
                run.place(),
                courses.len()
            ))
        })
        .on(cited(&format!(
            "V differs by less than {difference} V_l at the same friction and state, so that no digit of a peak velocity or period changes; {{friction}}'s friction coefficient is as low as {} ({}) and negative in {negative} of {} runs",
            round_digits(friction(course), 4),
            run.place(),
            courses.len()
        )))
}

/// Whether the regularised law changes the simulations of the law of this name.
pub(super) fn in_simulations(context: &Context, law: &str, reference: f64) -> Finding {
    let found = grids(context, Outcome::potentially_unstable).and_then(|grids| {
        let direct_effect = slider(context)?.direct_effect;
        let grid = grids.iter().find(|grid| grid.law.as_str() == law);
        let missing = || Finding::not_checked(format!("The report has no simulations with the {law} law."));
        grid.map(|grid| regularised(grid, direct_effect, reference)).ok_or_else(missing)
    });
    either(found)
}

/// One atomic distance in the age of the universe, m/s.
const SLOWEST_MEANINGFUL: f64 = 1e-10 / 4.35e17;

fn least_friction_of_runs(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let found = &outcome(context, Outcome::potentially_unstable)?.strong_vibrations;
    let effect_ratio = slider(context)?.effect_ratio();
    let draft =
        Draft::new("the least friction of strong vibration, and the least velocity on the grid of fig 3a");
    let draft = grids.iter().fold(draft, |draft, grid| {
        let law = grid.law;
        let series = found.iter().filter(|found| found.law == law).collect::<Vec<_>>();
        draft
            .part(
                format!("{} law: the least friction tends to μ0 − a√(4π(β−1)√(κη))", law.as_str()),
                least_friction(law, &series, effect_ratio),
            )
            .part(
                format!("{} law: the least velocity on the grid is below any meaningful value", law.as_str()),
                least_velocity(grid),
            )
    });
    Ok(of_readings([draft]))
}

/// Value at infinite η of a series whose corrections fall as η^(−1/6), with the change of the extrapolation as its error.
pub(super) fn extrapolated(ratios: &[f64]) -> Option<(f64, f64)> {
    let [.., first, second, third] = ratios else { return None };
    let growth = libm::pow(VIBRATION_STEP, 1.0 / 6.0) - 1.0;
    let limit = |before: f64, after: f64| after + (after - before) / growth;
    let (coarse, fine) = (limit(*first, *second), limit(*second, *third));
    Some((fine, (fine - coarse).abs()))
}

fn least_friction(law: EvolutionLaw, series: &[&StrongVibration], effect_ratio: f64) -> Finding {
    let ratio = |found: &&StrongVibration| {
        let scale = (4.0 * PI * (effect_ratio - 1.0)).sqrt() * libm::pow(found.inertial_parameter, 0.25);
        -found.profile.least_friction.value / scale
    };
    let ratios: Vec<f64> = series.iter().map(ratio).collect();
    let Some((limit, error)) = extrapolated(&ratios) else {
        return Finding::not_checked("Too few runs of strong vibration have a result.");
    };
    let each: Vec<String> = ratios.iter().map(|ratio| round_digits(*ratio, 4)).collect();
    let troughs = extent(series.iter().map(|found| found.log_trough / LN_10));
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "{} law, κ = 1, η = 1e6 to 1e12: (μ0 − μ_min)/a over √(4π(β−1)√(κη)), by η; extrapolated to infinite η; log10(V_min/V_l)",
            law.as_str()
        ),
        value: format!("{}; {}; {}", each.join(", "), round_digits(limit, 4), range(troughs, 4)),
        error: format!("{} of the extrapolation", round_digits(error, 1)),
        runs: series.len(),
    })
    .require((limit - 1.0).abs() <= error, || {
        format!("the ratio tends to {} ± {}", round_digits(limit, 4), round_digits(error, 1))
    })
}

fn least_velocity(grid: &Runs) -> Finding {
    let slowest = |run: &Run| run.simulation.minimum_velocity_log10_ratio + libm::log10(run.velocity_m_per_s);
    let cycles = || grid.runs.iter().filter(|run| run.periodic());
    let below: Vec<&Run> = cycles().filter(|run| slowest(run) < libm::log10(SLOWEST_MEANINGFUL)).collect();
    let errors = || cycles().map(|run| run.simulation.minimum_velocity_log10_error);
    let known = |error: &f64| *error < 1.0;
    let error = errors().filter(known).fold(0.0, f64::max);
    let unknown = errors().filter(|error| !known(error)).count();
    let least = cycles().min_by(|one, other| slowest(one).total_cmp(&slowest(other)));
    let Some(least) = least else { return Finding::not_checked("The grid has no limit cycle.") };
    let inertial = |run: &Run| run.inertial_parameter;
    let from = below.iter().map(|run| inertial(run)).fold(f64::INFINITY, f64::min);
    let mildest = cycles().filter(|run| inertial(run) < from).map(slowest).fold(0.0, f64::min);
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "{} law: limit cycles whose least velocity is below {} m/s, one atomic distance in the age of the universe; their least η; log10 of the least velocity in m/s over all; over those with smaller η",
            grid.law.as_str(),
            round_digits(SLOWEST_MEANINGFUL, 2)
        ),
        value: format!(
            "{} of {}; {}; {}; {}",
            below.len(),
            cycles().count(),
            round_digits(from, 3),
            round_digits(slowest(least), 4),
            round_digits(mildest, 4)
        ),
        error: format!("{} of the logarithm; no estimate for {unknown} runs", round_digits(error, 1)),
        runs: cycles().count(),
    })
    .require(!below.is_empty(), || "no limit cycle is as slow".into())
    .on(format!(
        "{} of {} limit cycles, all with η of at least {}; the slowest at {}",
        below.len(),
        cycles().count(),
        round_digits(from, 3),
        least.place()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_correction_of_the_sixth_root_is_extrapolated_away() {
        let ratio = |eta: f64| 1.0 - 3.0 * libm::pow(eta, -1.0 / 6.0);
        let (limit, error) = extrapolated(&[1e8, 1e10, 1e12].map(ratio)).unwrap();
        assert!((limit - 1.0).abs() < 1e-12 && error < 1e-12, "{limit} {error}");
        assert_eq!(extrapolated(&[1.0, 1.0]), None);
    }
}
