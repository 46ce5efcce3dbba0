//! Doubts about units: values that are as a lab writes them down, and far from what they are in SI.

use slipmode::number::Rational;
use slipmode::number::format::round_float;
use slipmode::scene::{Quantity, SceneParameters};

/// Effects beyond this are rather thousandths or per cent; measured ones are some thousandths to some hundredths.
const LARGEST_EFFECT: f64 = 0.5;

/// D_c beyond this is rather in µm, m: laboratories have 10^-7 to 10^-3 m.
const LARGEST_SLIP_DISTANCE_M: f64 = 0.1;

/// K below this is rather in MPa/mm or GPa/m, Pa/m: a table-top spring of 100 N/m on 100 cm² has 10^4 Pa/m.
const SMALLEST_STIFFNESS_PA_PER_M: f64 = 1e3;

/// What looks like another unit, a line each.
pub fn doubts(parameters: &SceneParameters) -> Vec<String> {
    let p = parameters;
    let doubts = [
        (&p.direct_effect, Quantity::DirectEffect, p.direct_effect > LARGEST_EFFECT, EFFECT),
        (&p.evolution_effect, Quantity::EvolutionEffect, p.evolution_effect > LARGEST_EFFECT, EFFECT),
        (
            &p.critical_slip_distance_m,
            Quantity::CriticalSlipDistance,
            p.critical_slip_distance_m > LARGEST_SLIP_DISTANCE_M,
            "looks like um (wanted: m)",
        ),
        (
            &p.stiffness_pa_per_m,
            Quantity::Stiffness,
            p.stiffness_pa_per_m < SMALLEST_STIFFNESS_PA_PER_M,
            "looks like MPa/mm (wanted: Pa/m)",
        ),
    ];
    doubts
        .into_iter()
        .filter(|(_, _, is_doubtful, _)| *is_doubtful)
        .map(|(value, quantity, _, looks)| format!("{} = {}: {looks}", quantity.key(), shown(value)))
        .collect()
}

const EFFECT: &str = "looks like thousandths (wanted: a plain number, such as 0.01)";

fn shown(value: &Rational) -> String {
    round_float(&rug::Float::with_val(64, value), 6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode::number::parse_decimal;

    fn doubted(values: [&str; 5]) -> Vec<String> {
        doubts(&SceneParameters::of_slider(values.map(|text| parse_decimal(text).unwrap())))
    }

    #[test]
    fn a_lab_books_units_are_doubted_each_and_those_of_si_never() {
        let said = doubted(["9", "12.6", "8", "2", "2400"]);
        for (said, part) in said.iter().zip([
            "direct_effect = 9: looks like thousandths",
            "evolution_effect = 12.6",
            "critical_slip_distance_m = 8: looks like um",
            "stiffness_pa_per_m = 2: looks like MPa/mm",
        ]) {
            assert!(said.starts_with(part), "{said}");
        }
        assert_eq!(said.len(), 4);
        assert!(doubted(["0.009", "0.0126", "8e-6", "2e9", "2400"]).is_empty());
        assert!(doubted(["0.02", "0.035", "1e-6", "1e4", "20"]).is_empty());
    }
}
