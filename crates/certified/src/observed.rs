//! What an enclosed motion shows: peak velocity, extremes of the spring stress, and elapsed time.

use crate::interval::{Interval, generously_up, worse};

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

impl Passed {
    /// Whether x crosses the section at most once, upward: it starts below, and rises all the time or is convex.
    pub fn crosses_once(&self, section: f64) -> bool {
        self.start.x.upper() < section && (self.speed.lower() > 0.0 || self.acceleration.lower() > 0.0)
    }
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
    pub fn with_rest(mut self, [x, highest, lowest]: [f64; 3]) -> Self {
        self.peak.at_most(x);
        self.highest_stress.at_most(highest);
        self.lowest_stress.at_most(lowest);
        self
    }

    /// Notes a step.
    pub fn step(&mut self, step: &Passed) {
        for moment in [&step.start, &step.end] {
            self.state(moment.x, moment.stress);
        }
        self.peak.at_most(highest(step));
        if step.x.may_contain(0.0) {
            let (stress, change) = match stress_beyond_ends(step) {
                Some((moment, change)) => (moment.stress, change),
                None => {
                    let rate = step.loading.magnitude() * (Interval::ONE - step.x.exp()).magnitude();
                    (step.start.stress.hull(step.end.stress), generously_up(rate * step.length))
                }
            };
            self.highest_stress.at_most((stress.upper() + change).next_up());
            self.lowest_stress.at_most((change - stress.lower()).next_up());
        }
        self.duration = self.duration + step.duration;
    }

    /// Notes a short time in which x may rise or fall.
    pub fn wait(&mut self, x: Interval, [stress, change]: [Interval; 2], duration: Interval) {
        self.peak.at_most(x.upper());
        if x.may_contain(0.0) {
            let stress = stress.widened(change.magnitude());
            self.highest_stress.at_most(stress.upper());
            self.lowest_stress.at_most(-stress.lower());
        }
        self.duration = self.duration + duration;
    }

    /// Lower and upper bound of the largest x.
    pub const fn peak(&self) -> [f64; 2] {
        [self.peak.low, self.peak.high]
    }

    /// Lower bounds of the largest ζ and of the largest −ζ.
    pub const fn least_extremes(&self) -> [f64; 3] {
        [self.peak.low, self.highest_stress.low, self.lowest_stress.low]
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

#[cfg(test)]
mod tests {
    use super::*;

    const LOADING: f64 = 0.7;

    /// The hull of the numbers.
    fn hull(values: impl Iterator<Item = f64>) -> Interval {
        values.map(Interval::point).reduce(Interval::hull).unwrap()
    }

    /// Motions x = c − m(t − t₀)²/2 + v t of a step from 0 to 1, given as (c, m, t₀, v): what is observed holds each of them.
    fn holds_all(motions: &[[f64; 4]], margin: f64) {
        const PARTS: usize = 1000;
        let x = |[c, m, t0, v]: [f64; 4], t: f64| c - 0.5 * m * (t - t0) * (t - t0) + v * t;
        let speed = |[_, m, t0, v]: [f64; 4], t: f64| v - m * (t - t0);
        let time = |part: usize| part as f64 / PARTS as f64;
        // ζ' = L(1 − e^x) by Simpson's rule.
        let stresses: Vec<Vec<f64>> = motions
            .iter()
            .map(|&motion| {
                let rate = |t: f64| -LOADING * libm::expm1(x(motion, t));
                let mut stress = vec![0.0];
                for part in 0..PARTS {
                    let [from, to] = [time(part), time(part + 1)];
                    let mean = (rate(from) + 4.0 * rate(0.5 * (from + to)) + rate(to)) / 6.0;
                    stress.push(stress[part] + mean * (to - from));
                }
                stress
            })
            .collect();
        let over = |of: &dyn Fn([f64; 4], f64) -> f64, parts: std::ops::RangeInclusive<usize>| {
            hull(motions.iter().flat_map(|&motion| parts.clone().map(move |part| of(motion, time(part)))))
        };
        let moment = |part: usize| Moment {
            x: over(&x, part..=part),
            speed: over(&speed, part..=part),
            stress: hull(stresses.iter().map(|stress| stress[part])),
        };
        let tops = motions.iter().map(|&motion| {
            let [_, m, t0, v] = motion;
            x(motion, if m == 0.0 { 0.0 } else { (t0 + v / m).clamp(0.0, 1.0) })
        });
        let mut observed = Observed::new();
        observed.step(&Passed {
            start: moment(0),
            end: moment(PARTS),
            x: over(&x, 0..=PARTS).hull(hull(tops)),
            speed: over(&speed, 0..=PARTS),
            acceleration: hull(motions.iter().map(|[_, m, ..]| -m)),
            loading: Interval::between(0.1 * LOADING, LOADING),
            length: 1.0,
            duration: Interval { mid: 1.0, rad: 0.1 },
        });
        let [low, high] = observed.peak();
        let largest = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mut highest = f64::NEG_INFINITY;
        for (&motion, stress) in motions.iter().zip(&stresses) {
            let [_, m, t0, v] = motion;
            let top = if m == 0.0 { 0.0 } else { (t0 + v / m).clamp(0.0, 1.0) };
            let peak = x(motion, top).max(x(motion, 0.0)).max(x(motion, 1.0));
            assert!(low <= peak && peak <= high, "{motion:?} {peak} {low} {high}");
            highest = highest.max(peak);
            let extremes = [largest(stress), largest(&stress.iter().map(|s| -s).collect::<Vec<_>>())];
            for (maximum, value) in [observed.highest_stress, observed.lowest_stress].iter().zip(extremes) {
                assert!(maximum.low <= value && value <= maximum.high, "{motion:?} {value} {maximum:?}");
            }
            let [least, most] = observed.stress_drop();
            let drop = extremes[0] + extremes[1];
            assert!(least <= drop && drop <= most, "{motion:?} {drop} {least} {most}");
        }
        assert!(high - highest <= margin, "{high} {highest}");
        assert!(observed.duration.may_contain(0.901) && observed.duration.may_contain(1.099));
    }

    #[test]
    fn a_step_shows_all_that_its_motions_reach() {
        for (motions, margin) in [
            // A maximum in the middle, where both ends give the same bound, and of unequal motions.
            (vec![[1.0, 1.0, 0.5, 0.0]], 1e-9),
            (vec![[1.0, 1.0, 0.45, 0.0], [1.1, 1.1, 0.55, 0.0], [0.9, 1.05, 0.5, 0.0]], 0.1),
            // Rising, falling, and convex motions.
            (vec![[0.3, 0.0, 0.0, 1.0], [0.4, 0.0, 0.0, 0.5]], 1e-9),
            (vec![[0.3, 0.0, 0.0, -1.0], [0.4, 0.0, 0.0, -0.5]], 1e-9),
            (vec![[0.0, -1.0, 0.3, 0.0], [0.0, -1.0, 0.7, 0.0]], 1e-9),
            // The speed has one sign for one motion only; the acceleration has no sign.
            (vec![[0.3, 1.0, 0.5, 0.0], [0.3, 0.5, 2.5, 0.0]], 1.0),
            (vec![[0.3, 2.0, 0.5, 0.0], [0.0, -0.1, 0.5, 0.0]], 1.0),
            // Across V = V_l: upward and downward at several speeds, and a maximum of x there.
            (vec![[-0.5, 0.0, 0.0, 1.0]], 1e-9),
            (vec![[0.5, 0.0, 0.0, -1.0]], 1e-9),
            (vec![[-0.4, 0.0, 0.0, 1.0], [-0.5, 0.0, 0.0, 0.9], [-0.6, 0.0, 0.0, 1.1]], 1e-9),
            (vec![[0.4, 0.0, 0.0, -1.0], [0.5, 0.0, 0.0, -0.9], [0.6, 0.0, 0.0, -1.1]], 1e-9),
            (vec![[-0.5, -1.0, 0.0, 0.6], [-0.45, -1.0, 0.0, 0.7]], 1e-9),
            (vec![[-0.2, 0.0, 0.0, 0.4], [-0.2, 0.0, 0.0, 2.0]], 1e-9),
            (vec![[-0.4, 0.0, 0.0, 1.0], [-0.1, 0.0, 0.0, 1.0]], 1e-9),
            (vec![[0.3, 4.0, 0.5, 0.0]], 1e-9),
            (vec![[-0.3, -4.0, 0.5, 0.0]], 1e-9),
            (vec![[0.5, 4.0, 0.5, 0.0]], 1e-9),
            (vec![[-0.5, -4.0, 0.5, 0.0]], 1e-9),
            // From or to V = V_l nearly, and far beyond it in between.
            (vec![[-2.0, -19.85, 0.45, 0.0]], 1e-9),
            (vec![[-2.0, -19.85, 0.55, 0.0]], 1e-9),
            // Far above V = V_l at one end, where e^x − 1 is much more than x.
            (vec![[3.0, 0.0, 0.0, -9.0]], 1e-9),
            (vec![[-6.0, 0.0, 0.0, 9.0]], 1e-9),
        ] {
            holds_all(&motions, margin);
        }
    }

    /// x = 1 − (t − ½)²/4 where x'' is only known to lie between −2 and −½: the weaker bend decides.
    #[test]
    fn the_weakest_bend_bounds_a_maximum() {
        let moment = |speed: f64| Moment {
            x: Interval::point(0.9375),
            speed: Interval::point(speed),
            stress: Interval::ZERO,
        };
        let found = highest(&Passed {
            start: moment(0.25),
            end: moment(-0.25),
            x: Interval::between(0.9375, 2.0),
            speed: Interval::symmetric(0.25),
            acceleration: Interval::between(-2.0, -0.5),
            loading: Interval::ZERO,
            length: 1.0,
            duration: Interval::ONE,
        });
        assert!((1.0..1.001).contains(&found), "{found}");
    }

    /// A maximum that has no bound keeps none, whatever follows; values that are taken are bounds from below and from above.
    #[test]
    fn a_maximum_without_a_bound_stays_without() {
        for unknown in [f64::NAN, f64::INFINITY] {
            for order in [[unknown, 1.0], [1.0, unknown]] {
                let mut maximum = Maximum::NONE;
                order.iter().for_each(|&bound| maximum.at_most(bound));
                assert!(!maximum.high.is_finite(), "{order:?}");
            }
        }
        let mut observed = Observed::new();
        observed.state(Interval { mid: 1.0, rad: 0.5 }, Interval { mid: 2.0, rad: 0.25 });
        let [low, high] = observed.peak();
        assert!((0.49..=0.5).contains(&low) && (1.5..1.51).contains(&high), "{low} {high}");
        let [_, highest, lowest] = observed.least_extremes();
        assert!((1.74..=1.75).contains(&highest) && (-2.26..=-2.25).contains(&lowest), "{highest} {lowest}");
    }

    /// A wait shows what its states reach and adds its time; what follows a run counts.
    #[test]
    fn waits_and_the_rest_of_a_run_are_observed() {
        let mut observed = Observed::new();
        observed.state(Interval::point(-1.0), Interval::point(0.0));
        let [x, stress, change, duration] = [0.1, 0.5, 0.25, 0.125].map(Interval::symmetric);
        observed.wait(x, [stress, change], duration);
        let holds = |[low, high]: [f64; 2], ends: [f64; 2]| low <= ends[0] && ends[1] <= high;
        assert!(holds(observed.peak(), [-1.0, 0.1]) && holds(observed.stress_drop(), [0.0, 1.5]));
        assert!(observed.duration.lower() <= -0.125 && observed.duration.upper() >= 0.125);
        let observed = observed.with_rest([1.0, 2.0, 3.0]);
        assert!(holds(observed.peak(), [-1.0, 1.0]) && holds(observed.stress_drop(), [0.0, 5.0]));
    }
}
