//! The nonlinear slider in logarithms: x = ln(V/V_l), y = ln(V_l θ/D_c), ζ = (spring stress/σ − μ0)/a, time in D_c/V_l.
//!
//! ```text
//! x' = (ζ − φ(x, y)) e^{−x} / η      ζ' = κ (1 − e^x)      y' = −e^x (x + y)  or  e^{−y} − e^x
//! ```
//!
//! V_l is the velocity of the load point; where that changes, V_l is a reference and the 1 in ζ' its velocity over V_l.
//!
//! φ is the friction: x + βy for eq 1. Differences from 1 are formed by e^x − 1 directly, so that a perturbation of steady
//! sliding keeps its digits however small it is, and steady sliding itself is a fixed point without any rounding.

use super::{Arrow, Scalar};
use crate::friction::{EvolutionLaw, Groups};
use crate::number::{Dd, Rational};

/// A point of the trajectory: [x, y, ζ].
pub type State<R> = [R; 3];

/// What balances what in the equation of motion.
#[derive(Debug, Clone, PartialEq)]
pub enum Balance<R> {
    /// Inertia, spring and the friction of eq 1.
    Inertial,
    /// Inertia, spring and the regularised friction a·asinh(V/(2 V_l)·exp((μ0 + b ln(V_l θ/D_c))/a)); holds μ0/a.
    Regularised(R),
}

impl<R> Balance<R> {
    /// The same balance in another number type.
    pub(crate) fn map<S>(&self, convert: impl FnOnce(&R) -> S) -> Balance<S> {
        match self {
            Self::Inertial => Balance::Inertial,
            Self::Regularised(reference) => Balance::Regularised(convert(reference)),
        }
    }
}

/// The slider's equations of motion.
///
/// ```
/// use slipmode_core::dynamics::Model;
/// use slipmode_core::friction::{EvolutionLaw, Groups};
///
/// let groups = Groups { inertial_parameter: 0.5, stiffness_group: 2.0, effect_ratio: 1.5 };
/// let model = Model::new(groups, EvolutionLaw::Aging);
/// assert_eq!(model.rate(&[0.0; 3]).map(f64::abs), [0.0; 3]); // steady sliding does not move
/// ```
#[derive(Debug, Clone)]
pub struct Model<R> {
    groups: Groups<R>,
    law: EvolutionLaw,
    pub(super) balance: Balance<R>,
    pub(super) inverse_inertia: R,
    /// What the regularised friction of steady sliding at V_l exceeds μ0 by, in units of a; ζ and φ are counted from there.
    steady_excess: R,
    /// What the velocity of the load point exceeds V_l by, in units of V_l.
    loading_excess: R,
}

/// Where e^{−x} stops growing. Down there V/V_l is below 1e-286 and x is slaved to ζ − βy: it lags by η e^x x', which is no more
/// than 1e-280 η x' with the bound in place of e^x, so that the bound changes no digit and keeps the rate from overflowing.
const SLOWEST: f64 = 1e-286;

/// The largest e^x and e^{−y} of a slider at rest, where y' is their plain difference; beside steady sliding, that of their excesses over 1.
const AT_REST: f64 = 1e-6;

/// The exponentials of one state, computed once for rate and Jacobian.
struct Exponentials<R> {
    velocity: R,
    velocity_excess: R,
    /// e^{−y} and e^{−y} − 1, zero when the law does not need them.
    healing: R,
    healing_excess: R,
}

impl Model<f64> {
    /// The same slider in double-double, from the groups that its own are rounded from.
    pub(super) fn in_double_double(&self, exact: &Groups<Rational>) -> Model<Dd> {
        let balance = self.balance.map(|value| Dd::from(*value));
        Model::with_balance(exact.map(Dd::from_rational), self.law, balance)
    }

    /// √(κη): how far an oscillation at √(K/M) moves ζ, over how far it moves ln V.
    pub(super) fn stress_swing(&self) -> f64 {
        (self.groups.stiffness_group * self.groups.inertial_parameter).sqrt()
    }
}

impl<R: Scalar> Model<R> {
    /// The slider with inertia and eq 1.
    #[must_use]
    pub fn new(groups: Groups<R>, law: EvolutionLaw) -> Self {
        Self::with_balance(groups, law, Balance::Inertial)
    }

    /// The slider with a chosen balance of forces.
    pub(crate) fn with_balance(groups: Groups<R>, law: EvolutionLaw, balance: Balance<R>) -> Self {
        let inverse_inertia = R::from(1) / &groups.inertial_parameter;
        let steady_excess = match &balance {
            Balance::Regularised(reference) => regularised_friction(&R::from(0), reference).0,
            Balance::Inertial => R::from(0),
        };
        Self { groups, law, balance, inverse_inertia, steady_excess, loading_excess: R::from(0) }
    }

    /// The same slider while its load point moves at another velocity than the V_l that it is counted in, in units of V_l.
    pub(crate) fn loaded_at(mut self, velocity_ratio: R) -> Self {
        self.loading_excess = velocity_ratio - R::from(1);
        self
    }

    /// η, κ and β.
    #[must_use]
    pub const fn groups(&self) -> &Groups<R> {
        &self.groups
    }

    /// The evolution law.
    #[must_use]
    pub const fn law(&self) -> EvolutionLaw {
        self.law
    }

    #[inline(always)]
    fn inverse_momentum(&self, velocity: &R) -> R {
        let floor = R::from_f64(SLOWEST);
        self.inverse_inertia.clone() / if *velocity < floor { &floor } else { velocity }
    }

    #[inline(always)]
    fn exponentials(&self, [x, y, _]: &State<R>) -> Exponentials<R> {
        let (velocity, velocity_excess) = x.exponentials();
        let (healing, healing_excess) = match self.law {
            EvolutionLaw::Slip => (R::from(0), R::from(0)),
            EvolutionLaw::Aging => (-y.clone()).exponentials(),
        };
        Exponentials { velocity, velocity_excess, healing, healing_excess }
    }

    /// The friction φ = (μ − μ0)/a; for the regularised law relative to that of steady sliding at V_l.
    #[inline(always)]
    pub(crate) fn friction(&self, state: &State<R>) -> R {
        let logarithmic = state[0].clone() + self.groups.effect_ratio.clone() * &state[1];
        match &self.balance {
            Balance::Regularised(reference) => {
                regularised_friction(&logarithmic, reference).0 - &self.steady_excess
            }
            Balance::Inertial => logarithmic,
        }
    }

    /// ζ − φ: spring stress not balanced by friction, in units of aσ.
    #[inline(always)]
    pub(crate) fn imbalance(&self, state: &State<R>) -> R {
        state[2].clone() - self.friction(state)
    }

    /// The time derivative of the state.
    #[must_use]
    #[inline(always)]
    pub fn rate(&self, state: &State<R>) -> State<R> {
        self.rate_and_stiffness(state).0
    }

    /// The same with the stiffness ∂x'/∂ζ = e^{−x}/η of the balance of forces.
    #[inline(always)]
    pub(crate) fn rate_and_stiffness(&self, state: &State<R>) -> (State<R>, R) {
        let e = self.exponentials(state);
        let state_rate = match self.law {
            EvolutionLaw::Slip => -(e.velocity.clone() * (state[0].clone() + &state[1])),
            // At rest the excesses are near −1 and would cancel: y' = e^{−y} is far below their rounding.
            EvolutionLaw::Aging if e.healing < R::from_f64(AT_REST) && e.velocity < R::from_f64(AT_REST) => {
                e.healing.clone() - &e.velocity
            }
            EvolutionLaw::Aging => e.healing_excess.clone() - &e.velocity_excess,
        };
        let excess = self.loading_excess.clone() - &e.velocity_excess;
        let stress_rate = self.groups.stiffness_group.clone() * excess;
        let stiffness = self.inverse_momentum(&e.velocity);
        ([self.imbalance(state) * &stiffness, state_rate, stress_rate], stiffness)
    }

    /// The derivative of the rate by the state.
    #[must_use]
    #[inline(always)]
    pub fn jacobian(&self, state: &State<R>) -> Arrow<R> {
        let e = self.exponentials(state);
        let beta = &self.groups.effect_ratio;
        let (yx, yy) = match self.law {
            EvolutionLaw::Slip => {
                (-(e.velocity.clone() * (state[0].clone() + &state[1] + R::from(1))), -e.velocity.clone())
            }
            EvolutionLaw::Aging => (-e.velocity.clone(), -e.healing.clone()),
        };
        let zx = -(self.groups.stiffness_group.clone() * &e.velocity);
        let logarithmic = state[0].clone() + beta.clone() * &state[1];
        let slope = match &self.balance {
            Balance::Regularised(reference) => regularised_friction(&logarithmic, reference).1,
            Balance::Inertial => R::from(1),
        };
        let xz = self.inverse_momentum(&e.velocity);
        let xx = -(xz.clone() * (slope.clone() + self.imbalance(state)));
        Arrow { xx, xy: -(xz.clone() * beta * slope), xz, yx, yy, zx }
    }
}

/// The regularised friction asinh(e^{m+s}/2) − m and its slope by s, where s = x + βy and m = μ0/a.
///
/// For m + s ≫ 1 it is s + ln((1 + √(1 + 4e^{−2(m+s)}))/2), which does not cancel; below, asinh is the logarithm itself.
fn regularised_friction<R: Scalar>(logarithmic: &R, reference: &R) -> (R, R) {
    let exponent = reference.clone() + logarithmic;
    let one = R::from(1);
    if exponent > R::from(1) {
        let (tail, _) = (-(exponent + logarithmic + reference)).exponentials();
        let root = (one.clone() + R::from(4) * tail).sqrt();
        let correction = ((one.clone() + &root) / R::from(2)).logarithm();
        return (logarithmic.clone() + correction, one / root);
    }
    let (exponential, _) = exponent.exponentials();
    let argument = exponential / R::from(2);
    let root = (one + argument.square()).sqrt();
    // For a vanishing argument asinh(z) = z − z³/6; the logarithm would lose it, and nothing physical happens there.
    let inverse_sine = (argument.clone() + &root).logarithm();
    (inverse_sine - reference, argument / root)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn model(law: EvolutionLaw, balance: Balance<f64>) -> Model<f64> {
        let groups = Groups { inertial_parameter: 0.7, stiffness_group: 0.4, effect_ratio: 1.5 };
        Model::with_balance(groups, law, balance)
    }

    #[test]
    fn steady_sliding_does_not_move_by_a_single_bit() {
        for law in EvolutionLaw::ALL {
            for balance in [Balance::Inertial, Balance::Regularised(150.0)] {
                assert_eq!(model(law, balance).rate(&[0.0; 3]).map(f64::abs), [0.0; 3]);
            }
        }
    }

    #[test]
    fn the_regularised_law_is_the_logarithm_to_the_square_of_its_exponential() {
        let (friction, slope) = regularised_friction(&0.25, &10.0);
        let tail = libm::exp(-20.5);
        assert!((friction - 0.25 - tail).abs() < 1e-15 && (slope - 1.0 + 2.0 * tail).abs() < 1e-15);
        let (at_rest, _) = regularised_friction(&-12.0, &10.0);
        assert!((at_rest + 10.0 - libm::asinh(libm::exp(-2.0) / 2.0)).abs() < 1e-14);
    }

    #[test]
    fn a_slider_at_rest_ages_by_its_own_rate_and_not_by_rounding_errors() {
        let [_, aging, _] = model(EvolutionLaw::Aging, Balance::Inertial).rate(&[-60.0, 40.0, 0.0]);
        let exact = libm::exp(-40.0) - libm::exp(-60.0);
        assert!((aging / exact - 1.0).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn the_jacobian_is_the_derivative_of_the_rate(
            state in prop::array::uniform3(-2.0f64..2.0), law in 0usize..2, which in 0usize..2
        ) {
            let balance = [Balance::Inertial, Balance::Regularised(1.5)][which].clone();
            let model = model(EvolutionLaw::ALL[law], balance);
            for column in 0..3 {
                // Central differences of step 1e-5 err by 1e-10 times the third derivative, below 1e3 here.
                let mut direction = [0.0; 3];
                direction[column] = 1e-5;
                let [low, high] = [-1.0, 1.0].map(|sign| model.rate(&std::array::from_fn(|i| state[i] + sign * direction[i])));
                let product = model.jacobian(&state).times(&direction);
                for i in 0..3 {
                    prop_assert!(((high[i] - low[i]) / 2.0 - product[i]).abs() < 1e-12 * (1.0 + high[i].abs()));
                }
            }
        }
    }
}
