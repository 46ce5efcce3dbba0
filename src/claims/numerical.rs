//! Claims N on which slip mode a simulation ends in: transition, six modes, both laws, critical damping.

use std::slice;

use crate::claims::certified::remark;
use crate::claims::overshoot::Overshoots;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Run, Runs, certificates, error_of, evidence, for_each_law, grids};
use crate::claims::simulated_courses::n15;
use crate::claims::simulated_damping::{n11, n14};
use crate::claims::simulated_laws::{ends_next_to_transition, n4};
use crate::claims::simulated_least_peak::{n7, n8};
use crate::claims::simulated_onset::n6;
use crate::claims::simulated_transition::{n12, n13, n16};
use crate::claims::simulated_trends::{n3, n5, n10, natural_period_s};
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
        id: "N1",
        criterion: "Every run of the grid with K < K_c ends on a limit cycle and every run with K > K_c decays.",
        not_established: "The behaviour between the grid's points and closer to K = K_c than the grid: see N4.",
        needs: &[Need::Simulations, Need::NearTransition, Need::Certificates],
        equations: &[],
        rests_on: &["S1"],
        decide: |context| n1(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N2",
        criterion: "At every grid point, the slip mode determined from the trajectory alone is the slip mode of the exact linear theory.",
        not_established: "The six cases of fig 3b-g themselves, because the text does not state their coordinates. The name of a cycle depends on the threshold ω/ω_n = √½.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["S1", "B1"],
        decide: |context| n2(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N3",
        criterion: "The peak velocity of the limit cycles rises between all neighbouring grid points, along σ and along V_l.",
        not_established: "Monotonic behaviour between the grid's points.",
        needs: CERTIFIED_NEEDS,
        equations: &[],
        rests_on: &["N1"],
        decide: |context| n3(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N4",
        criterion: "Both laws have the same long-term behaviour at every grid point and in every run next to K = K_c, and neither has a limit cycle where K > K_c.",
        not_established: "Starts other than steady state at V_l/10, and limit cycles that continuation from K = K_c does not reach.",
        needs: &[Need::Simulations, Need::NearTransition],
        equations: &["1", "2", "3", "4", "8", "steady-state"],
        rests_on: &["F2"],
        decide: |context| n4(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N5",
        criterion: "For neighbouring stick-slip points at the same V_l, stress drop and period are both smaller at the lower σ.",
        not_established: "Monotonic behaviour between the grid's points.",
        needs: CERTIFIED_NEEDS,
        equations: &[],
        rests_on: &["N1"],
        decide: |context| n5(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N6",
        criterion: "At each σ, small deviations in simulations begin to oscillate at the velocity of the exact boundary, and eq 20 differs from it by at most twice its own leading error bσ/(2KD_c).",
        not_established: "The velocities of the paper's own runs, which only the colours of fig 3a show; starts other than steady state at V_l/10; other definitions of visible oscillation.",
        needs: &[Need::Onset],
        equations: &["20"],
        rests_on: &["B5"],
        decide: |context| n6(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N7",
        criterion: "At every σ above σ_c, the velocity that minimises the peak velocity equals that of eq 18 within the error of the minimisation.",
        not_established: "Minima outside one decade around eq 18; normal stresses below σ_c, where eq 18 lies in the stable zone.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["B4"],
        decide: |context| n7(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N8",
        criterion: "Between neighbouring points at the same σ, the peak velocity falls with V_l in stick-slip and rises with V_l in harmonic vibration.",
        not_established: "Whether another threshold between the two modes gives the same counts.",
        needs: CERTIFIED_NEEDS,
        equations: &[],
        rests_on: &["N1"],
        decide: |context| n8(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N9",
        criterion: "For a > b every run decays, and small deviations oscillate exactly where the discriminant is negative.",
        not_established: "Visible oscillation: an oscillation that decays within a fraction of its period leaves no visible wave.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["S5", "B1"],
        decide: |context| n9(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N10",
        criterion: "The period of every harmonic vibration and of every inertial underdamped oscillation is 2π/√(K/M).",
        not_established: "Periods between the grid's points.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["Q1"],
        decide: |context| n10(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N11",
        criterion: "At each V_l, small deviations in simulations begin to oscillate at the normal stress of the exact boundary, and eq 16 differs from it by at most twice its own leading relative error η.",
        not_established: "Other starts than steady state at V_l/10; velocities next to the corner of eqs 16 and 20.",
        needs: &[Need::Onset],
        equations: &["16"],
        rests_on: &["B2"],
        decide: |context| n11(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N12",
        criterion: "At every σ above σ_c and with both laws, the period of the limit cycle falls below √2 natural periods, and its peak velocity is lowest, at the velocity of eq 18 within the errors of the search.",
        not_established: "Normal stresses below σ_c, where eq 18 lies in the stable zone.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["B4"],
        decide: |context| n12(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N13",
        criterion: "The total harmonic distortion of V on every limit cycle of harmonic vibration is at most 0.1.",
        not_established: "Cycles between the grid's points. Another limit of the distortion gives another range.",
        needs: NEEDS,
        equations: &[],
        rests_on: &["N2"],
        decide: |context| n13(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N14",
        criterion: "At both normal stresses of fig 4, the two slowest of five runs show no second rise and no undershoot, the third only a single visible peak, and the two fastest vibrate visibly and are inertial.",
        not_established: "The paper's own velocities: the text states none, so quarter decades around eq 20 are assumed, with two of them below it. The slip law only.",
        needs: &[Need::Onset],
        equations: &[],
        rests_on: &["N6"],
        decide: |context| n14(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N15",
        criterion: "In the runs of fig 6c, V has at most one visible peak and one visible trough where the oscillation is non-inertial, and more where it is inertial.",
        not_established: "The paper's own points: the text states none, so the points are assumed. The slip law only.",
        needs: &[Need::Trajectories],
        equations: &[],
        rests_on: &["N9"],
        decide: |context| n15(context).unwrap_or_else(|undecided| undecided),
    },
    Check {
        id: "N16",
        criterion: "At every normal stress of fig 3a, the run at 10^-5.5 m/s ends on a limit cycle.",
        not_established: "The normal stresses of the paper's fig 5, whose axis range the text does not state: those of fig 3a are assumed.",
        needs: CERTIFIED_NEEDS,
        equations: &[],
        rests_on: &["N1"],
        decide: |context| n16(context).unwrap_or_else(|undecided| undecided),
    },
];

fn n1(context: &Context) -> Result<Finding, Finding> {
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

fn n2(context: &Context) -> Result<Finding, Finding> {
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
    Ok(of_readings([written, strict])
        .remark("Two of the six conditions give stick-slip, so there are five names for six conditions. No simulation distinguishes these two conditions."))
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

fn n9(context: &Context) -> Result<Finding, Finding> {
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
