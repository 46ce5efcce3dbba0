//! What follows from a classification: the frequency in Hz and relative to the natural one, and K_c.

use slipmode::csv::{Column, Datum};
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, Rational, nearest_f64};
use slipmode_core::stability::{Classification, Frequencies};

/// Each is the 64-bit number nearest to the exact one. Values beyond the range of 64-bit numbers are absent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derived {
    /// max Im(s)/2π, Hz; 0 exactly when no root is complex.
    pub frequency_hz: Option<f64>,
    /// K_c of eq 9, Pa/m.
    pub critical_stiffness_pa_per_m: Option<f64>,
    /// K/K_c; absent for a ≥ b, where K_c is not positive.
    pub stiffness_over_critical: Option<f64>,
    /// ω_n = √(K/M), 1/s.
    pub natural_angular_frequency_per_s: Option<f64>,
    /// max Im(s)/ω_n.
    pub frequency_over_natural: Option<f64>,
}

/// The columns that `classify --points` appends last.
pub const COLUMNS: [Column<Derived>; 4] = [
    ("frequency_hz", |found| Datum::Number(found.frequency_hz)),
    ("critical_stiffness_pa_per_m", |found| Datum::Number(found.critical_stiffness_pa_per_m)),
    ("stiffness_over_critical", |found| Datum::Number(found.stiffness_over_critical)),
    ("frequency_over_natural", |found| Datum::Number(found.frequency_over_natural)),
];

/// The relative error of K_c in double-double beyond that of b − a, and of K/K_c: η has one of at most 12 units, and six more
/// inputs and operations follow.
const CRITICAL_ERROR: f64 = 24.0 * Dd::UNIT;

impl Derived {
    /// From the exact values.
    pub fn of(parameters: &Parameters<Rational>, found: &Classification) -> Self {
        Self::new(parameters, &Frequencies::of(parameters, found))
    }

    /// From the exact values, where the frequencies are known.
    pub fn new(parameters: &Parameters<Rational>, frequencies: &Frequencies) -> Self {
        let critical = parameters.critical_stiffness();
        let ratio = (critical > 0).then(|| Rational::from(&parameters.slider.stiffness_pa_per_m / &critical));
        let ratio = ratio.as_ref().map(nearest_f64);
        Self::rounded(nearest_f64(&critical), ratio, frequencies)
    }

    /// From values in double-double; none where they do not decide how a number is rounded.
    pub fn quickly(parameters: &Parameters<Dd>, found: &Classification) -> Option<Self> {
        let slider = &parameters.slider;
        let difference = slider.effect_difference().hi();
        let sum = slider.direct_effect.hi() + slider.evolution_effect.hi();
        // The inputs' own errors, and that of the difference itself.
        let of_difference = (2.0 * sum / difference.abs() + 1.0) * Dd::UNIT;
        let error = of_difference + CRITICAL_ERROR;
        let critical = parameters.critical_stiffness();
        let ratio = (slider.stiffness_pa_per_m / critical).rounded_surely(error)?;
        let critical = critical.rounded_surely(error)?;
        let ratio = (difference > 0.0).then_some(ratio);
        Some(Self::rounded(critical, ratio, &Frequencies::quickly(parameters, found)?))
    }

    fn rounded(critical: f64, ratio: Option<f64>, frequencies: &Frequencies) -> Self {
        let in_range = |value: f64| (value == 0.0 || value.is_normal()).then_some(value);
        Self {
            frequency_hz: frequencies.frequency_hz.to_f64(),
            critical_stiffness_pa_per_m: in_range(critical),
            stiffness_over_critical: ratio.filter(|ratio| ratio.is_normal()),
            natural_angular_frequency_per_s: frequencies.natural_angular_frequency_per_s.to_f64(),
            frequency_over_natural: frequencies.frequency_over_natural.to_f64(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;
    use slipmode_core::stability::{InertialThreshold, classify};

    #[test]
    fn double_double_gives_what_the_exact_values_give() {
        for (values, is_quick) in [
            (["0.004", "0.006", "1e-5", "1e7", "1000", "1e5", "1e-3"], true),
            (["0.009", "0.0126", "8e-6", "2e9", "2400", "5e6", "1e-5"], true),
            (["0.006", "0.004", "1e-5", "1e7", "1000", "1e5", "1e-3"], true),
            (["0.004", "0.00400000000000001", "1e-5", "1e7", "1000", "1e5", "1e-3"], false),
            (["0.004", "0.004", "1e-5", "1e7", "1000", "1e5", "1e-3"], false),
            (["0.004", "0.006", "1e-5", "1e7", "1000", "1e3", "1e-5"], true),
        ] {
            let exact = Parameters::from(values.map(|text| parse_decimal(text).unwrap()));
            let found = classify(&exact, &InertialThreshold::default());
            let wanted = Derived::of(&exact, &found);
            let quick = Derived::quickly(&exact.map(Dd::from_rational), &found);
            // Where a and b agree in too many digits, b − a is not known well enough.
            assert_eq!(quick.is_some(), is_quick, "{values:?}");
            assert!(quick.is_none_or(|quick| quick == wanted), "{values:?}");
            assert_eq!(wanted.stiffness_over_critical.is_some(), exact.critical_stiffness() > 0);
        }
    }
}
