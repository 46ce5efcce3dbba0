//! The families of limit cycles that leave steady sliding at K = K_c, each followed through its fold where it has one.

use crate::experiments::near_transition::NearTransitionSection;
use crate::experiments::near_transition::bistability::{Edge, edge};
use crate::parallel;
use slipmode_certified::certify_coexistence;
use slipmode_core::dynamics::{CycleFamily, Failure, Member};
use slipmode_core::friction::{EvolutionLaw, Groups, Slider, critical_stiffness_group};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_theory::hopf::{Criticality, square_amplitude};

/// One cycle of a family.
#[derive(Debug, Clone)]
pub struct FamilyCycle {
    /// K/K_c − 1 at which it exists.
    pub excess: f64,
    /// The same by the first Lyapunov coefficient from the cycle's amplitude; none where the coefficient is zero.
    pub predicted_excess: Option<f64>,
    /// Half of the range of ln(V/V_l): its amplitude but for terms of third order.
    pub amplitude: f64,
    /// ln(V_peak/V_l).
    pub log_peak: f64,
    /// Leading Floquet multiplier: above 1 the cycle is unstable; none when it could not be measured.
    pub multiplier: Option<f64>,
}

/// How the cycles approach what the coefficient says of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AmplitudeDeviation {
    /// Amplitude of ln(V/V_l).
    pub amplitude: f64,
    /// K/K_c − 1 over the predicted one, minus 1.
    pub deviation: f64,
    /// Power of the amplitude with which the deviation vanishes, from two cycles; 2 is derived. None where the deviation is below the
    /// fourth power of the amplitude: there its second-order term is about to change sign, and the next one shows.
    pub order: Option<f64>,
}

/// The cycles of one slider.
#[derive(Debug, Clone)]
pub struct CycleFamilyOutcome {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: Rational,
    /// By ascending size; empty when not even the smallest was found.
    pub cycles: Vec<FamilyCycle>,
    /// The largest K/K_c with a cycle, when that is above 1: the fold where the stable and the unstable cycle merge.
    pub edge: Result<Option<Edge>, Failure>,
    family: CycleFamily,
    members: Vec<Member>,
    /// β.
    pub(super) effect_ratio: Rational,
    critical: f64,
    square_amplitude: Option<f64>,
}

/// Amplitude of the smallest cycle: the linear equations give its stiffness to three digits, and rounding leaves five of K/K_c − 1.
const SMALLEST: f64 = 0.05;

/// Ratio of the stresses of neighbouring cycles.
const FACTOR: f64 = 1.1;

/// Where a family is no longer followed: beyond this K/K_c nothing is close to the transition.
const FARTHEST: f64 = 0.88;

/// The cycles whose deviations show the order: amplitudes of about 0.1 and 0.2.
const COMPARED: [usize; 2] = [8, 15];

/// Part of a small amplitude by which it may differ from that of the coefficient: more than the square of [`SMALLEST`] leads to.
const AROUND: f64 = 0.05;

/// Local tolerance of the returns: their error is about 1e-12.
const LOCAL_TOLERANCE: f64 = 1e-8;

impl CycleFamilyOutcome {
    /// How small cycles are born, decided exactly by the first Lyapunov coefficient.
    pub(crate) fn criticality(&self) -> Criticality {
        Criticality::of(self.law, &self.inertial_parameter, &self.effect_ratio)
    }

    /// The amplitude of ln(V/V_l) by the coefficient at this K/K_c − 1; none on the side without small cycles.
    pub(crate) fn predicted_amplitude(&self, excess: f64) -> Option<f64> {
        let square = self.square_amplitude? * excess;
        (square > 0.0).then(|| square.sqrt())
    }

    /// How far the cycles are from what the coefficient says, and how fast they approach it.
    pub(crate) fn agreement(&self) -> Option<AmplitudeDeviation> {
        let [small, large] = COMPARED.map(|index| self.cycles.get(index));
        let (small, large) = (small?, large?);
        let deviation = |cycle: &FamilyCycle| Some(cycle.excess / cycle.predicted_excess? - 1.0);
        let (first, second) = (deviation(small)?, deviation(large)?);
        let order = libm::log(second / first) / libm::log(large.amplitude / small.amplitude);
        let readable = order.is_finite() && first.abs() > libm::pow(small.amplitude, 4.0);
        Some(AmplitudeDeviation {
            amplitude: small.amplitude,
            deviation: first,
            order: readable.then_some(order),
        })
    }

    /// ln(V_peak/V_l) of the outermost cycle at this κ, by Newton's method on the return map.
    pub(crate) fn log_peak_at(&self, stiffness_group: f64) -> Option<f64> {
        let found = self.family.at(&self.members, stiffness_group).next_back();
        found.or_else(|| self.smaller(stiffness_group))?.ok().map(|member| member.orbit.peak)
    }

    /// Lower bound, value by Newton's method and upper bound of ln(V_peak/V_l) of the unstable cycle at this κ, where it is proved beside
    /// a larger, stable cycle and stable sliding.
    pub(crate) fn unstable_log_peak_at(&self, groups: &Groups<Rational>) -> Option<[f64; 3]> {
        let mut cycles = self.family.at(&self.members, nearest_f64(&groups.stiffness_group));
        let (unstable, stable) = (cycles.next()?.ok()?, cycles.next_back()?.ok()?);
        let proved = certify_coexistence(groups, self.law, &stable, &unstable).ok()?;
        let [low, high] = proved.repelling_log_peak;
        Some([low, unstable.orbit.peak, high])
    }

    /// A cycle smaller than those followed: between two about the size that the coefficient says.
    fn smaller(&self, stiffness_group: f64) -> Option<Result<Member, Failure>> {
        let predicted = self.predicted_amplitude(stiffness_group / self.critical - 1.0)?;
        let end = |part: f64| first(&self.family, self.critical, part * predicted);
        let ends = end(1.0 - AROUND).and_then(|below| Ok([below, end(1.0 + AROUND)?]));
        Some(ends.and_then(|[below, above]| self.family.between([&below, &above], stiffness_group)))
    }
}

/// Follows the cycles of both laws at every η of the section.
pub(crate) fn cycle_families(
    parameters: &Slider<Rational>,
    section: &NearTransitionSection,
) -> Vec<CycleFamilyOutcome> {
    let mut inertial: Vec<&Rational> =
        section.inertial_parameter.iter().chain(&section.edge_inertial_parameter).collect();
    inertial.extend(section.kicks.iter().map(|kicks| &kicks.inertial_parameter));
    inertial.sort();
    inertial.dedup();
    let of_law = |law| inertial.iter().map(move |&inertial| (law, inertial));
    let cases: Vec<(EvolutionLaw, &Rational)> = EvolutionLaw::ALL.into_iter().flat_map(of_law).collect();
    parallel::map(&cases, |&(law, inertial)| follow(parameters, law, inertial))
}

fn follow(parameters: &Slider<Rational>, law: EvolutionLaw, inertial: &Rational) -> CycleFamilyOutcome {
    let effect_ratio = parameters.effect_ratio();
    let family = CycleFamily {
        law,
        inertial_parameter: nearest_f64(inertial),
        effect_ratio: nearest_f64(&effect_ratio),
        local_tolerance: LOCAL_TOLERANCE,
    };
    let critical = nearest_f64(&critical_stiffness_group(&effect_ratio, inertial));
    let square = square_amplitude(law, inertial, &effect_ratio).map(|square| nearest_f64(&square));
    let first = first(&family, critical, SMALLEST);
    let members = first
        .map(|first| family.follow(first, FACTOR, |member| member.stiffness_group > FARTHEST * critical));
    let found = members.as_ref().map_err(Clone::clone);
    let edge = found.and_then(|members| edge(parameters, &family, inertial, members, critical));
    let members = members.unwrap_or_default();
    CycleFamilyOutcome {
        law,
        inertial_parameter: inertial.clone(),
        cycles: members.iter().map(|member| family_cycle(&family, member, critical, square)).collect(),
        edge,
        family,
        members,
        effect_ratio,
        critical,
        square_amplitude: square,
    }
}

/// The cycle of about this amplitude of ln(V/V_l), from the linear motion along the critical eigenvector: ζ = A ω (1 + η) and
/// ζ − φ = A ω η as x rises through zero.
fn first(family: &CycleFamily, critical: f64, amplitude: f64) -> Result<Member, Failure> {
    let turn = amplitude * (family.effect_ratio - 1.0).sqrt();
    family.member(turn * (1.0 + family.inertial_parameter), [turn * family.inertial_parameter, critical])
}

fn family_cycle(family: &CycleFamily, member: &Member, critical: f64, square: Option<f64>) -> FamilyCycle {
    let amplitude = 0.5 * (member.orbit.peak - member.orbit.trough);
    FamilyCycle {
        excess: member.stiffness_group / critical - 1.0,
        predicted_excess: square.map(|square| amplitude * amplitude / square),
        amplitude,
        log_peak: member.orbit.peak,
        multiplier: family.leading_multiplier(member).ok(),
    }
}
