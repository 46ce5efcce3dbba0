//! Whether the two evolution laws end alike, on the grid and next to K = K_c.

use crate::claims::simulated::{evidence, grids};
use crate::claims::{Evidence, Finding};
use crate::experiments::near_transition::{
    CycleFamilyOutcome, Edge, NearRun, NearTransitionOutcome, place_on_transition,
};
use crate::experiments::{Context, Outcome, SceneOutcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::{Side, rational_to_decimal, round_digits, rounded};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::theory::hopf::{Criticality, degenerate_inertial_parameter, quasi_static_centre};

/// The widest edge of bistability: its family and where it is.
type Widest<'c> = (&'c CycleFamilyOutcome, &'c Edge);

pub(super) fn laws_end_alike(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let by = |law| grids.iter().find(|grid| grid.law == law);
    let (Some(slip), Some(aging)) = (by(EvolutionLaw::Slip), by(EvolutionLaw::Aging)) else {
        return Err(Finding::not_checked("The report does not simulate both laws."));
    };
    let missing = || Finding::not_checked("The report has no runs next to K = K_c.");
    let scene = context.outcome.potentially_unstable().ok_or_else(missing)?;
    let near = scene.near_transition.as_ref().ok_or_else(missing)?;
    consistent(near)?;
    let pairs = || slip.runs.iter().zip(&aging.runs);
    let contradicting = pairs().filter(|(slip, aging)| slip.periodic() != aging.periodic()).count();
    let renamed = pairs().filter(|(slip, aging)| !slip.is(aging.simulation.slip_mode)).count();
    let points = slip.runs.len();
    let proofs = EvolutionLaw::ALL.into_iter().flat_map(|law| {
        let hopf = context.hopf_coefficient(law).map(|hopf| hopf.proof.clone());
        [hopf, quasi_static_centre(context.equations, law)]
    });
    let finding = Finding::from_proofs(proofs)
        .with_evidence(evidence(
            &grids,
            "Grid points where the laws differ in stability (in slip mode)",
            format!("{contradicting} ({renamed}) of {points}"),
        ))
        .with_evidence(runs_evidence(near))
        .with_evidence(families_evidence(near))
        .require(contradicting == 0, || format!("{contradicting} grid points differ in stability"));
    let finding = finding.remark("The criteria of the linear theory are the same for both laws: the laws differ after a finite disturbance.");
    let finding = match proved(near) {
        [0, 0] => finding,
        proved => finding.with_evidence(certified_evidence(proved)),
    };
    let finding = below(near, finding);
    let coexisting = coexisting(near);
    match widest(near)? {
        Some(widest) => Ok(bistable(finding, scene, near, widest, &coexisting)),
        None if !coexisting.is_empty() => Ok(finding.refuted(ends(&coexisting))),
        None if renamed == 0 => Ok(finding),
        None => Ok(finding.refuted(format!("{renamed} of {points} cycles differ so much in period that their slip modes differ; the stability is the same everywhere"))),
    }
}

/// Small cycles must stand on the side of K = K_c that the exact sign of the coefficient says: otherwise one of the two is wrong.
fn consistent(near: &NearTransitionOutcome) -> Result<(), Finding> {
    let sides = |family: &&CycleFamilyOutcome| match (family.cycles.first(), family.criticality()) {
        (Some(cycle), Criticality::Subcritical) => cycle.excess > 0.0,
        (Some(cycle), Criticality::Supercritical) => cycle.excess < 0.0,
        (_, Criticality::Degenerate) => true,
        (None, _) => false,
    };
    match near.families.iter().find(|family| !sides(family)) {
        None => Ok(()),
        Some(family) => Err(Finding::not_checked(format!(
            "With the {} law at η = {}, no small cycle was found on the side of K = K_c that the first Lyapunov coefficient predicts.",
            family.law.as_str(),
            rational_to_decimal(&family.inertial_parameter, 6)
        ))),
    }
}

/// Whether every run of a law next to K = K_c ends as the sign of K − K_c says.
pub(super) fn ends_next_to_transition(near: &NearTransitionOutcome, law: EvolutionLaw) -> Finding {
    let runs = || near.runs.iter().filter(|run| run.law == law);
    let contradicts = |run: &&NearRun| run.periodic() == Some(run.stiffness_over_critical > 1);
    let (wrong, open): (Vec<_>, usize) =
        (runs().filter(contradicts).collect(), runs().filter(|run| run.periodic().is_none()).count());
    let finding = Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "Runs next to K = K_c, {} law: as the sign of K − K_c, against it, without a result",
            law.as_str()
        ),
        value: format!("{}, {}, {open}", runs().count() - wrong.len() - open, wrong.len()),
        error: "each result is the same at two tolerances".into(),
        runs: runs().count(),
    });
    match (wrong.is_empty(), open) {
        (false, _) => finding.refuted(format!("{} runs: {}", wrong.len(), names(&wrong))),
        (true, 0) => finding.on(format!("{} runs next to K = K_c", runs().count())),
        (true, _) => Finding::not_checked(format!("{open} runs next to K = K_c have no result.")),
    }
}

/// Where K < K_c no run may end in sliding.
fn below(near: &NearTransitionOutcome, finding: Finding) -> Finding {
    let decays: Vec<&NearRun> = near
        .runs
        .iter()
        .filter(|run| run.stiffness_over_critical < 1 && run.periodic() == Some(false))
        .collect();
    finding.require(decays.is_empty(), || format!("Runs with K < K_c end in sliding: {}", names(&decays)))
}

fn coexisting(near: &NearTransitionOutcome) -> Vec<&NearRun> {
    near.runs.iter().filter(|run| run.stiffness_over_critical > 1 && run.periodic() == Some(true)).collect()
}

fn widest(near: &NearTransitionOutcome) -> Result<Option<Widest<'_>>, Finding> {
    let mut widest: Option<Widest<'_>> = None;
    for family in &near.families {
        let edge = family.edge.as_ref().map_err(|failure| {
            Finding::not_checked(format!("A family of cycles could not be followed: {failure}"))
        })?;
        if let Some(edge) = edge
            && widest.is_none_or(|(_, widest)| edge.excess > widest.excess)
        {
            widest = Some((family, edge));
        }
    }
    Ok(widest)
}

/// A stable limit cycle beside stable sliding refutes it; where the strip ends is what is true instead.
fn bistable(
    finding: Finding,
    scene: &SceneOutcome,
    near: &NearTransitionOutcome,
    (family, edge): Widest<'_>,
    coexisting: &[&NearRun],
) -> Finding {
    let count = near.families.iter().filter(|family| matches!(family.edge, Ok(Some(_)))).count();
    let [proved, _] = proved(near);
    let law = family.law.as_str();
    let widest = format!("K/K_c = 1 + {}", round_digits(edge.excess, 5));
    let finding = finding.number("widest", rounded(1.0 + edge.excess, 5, Side::Above)).refuted(format!(
        "with the {law} law a stable limit cycle coexists with stable sliding up to {widest} (± {}) at η = {}, the largest range for {count} values of η; at {proved} stiffnesses below these limits this is proved; {}",
        round_digits(edge.error, 1),
        rational_to_decimal(&family.inertial_parameter, 6),
        ends(coexisting)
    ));
    match place(scene, near) {
        Some(place) => finding.remark(place),
        None => finding,
    }
}

/// Where the strip lies in the plane of the paper's maps, and whether the grid could show it.
fn place(scene: &SceneOutcome, near: &NearTransitionOutcome) -> Option<String> {
    let parameters = scene.slider()?;
    let limit = degenerate_inertial_parameter(nearest_f64(&parameters.effect_ratio()));
    let [velocity, stress] = place_on_transition(parameters, limit);
    let edges = near.families.iter().filter_map(|family| family.edge.as_ref().ok()?.as_ref());
    let width = edges.map(|edge| edge.width_dex).fold(0.0, f64::max);
    let stresses = scene.scene.simulations.as_ref()?.rectangle.normal_stress_pa.coordinates();
    let step = stresses.windows(2).map(|pair| libm::log10(pair[1] / pair[0])).fold(f64::INFINITY, f64::min);
    Some(format!(
        "For the parameters of the simulations, the bistable strip follows K = K_c on the low-velocity side of the point V_l = {} m/s, σ = {} Pa, where η = η_0 = 1/(3 + 2√(β + 3)) = {}. It is at most {} dex of normal stress wide. The steps of the grid are {} dex, so the map does not show it.",
        round_digits(velocity, 3),
        round_digits(stress, 3),
        round_digits(limit, 4),
        round_digits(width, 2),
        round_digits(step, 2),
    ))
}

fn ends(runs: &[&NearRun]) -> String {
    format!("{} runs with K > K_c end on a limit cycle: {}", runs.len(), names(runs))
}

fn names(runs: &[&NearRun]) -> String {
    let decimal = |value: &Rational| rational_to_decimal(value, 6);
    let name = |run: &&NearRun| {
        let (ratio, inertial) = (decimal(&run.stiffness_over_critical), decimal(&run.inertial_parameter));
        format!("{} at K/K_c = {ratio}, η = {inertial}", run.law.as_str())
    };
    runs.iter().map(name).collect::<Vec<_>>().join("; ")
}

fn runs_evidence(near: &NearTransitionOutcome) -> Evidence {
    let count = |end: Option<bool>, above: bool| {
        let side = |run: &&NearRun| (run.stiffness_over_critical > 1) == above;
        near.runs.iter().filter(side).filter(|run| run.periodic() == end).count()
    };
    Evidence::Simulation {
        quantity:
            "Runs next to K = K_c that end on a limit cycle / in steady sliding / without a result, for K < K_c and for K > K_c"
                .into(),
        value: [false, true]
            .map(|above| [Some(true), Some(false), None].map(|end| count(end, above).to_string()).join(" / "))
            .join(" and "),
        error: "each result is the same at two tolerances".into(),
        runs: near.runs.len(),
    }
}

fn families_evidence(near: &NearTransitionOutcome) -> Evidence {
    let above = |law: EvolutionLaw| {
        let of_law = near.families.iter().filter(|family| family.law == law);
        let excess = of_law.flat_map(|family| &family.cycles).map(|cycle| cycle.excess);
        format!("{}: {:+.1e}", law.as_str(), excess.fold(f64::NEG_INFINITY, f64::max))
    };
    Evidence::Sample {
        quantity: "Largest K/K_c − 1 among the cycles found by Newton's method on the return map".into(),
        value: EvolutionLaw::ALL.map(above).join("; "),
        points: near.families.iter().map(|family| family.cycles.len()).sum(),
    }
}

/// At how many stiffnesses above K_c bistability is proved, and at how many it was tried.
fn proved(near: &NearTransitionOutcome) -> [usize; 2] {
    let edges = near.families.iter().filter_map(|family| family.edge.as_ref().ok()?.as_ref());
    let thresholds = edges.filter_map(|edge| edge.threshold.as_ref());
    thresholds.fold([0, 0], |[proved, tried], at| [proved + usize::from(at.coexistence.is_ok()), tried + 1])
}

fn certified_evidence([proved, tried]: [usize; 2]) -> Evidence {
    Evidence::Enclosure {
        quantity: "Stiffnesses above K_c at which bistability is proved".into(),
        value: format!("{proved} of {tried}"),
    }
}
