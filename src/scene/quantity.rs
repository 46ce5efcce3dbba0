//! The seven physical inputs: their names in scenes, CSV files and on the command line.

use crate::scene::section::{Section, given};
use crate::scene::{AllowedRange, Faults};
use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::Rational;

/// One of the seven inputs of the spring-slider, in the order of the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// a, dimensionless.
    DirectEffect,
    /// b, dimensionless.
    EvolutionEffect,
    /// D_c, m.
    CriticalSlipDistance,
    /// K, Pa/m.
    Stiffness,
    /// M, kg/m².
    MassPerArea,
    /// σ, Pa.
    NormalStress,
    /// V0, m/s.
    LoadingVelocity,
}

impl Quantity {
    /// All seven, in the order of columns and options.
    pub const ALL: [Self; 7] = [
        Self::DirectEffect,
        Self::EvolutionEffect,
        Self::CriticalSlipDistance,
        Self::Stiffness,
        Self::MassPerArea,
        Self::NormalStress,
        Self::LoadingVelocity,
    ];

    /// The name with its SI unit, as scene key and CSV column.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Self::DirectEffect => "direct_effect",
            Self::EvolutionEffect => "evolution_effect",
            Self::CriticalSlipDistance => "critical_slip_distance_m",
            Self::Stiffness => "stiffness_pa_per_m",
            Self::MassPerArea => "mass_per_area_kg_per_m2",
            Self::NormalStress => "normal_stress_pa",
            Self::LoadingVelocity => "loading_velocity_m_per_s",
        }
    }

    /// The key without its unit: what a column in other units still starts with.
    #[must_use]
    pub fn stem(self) -> &'static str {
        match self {
            Self::DirectEffect | Self::EvolutionEffect => self.key(),
            Self::CriticalSlipDistance => "critical_slip_distance",
            Self::Stiffness => "stiffness",
            Self::MassPerArea => "mass_per_area",
            Self::NormalStress => "normal_stress",
            Self::LoadingVelocity => "loading_velocity",
        }
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
}

impl ParametersSection {
    /// The scene's own operating point, when the scene states both σ and V0.
    #[must_use]
    pub fn point(&self) -> Option<OperatingPoint<Rational>> {
        Some(OperatingPoint {
            normal_stress_pa: self.normal_stress_pa.clone()?,
            loading_velocity_m_per_s: self.loading_velocity_m_per_s.clone()?,
        })
    }
}

/// The keys of `[parameters]`.
pub(crate) fn read_parameters(section: &mut Section<'_>, faults: &mut Faults) -> Option<ParametersSection> {
    let range = AllowedRange::PHYSICAL;
    let mut required = |section: &mut Section<'_>, quantity: Quantity| {
        section.required(quantity.key(), &range.text(), faults).and_then(|entry| entry.decimal(range, faults))
    };
    let direct_effect = required(section, Quantity::DirectEffect);
    let evolution_effect = required(section, Quantity::EvolutionEffect);
    let critical_slip_distance = required(section, Quantity::CriticalSlipDistance);
    let stiffness = required(section, Quantity::Stiffness);
    let mass_per_area = required(section, Quantity::MassPerArea);
    let mut optional = |section: &mut Section<'_>, quantity: Quantity| {
        section.optional(quantity.key()).map(|entry| entry.decimal(range, faults))
    };
    let normal_stress = optional(section, Quantity::NormalStress);
    let loading_velocity = optional(section, Quantity::LoadingVelocity);
    Some(ParametersSection {
        slider: Slider {
            direct_effect: direct_effect?,
            evolution_effect: evolution_effect?,
            critical_slip_distance_m: critical_slip_distance?,
            stiffness_pa_per_m: stiffness?,
            mass_per_area_kg_per_m2: mass_per_area?,
        },
        normal_stress_pa: given(normal_stress)?,
        loading_velocity_m_per_s: given(loading_velocity)?,
    })
}
