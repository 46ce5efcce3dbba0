//! The four asymptotes of the boundary (eqs 15, 16, 18, 20), their corners, and the geometric mean of the first two.
//!
//! Sums and differences of √a and √b are written so that nothing cancels when a ≈ b:
//! (√b − √a)² = (b−a)²/(√a + √b)².

use crate::friction::{OperatingPoint, Slider};
use crate::number::Real;
use crate::stability::Arc;

slipmode_algebra::named! {
    /// One of the asymptotes of max Im(s) = 0.
    ///
    /// ```
    /// use slipmode_core::{stability::Asymptote, friction::Slider};
    ///
    /// let slider = Slider::from([0.004, 0.006, 1e-5, 1e7, 1000.0]);
    /// // Eq 16: σ = K D_c/(√a + √b)², Pa.
    /// let sigma = Asymptote::QuasiStaticLower.value(&slider, &1e4);
    /// assert!((sigma - 100.0 / (0.004f64.sqrt() + 0.006f64.sqrt()).powi(2)).abs() < 1e-9 * sigma);
    /// ```
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
    pub enum Asymptote {
        /// Eq 15: the upper arc as V0 → 0, a normal stress.
        QuasiStaticUpper = "eq15",
        /// Eq 16: the lower arc as V0 → 0, a normal stress.
        QuasiStaticLower = "eq16",
        /// Eq 18: the upper arc as V0 → ∞, a velocity in proportion to σ.
        InertialUpper = "eq18",
        /// Eq 20: the lower arc as σ → 0, a velocity in proportion to σ.
        InertialLower = "eq20",
    }
}

impl Asymptote {
    /// The arc that it belongs to.
    #[must_use]
    pub const fn arc(self) -> Arc {
        match self {
            Self::QuasiStaticUpper | Self::InertialUpper => Arc::Upper,
            Self::QuasiStaticLower | Self::InertialLower => Arc::Lower,
        }
    }

    /// Whether it gives σ (eqs 15 and 16); the others give V0 at σ.
    #[must_use]
    pub const fn is_quasi_static(self) -> bool {
        matches!(self, Self::QuasiStaticUpper | Self::QuasiStaticLower)
    }

    /// The quasi-static asymptote of an arc.
    #[must_use]
    pub const fn quasi_static(arc: Arc) -> Self {
        match arc {
            Arc::Upper => Self::QuasiStaticUpper,
            Arc::Lower => Self::QuasiStaticLower,
        }
    }

    /// The inertial asymptote of an arc.
    #[must_use]
    pub const fn inertial(arc: Arc) -> Self {
        match arc {
            Arc::Upper => Self::InertialUpper,
            Arc::Lower => Self::InertialLower,
        }
    }

    /// σ of eq 15 or 16 in Pa, which does not depend on the given σ, or V0 of eq 18 or 20 in m/s at that σ in Pa.
    #[must_use]
    pub fn value<R: Real>(self, slider: &Slider<R>, normal_stress_pa: &R) -> R {
        match self {
            Self::QuasiStaticUpper => quasi_static_upper_normal_stress_pa(slider),
            Self::QuasiStaticLower => quasi_static_lower_normal_stress_pa(slider),
            Self::InertialUpper => inertial_upper_velocity_m_per_s(slider, normal_stress_pa),
            Self::InertialLower => inertial_lower_velocity_m_per_s(slider, normal_stress_pa),
        }
    }
}

/// σ = K D_c/(√b − √a)², Pa (eq 15), as K D_c (√a + √b)²/(b−a)²; infinite for a = b.
///
/// The paper takes M = 0. For M > 0 the boundary's σ is larger by the relative amount η, to leading order.
#[doc(alias = "eq. 15")]
#[must_use]
pub fn quasi_static_upper_normal_stress_pa<R: Real>(slider: &Slider<R>) -> R {
    slider.stiffness_stress_pa() * squared_root_sum(slider) / slider.effect_difference().square()
}

/// σ = K D_c/(√b + √a)², Pa (eq 16).
///
/// The paper takes M = 0. For M > 0 the boundary's σ is larger by the relative amount η, to leading order.
#[doc(alias = "eq. 16")]
#[must_use]
pub fn quasi_static_lower_normal_stress_pa<R: Real>(slider: &Slider<R>) -> R {
    slider.stiffness_stress_pa() / squared_root_sum(slider)
}

/// V0 = |a−b|σ/(2√(MK)), m/s (eq 18); zero for a = b.
///
/// The paper takes D_c → 0. The boundary's V0 is smaller by the relative amount 2bKD_c/((b−a)²σ), to leading order.
#[doc(alias = "eq. 18")]
#[must_use]
pub fn inertial_upper_velocity_m_per_s<R: Real>(slider: &Slider<R>, normal_stress_pa: &R) -> R {
    slider.effect_difference().square().sqrt() * normal_stress_pa / twice_impedance(slider)
}

/// V0 = aσ/(2√(MK)), m/s (eq 20).
///
/// The paper takes D_c → ∞. The boundary's V0 is larger by the relative amount bσ/(2KD_c), to leading order.
#[doc(alias = "eq. 20")]
#[must_use]
pub fn inertial_lower_velocity_m_per_s<R: Real>(slider: &Slider<R>, normal_stress_pa: &R) -> R {
    slider.direct_effect.clone() * normal_stress_pa / twice_impedance(slider)
}

/// The corner of an arc's two asymptotes, 15∩18 or 16∩20.
#[must_use]
pub fn corner<R: Real>(arc: Arc, slider: &Slider<R>) -> OperatingPoint<R> {
    // Eqs 15 and 16 do not depend on σ.
    let normal_stress_pa = Asymptote::quasi_static(arc).value(slider, &R::from(0));
    let loading_velocity_m_per_s = Asymptote::inertial(arc).value(slider, &normal_stress_pa);
    OperatingPoint { normal_stress_pa, loading_velocity_m_per_s }
}

/// (√a + √b)².
fn squared_root_sum<R: Real>(slider: &Slider<R>) -> R {
    (slider.direct_effect.sqrt() + slider.evolution_effect.sqrt()).square()
}

/// 2√(MK), Pa·s/m.
fn twice_impedance<R: Real>(slider: &Slider<R>) -> R {
    R::from(2) * (slider.mass_per_area_kg_per_m2.clone() * &slider.stiffness_pa_per_m).sqrt()
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::number::{Ball, Field, parse_decimal};
    use crate::stability::fixtures::{paper, with_effects};

    fn balls(slider: &Slider<Rational>) -> Slider<Ball> {
        slider.map(|value| Ball::from_rational(value, 200))
    }

    fn stress() -> Ball {
        Ball::from(10_000)
    }

    #[test]
    fn square_effects_give_rational_asymptotes() {
        let slider = with_effects(Rational::from((4, 10_000)), Rational::from((9, 10_000)));
        let values = Asymptote::ALL.map(|asymptote| asymptote.value(&balls(&slider), &stress()));
        // √a = 0.02, √b = 0.03; K D_c = 100 Pa; 2√(MK) = 2e5 Pa s/m; σ = 1e4 Pa.
        let expected = ["1e6", "40000", "2.5e-5", "2e-5"].map(|text| parse_decimal(text).unwrap());
        for (value, exact) in values.iter().zip(&expected) {
            assert!(value.contains(exact) && value.relative_radius_log2() < -190.0);
        }
    }

    #[test]
    fn exchanging_the_effects_leaves_eqs_15_16_and_18_and_moves_eq_20() {
        let (a, b) = (Rational::from((4, 1000)), Rational::from((6, 1000)));
        let (one, other) = (balls(&with_effects(a.clone(), b.clone())), balls(&with_effects(b, a)));
        for asymptote in Asymptote::ALL {
            let overlap = asymptote.value(&one, &stress()).overlaps(&asymptote.value(&other, &stress()));
            assert_eq!(overlap, asymptote != Asymptote::InertialLower);
        }
    }

    #[test]
    fn the_product_of_eqs_15_and_16_is_the_square_of_eq_12() {
        let slider = balls(&paper());
        let product =
            quasi_static_upper_normal_stress_pa(&slider) * quasi_static_lower_normal_stress_pa(&slider);
        assert!(product.overlaps(&slider.critical_normal_stress_pa().square()));
    }

    #[test]
    fn effects_that_agree_in_eighteen_digits_cost_eighteen_digits_once_and_not_twice() {
        let a = Rational::from((4, 1000));
        let b = &a + &a * parse_decimal("1e-18").unwrap();
        let value = quasi_static_upper_normal_stress_pa(&balls(&with_effects(a, b)));
        // The rounding of b at 200 bits is 2^60 times larger relative to b − a, and squared to twice that.
        assert!(value.relative_radius_log2() < 60.0 + 3.0 - 200.0);
    }
}
