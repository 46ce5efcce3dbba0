//! Decays: how fast and how often the velocity still moves about its steady value.

use super::Recording;
use super::laps::Lap;
use super::late::{LateDecay, Measured, Reduced};

/// Deviations below this part of the largest one are noise, in a decay without oscillation.
const NOISE: f64 = 1e-6;
/// Laps whose swing is below this part of the largest one are noise at any accuracy; above it their rates tell.
const NOISY_LAP: f64 = 1e-10;
/// Neighbouring rates that are compared.
const WINDOW: usize = 3;
/// Parts of a decay without oscillation that are compared with each other.
const PARTS: usize = 3;

/// Rate and period of a decaying oscillation, where three neighbouring laps agree best about the rate.
///
/// Early laps are not linear yet, the last ones drown in the recording's noise; between them lies a plateau, and the
/// spread on it is the error.
pub(super) fn decay_of_laps(reduced: &Reduced) -> LateDecay {
    let laps = &reduced.whole;
    let largest = laps.iter().map(Lap::swing).fold(0.0, f64::max);
    let alive = laps.iter().position(|lap| lap.swing() < NOISY_LAP * largest).unwrap_or(laps.len());
    let laps = &laps[..alive];
    let rates: Vec<f64> = laps
        .windows(2)
        .map(|pair| libm::log(pair[1].swing() / pair[0].swing()) / pair[1].duration_s)
        .collect();
    let spread = |values: &[f64]| {
        let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(*value), high.max(*value))
        });
        high - low
    };
    let width = WINDOW.min(rates.len());
    let windows = 0..if width < 2 { 0 } else { rates.len() + 1 - width };
    let best = windows.min_by(|one, other| {
        spread(&rates[*one..one + width]).total_cmp(&spread(&rates[*other..other + width]))
    });
    let Some(at) = best else {
        return LateDecay {
            period_s: laps.last().map(|lap| period(reduced, lap, lap.duration_s)),
            rate_per_s: None,
        };
    };
    let durations: Vec<f64> = laps[at + 1..at + 1 + width].iter().map(|lap| lap.duration_s).collect();
    let lap = &laps[at + 2];
    let swings = reduced.resolution(lap, Lap::swing) / lap.swing();
    let error = spread(&rates[at..at + width]) + 2.0 * swings / lap.duration_s;
    let rate = Measured { value: rates[at + 1], relative_error: error / rates[at + 1].abs() };
    LateDecay { period_s: Some(period(reduced, lap, spread(&durations))), rate_per_s: Some(rate) }
}

fn period(reduced: &Reduced, lap: &Lap, spread: f64) -> Measured {
    let error = spread + reduced.resolution(lap, |lap| lap.duration_s);
    Measured { value: lap.duration_s, relative_error: error / lap.duration_s }
}

/// A decay that passes its steady value no more: the deviation shrinks through the last half of the recording.
pub(super) fn decay_without_laps(recording: &Recording, log_level: f64) -> Option<LateDecay> {
    let deviations: Vec<f64> = recording.log_velocities.iter().map(|log| log - log_level).collect();
    let largest = deviations.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let (last, middle) = (deviations.last()?.abs(), deviations[deviations.len() / 2].abs());
    let is_dead = last <= NOISE * largest;
    let shrinks = last < 0.5 * middle && last < 0.1 * largest;
    if !(is_dead || shrinks) {
        return None;
    }
    let alive = deviations.iter().rposition(|value| value.abs() > NOISE * largest)?;
    let is_small = |value: &f64| value.abs() < 0.1 * largest;
    let begin = deviations[..=alive].iter().rposition(|value| !is_small(value)).map_or(0, |index| index + 1);
    let change = deviations[..=alive].windows(2).rposition(|pair| pair[0] * pair[1] <= 0.0);
    let begin = begin.max(change.map_or(0, |index| index + 1));
    Some(LateDecay { period_s: None, rate_per_s: rate(&recording.times_s, &deviations, begin, alive) })
}

/// The slope of ln |deviation| over the last of three parts of a stretch of samples, with the change from the part before as error.
fn rate(times: &[f64], deviations: &[f64], begin: usize, end: usize) -> Option<Measured> {
    if end < begin + 2 * PARTS {
        return None;
    }
    let (from, to) = (times[begin], times[end]);
    let nearest = |time: f64| (begin..=end).find(|index| times[*index] >= time).unwrap_or(end);
    let marks = [0.0, 1.0, 2.0, 3.0].map(|part| nearest(from + (to - from) * part / 3.0));
    let slopes: Vec<f64> = marks
        .windows(2)
        .map(|pair| {
            let fall = libm::log(deviations[pair[1]] / deviations[pair[0]]);
            fall / (times[pair[1]] - times[pair[0]])
        })
        .collect();
    let [_, before, last] = slopes[..] else { return None };
    let relative_error = (last - before).abs() / last.abs();
    relative_error.is_finite().then_some(Measured { value: last, relative_error })
}
