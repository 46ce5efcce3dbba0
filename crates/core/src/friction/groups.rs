//! The three dimensionless groups of the spring-slider.

use std::ops::{Add, Sub};

use crate::number::{Field, fields};

fields! {
    /// η, κ and β: with time in units of D_c/V0 the slider, linear or not, has no other parameter.
    ///
    /// ```
    /// use slipmode_core::{friction::Groups, number::Rational};
    ///
    /// let [inertial_parameter, stiffness_group, effect_ratio] = [1, 2, 3].map(Rational::from);
    /// let groups = Groups { inertial_parameter, stiffness_group, effect_ratio };
    /// // Eq 8: η p³ + (1 + η) p² + (κ + 1 − β) p + κ = 0.
    /// assert_eq!(groups.characteristic_cubic(), [2, 0, 2, 1].map(Rational::from));
    /// // κ_c = (β − 1)(1 + η) = 4 > κ: unstable.
    /// assert_eq!(groups.transition_margin(), -2);
    /// ```
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub struct Groups<R>[3] {
        /// η = M V0²/(σ a D_c).
        pub inertial_parameter,
        /// κ = K D_c/(a σ).
        pub stiffness_group,
        /// β = b/a.
        pub effect_ratio,
    }
}

/// κ_c = (β−1)(1+η), the κ of K = K_c (eq 9) at these β and η.
#[doc(alias = "eq. 9")]
#[must_use]
#[inline(always)]
pub fn critical_stiffness_group<R: Field>(effect_ratio: &R, inertial_parameter: &R) -> R {
    let one = R::from(1);
    (effect_ratio.clone() - &one) * (one + inertial_parameter)
}

/// Eq 8 by ascending power of p from the terms κ, 1, β and η, or from these four times one number.
#[inline(always)]
pub(crate) fn cubic_of_terms<R>([spring, direct, evolution, inertia]: [&R; 4]) -> [R; 4]
where
    R: Clone + for<'r> Add<&'r R, Output = R> + for<'r> Sub<&'r R, Output = R>,
{
    [spring.clone(), spring.clone() + direct - evolution, inertia.clone() + direct, inertia.clone()]
}

impl<R: Field> Groups<R> {
    /// Eq 8 in p = s·D_c/V0, by ascending power of p: κ, κ+1−β, 1+η, η.
    #[must_use]
    #[inline(always)]
    pub fn characteristic_cubic(&self) -> [R; 4] {
        let Self { inertial_parameter, stiffness_group, effect_ratio } = self;
        cubic_of_terms([stiffness_group, &R::from(1), effect_ratio, inertial_parameter])
    }

    /// κ_c = (β−1)(1+η), the κ of K = K_c (eq 9).
    pub(crate) fn critical_stiffness_group(&self) -> R {
        critical_stiffness_group(&self.effect_ratio, &self.inertial_parameter)
    }

    /// κ − κ_c = (K − K_c)/(aσ/D_c): its sign is that of K − K_c (eq 9), positive when linearly stable.
    #[must_use]
    #[inline(always)]
    pub fn transition_margin(&self) -> R {
        self.stiffness_group.clone() - self.critical_stiffness_group()
    }

    /// (ω_n D_c/V0)² = κ/η: the square of the natural angular frequency in units of V0/D_c.
    #[must_use]
    pub fn natural_angular_frequency_squared(&self) -> R {
        self.stiffness_group.clone() / &self.inertial_parameter
    }
}
