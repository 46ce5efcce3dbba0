//! How far an asymptote can be used for every slider of a box: each limit rises or falls with each parameter, so that two corners of
//! the box have the least and the greatest one.
//!
//! K, D_c and M act by their powers: V0 of eqs 15 and 16 is D_c √(K/M) times a function of β, σ of eqs 18 and 20 is K D_c/a times one.
//! For a and b let K = D_c = M = 1, u = √β, ε the relative error, and |s| = V0 w as in the proofs of `reports/im-avouac/proofs/monotone.toml`.
//!
//! **Eqs 15 and 16.** At the limit κ = (1 ∓ u)²/(1 + ε), and V0² is an extremum over w of a function φ(u, w): the greatest value for
//! eq 15, the least value next to the asymptote for eq 16. With e = u − 1 (eq 15) or e = −(u + 1) (eq 16) and w = |e| z,
//!
//! - φ = ((1 + ε)(e + 2 − z)/((1 + e z) z) − 1/z²)/e²,
//! - ∂φ/∂z has the sign of C = (1 + ε) P − 2ε (1 + e z)² with P = (z − 1)(e z² − 3e z − 2),
//! - ∂φ/∂u at fixed w has the sign of e (z − 1) for eq 15 and of 1 − z for eq 16.
//!
//! Eq 15 has C(0) > 0 and C(1) < 0. For b > a, C has one zero in 0 < z < 1, one in z > 1 and one in z < 0; behind the second zero φ rises
//! to 0, and φ > 0 at z = 1. For b < a, P < 0 for 1 < z < −1/e. So φ is greatest at a z < 1, and V0 falls with u > 1 and rises with u < 1.
//! Eq 16 has C = 0 at its least value, so P > 0, which in the domain z > 1/|e| needs z > 1. So V0 falls with u.
//!
//! **Eq 18.** With m = (1 − ε)(y + 1/y)/2 and d = |b − a|, σ at the limit is the least value over y with m < 1 of
//! 2y (a/d² ± m/d)/((1 − ε)(1 − m)), with + for b > a. At each y this rises with a and falls with b for b > a, and conversely for b < a.
//!
//! **Eq 20.** With m = (1 + ε)(y + 1/y)/2, σ at the limit is a local least value over y of 2y (m − 1)/((1 + ε)(b + a (m − 1))), which falls
//! with a and with b at each y.
//!
//! **Cusp.** Where the whole branch is good, the limit is the cusp: β = t³/(3t + 2), κ = (1 + t)³/(3t + 2), η/κ = 1/(1 + t)³ with t > 0.
//! So V0 falls with β, and σ = K D_c/(a κ) falls with a and b: the directions of eqs 16 and 20. The limit is continuous where one case ends.

use super::{enclosed, limit};
use crate::friction::Slider;
use crate::number::{Ball, Rational};
use crate::stability::{Arc, Asymptote, ParameterBox};

/// An asymptote and its limit over a box.
#[derive(Debug, Clone)]
pub struct LimitOverBox {
    /// The least and the greatest σ of eq 15 or 16, Pa, or V0 of eq 18 or 20 at 1 Pa, m/s.
    pub values: [Ball; 2],
    /// The least and the greatest limit of the box's sliders, in the unit of [`Limit::in_si`](super::Limit::in_si).
    pub limits: [Ball; 2],
    asymptote: Asymptote,
}

impl LimitOverBox {
    /// The limit that holds for every slider of the box, and the one of the best of them.
    #[must_use]
    pub fn certain_and_best(&self) -> [&Ball; 2] {
        let [least, greatest] = &self.limits;
        // Eq 18 is good above its limit.
        if self.asymptote == Asymptote::InertialUpper { [greatest, least] } else { [least, greatest] }
    }
}

/// How far an asymptote can be used for every slider of a box; σ and V0 of the box play no part.
///
/// None for eqs 15 and 18 where a = b lies in the box.
///
/// ```
/// use slipmode_core::stability::tolerance::limit_over_box;
/// use slipmode_core::stability::{Asymptote, ParameterBox};
/// use slipmode_core::{friction::Parameters, number::parse_decimal};
///
/// let point = |b: &str| {
///     Parameters::from(["0.004", b, "1e-5", "1e7", "1000", "1", "1"].map(|text| parse_decimal(text).unwrap()))
/// };
/// let region = ParameterBox::new(point("0.005"), point("0.007")).unwrap();
/// let tolerance = parse_decimal("0.01").unwrap();
/// let found = limit_over_box(Asymptote::QuasiStaticUpper, &region, &tolerance, 20).unwrap();
/// let [certain, best] = found.certain_and_best();
/// assert!(certain.upper() < best.lower());
/// ```
#[must_use]
pub fn limit_over_box(
    asymptote: Asymptote,
    region: &ParameterBox,
    tolerance: &Rational,
    digits: u32,
) -> Option<LimitOverBox> {
    let ends: [Slider<Rational>; 2] = [region.lower().slider, region.upper().slider];
    let effects = Effects::of(&ends);
    if effects == Effects::Equal && asymptote.arc() == Arc::Upper {
        return None;
    }
    let value = |slider: &Slider<Rational>| asymptote.value(&enclosed(slider, digits), &Ball::from(1));
    let at_limit = |slider: &Slider<Rational>| {
        Some(limit(asymptote, &slider.effect_ratio(), tolerance, digits)?.in_si(&enclosed(slider, digits)))
    };
    let [least, greatest] = corners(&ends, rises_of_limit(asymptote, effects));
    let limits = [at_limit(&least)?, at_limit(&greatest)?];
    let values = corners(&ends, rises_of_value(asymptote, effects)).map(|slider| value(&slider));
    Some(LimitOverBox { values, limits, asymptote })
}

/// Which effect is larger throughout a box.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Effects {
    Weakening,
    Strengthening,
    /// Equal at some point of the box.
    Equal,
}

impl Effects {
    fn of([lower, upper]: &[Slider<Rational>; 2]) -> Self {
        if upper.direct_effect < lower.evolution_effect {
            Self::Weakening
        } else if upper.evolution_effect < lower.direct_effect {
            Self::Strengthening
        } else {
            Self::Equal
        }
    }
}

/// Whether the limit rises with a, b, D_c, K, M.
fn rises_of_limit(asymptote: Asymptote, effects: Effects) -> [bool; 5] {
    let with_a = match asymptote.arc() {
        Arc::Upper => effects == Effects::Weakening,
        Arc::Lower => asymptote.is_quasi_static(),
    };
    let with_b = asymptote.arc() == Arc::Upper && !with_a;
    // M has no part in eqs 18 and 20.
    [with_a, with_b, true, true, false]
}

/// Whether σ of eqs 15 and 16, or V0 of eqs 18 and 20 at a given σ, rises with a, b, D_c, K, M.
fn rises_of_value(asymptote: Asymptote, effects: Effects) -> [bool; 5] {
    let is_weakening = effects == Effects::Weakening;
    match asymptote {
        Asymptote::QuasiStaticUpper => [is_weakening, !is_weakening, true, true, false],
        Asymptote::QuasiStaticLower => [false, false, true, true, false],
        Asymptote::InertialUpper => [!is_weakening, is_weakening, false, false, false],
        Asymptote::InertialLower => [true, false, false, false, false],
    }
}

/// The corners with the least and the greatest value of what rises with these parameters and falls with, or has no part of, the others.
fn corners(ends: &[Slider<Rational>; 2], rises: [bool; 5]) -> [Slider<Rational>; 2] {
    let values: [[Rational; 5]; 2] = ends.each_ref().map(|slider| slider.clone().into());
    [false, true].map(|is_greatest| {
        Slider::from([0, 1, 2, 3, 4].map(|i| values[usize::from(rises[i] == is_greatest)][i].clone()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;
    use crate::stability::tolerance::Limit;

    fn number(text: &str) -> Rational {
        parse_decimal(text).unwrap()
    }

    fn region(ends: [[&str; 5]; 2]) -> ParameterBox {
        let [lower, upper] =
            ends.map(|values| Slider::from(values.map(number)).at(Rational::from(1), Rational::from(1)));
        ParameterBox::new(lower, upper).unwrap()
    }

    const WEAKENING: [[&str; 5]; 2] =
        [["0.008", "0.0119", "7e-6", "1.9e9", "2300"], ["0.0101", "0.0133", "9e-6", "2.1e9", "2500"]];
    const STRENGTHENING: [[&str; 5]; 2] =
        [["0.0119", "0.002", "7e-6", "1.9e9", "2300"], ["0.0133", "0.0101", "9e-6", "2.1e9", "2500"]];
    const STRADDLING: [[&str; 5]; 2] =
        [["0.004", "0.001", "7e-6", "1.9e9", "2300"], ["0.0133", "0.09", "9e-6", "2.1e9", "2500"]];

    fn limit_of(asymptote: Asymptote, slider: &Slider<Rational>, tolerance: &str) -> Option<(Limit, Ball)> {
        let found = limit(asymptote, &slider.effect_ratio(), &number(tolerance), 15)?;
        let in_si = found.in_si(&slider.map(|value| Ball::from_rational(value, 80)));
        Some((found, in_si))
    }

    #[test]
    fn no_slider_of_a_box_has_a_limit_or_a_value_beyond_those_of_the_two_corners() {
        let mut whole_branches = 0;
        for ends in [WEAKENING, STRENGTHENING, STRADDLING] {
            let region = region(ends);
            let (lower, upper): ([Rational; 7], [Rational; 7]) =
                (region.lower().into(), region.upper().into());
            for (asymptote, tolerance) in
                Asymptote::ALL.into_iter().flat_map(|it| [(it, "0.3"), (it, "0.003")])
            {
                let Some(found) = limit_over_box(asymptote, &region, &number(tolerance), 15) else {
                    assert!(ends == STRADDLING && asymptote.arc() == Arc::Upper);
                    continue;
                };
                let [least, greatest] = &found.limits;
                let [least_value, greatest_value] = &found.values;
                // The points of a grid in a, b and one of the others at a time, the corners among them.
                for index in 0..3 * 25 {
                    let shares = [index % 5, index / 5 % 5].map(|share| Rational::from((share, 4)));
                    let at = |i: usize| {
                        let share = match i {
                            0 | 1 => shares[i].clone(),
                            _ => Rational::from(u32::from(i == 2 + index as usize / 25)),
                        };
                        Rational::from(&upper[i] - &lower[i]) * share + &lower[i]
                    };
                    let slider = Slider::from([0, 1, 2, 3, 4].map(at));
                    let (found, in_si) = limit_of(asymptote, &slider, tolerance).unwrap();
                    whole_branches += u32::from(found.whole_branch);
                    let value =
                        asymptote.value(&slider.map(|value| Ball::from_rational(value, 80)), &Ball::from(1));
                    assert!(
                        least.lower() <= in_si.upper() && in_si.lower() <= greatest.upper(),
                        "{asymptote:?}"
                    );
                    assert!(
                        least_value.lower() <= value.upper() && value.lower() <= greatest_value.upper(),
                        "{asymptote:?}"
                    );
                }
            }
        }
        assert!(whole_branches > 0, "a limit at the cusp is among them");
    }

    #[test]
    fn the_ends_are_strictly_apart_in_a_and_in_b_alone() {
        for (ends, asymptote) in
            [WEAKENING, STRENGTHENING].into_iter().flat_map(|ends| Asymptote::ALL.map(|it| (ends, it)))
        {
            for varied in [0, 1] {
                let mut thin = [ends[0]; 2];
                thin[1][varied] = ends[1][varied];
                let [least, greatest] =
                    limit_over_box(asymptote, &region(thin), &number("0.01"), 15).unwrap().limits;
                assert!(least.upper() < greatest.lower(), "{asymptote:?} {varied}");
            }
        }
    }

    /// The sign of ∂φ/∂z, as the proof states it, against the quotient rule.
    #[test]
    fn the_slope_of_phi_has_the_sign_that_the_proof_states() {
        let one = || Rational::from(1);
        for (e, z, error) in
            [("0.7", "0.3", "0.1"), ("-0.4", "1.9", "0.01"), ("-2.5", "1.3", "0.5"), ("3", "4", "0.2")]
        {
            let parse = |text: &str| match text.strip_prefix('-') {
                Some(size) => -number(size),
                None => number(text),
            };
            let (e, z, error) = (parse(e), parse(z), parse(error));
            let grown = one() + &error;
            // φ e² = N/D − 1/z² with N = (1 + ε)(e + 2 − z) and D = (1 + e z) z.
            let numerator = Rational::from(&e + 2u32) - &z;
            let factor = one() + Rational::from(&e * &z);
            let denominator = Rational::from(&factor * &z);
            let slope_of_denominator = one() + Rational::from(&e * &z) * 2u32;
            let quotient = (-denominator.clone() - numerator * slope_of_denominator)
                / Rational::from(denominator.square_ref());
            let cube = Rational::from(z.square_ref()) * &z;
            let slope = grown.clone() * quotient + Rational::from(2) / &cube;
            let p =
                Rational::from(&z - 1u32) * (z.clone().square() * &e - Rational::from(&e * &z) * 3u32 - 2u32);
            let square = factor.square();
            let c = grown * p - error * 2u32 * &square;
            assert_eq!(slope * cube * square, c);
        }
    }
}
