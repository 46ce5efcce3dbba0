//! The seven inputs of the spring-slider, in SI.

use crate::friction::Groups;
use crate::number::Field;

/// What a user knows of a spring-slider with rate-and-state friction; every value is positive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameters<R> {
    /// a of eq 1, dimensionless.
    pub direct_effect: R,
    /// b of eq 1, dimensionless.
    pub evolution_effect: R,
    /// D_c of eqs 1-3, m.
    pub critical_slip_distance_m: R,
    /// K of eq 4: shear stress per slip, Pa/m.
    pub stiffness_pa_per_m: R,
    /// M of eq 4: mass per unit area, kg/m².
    pub mass_per_area_kg_per_m2: R,
    /// σ of eq 4, Pa.
    pub normal_stress_pa: R,
    /// V0 of eq 4 (the paper's V_l in its section 3), m/s.
    pub loading_velocity_m_per_s: R,
}

/// The seven values in the order of the fields: a, b, D_c, K, M, σ, V0.
impl<R> From<[R; 7]> for Parameters<R> {
    fn from([a, b, d, k, m, s, v]: [R; 7]) -> Self {
        Self {
            direct_effect: a,
            evolution_effect: b,
            critical_slip_distance_m: d,
            stiffness_pa_per_m: k,
            mass_per_area_kg_per_m2: m,
            normal_stress_pa: s,
            loading_velocity_m_per_s: v,
        }
    }
}

impl<R: Field> Parameters<R> {
    /// The dimensionless groups η, κ, β of these parameters.
    #[must_use]
    pub fn groups(&self) -> Groups<R> {
        let direct_stress_pa = self.direct_effect.clone() * &self.normal_stress_pa;
        Groups {
            inertial_parameter: self.mass_per_area_kg_per_m2.clone() * self.loading_velocity_m_per_s.square()
                / (direct_stress_pa.clone() * &self.critical_slip_distance_m),
            stiffness_group: self.stiffness_pa_per_m.clone() * &self.critical_slip_distance_m
                / &direct_stress_pa,
            effect_ratio: self.evolution_effect.clone() / &self.direct_effect,
        }
    }

    /// V0/D_c, 1/s: the rate that turns a dimensionless exponent p into s = p·V0/D_c.
    #[must_use]
    pub fn rate_per_s(&self) -> R {
        self.loading_velocity_m_per_s.clone() / &self.critical_slip_distance_m
    }

    /// ω_n² = K/M, 1/s²: the square of the natural angular frequency.
    #[must_use]
    pub fn natural_angular_frequency_squared_per_s2(&self) -> R {
        self.stiffness_pa_per_m.clone() / &self.mass_per_area_kg_per_m2
    }

    /// The coefficients of eq 8 times σ, by ascending power of s: K V0/D_c, K + (a−b)σ/D_c, aσ/V0 + M V0/D_c, M.
    #[must_use]
    pub fn characteristic_cubic_per_s(&self) -> [R; 4] {
        let p = self;
        let effect_difference = p.direct_effect.clone() - &p.evolution_effect;
        [
            p.stiffness_pa_per_m.clone() * self.rate_per_s(),
            p.stiffness_pa_per_m.clone()
                + effect_difference * &p.normal_stress_pa / &p.critical_slip_distance_m,
            p.direct_effect.clone() * &p.normal_stress_pa / &p.loading_velocity_m_per_s
                + p.mass_per_area_kg_per_m2.clone() * self.rate_per_s(),
            p.mass_per_area_kg_per_m2.clone(),
        ]
    }

    /// The same parameters in another number type.
    #[must_use]
    pub fn map<S>(&self, mut convert: impl FnMut(&R) -> S) -> Parameters<S> {
        Parameters {
            direct_effect: convert(&self.direct_effect),
            evolution_effect: convert(&self.evolution_effect),
            critical_slip_distance_m: convert(&self.critical_slip_distance_m),
            stiffness_pa_per_m: convert(&self.stiffness_pa_per_m),
            mass_per_area_kg_per_m2: convert(&self.mass_per_area_kg_per_m2),
            normal_stress_pa: convert(&self.normal_stress_pa),
            loading_velocity_m_per_s: convert(&self.loading_velocity_m_per_s),
        }
    }
}
