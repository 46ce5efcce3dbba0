//! The returns since the last jump, and what they show of the return map: its slow direction, where that leads, repetition.

use super::Scalar;
use super::section_return::Return;

/// Most returns per cycle that are looked for.
const MOST_RETURNS_PER_CYCLE: usize = 4;

/// y and ζ at a crossing of the section x = 0.
pub(super) type SectionPoint = [f64; 2];

/// The returns since the last jump.
pub(super) struct History<R> {
    pub returns: Vec<Return<R>>,
}

pub(super) fn size(v: SectionPoint) -> f64 {
    v[0].abs().max(v[1].abs())
}

pub(super) fn difference(a: SectionPoint, b: SectionPoint) -> SectionPoint {
    [a[0] - b[0], a[1] - b[1]]
}

impl<R: Scalar> History<R> {
    pub const fn new() -> Self {
        Self { returns: Vec::new() }
    }

    /// Where the last return but `n` ended.
    pub fn back(&self, n: usize) -> Option<SectionPoint> {
        let index = self.returns.len().checked_sub(n + 1)?;
        let [_, y, zeta] = self.returns[index].end.each_ref().map(Scalar::to_f64);
        Some([y, zeta])
    }

    /// The change over the last `m` returns, relative to the state.
    pub fn change(&self, m: usize) -> Option<f64> {
        let (last, before) = (self.back(0)?, self.back(m)?);
        Some(size(difference(last, before)) / size(last))
    }

    /// Whether the last three changes are so small that they may be the integrator's errors, which no return can improve on.
    pub fn within(&self, noise: f64) -> bool {
        (0..3).all(|n| {
            let (Some(last), Some(before)) = (self.back(n), self.back(n + 1)) else { return false };
            size(difference(last, before)) < noise * size(last)
        })
    }

    /// The factor by which the last return shrank the change: along the slow direction, or any when it is small.
    pub fn multiplier(&self) -> Option<f64> {
        if let Some((multiplier, _)) = self.slow_direction() {
            return Some(multiplier.abs());
        }
        let (last, before) =
            (self.change(1)?, size(difference(self.back(1)?, self.back(2)?)) / size(self.back(0)?));
        (last < 0.1 * before).then(|| last / before)
    }

    /// The slow multiplier and the last change, when the last three crossings lie on a line.
    pub fn slow_direction(&self) -> Option<(f64, SectionPoint)> {
        let (a, b, c) = (self.back(2)?, self.back(1)?, self.back(0)?);
        let (first, second) = (difference(b, a), difference(c, b));
        let norm = first[0] * first[0] + first[1] * first[1];
        let multiplier = (first[0] * second[0] + first[1] * second[1]) / norm;
        let rest = difference(second, [multiplier * first[0], multiplier * first[1]]);
        (size(rest) <= 0.1 * size(second)).then_some((multiplier, second))
    }
}

/// The number of returns after which the state repeats, when it is more than one and the repetition is already exact.
pub(super) fn returns_per_cycle<R: Scalar>(history: &History<R>, target: f64, noise: f64) -> Option<usize> {
    let single = history.change(1)?;
    if single < 100.0 * noise {
        return None;
    }
    (2..=MOST_RETURNS_PER_CYCLE).find(|&m| {
        let twice = history.returns.len() > 2 * m;
        twice && history.change(m).is_some_and(|change| change <= target && change <= 1e-3 * single)
    })
}

/// Where the slow direction leads: the secant's fixed point, or a limited part of the way.
pub(super) fn jump<R: Scalar>(history: &History<R>, reach: f64) -> Option<SectionPoint> {
    let (multiplier, change) = history.slow_direction()?;
    let here = history.back(0)?;
    let amplitude = size(here);
    // Faster contraction than this converges by itself before a jump pays.
    if multiplier < 0.3 {
        return None;
    }
    let largest = reach * amplitude / size(change);
    let factor = if multiplier < 1.0 { (multiplier / (1.0 - multiplier)).min(largest) } else { largest };
    let to = [here[0] + factor * change[0], here[1] + factor * change[1]];
    let full = multiplier / (1.0 - multiplier);
    let end = [here[0] + full * change[0], here[1] + full * change[1]];
    // A small state on its way to zero: the equations are nearly linear, and a decade is as good as a return.
    if multiplier < 1.0 && amplitude < 0.05 && size(end) < 0.2 * amplitude {
        return Some([0.1 * here[0], 0.1 * here[1]]);
    }
    Some(to)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn history(crossings: &[SectionPoint]) -> History<f64> {
        let to = |&[y, zeta]: &SectionPoint| Return {
            duration: 1.0,
            peak: 0.0,
            trough: 0.0,
            highest_stress: 0.0,
            lowest_stress: 0.0,
            end: [0.0, y, zeta],
        };
        History { returns: crossings.iter().map(to).collect() }
    }

    #[test]
    fn a_geometric_approach_leads_to_its_limit() {
        // 2 + 0.02·0.9^n along (1, −1).
        let crossings: Vec<SectionPoint> =
            [1.0, 0.9, 0.81, 0.729].iter().map(|r| [2.0 + 0.02 * r, -1.0 - 0.02 * r]).collect();
        let history = history(&crossings);
        assert!((history.multiplier().unwrap() - 0.9).abs() < 1e-12);
        let to = jump(&history, 0.3).unwrap();
        assert!((to[0] - 2.0).abs() < 1e-12 && (to[1] + 1.0).abs() < 1e-12);
    }

    #[test]
    fn growth_and_far_limits_are_approached_by_a_limited_part_of_the_state() {
        let crossings: Vec<SectionPoint> = [1.0, 1.1, 1.21].iter().map(|r| [1.0 + 0.01 * r, 0.0]).collect();
        let to = jump(&history(&crossings), 0.3).unwrap();
        assert!((to[0] / 1.0121 - 1.3).abs() < 1e-12);
    }

    #[test]
    fn a_small_state_on_its_way_to_zero_loses_a_decade() {
        let crossings = [[0.01, 0.0], [0.0099, 0.0], [0.009801, 0.0]];
        let to = jump(&history(&crossings), 0.3).unwrap();
        assert!((to[0] - 0.0009801).abs() < 1e-12);
    }

    #[test]
    fn a_repetition_after_two_returns_is_found() {
        let crossings = [[1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
        assert_eq!(returns_per_cycle(&history(&crossings), 1e-9, 1e-9), Some(2));
        let single = [[1.0, 0.0]; 6];
        assert_eq!(returns_per_cycle(&history(&single), 1e-9, 1e-9), None);
    }
}
