//! Claim N4: whether the two evolution laws end alike, on the grid and next to K = K_c.

use crate::claims::simulated::{evidence, grids, outcome};
use crate::claims::{Context, Evidence, Finding};
use crate::friction::EvolutionLaw;
use crate::number::format::rational_to_decimal;
use crate::study::{NearRun, Outcome};

pub(super) fn n4(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let by = |law| grids.iter().find(|grid| grid.law == law);
    let (Some(slip), Some(aging)) = (by(EvolutionLaw::Slip), by(EvolutionLaw::Aging)) else {
        return Err(Finding::not_checked("The report does not simulate both laws."));
    };
    let pairs = || slip.runs.iter().zip(&aging.runs);
    let contradicting = pairs().filter(|(slip, aging)| slip.periodic() != aging.periodic()).count();
    let renamed = pairs().filter(|(slip, aging)| !slip.is(aging.simulation.slip_mode)).count();
    let points = slip.runs.len();
    let finding = Finding::from_proofs([])
        .with_evidence(evidence(
            &grids,
            "Grid points where the laws differ in stability (in slip mode)",
            format!("{contradicting} ({renamed}) of {points}"),
        ))
        .require(contradicting == 0, || format!("{contradicting} grid points differ in stability"));
    let near = &outcome(context, Outcome::potentially_unstable)?.near_transition;
    if let Some(run) = near.iter().find(|run| run.periodic().is_none()) {
        return Err(Finding::not_checked(format!(
            "The {} law has no result near K = K_c.",
            run.law.as_str()
        )));
    }
    let coexisting: Vec<&NearRun> =
        near.iter().filter(|run| run.stiffness_over_critical > 1 && run.periodic() == Some(true)).collect();
    let finding = finding.with_evidence(near_evidence(near));
    let Some(farthest) =
        coexisting.iter().max_by(|x, y| x.stiffness_over_critical.cmp(&y.stiffness_over_critical))
    else {
        return Ok(if renamed == 0 {
            finding
        } else {
            finding.within(format!("the same stability everywhere; {renamed} of {points} cycles differ in period enough to be named differently"))
        });
    };
    let ratio = rational_to_decimal(&farthest.stiffness_over_critical, 6);
    let inertial = rational_to_decimal(&farthest.inertial_parameter, 6);
    Ok(finding
        .within(format!("infinitesimal disturbances: at η = {inertial} the start V_l/10 still reaches a limit cycle at K/K_c = {ratio} with the {} law, where steady sliding is stable", farthest.law.as_str()))
        .outside(format!("{} runs with K > K_c end on a limit cycle: {}", coexisting.len(), names(&coexisting))))
}

fn names(runs: &[&NearRun]) -> String {
    let name = |run: &&NearRun| {
        format!("{} at {}", run.law.as_str(), rational_to_decimal(&run.stiffness_over_critical, 6))
    };
    runs.iter().map(name).collect::<Vec<_>>().join(", ")
}

fn near_evidence(near: &[NearRun]) -> Evidence {
    let end = |run: &NearRun| {
        let end = if run.periodic() == Some(true) { "cycle" } else { "decay" };
        format!("{} {} {end}", run.law.as_str(), rational_to_decimal(&run.stiffness_over_critical, 6))
    };
    Evidence::Simulation {
        quantity: "Late behaviour next to the transition: law, K/K_c, end".into(),
        value: near.iter().map(end).collect::<Vec<_>>().join(", "),
        error: "each end is the same at two tolerances".into(),
        runs: near.len(),
    }
}
