//! The stability transition K = K_c (eqs 9-13): where the growth rate of the oscillating pair changes sign.
//!
//! For b ≤ a there is no transition: K_c is not positive, σ_c is negative or infinite, V_c is not a number.
//! [`has_transition`] says so before a division by b − a is tried in rationals.

use rug::Rational;

use crate::friction::Parameters;
use crate::number::{Field, Real};

/// Whether the transition exists at positive σ and V0: b > a.
#[must_use]
pub fn has_transition(parameters: &Parameters<Rational>) -> bool {
    parameters.evolution_effect > parameters.direct_effect
}

/// K_c,qs = (b−a)σ/D_c, Pa/m (eq 10): depends on σ, not on M or V0.
#[doc(alias = "eq. 10")]
#[must_use]
pub fn critical_stiffness_quasi_static<R: Field>(parameters: &Parameters<R>) -> R {
    effect_difference(parameters) * &parameters.normal_stress_pa / &parameters.critical_slip_distance_m
}

/// K_c,dyn = ((b−a)/a)·M V0²/D_c², Pa/m (eq 11): depends on M·V0², not on σ.
#[doc(alias = "eq. 11")]
#[must_use]
pub fn critical_stiffness_dynamic<R: Field>(parameters: &Parameters<R>) -> R {
    effect_difference(parameters) / &parameters.direct_effect
        * &parameters.mass_per_area_kg_per_m2
        * parameters.rate_per_s().square()
}

/// K_c = ((b−a)σ/D_c)·(1 + M V0²/(σ a D_c)), Pa/m (eq 9): linearly stable above it.
#[doc(alias = "eq. 9")]
#[must_use]
pub fn critical_stiffness<R: Field>(parameters: &Parameters<R>) -> R {
    critical_stiffness_quasi_static(parameters) * (R::from(1) + parameters.groups().inertial_parameter)
}

/// σ_c = K D_c/(b−a), Pa (eq 12): the normal stress of K = K_c as V0 → 0. Needs b ≠ a in rationals.
#[doc(alias = "eq. 12")]
#[must_use]
pub fn critical_normal_stress_pa<R: Field>(parameters: &Parameters<R>) -> R {
    parameters.stiffness_pa_per_m.clone() * &parameters.critical_slip_distance_m
        / effect_difference(parameters)
}

/// V_c² = D_c²·(a/(b−a))·(K/M), m²/s² (eq 13 squared). Needs b ≠ a in rationals.
#[must_use]
pub fn critical_velocity_squared<R: Field>(parameters: &Parameters<R>) -> R {
    parameters.critical_slip_distance_m.square()
        * &parameters.direct_effect
        * parameters.natural_angular_frequency_squared_per_s2()
        / effect_difference(parameters)
}

/// V_c = D_c·√(a/(b−a))·√(K/M), m/s (eq 13): the velocity of K = K_c as σ → 0. Needs b > a.
#[doc(alias = "eq. 13")]
#[must_use]
pub fn critical_velocity_m_per_s<R: Real>(parameters: &Parameters<R>) -> R {
    critical_velocity_squared(parameters).sqrt()
}

/// σ where K = K_c at the parameters' V0, Pa: eq 9 is linear in σ, σ = σ_c − M V0²/(a D_c).
///
/// Not positive, that is outside the map, when V0 ≥ V_c. Needs b ≠ a in rationals.
#[must_use]
pub fn transition_normal_stress_pa<R: Field>(parameters: &Parameters<R>) -> R {
    let inertial_stress_pa = parameters.mass_per_area_kg_per_m2.clone()
        * parameters.loading_velocity_m_per_s.square()
        / (parameters.direct_effect.clone() * &parameters.critical_slip_distance_m);
    critical_normal_stress_pa(parameters) - inertial_stress_pa
}

/// V0² where K = K_c at the parameters' σ, m²/s²: (σ_c − σ)·a D_c/M.
///
/// Not positive, that is outside the map, when σ ≥ σ_c. Needs b ≠ a in rationals.
#[must_use]
pub fn transition_velocity_squared<R: Field>(parameters: &Parameters<R>) -> R {
    (critical_normal_stress_pa(parameters) - &parameters.normal_stress_pa)
        * &parameters.direct_effect
        * &parameters.critical_slip_distance_m
        / &parameters.mass_per_area_kg_per_m2
}

fn effect_difference<R: Field>(parameters: &Parameters<R>) -> R {
    parameters.evolution_effect.clone() - &parameters.direct_effect
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::fixtures::{paper, positive_rational};
    use proptest::prelude::*;

    #[test]
    fn the_papers_values_give_its_critical_points() {
        assert_eq!(critical_normal_stress_pa(&paper()), 50_000);
        assert_eq!(critical_velocity_squared(&paper()), Rational::from((2, 1_000_000)));
        assert!(has_transition(&paper()));
    }

    proptest! {
        #[test]
        fn the_transition_lies_where_the_margin_of_the_groups_vanishes(
            velocity in positive_rational(), stress in positive_rational(),
        ) {
            let mut p = Parameters { loading_velocity_m_per_s: velocity, ..paper() };
            p.normal_stress_pa = transition_normal_stress_pa(&p);
            if p.normal_stress_pa != 0 {
                prop_assert_eq!(p.groups().transition_margin(), 0);
                prop_assert_eq!(critical_stiffness(&p), p.stiffness_pa_per_m.clone());
                prop_assert_eq!(transition_velocity_squared(&p), p.loading_velocity_m_per_s.clone().square());
            }
            p.normal_stress_pa = stress;
            prop_assert_eq!(
                critical_stiffness(&p),
                critical_stiffness_quasi_static(&p) + critical_stiffness_dynamic(&p)
            );
        }
    }
}
