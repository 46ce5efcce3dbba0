//! The seven physical inputs: their names in scenes, CSV files and on the command line.

use crate::scene::section::Section;
use crate::scene::units::{stem_of_key, unit_of_key};
use crate::scene::{AllowedRange, Problem, Uncertain};
use slipmode_core::friction::{OperatingPoint, Parameters, Slider};
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;
use slipmode_core::stability::inverse::Unknown;

slipmode_algebra::named! {
    /// One of the seven inputs of the spring-slider, in the order of columns and options.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Quantity {
        /// a, dimensionless.
        DirectEffect = "direct_effect",
        /// b, dimensionless.
        EvolutionEffect = "evolution_effect",
        /// D_c, m.
        CriticalSlipDistance = "critical_slip_distance_m",
        /// K, Pa/m.
        Stiffness = "stiffness_pa_per_m",
        /// M, kg/m².
        MassPerArea = "mass_per_area_kg_per_m2",
        /// σ, Pa.
        NormalStress = "normal_stress_pa",
        /// V0, m/s.
        LoadingVelocity = "loading_velocity_m_per_s",
    }
}

impl From<Unknown> for Quantity {
    fn from(unknown: Unknown) -> Self {
        match unknown {
            Unknown::NormalStress => Self::NormalStress,
            Unknown::LoadingVelocity => Self::LoadingVelocity,
            Unknown::Stiffness => Self::Stiffness,
            Unknown::MassPerArea => Self::MassPerArea,
        }
    }
}

impl Quantity {
    /// Those of the material and the machine.
    pub const OF_THE_SLIDER: [Self; 5] = {
        let [a, b, d, k, m, ..] = Self::ALL;
        [a, b, d, k, m]
    };

    /// The name with its SI unit, as scene key and CSV column.
    #[must_use]
    pub fn key(self) -> &'static str {
        self.as_str()
    }

    /// Its symbols in formulas, as columns spell them in any case; a longer one before one with which it begins.
    #[must_use]
    pub fn symbols(self) -> &'static [&'static str] {
        match self {
            Self::DirectEffect => &["a"],
            Self::EvolutionEffect => &["b"],
            Self::CriticalSlipDistance => &["d_c", "dc"],
            Self::Stiffness => &["k"],
            Self::MassPerArea => &["m"],
            Self::NormalStress => &["sigma_n", "sigma"],
            Self::LoadingVelocity => &["v_0", "v0", "v"],
        }
    }

    /// The unit of SI.
    #[must_use]
    pub fn unit(self) -> &'static str {
        unit_of_key(self.key())
    }

    /// The value of a text: a number in SI, a fraction such as `1/3`, or a number with a unit, such as `8um`.
    ///
    /// # Errors
    /// When it is no number, not in the allowed range, or in a unit of another dimension.
    pub fn parse(self, text: &str) -> Result<Rational, Problem> {
        AllowedRange::PHYSICAL.parse_given(text, self.unit())
    }

    /// The key without its unit: what a column in other units still starts with.
    #[must_use]
    pub fn stem(self) -> &'static str {
        stem_of_key(self.key())
    }
}

/// `[parameters]`: the slider, and perhaps how it is driven.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParametersSection {
    /// a, b, D_c, K and M.
    pub slider: Slider<Rational>,
    /// σ, Pa; absent when the scene sweeps it.
    pub normal_stress_pa: Option<Rational>,
    /// V0, m/s; absent when the scene sweeps it.
    pub loading_velocity_m_per_s: Option<Rational>,
    /// All values within the error bars, when a value has one: those above are in the middle. σ and V0 are 1 where they are absent.
    pub error_bars: Option<ParameterBox>,
}

impl ParametersSection {
    /// The value of a quantity, when it is stated.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> Option<&Rational> {
        match quantity {
            Quantity::DirectEffect => Some(&self.slider.direct_effect),
            Quantity::EvolutionEffect => Some(&self.slider.evolution_effect),
            Quantity::CriticalSlipDistance => Some(&self.slider.critical_slip_distance_m),
            Quantity::Stiffness => Some(&self.slider.stiffness_pa_per_m),
            Quantity::MassPerArea => Some(&self.slider.mass_per_area_kg_per_m2),
            Quantity::NormalStress => self.normal_stress_pa.as_ref(),
            Quantity::LoadingVelocity => self.loading_velocity_m_per_s.as_ref(),
        }
    }

    /// The value of a quantity with its error bar, when it is stated.
    #[must_use]
    pub fn uncertain(&self, quantity: Quantity) -> Option<Uncertain> {
        let middle = self.value(quantity)?;
        let end = |of: fn(&ParameterBox) -> Parameters<Rational>| match &self.error_bars {
            Some(region) => <[Rational; 7]>::from(of(region))[quantity as usize].clone(),
            None => middle.clone(),
        };
        Some(Uncertain { lower: end(ParameterBox::lower), upper: end(ParameterBox::upper) })
    }

    /// The scene's own operating point, when the scene states both σ and V0.
    #[must_use]
    pub fn point(&self) -> Option<OperatingPoint<Rational>> {
        Some(OperatingPoint {
            normal_stress_pa: self.normal_stress_pa.clone()?,
            loading_velocity_m_per_s: self.loading_velocity_m_per_s.clone()?,
        })
    }
}

/// All of them, if none is missing.
pub fn all_of<T, const N: usize>(values: [Option<T>; N]) -> Option<[T; N]> {
    let all: Option<Vec<T>> = values.into_iter().collect();
    all?.try_into().ok()
}

/// The keys of `[parameters]`.
pub(crate) fn read_parameters(section: &mut Section<'_>) -> Option<ParametersSection> {
    let range = AllowedRange::PHYSICAL;
    let material = Quantity::OF_THE_SLIDER
        .map(|quantity| section.required(quantity.key(), &range.wanted())?.uncertain(range));
    let [stress, velocity] = [Quantity::NormalStress, Quantity::LoadingVelocity]
        .map(|quantity| section.optionally(quantity.key(), |entry| entry.uncertain(range)));
    let material = all_of(material)?;
    let middle = |value: &Option<Uncertain>| value.as_ref().map(Uncertain::middle);
    Some(ParametersSection {
        slider: Slider::from(material.each_ref().map(Uncertain::middle)),
        normal_stress_pa: middle(&stress),
        loading_velocity_m_per_s: middle(&velocity),
        error_bars: error_bars(material, [stress, velocity]),
    })
}

/// The box of the error bars; none where no value has one.
fn error_bars(material: [Uncertain; 5], place: [Option<Uncertain>; 2]) -> Option<ParameterBox> {
    let one = || Uncertain::certain(Rational::from(1));
    let [a, b, d, k, m] = material;
    let [s, v] = place.map(|value| value.unwrap_or_else(one));
    let values = [a, b, d, k, m, s, v];
    if values.iter().all(Uncertain::is_certain) {
        return None;
    }
    Uncertain::region(values)
}
