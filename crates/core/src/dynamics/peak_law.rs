//! The peak velocity of deep stick-slip by matched asymptotics, for a spring that is soft against friction: κ ≪ β − 1.
//!
//! Stresses are in units of (b − a)σ and velocities in units of V_18 = (b − a)σ/(2√(KM)). While the mass moves fast, friction is in steady
//! state but for a slip of order D_c, so that with A = V_peak/(2 V_18), v = V/V_peak, λ = V_l/V_peak and time in √(M/K)
//!
//! A dv/dt = Z + ln v,  dZ/dt = −A(v − λ),
//!
//! with Z the spring stress above the friction at V_peak. Slip begins at v = 0 and Z = Z_0. To second order in 1/A and first order in λ
//! Z_0 = A√(1 − 2λ) + 1 − ln 2 − λ(π/2 − 1) + (ln 2 − ½)/A, and the spring stress falls by 2A[√(1 − 2λ) + (ln 2 − ½)/A²].
//! The stress at which a stick ends follows from the state alone ([`PeakLaw::strength`]), and Z_0 equals it but for what the spring
//! loses while the state weakens ([`PeakLaw::weakening`]).

use core::f64::consts::{FRAC_PI_2, LN_2};

use crate::friction::EvolutionLaw;

/// A cycle of deep stick-slip without units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeepCycle {
    /// A = V_peak/(2 V_18) > 1.
    pub peak: f64,
    /// λ = V_l/V_peak < 1/2.
    pub loading: f64,
    /// κ = K D_c/(aσ).
    pub stiffness_group: f64,
}

/// Deep stick-slip: the largest κ/(β − 1) = K/K_c,qs, and the largest V_l over V_18.
pub const DEEP: f64 = 0.1;

/// The law of the peak velocity for one evolution law and one β = b/a > 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakLaw {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// β.
    pub effect_ratio: f64,
    /// C(β) of the slip law with its error estimate.
    nucleation: [f64; 2],
}

impl PeakLaw {
    /// The law at this β > 1.
    #[must_use]
    pub fn new(law: EvolutionLaw, effect_ratio: f64) -> Self {
        let nucleation = match law {
            EvolutionLaw::Slip => nucleation_constant(effect_ratio),
            EvolutionLaw::Aging => [0.0; 2],
        };
        Self { law, effect_ratio, nucleation }
    }

    /// c(β) of V_peak = 2 V_18 [ln(V_peak/V_l) + ln(1/κ) + c + …] with its error estimate. With the aging law the bracket also has
    /// β/(β − 1) times the logarithm of V_peak/V_18.
    #[must_use]
    pub fn constant(&self) -> [f64; 2] {
        let (beta, excess) = (self.effect_ratio, self.effect_ratio - 1.0);
        let [slip, error] = self.nucleation;
        match self.law {
            EvolutionLaw::Slip => [slip - 1.0 + LN_2, error],
            EvolutionLaw::Aging => {
                [(beta * libm::log(excess) - libm::log(beta)) / excess - 1.0 + LN_2, f64::EPSILON]
            }
        }
    }

    /// The power of the stick's duration in the strength: 0 with the slip law, and β/(β − 1) with the aging law, which heals.
    #[must_use]
    pub fn healing(&self) -> f64 {
        healing(self.law, self.effect_ratio)
    }

    /// The stress at which the stick ends, above the friction at V_peak.
    #[must_use]
    pub fn strength(&self, cycle: &DeepCycle) -> f64 {
        let (beta, excess) = (self.effect_ratio, self.effect_ratio - 1.0);
        let from_peak = -libm::log(cycle.loading * cycle.stiffness_group);
        match self.law {
            EvolutionLaw::Slip => from_peak + self.nucleation[0],
            EvolutionLaw::Aging => {
                // The stick lasts D/κ, D the stress drop over aσ; its next order contains the harmonic number of (β − 1)/β.
                let duration = 2.0 * excess * cycle.peak * (1.0 - 2.0 * cycle.loading).sqrt();
                let healed = beta * libm::log(duration) - libm::log(beta);
                from_peak + (healed - beta * harmonic(excess / beta) / duration) / excess
            }
        }
    }

    /// Strength less Z_0: what the formula of the peak leaves open.
    #[must_use]
    pub fn remainder(&self, cycle: &DeepCycle) -> f64 {
        let DeepCycle { peak, loading, .. } = *cycle;
        let start = peak * (1.0 - 2.0 * loading).sqrt() + (1.0 - LN_2) - loading * (FRAC_PI_2 - 1.0)
            + (LN_2 - 0.5) / peak;
        self.strength(cycle) - start
    }

    /// Bound of the remainder: what the spring loses while ln θ falls to its steady state, at most one D_c of slip per unit of it.
    #[must_use]
    pub fn weakening(&self, cycle: &DeepCycle) -> f64 {
        let excess = self.effect_ratio - 1.0;
        let healed = match self.law {
            EvolutionLaw::Slip => 0.0,
            EvolutionLaw::Aging => libm::log(2.0 * excess * cycle.peak),
        };
        cycle.stiffness_group * (healed - libm::log(cycle.loading * cycle.stiffness_group)) / excess
    }

    /// A for V_l/(2 V_18) and κ, if the spring loses this part of [`Self::weakening`] while the state weakens. None without such a peak.
    #[must_use]
    pub fn peak(&self, load: f64, stiffness_group: f64, part: f64) -> Option<f64> {
        /// Far above any peak, and far more steps than a search from there takes.
        const START: f64 = 300.0;
        const MOST_STEPS: usize = 100;
        let mut peak = START;
        for _ in 0..MOST_STEPS {
            let cycle = DeepCycle { peak, loading: load / peak, stiffness_group };
            let step = self.slope(peak) * (self.remainder(&cycle) - part * self.weakening(&cycle));
            peak += step;
            if peak.is_nan() || peak <= 1.0 + self.healing() || load >= 0.5 * peak {
                return None;
            }
            if step.abs() < 1e-13 * peak {
                return Some(peak);
            }
        }
        None
    }

    /// −dV_peak/d ln V_l in 2 V_18, without loading during the slip.
    #[must_use]
    pub fn slope(&self, peak: f64) -> f64 {
        1.0 / (1.0 - (1.0 + self.healing()) / peak)
    }
}

/// V_l/(2 V_18) where the peak is lowest, to first order in 1/A.
#[must_use]
pub fn least_loading(law: EvolutionLaw, effect_ratio: f64, peak: f64) -> f64 {
    1.0 + (healing(law, effect_ratio) - FRAC_PI_2) / peak
}

fn healing(law: EvolutionLaw, effect_ratio: f64) -> f64 {
    match law {
        EvolutionLaw::Slip => 0.0,
        EvolutionLaw::Aging => effect_ratio / (effect_ratio - 1.0),
    }
}

/// Stress drop over 2√(KM) V_peak.
#[must_use]
pub fn drop_over_impedance(cycle: &DeepCycle) -> f64 {
    (1.0 - 2.0 * cycle.loading).sqrt() + (LN_2 - 0.5) / (cycle.peak * cycle.peak)
}

/// The stress, in (b − a)σ and above ln(1/κ), at which a stick with the slip law ends, with its error estimate.
///
/// With q = κ V_l/V and T = (ζ + (β − 1) ln κ) the state obeys dq/dT = −q − T + (β − 1) ln q while the spring is loaded at a constant rate; the one
/// solution that came from rest reaches q = 0 at T = (β − 1) C. It is followed in ξ = −ln q with p = dξ/d(slip).
fn nucleation_constant(effect_ratio: f64) -> [f64; 2] {
    let excess = effect_ratio - 1.0;
    let first = AT_REST.max(4.0 * excess);
    let step = 0.005f64.min(0.5 / first);
    let [fine, coarse] = [step, 2.0 * step].map(|step| failure_stress(excess, first, step) / excess);
    [fine, (fine - coarse).abs()]
}

/// The least q at the start: solutions approach the one from rest as e^(−q), and its series in 1/q has three digits.
const AT_REST: f64 = 60.0;

/// Where ξ ends: the rest of T is below e^(−ξ).
const FAST: f64 = 40.0;

fn failure_stress(excess: f64, first: f64, step: f64) -> f64 {
    let p = 1.0 + excess / first + excess * (excess - 1.0) / (first * first);
    let rates = |xi: f64, [p, _]: [f64; 2]| {
        let q = libm::exp(-xi);
        [((1.0 - p) * q + excess * p) / p, q / p]
    };
    let mut xi = -libm::log(first);
    let mut state = [p, p - first + excess * libm::log(first)];
    while xi < FAST {
        state = runge_kutta(rates, xi, state, step);
        xi += step;
    }
    state[1]
}

/// One step of the classical method of order 4.
pub(super) fn runge_kutta<const N: usize>(
    rates: impl Fn(f64, [f64; N]) -> [f64; N],
    at: f64,
    state: [f64; N],
    step: f64,
) -> [f64; N] {
    let moved = |by: &[f64; N], part: f64| core::array::from_fn(|n| by[n].mul_add(part, state[n]));
    let first = rates(at, state);
    let second = rates(at + 0.5 * step, moved(&first, 0.5 * step));
    let third = rates(at + 0.5 * step, moved(&second, 0.5 * step));
    let fourth = rates(at + step, moved(&third, step));
    core::array::from_fn(|n| state[n] + step / 6.0 * (first[n] + 2.0 * (second[n] + third[n]) + fourth[n]))
}

/// The harmonic number of a real number of at least 0: the sum of 1/k − 1/(k + x).
fn harmonic(x: f64) -> f64 {
    let digamma = |z: f64| libm::log(z) - 0.5 / z - 1.0 / (12.0 * z * z) + 1.0 / (120.0 * libm::pow(z, 4.0));
    let head: f64 = (1..=30).map(|k| x / (f64::from(k) * (f64::from(k) + x))).sum();
    head + digamma(31.0 + x) - digamma(31.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Euler's constant.
    const GAMMA: f64 = 0.577_215_664_901_532_9;

    #[test]
    fn the_constant_of_the_slip_law_agrees_with_another_integration_and_its_limits() {
        // (β − 1) C by an explicit method of order 8 along the slip, from q = 200 with twelve terms of the series.
        let known = [(1.1, 0.9564378255382081), (1.5, 0.9621788176772113), (3.0, 2.133161342452681)];
        for (beta, stress) in known {
            let [constant, error] = nucleation_constant(beta);
            assert!(
                ((beta - 1.0) * constant - stress).abs() < 1e-9 && error < 1e-8,
                "{beta} {constant} {error:e}"
            );
        }
        // C = 1/(β − 1) − γ + O(β − 1); C = ln(β − 1) − 1 + z 2^(1/3) (β − 1)^(−2/3) + …, −z the first zero of Airy's function.
        let near = nucleation_constant(1.001)[0];
        assert!((near - 1000.0 + GAMMA).abs() < 2e-3, "{near}");
        let limit = 2.338_107_410 * libm::cbrt(2.0);
        let [far, farther] = [1e2, 1e3].map(|excess: f64| {
            let above = nucleation_constant(excess + 1.0)[0] - libm::log(excess) + 1.0;
            above * libm::pow(excess, 2.0 / 3.0) / limit
        });
        assert!(0.8 < far && far < farther && farther < 1.0, "{far} {farther}");
    }

    #[test]
    fn the_strength_of_the_aging_law_is_the_blow_up_of_its_state_under_constant_loading() {
        // With θ in D_c/(κ V_l) and time in the stress aσ, dθ/dT = 1 − B e^T θ^(1−β): for T = D at blow-up ln B + D is the healed strength.
        let beta = 1.5;
        for (log_b, most) in [(-10.0, 2e-2), (-40.0, 1e-3)] {
            let rates =
                |at: f64, [theta]: [f64; 1]| [1.0 - libm::exp(log_b + at) * libm::pow(theta, 1.0 - beta)];
            let (mut at, mut state) = (1.0, [1.0]);
            while state[0] > 1e-3 {
                let step = 1e-3 * (1.0f64).min(state[0] / rates(at, state)[0].abs());
                state = runge_kutta(rates, at, state, step);
                at += step;
            }
            let healed = beta * libm::log(at) - libm::log(beta) - beta * harmonic(0.5 / beta) / at;
            assert!((log_b + at - healed).abs() < most, "{at} {}", log_b + at - healed);
        }
    }

    #[test]
    fn start_and_drop_are_those_of_the_slip_itself() {
        // The fast slip integrated from the peak to both sides, in ln v so that v stays positive.
        let (peak, loading) = (20.0, 1e-3);
        let side = |sign: f64| {
            let rates = |_: f64, [log_v, z]: [f64; 2]| {
                [sign * (z + log_v / peak) * libm::exp(-log_v), -sign * (libm::exp(log_v) - loading)]
            };
            let mut state = [0.0, 0.0];
            while state[0] > -14.0 && (state[0] > -2.0 || state[0] + peak * state[1] > 1.0 || sign > 0.0) {
                let rate = rates(0.0, state)[0].abs() + libm::exp(-state[0]) / peak;
                state = runge_kutta(rates, 0.0, state, 1e-3f64.min(0.02 / rate));
            }
            peak * state[1]
        };
        let (start, end) = (side(-1.0), side(1.0));
        let cycle = DeepCycle { peak, loading, stiffness_group: 1e-3 };
        let law = PeakLaw::new(EvolutionLaw::Slip, 1.5);
        assert!((law.strength(&cycle) - law.remainder(&cycle) - start).abs() < 2e-3, "{start}");
        let drop = (start - end) / (2.0 * peak);
        assert!((drop_over_impedance(&cycle) - drop).abs() < 1e-5, "{drop}");
    }
}
