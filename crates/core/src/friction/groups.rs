//! The three dimensionless groups of the spring-slider.

use crate::number::Field;

/// η, κ and β: with time in units of D_c/V0 the slider, linear or not, has no other parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups<R> {
    /// η = M V0²/(σ a D_c).
    pub inertial_parameter: R,
    /// κ = K D_c/(a σ).
    pub stiffness_group: R,
    /// β = b/a.
    pub effect_ratio: R,
}

impl<R: Field> Groups<R> {
    /// Eq 8 in p = s·D_c/V0, by ascending power of p: κ, κ+1−β, 1+η, η.
    #[must_use]
    pub fn characteristic_cubic(&self) -> [R; 4] {
        let one = R::from(1);
        [
            self.stiffness_group.clone(),
            self.stiffness_group.clone() + &one - &self.effect_ratio,
            self.inertial_parameter.clone() + &one,
            self.inertial_parameter.clone(),
        ]
    }

    /// (K − K_c)/(aσ/D_c) = κ + (1−β)(1+η): its sign is that of K − K_c (eq 9), positive when linearly stable.
    #[must_use]
    pub fn transition_margin(&self) -> R {
        let one = R::from(1);
        self.stiffness_group.clone() + (one.clone() - &self.effect_ratio) * (one + &self.inertial_parameter)
    }

    /// The same groups in another number type.
    #[must_use]
    pub fn map<S>(&self, mut convert: impl FnMut(&R) -> S) -> Groups<S> {
        Groups {
            inertial_parameter: convert(&self.inertial_parameter),
            stiffness_group: convert(&self.stiffness_group),
            effect_ratio: convert(&self.effect_ratio),
        }
    }
}
