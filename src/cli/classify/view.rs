//! What `classify` says of one point: as text for people, as one JSON object for programs.

use rug::Float;
use serde_json::{Value, json};
use slipmode_core::friction::{Groups, Parameters};
use slipmode_core::number::format::{round_digits, round_float};
use slipmode_core::number::{Rational, Wide};
use slipmode_core::stability::{Classification, InertialThreshold, LogDistance, classify};

use crate::cli::classify::derived::Derived;
use crate::cli::classify::rows::slip_mode_word;
use crate::cli::inputs::{SCHEMA, inputs_json};
use crate::cli::roots::{PrintedRoot, print_roots};
use crate::cli::terminal;

/// Significant digits of the roots next to a classification: those of a 64-bit number.
const ROOT_DIGITS: u32 = 17;
/// Significant digits in the text for people.
const SHOWN_DIGITS: usize = 6;

/// A classified point with what surrounds it.
#[derive(Debug)]
pub struct PointView {
    inputs: Value,
    found: Classification,
    critical_stiffness_pa_per_m: Rational,
    groups: Groups<Rational>,
    stiffness_ratio: Option<Rational>,
    derived: Derived,
    to_transition: LogDistance,
    to_boundary: LogDistance,
    roots: Vec<PrintedRoot>,
}

impl PointView {
    /// Classifies the point.
    pub fn new(parameters: &Parameters<Rational>, threshold: &InertialThreshold) -> Self {
        let critical_stiffness_pa_per_m = parameters.critical_stiffness();
        let stiffness_ratio = (critical_stiffness_pa_per_m > 0)
            .then(|| Rational::from(&parameters.slider.stiffness_pa_per_m / &critical_stiffness_pa_per_m));
        let found = classify(parameters, threshold);
        Self {
            inputs: inputs_json(parameters),
            derived: Derived::of(parameters, &found),
            found,
            critical_stiffness_pa_per_m,
            groups: parameters.groups(),
            stiffness_ratio,
            to_transition: LogDistance::to_transition(parameters),
            to_boundary: LogDistance::to_boundary(parameters),
            roots: print_roots(parameters, ROOT_DIGITS),
        }
    }

    /// One object with the names of the CSV columns and more.
    pub fn json(&self) -> Value {
        let found = &self.found;
        json!({
            "schema": SCHEMA,
            "inputs": self.inputs,
            "transition_sign": found.transition_sign,
            "boundary_sign": found.boundary_sign,
            "spectral_class": found.spectral_class.as_str(),
            "slip_mode": slip_mode_word(found),
            "max_real_per_s": number(found.max_real_per_s),
            "max_imaginary_per_s": number(found.max_imaginary_per_s),
            "rung": found.precision_level.as_str(),
            "frequency_hz": self.derived.frequency_hz,
            "natural_angular_frequency_per_s": self.derived.natural_angular_frequency_per_s,
            "frequency_over_natural": self.derived.frequency_over_natural,
            "critical_stiffness_pa_per_m": nearest_number(&self.critical_stiffness_pa_per_m),
            "stiffness_over_critical": self.stiffness_ratio.as_ref().map(nearest_number),
            "transition_distance": distance_object(&self.to_transition),
            "boundary_distance": distance_object(&self.to_boundary),
            "groups": {
                "inertial_parameter": nearest_number(&self.groups.inertial_parameter),
                "stiffness_group": nearest_number(&self.groups.stiffness_group),
                "effect_ratio": nearest_number(&self.groups.effect_ratio),
            },
            "roots": self.roots.iter().map(PrintedRoot::json).collect::<Vec<_>>(),
        })
    }

    /// Lines of name, value and meaning.
    pub fn text(&self) -> String {
        let found = &self.found;
        let mut lines = vec![
            ("slip mode", slip_mode_word(found).to_string(), mode_words(found)),
            ("spectral class", found.spectral_class.as_str().to_string(), ""),
            ("sign of K - K_c", signed(found.transition_sign), transition_words(found.transition_sign)),
            ("sign of discriminant", signed(found.boundary_sign), boundary_words(found.boundary_sign)),
            ("max Re(s)", format!("{} 1/s", found.max_real_per_s), ""),
            ("max Im(s)", format!("{} 1/s", found.max_imaginary_per_s), ""),
            ("frequency", with_unit(self.derived.frequency_hz, " Hz"), "(max Im(s)/2 pi)"),
            (
                "omega / omega_n",
                with_unit(self.derived.frequency_over_natural, ""),
                "(max Im(s) over sqrt(K/M))",
            ),
            ("K_c", format!("{} Pa/m", shown(&self.critical_stiffness_pa_per_m)), "(eq 9)"),
            (
                "K / K_c",
                self.stiffness_ratio.as_ref().map_or_else(|| "-".into(), shown),
                if self.stiffness_ratio.is_some() { "" } else { "(a >= b: no transition)" },
            ),
            ("distance to K = K_c", distance_text(&self.to_transition), ""),
            ("distance to max Im(s) = 0", distance_text(&self.to_boundary), ""),
            ("eta, M V0^2/(sigma a D_c)", shown(&self.groups.inertial_parameter), ""),
            ("kappa, K D_c/(a sigma)", shown(&self.groups.stiffness_group), ""),
            ("beta, b/a", shown(&self.groups.effect_ratio), ""),
            ("decided by", found.precision_level.as_str().to_string(), ""),
        ];
        lines.extend(self.roots.iter().map(|root| ("root s", root.text(), "")));
        terminal::named_values(&lines)
    }
}

/// log10 of the factors by which σ at the same V0, or V0 at the same σ, would have to change.
fn distance_object(distance: &LogDistance) -> Value {
    json!({
        "log10_normal_stress": distance.normal_stress.map(number),
        "log10_loading_velocity": distance.loading_velocity.map(number),
    })
}

fn distance_text(distance: &LogDistance) -> String {
    let part = |distance: Option<Wide>, coordinate: &str| match distance {
        Some(distance) => {
            format!("{} decades in {coordinate}", round_float(&distance.to_float(), SHOWN_DIGITS))
        }
        None => format!("none in {coordinate}"),
    };
    format!("{}, {}", part(distance.normal_stress, "sigma"), part(distance.loading_velocity, "V0"))
}

fn transition_words(sign: i8) -> &'static str {
    match sign {
        1 => "(K > K_c: linearly stable)",
        0 => "(K = K_c: on the transition)",
        _ => "(K < K_c: linearly unstable)",
    }
}

/// What a mode without a name in the paper means.
fn mode_words(found: &Classification) -> &'static str {
    if found.transition_sign == 0 {
        "(neither grows nor decays: the linear theory does not decide)"
    } else {
        ""
    }
}

fn boundary_words(sign: i8) -> &'static str {
    match sign {
        1 => "(all roots real)",
        0 => "(on the boundary max Im(s) = 0)",
        _ => "(a complex pair)",
    }
}

fn signed(sign: i8) -> String {
    if sign > 0 { format!("+{sign}") } else { sign.to_string() }
}

/// A value as it is shown; a dash beyond the range of 64-bit numbers.
fn with_unit(value: Option<f64>, unit: &str) -> String {
    value.map_or_else(|| "-".into(), |value| format!("{}{unit}", round_digits(value, SHOWN_DIGITS)))
}

fn shown(value: &Rational) -> String {
    round_float(&Float::with_val(64, value), SHOWN_DIGITS)
}

/// A JSON number; a text beyond the range of 64-bit numbers, which JSON readers would turn into infinity or zero.
fn number(value: Wide) -> Value {
    value.to_f64().map_or_else(|| json!(value.to_string()), |value| json!(value))
}

/// The nearest 64-bit number.
fn nearest_number(value: &Rational) -> Value {
    number(Wide::from_float(&Float::with_val(53, value)))
}
