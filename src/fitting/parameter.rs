//! What is fitted.

use slipmode_core::dynamics::{DRIVEN_PARAMETERS, DrivenSlider};
use slipmode_core::friction::EvolutionLaw;

slipmode_algebra::named! {
    /// A parameter of a fit.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Parameter {
        /// a of eq 1.
        DirectEffect = "direct_effect",
        /// b of eq 1.
        EvolutionEffect = "evolution_effect",
        /// D_c of eqs 1-3, m.
        CriticalSlipDistance = "critical_slip_distance_m",
        /// K of eq 4, Pa/m.
        Stiffness = "stiffness_pa_per_m",
        /// μ0 of eq 1, at the velocity before the first step.
        ReferenceFriction = "reference_friction",
        /// A change of the friction in proportion to the displacement of the load point, 1/m.
        Drift = "drift_per_m",
    }
}

/// How many parameters there are.
pub const PARAMETERS: usize = 6;

/// Values of all parameters as the search has them: the logarithms of a, b, D_c and K, then μ0 and the drift.
pub type Point = [f64; PARAMETERS];

/// The symbol of each parameter, and its unit: empty for pure numbers.
const SYMBOLS: [&str; PARAMETERS] = ["a", "b", "D_c", "K", "mu_0", "drift"];
const UNITS: [&str; PARAMETERS] = ["", "", "m", "Pa/m", "", "1/m"];

impl Parameter {
    /// Whether the search has the logarithm: the value is positive.
    pub(crate) const fn is_logarithmic(self) -> bool {
        (self as usize) < 4
    }

    /// The value for a coordinate of the search.
    pub(crate) fn value(self, coordinate: f64) -> f64 {
        if self.is_logarithmic() { libm::exp(coordinate) } else { coordinate }
    }

    /// The value at a point.
    pub(crate) fn at(self, point: &Point) -> f64 {
        self.value(point[self as usize])
    }

    /// Its symbol.
    pub(crate) const fn symbol(self) -> &'static str {
        SYMBOLS[self as usize]
    }

    /// Its unit; empty for pure numbers.
    pub(crate) const fn unit(self) -> &'static str {
        UNITS[self as usize]
    }
}

/// The slider of a point.
#[must_use]
pub fn slider(point: &Point, mass_per_area_kg_per_m2: Option<f64>, law: EvolutionLaw) -> DrivenSlider {
    DrivenSlider {
        direct_effect: Parameter::DirectEffect.at(point),
        evolution_effect: Parameter::EvolutionEffect.at(point),
        critical_slip_distance_m: Parameter::CriticalSlipDistance.at(point),
        stiffness_pa_per_m: Parameter::Stiffness.at(point),
        reference_friction: Parameter::ReferenceFriction.at(point),
        mass_per_area_kg_per_m2,
        law,
    }
}

// The derivatives of a run are by the coordinates before the drift, in their order.
const _: () = assert!(DRIVEN_PARAMETERS + 1 == PARAMETERS);
