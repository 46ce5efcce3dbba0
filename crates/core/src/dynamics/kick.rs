//! The smallest kick by which a slider leaves stable steady sliding and reaches a limit cycle.
//!
//! Where steady sliding and a cycle both attract, a finite disturbance decides between them. Kicks of rising size are tried, and the border
//! between the last that decays and the first that does not is bisected. The set of kicks that decay need not be an interval: what is found
//! is the smallest border between two tried sizes, not a proof that no smaller kick leaves.
//!
//! One run is decided on the section V = V_l, without extrapolation. After some returns the crossings move along the slow direction, in one
//! dimension, where no trajectory passes a fixed point. A stress at the crossing that rises there does not return to steady sliding. One that
//! falls decays once the amplitude A is small: the rate of growth is r_0 + cA² there, negative at A and at 0, and so between.

use std::cell::Cell;

use super::history::{History, size};
use super::integrator::{Control, Integrator};
use super::section_return::{FAINT, ReturnEnd, return_above};
use super::threshold::border;
use super::{Failure, Model, Radau, Start, State};

slipmode_algebra::named! {
    /// A sudden change of a slider in steady sliding.
    ///
    /// ```
    /// use slipmode_core::dynamics::Kick;
    ///
    /// assert_eq!(Kick::ALL.map(Kick::as_str), ["velocity-up", "velocity-down", "stress-up", "stress-down"]);
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Kick {
        /// V rises; state and spring stay.
        VelocityUp = "velocity-up",
        /// V falls; state and spring stay.
        VelocityDown = "velocity-down",
        /// The stress of the spring rises; V and state stay.
        StressUp = "stress-up",
        /// The stress of the spring falls; V and state stay.
        StressDown = "stress-down",
    }
}

/// The smallest size that is tried.
const SMALLEST: f64 = 1e-4;

/// Sizes that are tried in each decade.
const SIZES_PER_DECADE: f64 = 8.0;

/// Relative width to which a border is bisected.
const WIDTH: f64 = 1e-6;

/// Returns after which a trajectory moves along the slow direction alone.
const RETURNS: u64 = 8;

/// The return whose peak is compared with that of a cycle: what is left of the fast direction is far below rounding.
const LATE: u64 = 12;

/// Amplitude of ln(V/V_l) below which the rate of growth is r_0 + cA².
const SMALL: f64 = 0.05;

/// A change of stress over aσ whose square is below rounding.
const LINEAR: f64 = 1e-9;

/// Most returns of one run; a part of 1e-4 above K_c takes a tenth of them.
const MOST_RETURNS: u64 = 100_000;

/// Of the returns: their relative errors are below [`NOISE`].
const CONTROL: Control = Control { local_tolerance: 1e-10, most_steps: 20_000_000 };

/// Relative changes of a return that its errors may hide.
const NOISE: f64 = 1e-12;

/// The least decay of small deviations in one return. The square of the smallest kick is in proportion to it, so that errors of returns change
/// the kick by a part of NOISE/LEAST_DECAY at most.
const LEAST_DECAY: f64 = 1e-9;

impl Kick {
    /// Whether V changes, and not the stress.
    #[must_use]
    pub const fn is_of_velocity(self) -> bool {
        matches!(self, Self::VelocityUp | Self::VelocityDown)
    }

    /// 1 or -1.
    pub(crate) const fn sign(self) -> f64 {
        if matches!(self, Self::VelocityUp | Self::StressUp) { 1.0 } else { -1.0 }
    }

    /// The largest size that is tried: V changes by a factor of a million, or the stress by 10 aσ.
    #[must_use]
    pub fn largest(self) -> f64 {
        if self.is_of_velocity() { libm::log(1e6) } else { 10.0 }
    }

    /// Steady sliding right after a kick of this size: of |ln(V/V_l)|, or of the change of stress over aσ.
    #[must_use]
    pub fn state(self, model: &Model<f64>, size: f64) -> State<f64> {
        if self.is_of_velocity() {
            Start::VelocityKick.state(model, &(self.sign() * size))
        } else {
            [0.0, 0.0, self.sign() * size]
        }
    }

    /// V/V_l − 1, or the change of stress over aσ, right after a kick of this size.
    #[must_use]
    pub fn change(self, size: f64) -> f64 {
        let signed = self.sign() * size;
        if self.is_of_velocity() { libm::expm1(signed) } else { signed }
    }

    /// ln(V_peak/V_l) of a late return after a kick of this size, when the run moves along the slow direction alone. Next to the smallest
    /// kick this is the unstable cycle's.
    ///
    /// # Errors
    /// Those of the integrator, and [`Failure::Undecided`] where the slider comes to rest before.
    pub fn late_peak(self, model: &Model<f64>, size: f64) -> Result<f64, Failure> {
        let mut run = Integrator::new(model, Radau::<f64, 5>::new(), self.state(model, size), CONTROL)?;
        let mut peak = f64::NEG_INFINITY;
        for _ in 0..LATE {
            let (orbit, end) = return_above(&mut run, FAINT)?;
            if end == ReturnEnd::AtRest {
                return Err(Failure::Undecided { cycles: LATE, change: 1.0 });
            }
            peak = orbit.peak;
        }
        Ok(peak)
    }

    /// The sizes between which the smallest kick lies that leaves steady sliding: the first decays and the second ends on a cycle. None when
    /// no tried size leaves.
    ///
    /// `decayed` is 0 at first. It becomes the largest stress at a crossing on the slow direction from which a run returned to steady
    /// sliding. Searches of the same slider share it: a run that falls below it returns, too, and needs no longer be followed.
    ///
    /// ```
    /// use std::cell::Cell;
    /// use slipmode_core::dynamics::{Kick, Model};
    /// use slipmode_core::friction::{EvolutionLaw, Groups};
    ///
    /// // K is 0.3 % above K_c.
    /// let groups = Groups { inertial_parameter: 0.025, stiffness_group: 1.003 * 0.5125, effect_ratio: 1.5 };
    /// let [aging, slip] = [EvolutionLaw::Aging, EvolutionLaw::Slip]
    ///     .map(|law| Kick::StressUp.smallest(&Model::new(groups.clone(), law), &Cell::new(0.0)).unwrap());
    /// let [decays, leaves] = aging.unwrap();
    /// assert!(decays < leaves && leaves < 1.000_001 * decays);
    /// assert_eq!(slip, None);
    /// ```
    ///
    /// # Errors
    /// Those of the integrator, and [`Failure::Undecided`] when a run neither decays nor leaves, or K is too close to K_c.
    pub fn smallest(self, model: &Model<f64>, decayed: &Cell<f64>) -> Result<Option<[f64; 2]>, Failure> {
        let decay = decay_of_small_deviations(model)?;
        if decay < LEAST_DECAY {
            return Err(Failure::Undecided { cycles: RETURNS, change: decay });
        }
        let leaves = |size: f64| leaves(model, self.state(model, size), decayed);
        let decades = libm::log10(self.largest() / SMALLEST);
        let steps = (SIZES_PER_DECADE * decades).ceil() as u32;
        let mut decays = 0.0f64;
        for step in 0..=steps {
            let size = SMALLEST * libm::pow(10.0, decades * f64::from(step) / f64::from(steps));
            if leaves(size)? {
                let width = WIDTH * decays.max(WIDTH * size);
                let [low, high] = border(leaves, (decays, size), width)?;
                let error = NOISE / decay;
                return Ok(Some([low * (1.0 - error), high * (1.0 + error)]));
            }
            decays = size;
        }
        Ok(None)
    }
}

/// The part by which a small deviation shrinks in one return; infinity when it does not oscillate.
fn decay_of_small_deviations(model: &Model<f64>) -> Result<f64, Failure> {
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), [0.0, 0.0, LINEAR], CONTROL)?;
    let mut stresses = [LINEAR; 2];
    for _ in 0..RETURNS {
        let (orbit, end) = return_above(&mut run, FAINT)?;
        if end == ReturnEnd::AtRest {
            return Ok(f64::INFINITY);
        }
        stresses = [stresses[1], orbit.end[2]];
    }
    Ok(1.0 - stresses[1] / stresses[0])
}

/// Whether a run does not return to steady sliding; `decayed` is that of [`Kick::smallest`].
fn leaves(model: &Model<f64>, start: State<f64>, decayed: &Cell<f64>) -> Result<bool, Failure> {
    let mut run = Integrator::new(model, Radau::<f64, 5>::new(), start, CONTROL)?;
    let mut history = History::new();
    let mut first_slow = None;
    for done in 1..=MOST_RETURNS {
        let (orbit, end) = return_above(&mut run, FAINT)?;
        if end == ReturnEnd::AtRest {
            return Ok(false);
        }
        let peak = orbit.peak;
        history.returns.push(orbit);
        // On a cycle; small deviations fall by more.
        if history.within(NOISE) {
            return Ok(true);
        }
        let (Some(here), Some((_, change))) = (history.back(0), history.slow_direction()) else { continue };
        if done < RETURNS || size(change) < NOISE * size(here) {
            continue;
        }
        if change[1] > 0.0 {
            return Ok(true);
        }
        let first = *first_slow.get_or_insert(here[1]);
        if peak < SMALL || here[1] <= decayed.get() {
            decayed.set(decayed.get().max(first));
            return Ok(false);
        }
    }
    let change = history.change(1).unwrap_or(f64::INFINITY);
    Err(Failure::Undecided { cycles: MOST_RETURNS, change })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::cycle_family::CLOSED;
    use crate::dynamics::{CycleFamily, LongTerm, Options, simulate_model};
    use crate::friction::{EvolutionLaw, Groups, critical_stiffness_group};

    const ETA: f64 = 0.025;
    const BETA: f64 = 1.5;

    fn model(law: EvolutionLaw, excess: f64) -> Model<f64> {
        let stiffness_group = (1.0 + excess) * critical_stiffness_group(&BETA, &ETA);
        Model::new(Groups { inertial_parameter: ETA, stiffness_group, effect_ratio: BETA }, law)
    }

    /// ln(V_peak/V_l) of the unstable cycle, by Newton's method on the return map.
    fn unstable_peak(model: &Model<f64>) -> f64 {
        let family = CycleFamily {
            law: model.law(),
            inertial_parameter: ETA,
            effect_ratio: BETA,
            local_tolerance: 1e-8,
        };
        let imbalance = 0.05 * (BETA - 1.0).sqrt() * ETA;
        let critical = critical_stiffness_group(&BETA, &ETA);
        let first = family.member(imbalance * (1.0 + ETA) / ETA, [imbalance, critical]).unwrap();
        let members = family.follow(first, 1.1, |member| member.stiffness_group > critical);
        let unstable = family.at(&members, model.groups().stiffness_group).next().unwrap().unwrap();
        assert!(family.leading_multiplier(&unstable).unwrap() > 1.0);
        unstable.orbit.peak
    }

    #[test]
    fn a_kick_at_the_threshold_ends_on_the_unstable_cycle() {
        let excess = 0.003;
        let model = model(EvolutionLaw::Aging, excess);
        let unstable = unstable_peak(&model);
        // The member has its stiffness to a part of CLOSED, and its peak is as the root of K/K_c - 1.
        let error = CLOSED / excess;
        for kick in [Kick::VelocityUp, Kick::StressUp, Kick::StressDown] {
            let ends = kick.smallest(&model, &Cell::new(0.0)).unwrap().unwrap();
            // In one dimension the fixed point stays between the two runs.
            let [inside, outside] = ends.map(|size| kick.late_peak(&model, size).unwrap());
            assert!(
                inside - error < unstable && unstable < outside + error,
                "{kick:?} {inside} {unstable} {outside}"
            );
            // The kicks differ by a part of 1e-6 of a number of order 1.
            assert!(outside - inside < 1e-5, "{kick:?} {inside} {outside}");
        }
    }

    #[test]
    fn close_to_the_critical_stiffness_the_smallest_kick_is_as_the_root_of_the_excess() {
        // What is even in the kick cancels in the mean of both signs, and the next term is a part of order K/K_c - 1.
        let mean = |excess: f64| {
            let model = model(EvolutionLaw::Aging, excess);
            let [up, down] = [Kick::StressUp, Kick::StressDown]
                .map(|kick| kick.smallest(&model, &Cell::new(0.0)).unwrap().unwrap());
            let (low, high) = (up[0] + down[0], up[1] + down[1]);
            (0.5 * (low + high), (high - low) / (high + low))
        };
        let ((near, near_error), (far, far_error)) = (mean(1e-8), mean(1e-7));
        let deviation = far / near / 10.0_f64.sqrt() - 1.0;
        assert!(deviation.abs() <= near_error + far_error, "{deviation:e} {near_error:e} {far_error:e}");
        assert!(near_error < 1e-4);
    }

    #[test]
    fn simulations_on_either_side_end_as_the_threshold_says() {
        for excess in [0.001, 0.003, 0.005] {
            let model = model(EvolutionLaw::Aging, excess);
            let ends = Kick::VelocityUp.smallest(&model, &Cell::new(0.0)).unwrap().unwrap();
            let is_cycle = |size: f64| {
                let options = Options {
                    velocity_ratio: libm::exp(size),
                    start: Start::VelocityKick,
                    ..Options::at(1e-6)
                };
                matches!(simulate_model(&model, &options).unwrap().long_term(), LongTerm::Cycle(_))
            };
            let found = [0.999 * ends[0], 1.001 * ends[1]].map(is_cycle);
            assert_eq!(found, [false, true], "{excess}");
        }
    }

    #[test]
    fn no_kick_leaves_with_the_slip_law_or_beyond_the_edge_of_bistability() {
        // The edge is at K/K_c = 1.0059.
        let sliders =
            [(EvolutionLaw::Slip, 0.0003), (EvolutionLaw::Slip, 0.003), (EvolutionLaw::Aging, 0.0062)];
        for (law, excess) in sliders {
            for kick in Kick::ALL {
                assert_eq!(
                    kick.smallest(&model(law, excess), &Cell::new(0.0)),
                    Ok(None),
                    "{law:?} {excess} {kick:?}"
                );
            }
        }
    }
}
