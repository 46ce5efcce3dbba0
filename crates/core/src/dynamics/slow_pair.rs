//! Oscillations that grow or die by less in a return than runs in f64 resolve.
//!
//! What a return leaves of the amplitude is then lost in the errors of its steps, and so is the sign of K − K_c. The pair of small deviations is
//! taken from the roots of eq 8, of the parameters as they were given. Near K = K_c the normal form gives the rate of ln A, with A the amplitude
//! of ln(V/V_l), as growth rate + cubic A².

use super::decay::Oscillation;
use super::deviations::Modes;
use super::integrator::Work;
use super::{Balance, Model};
use crate::friction::Groups;
use crate::number::{Rational, nearest_f64};
use crate::roots::certified_roots;

/// The part of a small deviation that grows or dies in one period below which the search is not tried. Returns have relative errors of about 1e-12, and
/// the search takes differences of their changes.
const LOST_PART: f64 = 1e-7;

/// The swing of ζ over that of ln V from which on the rounding errors of ζ make those of returns larger, in proportion to it.
const LARGE_SWING: f64 = 1e3;

/// The largest such part for which anything but the search is tried.
const LARGEST_PART: f64 = 1e-3;

/// The largest |K/K_c − 1| at which the normal form gives cubic to better than the comparison with runs asks for.
const NEAREST: f64 = 1e-3;

/// Digits of the roots of eq 8: more than f64 has.
const DIGITS: u32 = 20;

/// How fast small deviations grow or die.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pace {
    /// Returns show it, or there is another friction law than eq 1.
    Fast,
    /// The search often resolves it.
    Slow,
    /// The search does not resolve it.
    Lost,
}

impl Pace {
    /// The pace of a pair next to the imaginary axis.
    pub fn of(model: &Model<f64>) -> Self {
        let part = growth_rate(model.groups()).abs() * std::f64::consts::TAU / frequency(model.groups());
        if model.balance != Balance::Inertial || part.is_nan() || part > LARGEST_PART {
            Self::Fast
        } else if part > LOST_PART * (model.stress_swing() / LARGE_SWING).max(1.0) {
            Self::Slow
        } else {
            Self::Lost
        }
    }
}

/// A pair of small deviations whose amplitude changes little in a period.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlowPair {
    pub modes: Modes,
    /// None far from K = K_c.
    pub near_transition: Option<NearTransition>,
}

/// The normal form near K = K_c.
#[derive(Debug, Clone, Copy)]
pub(super) struct NearTransition {
    /// K/K_c − 1.
    pub excess: f64,
    /// A²/(K/K_c − 1) of the small cycle, to leading order.
    pub square_amplitude: f64,
    /// The change of d ln A/dt with A².
    pub cubic: f64,
}

/// The relative difference that is permitted between the normal form and the rates of runs.
const AGREEMENT: f64 = 0.2;

impl NearTransition {
    /// Whether all small deviations return to steady sliding.
    pub fn attracts(&self) -> bool {
        self.excess >= 0.0 && self.cubic < 0.0
    }

    /// Whether the rates of ln A at two amplitudes are those of the normal form, the second by itself and both extrapolated to zero. Then smaller
    /// amplitudes go the same way, to zero or to the small cycle. Each pair is an amplitude and its rate.
    pub fn describes(&self, growth_rate: f64, wide: [f64; 2], here: [f64; 2]) -> bool {
        // What the normal form leaves is of order A⁴.
        let [there, here] = [wide, here].map(|[amplitude, rate]| {
            let square = amplitude * amplitude;
            (square, (rate - growth_rate) / square - self.cubic)
        });
        let at_zero = (here.1 * there.0 - there.1 * here.0) / (there.0 - here.0);
        // Two rates of one sign add up. Of a decay that a larger amplitude ends, the difference is what may not change its sign.
        let of_growth = growth_rate.min(0.0) / here.0;
        let permitted = AGREEMENT * (self.cubic + of_growth).abs();
        here.1.abs() < permitted && at_zero.abs() < permitted
    }
}

impl SlowPair {
    /// The pair, when the real mode dies faster.
    pub fn of(model: &Model<f64>, exact: &Groups<Rational>) -> Option<Self> {
        let roots = certified_roots(&exact.characteristic_cubic(), DIGITS).roots;
        let [real, _, pair] = roots.as_slice() else { return None };
        let oscillation =
            Oscillation { period: std::f64::consts::TAU / pair.im.to_f64(), growth_rate: pair.re.to_f64() };
        let modes = Modes { oscillation, real_rate: real.re.to_f64(), work: Work::default() };
        let is_led_by_pair = pair.im != 0 && modes.real_rate < oscillation.growth_rate.min(0.0);
        let near_transition = near_transition(model, exact);
        is_led_by_pair.then_some(Self { modes, near_transition })
    }
}

fn near_transition(model: &Model<f64>, exact: &Groups<Rational>) -> Option<NearTransition> {
    let critical = exact.critical_stiffness_group();
    if critical <= 0 {
        return None;
    }
    let excess = nearest_f64(&(exact.transition_margin() / critical));
    if excess.abs() > NEAREST {
        return None;
    }
    let Groups { inertial_parameter, effect_ratio, .. } = model.groups();
    // Infinite where the first Lyapunov coefficient vanishes.
    let [numerator, divisor] = model.law().square_amplitude(inertial_parameter, effect_ratio);
    let square_amplitude = numerator / divisor;
    // The rate of ln A vanishes on the small cycle.
    let critical =
        Groups { stiffness_group: model.groups().critical_stiffness_group(), ..model.groups().clone() };
    let cubic = -model.groups().critical_stiffness_group() * crossing_speed(&critical) / square_amplitude;
    Some(NearTransition { excess, square_amplitude, cubic })
}

/// The frequency of a pair next to the imaginary axis, in V_l/D_c.
fn frequency(groups: &Groups<f64>) -> f64 {
    (groups.stiffness_group / (1.0 + groups.inertial_parameter)).sqrt()
}

/// The change of its growth rate with κ − κ_c.
fn crossing_speed(groups: &Groups<f64>) -> f64 {
    let (sum, moving) = (1.0 + groups.inertial_parameter, groups.inertial_parameter * frequency(groups));
    -0.5 / (sum * sum + moving * moving)
}

/// Its growth rate, to first order in it.
fn growth_rate(groups: &Groups<f64>) -> f64 {
    groups.transition_margin() * crossing_speed(groups)
}
