//! A scene's own operating point: what it is in words, and its place on a map.

use crate::experiments::tolerance::words::scientific;
use crate::experiments::{Outcome, SceneOutcome};
use slipmode_core::friction::{OperatingPoint, Parameters};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::{Classification, Frequencies, OverBox, ParameterBox, classify, over_box};
use slipmode_plot::figure::{Axis, PointMark, Side};

/// Digits of a ratio or a frequency in the sentence.
const DIGITS: usize = 3;
/// Working precision of a coordinate, in bits.
const WORKING_BITS: u32 = 64;

/// What the first scene with an operating point is there, decided exactly: Markdown; `None` when no scene states one.
#[must_use]
pub fn operating_point_words(outcome: &Outcome) -> Option<String> {
    outcome.scenes.iter().find_map(|scene| {
        let (slider, point) = (scene.slider()?, point_of(scene)?);
        let parameters = Parameters { slider: slider.clone(), point };
        let threshold = scene.scene.threshold();
        let at_point = words(&parameters, &classify(&parameters, &threshold));
        let Some(region) = error_bars(scene) else { return Some(at_point) };
        let within = over_box(region, &threshold).map(|found| words_over_box(&found));
        let at_point = at_point.replacen("At", "at", 1);
        Some(format!("{}For the middle values, {at_point}", within.unwrap_or_default()))
    })
}

/// All values within the error bars of a scene's slider, when it has some.
pub(crate) fn error_bars(scene: &SceneOutcome) -> Option<&ParameterBox> {
    scene.scene.parameters.as_ref()?.error_bars.as_ref()
}

/// What is certain within the error bars and what is possible, decided exactly.
fn words_over_box(found: &OverBox) -> String {
    let stability = match found.transition_signs {
        [1, 1] => "certainly linearly stable",
        [-1, -1] => "certainly linearly unstable",
        _ => "linearly stable for some values and not for others",
    };
    let modes: Vec<&str> = found.slip_modes.iter().map(|possible| possible.what.words()).collect();
    let modes = match (modes.as_slice(), found.undecided.as_slice()) {
        ([mode], []) => format!("the slip mode is certainly {mode}"),
        (_, []) => format!("the possible slip modes are {}", modes.join(" and ")),
        (_, undecided) => {
            let open: Vec<&str> = undecided.iter().map(|(mode, _)| mode.words()).collect();
            format!(
                "the possible slip modes are {}; not decided: {}",
                modes.join(" and "),
                open.join(" and ")
            )
        }
    };
    format!("For all values within the error bars, the slider is {stability}, and {modes}. ")
}

fn words(parameters: &Parameters<Rational>, found: &Classification) -> String {
    let shown = |value: &Rational| scientific(&Ball::from_rational(value, WORKING_BITS), None);
    let point = &parameters.point;
    let place = format!(
        "At σ = {} Pa and V0 = {} m/s",
        shown(&point.normal_stress_pa),
        shown(&point.loading_velocity_m_per_s)
    );
    let stability = match found.transition_sign {
        1 => "linearly stable",
        0 => "on the transition",
        _ => "linearly unstable",
    };
    let critical = parameters.critical_stiffness();
    let ratio = Rational::from(&parameters.slider.stiffness_pa_per_m / &critical);
    let ratio = match critical > 0 {
        true => format!("K/K_c is {}", round_digits(nearest_f64(&ratio), DIGITS)),
        false => "there is no transition, because a ≥ b".into(),
    };
    let frequency = match Frequencies::of(parameters, found).frequency_hz.to_f64() {
        Some(hertz) if hertz > 0.0 => {
            format!("small disturbances oscillate with {} Hz", round_digits(hertz, DIGITS))
        }
        _ => "small disturbances do not oscillate".into(),
    };
    let mode = found.slip_mode.words();
    format!("{place} the slider is {stability}: {mode}; {ratio}, and {frequency}.")
}

fn point_of(scene: &SceneOutcome) -> Option<OperatingPoint<Rational>> {
    scene.scene.parameters.as_ref()?.point()
}

/// The scene's operating point as a mark on a map, its name towards the middle; none when the scene states none, or outside of the axes.
pub(crate) fn operating_point_mark(scene: &SceneOutcome, x: &Axis, y: &Axis) -> Option<PointMark> {
    let point = point_of(scene)?;
    let place = (nearest_f64(&point.loading_velocity_m_per_s), nearest_f64(&point.normal_stress_pa));
    let is_inside = (x.min..=x.max).contains(&place.0) && (y.min..=y.max).contains(&place.1);
    let is_right = place.0 > (x.min * x.max).sqrt();
    let side = if is_right { Side::Left } else { Side::Right };
    is_inside.then(|| PointMark::new("operating point", place, side))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::paper;
    use slipmode_core::number::parse_decimal;
    use slipmode_core::stability::InertialThreshold;

    #[test]
    fn what_is_certain_within_error_bars_is_said_so() {
        let said = |low: &str, high: &str| {
            let [low, high] = [low, high]
                .map(|stress| paper().at(parse_decimal(stress).unwrap(), parse_decimal("1e-3").unwrap()));
            let region = ParameterBox::new(low, high).unwrap();
            words_over_box(&over_box(&region, &InertialThreshold::default()).unwrap())
        };
        assert_eq!(
            said("9e4", "1e5"),
            "For all values within the error bars, the slider is certainly linearly unstable, and the slip mode is certainly stick-slip. "
        );
        assert!(
            said("2e4", "6e4")
                .contains("linearly stable for some values and not for others, and the possible")
        );
    }

    #[test]
    fn the_sentence_says_what_classify_finds() {
        let said = |stress: &str, velocity: &str| {
            let [stress, velocity] = [stress, velocity].map(|text| parse_decimal(text).unwrap());
            let parameters = paper().at(stress, velocity);
            words(&parameters, &classify(&parameters, &InertialThreshold::default()))
        };
        assert_eq!(
            said("1e5", "1e-3"),
            "At σ = $1\\times10^{5}$ Pa and V0 = $1\\times10^{-3}$ m/s the slider is linearly unstable: stick-slip; \
             K/K_c is 0.4, and small disturbances oscillate with 6.72 Hz."
        );
        assert!(said("1e3", "1e-5").contains("linearly stable: overdamped stable sliding"));
        assert!(said("1e3", "1e-5").ends_with("and small disturbances do not oscillate."));
    }
}
