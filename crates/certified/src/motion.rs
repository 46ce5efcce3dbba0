//! An enclosed motion: the whole slider where inertia matters, the slow manifold with its tube where it sticks.

use crate::inertial::Inertial;
use crate::interval::{Interval, worse};
use crate::manifold::Tube;
use crate::observed::{Moment, Observed, Passed};
use crate::set::{COORDINATES, Set};
use crate::step::{Expansion, Step};
use crate::{Constants, Reason};

/// Attempts to find a step that is held by its box, each shorter than the one before.
const ATTEMPTS: usize = 40;
const SHORTER: f64 = 0.75;
const LONGER: f64 = 1.04;

/// A crossing this near to the start of a step, in parts of its length, is the one that the last step ended on.
const JUST_LEFT: f64 = 1e-7;
/// The same in parts of the length at which the terms of the series are small: an extreme is not known to less.
const ROUNDING: f64 = 1e-14;

/// The set of states, in either description.
#[derive(Debug, Clone)]
pub(super) enum States {
    /// (x, y, F).
    Inertial(Set<3>),
    /// (x, y) and ψ.
    Stuck(Set<2>, Tube),
}

/// Where the motion crossed the section, seen from p.
#[derive(Debug, Clone)]
pub(super) struct CrossingSet {
    /// (y, F) or (y, ψ) for p = 0.
    pub centre: [Interval; COORDINATES],
    /// Its derivative by p over the box.
    pub derivative: [[Interval; COORDINATES]; COORDINATES],
}

/// A motion in progress.
#[derive(Debug, Clone)]
pub(super) struct Motion<'c> {
    pub constants: &'c Constants,
    pub states: States,
    pub observed: Observed,
    /// Part of the length aimed at that the last steps took.
    pub reach: f64,
    /// The largest such part.
    pub longest: f64,
    steps_left: u64,
    /// Whether sticking states are followed on the slow manifold, after x has fallen.
    pub may_stick: bool,
    pub has_fallen: bool,
    /// The delays at which the slow manifold is entered and left, over those of a cycle.
    pub lateness: f64,
    /// Whether x has risen all the time since the start.
    has_only_risen: bool,
}

impl<'c> Motion<'c> {
    /// A motion of at most so many steps.
    pub const fn new(constants: &'c Constants, states: States, most_steps: u64) -> Self {
        Self {
            constants,
            states,
            observed: Observed::new(),
            reach: 0.7,
            longest: 1.0,
            steps_left: most_steps,
            may_stick: true,
            has_fallen: false,
            lateness: 1.0,
            has_only_risen: true,
        }
    }

    /// One step, which ends on `section` (rising) if it reaches it; then the crossing.
    pub fn advance(&mut self, section: Option<f64>) -> Result<Option<CrossingSet>, Reason> {
        self.steps_left = self.steps_left.checked_sub(1).ok_or(Reason::TooManySteps)?;
        match self.states.clone() {
            States::Inertial(set) => self.inertial_step(&set, section),
            States::Stuck(set, tube) => self.slow_step(&set, tube, section),
        }
    }

    fn inertial_step(&mut self, set: &Set<3>, section: Option<f64>) -> Result<Option<CrossingSet>, Reason> {
        let system = Inertial(self.constants);
        let expansion = Expansion::new(&system, set);
        let length = expansion.length();
        let (h, landed) = landing(&expansion, [self.reach * length, length], section);
        let (h, step) = self.held(h, |h| expansion.step(&system, set, h, 0.0))?;
        let end = set.mapped(step.image, &step.slope, &[[Interval::ZERO; COORDINATES]; 3]);
        let passed = self.passed([&set.hull(), &end.hull()], &step, h);
        self.has_fallen |= passed.end.speed.upper() < 0.0;
        if let Some(x) = self.noted(&passed, landed == Some(h), section)? {
            let crossing = self.inertial_crossing(&end, x)?;
            self.states = States::Inertial(end);
            return Ok(Some(crossing));
        }
        let end = self.without_flow(&end, section).unwrap_or(end);
        self.states = self.entered(&end).unwrap_or(States::Inertial(end));
        Ok(None)
    }

    /// Notes a step. The section, if the step ends on it.
    pub(super) fn noted(
        &mut self,
        step: &Passed,
        is_crossing: bool,
        section: Option<f64>,
    ) -> Result<Option<f64>, Reason> {
        self.observed.step(step);
        match section {
            Some(x) if is_crossing => step.crosses_once(x).then_some(section).ok_or(Reason::Tangent),
            Some(x) => self.refuse_other_crossings(step, x).map(|()| None),
            None => Ok(None),
        }
    }

    /// What a step shows.
    pub(super) fn passed(&self, [start, end]: [&[Interval; 3]; 2], step: &Step<3, 4>, h: f64) -> Passed {
        let Constants { inertia, stiffness, .. } = *self.constants;
        let [x, _, speed] = step.during;
        let [_, _, acceleration] = Inertial(self.constants).rates(&step.during);
        Passed {
            start: self.moment(start),
            end: self.moment(end),
            x,
            speed,
            acceleration,
            loading: stiffness * inertia * x.exp(),
            length: h,
            duration: step.duration,
        }
    }

    pub(super) fn moment(&self, [x, y, f]: &[Interval; 3]) -> Moment {
        Moment { x: *x, speed: *f, stress: *f + *x + self.constants.effect_ratio * *y }
    }

    /// A step before the return must not cross the section upward. One that has only risen since it started there cannot.
    pub(super) fn refuse_other_crossings(&mut self, step: &Passed, section: f64) -> Result<(), Reason> {
        self.has_only_risen &= step.speed.lower() > 0.0;
        if step.x.may_contain(section) && !self.has_only_risen && !(step.speed.upper() < 0.0) {
            return Err(Reason::Tangent);
        }
        Ok(())
    }

    /// The longest step, from h downward, that is held by its box.
    pub(super) fn held<T>(
        &mut self,
        h: f64,
        mut step: impl FnMut(f64) -> Option<T>,
    ) -> Result<(f64, T), Reason> {
        let mut length = h;
        for attempt in 0..ATTEMPTS {
            if let Some(found) = step(length) {
                if attempt == 0 {
                    self.reach = (self.reach * LONGER).min(self.longest);
                }
                return Ok((length, found));
            }
            length *= SHORTER;
            self.reach *= SHORTER;
            if !(length > 0.0 && length.is_finite()) {
                break;
            }
        }
        Err(Reason::NoEnclosure)
    }
}

/// The length at which the centre reaches the section, V = V_l or an extreme of V; otherwise the length aimed at. Second, the same length
/// if it is that of the section. `length` is that at which the terms of the series are small.
pub(super) fn landing<const N: usize, const C: usize>(
    expansion: &Expansion<N, C>,
    [aimed, length]: [f64; 2],
    section: Option<f64>,
) -> (f64, Option<f64>) {
    let nearest = worse(JUST_LEFT * aimed, ROUNDING * length);
    let is_new = |length: &f64| *length > nearest;
    let start = expansion.centre[0][0].mid[0];
    let level = |x: f64| expansion.crossing(aimed, |length| expansion.velocity_at(length) - x).filter(is_new);
    let reached = section.filter(|&x| start < x).and_then(level);
    let extreme = expansion.crossing(aimed, |length| expansion.acceleration_at(length)).filter(is_new);
    let first = [level(0.0), extreme].into_iter().flatten().fold(aimed, f64::min);
    match reached {
        Some(length) if length <= first => (length, Some(length)),
        _ => (first, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::members::passing;
    use slipmode_core::friction::EvolutionLaw;

    /// Steps by x and x', in parts of the section and of a speed; what may be a second upward crossing is refused.
    #[test]
    fn an_upward_crossing_before_the_return_is_refused() {
        let point = Interval::point(1.0);
        let constants =
            Constants { inertia: point, stiffness: point, effect_ratio: point, law: EvolutionLaw::Slip };
        let none = [Interval::ZERO; COORDINATES];
        let set = Set::new(none, [Interval::ZERO; 3], [none; 3]);
        let [rises, falls, turns] = [[1.0, 0.9], [-1.0, 0.9], [0.1, 1.0]];
        let falls_mostly = [-0.1, 1.0];
        let [at, above, below] = [[0.0, 0.1], [1.0, 0.5], [-1.0, 0.5]];
        for (steps, is_refused) in [
            (vec![(at, rises), (above, turns), (at, falls), (below, turns)], false),
            (vec![(at, rises), (above, turns), (at, falls), (below, turns), (at, rises)], true),
            (vec![(at, rises), (above, turns), (at, turns)], true),
            (vec![(at, rises), (above, falls_mostly), (at, falls_mostly)], true),
            (vec![(at, turns)], true),
            (vec![(at, falls), (at, rises)], true),
        ] {
            let mut motion = Motion::new(&constants, States::Inertial(set.clone()), 1);
            let found = steps.iter().try_for_each(|&([x, of_x], [speed, of_speed])| {
                let [x, speed] = [(x, of_x), (speed, of_speed)].map(|(mid, rad)| Interval { mid, rad });
                motion.refuse_other_crossings(&passing(x, speed), 0.0)
            });
            assert_eq!(found.is_err(), is_refused, "{steps:?}");
        }
    }
}
