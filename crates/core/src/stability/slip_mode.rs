//! Slip modes: the names the paper gives to areas of the (V0, σ) plane, decided exactly.

use rug::{Complete, Integer};

use super::SpectralClass;
use crate::friction::{Groups, SlipMode};
use crate::number::Rational;
use crate::roots::Depressed;

/// From which ω/ω_n on an oscillation is called inertial, ω being the imaginary part of the complex pair.
///
/// The paper draws no line. The default is (ω/ω_n)² = 1/2, for a reason: on K = K_c the pair has ω² = β−1 (eq 23, in units of
/// V0/D_c) and ω_n² = κ/η = (β−1)(1+η)/η, so that (ω/ω_n)² = η/(1+η) exactly. That is 1/2 at η = 1, which is where
/// the asymptotes V0 = V_c and σ = σ_c of the transition cross; eq 23 taken beyond V_c would exceed ω_n.
///
/// ```
/// use slipmode_core::{stability::InertialThreshold, number::Rational};
///
/// assert_eq!(*InertialThreshold::default().squared_ratio(), 0.5);
/// assert!(InertialThreshold::from_ratio(&Rational::from((9, 10))).is_some());
/// assert!(InertialThreshold::from_ratio(&Rational::from(2)).is_none()); // ω never reaches ω_n
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InertialThreshold {
    squared_ratio: Rational,
}

impl Default for InertialThreshold {
    fn default() -> Self {
        Self { squared_ratio: Rational::from((1, 2)) }
    }
}

impl InertialThreshold {
    /// The threshold ω/ω_n = ratio, or `None` unless 0 < ratio < 1 (ω never reaches ω_n).
    #[must_use]
    pub fn from_ratio(ratio: &Rational) -> Option<Self> {
        Self::from_squared_ratio(ratio.square_ref().complete()).filter(|_| *ratio > 0)
    }

    /// The threshold (ω/ω_n)² = ratio, or `None` unless 0 < ratio < 1.
    #[must_use]
    pub fn from_squared_ratio(squared_ratio: Rational) -> Option<Self> {
        (squared_ratio > 0 && squared_ratio < 1).then_some(Self { squared_ratio })
    }

    /// (ω/ω_n)² of the threshold.
    #[must_use]
    pub const fn squared_ratio(&self) -> &Rational {
        &self.squared_ratio
    }

    /// Whether the complex pair of eq 8 oscillates above the threshold, ω² > T·κ/η; decided exactly.
    ///
    /// −4ω² is a root of the equation of squared differences z(z + 3p)² + 4p³ + 27q² = 0 of the depressed cubic, at which
    /// its left side changes sign from − to +; the only other real root it can have is z = −p, a double one, when q = 0.
    /// So ω² > w ⇔ 4p³ + 27q² − 4w(3p − 4w)² > 0, or w = p/4 on that double root.
    pub(super) fn exceeded_by(&self, depressed: &Depressed) -> bool {
        let g = equation_at_ratio(depressed, &self.squared_ratio);
        let is_double = || {
            let [p, w] = scaled_at_ratio(depressed, &self.squared_ratio);
            depressed.constant.is_zero() && p == w * 4u32
        };
        g > 0 || (g.is_zero() && is_double())
    }

    /// The same by the groups.
    pub(super) fn exceeded_at(&self, groups: &Groups<Rational>) -> bool {
        Depressed::of(&groups.characteristic_cubic()).is_some_and(|cubic| self.exceeded_by(&cubic))
    }
}

/// p and w = T·κ/η of [`InertialThreshold::exceeded_by`] times the denominator of T.
fn scaled_at_ratio(depressed: &Depressed, squared_ratio: &Rational) -> [Integer; 2] {
    let [c0, _, _, c3] = &depressed.cubic;
    // w = T·c0/c3 in x is 9T·c3·c0 in y = 3c3·x + c2.
    let w = (c0 * c3).complete() * squared_ratio.numer() * 9u32;
    [(&depressed.linear * squared_ratio.denom()).complete(), w]
}

/// 4p³ + 27q² − 4w(3p − 4w)² of [`InertialThreshold::exceeded_by`] times the cube of the denominator of T.
pub(super) fn equation_at_ratio(depressed: &Depressed, squared_ratio: &Rational) -> Integer {
    let [p, w] = scaled_at_ratio(depressed, squared_ratio);
    let difference = p * 3u32 - w.clone() * 4u32;
    let denominator = squared_ratio.denom();
    let cube = denominator.square_ref().complete() * denominator;
    -(depressed.discriminant() * cube) - w * 4u32 * difference.square()
}

/// The slip mode of a point. Each case is decided by signs of rationals.
///
/// - stable, roots real: overdamped stable sliding; but an overdamped oscillation when a > b and the point lies in the upper area;
/// - stable, complex: inertial above the threshold, else non-inertial; on the transition likewise, as an oscillation
///   that neither grows nor decays;
/// - unstable, complex: harmonic vibration above the threshold, else stick-slip; unstable, real: stick-slip.
///
/// A point on the boundary counts as real, an oscillation exactly at the threshold as not inertial.
#[must_use]
pub fn slip_mode(groups: &Groups<Rational>, class: SpectralClass, threshold: &InertialThreshold) -> SlipMode {
    slip_mode_given(groups, class, || threshold.exceeded_at(groups))
}

/// [`slip_mode`] with the answer to "does the pair oscillate above the threshold?", computed only where it matters.
pub(super) fn slip_mode_given(
    groups: &Groups<Rational>,
    class: SpectralClass,
    inertial: impl Fn() -> bool,
) -> SlipMode {
    let upper_area = || Some(is_upper_area(groups));
    // Both answers are always given, so that no mode is left open.
    slip_mode_by(class, upper_area, || Some(inertial())).unwrap_or(SlipMode::StickSlip)
}

/// The table of modes: `upper_area` says whether real roots lie in the upper area of a > b, `inertial` whether the pair
/// oscillates above the threshold. Each is computed only where it matters; without its answer there is no mode.
pub(super) fn slip_mode_by(
    class: SpectralClass,
    upper_area: impl Fn() -> Option<bool>,
    inertial: impl Fn() -> Option<bool>,
) -> Option<SlipMode> {
    let either = |answer: bool, yes: SlipMode, no: SlipMode| if answer { yes } else { no };
    Some(match class {
        SpectralClass::StableReal => {
            either(upper_area()?, SlipMode::OverdampedOscillation, SlipMode::OverdampedStableSliding)
        }
        SpectralClass::UnstableReal => SlipMode::StickSlip,
        SpectralClass::StableComplex | SpectralClass::Neutral => either(
            inertial()?,
            SlipMode::InertialUnderdampedOscillation,
            SlipMode::NonInertialUnderdampedOscillation,
        ),
        SpectralClass::UnstableComplex => {
            either(inertial()?, SlipMode::HarmonicVibration, SlipMode::StickSlip)
        }
    })
}

/// Whether a point with stable real roots lies in the upper area of a > b.
pub(super) fn is_upper_area(groups: &Groups<Rational>) -> bool {
    let Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta } = groups;
    let sum = (kappa + eta).complete() - beta - 1u32;
    let signs = [beta.partial_cmp(&1), eta.partial_cmp(&0.5), sum.partial_cmp(&0)];
    is_upper_area_by(signs.map(|sign| sign.map_or(0, |sign| sign as i8)))
}

/// The same by the signs of β − 1, η − 1/2 and κ + η − 1 − β: all roots of the lower area are below −1.
///
/// F(q−1) = ηq³ + (1−2η)q² + (κ+η−1−β)q + β has only negative roots when all coefficients are positive.
pub(super) fn is_upper_area_by([effect, inertia, sum]: [i8; 3]) -> bool {
    let is_lower_area = inertia < 0 && sum > 0;
    effect < 0 && !is_lower_area
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{nearest_f64, parse_decimal};
    use crate::roots::certified_roots;
    use crate::stability::{boundary_sign, transition_sign};
    use proptest::prelude::*;

    fn groups(eta: &str, kappa: &str, beta: &str) -> Groups<Rational> {
        let [eta, kappa, beta] = [eta, kappa, beta].map(|text| parse_decimal(text).unwrap());
        Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta }
    }

    fn mode(groups: &Groups<Rational>) -> SlipMode {
        let class = SpectralClass::from_signs(transition_sign(groups), boundary_sign(groups));
        slip_mode(groups, class, &InertialThreshold::default())
    }

    #[test]
    fn on_the_transition_the_default_threshold_is_met_exactly_at_eta_one() {
        // κ = (β−1)(1+η) with β = 3.
        assert_eq!(mode(&groups("1", "4", "3")), SlipMode::NonInertialUnderdampedOscillation);
        assert_eq!(mode(&groups("1.5", "5", "3")), SlipMode::InertialUnderdampedOscillation);
        assert_eq!(mode(&groups("0.5", "3", "3")), SlipMode::NonInertialUnderdampedOscillation);
    }

    #[test]
    fn the_upper_real_area_of_a_above_b_is_an_overdamped_oscillation() {
        assert_eq!(mode(&groups("1e-4", "1e-3", "0.5")), SlipMode::OverdampedOscillation);
        assert_eq!(mode(&groups("1e-4", "1e3", "0.5")), SlipMode::OverdampedStableSliding);
        assert_eq!(mode(&groups("1e-4", "1e3", "2")), SlipMode::OverdampedStableSliding);
        assert_eq!(mode(&groups("1e-4", "1e-3", "2")), SlipMode::StickSlip);
    }

    #[test]
    fn thresholds_outside_zero_to_one_are_refused() {
        for text in ["0", "1", "-0.5", "2"] {
            assert!(InertialThreshold::from_ratio(&parse_decimal(text).unwrap()).is_none(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn the_exact_threshold_agrees_with_the_enclosed_frequency(
            eta in 1i64..10_000, kappa in 1i64..10_000, beta in 1i64..5_000, ratio in 1i64..1000,
        ) {
            let g = Groups {
                inertial_parameter: Rational::from((eta, 1000)),
                stiffness_group: Rational::from((kappa, 1000)),
                effect_ratio: Rational::from((beta, 1000)),
            };
            let cubic = g.characteristic_cubic();
            let roots = certified_roots(&cubic, 40);
            prop_assume!(roots.discriminant_sign < 0);
            let squared = Rational::from((ratio, 1000));
            let threshold = InertialThreshold::from_squared_ratio(squared.clone()).unwrap();
            let omega = roots.roots[2].im.to_f64();
            let limit = nearest_f64(&(squared * &g.stiffness_group / &g.inertial_parameter)).sqrt();
            prop_assume!((omega / limit - 1.0).abs() > 1e-12);
            prop_assert_eq!(threshold.exceeded_by(&Depressed::of(&cubic).unwrap()), omega > limit);
        }
    }
}
