//! Claims N on which slip mode a simulation ends in: transition, six modes, both laws, critical damping.

use std::slice;

use crate::claims::certified::remark;
use crate::claims::computed::either;
use crate::claims::overshoot::Overshoots;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Run, Runs, certificates, error_of, evidence, for_each_law, grids};
use crate::claims::simulated_courses::visible_peaks;
use crate::claims::simulated_damping::{onset_in_normal_stress, visible_onset};
use crate::claims::simulated_laws::{ends_next_to_transition, laws_end_alike};
use crate::claims::simulated_least_peak::{peak_along_velocity, velocity_of_least_peak};
use crate::claims::simulated_onset::onset_in_velocity;
use crate::claims::simulated_transition::{
    cycles_at_one_velocity, harmonic_distortion, period_at_least_peak,
};
use crate::claims::simulated_trends::{
    drop_and_period_fall, natural_period_s, peak_rises, period_of_vibration,
};
use crate::claims::{Check, Evidence, Finding};
use crate::experiments::certificates::Certificates;
use crate::experiments::{Context, Need, Outcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::stability::SlipMode;

const NEEDS: &[Need] = &[Need::Simulations];
/// Of claims that certificates decide where there are any.
const CERTIFIED_NEEDS: &[Need] = &[Need::Simulations, Need::Certificates];

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "ends-by-stiffness",
        is_of_runs: true,
        needs: &[Need::Simulations, Need::NearTransition, Need::Certificates],
        decide: |context, _| either(long_term(context)),
    },
    Check {
        name: "modes-by-theory",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(modes_by_theory(context)),
    },
    Check {
        name: "peak-rises",
        is_of_runs: true,
        needs: CERTIFIED_NEEDS,
        decide: |context, _| either(peak_rises(context)),
    },
    Check {
        name: "laws-end-alike",
        is_of_runs: true,
        needs: &[Need::Simulations, Need::NearTransition],
        decide: |context, _| either(laws_end_alike(context)),
    },
    Check {
        name: "drop-and-period-fall",
        is_of_runs: true,
        needs: CERTIFIED_NEEDS,
        decide: |context, _| either(drop_and_period_fall(context)),
    },
    Check {
        name: "onset-in-velocity",
        is_of_runs: true,
        needs: &[Need::Onset],
        decide: |context, _| either(onset_in_velocity(context)),
    },
    Check {
        name: "velocity-of-least-peak",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(velocity_of_least_peak(context)),
    },
    Check {
        name: "peak-along-velocity",
        is_of_runs: true,
        needs: CERTIFIED_NEEDS,
        decide: |context, _| either(peak_along_velocity(context)),
    },
    Check {
        name: "runs-that-strengthen",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(strengthening_runs(context)),
    },
    Check {
        name: "period-of-vibration",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(period_of_vibration(context)),
    },
    Check {
        name: "onset-in-normal-stress",
        is_of_runs: true,
        needs: &[Need::Onset],
        decide: |context, _| either(onset_in_normal_stress(context)),
    },
    Check {
        name: "period-at-least-peak",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(period_at_least_peak(context)),
    },
    Check {
        name: "harmonic-distortion",
        is_of_runs: true,
        needs: NEEDS,
        decide: |context, _| either(harmonic_distortion(context)),
    },
    Check {
        name: "visible-onset",
        is_of_runs: true,
        needs: &[Need::Onset],
        decide: |context, _| either(visible_onset(context)),
    },
    Check {
        name: "visible-peaks",
        is_of_runs: true,
        needs: &[Need::Trajectories],
        decide: |context, _| either(visible_peaks(context)),
    },
    Check {
        name: "cycles-at-one-velocity",
        is_of_runs: true,
        needs: CERTIFIED_NEEDS,
        decide: |context, _| either(cycles_at_one_velocity(context)),
    },
];

fn long_term(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let words = |law: EvolutionLaw| format!("{} law", law.as_str());
    let on_the_grid = Draft::new("the simulations on the grid of fig 3a");
    let on_the_grid =
        grids.iter().fold(on_the_grid, |draft, grid| draft.part(words(grid.law), ends_by_stiffness(grid)));
    let everywhere = Draft::new("every simulation, at any distance from K = K_c");
    let near = context.outcome.potentially_unstable().and_then(|scene| scene.near_transition.as_ref());
    let everywhere = grids.iter().fold(everywhere, |draft, grid| {
        let none = || Finding::not_checked("The report has no runs next to K = K_c.");
        draft.part(words(grid.law), near.map_or_else(none, |near| ends_next_to_transition(near, grid.law)))
    });
    let certificates = certificates(context, Outcome::potentially_unstable);
    let scope =
        || "The certificate of a cycle proves that it exists and attracts, not that this run ends on it.";
    Ok(of_readings([on_the_grid, everywhere])
        .with_remark(certificates.map(|_| scope().into()))
        .with_remark(remark(certificates))
        .with_remark(certificates.and_then(Certificates::missing)))
}

/// Whether every run of one law's grid ends as the sign of K − K_c says.
fn ends_by_stiffness(grid: &Runs) -> Finding {
    let ratios = || grid.runs.iter().filter_map(|run| run.stiffness_over_critical);
    let below = ratios().filter(|ratio| *ratio < 1.0).fold(0.0, f64::max);
    let above = ratios().filter(|ratio| *ratio > 1.0).fold(f64::INFINITY, f64::min);
    let cycles = grid.runs.iter().filter(|run| run.periodic()).count();
    let value = format!("{cycles} limit cycles, {} decays", grid.runs.len() - cycles);
    let quantity = format!("Long-term behaviour, {} law", grid.law.as_str());
    let wrong: Vec<_> =
        grid.runs.iter().filter(|run| run.periodic() != (run.theory.transition_sign < 0)).collect();
    let finding = Finding::from_evidence(evidence(slice::from_ref(grid), &quantity, value));
    let finding = certified_ends(grid).into_iter().fold(finding, Finding::with_supporting);
    finding
        .require(wrong.is_empty(), || {
            format!("{} runs contradict the sign of K − K_c: {}", wrong.len(), wrong[0].place())
        })
        .on(format!(
            "{} runs from steady state at V_l/10, K/K_c up to {} and from {}",
            grid.runs.len(),
            round_digits(below, 4),
            round_digits(above, 4)
        ))
}

/// The certified limit cycles and decays of a grid, if there are any.
fn certified_ends(grid: &Runs) -> Option<Evidence> {
    let proofs = || grid.runs.iter().filter_map(|run| run.certificate);
    let cycles = proofs().filter(|proof| proof.period_s().is_some()).count();
    let decays = proofs().count() - cycles;
    (cycles + decays > 0).then(|| Evidence::Enclosure {
        quantity: format!("Certificates, {} law", grid.law.as_str()),
        value: format!("{cycles} limit cycles, {decays} decays"),
    })
}

/// The six conditions of section 3.1 in its order: the sign of K_c − K, whether max Im(s) is 0, and whether it is near ω_n; and the
/// slip mode that each gives.
const CONDITIONS: [(bool, Option<bool>, SlipMode); 6] = [
    (true, None, SlipMode::StickSlip),
    (true, Some(false), SlipMode::StickSlip),
    (false, Some(false), SlipMode::NonInertialUnderdampedOscillation),
    (true, Some(true), SlipMode::HarmonicVibration),
    (false, None, SlipMode::OverdampedStableSliding),
    (false, Some(true), SlipMode::InertialUnderdampedOscillation),
];

fn modes_by_theory(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let natural_per_s = std::f64::consts::TAU / natural_period_s(context)?;
    let by_threshold = |run: &Run| {
        use SlipMode::{HarmonicVibration, InertialUnderdampedOscillation};
        matches!(run.theory.slip_mode, HarmonicVibration | InertialUnderdampedOscillation)
    };
    let within_a_tenth =
        |run: &Run| run.theory.max_imaginary_per_s.to_f64().unwrap_or(0.0) >= (1.0 - NEAR) * natural_per_s;
    let written = Draft::new("max Im(s) is near ω_n from √½ ω_n on");
    let written = CONDITIONS.into_iter().fold(written, |draft, condition| {
        draft.part(condition_words(condition), ends_in(&grids, condition, &by_threshold))
    });
    let strict = Draft::new("max Im(s) is near ω_n within 10 % of it");
    let strict = CONDITIONS
        .into_iter()
        .filter(|(_, near, _)| *near == Some(true))
        .fold(strict, |draft, one| draft.part(condition_words(one), ends_in(&grids, one, &within_a_tenth)));
    Ok(of_readings([written, strict]))
}

/// The share of ω_n up to which a frequency is near it, where "≈" is read as for every approximate sentence.
const NEAR: f64 = 0.1;

fn condition_words((is_unstable, near, mode): (bool, Option<bool>, SlipMode)) -> String {
    let stiffness = if is_unstable { "K < K_c" } else { "K > K_c" };
    let frequency = match near {
        None => "max Im(s) = 0",
        Some(false) => "0 < max Im(s), far below ω_n",
        Some(true) => "max Im(s) near ω_n",
    };
    format!("{stiffness} and {frequency}: {}", mode.as_str())
}

/// Whether every run under a condition ends in its slip mode.
fn ends_in(
    grids: &[Runs],
    (is_unstable, near, mode): (bool, Option<bool>, SlipMode),
    is_near: &dyn Fn(&Run) -> bool,
) -> Finding {
    let meets = |run: &&Run| {
        let frequency = (run.theory.boundary_sign < 0).then(|| is_near(run));
        (run.theory.transition_sign < 0) == is_unstable && frequency == near
    };
    let runs: Vec<&Run> = grids.iter().flat_map(|grid| &grid.runs).filter(meets).collect();
    let other: Vec<&&Run> = runs.iter().filter(|run| !run.is(mode)).collect();
    let finding = Finding::from_evidence(Evidence::Simulation {
        quantity: format!("Runs under this condition that end in {}", mode.as_str()),
        value: format!("{} of {}", runs.len() - other.len(), runs.len()),
        error: error_of(grids),
        runs: runs.len(),
    });
    let Some(first) = other.first() else { return finding };
    let share = format!("{} of {} runs", other.len(), runs.len());
    finding.number("share", share.clone()).refuted(format!(
        "{share} do not: at {} the slip mode is {}, because the limit cycle is slower than the small oscillation",
        first.place(),
        first.simulation.slip_mode.as_str()
    ))
}

/// Relative deviation of a decay's period from that of the exact pair; 0 without oscillation.
fn period_deviation(run: &Run) -> f64 {
    let exact = run.theory.max_imaginary_per_s.to_f64().unwrap_or(0.0);
    run.simulation.period_s.map_or(0.0, |period| (period * exact / std::f64::consts::TAU - 1.0).abs())
}

fn strengthening_runs(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::intrinsically_stable)?;
    let all: Vec<_> = grids.iter().flat_map(|grid| &grid.runs).collect();
    let ends_in = |mode| all.iter().filter(|run| run.is(mode)).count();
    let deviation = all.iter().map(|run| period_deviation(run)).fold(0.0, f64::max);
    let oscillating = |grid: &Runs| grid.runs.iter().filter(|run| run.simulation.period_s.is_some()).count();
    let wrong = all.iter().find(|run| run.simulation.period_s.is_some() != (run.theory.boundary_sign < 0));
    let overshoots = Overshoots::of(&all);
    let finding = Finding::from_evidence(evidence(
        &grids,
        "Runs that oscillate in the long term",
        for_each_law(&grids, |grid| format!("{} of {}", oscillating(grid), grid.runs.len())),
    ))
    .require(!all.iter().any(|run| run.periodic()), || "a run ends on a limit cycle".into())
    .require(wrong.is_none(), || {
        wrong
            .map_or_else(String::new, |run| format!("{}: oscillation and discriminant disagree", run.place()))
    })
    .with_evidence(evidence(
        &grids,
        "Runs without oscillation: in the upper area, in the lower area",
        format!(
            "{}, {}",
            ends_in(SlipMode::OverdampedOscillation),
            ends_in(SlipMode::OverdampedStableSliding)
        ),
    ))
    .with_evidence(evidence(
        &grids,
        "Largest relative deviation of a period from 2π/max Im(s)",
        round_digits(deviation, 2),
    ))
    .with_evidence(evidence(
        &grids,
        "Largest V/V_l − 1 of the runs without oscillation: upper area, lower area",
        overshoots.text(),
    ));
    Ok(if overshoots.lower > 0.0 { finding.on(overshoots.limit()) } else { finding })
}
