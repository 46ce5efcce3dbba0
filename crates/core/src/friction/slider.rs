//! Material and machine: the five inputs of the spring-slider that do not say how it is driven, in SI.

use super::Quantity;
use crate::number::{Field, Real, fields};

fields! {
    /// Rate-and-state friction on a spring and a mass; every value is positive.
    ///
    /// ```
    /// use slipmode_core::{friction::Slider, number::parse_decimal};
    ///
    /// // A laboratory slider: a, b, D_c in m, K in Pa/m, M in kg/m².
    /// let slider = Slider::from(["0.004", "0.006", "1e-5", "1e7", "1000"].map(|text| parse_decimal(text).unwrap()));
    /// assert!(slider.has_transition()); // b > a
    /// assert_eq!(slider.critical_normal_stress_pa(), 50_000); // K D_c/(b − a)
    /// ```
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    pub struct Slider<R>[5] {
        /// a of eq 1, dimensionless.
        pub direct_effect,
        /// b of eq 1, dimensionless.
        pub evolution_effect,
        /// D_c of eqs 1-3, m.
        pub critical_slip_distance_m,
        /// K of eq 4: shear stress per slip, Pa/m.
        pub stiffness_pa_per_m,
        /// M of eq 4: mass per unit area, kg/m².
        pub mass_per_area_kg_per_m2,
    }
}

impl<R> Slider<R> {
    /// The value of a quantity; none of the operating point.
    #[must_use]
    pub const fn value(&self, quantity: Quantity) -> Option<&R> {
        match quantity {
            Quantity::DirectEffect => Some(&self.direct_effect),
            Quantity::EvolutionEffect => Some(&self.evolution_effect),
            Quantity::CriticalSlipDistance => Some(&self.critical_slip_distance_m),
            Quantity::Stiffness => Some(&self.stiffness_pa_per_m),
            Quantity::MassPerArea => Some(&self.mass_per_area_kg_per_m2),
            Quantity::NormalStress | Quantity::LoadingVelocity => None,
        }
    }
}

impl<R: PartialOrd> Slider<R> {
    /// Whether the transition K = K_c exists at positive σ and V0: b > a.
    #[must_use]
    pub fn has_transition(&self) -> bool {
        self.evolution_effect > self.direct_effect
    }
}

impl<R: Field> Slider<R> {
    /// β = b/a.
    #[must_use]
    #[inline(always)]
    pub fn effect_ratio(&self) -> R {
        self.evolution_effect.clone() / &self.direct_effect
    }

    /// b − a.
    #[must_use]
    pub fn effect_difference(&self) -> R {
        self.evolution_effect.clone() - &self.direct_effect
    }

    /// ω_n² = K/M, 1/s²: the square of the natural angular frequency.
    pub(crate) fn natural_angular_frequency_squared_per_s2(&self) -> R {
        self.stiffness_pa_per_m.clone() / &self.mass_per_area_kg_per_m2
    }

    /// K D_c, Pa.
    #[must_use]
    #[inline(always)]
    pub fn stiffness_stress_pa(&self) -> R {
        self.stiffness_pa_per_m.clone() * &self.critical_slip_distance_m
    }

    /// K D_c/a, Pa: σ = (K D_c/a)/κ.
    #[must_use]
    pub fn stress_scale_pa(&self) -> R {
        self.stiffness_stress_pa() / &self.direct_effect
    }

    /// D_c² K/M, m²/s²: V0² = (D_c² K/M)·η/κ.
    pub(crate) fn velocity_scale_squared(&self) -> R {
        self.critical_slip_distance_m.square() * self.natural_angular_frequency_squared_per_s2()
    }

    /// σ_c = K D_c/(b−a), Pa (eq 12): the normal stress of K = K_c as V0 → 0. Needs b ≠ a in rationals.
    #[doc(alias = "eq. 12")]
    #[must_use]
    pub fn critical_normal_stress_pa(&self) -> R {
        self.stiffness_stress_pa() / self.effect_difference()
    }

    /// V_c² = D_c²·(a/(b−a))·(K/M), m²/s² (eq 13 squared). Needs b ≠ a in rationals.
    #[must_use]
    pub fn critical_velocity_squared(&self) -> R {
        self.critical_slip_distance_m.square()
            * &self.direct_effect
            * self.natural_angular_frequency_squared_per_s2()
            / self.effect_difference()
    }

    /// σ where K = K_c at this V0, Pa: eq 9 is linear in σ, σ = σ_c − M V0²/(a D_c).
    ///
    /// Not positive, that is outside the map, when V0 ≥ V_c. Needs b ≠ a in rationals.
    #[must_use]
    pub fn transition_normal_stress_pa(&self, loading_velocity_m_per_s: &R) -> R {
        let inertial_stress_pa = self.mass_per_area_kg_per_m2.clone() * loading_velocity_m_per_s.square()
            / (self.direct_effect.clone() * &self.critical_slip_distance_m);
        self.critical_normal_stress_pa() - inertial_stress_pa
    }

    /// V0² where K = K_c at this σ, m²/s²: (σ_c − σ)·a D_c/M.
    ///
    /// Not positive, that is outside the map, when σ ≥ σ_c. Needs b ≠ a in rationals.
    pub(crate) fn transition_velocity_squared(&self, normal_stress_pa: &R) -> R {
        (self.critical_normal_stress_pa() - normal_stress_pa)
            * &self.direct_effect
            * &self.critical_slip_distance_m
            / &self.mass_per_area_kg_per_m2
    }
}

impl<R: Real> Slider<R> {
    /// ω_n = √(K/M), 1/s: the natural angular frequency.
    #[must_use]
    pub fn natural_angular_frequency_per_s(&self) -> R {
        self.natural_angular_frequency_squared_per_s2().sqrt()
    }

    /// ω/V0 of eq 23, √((b−a)/a)/D_c, 1/m: exact on K = K_c. Needs b > a.
    #[doc(alias = "eq. 23")]
    #[must_use]
    pub fn transition_angular_frequency_over_velocity_per_m(&self) -> R {
        (self.effect_difference() / &self.direct_effect).sqrt() / &self.critical_slip_distance_m
    }

    /// V_c = D_c·√(a/(b−a))·√(K/M), m/s (eq 13): the velocity of K = K_c as σ → 0. Needs b > a.
    #[doc(alias = "eq. 13")]
    #[must_use]
    pub fn critical_velocity_m_per_s(&self) -> R {
        self.critical_velocity_squared().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;

    /// The paper's slider (fig 1).
    fn paper() -> Slider<Rational> {
        Slider::from([(4, 1000), (6, 1000), (1, 100_000), (10_000_000, 1), (1000, 1)].map(Rational::from))
    }

    #[test]
    fn the_papers_values_give_its_critical_points() {
        assert_eq!(paper().critical_normal_stress_pa(), 50_000);
        assert_eq!(paper().critical_velocity_squared(), Rational::from((2, 1_000_000)));
        assert!(paper().has_transition());
    }

    fn positive() -> impl Strategy<Value = Rational> {
        (1_i64..1_000_000, 1_i64..1_000_000).prop_map(Rational::from)
    }

    proptest! {
        #[test]
        fn the_transition_lies_where_the_margin_of_the_groups_vanishes(velocity in positive(), stress in positive()) {
            let transition_stress = paper().transition_normal_stress_pa(&velocity);
            if transition_stress != 0 {
                let p = paper().at(transition_stress, velocity.clone());
                prop_assert_eq!(p.groups().transition_margin(), 0);
                prop_assert_eq!(p.critical_stiffness(), paper().stiffness_pa_per_m);
                prop_assert_eq!(
                    paper().transition_velocity_squared(&p.point.normal_stress_pa),
                    velocity.clone().square()
                );
            }
            let p = paper().at(stress, velocity);
            // Eq 11: K_c,dyn = ((b−a)/a)·M V0²/D_c².
            let dynamic = p.slider.effect_difference() / &p.slider.direct_effect
                * &p.slider.mass_per_area_kg_per_m2
                * p.rate_per_s().square();
            prop_assert_eq!(p.critical_stiffness(), p.critical_stiffness_quasi_static() + dynamic);
        }
    }
}
