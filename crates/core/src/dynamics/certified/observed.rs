//! What an enclosed motion shows: peak velocity, extremes of the spring stress, and elapsed time.

use super::interval::{Interval, generously_up};
use super::linear::worse;

/// A maximum that lies between two bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Maximum {
    pub low: f64,
    pub high: f64,
}

impl Maximum {
    const NONE: Self = Self { low: f64::NEG_INFINITY, high: f64::NEG_INFINITY };

    /// A value that the motion takes.
    pub fn takes(&mut self, value: Interval) {
        self.low = worse(self.low, value.lower());
        self.at_most(value.upper());
    }

    /// A bound of values that the motion may take.
    pub fn at_most(&mut self, bound: f64) {
        self.high = worse(self.high, bound);
    }

    const fn interval(self) -> [f64; 2] {
        [self.low, self.high]
    }
}

/// One state on the boundary of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    pub x: Interval,
    /// x' in the time of the step.
    pub speed: Interval,
    /// ζ.
    pub stress: Interval,
}

/// What one step shows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passed {
    pub start: Moment,
    pub end: Moment,
    /// x, x' and x'' during the step; x'' is unbounded where it is not known.
    pub x: Interval,
    pub speed: Interval,
    pub acceleration: Interval,
    /// ζ'/(1 − e^x) during the step.
    pub loading: Interval,
    /// The length of the step in its own time, and the time that passed.
    pub length: f64,
    pub duration: Interval,
}

/// A short time, before or after now.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wait {
    pub x: Interval,
    pub stress: Interval,
    pub stress_change: Interval,
    pub duration: Interval,
}

/// What a motion has shown so far.
#[derive(Debug, Clone)]
pub(super) struct Observed {
    peak: Maximum,
    highest_stress: Maximum,
    /// Of −ζ.
    lowest_stress: Maximum,
    pub duration: Interval,
}

impl Observed {
    pub const fn new() -> Self {
        let none = Maximum::NONE;
        Self { peak: none, highest_stress: none, lowest_stress: none, duration: Interval::ZERO }
    }

    /// A state that the motion passes.
    pub fn state(&mut self, x: Interval, stress: Interval) {
        self.peak.takes(x);
        self.highest_stress.takes(stress);
        self.lowest_stress.takes(-stress);
    }

    /// Bounds of x, of ζ and of −ζ for all that follows.
    pub fn rest(&mut self, x: f64, [highest, lowest]: [f64; 2]) {
        self.peak.at_most(x);
        self.highest_stress.at_most(highest);
        self.lowest_stress.at_most(lowest);
    }

    /// Notes a step.
    pub fn step(&mut self, step: &Passed) {
        for moment in [&step.start, &step.end] {
            self.state(moment.x, moment.stress);
        }
        self.peak.at_most(highest(step));
        if step.x.may_contain(0.0) {
            let change = stress_beyond_ends(step);
            let ends = step.start.stress.hull(step.end.stress);
            match change {
                Some((moment, change)) => {
                    self.highest_stress.at_most((moment.stress.upper() + change).next_up());
                    self.lowest_stress.at_most((change - moment.stress.lower()).next_up());
                }
                None => {
                    let change = generously_up(
                        step.loading.magnitude() * (Interval::ONE - step.x.exp()).magnitude() * step.length,
                    );
                    self.highest_stress.at_most((ends.upper() + change).next_up());
                    self.lowest_stress.at_most((change - ends.lower()).next_up());
                }
            }
        }
        self.duration = self.duration + step.duration;
    }

    /// Notes a short time in which x may rise or fall.
    pub fn wait(&mut self, wait: Wait) {
        self.peak.at_most(wait.x.upper());
        if wait.x.may_contain(0.0) {
            let stress = wait.stress.widened(wait.stress_change.magnitude());
            self.highest_stress.at_most(stress.upper());
            self.lowest_stress.at_most(-stress.lower());
        }
        self.duration = self.duration + wait.duration;
    }

    /// Lower and upper bound of the largest x.
    pub const fn peak(&self) -> [f64; 2] {
        self.peak.interval()
    }

    /// Lower bounds of the largest ζ and of the largest −ζ.
    pub const fn least_extremes(&self) -> [f64; 2] {
        [self.highest_stress.low, self.lowest_stress.low]
    }

    /// Lower and upper bound of the largest less the least ζ.
    pub fn stress_drop(&self) -> [f64; 2] {
        let (high, low) = (self.highest_stress, self.lowest_stress);
        [(high.low + low.low).next_down(), (high.high + low.high).next_up()]
    }
}

/// At least the largest x of a step.
///
/// Where x' keeps its sign, or x'' is positive, x is largest at an end. Where x'' ≤ −m, x exceeds either end by at most x'²/(2m).
fn highest(step: &Passed) -> f64 {
    let ends = worse(step.start.x.upper(), step.end.x.upper());
    if step.speed.mignitude() > 0.0 || step.acceleration.lower() > 0.0 {
        return ends;
    }
    let bend = -step.acceleration.upper();
    if bend > 0.0 {
        let beyond = |moment: &Moment| {
            let speed = moment.speed.magnitude();
            (moment.x.upper() + generously_up(speed * speed / (2.0 * bend))).next_up()
        };
        let (from_start, from_end) = (beyond(&step.start), beyond(&step.end));
        return worse(ends, if from_start < from_end { from_start } else { from_end });
    }
    step.x.upper()
}

/// How far ζ at V = V_l can be from that at an end of the step, and which end.
///
/// x is monotone. Between an end, at x = X, and V = V_l, ζ changes by ∫(dζ/dt)/x' dx ≤ |X| (e^|X| − 1) sup|ζ'/(1 − e^x)|/inf|x'|.
fn stress_beyond_ends(step: &Passed) -> Option<(&Moment, f64)> {
    let slowest = step.speed.mignitude();
    if !(slowest > 0.0) {
        return None;
    }
    let of = |moment: &Moment| {
        let x = moment.x.magnitude();
        let excess = (Interval::point(x).exp() - Interval::ONE).magnitude();
        generously_up(x * excess * step.loading.magnitude() / slowest)
    };
    let (start, end) = (of(&step.start), of(&step.end));
    Some(if start < end { (&step.start, start) } else { (&step.end, end) })
}
