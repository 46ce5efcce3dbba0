//! The loading velocity at which the peak velocity is least, by minimisation, against eq 18 (fig 5), and how flat the minimum is.

use crate::parallel;

use crate::experiments::map::run::exactly;
use crate::experiments::simulations::SimulationsSection;
use slipmode_core::dynamics::{Behaviour, Options, Simulation, simulate};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::search::{border_between, minimum_between, zero_between};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::asymptote::inertial_upper_velocity_m_per_s;
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

/// The minimum of the peak velocity over the loading velocity at one normal stress.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastPeak {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Normal stress, Pa.
    pub normal_stress_pa: f64,
    /// Velocity of eq 18, m/s.
    pub eq18_velocity_m_per_s: f64,
    /// log10 of the minimising velocity over that of eq 18.
    pub offset_dex: f64,
    /// Estimated error of the offset.
    pub offset_error_dex: f64,
    /// The least peak velocity, m/s.
    pub least_m_per_s: f64,
    /// Peak velocity at eq 18 over the least one.
    pub peak_at_eq18_over_least: f64,
    /// Second derivative of ln(peak velocity) by log10(V_l) at the minimum.
    pub curvature_per_dex2: f64,
    /// For each of [`FLATNESS_LEVELS`]: the offsets from eq 18 between which the peak is less than that much above the
    /// least one, to [`SIDE_WIDTH`]; none at a side that lies beyond the searched decade.
    pub flat: [[Option<f64>; 2]; 2],
    /// log10 of the velocity at which the limit cycle turns from stick-slip to harmonic vibration over that of eq 18.
    pub cycle_mode_change_dex: Option<f64>,
    /// log10 of the velocities from which on the period is below [`PERIOD_LEVELS`] times the natural one, over that of eq 18, to
    /// [`SIDE_WIDTH`].
    pub period_change_dex: [Option<f64>; 2],
    /// Period over the natural one at eq 18 and at the least peak, each with its relative error.
    pub periods_over_natural: [(f64, f64); 2],
    /// The change of mode of small deviations, decided by the exact theory.
    pub theory_mode_change_dex: Option<f64>,
    /// (offset from eq 18, dex; peak velocity, m/s) of the samples that bracket the minimum.
    pub samples: Vec<(f64, f64)>,
}

/// Relative excess over the least peak between whose sides the minimum counts as flat.
pub const FLATNESS_LEVELS: [f64; 2] = [0.01, 0.05];

/// Periods in units of the natural one between which a cycle turns from stick-slip into vibration, besides √2 of the modes' names.
pub const PERIOD_LEVELS: [f64; 2] = [2.0, 1.1];

/// Half of the width that is searched around eq 18, dex.
const REACH_DEX: f64 = 1.0;

/// Samples that bracket the minimum before it is refined.
const SAMPLES: i32 = 9;

/// Distance of the samples, dex.
const SAMPLE_STEP_DEX: f64 = 0.25;

/// Distance of the points from which the minimum is refined, dex.
const STENCIL_DEX: f64 = 0.03;

/// Width to which the sides of the flat part and the changes of mode are located, dex.
pub const SIDE_WIDTH: f64 = 1e-3;

/// Minimises at every normal stress of the section's grid above σ_c, where no velocity is stable; a stress is left out
/// when a run fails or decays, or when the least sample lies at an end of the searched range.
pub(crate) fn least_peaks(
    parameters: &Slider<Rational>,
    section: &SimulationsSection,
    threshold: &InertialThreshold,
    options: &Options,
) -> Vec<LeastPeak> {
    let mut stresses = section.rectangle.normal_stress_pa.coordinates();
    let critical = parameters.has_transition().then(|| parameters.critical_normal_stress_pa());
    stresses.retain(|stress| critical.as_ref().is_some_and(|critical| exactly(*stress) > *critical));
    let cases: Vec<(EvolutionLaw, f64)> =
        section.laws.iter().flat_map(|&law| stresses.iter().map(move |&stress| (law, stress))).collect();
    let least = |&(law, stress): &(EvolutionLaw, f64)| {
        let eq18_velocity_m_per_s = inertial_upper_velocity_m_per_s(&parameters.map(nearest_f64), &stress);
        Line { parameters, law, stress, eq18_velocity_m_per_s, options }.least_peak(threshold)
    };
    parallel::flat_map(&cases, least)
}

/// A line of constant normal stress; places on it are offsets from eq 18 in dex.
struct Line<'p> {
    parameters: &'p Slider<Rational>,
    law: EvolutionLaw,
    stress: f64,
    eq18_velocity_m_per_s: f64,
    options: &'p Options,
}

impl Line<'_> {
    fn velocity(&self, offset: f64) -> f64 {
        self.eq18_velocity_m_per_s * libm::exp10(offset)
    }

    fn cycle(&self, offset: f64) -> Option<Simulation> {
        let point = self.parameters.at(exactly(self.stress), exactly(self.velocity(offset)));
        let simulation = simulate(&point, self.law, self.options).ok()?;
        (simulation.behaviour == Behaviour::Periodic).then_some(simulation)
    }

    /// ln of the peak velocity in m/s.
    fn log_peak(&self, offset: f64) -> Option<f64> {
        Some(libm::log(self.cycle(offset)?.peak_velocity_m_per_s))
    }

    fn least_peak(&self, threshold: &InertialThreshold) -> Option<LeastPeak> {
        let sample = |index| {
            let offset = f64::from(index).mul_add(SAMPLE_STEP_DEX, -REACH_DEX);
            Some((offset, self.cycle(offset)?))
        };
        let samples: Option<Vec<(f64, Simulation)>> = (0..SAMPLES).map(sample).collect();
        let samples = samples?;
        let peak = |index: usize| samples[index].1.peak_velocity_m_per_s;
        let least = (0..samples.len()).min_by(|&i, &j| peak(i).total_cmp(&peak(j)))?;
        if least == 0 || least + 1 == samples.len() {
            return None;
        }
        let ends = (samples[least - 1].0, samples[least + 1].0);
        let noise = self.options.tolerance;
        let minimum = minimum_between(|offset| self.log_peak(offset), ends, STENCIL_DEX, noise)?;
        let (at_least, at_eq18) = (self.cycle(minimum.at)?, self.cycle(0.0)?);
        let log_least = libm::log(at_least.peak_velocity_m_per_s);
        let peaks: Vec<(f64, f64)> =
            samples.iter().map(|(offset, found)| (*offset, found.peak_velocity_m_per_s)).collect();
        Some(LeastPeak {
            law: self.law,
            normal_stress_pa: self.stress,
            eq18_velocity_m_per_s: self.eq18_velocity_m_per_s,
            offset_dex: minimum.at,
            offset_error_dex: minimum.error,
            least_m_per_s: libm::exp(log_least),
            peak_at_eq18_over_least: libm::exp(libm::log(at_eq18.peak_velocity_m_per_s) - log_least),
            period_change_dex: PERIOD_LEVELS.map(|level| self.period_change(&samples, level)),
            periods_over_natural: [
                (self.period_over_natural(&at_eq18)?, at_eq18.period_relative_error?),
                (self.period_over_natural(&at_least)?, at_least.period_relative_error?),
            ],
            curvature_per_dex2: minimum.curvature,
            flat: FLATNESS_LEVELS.map(|level| self.flat_part(&peaks, (minimum.at, log_least), level)),
            cycle_mode_change_dex: self.cycle_mode_change(&samples),
            theory_mode_change_dex: self.theory_mode_change(threshold),
            samples: peaks,
        })
    }

    /// The places below and above the minimum where the peak exceeds the least one by `level`.
    fn flat_part(&self, samples: &[(f64, f64)], (at, log_least): (f64, f64), level: f64) -> [Option<f64>; 2] {
        let raised = log_least + libm::log1p(level);
        let above = |offset: f64| Some(self.log_peak(offset)? - raised);
        let side = |outside: Option<&(f64, f64)>| {
            let (offset, peak) = *outside?;
            let ends = [(at, log_least - raised), (offset, libm::log(peak) - raised)];
            zero_between(above, ends, SIDE_WIDTH)
        };
        let high = |sample: &&(f64, f64)| libm::log(sample.1) > raised;
        let (lower, upper): (Vec<_>, Vec<_>) = samples.iter().partition(|sample| sample.0 < at);
        [side(lower.into_iter().rev().find(high)), side(upper.into_iter().find(high))]
    }

    /// The first two neighbours among the samples, and among so many more beyond them, of which the second has the property and the first has
    /// it not yet; none when a cycle before them is missing.
    fn first_change<V: Copy>(
        &self,
        (samples, beyond): (&[(f64, Simulation)], i32),
        value: impl Fn(&Simulation) -> Option<V>,
        has_changed: impl Fn(V) -> bool,
    ) -> Option<[(f64, V); 2]> {
        let last = samples.last()?.0;
        let beyond = (1..beyond).map(|index| f64::from(index).mul_add(SAMPLE_STEP_DEX, last));
        let known = samples.iter().map(|(offset, found)| (*offset, value(found)));
        let mut places =
            known.chain(beyond.map(|offset| (offset, self.cycle(offset).as_ref().and_then(&value))));
        let (first, value) = places.next()?;
        let mut before = (first, value.filter(|value| !has_changed(*value))?);
        for (offset, value) in places {
            let here = (offset, value?);
            if has_changed(here.1) {
                return Some([before, here]);
            }
            before = here;
        }
        None
    }

    /// The first change from stick-slip to harmonic vibration among the samples and as far again beyond them, refined.
    fn cycle_mode_change(&self, samples: &[(f64, Simulation)]) -> Option<f64> {
        let harmonic = |found: &Simulation| Some(found.slip_mode == SlipMode::HarmonicVibration);
        let [without, with] = self.first_change((samples, SAMPLES), harmonic, |is_harmonic| is_harmonic)?;
        let holds = |offset: f64| harmonic(&self.cycle(offset)?);
        border_between(holds, (without.0, with.0), SIDE_WIDTH).map(|(_, with)| with)
    }

    fn period_over_natural(&self, cycle: &Simulation) -> Option<f64> {
        let natural = self.parameters.map(nearest_f64).natural_angular_frequency_per_s();
        Some(cycle.period_s? * natural / std::f64::consts::TAU)
    }

    /// Where the period falls below a multiple of the natural one, among the samples and twice as far beyond them.
    fn period_change(&self, samples: &[(f64, Simulation)], level: f64) -> Option<f64> {
        let excess = |found: &Simulation| Some(libm::log(self.period_over_natural(found)? / level));
        let ends = self.first_change((samples, 2 * SAMPLES), excess, |excess| excess <= 0.0)?;
        zero_between(|offset| excess(&self.cycle(offset)?), ends, SIDE_WIDTH)
    }

    fn theory_mode_change(&self, threshold: &InertialThreshold) -> Option<f64> {
        let harmonic = |offset: f64| {
            let point = self.parameters.at(exactly(self.stress), exactly(self.velocity(offset)));
            Some(classify(&point, threshold).slip_mode == SlipMode::HarmonicVibration)
        };
        if harmonic(-REACH_DEX) != Some(false) || harmonic(REACH_DEX) != Some(true) {
            return None;
        }
        border_between(harmonic, (-REACH_DEX, REACH_DEX), SIDE_WIDTH).map(|(_, with)| with)
    }
}
