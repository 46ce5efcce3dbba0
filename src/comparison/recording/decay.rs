//! Decays: how fast and how often the velocity still moves about its steady value.

use super::returns::{Reduced, Return};
use super::{Measured, Recording};

/// Deviations below this part of the largest one are noise, in a decay without oscillation.
const NOISE: f64 = 1e-6;
/// Returns whose swing is below this part of the largest one are noise at any accuracy; above it their rates tell.
const NOISY_RETURN: f64 = 1e-10;
/// Neighbouring rates that are compared.
const WINDOW: usize = 3;
/// Parts of a decay without oscillation that are compared with each other.
const PARTS: usize = 3;

/// A return to steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedDecay {
    /// Period of the long-term oscillation, s; none when nothing oscillates.
    pub period_s: Option<Measured>,
    /// Growth rate of the deviation of ln V, 1/s, as a rule negative; none when too little is recorded.
    pub rate_per_s: Option<Measured>,
}

/// Rate and period of a decaying oscillation, where three neighbouring returns agree best about the rate.
///
/// Early returns are not linear yet, the last ones drown in the recording's noise; between them lies a plateau, and the
/// spread on it is the error.
pub(crate) fn decay_of_returns(reduced: &Reduced) -> RecordedDecay {
    let returns = &reduced.whole;
    let largest = returns.iter().map(Return::swing).fold(0.0, f64::max);
    let alive =
        returns.iter().position(|orbit| orbit.swing() < NOISY_RETURN * largest).unwrap_or(returns.len());
    let returns = &returns[..alive];
    let rates: Vec<f64> = returns
        .windows(2)
        .map(|pair| libm::log(pair[1].swing() / pair[0].swing()) / pair[1].duration_s)
        .collect();
    let spread = |values: &[f64]| {
        let fold = |start, of: fn(f64, f64) -> f64| values.iter().copied().fold(start, of);
        fold(f64::NEG_INFINITY, f64::max) - fold(f64::INFINITY, f64::min)
    };
    let width = rates.len().clamp(2, WINDOW);
    let windows = rates.windows(width).map(spread).enumerate();
    let Some((at, spread_of_rates)) = windows.min_by(|one, other| one.1.total_cmp(&other.1)) else {
        return RecordedDecay {
            period_s: returns.last().map(|orbit| period(reduced, orbit, orbit.duration_s)),
            rate_per_s: None,
        };
    };
    let durations: Vec<f64> = returns[at + 1..at + 1 + width].iter().map(|orbit| orbit.duration_s).collect();
    let orbit = &returns[at + 2];
    let swings = reduced.resolution(orbit, Return::swing) / orbit.swing();
    let error = spread_of_rates + 2.0 * swings / orbit.duration_s;
    let rate = Measured { value: rates[at + 1], relative_error: error / rates[at + 1].abs() };
    RecordedDecay { period_s: Some(period(reduced, orbit, spread(&durations))), rate_per_s: Some(rate) }
}

fn period(reduced: &Reduced, orbit: &Return, spread: f64) -> Measured {
    let error = spread + reduced.resolution(orbit, |orbit| orbit.duration_s);
    Measured { value: orbit.duration_s, relative_error: error / orbit.duration_s }
}

/// A decay that passes its steady value no more: the deviation shrinks through the last half of the recording.
pub(crate) fn decay_without_returns(recording: &Recording, log_level: f64) -> Option<RecordedDecay> {
    let deviations: Vec<f64> = recording.log_velocities.iter().map(|log| log - log_level).collect();
    let largest = deviations.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let (last, middle) = (deviations.last()?.abs(), deviations[deviations.len() / 2].abs());
    let is_dead = last <= NOISE * largest;
    let shrinks = last < 0.5 * middle && last < 0.1 * largest;
    let is_alive = |value: &f64| value.abs() > NOISE * largest;
    let alive = deviations.iter().rposition(is_alive).filter(|_| is_dead || shrinks)?;
    let large = deviations[..=alive].iter().rposition(|value| value.abs() >= 0.1 * largest);
    let change = deviations[..=alive].windows(2).rposition(|pair| pair[0] * pair[1] <= 0.0);
    let begin = large.max(change).map_or(0, |index| index + 1);
    Some(RecordedDecay { period_s: None, rate_per_s: rate(&recording.times_s, &deviations, begin, alive) })
}

/// The slope of ln |deviation| over the last of three parts of a stretch of samples, with the change from the part before as error.
fn rate(times: &[f64], deviations: &[f64], begin: usize, end: usize) -> Option<Measured> {
    if end < begin + 2 * PARTS {
        return None;
    }
    let (from, to) = (times[begin], times[end]);
    let nearest = |time: f64| (begin..=end).find(|index| times[*index] >= time).unwrap_or(end);
    let [first, second, third] = [1.0, 2.0, 3.0].map(|part| nearest(from + (to - from) * part / 3.0));
    let slope = |one: usize, other: usize| {
        libm::log(deviations[other] / deviations[one]) / (times[other] - times[one])
    };
    let (before, last) = (slope(first, second), slope(second, third));
    let relative_error = (last - before).abs() / last.abs();
    relative_error.is_finite().then_some(Measured { value: last, relative_error })
}
