//! Whether estimated errors hold: random sliders, both laws, compared with double-double references.
//!
//! The groups come from a fixed sequence and not from any grid of the paper. The reference continues from the state
//! where the run ended (a limit cycle) or begins at its start (a decay), with Radau IIA of order 13 in double-double.

mod tables;

pub use tables::table;

use rayon::prelude::*;

use crate::split_mix::SplitMix64;
use slipmode_core::dynamics::{
    Control, Integrator, LongTerm, Model, Options, Outcome, Radau, Scalar, Start, State, long_term_behaviour,
    simulate_model,
};
use slipmode_core::friction::{EvolutionLaw, Groups, Parameters, critical_stiffness_group};
use slipmode_core::number::Dd;

/// One run compared with its reference.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundCheck {
    /// η, κ and β.
    pub groups: Groups<f64>,
    /// Relative error requested.
    pub tolerance: f64,
    /// Whether the run ended on a limit cycle; none when it failed.
    pub periodic: Option<bool>,
    /// True error of the peak over the stated one; infinite when the reference ends elsewhere, none without one.
    pub peak_ratio: Option<f64>,
    /// The same of the period; none when nothing oscillates.
    pub period_ratio: Option<f64>,
}

/// Local tolerance of the reference: its global error is below 1e-16 wherever a return multiplies errors by less than 100.
const LOCAL_TOLERANCE: f64 = 1e-18;

/// Relative distance from the limit cycle at which the reference ends.
const TARGET: f64 = 1e-16;

/// The most returns of a reference.
const MOST_RETURNS: u64 = 4_000;

/// η over ten decades, b/a from 0.4 to 3.4, K/K_c over four decades around 1 (κ itself for a ≥ b).
fn random_groups(sequence: &mut SplitMix64) -> Groups<f64> {
    let inertial_parameter = libm::exp10(sequence.between(-6.0, 4.0));
    let effect_ratio = sequence.between(0.4, 3.4);
    let ratio = libm::exp10(sequence.between(-3.0, 1.0));
    let critical =
        if effect_ratio > 1.0 { critical_stiffness_group(&effect_ratio, &inertial_parameter) } else { 1.0 };
    Groups { inertial_parameter, stiffness_group: ratio * critical, effect_ratio }
}

/// What the report on the paper shows: how many sliders, and the relative errors requested of each.
pub const REPORTED: (usize, [f64; 3]) = (12, [1e-4, 1e-6, 1e-8]);

/// Runs so many random sliders at every tolerance, by slider, law and tolerance.
#[must_use]
pub fn error_bound((count, tolerances): (usize, [f64; 3])) -> Vec<BoundCheck> {
    let mut sequence = SplitMix64(0);
    let groups: Vec<Groups<f64>> = (0..count).map(|_| random_groups(&mut sequence)).collect();
    let cases: Vec<(&Groups<f64>, EvolutionLaw)> = groups
        .iter()
        .flat_map(|groups| EvolutionLaw::ALL.into_iter().map(move |law| (groups, law)))
        .collect();
    let checks: Vec<Vec<BoundCheck>> =
        cases.par_iter().map(|&(groups, law)| checks(groups, law, &tolerances)).collect();
    checks.into_iter().flatten().collect()
}

/// The reference once for all tolerances: where the run at the tightest one ended.
fn checks(groups: &Groups<f64>, law: EvolutionLaw, tolerances: &[f64]) -> Vec<BoundCheck> {
    let model = Model::new(groups.clone(), law);
    let runs: Vec<_> = tolerances
        .iter()
        .map(|&tolerance| (tolerance, simulate_model(&model, &Options::at(tolerance))))
        .collect();
    let reference = runs
        .iter()
        .rev()
        .find_map(|(_, run)| run.as_ref().ok())
        .and_then(|run| reference(&model, run.long_term()));
    runs.iter()
        .map(|(tolerance, run)| {
            let empty = BoundCheck {
                groups: groups.clone(),
                tolerance: *tolerance,
                periodic: None,
                peak_ratio: None,
                period_ratio: None,
            };
            match run {
                Err(_) => empty,
                Ok(run) => compared_with(run, reference.as_ref(), empty),
            }
        })
        .collect()
}

/// What the reference says: ln of the peak, and the period.
struct Truth {
    periodic: bool,
    log_peak: Dd,
    period: Option<Dd>,
}

fn reference(model: &Model<f64>, long_term: &LongTerm<f64>) -> Option<Truth> {
    let fine = Model::new(model.groups().map(|&group| Dd::from(group)), model.law());
    let control = Control { local_tolerance: LOCAL_TOLERANCE, most_steps: 1_000_000 };
    let start: State<Dd> = match long_term {
        LongTerm::Cycle(cycle) => cycle.orbit.end.map(Dd::from),
        LongTerm::Decay(_) => Start::default().state(&fine, &Dd::from_f64(libm::log(0.1))),
    };
    let mut run = Integrator::new(&fine, Radau::<Dd, 7>::new(), start, control).ok()?;
    Some(match long_term_behaviour(&mut run, TARGET, MOST_RETURNS).ok()? {
        LongTerm::Cycle(cycle) => {
            Truth { periodic: true, log_peak: cycle.orbit.peak, period: Some(cycle.orbit.duration) }
        }
        LongTerm::Decay(decay) => {
            let highest = [start[0], decay.transient.end[0]]
                .into_iter()
                .fold(decay.transient.peak, |highest, x| if x > highest { x } else { highest });
            Truth {
                periodic: false,
                log_peak: highest,
                period: decay.oscillation.map(|oscillation| oscillation.period),
            }
        }
    })
}

fn compared_with(run: &Outcome, truth: Option<&Truth>, empty: BoundCheck) -> BoundCheck {
    // Units in which the three groups are M, K and b.
    let groups = &empty.groups;
    let stated = run.in_si(&Parameters::from([
        1.0,
        groups.effect_ratio,
        1.0,
        groups.stiffness_group,
        groups.inertial_parameter,
        1.0,
        1.0,
    ]));
    let periodic = matches!(run.long_term(), LongTerm::Cycle(_));
    let Some(truth) = truth else { return BoundCheck { periodic: Some(periodic), ..empty } };
    let same = truth.periodic == periodic;
    let peak_error = libm::expm1(run.log_peak() - truth.log_peak.to_f64()).abs();
    let peak_ratio = if same { peak_error / stated.peak_relative_error } else { f64::INFINITY };
    let period = stated.period_s.zip(stated.period_relative_error).zip(truth.period.as_ref());
    let period_ratio = period.map(|((period, error), exact)| {
        let deviation = (period / exact.to_f64() - 1.0).abs();
        if same { deviation / error } else { f64::INFINITY }
    });
    BoundCheck { periodic: Some(periodic), peak_ratio: Some(peak_ratio), period_ratio, ..empty }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_that_is_stated_too_small_would_be_seen() {
        let groups = Groups { inertial_parameter: 79.06, stiffness_group: 0.7906, effect_ratio: 1.5 };
        let model = Model::new(groups.clone(), EvolutionLaw::Slip);
        let run = simulate_model(&model, &Options::default()).unwrap();
        let empty =
            BoundCheck { groups, tolerance: 1e-8, periodic: None, peak_ratio: None, period_ratio: None };
        let truth = reference(&model, run.long_term()).unwrap();
        let held = compared_with(&run, Some(&truth), empty.clone());
        assert!(held.peak_ratio.unwrap() < 1.0 && held.period_ratio.unwrap() < 1.0, "{held:?}");
        let wrong = Truth { log_peak: truth.log_peak + Dd::from(1e-6), ..truth };
        assert!(compared_with(&run, Some(&wrong), empty).peak_ratio.unwrap() > 1.0);
    }
}
