//! Motions that reach a plane shortly before or after now: the shift of a set across the flow, and the crossing of a section.
//!
//! A motion from z that meets the plane with normal n through c at Z has Z − z = τf, with its time τ and a mean f of its rates. As n·(Z − c) = 0,
//! Z − c = (I − f nᵀ/(n·f))(z − c). The derivative of Z by p is (I − f nᵀ/(n·f)) times that of the state at the fixed time τ, with the rates f at Z.

use crate::Reason;
use crate::interval::{Interval, generously_up};
use crate::linear::{Square, apply, unit};
use crate::manifold::{Manifold, Tube};

/// The largest t = ‖J‖τ. Below it e^t < 1.65.
const LARGEST_TURN: f64 = 0.5;

/// All motions of a set until they reach a plane, forward or backward.
#[derive(Debug)]
pub(super) struct ShortTime<const N: usize, T> {
    pub normal: [Interval; N],
    /// The longest time.
    pub time: f64,
    /// The states and their rates.
    pub during: [Interval; N],
    pub rates: [Interval; N],
    /// A number below the speed along the normal.
    pub slowest: f64,
    /// What else holds of these states.
    pub around: T,
}

/// A short time of the whole slider, with the derivative of its rates.
pub(super) type ShortMotion = ShortTime<3, Square<3>>;

/// A short time of a sticking slider, with the slow manifold and the tube around it.
pub(super) type ShortStick = ShortTime<2, (Manifold, Tube)>;

impl<const N: usize, T> ShortTime<N, T> {
    /// The motions from `hull`, which are at most `distance` away from the plane along its normal, in the unit of n·z.
    ///
    /// `over` gives the rates in a box, and what else holds there, for motions that stay in it for a time; `guess` holds rates to begin with.
    pub fn until_plane(
        hull: &[Interval; N],
        normal: [Interval; N],
        distance: f64,
        guess: &[Interval; N],
        over: impl FnOnce(&[Interval; N], f64) -> Result<([Interval; N], T), Reason>,
    ) -> Result<Self, Reason> {
        let time = generously_up(2.0 * distance / along(&normal, guess).mignitude());
        let during: [Interval; N] = std::array::from_fn(|i| {
            hull[i].widened(generously_up(2.0 * time * guess[i].magnitude() + 1e-300))
        });
        let (rates, around) = over(&during, time)?;
        let slowest = along(&normal, &rates).lower();
        let is_reached = slowest > 0.0 && generously_up(distance / slowest) < time;
        let is_held =
            (0..N).all(|i| hull[i].widened(generously_up(time * rates[i].magnitude())).is_inside(during[i]));
        if !(is_reached && is_held) {
            return Err(Reason::Tangent);
        }
        Ok(Self { normal, time, during, rates, slowest, around })
    }

    /// I − f nᵀ/(n·f), for all rates f.
    pub fn projection(&self) -> Square<N> {
        let (one, inverse) = (unit::<N>(), along(&self.normal, &self.rates).reciprocal());
        let removed = |i: usize, j: usize| self.rates[i] * self.normal[j] * inverse;
        std::array::from_fn(|i| std::array::from_fn(|j| one[i][j] - removed(i, j)))
    }

    /// By how much the derivative of the flow differs from I, if the rows of that of the rates sum to `slope` at most: e^t − 1 < 1.3 t below 0.5.
    pub fn turning(&self, slope: f64) -> Result<f64, Reason> {
        let turning = slope * self.time;
        if turning < LARGEST_TURN { Ok(generously_up(1.3 * turning)) } else { Err(Reason::Tangent) }
    }
}

/// n·v.
pub(super) fn along<const N: usize>(normal: &[Interval; N], v: &[Interval; N]) -> Interval {
    apply(&[*normal], v)[0]
}
