//! Steps of a sticking slider on the slow manifold, and the changes between both descriptions.

use crate::interval::{Interval, generously_up, worse};
use crate::manifold::{Manifold, Passage, Tube};
use crate::motion::{CrossingSet, Motion, States, landing};
use crate::observed::{Moment, Passed};
use crate::set::{COORDINATES, Derivative, Set, column_sizes};
use crate::slow::Slow;
use crate::step::{Expansion, Step};
use crate::{Constants, Reason};

/// The delay by inertia (ε times the fastest slow rate) at which a sticking slider is followed on the slow manifold.
pub(super) const ENTRY_DELAY: f64 = 2e-4;
/// The same at which this ends.
pub(super) const EXIT_DELAY: f64 = 4e-4;

/// How much larger the delay may be before a section is reached.
const LATE: f64 = 4.0;

/// The distance in F from the slow manifold at which it is entered.
const NEAR: f64 = 1e-14;
/// The same over what the tube settles at.
const NEAR_SETTLED: f64 = 4.0;

/// The disturbance by ψ that the box of a step allows for at least.
const LEAST_DISTURBANCE: f64 = 1e-18;

/// The longest step over the inverse of the fastest slow rate.
const LONGEST_SLOW: f64 = 2.0;

/// How many times ε a step takes while ψ still fades.
const FADING: f64 = 40.0;

/// A step on the slow manifold: the box of its states, and the set and the tube at its start.
pub(super) struct LastStep<'s> {
    pub during: [Interval; 2],
    pub start: &'s Set<2>,
    pub tube: Tube,
    pub h: f64,
}

impl LastStep<'_> {
    /// The rates of x and y in a box that the step enters if it lasts a little longer, with the slow manifold and the tube there.
    pub fn over(
        &self,
        constants: &Constants,
        at: &[Interval; 2],
        time: f64,
    ) -> Result<([Interval; 2], (Manifold, Tube)), Reason> {
        let whole = Manifold::over(constants, &std::array::from_fn(|i| self.during[i].hull(at[i])));
        let sizes = column_sizes(&self.start.derivative());
        let passage = whole.passage(self.tube, generously_up(self.h + time), sizes);
        let tube = passage.ok_or(Reason::LeftTheTube)?.after((self.h - time).max(0.0));
        let manifold = Manifold::over(constants, at);
        Ok(([manifold.rate.widened(tube.distance), manifold.state_rate], (manifold, tube)))
    }
}

/// A step of the slow equations in a box that holds the whole slider, and the tube in this box.
pub(super) struct InTube {
    pub step: Step<2, 3>,
    manifold: Manifold,
    passage: Passage,
}

impl InTube {
    /// The step of length h, if ψ moves the state by less than is `allowed`; if not, more is allowed the next time.
    pub fn of(
        constants: &Constants,
        expansion: &Expansion<2, 3>,
        set: &Set<2>,
        tube: Tube,
        h: f64,
        allowed: &mut f64,
    ) -> Option<Self> {
        let step = expansion.step(&Slow(constants), set, h, *allowed)?;
        let manifold = Manifold::over(constants, &step.during);
        let passage = manifold.passage(tube, h, column_sizes(&set.derivative()))?;
        let is_allowed = passage.moved < *allowed;
        *allowed = worse(*allowed, 4.0 * passage.moved);
        is_allowed.then_some(Self { step, manifold, passage })
    }

    /// The image of the set, and all that ψ adds to it.
    ///
    /// With |x' − ξ_n| = |ψ| the state is off by at most d = e^{μh}∫|ψ|, where μ bounds the derivative of the rates (Gronwall). The derivative by
    /// the initial state is off by e^{μh} h d sup|second derivatives| times its size, and by e^{μh}∫|∂ψ/∂p|.
    pub fn end(&self, set: &Set<2>, h: f64) -> Set<2> {
        let Self { step, manifold, passage: Passage { moved, moved_slopes, growth, .. } } = self;
        let bend = generously_up(growth * h * moved * manifold.largest_bend * step.largest_slope);
        let image = step.image.map(|c| c.widened(*moved));
        let slope = step.slope.map(|row| row.map(|entry| entry.widened(bend)));
        set.mapped(image, &slope, &[moved_slopes.map(Interval::symmetric); 2])
    }
}

impl Motion<'_> {
    /// The states on the slow manifold, if they are near enough to it.
    pub(super) fn entered(&self, set: &Set<3>) -> Option<States> {
        let [x, y, f] = set.hull();
        if !(self.has_fallen && self.may_stick) {
            return None;
        }
        let largest_delay = self.lateness * ENTRY_DELAY;
        if !(Manifold::least_delay(self.constants, &[x, y]) < largest_delay) {
            return None;
        }
        let manifold = Manifold::over(self.constants, &[x, y]);
        if !(manifold.delay() < largest_delay) {
            return None;
        }
        let off = f - manifold.inertia * manifold.rate;
        let settled = NEAR_SETTLED * manifold.inertia.magnitude() * manifold.settled();
        if !(off.magnitude() < NEAR + settled + NEAR_SETTLED * off.rad) {
            return None;
        }
        let inverse = manifold.inertia.reciprocal();
        let speed = f * inverse;
        let d = set.derivative();
        let slopes = std::array::from_fn(|j| {
            let [along_x, along_y] = manifold.rate_gradient;
            (d[2][j] * inverse - (speed + along_x) * d[0][j] - along_y * d[1][j]).magnitude()
        });
        let tube = Tube { distance: (speed - manifold.rate).magnitude(), slopes };
        let [cx, cy, _] = set.at_centre();
        let kept: Derivative<2> = [d[0], d[1]];
        Some(States::Stuck(Set::new(set.section, [cx, cy], kept), tube))
    }

    /// The states of a slider that no longer sticks: F = ε(ξ_n + ψ).
    fn left(&self, set: &Set<2>, tube: Tube, over_hull: &Manifold) -> Set<3> {
        let centre = set.centre.map(Interval::point);
        let at_centre = Manifold::over(self.constants, &centre);
        let (zero, one) = (Interval::ZERO, Interval::ONE);
        let of_tube = |size: f64| over_hull.inertia * Interval::symmetric(size);
        let force = at_centre.inertia * at_centre.rate + of_tube(tube.distance);
        let [by_x, by_y] = over_hull.rate_gradient;
        let slope = [over_hull.inertia * (over_hull.rate + by_x), over_hull.inertia * by_y];
        // F depends on x by ε(ξ_n + ψ), and on p by εψ as well.
        let sizes = column_sizes(&set.derivative());
        let gained =
            std::array::from_fn(|j| of_tube(generously_up(tube.slopes[j] + tube.distance * sizes[j])));
        set.lifted(
            [centre[0], centre[1], force],
            &[[one, zero], [zero, one], slope],
            &[[zero; COORDINATES], [zero; COORDINATES], gained],
        )
    }

    pub(super) fn slow_step(
        &mut self,
        set: &Set<2>,
        tube: Tube,
        section: Option<f64>,
    ) -> Result<Option<CrossingSet>, Reason> {
        let system = Slow(self.constants);
        let expansion = Expansion::new(&system, set);
        let start_hull = set.hull();
        let here = Manifold::over(self.constants, &start_hull);
        let largest_delay = if section.is_some() { LATE * EXIT_DELAY } else { EXIT_DELAY };
        if here.delay() > self.lateness * largest_delay {
            self.states = States::Inertial(self.left(set, tube, &here));
            return Ok(None);
        }
        let length = expansion.length();
        let mut aimed = (self.reach * length).min(LONGEST_SLOW / here.largest_slope);
        if tube.distance > self.lateness * NEAR_SETTLED * here.settled() {
            aimed = aimed.min(FADING * here.inertia.mid);
        }
        let (h, landed) = landing(&expansion, [aimed, length], section);
        let mut allowed = LEAST_DISTURBANCE;
        let (h, taken) = self.held(h, |h| {
            // How far ψ moves the state does not depend on derivatives.
            if let Some(expected) = here.passage(tube, h, [0.0; COORDINATES]) {
                allowed = worse(allowed, 4.0 * expected.moved / expected.growth);
            }
            InTube::of(self.constants, &expansion, set, tube, h, &mut allowed)
        })?;
        let end = taken.end(set, h);
        let end_tube = taken.passage.after(h);
        let start = self.slow_moment(&start_hull, &here, tube.distance);
        let passed = self.slow_passed(start, &end.hull(), &taken, h);
        let last = LastStep { during: taken.step.during, start: set, tube, h };
        if let Some(x) = self.noted(&passed, landed == Some(h), section)? {
            let crossing = self.slow_crossing(&end, &last, x)?;
            self.states = States::Stuck(end, end_tube);
            return Ok(Some(crossing));
        }
        let (end, tube) = self.slow_without_flow(&end, &last, section).unwrap_or((end, end_tube));
        self.states = States::Stuck(end, tube);
        Ok(None)
    }

    /// What a step shows.
    pub(super) fn slow_passed(&self, start: Moment, end: &[Interval; 2], taken: &InTube, h: f64) -> Passed {
        let InTube { step, manifold, passage } = taken;
        let largest = passage.after(0.0).distance;
        let at_end = Manifold::over(self.constants, end);
        Passed {
            start,
            end: self.slow_moment(end, &at_end, passage.after(h).distance),
            x: step.during[0],
            speed: manifold.rate.widened(largest),
            acceleration: manifold.acceleration(largest),
            loading: self.constants.stiffness,
            length: h,
            duration: Interval::point(h),
        }
    }

    pub(super) fn slow_moment(&self, [x, y]: &[Interval; 2], manifold: &Manifold, distance: f64) -> Moment {
        let speed = manifold.rate.widened(distance);
        let stress = manifold.inertia * speed + *x + self.constants.effect_ratio * *y;
        Moment { x: *x, speed, stress }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::friction::EvolutionLaw;

    /// x' = x² with y' = 0, which ψ pushes by I + Jp at the start: then x = u/(1 − uh) with u = x₀ + p + I + Jp, and its derivative by p
    /// is (1 + J)/(1 − uh)².
    #[test]
    fn what_psi_adds_to_a_step_is_held_in_closed_form() {
        let one = Interval::point(1.0);
        let constants =
            Constants { inertia: one, stiffness: one, effect_ratio: one, law: EvolutionLaw::Slip };
        let zero = Interval::ZERO;
        let nothing = Tube { distance: 0.0, slopes: [0.0; COORDINATES] };
        let of_no_tube =
            Manifold::over(&constants, &[zero; 2]).passage(nothing, 1e-9, [0.0; COORDINATES]).unwrap();
        for (from, h) in [(0.5_f64, 0.5), (1.0, 0.3), (0.2, 2.0), (-1.0, 0.5)] {
            for (impulse, by_p) in [(0.02, 0.0), (0.0, 0.3), (0.02, 0.3), (0.05, 0.01)] {
                for direction in 0..2 {
                    // In one of the two components, while the other one rests.
                    let place = |value: Interval| if direction == 0 { [value, zero] } else { [zero, value] };
                    let mut manifold = Manifold::over(&constants, &[zero; 2]);
                    let largest = (from + impulse) / (1.0 - (from + impulse) * h);
                    let largest = largest.abs().max((from + impulse).abs());
                    (manifold.largest_slope, manifold.largest_bend) = (2.0 * largest, 2.0);
                    let growth = libm::exp(manifold.largest_slope * h);
                    let at = |u: f64| [u / (1.0 - u * h), 1.0 / ((1.0 - u * h) * (1.0 - u * h))];
                    let [x, slope] = at(from);
                    let mut slopes = [[Interval::ONE, zero], [zero, Interval::ONE]];
                    slopes[direction][direction] = Interval::point(slope);
                    let step = Step {
                        during: [zero; 2],
                        image: place(Interval::point(x)),
                        slope: slopes,
                        largest_slope: slope.max(1.0),
                        duration: Interval::point(h),
                    };
                    let by_first = place(Interval::ONE).map(|slope| [slope, zero]);
                    let start = Set::new([zero; 2], place(Interval::point(from)), by_first);
                    let mut passage = of_no_tube;
                    (passage.growth, passage.moved) = (growth, impulse * growth);
                    passage.moved_slopes = [by_p * growth, 0.0];
                    let end = InTube { step, manifold, passage }.end(&start, h);
                    for sign in [1.0, -1.0] {
                        let [pushed, slope] = at(from + sign * impulse);
                        let holds =
                            |c: Interval, value: f64| c.widened(1e-14 * value.abs()).may_contain(value);
                        assert!(
                            holds(end.hull()[direction], pushed),
                            "{from} {impulse} {pushed} {:?}",
                            end.hull()
                        );
                        for of_p in [1.0 + by_p, 1.0 - by_p] {
                            let derivative = end.derivative()[direction][0];
                            assert!(
                                holds(derivative, slope * of_p),
                                "{from} {impulse} {by_p} {} {derivative:?}",
                                slope * of_p
                            );
                        }
                    }
                }
            }
        }
    }
}
