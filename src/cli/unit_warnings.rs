//! Warnings about units: values as a lab book has them, far from what they are in SI.

use slipmode::scene::Quantity;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::round_digits;

/// Loading velocities of laboratories end below this, m/s; one in um/s is written as 1 and more.
const FAST_M_PER_S: f64 = 1.0;
/// A kilogram on 1000 cm² has this mass per area; blocks of a laboratory have some kilograms on less.
const LIGHT_KG_PER_M2: f64 = 10.0;
/// Laboratories have 10^-7 to 10^-3 m.
const LONG_SLIP_M: f64 = 1e-3;
/// Heavier sliders than this are faults, which slip further.
const HEAVY_KG_PER_M2: f64 = 1e5;
/// A table-top spring of 100 N/m on 100 cm² has 10^4 Pa/m.
const SOFT_PA_PER_M: f64 = 1e3;
/// A kilogram on 500 cm².
const LOW_STRESS_PA: f64 = 200.0;
/// Measured effects are some thousandths to some hundredths.
const LARGE_EFFECT: f64 = 0.5;

/// What looks like another unit, a line each; `values` are those of [`Quantity::ALL`] in SI, as far as they are known, and
/// `with_unit` are quantities whose unit was given.
pub fn unit_warnings(values: [Option<f64>; 7], with_unit: &[Quantity]) -> Vec<String> {
    if is_dimensionless(&values) {
        return Vec::new();
    }
    let mass = values[Quantity::MassPerArea as usize];
    let warning = |(quantity, value): (Quantity, Option<f64>)| {
        let looks = looks_like(quantity, value?, mass)?;
        Some(format!("{} = {}: {looks}", quantity.as_str(), round_digits(value?, 6)))
    };
    let is_in_doubt = |(quantity, _): &(Quantity, Option<f64>)| !with_unit.contains(quantity);
    Quantity::ALL.into_iter().zip(values).filter(is_in_doubt).filter_map(warning).collect()
}

/// Whether D_c is the unit of length, and V0 and σ are units too where they are known: no lab book has such values.
fn is_dimensionless(values: &[Option<f64>; 7]) -> bool {
    let is_unit = |quantity: Quantity| values[quantity as usize].is_none_or(|value| value == 1.0);
    values[Quantity::CriticalSlipDistance as usize].is_some()
        && [Quantity::CriticalSlipDistance, Quantity::NormalStress, Quantity::LoadingVelocity]
            .into_iter()
            .all(is_unit)
}

/// [`unit_warnings`] of a whole slider.
pub fn slider_warnings(slider: Parameters<f64>) -> Vec<String> {
    let values: [f64; 7] = slider.into();
    unit_warnings(values.map(Some), &[])
}

/// Which other unit a value seems to have.
fn looks_like(quantity: Quantity, value: f64, mass: Option<f64>) -> Option<&'static str> {
    match quantity {
        Quantity::DirectEffect | Quantity::EvolutionEffect if value > LARGE_EFFECT => {
            Some("looks like thousandths (wanted: a plain number, such as 0.01)")
        }
        Quantity::CriticalSlipDistance if value >= 1.0 => Some("looks like um (wanted: m)"),
        Quantity::CriticalSlipDistance
            if value > LONG_SLIP_M && mass.is_none_or(|mass| mass < HEAVY_KG_PER_M2) =>
        {
            Some("looks like mm or um (wanted: m)")
        }
        Quantity::Stiffness if value < SOFT_PA_PER_M => Some("looks like MPa/mm or MPa/m (wanted: Pa/m)"),
        Quantity::MassPerArea if value < LIGHT_KG_PER_M2 => {
            Some("looks like kg (wanted: kg/m2, the mass per area of contact)")
        }
        Quantity::NormalStress if value < LOW_STRESS_PA => Some("looks like MPa (wanted: Pa)"),
        Quantity::LoadingVelocity if value >= FAST_M_PER_S => Some("looks like um/s (wanted: m/s)"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn warned(values: [f64; 7]) -> Vec<String> {
        unit_warnings(values.map(Some), &[])
    }

    #[test]
    fn a_lab_books_units_are_warned_of_each_and_those_of_si_never() {
        let wanted = [
            "direct_effect = 9: looks like thousandths",
            "evolution_effect = 12.6: looks like thousandths",
            "critical_slip_distance_m = 8: looks like um",
            "stiffness_pa_per_m = 2: looks like MPa/mm",
            "mass_per_area_kg_per_m2 = 5: looks like kg",
            "normal_stress_pa = 5: looks like MPa",
            "loading_velocity_m_per_s = 10: looks like um/s",
        ];
        let warnings = warned([9.0, 12.6, 8.0, 2.0, 5.0, 5.0, 10.0]);
        assert_eq!(warnings.len(), wanted.len(), "{warnings:?}");
        for (warning, part) in warnings.iter().zip(wanted) {
            assert!(warning.starts_with(part), "{warning}");
        }
        assert!(warned([0.009, 0.0126, 8e-6, 2e9, 2400.0, 5e6, 1e-5]).is_empty());
        assert!(warned([0.02, 0.035, 1e-6, 1e4, 20.0, 2.5e3, 1e-6]).is_empty());
        assert!(unit_warnings([None; 7], &[]).is_empty());
        let long = [0.009, 0.0126, 0.01, 2e9, 2400.0, 5e6, 1e-5].map(Some);
        assert_eq!(unit_warnings(long, &[]).len(), 1);
        assert!(unit_warnings(long, &[Quantity::CriticalSlipDistance]).is_empty(), "as 1cm");
        assert!(warned([1.0, 1.9, 1.0, 0.7, 0.3, 1.0, 1.0]).is_empty(), "dimensionless");
    }

    #[test]
    fn millimetres_are_told_from_the_slip_of_a_fault_by_its_mass() {
        let slip = |metres: f64, mass: f64| warned([0.009, 0.0126, metres, 2e9, mass, 5e6, 1e-5]);
        assert!(slip(0.01, 2400.0)[0].contains("looks like mm"));
        assert!(slip(0.01, 3e6).is_empty());
        assert!(slip(10.0, 3e6)[0].contains("looks like um"));
    }
}
