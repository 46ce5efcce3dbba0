//! What eqs 15, 16, 18 and 20 and the ends of the transition say for a slider, in words for the explorer.

use crate::explorer::{DIGITS, Varying};
use crate::scene::cited;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational, format::round_digits};
use slipmode_core::stability::{Arc, Asymptote, asymptote};

/// How many values [`formula_values`] gives.
pub(crate) const FORMULAS: usize = 8;

/// Working precision, in bits: far more than the digits that are shown.
const WORKING_BITS: u32 = 96;

/// What stands where a formula has no value, as eqs 15 and 18 for a = b.
const NONE: &str = "none";

/// What a formula says, between words that stay.
#[derive(Debug, Clone, serde::Serialize)]
pub struct FormulaRow {
    /// The formula's name.
    pub name: String,
    /// Words before the value.
    pub before: &'static str,
    /// The value.
    pub value: Varying,
    /// Its unit.
    pub unit: &'static str,
    /// Words before the limit of its range.
    pub where_before: &'static str,
    /// The limit.
    pub limit: Varying,
    /// Its unit.
    pub limit_unit: &'static str,
}

/// Eqs 15, 16, 18 and 20 (the latter two in m/s at 1 Pa), V0 at the upper and at the lower corner, σ_c and V_c.
pub(crate) fn formula_values(slider: &Slider<Rational>) -> [String; FORMULAS] {
    let balls = slider.map(|value| Ball::from_rational(value, WORKING_BITS));
    let text = |value: &Ball| round_digits(value.to_f64(), DIGITS);
    let has_upper = slider.direct_effect != slider.evolution_effect;
    let exists = |arc: Arc| arc == Arc::Lower || has_upper;
    let of = |formula: Asymptote| {
        if exists(formula.arc()) { text(&formula.value(&balls, &Ball::from(1))) } else { NONE.into() }
    };
    let corner = |arc: Arc| {
        if exists(arc) { text(&asymptote::corner(arc, &balls).loading_velocity_m_per_s) } else { NONE.into() }
    };
    let [upper, lower, inertial_upper, inertial_lower] = Asymptote::ALL.map(of);
    let (stress, velocity) = if slider.has_transition() {
        (text(&balls.critical_normal_stress_pa()), text(&balls.critical_velocity_m_per_s()))
    } else {
        (NONE.into(), NONE.into())
    };
    [upper, lower, inertial_upper, inertial_lower, corner(Arc::Upper), corner(Arc::Lower), stress, velocity]
}

/// The rows of the page's list of formulas; `value` gives the texts at a place of [`formula_values`].
pub(crate) fn rows(value: impl Fn(usize) -> Varying) -> Vec<FormulaRow> {
    let stress = |name: &str, at, where_before, limit| FormulaRow {
        name: cited(name),
        before: "σ = ",
        value: value(at),
        unit: " Pa",
        where_before,
        limit: value(limit),
        limit_unit: " m/s",
    };
    let velocity = |name: &str, at, where_before, limit| FormulaRow {
        name: cited(name),
        before: "V0 = ",
        value: value(at),
        unit: " m/s · σ/Pa",
        where_before,
        limit: value(limit),
        limit_unit: " Pa",
    };
    vec![
        stress("{quasi-static-upper}", 0, "V0 below ", 4),
        stress("{quasi-static-lower}", 1, "V0 below ", 5),
        velocity("{inertial-upper}", 2, "σ above ", 0),
        velocity("{inertial-lower}", 3, "σ below ", 1),
        stress("K = K_c ({critical-normal-stress})", 6, "ends at V0 = ", 7),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::parse_decimal;

    fn slider(a: &str, b: &str) -> Slider<Rational> {
        Slider::from([a, b, "1e-5", "1e7", "1000"].map(|text| parse_decimal(text).unwrap()))
    }

    #[test]
    fn square_effects_give_the_values_worked_out_by_hand() {
        // √a = 0.02, √b = 0.03, K D_c = 100 Pa, 2√(MK) = 2e5 Pa s/m; σ_c = 100/5e-4 Pa.
        let values = formula_values(&slider("0.0004", "0.0009"));
        let numbers: Vec<f64> = values.iter().take(7).filter_map(|text| text.parse().ok()).collect();
        assert_eq!(numbers, [1e6, 4e4, 2.5e-9, 2e-9, 2.5e-3, 8e-5, 2e5]);
    }

    #[test]
    fn equal_effects_have_no_upper_formulas_and_no_transition() {
        let values = formula_values(&slider("0.005", "0.005"));
        let none: Vec<usize> = (0..FORMULAS).filter(|&at| values[at] == NONE).collect();
        assert_eq!(none, [0, 2, 4, 6, 7]);
    }
}
