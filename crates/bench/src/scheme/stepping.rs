//! The fixed-step scheme of the original simulations, as a comparator: what its step does to the figures.
//!
//! Friction is frozen at its end-of-step value; the mass on the spring then moves by the exact harmonic solution; the velocity of the
//! step is the displacement over the step; Newton closes the loop on that velocity. The state follows the evolution law exactly for
//! that constant velocity. First order in the step; the public solver advises a step below √(M/K)/10.
//!
//! In the units of [`Model`] the spring–mass equation is η u' = ζ − φ with ζ' = κ(1 − u), u = V/V_l, natural frequency √(κ/η).

use slipmode_core::dynamics::{Failure, Model, State};
use slipmode_core::friction::EvolutionLaw;

/// A run of the scheme in progress.
#[derive(Debug, Clone)]
pub struct OriginalScheme<'m> {
    model: &'m Model<f64>,
    step: f64,
    /// Cosine of ω_n·step, 1 − cosine, and sine over ω_n.
    cosine: f64,
    versine: f64,
    sine_over_frequency: f64,
    /// Velocity at the end of the step, V/V_l: it may have either sign.
    velocity: f64,
    /// ln of the mean velocity over the last step.
    log_mean_velocity: f64,
    log_state: f64,
    stress: f64,
    iterations: u64,
}

/// Newton iterations on the velocity of a step.
const MOST_ITERATIONS: usize = 200;

impl<'m> OriginalScheme<'m> {
    /// Begins at a state with steps of `fraction`·√(M/K).
    #[must_use]
    pub fn new(model: &'m Model<f64>, [x, y, zeta]: State<f64>, fraction: f64) -> Self {
        let groups = model.groups();
        let frequency = groups.natural_angular_frequency_squared().sqrt();
        let (sine, cosine) = libm::sincos(fraction);
        let half = libm::sin(0.5 * fraction);
        Self {
            model,
            step: fraction / frequency,
            cosine,
            versine: 2.0 * half * half,
            sine_over_frequency: sine / frequency,
            velocity: libm::exp(x),
            log_mean_velocity: x,
            log_state: y,
            stress: zeta,
            iterations: 0,
        }
    }

    /// The step in D_c/V_l.
    #[must_use]
    pub const fn step(&self) -> f64 {
        self.step
    }

    /// ln of the mean velocity of the last step over V_l: the scheme's velocity.
    #[must_use]
    pub const fn log_velocity(&self) -> f64 {
        self.log_mean_velocity
    }

    /// Newton iterations so far: each evaluates friction and state once.
    #[must_use]
    pub const fn iterations(&self) -> u64 {
        self.iterations
    }

    /// y at the end of a step at constant velocity e^x: the exact solution of either law.
    fn state_after(&self, x: f64) -> (f64, f64) {
        let travel = self.step * libm::exp(x);
        let decay = libm::exp(-travel);
        match self.model.law() {
            EvolutionLaw::Slip => {
                // x + y shrinks by e^{−travel}.
                let y = (x + self.log_state) * decay - x;
                (y, decay - (x + self.log_state) * decay * travel - 1.0)
            }
            EvolutionLaw::Aging => {
                // θ = e^{−x} + (θ0 − e^{−x}) e^{−travel}.
                let rest = libm::exp(-x);
                let start = libm::exp(self.log_state);
                let theta = start * decay - rest * libm::expm1(-travel);
                let slope = rest * libm::expm1(-travel) + (1.0 - start / rest) * decay * travel * rest;
                (libm::log(theta), slope / theta)
            }
        }
    }

    /// Mean velocity of the step when friction is held at φ, and the size of its largest term.
    fn mean_velocity(&self, friction: f64) -> (f64, f64) {
        // The spring's stretch relative to its equilibrium under φ oscillates about the loading.
        let excess = (self.stress - friction) / self.model.groups().stiffness_group;
        let [spring, inertia] = [excess * self.versine, (self.velocity - 1.0) * self.sine_over_frequency];
        let largest = spring.abs().max(inertia.abs()).max(self.step);
        ((self.step + spring + inertia) / self.step, largest / self.step)
    }

    /// Takes one step.
    ///
    /// # Errors
    /// [`Failure::StepVanished`] when Newton's iteration on the velocity does not converge.
    pub fn advance(&mut self) -> Result<(), Failure> {
        let groups = self.model.groups();
        let slope_of_mean = -self.versine / (groups.stiffness_group * self.step);
        let friction = |x: f64, y: f64| x + groups.effect_ratio * y;
        let mut x = self.log_mean_velocity;
        for _ in 0..MOST_ITERATIONS {
            let (y, y_slope) = self.state_after(x);
            let velocity = libm::exp(x);
            let (mean, largest) = self.mean_velocity(friction(x, y));
            let defect = velocity - mean;
            self.iterations += 1;
            let slope = velocity - slope_of_mean * (1.0 + groups.effect_ratio * y_slope);
            // In the logarithm the defect is convex one way and flat the other: long steps are cut.
            let update = (-defect / slope).clamp(-2.0, 2.0);
            x += update;
            // Where the mass all but stops its velocity is a difference of larger terms, and no update can beat their rounding.
            let rounded = defect.abs() < 4.0 * f64::EPSILON * largest;
            if rounded || update.abs() < 1e-13 * x.abs().max(1.0) {
                self.finish(x);
                return Ok(());
            }
        }
        Err(Failure::StepVanished { tolerance: 1e-13, time: self.step, log_velocity: x })
    }

    fn finish(&mut self, x: f64) {
        let groups = self.model.groups();
        let (y, _) = self.state_after(x);
        let friction = x + groups.effect_ratio * y;
        let excess = (self.stress - friction) / groups.stiffness_group;
        let frequency_squared = groups.natural_angular_frequency_squared();
        self.velocity =
            1.0 + (self.velocity - 1.0) * self.cosine + excess * frequency_squared * self.sine_over_frequency;
        self.stress += groups.stiffness_group * self.step * (1.0 - libm::exp(x));
        self.log_state = y;
        self.log_mean_velocity = x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::dynamics::{Options, Start, simulate_model};
    use slipmode_core::friction::Groups;

    /// Harmonic vibration: σ = 10^4.5 Pa, V_l = 10^-2 m/s with the paper's values.
    fn vibration(law: EvolutionLaw) -> Model<f64> {
        let groups = Groups { inertial_parameter: 79.06, stiffness_group: 0.7906, effect_ratio: 1.5 };
        Model::new(groups, law)
    }

    /// The highest ln(V/V_l) between two times from now, in D_c/V_l: the scheme's long-term peak when both are late.
    fn highest_velocity(scheme: &mut OriginalScheme<'_>, from: f64, to: f64) -> f64 {
        let [first, last] = [from, to].map(|time| libm::ceil(time / scheme.step));
        let mut highest = f64::NEG_INFINITY;
        for step in 0..last as u64 {
            scheme.advance().unwrap();
            if step as f64 >= first {
                highest = highest.max(scheme.log_mean_velocity);
            }
        }
        highest
    }

    fn bias(law: EvolutionLaw, fraction: f64) -> f64 {
        let model = vibration(law);
        let exact = simulate_model(&model, &Options::default()).unwrap().log_peak();
        let mut scheme = OriginalScheme::new(&model, Start::default().at_a_tenth(&model), fraction);
        libm::expm1(highest_velocity(&mut scheme, 6000.0, 6400.0) - exact)
    }

    #[test]
    fn the_long_term_peak_converges_at_first_order() {
        for law in EvolutionLaw::ALL {
            let errors = [0.04, 0.02, 0.01].map(|fraction| bias(law, fraction));
            for pair in errors.windows(2) {
                let ratio = pair[0] / pair[1];
                assert!((1.6..2.6).contains(&ratio), "{law:?}: {errors:?}");
            }
        }
    }

    #[test]
    fn steady_sliding_stays_steady() {
        let model = vibration(EvolutionLaw::Slip);
        let mut scheme = OriginalScheme::new(&model, [0.0; 3], 0.1);
        assert_eq!(highest_velocity(&mut scheme, 0.0, 1000.0).abs(), 0.0);
    }
}
