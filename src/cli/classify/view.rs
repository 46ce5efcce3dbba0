//! The answer of `classify` for one point.

use serde_json::{Value, json};
use slipmode::scene::cited;
use slipmode_core::friction::Parameters;
use slipmode_core::number::format::round_float;
use slipmode_core::number::{Rational, Wide};
use slipmode_core::stability::{Classification, Frequencies, InertialThreshold, LogDistance, classify};

use crate::cli::answer::{Answer, Item, SHOWN_DIGITS, wide};
pub use crate::cli::classify::derived::Derived;
use crate::cli::classify::rows::slip_mode_word;
use crate::cli::inputs::inputs_json;
use crate::cli::roots::{PrintedRoot, print_roots};

/// Significant digits of the roots next to a classification: those of a 64-bit number.
const ROOT_DIGITS: u32 = 17;

/// A point with its class and its frequency.
#[derive(Debug)]
pub struct ClassifiedPoint {
    parameters: Parameters<Rational>,
    found: Classification,
    frequencies: Frequencies,
}

impl ClassifiedPoint {
    /// Classifies a point.
    pub fn new(parameters: Parameters<Rational>, threshold: &InertialThreshold) -> Self {
        let found = classify(&parameters, threshold);
        let frequencies = Frequencies::of(&parameters, &found);
        Self { parameters, found, frequencies }
    }

    /// The slip mode as a word.
    pub fn slip_mode(&self) -> &'static str {
        slip_mode_word(&self.found)
    }

    /// The object that `classify --json` prints.
    pub fn json(&self) -> Value {
        self.answer().json()
    }

    /// All that `classify` says of the point; the keys are the names of the CSV columns and more.
    pub(in crate::cli) fn answer(&self) -> Answer {
        let Self { parameters, found, frequencies } = self;
        let derived = Derived::new(parameters, frequencies);
        let groups = parameters.groups();
        let critical = parameters.critical_stiffness();
        let ratio = (critical > 0).then(|| Rational::from(&parameters.slider.stiffness_pa_per_m / &critical));
        let without_ratio = if ratio.is_some() { "" } else { "(a >= b: no transition)" };
        let over_natural = Item::rounded(derived.frequency_over_natural, "");
        let roots = print_roots(parameters, ROOT_DIGITS);
        let in_groups = Answer::default()
            .item("inertial_parameter", "eta, M V0^2/(sigma a D_c)", &groups.inertial_parameter)
            .item("stiffness_group", "kappa, K D_c/(a sigma)", &groups.stiffness_group)
            .item("effect_ratio", "beta, b/a", &groups.effect_ratio);
        let [to_transition, to_boundary] =
            [LogDistance::to_transition, LogDistance::to_boundary].map(|of| distance(&of(parameters)));
        Answer::to(inputs_json(parameters))
            .item("slip_mode", "slip mode", slip_mode_word(found))
            .note(mode_words(found))
            .item("spectral_class", "spectral class", found.spectral_class.as_str())
            .item("transition_sign", "sign of K - K_c", found.transition_sign)
            .note(transition_words(found.transition_sign))
            .item("boundary_sign", "sign of discriminant", found.boundary_sign)
            .note(boundary_words(found.boundary_sign))
            .text("\n")
            .item("max_real_per_s", "max Re(s)", Item::from(found.max_real_per_s).in_unit("1/s"))
            .item("max_imaginary_per_s", "max Im(s)", Item::from(found.max_imaginary_per_s).in_unit("1/s"))
            .item("frequency_hz", "frequency", Item::rounded(derived.frequency_hz, " Hz"))
            .note("(max Im(s)/2 pi)")
            .item("frequency_over_natural", "omega / omega_n", over_natural)
            .note("(max Im(s) over sqrt(K/M))")
            .with("natural_angular_frequency_per_s", derived.natural_angular_frequency_per_s)
            .item("critical_stiffness_pa_per_m", "K_c", Item::from(&critical).in_unit("Pa/m"))
            .note(&cited("({transition})"))
            .item("stiffness_over_critical", "K / K_c", ratio.as_ref())
            .note(without_ratio)
            .item("transition_distance", "distance to K = K_c", to_transition)
            .item("boundary_distance", "distance to max Im(s) = 0", to_boundary)
            .text("\n")
            .part("groups", in_groups)
            .item("rung", "decided by", found.precision_level.as_str())
            .list("roots", roots.iter().map(|root| PrintedRoot::answer(root).named("root s", &root.text())))
    }
}

/// log10 of the factors by which σ at the same V0, or V0 at the same σ, would have to change.
fn distance(distance: &LogDistance) -> Item {
    let part = |distance: Option<Wide>, coordinate: &str| match distance {
        Some(distance) => {
            format!("{} decades in {coordinate}", round_float(&distance.to_float(), SHOWN_DIGITS))
        }
        None => format!("none in {coordinate}"),
    };
    let LogDistance { normal_stress, loading_velocity } = distance;
    Item::new(
        json!({
            "log10_normal_stress": normal_stress.map(wide),
            "log10_loading_velocity": loading_velocity.map(wide),
        }),
        format!("{}, {}", part(*normal_stress, "sigma"), part(*loading_velocity, "V0")),
    )
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
