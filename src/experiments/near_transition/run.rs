//! Finite starts close to K = K_c, and the cycles that are there: what the linear theory, the same for both laws, cannot tell.

use crate::experiments::near_transition::NearTransitionSection;
use crate::experiments::near_transition::cycle_families::{CycleFamilyOutcome, cycle_families};
use crate::experiments::near_transition::kicks::{SmallestKick, smallest_kicks};
use crate::parallel;
use slipmode_core::dynamics::{
    Decay, Failure, LongTerm, Model, Options, Oscillation, Outcome, simulate_model,
};
use slipmode_core::friction::{EvolutionLaw, Groups, Slider, critical_stiffness_group};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::roots::{Pair, bounded_roots};

/// One run from the start of the scene's simulations, V_l/10.
#[derive(Debug, Clone)]
pub struct NearRun {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// η.
    pub inertial_parameter: Rational,
    /// K/K_c.
    pub stiffness_over_critical: Rational,
    /// What the simulation showed, or why it has no result.
    pub outcome: Result<Outcome, Failure>,
    /// Re(s) of the oscillating pair of eq 8 in V_l/D_c; none when all roots are real.
    pub linear_growth: Option<f64>,
    /// Amplitude of ln(V/V_l) by the first Lyapunov coefficient; none where it has no cycle, or the cycle is unstable.
    pub predicted_amplitude: Option<f64>,
    /// ln(V_peak/V_l) of the cycle at this K by Newton's method on the return map; none where there is no cycle.
    pub newton_log_peak: Option<f64>,
}

/// What a scene's slider does close to K = K_c.
#[derive(Debug, Clone)]
pub struct NearTransitionOutcome {
    /// The runs, law by law.
    pub runs: Vec<NearRun>,
    /// The families of cycles, law by law and by ascending η.
    pub families: Vec<CycleFamilyOutcome>,
    /// The smallest kicks, law by law and by K/K_c.
    pub kicks: Vec<SmallestKick>,
}

impl NearRun {
    /// Whether the run ended on a limit cycle; none when it failed.
    pub(crate) fn periodic(&self) -> Option<bool> {
        self.outcome.as_ref().ok().map(|outcome| matches!(outcome.long_term(), LongTerm::Cycle(_)))
    }

    /// Half of the range of ln(V/V_l) along the limit cycle: its amplitude but for terms of third order.
    pub(crate) fn amplitude(&self) -> Option<f64> {
        match self.outcome.as_ref().ok()?.long_term() {
            LongTerm::Cycle(cycle) => Some(0.5 * (cycle.orbit.peak - cycle.orbit.trough)),
            LongTerm::Decay(_) => None,
        }
    }

    /// Growth rate of the oscillation of a decay, in V_l/D_c.
    pub(crate) fn growth(&self) -> Option<f64> {
        self.long_term_oscillation().map(|oscillation| oscillation.growth_rate)
    }

    /// Returns in which the distance from the long-term behaviour shrinks by e.
    pub(crate) fn returns_per_fold(&self) -> Option<f64> {
        let contraction = self.outcome.as_ref().ok()?.contraction();
        let on_cycle = contraction.filter(|factor| (0.0..1.0).contains(factor)).map(|f| -1.0 / libm::log(f));
        on_cycle.or_else(|| {
            self.long_term_oscillation()
                .map(|oscillation| -1.0 / (oscillation.growth_rate * oscillation.period))
        })
    }

    fn long_term_oscillation(&self) -> Option<Oscillation<f64>> {
        match self.outcome.as_ref().ok()?.long_term() {
            LongTerm::Decay(Decay { oscillation, .. }) => *oscillation,
            LongTerm::Cycle(_) => None,
        }
    }
}

/// Simulates with each law at κ = (K/K_c)(β − 1)(1 + η), which is eq 9 in the groups, and follows the families of cycles.
pub(crate) fn near_transition(
    parameters: &Slider<Rational>,
    section: &NearTransitionSection,
) -> NearTransitionOutcome {
    let families = cycle_families(parameters, section);
    let mut cases: Vec<(EvolutionLaw, &Rational, &Rational)> = Vec::new();
    for law in EvolutionLaw::ALL {
        for inertial in &section.inertial_parameter {
            cases.extend(section.stiffness_over_critical.iter().map(|ratio| (law, inertial, ratio)));
        }
    }
    let options = Options::at(nearest_f64(&section.tolerance));
    let effect_ratio = parameters.effect_ratio();
    let runs = parallel::map(&cases, |&(law, inertial, ratio)| {
        let family =
            families.iter().find(|family| family.law == law && family.inertial_parameter == *inertial);
        near_run(law, inertial, ratio, &effect_ratio, family, &options)
    });
    let kicks = section.kicks.iter().flat_map(|kicks| smallest_kicks(kicks, &families)).collect();
    NearTransitionOutcome { runs, families, kicks }
}

fn near_run(
    law: EvolutionLaw,
    inertial: &Rational,
    ratio: &Rational,
    effect_ratio: &Rational,
    family: Option<&CycleFamilyOutcome>,
    options: &Options,
) -> NearRun {
    let critical = critical_stiffness_group(effect_ratio, inertial);
    let groups = Groups {
        inertial_parameter: inertial.clone(),
        stiffness_group: critical * ratio,
        effect_ratio: effect_ratio.clone(),
    };
    let groups = groups.map(nearest_f64);
    let pair = bounded_roots(groups.characteristic_cubic()).pair;
    let linear_growth = if let Pair::Complex { re, .. } = pair { Some(re.value) } else { None };
    let excess = nearest_f64(&Rational::from(ratio - 1));
    NearRun {
        law,
        inertial_parameter: inertial.clone(),
        stiffness_over_critical: ratio.clone(),
        newton_log_peak: family.and_then(|family| family.log_peak_at(groups.stiffness_group)),
        predicted_amplitude: family
            .and_then(|family| family.predicted_amplitude(excess))
            .filter(|_| excess < 0.0),
        outcome: simulate_model(&Model::new(groups, law), options),
        linear_growth,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::number::parse_decimal;

    fn outcome(inertial: &[&str], stiffness: &[&str], edge: &[&str]) -> NearTransitionOutcome {
        let decimals = |texts: &[&str]| texts.iter().map(|text| parse_decimal(text).unwrap()).collect();
        let section = NearTransitionSection {
            inertial_parameter: decimals(inertial),
            stiffness_over_critical: decimals(stiffness),
            edge_inertial_parameter: decimals(edge),
            tolerance: parse_decimal("1e-8").unwrap(),
            kicks: None,
        };
        near_transition(&paper(), &section)
    }

    #[test]
    fn only_the_aging_law_keeps_a_cycle_just_above_the_critical_stiffness() {
        let found = outcome(&["0.01"], &["0.999", "1.002", "1.01"], &["0.01"]);
        let (aging, slip) = (EvolutionLaw::Aging, EvolutionLaw::Slip);
        for (law, ends) in [(aging, [true, true, false]), (slip, [true, false, false])] {
            let of_law: Vec<bool> =
                found.runs.iter().filter(|run| run.law == law).filter_map(NearRun::periodic).collect();
            assert_eq!(of_law, ends, "{law:?}");
        }
        // The runs and Newton's method on the return map find the same cycles.
        for run in found.runs.iter().filter(|run| run.periodic() == Some(true)) {
            let simulated = run.outcome.as_ref().unwrap().log_peak();
            assert!((simulated - run.newton_log_peak.unwrap()).abs() < 2e-8, "{run:?}");
        }
    }

    #[test]
    fn decays_have_the_growth_rate_of_the_linear_theory() {
        let found = outcome(&["1"], &["1.0001", "1.1"], &["1"]);
        for run in &found.runs {
            let (seen, exact) = (run.growth().unwrap(), run.linear_growth.unwrap());
            // What a return of about 9 D_c/V_l multiplies the amplitude by is known to the tolerance of 1e-8.
            assert!((seen - exact).abs() < 1e-8 / 9.0, "{seen} {exact}");
        }
    }

    #[test]
    fn cycles_approach_the_coefficient_with_the_square_of_their_amplitude() {
        let found = outcome(&["1"], &["0.999"], &["0.05", "1"]);
        for family in &found.families {
            let agreement = family.agreement().unwrap();
            assert!((agreement.order.unwrap() - 2.0).abs() < 0.05, "{:?} {agreement:?}", family.law);
            assert!(agreement.deviation.abs() < agreement.amplitude * agreement.amplitude, "{agreement:?}");
        }
    }

    #[test]
    fn the_edge_of_bistability_is_bracketed_by_runs_and_its_threshold_by_starts() {
        let found = outcome(&["0.03"], &["1.001"], &["0.03", "0.1", "0.2"]);
        let of = |law| found.families.iter().filter(move |family| family.law == law);
        let edges: Vec<_> = of(EvolutionLaw::Aging).map(|family| family.edge.clone().unwrap()).collect();
        let [Some(near), Some(far), None] = edges.as_slice() else { panic!("{edges:?}") };
        // Runs from the cycle of the fold, 1 % to either side of the edge, end on a cycle and in sliding.
        assert_eq!((near.bracket, far.bracket), (Some(0.01), Some(0.01)));
        assert!((near.excess - 5.8796e-3).abs() < 1e-6 && near.error < 1e-6, "{near:?}");
        let threshold = near.threshold.as_ref().unwrap();
        assert_eq!(threshold.confirmed, Some(true), "{threshold:?}");
        assert!(threshold.start_velocity_ratio > 0.1 && threshold.start_velocity_ratio < 1.0);
        for family in of(EvolutionLaw::Slip) {
            assert_eq!(family.edge, Ok(None));
            assert!(family.cycles.iter().all(|cycle| cycle.excess < 0.0));
        }
    }
}
