//! A slider at an operating point: the seven inputs of the spring-slider, in SI.

use crate::friction::{Groups, Slider};
use crate::number::{Field, fields};

fields! {
    /// How the slider is driven: one point of the (V0, σ) plane; both values are positive.
    ///
    /// ```
    /// use slipmode_core::friction::{OperatingPoint, Parameters, Slider};
    ///
    /// let point = OperatingPoint { normal_stress_pa: 1e6, loading_velocity_m_per_s: 1e-5 };
    /// let parameters = Parameters { slider: Slider::from([0.004, 0.006, 1e-5, 1e7, 1000.0]), point };
    /// assert!((parameters.rate_per_s() - 1.0).abs() < 1e-15);
    /// ```
    #[derive(Debug, Clone, PartialEq, Eq, Hash)]
    pub struct OperatingPoint<R>[2] {
        /// σ of eq 4, Pa.
        pub normal_stress_pa,
        /// V0 of eq 4 (the paper's V_l in its section 3), m/s.
        pub loading_velocity_m_per_s,
    }
}

/// A slider at an operating point: all that the equations of motion need.
///
/// ```
/// use slipmode_core::friction::Parameters;
///
/// // a, b, D_c, K, M, σ, V0.
/// let parameters = Parameters::from([0.004, 0.006, 1e-5, 1e7, 1000.0, 1e6, 1e-5]);
/// assert!((parameters.direct_stress_pa() - 4000.0).abs() < 1e-9);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameters<R> {
    /// a, b, D_c, K, M.
    pub slider: Slider<R>,
    /// σ, V0.
    pub point: OperatingPoint<R>,
}

/// The seven values in the order of the fields: a, b, D_c, K, M, σ, V0.
impl<R> From<[R; 7]> for Parameters<R> {
    fn from([a, b, d, k, m, s, v]: [R; 7]) -> Self {
        Self { slider: [a, b, d, k, m].into(), point: [s, v].into() }
    }
}

/// The inverse of [`Parameters::from`] an array: a, b, D_c, K, M, σ, V0.
impl<R> From<Parameters<R>> for [R; 7] {
    fn from(Parameters { slider, point }: Parameters<R>) -> Self {
        let ([a, b, d, k, m], [s, v]) = (slider.into(), point.into());
        [a, b, d, k, m, s, v]
    }
}

impl<R: Clone> Slider<R> {
    /// The slider driven at V0 (m/s) under σ (Pa).
    ///
    /// ```
    /// use slipmode_core::friction::Slider;
    ///
    /// let parameters = Slider::from([0.004, 0.006, 1e-5, 1e7, 1000.0]).at(1e6, 1e-5);
    /// assert_eq!(parameters.point.normal_stress_pa, 1e6);
    /// ```
    #[must_use]
    pub fn at(&self, normal_stress_pa: R, loading_velocity_m_per_s: R) -> Parameters<R> {
        Parameters { slider: self.clone(), point: [normal_stress_pa, loading_velocity_m_per_s].into() }
    }
}

impl<R> Parameters<R> {
    /// The same parameters in another number type.
    #[must_use]
    #[inline(always)]
    pub fn map<S>(&self, mut convert: impl FnMut(&R) -> S) -> Parameters<S> {
        Parameters { slider: self.slider.map(&mut convert), point: self.point.map(convert) }
    }
}

impl<R: Field> Parameters<R> {
    /// aσ, Pa: the unit of stress of the dimensionless slider.
    #[must_use]
    #[inline(always)]
    pub fn direct_stress_pa(&self) -> R {
        self.slider.direct_effect.clone() * &self.point.normal_stress_pa
    }

    /// The dimensionless groups η, κ, β of these parameters.
    #[must_use]
    #[inline(always)]
    pub fn groups(&self) -> Groups<R> {
        let Self { slider, point } = self;
        let direct_stress_pa = self.direct_stress_pa();
        Groups {
            inertial_parameter: slider.mass_per_area_kg_per_m2.clone()
                * point.loading_velocity_m_per_s.square()
                / (direct_stress_pa.clone() * &slider.critical_slip_distance_m),
            stiffness_group: slider.stiffness_stress_pa() / &direct_stress_pa,
            effect_ratio: slider.effect_ratio(),
        }
    }

    /// V0/D_c, 1/s: the rate that turns a dimensionless exponent p into s = p·V0/D_c.
    #[must_use]
    #[inline(always)]
    pub fn rate_per_s(&self) -> R {
        self.point.loading_velocity_m_per_s.clone() / &self.slider.critical_slip_distance_m
    }

    /// The coefficients of eq 8 times σ, by ascending power of s: K V0/D_c, K + (a−b)σ/D_c, aσ/V0 + M V0/D_c, M.
    #[must_use]
    pub fn characteristic_cubic_per_s(&self) -> [R; 4] {
        let Self { slider, point } = self;
        let effect_difference = slider.direct_effect.clone() - &slider.evolution_effect;
        [
            slider.stiffness_pa_per_m.clone() * self.rate_per_s(),
            slider.stiffness_pa_per_m.clone()
                + effect_difference * &point.normal_stress_pa / &slider.critical_slip_distance_m,
            slider.direct_effect.clone() * &point.normal_stress_pa / &point.loading_velocity_m_per_s
                + slider.mass_per_area_kg_per_m2.clone() * self.rate_per_s(),
            slider.mass_per_area_kg_per_m2.clone(),
        ]
    }

    /// K_c,qs = (b−a)σ/D_c, Pa/m (eq 10): depends on σ, not on M or V0.
    #[doc(alias = "eq. 10")]
    #[must_use]
    pub fn critical_stiffness_quasi_static(&self) -> R {
        self.slider.effect_difference() * &self.point.normal_stress_pa / &self.slider.critical_slip_distance_m
    }

    /// K_c = ((b−a)σ/D_c)·(1 + M V0²/(σ a D_c)), Pa/m (eq 9): linearly stable above it.
    #[doc(alias = "eq. 9")]
    #[must_use]
    pub fn critical_stiffness(&self) -> R {
        self.critical_stiffness_quasi_static() * (R::from(1) + self.groups().inertial_parameter)
    }
}
