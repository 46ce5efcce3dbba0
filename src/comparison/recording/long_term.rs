//! The long-term behaviour of a recording: a cycle, a decay, or neither yet.

use super::decay::{RecordedDecay, decay_of_returns, decay_without_returns};
use super::returns::{Reduced, Return};
use super::{LEAST_SAMPLES, Measured, Recording};
use slipmode_core::dynamics::Behaviour;

/// The long-term behaviour of a recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RecordedBehaviour {
    /// A limit cycle.
    Cycle {
        /// V at the peak over V_l.
        peak_ratio: Measured,
        /// s.
        period_s: Measured,
        /// Largest minus least stress, Pa; none when no stress was recorded.
        stress_drop_pa: Option<Measured>,
    },
    /// A return to steady sliding.
    Decay(RecordedDecay),
}

/// Why no long-term behaviour is reported.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Undecided {
    /// The recording is too short.
    #[error("the trajectory has {0} samples (needed: {LEAST_SAMPLES})")]
    FewSamples(usize),
    /// Neither enough cycles nor a decay.
    #[error(
        "the trajectory has {0} cycles after its first crossing of the loading velocity, and no decay (needed: 3 cycles)"
    )]
    FewCycles(usize),
    /// The cycles still change.
    #[error("the trajectory has not converged to a cycle or a decay: its last ranges of log10 V are {0}")]
    StillChanging(String),
}

/// Swings below this part of the largest deviation of ln V are the end of a decay, whatever noise they show.
///
/// A true cycle is as small as this only within about 1e-8 of K = K_c, where no recording is long enough to decide.
const DEAD: f64 = 1e-4;
/// A geometric approach is what three cycles let expect; an early approach is slower, so that more than expected is left.
const APPROACH: f64 = 3.0;
/// A cycle is only reported when its swing changed by less than this part of it through the last third of the recording.
const NEARLY_CONSTANT: f64 = 0.05;
/// Changes of the swing below this part of it count as none.
const STILL: f64 = 1e-6;
/// ln(V/V_l) of deep stick-slip at its peak: 10^3. It reaches its cycle within few periods.
const DEEP: f64 = 6.9;
/// A cycle of deep stick-slip is known from changes within the errors of the samples, if these are below this part.
const KNOWN: f64 = 2e-3;
/// A peak whose ln V has a larger error lies between samples: how high it is, they do not tell.
const SEEN: f64 = 0.1;

impl Recording {
    /// The long-term behaviour about steady sliding at a velocity, of which its logarithm is given; cycles have so many returns.
    ///
    /// The first return is never used: it belongs to the start.
    ///
    /// # Errors
    /// When the recording is too short or still changing.
    pub fn long_term(
        &self,
        log_level: f64,
        returns_per_cycle: usize,
    ) -> Result<RecordedBehaviour, Undecided> {
        let samples = self.times_s.len();
        if samples < LEAST_SAMPLES {
            return Err(Undecided::FewSamples(samples));
        }
        let reduced = Reduced::of(self, log_level, returns_per_cycle.max(1));
        let cycles = reduced.whole.len();
        let deviation = |log: &f64| (log - log_level).abs();
        let largest = self.log_velocities.iter().map(deviation).fold(0.0, f64::max);
        let is_alive = reduced.whole.iter().any(|orbit| orbit.swing() > DEAD * largest);
        if cycles < 3 || !is_alive {
            let decay = decay_without_returns(self, log_level);
            return decay.map(RecordedBehaviour::Decay).ok_or(Undecided::FewCycles(cycles));
        }
        match limit_of_swing(&reduced.whole, largest) {
            Some(Behaviour::Decaying) => Ok(RecordedBehaviour::Decay(decay_of_returns(&reduced))),
            Some(Behaviour::Periodic) => Ok(reduced.cycle(self.stresses_pa.is_empty())),
            None => {
                let last = &reduced.whole[cycles - 3..];
                let swing = |orbit: &Return| format!("{:.4}", orbit.swing() / std::f64::consts::LN_10);
                Err(Undecided::StillChanging(last.iter().map(swing).collect::<Vec<_>>().join(", ")))
            }
        }
    }
}

impl Reduced {
    fn cycle(&self, without_stress: bool) -> RecordedBehaviour {
        let relative = |(value, error): (f64, f64)| Measured { value, relative_error: error / value.abs() };
        let (peak, error) = self.last_value(|orbit| orbit.peak.value, |orbit| orbit.peak.error);
        let error = if error <= SEEN { libm::expm1(error) } else { f64::INFINITY };
        let drop = || self.last_value(Return::stress_drop_pa, Return::stress_drop_error_pa);
        let duration = |orbit: &Return| orbit.duration_s;
        RecordedBehaviour::Cycle {
            peak_ratio: Measured { value: libm::exp(peak), relative_error: error },
            period_s: relative(self.last_value(duration, |orbit| self.resolution(orbit, duration))),
            stress_drop_pa: (!without_stress).then(|| relative(drop())),
        }
    }

    /// The value of the last cycle and its error: the largest that the samples leave among the last cycles, and what they may still
    /// change.
    fn last_value(&self, value: impl Fn(&Return) -> f64, error: impl Fn(&Return) -> f64) -> (f64, f64) {
        let count = self.whole.len();
        let last_cycles = &self.whole[count.saturating_sub(4)..];
        let resolution = last_cycles.iter().map(error).fold(0.0, f64::max);
        let values = spaced(&self.whole).map(&value);
        let last = value(&self.whole[count - 1]);
        let step = (last - value(&self.whole[count - 2])).abs();
        (last, resolution + APPROACH * step.max(remaining(values)))
    }
}

/// The last cycle and two earlier ones at equal distances, as far apart as the recording allows.
fn spaced(whole: &[Return]) -> [&Return; 3] {
    let last = whole.len() - 1;
    let apart = (last / 2).min(1 + last / 3);
    [&whole[last - 2 * apart], &whole[last - apart], &whole[last]]
}

/// What a geometric approach through three values has left.
fn remaining([first, second, third]: [f64; 3]) -> f64 {
    let (before, after) = (second - first, third - second);
    let ratio = after / before;
    if (0.0..1.0).contains(&ratio) { after.abs() * ratio / (1.0 - ratio) } else { after.abs() }
}

/// Whether cycles of deep stick-slip change by no more than the errors of their samples, in velocity or in stress.
fn is_still(whole: &[Return]) -> bool {
    let cycles = spaced(whole);
    let within = |value: fn(&Return) -> f64, error: fn(&Return) -> f64| {
        let [values, errors] = [cycles.map(value), cycles.map(error)];
        let error = errors.into_iter().fold(0.0, f64::max);
        let changes = [values[1] - values[0], values[2] - values[1], values[2] - values[0]];
        error <= KNOWN * values[2] && changes.into_iter().all(|change| change.abs() <= 2.0 * error)
    };
    cycles.iter().all(|orbit| orbit.peak.value > DEEP)
        && (within(Return::swing, |orbit| orbit.peak.error + orbit.trough.error)
            || within(Return::stress_drop_pa, Return::stress_drop_error_pa))
}

/// What the trend of the swing of the cycles leads to; none if it is not known yet.
fn limit_of_swing(whole: &[Return], largest: f64) -> Option<Behaviour> {
    if is_still(whole) {
        return Some(Behaviour::Periodic);
    }
    let [first, second, third] = spaced(whole).map(Return::swing);
    if third <= DEAD * largest {
        return Some(Behaviour::Decaying);
    }
    let (before, after) = (second - first, third - second);
    let ratio = after / before;
    let is_nearly_constant = after.abs() <= NEARLY_CONSTANT * third;
    if after.abs() <= STILL * third {
        // A decay as slow as this shows its ratio all the same; noise has none.
        let is_geometric = before.abs() > STILL * third && (0.9..1.0).contains(&ratio);
        if !is_geometric {
            return Some(Behaviour::Periodic);
        }
    }
    if !(0.0..1.0).contains(&ratio) {
        // Cycles that scatter about a value have reached their limit; those that run away have not.
        return (ratio < 0.0 && is_nearly_constant).then_some(Behaviour::Periodic);
    }
    match (third + after * ratio / (1.0 - ratio)) / third {
        limit if limit < 0.2 => Some(Behaviour::Decaying),
        limit if (0.8..1.25).contains(&limit) && is_nearly_constant => Some(Behaviour::Periodic),
        _ => None,
    }
}
