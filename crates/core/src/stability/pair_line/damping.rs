//! The line of a damping ratio ζ = −Re(s)/|s|.
//!
//! With r = |p| the pair has x = −ζr and u = 1 − 2ζr + r², so that η and κ are rational functions of r. Where η > 0, κ and y² are positive,
//! too. η > 0 means that r² − 2ζr + 1 − β = (r − r₋)(r − r₊) has the sign of ζ:
//!
//! * ζ < 0, where oscillations grow: 0 < r < r₊, and β > 1;
//! * ζ > 0 and β ≥ 1: r > r₊;
//! * ζ > 0 and β < 1: 0 < r < r₋ and r > r₊, two curves, or one curve where the roots r₋ and r₊ are not real.
//!
//! With r → 0 the line tends to eq 18 times 1/|ζ|, with r → ∞ to eq 20 times 1/ζ. With r → r± V0 tends to 0, at κ = r²: at ζ = ±1 this is
//! eqs 15 and 16.

use rug::{Complete, Rational};

use crate::friction::Groups;
use crate::number::{Ball, Field, Real};
use crate::stability::Asymptote;
use crate::stability::boundary::log2;

/// Bits of a place that need not be certain.
const PLACING_BITS: u32 = 64;

/// The end of a curve with V0 → 0, if it has one, and log2 of the first and the last parameter of a sample.
pub(super) type Curve = (Option<Asymptote>, [f64; 2]);

/// A damping ratio of growing or decaying oscillations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DampingRatio(Rational);

impl DampingRatio {
    /// The ratio, or `None` unless −1 < ζ < 1 and ζ is not 0: at 0 the line is K = K_c, at ±1 the boundary of oscillation.
    #[must_use]
    pub fn new(ratio: Rational) -> Option<Self> {
        (ratio != 0 && *ratio.as_abs() < 1).then_some(Self(ratio))
    }

    /// ζ.
    #[must_use]
    pub const fn value(&self) -> &Rational {
        &self.0
    }

    /// ζ².
    pub(super) fn squared(&self) -> Rational {
        self.0.square_ref().complete()
    }

    /// Whether the line tends to eqs 20 and 18.
    pub(super) fn tends_to(&self, effect_ratio: &Rational) -> [bool; 2] {
        let decays = self.0 > 0;
        [decays, decays == (*effect_ratio < 1)]
    }

    /// The r = √κ at which V0 → 0, with the asymptote that it is at ζ = ±1. |ζ| + √(ζ² + β − 1) does not cancel; r₋ r₊ = 1 − β.
    pub(super) fn limits(&self, effect_ratio: &Rational, bits: u32) -> Vec<(Asymptote, Ball)> {
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let excess = Rational::from(effect_ratio - 1_u32);
        let square = self.squared() + &excess;
        if square < 0 {
            return Vec::new();
        }
        let large = ball(&self.0.clone().abs()) + ball(&square).sqrt();
        let small = ball(&excess.clone().abs()) / &large;
        let decays = self.0 > 0;
        let lower = decays.then_some((Asymptote::QuasiStaticLower, large));
        let upper = (excess != 0 && decays == (excess < 0)).then_some((Asymptote::QuasiStaticUpper, small));
        lower.into_iter().chain(upper).collect()
    }

    /// The curves of the line by their ends with V0 → 0, and log2 of the ends of their parameters at which the asymptotes are off by about
    /// this. Without such an end the parameter is r; else it is g, with r = r±(1 + g) outside of r± and r = r±/(1 + g) inside.
    ///
    /// The leading errors are ζβ/r and ζβr/(β − 1) at the inertial ends, and at r± at most g(2 + √D/(|ζ|β) + 2r√D/β) with D = ζ² + β − 1.
    pub(super) fn reach_log2(&self, effect_ratio: &Rational, end_error: f64) -> Vec<Curve> {
        let log2_of = |value: &Rational| log2(&Ball::from_rational(value, PLACING_BITS));
        let excess = Rational::from(effect_ratio - 1_u32);
        let (error, beta, zeta) =
            (libm::log2(end_error), log2_of(effect_ratio), log2_of(&self.0.clone().abs()));
        let far = (zeta + beta - error).max(0.5 * (beta - error));
        let near = || {
            let excess = log2_of(&excess.clone().abs());
            (error + excess - zeta - beta).min(0.5 * (error + excess))
        };
        let limits = self.limits(effect_ratio, PLACING_BITS);
        if limits.is_empty() {
            return if self.0 > 0 { vec![(None, [far, near()])] } else { Vec::new() };
        }
        let square = self.squared() + &excess;
        let root = if square > 0 { 0.5 * log2_of(&square) } else { f64::NEG_INFINITY };
        let curve = |(asymptote, modulus): (Asymptote, Ball)| {
            let modulus = log2(&modulus);
            let least = error - 1.0_f64.max(root - zeta - beta).max(1.0 + modulus + root - beta);
            let ends = match asymptote {
                Asymptote::QuasiStaticLower => [(far - modulus).max(-error), least],
                _ => [least, (modulus - near()).max(-error)],
            };
            (Some(asymptote), ends)
        };
        limits.into_iter().map(curve).collect()
    }

    /// x and u at a parameter of the curve with this end.
    pub(super) fn at(
        &self,
        end: Option<Asymptote>,
        parameter: &Ball,
        effect_ratio: &Rational,
        bits: u32,
    ) -> [Ball; 2] {
        let next = Ball::from(1) + parameter;
        let limit = self.limits(effect_ratio, bits).into_iter().find(|limit| Some(limit.0) == end);
        let modulus = match limit {
            None => parameter.clone(),
            Some((Asymptote::QuasiStaticLower, limit)) => limit * next,
            Some((_, limit)) => limit / next,
        };
        let x = -(Ball::from_rational(&self.0, bits) * &modulus);
        let u = x.clone().times_small(2) + Ball::from(1) + modulus.square();
        [x, u]
    }

    /// x of a point of the line: from the remainders of eq 8 at p² = −2ζrp − r², which are linear in r once r² is eliminated.
    ///
    /// The divisor over η² is q² + r² + 2(3ζ − 4ζ³)qr with the real root −q. It is positive.
    pub(super) fn real_part(&self, groups: &Groups<Ball>, bits: u32) -> Ball {
        let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } = groups;
        let share = Ball::from_rational(&(Rational::from(1) - self.squared() * 4_u32), bits);
        let [quadratic, linear] = [Ball::from(1) + eta, kappa.clone() + Ball::from(1) - beta];
        let dividend = eta.clone() * kappa * share.square() - quadratic.clone() * &linear;
        dividend / (eta.clone() * share * linear + quadratic.square()).times_small(2)
    }
}
