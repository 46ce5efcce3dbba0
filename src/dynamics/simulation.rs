//! One simulation from parameters in SI to observables in SI, each with an error estimate.
//!
//! Everything is computed at a local tolerance and again at a tenth of it; the finer result is reported and the difference is its
//! stated error. A result that misses the asked accuracy is computed anew, tighter; when the arithmetic allows no
//! tighter run the answer is a failure that says what was reached.

use super::deviations::oscillation_of_small_deviations;
use super::integrator::{Control, Integrator};
use super::lap::Lap;
use super::settle::{Cycle, Decay, Late, settle};
use super::stepper::Stepper;
use super::{Balance, Failure, Model, Radau, Start};
use crate::friction::{EvolutionLaw, Groups, Parameters, SlipMode};
use crate::number::Rational;

/// What to simulate, beyond the parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How the start is completed.
    pub start: Start,
    /// V/V_l at the start; the paper takes 1/10.
    pub velocity_ratio: f64,
    /// Permitted relative error of peak velocity and period.
    pub tolerance: f64,
    /// μ0 of the regularised friction law; none for eq 1 as it stands.
    pub regularised_reference_friction: Option<f64>,
    /// Most steps of one run, refused ones included.
    pub most_steps: u64,
    /// Most oscillations before the late behaviour is called undecided.
    pub most_laps: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            start: Start::default(),
            velocity_ratio: 0.1,
            tolerance: 1e-8,
            regularised_reference_friction: None,
            most_steps: 5_000_000,
            most_laps: 4_000,
        }
    }
}

/// The late behaviour in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Behaviour {
    /// A limit cycle.
    Periodic,
    /// A return to steady sliding.
    Decaying,
}

impl Behaviour {
    /// The word for tables: `periodic` or `decaying`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Periodic => "periodic",
            Self::Decaying => "decaying",
        }
    }
}

/// What a simulation showed.
#[derive(Debug, Clone, PartialEq)]
pub struct Simulation {
    /// Limit cycle or decay.
    pub behaviour: Behaviour,
    /// The slip mode, from the trajectory alone.
    pub slip_mode: SlipMode,
    /// Peak velocity of the cycle, or of the transient, m/s.
    pub peak_velocity_m_per_s: f64,
    /// log10 of the least velocity over V_l, of the cycle or the transient.
    pub minimum_velocity_log10_ratio: f64,
    /// Period of the cycle or of the late oscillation, s; none when nothing oscillates.
    pub period_s: Option<f64>,
    /// Largest minus least spring stress of the cycle or the transient, Pa.
    pub stress_drop_pa: f64,
    /// The same in units of aσ.
    pub stress_drop_over_direct_effect: f64,
    /// Passages of V = V_l per second in late behaviour, Hz; none when nothing oscillates.
    pub frequency_hz: Option<f64>,
    /// Growth rate of the late oscillation, or the rate of a late decay without oscillation, 1/s; none on a cycle.
    pub growth_rate_per_s: Option<f64>,
    /// Leading Floquet multiplier of the cycle as seen in its approach; an upper bound when superattracting.
    pub floquet_multiplier: Option<f64>,
    /// Estimated relative error of the peak velocity.
    pub peak_relative_error: f64,
    /// Estimated relative error of the period; none when there is none.
    pub period_relative_error: Option<f64>,
    /// Accepted and refused steps of all runs.
    pub steps: u64,
    /// Evaluations of the right-hand side of all runs.
    pub evaluations: u64,
    /// Local tolerance of the finest run.
    pub local_tolerance: f64,
}

/// Local tolerance of the first run, for the asked error of the results: Radau IIA of order 9 is that much better than its estimate.
const LOCAL_OVER_ASKED: f64 = 100.0;

/// Errors of peak and period over the local tolerance: the largest seen on a grid of 1 764 cases is below this, so that
/// two runs that agree by chance cannot state less.
const ERROR_OVER_LOCAL: f64 = 2e-3;

/// The loosest and the tightest local tolerance in use.
const LOOSEST: f64 = 1e-3;
const TIGHTEST: f64 = 2e-13;

/// One run at one tolerance.
struct Run {
    late: Late<f64>,
    steps: u64,
    evaluations: u64,
}

/// Simulates a slider.
///
/// # Errors
/// A [`Failure`] when the start is not admissible, the late behaviour is undecided or the tolerance is out of reach.
pub fn simulate(
    parameters: &Parameters<Rational>,
    law: EvolutionLaw,
    options: &Options,
) -> Result<Simulation, Failure> {
    let groups = parameters.groups().map(Rational::to_f64);
    let parameters = parameters.map(Rational::to_f64);
    let balance = match options.regularised_reference_friction {
        Some(reference) => Balance::Regularised(reference / parameters.direct_effect),
        None => Balance::Inertial,
    };
    let outcome = simulate_model(&Model::with_balance(groups, law, balance), options)?;
    Ok(outcome.in_si(&parameters))
}

/// A simulation in units of V_l, D_c/V_l and aσ.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    late: Late<f64>,
    groups: Groups<f64>,
    start: f64,
    contraction: Option<f64>,
    peak_relative_error: f64,
    period_relative_error: Option<f64>,
    steps: u64,
    evaluations: u64,
    local_tolerance: f64,
}

/// Simulates a slider without units.
///
/// # Errors
/// Those of [`simulate`].
pub fn simulate_model(model: &Model<f64>, options: &Options) -> Result<Outcome, Failure> {
    let asked = options.tolerance;
    let mut local = (LOCAL_OVER_ASKED * asked).clamp(TIGHTEST, LOOSEST);
    let mut reached = f64::INFINITY;
    let mut last_failure = None;
    let (mut steps, mut evaluations) = (0, 0);
    while local >= TIGHTEST {
        match both_runs(model, options, local) {
            Ok((coarse, fine)) => {
                steps += coarse.steps + fine.steps;
                evaluations += coarse.evaluations + fine.evaluations;
                let start = libm::log(options.velocity_ratio);
                let outcome =
                    Outcome::new(model, start, &coarse.late, fine.late, [steps, evaluations], 0.1 * local);
                reached = outcome.largest_error();
                if reached <= asked {
                    return Ok(outcome);
                }
            }
            Err(failure @ (Failure::Undecided { .. } | Failure::StepVanished { .. })) => {
                last_failure = Some(failure)
            }
            Err(failure) => return Err(failure),
        }
        local *= 0.01;
    }
    match last_failure {
        Some(failure) if reached.is_infinite() => Err(failure),
        _ => Err(Failure::UnreachableTolerance { asked, reached }),
    }
}

/// A run at the local tolerance and one at a tenth of it; on a cycle the second begins where the first ended.
fn both_runs(model: &Model<f64>, options: &Options, local: f64) -> Result<(Run, Run), Failure> {
    let start = options.start.state(model, &libm::log(options.velocity_ratio));
    let control = Control { local_tolerance: local, most_steps: options.most_steps };
    let mut integrator = Integrator::new(model, Radau::<f64, 5>::new(), start, control)?;
    let target = options.tolerance * 0.01;
    let late = settle(&mut integrator, target, options.most_laps)?;
    let mut coarse = Run::of(late, &integrator);
    let finer = Control { local_tolerance: 0.1 * local, ..control };
    let from = match coarse.late {
        Late::Cycle(_) => *integrator.state(),
        Late::Decay(_) => start,
    };
    let mut integrator = Integrator::new(model, Radau::<f64, 5>::new(), from, finer)?;
    let late = settle(&mut integrator, target, options.most_laps)?;
    let mut fine = Run::of(late, &integrator);
    // A pair that dies faster than the real mode leaves no trace in late behaviour, but it is there.
    if let (Late::Decay(coarse), Late::Decay(fine)) = (&mut coarse.late, &mut fine.late)
        && coarse.oscillation.is_none()
        && fine.oscillation.is_none()
    {
        coarse.oscillation = oscillation_of_small_deviations(model, local.min(1e-6))?;
        fine.oscillation = oscillation_of_small_deviations(model, 0.1 * local.min(1e-6))?;
    }
    Ok((coarse, fine))
}

impl Run {
    fn of(late: Late<f64>, integrator: &Integrator<'_, f64, Radau<f64, 5>>) -> Self {
        let (accepted, refused) = integrator.step_counts();
        Self { late, steps: accepted + refused, evaluations: integrator.method().evaluations() }
    }
}

/// Peak and period of a late behaviour; the start counts for a transient's peak.
fn peak_and_period(late: &Late<f64>, start: f64) -> (f64, Option<f64>) {
    match late {
        Late::Cycle(cycle) => (cycle.lap.peak, Some(cycle.lap.duration)),
        Late::Decay(decay) => {
            let approached = decay.transient.end[0].max(start);
            (decay.transient.peak.max(approached), decay.oscillation.map(|(period, _)| period))
        }
    }
}

impl Outcome {
    fn new(
        model: &Model<f64>,
        start: f64,
        coarse: &Late<f64>,
        fine: Late<f64>,
        [steps, evaluations]: [u64; 2],
        local_tolerance: f64,
    ) -> Self {
        let (coarse_peak, coarse_period) = peak_and_period(coarse, start);
        let (peak, period) = peak_and_period(&fine, start);
        let distance = match &fine {
            Late::Cycle(cycle) => cycle.distance,
            Late::Decay(_) => 0.0,
        };
        // A hundred steps of rounding in x, what the local tolerance alone lets expect, and the way left to the cycle,
        // whose estimate rests on a multiplier known to a few parts only.
        let floor = |size: f64| {
            (100.0 * f64::EPSILON + ERROR_OVER_LOCAL * local_tolerance + 5.0 * distance) * size.max(1.0)
        };
        let seen = |late: &Late<f64>| if let Late::Cycle(cycle) = late { cycle.contraction } else { None };
        // The finer run began on the cycle and has no approach to show.
        let contraction = seen(coarse).or(seen(&fine));
        let same_kind = matches!(coarse, Late::Cycle(_)) == matches!(fine, Late::Cycle(_));
        let same_kind = same_kind && coarse_period.is_some() == period.is_some();
        let doubt = if same_kind { 0.0 } else { f64::INFINITY };
        let peak_relative_error = 2.0 * libm::expm1(coarse_peak - peak).abs() + floor(peak.abs()) + doubt;
        let period_relative_error = coarse_period
            .zip(period)
            .map(|(coarse, fine)| 2.0 * (coarse / fine - 1.0).abs() + floor(1.0) + doubt);
        Self {
            late: fine,
            groups: model.groups().clone(),
            start,
            contraction,
            peak_relative_error,
            period_relative_error,
            steps,
            evaluations,
            local_tolerance,
        }
    }

    /// The late behaviour in units of V_l, D_c/V_l and aσ.
    #[must_use]
    pub const fn late(&self) -> &Late<f64> {
        &self.late
    }

    /// ln(V_peak/V_l).
    #[must_use]
    pub fn log_peak(&self) -> f64 {
        peak_and_period(&self.late, self.start).0
    }

    /// Accepted and refused steps of all runs.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.steps
    }

    /// Factor by which deviations from the cycle shrank in one lap of the approach; none for a decay.
    #[must_use]
    pub const fn contraction(&self) -> Option<f64> {
        self.contraction
    }

    fn largest_error(&self) -> f64 {
        self.peak_relative_error.max(self.period_relative_error.unwrap_or(0.0))
    }

    fn extremes(&self) -> &Lap<f64> {
        match &self.late {
            Late::Cycle(cycle) => &cycle.lap,
            Late::Decay(decay) => &decay.transient,
        }
    }

    /// The slip mode, from the trajectory alone: what it ends in, and how fast it oscillates against √(K/M).
    #[must_use]
    pub fn slip_mode(&self) -> SlipMode {
        let natural_squared = self.groups.stiffness_group / self.groups.inertial_parameter;
        let inertial = |angular: f64| 2.0 * angular * angular > natural_squared;
        match &self.late {
            Late::Cycle(cycle) if inertial(angular_frequency(cycle)) => SlipMode::HarmonicVibration,
            Late::Cycle(_) => SlipMode::StickSlip,
            Late::Decay(Decay { oscillation: Some((period, _)), .. }) => {
                if inertial(std::f64::consts::TAU / period) {
                    SlipMode::InertialUnderdampedOscillation
                } else {
                    SlipMode::NonInertialUnderdampedOscillation
                }
            }
            // Below eq 16 every mode decays faster than e^{-V_l t/D_c}; a slower end belongs to the area above eq 15.
            Late::Decay(Decay { rate: Some(rate), .. }) if *rate > -1.0 && self.groups.effect_ratio < 1.0 => {
                SlipMode::OverdampedOscillation
            }
            Late::Decay(_) => SlipMode::OverdampedStableSliding,
        }
    }

    /// The same in SI.
    #[must_use]
    pub fn in_si(&self, parameters: &Parameters<f64>) -> Simulation {
        let rate_per_s = parameters.rate_per_s();
        let direct_stress_pa = parameters.direct_effect * parameters.normal_stress_pa;
        let extremes = self.extremes();
        let drop = extremes.highest_stress - extremes.lowest_stress;
        let (log_peak, period) = peak_and_period(&self.late, self.start);
        let trough = match self.late {
            Late::Cycle(_) => extremes.trough,
            Late::Decay(_) => extremes.trough.min(self.start),
        };
        let (laps, growth) = match &self.late {
            Late::Cycle(cycle) => (cycle.laps_per_cycle, None),
            Late::Decay(decay) => (1, decay.oscillation.map(|(_, growth)| growth).or(decay.rate)),
        };
        let periodic = matches!(self.late, Late::Cycle(_));
        Simulation {
            behaviour: if periodic { Behaviour::Periodic } else { Behaviour::Decaying },
            slip_mode: self.slip_mode(),
            peak_velocity_m_per_s: parameters.loading_velocity_m_per_s * libm::exp(log_peak),
            minimum_velocity_log10_ratio: trough / std::f64::consts::LN_10,
            period_s: period.map(|period| period / rate_per_s),
            stress_drop_pa: drop * direct_stress_pa,
            stress_drop_over_direct_effect: drop,
            frequency_hz: period.map(|period| laps as f64 * rate_per_s / period),
            growth_rate_per_s: growth.map(|growth| growth * rate_per_s),
            floquet_multiplier: self.contraction,
            peak_relative_error: self.peak_relative_error,
            period_relative_error: self.period_relative_error,
            steps: self.steps,
            evaluations: self.evaluations,
            local_tolerance: self.local_tolerance,
        }
    }
}

fn angular_frequency(cycle: &Cycle<f64>) -> f64 {
    std::f64::consts::TAU * cycle.laps_per_cycle as f64 / cycle.lap.duration
}
