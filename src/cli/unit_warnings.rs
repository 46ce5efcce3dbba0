//! Warnings about units: values as a lab book has them, far from what they are in SI.

use rug::Float;
use slipmode::scene::Quantity;
use slipmode_core::number::Rational;
use slipmode_core::number::format::round_float;

/// A quantity, the values it has in SI, and what others look like.
type Usual = (Quantity, [f64; 2], &'static str);

const USUAL: [Usual; 5] = [
    (Quantity::DirectEffect, EFFECTS, THOUSANDTHS),
    (Quantity::EvolutionEffect, EFFECTS, THOUSANDTHS),
    // Laboratories have 10^-7 to 10^-3 m.
    (Quantity::CriticalSlipDistance, [0.0, 0.1], "looks like um (wanted: m)"),
    // A table-top spring of 100 N/m on 100 cm² has 10^4 Pa/m.
    (Quantity::Stiffness, [1e3, f64::MAX], "looks like MPa/mm (wanted: Pa/m)"),
    // A kilogram on 500 cm².
    (Quantity::NormalStress, [200.0, f64::MAX], "looks like MPa (wanted: Pa)"),
];

/// Measured effects are some thousandths to some hundredths.
const EFFECTS: [f64; 2] = [0.0, 0.5];
const THOUSANDTHS: &str = "looks like thousandths (wanted: a plain number, such as 0.01)";

/// What looks like another unit, a line each; `values` are those of [`Quantity::ALL`], or the first of them.
pub fn unit_warnings(values: &[&Rational]) -> Vec<String> {
    let warning = |(quantity, value): (Quantity, &&Rational)| {
        let (_, [from, to], looks) = USUAL.into_iter().find(|(usual, ..)| *usual == quantity)?;
        let shown = || round_float(&Float::with_val(64, *value), 6);
        (**value < from || **value > to).then(|| format!("{} = {}: {looks}", quantity.key(), shown()))
    };
    Quantity::ALL.into_iter().zip(values).filter_map(warning).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;

    fn warned<const N: usize>(values: [&str; N]) -> Vec<String> {
        let values = values.map(|text| parse_decimal(text).unwrap());
        unit_warnings(&values.each_ref())
    }

    #[test]
    fn a_lab_books_units_are_warned_of_each_and_those_of_si_never() {
        let wanted = [
            "direct_effect = 9: looks like thousandths",
            "evolution_effect = 12.6: looks like thousandths",
            "critical_slip_distance_m = 8: looks like um",
            "stiffness_pa_per_m = 2: looks like MPa/mm",
            "normal_stress_pa = 5: looks like MPa",
        ];
        let said = warned(["9", "12.6", "8", "2", "2400", "5", "1e-5"]);
        assert_eq!(said.len(), wanted.len(), "{said:?}");
        for (said, part) in said.iter().zip(wanted) {
            assert!(said.starts_with(part), "{said}");
        }
        assert!(warned(["0.009", "0.0126", "8e-6", "2e9", "2400"]).is_empty());
        assert!(warned(["0.02", "0.035", "1e-6", "1e4", "20", "2.5e3", "1e-6"]).is_empty());
    }
}
