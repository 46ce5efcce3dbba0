//! The edge of bistability: the largest K/K_c at which a limit cycle coexists with stable sliding, and what start reaches it.

use crate::experiments::near_transition::EdgeLaw;
use slipmode_certified::{Coexistence, Reason, certify_coexistence};
use slipmode_core::dynamics::{
    Control, CycleFamily, Failure, Fold, Integrator, LongTerm, Member, Model, Radau, Start, State,
    long_term_behaviour, start_threshold,
};
use slipmode_core::friction::{Groups, Slider, critical_stiffness_group};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64, parse_decimal};

/// The edge at one η.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// K/K_c − 1 of the fold.
    pub excess: f64,
    /// Its absolute error estimate: the last refinement, and what a tenth of the tolerance changes.
    pub error: f64,
    /// ln(V_peak/V_l) of the cycle there.
    pub log_peak: f64,
    /// Part of `excess` within which runs that start on the fold's cycle confirm it: below the edge they end on a cycle, above it in
    /// sliding. None when no tried part does.
    pub bracket: Option<f64>,
    /// Loading velocity of this η on the line K = K_c of the scene's slider, m/s.
    pub loading_velocity_m_per_s: f64,
    /// Normal stress there, Pa.
    pub normal_stress_pa: f64,
    /// Width of the strip in log10 of the normal stress at that velocity.
    pub width_dex: f64,
    /// The law of the edge as η → 0; none where it has no largest value.
    pub law: Option<EdgeLaw>,
    /// The unstable cycle half-way to the edge; none when it was not reached.
    pub threshold: Option<Threshold>,
}

/// The unstable cycle that parts the starts that decay from those that do not.
#[derive(Debug, Clone, PartialEq)]
pub struct Threshold {
    /// κ, a decimal.
    pub stiffness_group: Rational,
    /// K/K_c − 1.
    pub excess: f64,
    /// ln(V_peak/V_l) of the unstable cycle.
    pub unstable_log_peak: f64,
    /// y = ln(V_l θ/D_c) and ζ of the unstable cycle where V rises through V_l; nothing about them is proved.
    pub crossing: [f64; 2],
    /// V/V_l of the steady sliding from which a run is at the threshold; a slower start ends on the limit cycle.
    pub start_velocity_ratio: f64,
    /// Whether simulations from 2 % in ln(V/V_l) on either side end as the threshold says; none when one has no result.
    pub confirmed: Option<bool>,
    /// Steady sliding and both cycles, proved for the decimals η, κ and β.
    pub coexistence: Result<Coexistence, Reason>,
}

/// Parts of K/K_c − 1 at which runs are tried on both sides of the edge.
const BRACKETS: [f64; 2] = [0.01, 0.1];

/// Digits of κ where cycles are proved: it is far closer to the wanted one than the strip is wide.
pub(super) const DIGITS: usize = 12;

/// Part of ln(V/V_l) by which starts are moved off the threshold.
const START_MARGIN: f64 = 0.02;

/// Permitted relative distance from the cycle, and most returns, of a run that only has to end on one side.
const TARGET: f64 = 1e-6;
const MOST_RETURNS: u64 = 4_000;

/// Tolerances of such a run.
const CONTROL: Control = Control { local_tolerance: 1e-8, most_steps: 1_000_000 };

/// The fold of a family above K = K_c, if it has one.
pub(crate) fn edge(
    parameters: &Slider<Rational>,
    family: &CycleFamily,
    inertial_parameter: &Rational,
    members: &[Member],
    critical: f64,
) -> Result<Option<Edge>, Failure> {
    let finer = CycleFamily { local_tolerance: 0.1 * family.local_tolerance, ..*family };
    let (Some(coarse), Some(fold)) = (family.fold(members)?, finer.fold(members)?) else { return Ok(None) };
    let over_critical = fold.member.stiffness_group / critical;
    let change = (coarse.member.stiffness_group / fold.member.stiffness_group - 1.0).abs();
    let excess = over_critical - 1.0;
    if excess <= 0.0 {
        return Ok(None);
    }
    let groups = |stiffness_group| Groups {
        inertial_parameter: inertial_parameter.clone(),
        stiffness_group,
        effect_ratio: parameters.effect_ratio(),
    };
    let [velocity, stress] = place_on_transition(parameters, family.inertial_parameter);
    Ok(Some(Edge {
        excess,
        error: over_critical * (fold.relative_error + 2.0 * change),
        log_peak: fold.member.orbit.peak,
        bracket: BRACKETS.into_iter().find(|&part| confirms(family, &fold, critical, excess * part)),
        loading_velocity_m_per_s: velocity,
        normal_stress_pa: stress,
        // At given V the product ησ is given, so that K/K_c is proportional to 1/(σ + ησ).
        width_dex: (1.0 + family.inertial_parameter) * libm::log10(over_critical),
        law: EdgeLaw::new(family.effect_ratio, family.inertial_parameter),
        threshold: threshold(family, members, groups, [critical, 0.5 * excess]),
    }))
}

fn model(family: &CycleFamily, stiffness_group: f64) -> Model<f64> {
    let groups = Groups {
        inertial_parameter: family.inertial_parameter,
        stiffness_group,
        effect_ratio: family.effect_ratio,
    };
    Model::new(groups, family.law)
}

/// Loading velocity (m/s) and normal stress (Pa) at which a slider with b > a has this η on K = K_c.
fn place_on_transition(parameters: &Slider<Rational>, inertial_parameter: f64) -> [f64; 2] {
    let slider = parameters.map(nearest_f64);
    let critical = critical_stiffness_group(&slider.effect_ratio(), &inertial_parameter);
    let stress = slider.stiffness_stress_pa() / (slider.direct_effect * critical);
    let inertia_pa = inertial_parameter * stress * slider.direct_effect;
    let velocity_squared = inertia_pa * slider.critical_slip_distance_m / slider.mass_per_area_kg_per_m2;
    [velocity_squared.sqrt(), stress]
}

/// Whether runs from the fold's cycle end on a cycle a little below the edge and in sliding a little above it.
fn confirms(family: &CycleFamily, fold: &Fold, critical: f64, step: f64) -> bool {
    let periodic = |shift: f64| {
        let model = model(family, fold.member.stiffness_group + critical * shift);
        ends_on_cycle(&model, fold.member.orbit.end)
    };
    periodic(-step) == Ok(true) && periodic(step) == Ok(false)
}

/// Whether the run from a state ends on a limit cycle, and not in steady sliding.
pub(super) fn ends_on_cycle(model: &Model<f64>, start: State<f64>) -> Result<bool, Failure> {
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, CONTROL)?;
    long_term_behaviour(&mut run, TARGET, MOST_RETURNS)
        .map(|long_term| matches!(long_term, LongTerm::Cycle(_)))
}

/// The cycles at this K/K_c − 1, rounded so that κ is a decimal, and the start that the unstable one repels.
fn threshold(
    family: &CycleFamily,
    members: &[Member],
    groups: impl Fn(Rational) -> Groups<Rational>,
    [critical, excess]: [f64; 2],
) -> Option<Threshold> {
    let groups = groups(parse_decimal(&round_digits(critical * (1.0 + excess), DIGITS)).ok()?);
    let stiffness = nearest_f64(&groups.stiffness_group);
    let mut cycles = family.at(members, stiffness);
    let (unstable, stable) = (cycles.next()?.ok()?, cycles.next_back()?.ok()?);
    let model = model(family, stiffness);
    let below = start_threshold(&model, &unstable).ok()??;
    let periodic =
        |factor: f64| ends_on_cycle(&model, Start::SteadyAtVelocity.state(&model, &(-factor * below))).ok();
    let ends = periodic(1.0 - START_MARGIN).zip(periodic(1.0 + START_MARGIN));
    Some(Threshold {
        excess: stiffness / critical - 1.0,
        unstable_log_peak: unstable.orbit.peak,
        crossing: [unstable.orbit.end[1], unstable.orbit.end[2]],
        start_velocity_ratio: libm::exp(-below),
        confirmed: ends.map(|ends| ends == (false, true)),
        coexistence: certify_coexistence(&groups, family.law, &stable, &unstable),
        stiffness_group: groups.stiffness_group,
    })
}
