//! The scene of a new report: the slider as it was typed, and what is computed for it.

use slipmode::scene::{Quantity, Sliders, Uncertain, cited, parse_value, with_unit};
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{exact_text, round_digits};
use slipmode_core::number::{Rational, nearest_f64};

use crate::cli::new::ranges::{Decades, OwnRange, Ranges};
use crate::cli::options::{SliderOptions, has_unit};

/// What was typed, valid.
#[derive(Debug)]
pub struct Typed {
    /// The report's name.
    pub name: String,
    /// The numbers.
    pub slider: SliderOptions,
    /// Whether the numbers are the paper's because none were given.
    pub is_example: bool,
    /// The slider with its operating range, where an operating point was given.
    pub own: Option<Own>,
    /// The record that the values were fitted to.
    pub fitted: Option<Fitted>,
}

/// A record of velocity steps, for a laboratory's report.
#[derive(Debug)]
pub struct Fitted {
    /// The text of `[fit]`.
    pub section: String,
    /// The record as CSV.
    pub record: String,
}

impl Typed {
    /// The text of a quantity.
    pub fn text(&self, quantity: Quantity) -> &str {
        self.slider.text(quantity).unwrap_or_default()
    }

    /// The value of a quantity in SI: as it was typed, unless it has a unit.
    pub fn in_si(&self, quantity: Quantity) -> String {
        let text = self.text(quantity);
        if Uncertain::is_meant(text) {
            let ends = Uncertain::of(quantity, text).ok().filter(|_| has_unit(text));
            let range =
                ends.map(|ends| format!("{} to {}", exact_text(&ends.lower), exact_text(&ends.upper)));
            return range.unwrap_or_else(|| text.to_string());
        }
        let converted = with_unit(text).and_then(|_| parse_value(quantity, text).ok());
        converted.map_or_else(|| text.to_string(), |value| exact_text(&value))
    }
}

/// Points of a map along V and along σ.
const MAP_POINTS: (i32, i32) = (141, 121);

/// The text of `scenes/NAME.toml`.
pub fn scene_text(typed: &Typed, effects: Sliders, ranges: &Ranges) -> String {
    let name = &typed.name;
    let map = rectangle(ranges.velocity, ranges.stress, MAP_POINTS);
    let (velocity, stress) = (ranges.simulated_velocity, ranges.simulated_stress);
    let runs = rectangle(velocity, stress, ranges.simulated_points());
    let coarser = match ranges.points_less {
        0 => "",
        _ => {
            "# With finer grids, a run next to the boundary failed, and claims about every run need all runs.\n"
        }
    };
    let head = [
        format!(
            "# Computations for this slider. Delete a section to leave out its computation. Every key is checked.\n# \
                Decimals are exact: 0.004 is 1/250. All units are SI.\nname = \"{name}\"\ntitle = \"{name}\"\n"
        ),
        parameters(typed),
    ]
    .join("\n");
    let points = typed.own.as_ref().map(Own::points);
    let template = if points.is_some() { LABORATORY } else { WHOLE_BOUNDARY };
    let parts = [
        ("{frequency}", frequency(effects, ranges.velocity)),
        ("{map}", map),
        ("{points}", points.unwrap_or_default()),
        ("{coarser}", coarser.into()),
        ("{runs}", runs),
    ];
    let rest = parts.iter().fold(template.to_owned(), |text, (key, part)| text.replace(key, part));
    let fitted = typed.fitted.as_ref().map_or("", |fitted| &fitted.section);
    cited(&format!("{head}{rest}{fitted}"))
}

fn parameters(typed: &Typed) -> String {
    let source = match typed.is_example {
        true => "# No values were given; these are the paper's values. Replace them by yours.\n",
        false => "# As typed.\n",
    };
    let meaning: [&str; 7] = [
        "a of {friction}",
        "b of {friction}",
        "D_c",
        "K: stiffness of machine and specimen, shear stress per slip",
        "M: moving mass per area of contact",
        "σ of the operating point",
        "V0 of the operating point",
    ];
    let line = |(quantity, meaning): (Quantity, &str)| {
        let text = typed.slider.text(quantity)?;
        Some(format!("{} = {}  # {meaning}\n", quantity.as_str(), toml_number(text)))
    };
    let lines: String = Quantity::ALL.into_iter().zip(meaning).filter_map(line).collect();
    format!("{source}[parameters]\n{lines}")
}

fn frequency(effects: Sliders, velocity: Decades) -> String {
    match effects {
        Sliders::Weakening => {
            let [from, to] = velocity.decimals();
            format!(
            "# max Im(s) along lines of constant normal stress, in units of the critical one ({{critical-normal-stress}}).\n\
             [frequency]\nnormal_stress_over_critical = [\"1/3\", 1, 3]\n\
             loading_velocity_m_per_s = {{ from = {from}, to = {to}, points = 121 }}\n"
            )
        }
        Sliders::Neutral | Sliders::Strengthening => {
            "# [frequency] is left out: it needs the critical normal stress of {critical-normal-stress}, which exists for a < b only.\n".into()
        }
    }
}

fn rectangle(velocity: Decades, stress: Decades, (columns, rows): (i32, i32)) -> String {
    let ([slow, fast], [low, high]) = (velocity.decimals(), stress.decimals());
    format!(
        "loading_velocity_m_per_s = {{ from = {slow}, to = {fast}, points = {columns} }}\n\
         normal_stress_pa = {{ from = {low}, to = {high}, points = {rows} }}\n"
    )
}

/// The sections of a scene that shows all corners of the boundary.
const WHOLE_BOUNDARY: &str = include_str!("../../../templates/new/scene.toml");
/// The sections of a scene about an operating point.
const LABORATORY: &str = include_str!("../../../templates/new/laboratory/scene.toml");

/// A slider with its operating range.
#[derive(Debug)]
pub struct Own {
    /// The slider.
    pub slider: Slider<Rational>,
    /// Normal stresses and loading velocities.
    pub ranges: [OwnRange; 2],
}

/// How far the load point moves in a run, in D_c, and how many natural periods a run has, at least.
const RUN: [f64; 2] = [100.0, 10.0];

impl Own {
    /// The points of `[trajectories]`: the operating point, and those with one coordinate at an end of its range.
    fn points(&self) -> String {
        let [[low, stress, high], [slow, velocity, fast]] = &self.ranges;
        let points = [
            ("operating-point", stress, velocity),
            ("lower-stress", low, velocity),
            ("higher-stress", high, velocity),
            ("slower", stress, slow),
            ("faster", stress, fast),
        ];
        points.into_iter().map(|(id, stress, velocity)| self.point(id, stress, velocity)).collect()
    }

    fn point(&self, id: &str, stress: &Rational, velocity: &Rational) -> String {
        let slider = self.slider.map(nearest_f64);
        let at = slider.at(nearest_f64(stress), nearest_f64(velocity));
        // A cycle of stick-slip is longer in proportion to K_c/K.
        let cycles = (at.critical_stiffness_quasi_static() / slider.stiffness_pa_per_m).max(1.0);
        let natural = std::f64::consts::TAU / slider.natural_angular_frequency_per_s();
        let duration = (RUN[0] * cycles / at.rate_per_s()).max(RUN[1] * natural);
        let [stress, velocity] = [stress, velocity].map(|value| toml_number(&exact_text(value)));
        let duration = round_digits(duration, 2);
        format!(
            "[[trajectories.point]]\nid = \"{id}\"\nnormal_stress_pa = {stress}\nloading_velocity_m_per_s = {velocity}\n\
             laws = [\"slip\", \"aging\"]\nduration_s = {duration}\n"
        )
    }
}

/// A number as typed: bare where TOML has it as a number, otherwise between quotes, which scenes read alike.
fn toml_number(text: &str) -> String {
    if is_toml_number(text) { text.to_string() } else { format!("\"{text}\"") }
}

/// `[+-]digits[.digits][e[+-]digits]` without a leading zero before another digit, and short enough for any reader.
fn is_toml_number(text: &str) -> bool {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.strip_prefix(['+', '-']).unwrap_or(exponent)),
        None => (unsigned, "0"),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let leading_zero = whole.len() > 1 && whole.starts_with('0');
    // Whole numbers of more digits may be refused by other readers of the file.
    digits(whole) && digits(fraction) && digits(exponent) && !leading_zero && text.len() < 18
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_stands_as_typed_and_quoted_only_where_toml_needs_it() {
        for bare in ["0.004", "10e-6", "1E+7", "1000", "+5", "0"] {
            assert_eq!(toml_number(bare), bare);
        }
        for quoted in [".004", "1.", "007", "1000000000000000000000", "1.e5"] {
            assert_eq!(toml_number(quoted), format!("\"{quoted}\""));
        }
    }
}
