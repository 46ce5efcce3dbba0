//! Adaptive steps over any one-step method, with a clock that starts anew at every event.
//!
//! The equations do not contain the time, so a step of 1e-60 after a stick phase of length 1 is as good as any other:
//! only the clock, which is a compensated sum local to the cycle, ever adds the two.

use super::arrest::{Arrest, arrest};
use super::clock::Clock;
use super::stepper::{Stepper, Trial, Weight, increment};
use super::{Failure, Model, Scalar, State};

/// The tightest local tolerance, in units of the arithmetic's rounding error.
const TIGHTEST_IN_UNITS: f64 = 64.0;

/// The tightest local tolerance of a state of this size.
pub(super) fn tightest<R: Scalar>(size: f64) -> f64 {
    TIGHTEST_IN_UNITS * R::UNIT_ROUNDOFF * size
}

/// The most by which a step may exceed the one before: where nothing happens any more it grows to the next time scale quickly.
const LARGEST_GROWTH: f64 = 8.0;

/// What an integration may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Control {
    /// Permitted local error of x, y, ζ; relative to the state's size where that is below 1.
    pub local_tolerance: f64,
    /// Most accepted and refused steps of one run.
    pub most_steps: u64,
}

/// What runs cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Work {
    /// Accepted and refused steps.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.steps += other.steps;
        self.evaluations += other.evaluations;
    }
}

/// A run in progress.
#[derive(Debug, Clone)]
pub struct Integrator<'m, R, M> {
    pub(super) model: &'m Model<R>,
    method: M,
    pub(super) control: Control,
    state: State<R>,
    /// Where the last accepted step began, and its length.
    pub(super) step_start: State<R>,
    step: R,
    proposal: R,
    last_error: f64,
    /// How far the next step may exceed the proposal, where the method foresees its length.
    reach: f64,
    clock: Clock<R>,
    steps: u64,
    refused: u64,
}

impl<'m, R: Scalar, M: Stepper<R>> Integrator<'m, R, M> {
    /// Begins a run.
    ///
    /// # Errors
    /// When the start is not finite.
    pub fn new(model: &'m Model<R>, method: M, start: State<R>, control: Control) -> Result<Self, Failure> {
        let positive = |value: &R| value.is_finite() && *value > R::from(0);
        let groups = model.groups();
        let admissible = positive(&groups.inertial_parameter)
            && positive(&model.inverse_inertia)
            && positive(&groups.stiffness_group)
            && positive(&groups.effect_ratio);
        if !admissible || !start.iter().all(Scalar::is_finite) {
            return Err(Failure::InvalidStart);
        }
        let proposal = first_step(model, &start, control);
        Ok(Self {
            model,
            method,
            control,
            step_start: start.clone(),
            state: start,
            step: R::from(0),
            proposal,
            last_error: 1.0,
            reach: LARGEST_GROWTH,
            clock: Clock::zero(),
            steps: 0,
            refused: 0,
        })
    }

    /// The current state.
    #[must_use]
    pub const fn state(&self) -> &State<R> {
        &self.state
    }

    /// The state at this part of the last step, from its polynomial.
    #[must_use]
    pub fn state_within(&self, part: &R) -> State<R> {
        let moved = increment(self.method.polynomial(), part);
        std::array::from_fn(|i| self.step_start[i].clone() + &moved[i])
    }

    /// The length of the last step.
    #[must_use]
    pub const fn step(&self) -> &R {
        &self.step
    }

    /// The time since the run or the cycle began, in D_c/V_l.
    #[must_use]
    pub fn time(&self) -> R {
        self.clock.elapsed()
    }

    /// The method, for its step polynomial and its count of evaluations.
    #[must_use]
    pub const fn method(&self) -> &M {
        &self.method
    }

    /// Steps accepted and steps refused so far.
    #[must_use]
    pub const fn step_counts(&self) -> (u64, u64) {
        (self.steps, self.refused)
    }

    /// What the run cost so far.
    pub(super) fn work(&self) -> Work {
        Work { steps: self.steps + self.refused, evaluations: self.method.evaluations() }
    }

    /// Continues from another state, as a new cycle: clock at zero, a cautious first step.
    pub fn resume_from(&mut self, state: State<R>) {
        self.proposal = first_step(self.model, &state, self.control);
        self.step_start = state.clone();
        self.state = state;
        self.step = R::from(0);
        self.clock = Clock::zero();
        self.method.restart();
    }

    /// Continues from a state with another model: the clock and the proposed step stay.
    pub fn continue_with(&mut self, model: &'m Model<R>, state: State<R>) {
        self.model = model;
        self.state = state;
        self.method.restart();
    }

    /// Begins a new cycle at V = V_l, where the run stands up to rounding: x is 0, the clock is at zero.
    pub fn begin_cycle(&mut self) {
        self.state[0] = R::from(0);
        self.clock = Clock::zero();
    }

    /// Takes the last step back; the next one will be at most half as long.
    pub fn take_back(&mut self) {
        self.clock.advance(&-self.step.clone());
        self.proposal = self.step.clone() / R::from(2);
        self.reach = 1.0;
        self.state = self.step_start.clone();
        self.method.restart();
    }

    /// Takes a stop from where it becomes predictable to the slow motion after it, in one step without a polynomial; false when there is none.
    pub fn arrest(&mut self) -> bool {
        let permitted = self.weight(&self.state).absolute;
        let Some(Arrest { to, time, slow_rate }) = arrest(self.model, &self.state, permitted) else {
            return false;
        };
        self.steps += 1;
        self.clock.advance(&time);
        self.proposal = R::from_f64(libm::pow(permitted, 0.2) / slow_rate);
        self.step = time;
        self.step_start = std::mem::replace(&mut self.state, to);
        self.method.restart();
        true
    }

    /// How exact a step from this state must be.
    pub(crate) fn weight(&self, state: &State<R>) -> Weight {
        let [x, y, stress] = state.each_ref().map(Scalar::to_f64);
        let size = x.abs().max(y.abs()).max(stress.abs() / self.method.stress_unit());
        // Where the state is small the equations keep relative accuracy, and so must the steps.
        let scale = if size == 0.0 { 1.0 } else { size.min(1.0) };
        let noise = 2.0 * R::UNIT_ROUNDOFF * size.max(f64::MIN_POSITIVE);
        Weight { absolute: (self.control.local_tolerance * scale).max(tightest::<R>(size)), noise }
    }

    /// Takes one step no longer than `limit`.
    ///
    /// # Errors
    /// When the step size vanishes or the run's steps are used up.
    pub fn advance(&mut self, limit: Option<&R>) -> Result<(), Failure> {
        let weight = self.weight(&self.state);
        let foreseen = self.method.foresee(self.model, &self.state, weight);
        if let Some(length) = foreseen {
            self.proposal = R::from_f64(length.min(self.reach * self.proposal.to_f64()));
        }
        let smallest = R::UNIT_ROUNDOFF * R::UNIT_ROUNDOFF;
        let first_proposal = self.proposal.to_f64();
        loop {
            if self.steps + self.refused >= self.control.most_steps {
                return Err(Failure::TooManySteps { steps: self.steps, time: self.time().to_f64() });
            }
            let limited = limit.filter(|limit| **limit < self.proposal);
            let h = limited.unwrap_or(&self.proposal).clone();
            match self.method.attempt(self.model, &self.state, &h, weight) {
                Some(trial) if trial.error <= 1.0 => {
                    if foreseen.is_none() {
                        self.propose(trial.error, &h, limited.is_some());
                    }
                    self.take(trial, h);
                    return Ok(());
                }
                Some(trial) => self.shrink(&h, self.factor(trial.error).min(0.9)),
                None => self.shrink(&h, 0.3),
            }
            if self.proposal.to_f64() <= first_proposal * smallest
                || self.proposal.to_f64() < f64::MIN_POSITIVE
            {
                return Err(Failure::StepVanished {
                    tolerance: weight.absolute,
                    time: self.time().to_f64(),
                    log_velocity: self.state[0].to_f64(),
                });
            }
        }
    }

    fn take(&mut self, trial: Trial<R>, h: R) {
        self.steps += 1;
        self.reach = LARGEST_GROWTH;
        self.method.accept();
        self.clock.advance(&h);
        self.step = h;
        self.step_start = std::mem::replace(&mut self.state, trial.to);
    }

    /// Proposes the next step from the error of the one of length `h`.
    fn propose(&mut self, error: f64, h: &R, limited: bool) {
        let growth = self.growth(error, h);
        // A step cut short by its limit says nothing against the proposal it was cut from.
        if !limited || growth > 1.0 {
            let next = h.clone() * R::from_f64(growth);
            if !limited || next > self.proposal {
                self.proposal = next;
            }
        }
        self.last_error = error.max(1e-2);
    }

    fn shrink(&mut self, h: &R, factor: f64) {
        self.refused += 1;
        self.proposal = h.clone() * R::from_f64(factor);
    }

    /// The factor that would bring the error to its permitted size.
    fn factor(&self, error: f64) -> f64 {
        (0.9 / root(error.max(1e-30), M::ERROR_EXPONENT)).clamp(0.1, LARGEST_GROWTH)
    }

    /// Gustafsson's predictive factor, held back where the iteration was slow.
    fn growth(&self, error: f64, h: &R) -> f64 {
        let plain = self.factor(error);
        let last = self.step.to_f64();
        let ratio = if last > 0.0 { h.to_f64() / last } else { 1.0 };
        let predicted = plain * ratio * root(self.last_error / error.max(1e-10), M::ERROR_EXPONENT);
        // Slow convergence shortens the next step before it has to be refused.
        let patience = 1.6 - self.method.effort();
        let ceiling = if patience >= 1.0 { LARGEST_GROWTH } else { patience.max(0.6) };
        plain.min(predicted.max(0.2)).min(ceiling)
    }

    /// Repeats the last step with another length, from the same start; the run then stands at its end.
    ///
    /// Nothing when the method does not converge; the run is then unchanged.
    pub fn redo(&mut self, h: &R) -> Option<()> {
        let weight = self.weight(&self.step_start);
        self.method.rewind();
        let trial = self.method.attempt(self.model, &self.step_start, h, weight)?;
        self.clock.advance(&(h.clone() - &self.step));
        self.step = h.clone();
        self.state = trial.to;
        self.method.accept();
        Some(())
    }
}

/// A first step on which the state changes by little: its error is corrected by the control at once.
fn first_step<R: Scalar>(model: &Model<R>, start: &State<R>, control: Control) -> R {
    let rate = model.rate(start);
    let fastest = rate.iter().fold(0.0f64, |largest, r| largest.max(r.to_f64().abs()));
    let size = start.iter().fold(0.0f64, |size, c| size.max(c.to_f64().abs())).clamp(1e-300, 1.0);
    let cautious = libm::pow(control.local_tolerance, 0.2);
    let step = if fastest > 0.0 { cautious * size / fastest } else { cautious };
    R::from_f64(step.clamp(1e-250, 1.0))
}

/// The n-th root; those of the methods in use without logarithms.
fn root(value: f64, n: u32) -> f64 {
    match n {
        4 => value.sqrt().sqrt(),
        6 => libm::cbrt(value).sqrt(),
        8 => value.sqrt().sqrt().sqrt(),
        _ => libm::pow(value, 1.0 / f64::from(n)),
    }
}
