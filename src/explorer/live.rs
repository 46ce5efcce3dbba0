//! The map on which a reader changes all seven values: what its script evaluates, as polynomials and a table of slip modes.
//!
//! The script knows no equation. The groups are monomials of the parameters, what decides are polynomials of the groups, and the mode of
//! each combination of signs is listed: all of it is made here from the routines that decide in this program.

use serde::Serialize;
use serde_json::{Value, json};
use slipmode_algebra::{Polynomial, RationalFunction};
use slipmode_core::friction::{Groups, LEAST, MOST, OperatingPoint, Parameters};
use slipmode_core::number::Rational;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::stability::{
    DECIDING, InertialThreshold, SlipMode, deciding_quantities, slip_mode_of_signs,
};
use slipmode_plot::figure::zone_fill;

use super::{NamedPoint, Window};
use crate::scene::{ParametersSection, Quantity};

/// What the live map of a slider shows and evaluates.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveMap {
    /// The seven values.
    pub controls: Vec<LiveControl>,
    /// The slip modes with their colours.
    pub modes: Vec<LiveMode>,
    /// The model, the window and the points, as JSON.
    pub data: String,
}

/// A value that can be changed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveControl {
    /// The letter of its option on the command line.
    pub id: &'static str,
    /// What it is.
    pub name: &'static str,
    /// Its unit; may be empty.
    pub unit: &'static str,
    /// The scene's value.
    pub value: String,
    /// Its error bar as the command line reads it; empty where the scene has none.
    pub bar: String,
}

/// A slip mode on the map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveMode {
    /// Its name.
    pub name: &'static str,
    /// Its colour.
    pub fill: &'static str,
}

const CONTROLS: [[&str; 3]; 7] = [
    ["a", "Direct effect a", ""],
    ["b", "Evolution effect b", ""],
    ["d", "Critical slip distance D_c", "m"],
    ["k", "Stiffness K", "Pa/m"],
    ["m", "Mass per area M", "kg/m²"],
    ["s", "Normal stress σ", "Pa"],
    ["v", "Loading velocity V0", "m/s"],
];

/// Digits of a value: all that a person typed.
const DIGITS: usize = 17;

/// The live map of a scene's slider; the first point is the one that is moved first.
#[must_use]
pub fn live_map(
    parameters: &ParametersSection,
    points: &[NamedPoint],
    window: Window,
    threshold: &InertialThreshold,
) -> Option<LiveMap> {
    let values = Parameters { slider: parameters.slider.clone(), point: points.first()?.place.clone() };
    let decimal = |value: &Rational| rational_to_decimal(value, DIGITS);
    let controls = CONTROLS.iter().zip(<[Rational; 7]>::from(values)).zip(Quantity::ALL);
    let control = |(([id, name, unit], value), quantity): ((&[&'static str; 3], Rational), Quantity)| {
        let own = parameters.uncertain(quantity).filter(|own| !own.is_certain() && own.middle() == value);
        let bar = own.map(|own| format!("±{}", decimal(&(own.upper - &value))));
        LiveControl { id, name, unit, value: decimal(&value), bar: bar.unwrap_or_default() }
    };
    let places = points.iter().map(|point| {
        let OperatingPoint { normal_stress_pa, loading_velocity_m_per_s } = &point.place;
        json!([point.name, decimal(normal_stress_pa), decimal(loading_velocity_m_per_s)])
    });
    let mut data = model(threshold)?;
    // What is said of a point on the transition.
    data["neutral"] = "neutral".into();
    data["points"] = places.collect();
    data["limits"] = json!([LEAST, MOST]);
    data["window"] = json!({ "v": window.velocity, "s": window.stress });
    let modes = SlipMode::ALL.iter().enumerate();
    Some(LiveMap {
        controls: controls.map(control).collect(),
        modes: modes.map(|(style, mode)| LiveMode { name: mode.words(), fill: zone_fill(style) }).collect(),
        data: data.to_string(),
    })
}

/// Groups, polynomials and modes.
fn model(threshold: &InertialThreshold) -> Option<Value> {
    let letters = CONTROLS.map(|[id, ..]| id);
    let groups = Parameters::from(letters.map(RationalFunction::variable)).groups();
    let Groups { inertial_parameter, stiffness_group, effect_ratio } = groups;
    let exponents = |group: &RationalFunction| {
        letters.map(|letter| {
            let of = |part: &Polynomial| i64::from(part.degree(&slipmode_algebra::Symbol::from(letter)));
            of(group.numerator()) - of(group.denominator())
        })
    };
    let names = ["eta", "kappa", "beta"];
    let [eta, kappa, beta] = names.map(RationalFunction::variable);
    let of_parameters = [inertial_parameter, stiffness_group, effect_ratio];
    let of_names = Groups { inertial_parameter: eta, stiffness_group: kappa, effect_ratio: beta };
    let ratio = RationalFunction::constant(threshold.squared_ratio().clone());
    let quantities = deciding_quantities(&of_names, &ratio);
    Some(json!({
        "groups": of_parameters.each_ref().map(exponents),
        "polynomials": quantities.iter().map(|quantity| terms(quantity, names)).collect::<Option<Vec<_>>>()?,
        "modes": modes(),
    }))
}

/// Coefficient and exponents of each term, with a positive factor that makes the coefficients integers.
fn terms(quantity: &RationalFunction, names: [&'static str; 3]) -> Option<Value> {
    let scale = quantity.denominator().as_constant().filter(|constant| *constant > 0)?;
    let numerator = quantity.numerator();
    let common =
        numerator.terms().fold(rug::Integer::from(1), |common, (_, value)| common.lcm(value.denom()));
    let factor = Rational::from(common) / scale;
    let one = |(monomial, value): (&slipmode_algebra::Monomial, &Rational)| {
        let exponents = names.map(|name| monomial.exponent(&slipmode_algebra::Symbol::from(name)));
        json!([Rational::from(value * &factor).to_string(), exponents[0], exponents[1], exponents[2]])
    };
    Some(numerator.terms().map(one).collect())
}

/// The mode of each combination of signs, or the number after the last mode for a point on the transition, as `classify` says it: that of the first quantity has the weight 1, the next 3, and so on; −1, 0 and 1 are 0, 1 and 2.
fn modes() -> String {
    let mode = |place: usize| {
        let sign = |which: usize| (place / 3_usize.pow(which as u32) % 3) as i8 - 1;
        let signs: [i8; DECIDING] = std::array::from_fn(sign);
        if signs[0] == 0 {
            return SlipMode::ALL.len().to_string();
        }
        let mode = slip_mode_of_signs(signs);
        SlipMode::ALL.iter().position(|known| *known == mode).map_or_else(String::new, |at| at.to_string())
    };
    (0..3_usize.pow(DECIDING as u32)).map(mode).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use proptest::prelude::*;
    use slipmode_core::friction::ParameterBox;
    use slipmode_core::number::parse_decimal;
    use slipmode_core::stability::classify;

    fn found(data: &Value, values: &[Rational; 7]) -> usize {
        let power = |value: &Rational, exponent: i64| {
            let power = (0..exponent.abs()).fold(Rational::from(1), |power, _| power * value);
            if exponent < 0 { power.recip() } else { power }
        };
        let list = |value: &Value| value.as_array().unwrap().clone();
        let whole = |value: &Value| value.as_i64().unwrap();
        let group = |exponents: &Value| {
            let powers = list(exponents)
                .iter()
                .zip(values)
                .map(|(exponent, value)| power(value, whole(exponent)))
                .collect::<Vec<_>>();
            powers.into_iter().fold(Rational::from(1), |product, power| product * power)
        };
        let groups: Vec<Rational> = list(&data["groups"]).iter().map(group).collect();
        let value = |polynomial: &Value| {
            list(polynomial).iter().fold(Rational::new(), |sum, term| {
                let coefficient: Rational = term[0].as_str().unwrap().parse().unwrap();
                let powers = groups.iter().enumerate().map(|(at, group)| power(group, whole(&term[at + 1])));
                sum + powers.fold(coefficient, |product, power| product * power)
            })
        };
        let signs =
            list(&data["polynomials"]).iter().map(|one| value(one).cmp0() as i8 + 1).collect::<Vec<_>>();
        let place = signs.iter().rev().fold(0, |place, sign| place * 3 + *sign as usize);
        data["modes"].as_str().unwrap().as_bytes()[place].into()
    }

    proptest! {
        #[test]
        fn what_a_page_evaluates_gives_the_mode_of_the_program(exponents in [
            -3f64..-1.0, -3f64..-1.0, -6f64..-3.0, 5f64..9.0, 0f64..5.0, 3f64..8.0, -6f64..0.0,
        ]) {
            let threshold = InertialThreshold::default();
            let values = exponents.map(|exponent| parse_decimal(&format!("{:.4e}", libm::exp10(exponent))).unwrap());
            let mode = classify(&Parameters::from(values.clone()), &threshold).slip_mode;
            let expected = SlipMode::ALL.iter().position(|known| *known == mode).unwrap();
            prop_assert_eq!(found(&model(&threshold).unwrap(), &values), usize::from(b'0') + expected);
        }
    }

    #[test]
    fn the_values_stand_as_they_were_typed() {
        let point = NamedPoint {
            name: "A".into(),
            place: ["1e5", "1e-3"].map(|text| parse_decimal(text).unwrap()).into(),
            has_error_bars: false,
        };
        let window = Window { velocity: (1e-6, 1e-1), stress: (1e2, 1e8) };
        let [low, high] = ["1e4", "3e5"].map(|stress| Parameters {
            slider: paper(),
            point: [parse_decimal(stress).unwrap(), point.place.loading_velocity_m_per_s.clone()].into(),
        });
        let with_bars = ParametersSection {
            slider: paper(),
            normal_stress_pa: Some(parse_decimal("155000").unwrap()),
            loading_velocity_m_per_s: None,
            error_bars: ParameterBox::new(low, high),
        };
        let scene = NamedPoint {
            place: [parse_decimal("155000").unwrap(), parse_decimal("1").unwrap()].into(),
            ..point.clone()
        };
        let threshold = InertialThreshold::default();
        let bars = |first: &NamedPoint| {
            let live = live_map(&with_bars, std::slice::from_ref(first), window, &threshold).unwrap();
            live.controls.iter().map(|control| control.bar.clone()).collect::<String>()
        };
        // A value that is not the scene's has no error bar.
        assert_eq!((bars(&scene).as_str(), bars(&point).as_str()), ("±145000", ""));
        let live = live_map(&with_bars, &[point], window, &threshold).unwrap();
        let values: Vec<&str> = live.controls.iter().map(|control| control.value.as_str()).collect();
        assert_eq!(values, ["0.004", "0.006", "1e-5", "1e7", "1000", "100000", "0.001"]);
        assert_eq!(live.modes.len(), 6);
    }
}
