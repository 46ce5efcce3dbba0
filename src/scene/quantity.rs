//! The seven physical inputs in a scene.

use crate::scene::section::Section;
use crate::scene::{AllowedRange, PlanePoint, Uncertain};
use slipmode_core::friction::{Parameters, Quantity, Slider};
use slipmode_core::number::Rational;
use slipmode_core::stability::ParameterBox;

/// Its symbols in formulas, as columns spell them in any case; a longer one before one with which it begins.
pub(crate) fn symbols(quantity: Quantity) -> &'static [&'static str] {
    match quantity {
        Quantity::DirectEffect => &["a"],
        Quantity::EvolutionEffect => &["b"],
        Quantity::CriticalSlipDistance => &["d_c", "dc"],
        Quantity::Stiffness => &["k"],
        Quantity::MassPerArea => &["m"],
        Quantity::NormalStress => &["sigma_n", "sigma"],
        Quantity::LoadingVelocity => &["v_0", "v0", "v"],
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
            Quantity::NormalStress => self.normal_stress_pa.as_ref(),
            Quantity::LoadingVelocity => self.loading_velocity_m_per_s.as_ref(),
            of_the_slider => self.slider.value(of_the_slider),
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
    pub fn point(&self) -> Option<PlanePoint> {
        all_of([self.normal_stress_pa.clone(), self.loading_velocity_m_per_s.clone()]).map(Into::into)
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
        .map(|quantity| section.required(quantity.as_str(), &range.wanted())?.uncertain(range));
    let [stress, velocity] = [Quantity::NormalStress, Quantity::LoadingVelocity]
        .map(|quantity| section.optionally(quantity.as_str(), |entry| entry.uncertain(range)));
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
    let [a, b, d, k, m] = material;
    let [s, v] = place.map(|value| value.unwrap_or_else(|| Uncertain::certain(Rational::from(1))));
    let values = [a, b, d, k, m, s, v];
    let has_bars = !values.iter().all(Uncertain::is_certain);
    has_bars.then(|| Uncertain::region(values)).flatten()
}
