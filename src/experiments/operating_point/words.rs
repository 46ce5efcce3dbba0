//! A scene's own operating point in sentences, each decided exactly: its slip mode, the lines next to it, what leaves the mode, and
//! which error bar decides it.

use super::error_bars::Bar;
use super::reach::{DIGITS, digits_of_factor, in_words, range_in_words, reach};
use super::run::{Change, OperatingPointOutcome};
use crate::experiments::{Outcome, SceneOutcome};
use crate::scene::{Quantity, unit_of};
use slipmode_core::friction::{OperatingPoint, Parameters};
use slipmode_core::number::format::{Side, round_digits, rounded};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::inverse::Target;
use slipmode_core::stability::{
    Classification, Frequencies, InertialThreshold, ParameterBox, SlipMode, classify, over_box,
};

/// The first scene with an operating point, and this point.
pub(crate) fn first_point(outcome: &Outcome) -> Option<(&SceneOutcome, Parameters<Rational>)> {
    outcome.scenes.iter().find_map(|scene| {
        Some((scene, Parameters { slider: scene.slider()?.clone(), point: point_of(scene)? }))
    })
}

pub(super) fn point_of(scene: &SceneOutcome) -> Option<OperatingPoint<Rational>> {
    scene.scene.parameters.as_ref()?.point()
}

/// All values within the error bars of a scene's slider, when it has some.
pub(crate) fn error_bars(scene: &SceneOutcome) -> Option<&ParameterBox> {
    scene.scene.parameters.as_ref()?.error_bars.as_ref()
}

/// The first outcome of a section `[operating_point]`, and its scene.
fn found(outcome: &Outcome) -> Option<(&SceneOutcome, &OperatingPointOutcome)> {
    outcome.scenes.iter().find_map(|scene| Some((scene, scene.operating_point.as_ref()?)))
}

/// The name of a value with its symbol.
pub(super) fn name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::DirectEffect => "direct effect a",
        Quantity::EvolutionEffect => "evolution effect b",
        Quantity::CriticalSlipDistance => "critical slip distance D_c",
        Quantity::Stiffness => "stiffness K",
        Quantity::MassPerArea => "mass per area M",
        Quantity::NormalStress => "normal stress σ",
        Quantity::LoadingVelocity => "loading velocity V0",
    }
}

/// Slip modes in words, the last one behind `or`.
pub(super) fn mode_list(modes: &[SlipMode]) -> String {
    modes.iter().map(|mode| mode.words()).collect::<Vec<_>>().join(" or ")
}

/// What the first scene with an operating point is there: Markdown; `None` when no scene states one.
pub(crate) fn operating_point_words(outcome: &Outcome) -> Option<String> {
    let (scene, parameters) = first_point(outcome)?;
    let threshold = scene.scene.threshold();
    let at_point = classify(&parameters, &threshold);
    let within = error_bars(scene).and_then(|region| words_over_box(region, &threshold, &at_point));
    let OperatingPoint { normal_stress_pa, loading_velocity_m_per_s } = &parameters.point;
    let [stress, velocity] = [(normal_stress_pa, "Pa"), (loading_velocity_m_per_s, "m/s")]
        .map(|(value, unit)| in_words(nearest_f64(value), unit));
    let within = within.unwrap_or_else(|| format!("the slip mode is {}:", at_point.slip_mode.words()));
    Some(format!("At {stress} and {velocity}, {within} {}", words(&parameters, &at_point)))
}

/// The slip modes that are possible within the error bars; the beginning of a sentence on the middle values follows.
fn words_over_box(
    region: &ParameterBox,
    threshold: &InertialThreshold,
    at_point: &Classification,
) -> Option<String> {
    let found = over_box(region, threshold)?;
    if let Some(mode) = found.certain_mode() {
        let of_all = "for all values within the error bars";
        return Some(format!("the slip mode is {}, {of_all}. With the middle values,", mode.words()));
    }
    let modes: Vec<SlipMode> = found.slip_modes.iter().map(|possible| possible.what).collect();
    let open: Vec<SlipMode> = found.undecided.iter().map(|(mode, _)| *mode).collect();
    let open = if open.is_empty() { String::new() } else { format!("; not decided: {}", mode_list(&open)) };
    Some(format!(
        "the slip mode is {}, depending on the values within the error bars{open}. With the middle values it is {}:",
        mode_list(&modes),
        at_point.slip_mode.words()
    ))
}

fn words(parameters: &Parameters<Rational>, found: &Classification) -> String {
    let stability = match found.transition_sign {
        1 => "linearly stable",
        0 => "on the transition",
        _ => "linearly unstable",
    };
    let critical = parameters.critical_stiffness();
    let ratio = match critical > 0 {
        true => {
            let ratio = nearest_f64(&Rational::from(&parameters.slider.stiffness_pa_per_m / &critical));
            format!("K/K_c is {}", round_digits(ratio, digits_of_factor(ratio)))
        }
        false => "there is no transition, because a ≥ b".into(),
    };
    let frequency = match Frequencies::of(parameters, found).frequency_hz.to_f64() {
        Some(hertz) if hertz > 0.0 => {
            format!("small disturbances oscillate with {} Hz", round_digits(hertz, DIGITS))
        }
        _ => "small disturbances do not oscillate".into(),
    };
    format!("sliding is {stability} ({ratio}), and {frequency}.")
}

/// Where sliding is unstable and where small disturbances oscillate, along the normal stress.
pub(crate) fn range_words(outcome: &Outcome) -> Option<String> {
    let (scene, found) = found(outcome)?;
    let (_, parameters) = first_point(outcome)?;
    let point = &parameters.point;
    let stress = nearest_f64(&point.normal_stress_pa);
    let at_point = classify(&parameters, &scene.scene.threshold());
    let of = |is_transition: bool| {
        let is_such = move |target: &Target| (*target != Target::Boundary) == is_transition;
        found.limits.iter().filter(move |(target, _)| is_such(target)).map(|(_, range)| *range)
    };
    let place = |range: [f64; 2]| range_in_words(Quantity::NormalStress, range);
    let [least, most] = reach(Quantity::NormalStress);
    let within_reach = |[low, high]: &[f64; 2]| *low <= most && *high >= least;
    let stability = match of(true).find(within_reach) {
        Some(range) => format!("unstable above {}", place(range)),
        None if at_point.transition_sign < 0 => "unstable at every normal stress within reach".into(),
        None => "stable at every normal stress within reach".into(),
    };
    // A boundary belongs to the side on which its middle is.
    let is_above = |range: &[f64; 2]| range[0] * range[1] > stress * stress;
    let [mut below, mut above] = [false, true]
        .map(|side| of(false).filter(move |range| is_above(range) == side && within_reach(range)));
    let [here, there] =
        if at_point.boundary_sign < 0 { ["oscillate", "stop"] } else { ["do not oscillate", "begin"] };
    // From the nearest boundary to the next one, where there is one.
    let sides = [("below", below.next_back(), below.next_back()), ("above", above.next(), above.next())];
    let sides = sides.into_iter().filter_map(|(side, nearest, next)| {
        let Some(next) = next else { return Some(format!("{side} {}", place(nearest?))) };
        let [low, high] = if side == "below" { [next, nearest?] } else { [nearest?, next] };
        Some(format!("between {} and {}", place(low), place(high)))
    });
    let sides = sides.collect::<Vec<_>>();
    let oscillation = match sides.is_empty() {
        true => format!("small disturbances {here} at any of them"),
        false => format!("small disturbances {there} oscillating {}", sides.join(" and ")),
    };
    let velocity = in_words(nearest_f64(&point.loading_velocity_m_per_s), "m/s");
    Some(format!("At {velocity}, sliding is {stability}; {oscillation}."))
}

/// The smallest single change that leaves the slip mode.
pub(crate) fn what_leaves_words(outcome: &Outcome) -> Option<String> {
    let (_, found) = found(outcome)?;
    let factor = |change: &Change| change.to.map(|(to, _)| to / change.now);
    let size = |change: &&Change| factor(change).map_or(f64::INFINITY, |factor| libm::log(factor).abs());
    let change = found.changes.iter().min_by(|one, other| size(one).total_cmp(&size(other)))?;
    let Some((to, mode)) = change.to else {
        return Some("No single change within reach leaves this mode.".into());
    };
    let shown = |value: f64| in_words(value, unit_of(change.quantity));
    let certain = match (found.bars.is_empty(), change.certain_from) {
        (true, _) => String::new(),
        (false, Some(value)) => format!(", and at {} for all values within the error bars", shown(value)),
        (false, None) => {
            "; no such change within reach leaves it for all values within the error bars".into()
        }
    };
    Some(format!(
        "The smallest single change that leaves this mode is {} times {}: at {} it gives way to {}{certain}.",
        name(change.quantity),
        round_digits(to / change.now, digits_of_factor(to / change.now)),
        shown(to),
        mode.words()
    ))
}

/// The middle of an error bar with the error that settles the slip mode.
pub(super) fn settling(bar: &Bar) -> Option<String> {
    let [low, high] = bar.ends;
    let error = rounded(0.5 * (high - low) * bar.settling_share?, 2, Side::Below).parse().ok()?;
    let [middle, error] = [0.5 * (low + high), error].map(|value| in_words(value, unit_of(bar.quantity)));
    Some(format!("{middle} ± {error}"))
}

/// Which error bar decides the slip mode, and what a better measurement would settle.
pub(crate) fn what_decides_words(outcome: &Outcome) -> Option<String> {
    let (_, found) = found(outcome)?;
    let widest = found.bars.iter().max_by(|one, other| one.width_decades.total_cmp(&other.width_decades))?;
    let effect = match widest.width_decades.is_finite() {
        true => format!("causes {} % of the width of the band", round_digits(100.0 * widest.share, 2)),
        false => "causes a band that has no end".into(),
    };
    // The measurement that has to improve least.
    let easiest = found.bars.iter().filter_map(|bar| Some((bar.settling_share?, bar)));
    let easiest = easiest.max_by(|one, other| one.0.total_cmp(&other.0));
    let settled = match easiest {
        _ if found.is_certain => "no error bar changes the mode".into(),
        Some((_, bar)) => {
            format!("a measurement of {} as {} would settle the mode", name(bar.quantity), settling(bar)?)
        }
        None => "no better measurement of one value alone would settle the mode".into(),
    };
    Some(format!("The error bar of {} {effect}; {settled}.", name(widest.quantity)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::{References, Scene, all_needs, run};
    use crate::scene::Limits;

    /// The outcome of the paper's slider with these lines of `[parameters]`.
    fn outcome(lines: &str) -> Outcome {
        let text = format!(
            "name = \"a\"\ntitle = \"A\"\n[parameters]\ncritical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\n\
             mass_per_area_kg_per_m2 = 1000\n{lines}\n[operating_point]\n"
        );
        let scene = Scene::parse("a.toml", text.as_bytes(), &Limits::default()).unwrap();
        run(&[scene], &all_needs(), &References::default(), &|_, _, _| ())
    }

    const EFFECTS: &str = "direct_effect = 0.004\nevolution_effect = 0.006\n";

    #[test]
    fn the_sentences_say_what_classify_finds() {
        let found = outcome(&format!("{EFFECTS}normal_stress_pa = 1e5\nloading_velocity_m_per_s = 1e-3"));
        assert_eq!(
            operating_point_words(&found).unwrap(),
            "At 100 kPa and 1 mm/s, the slip mode is stick-slip: sliding is linearly unstable (K/K_c is 0.4), and small disturbances oscillate with 6.72 Hz."
        );
        let still = outcome(&format!("{EFFECTS}normal_stress_pa = 1e3\nloading_velocity_m_per_s = 1e-5"));
        let said = operating_point_words(&still).unwrap();
        assert!(said.contains("is overdamped stable sliding: sliding is linearly stable"), "{said}");
        assert!(said.ends_with("and small disturbances do not oscillate."), "{said}");
        assert_eq!(what_decides_words(&still), None);
        // The boundary is at 492.48 Pa, 5.0535 kPa and 494.95 kPa.
        let oscillating =
            outcome(&format!("{EFFECTS}normal_stress_pa = 1e5\nloading_velocity_m_per_s = 1e-5"));
        let said = range_words(&oscillating).unwrap();
        let wanted = "stop oscillating between 492 Pa and 5.05 kPa and above 495 kPa.";
        assert!(said.ends_with(wanted), "{said}");
        let equal = "direct_effect = 0.004\nevolution_effect = 0.004\nnormal_stress_pa = 1e3\nloading_velocity_m_per_s = 1e-5";
        let equal = outcome(equal);
        assert!(operating_point_words(&equal).unwrap().contains("no transition, because a ≥ b"));
        assert!(
            range_words(&equal).unwrap().contains("sliding is stable at every normal stress within reach")
        );
    }

    #[test]
    fn what_is_certain_within_error_bars_is_said_so() {
        let certain =
            outcome(&format!("{EFFECTS}normal_stress_pa = \"[9e4, 1e5]\"\nloading_velocity_m_per_s = 1e-3"));
        let said = operating_point_words(&certain).unwrap();
        assert!(
            said.contains("the slip mode is stick-slip, for all values within the error bars. With"),
            "{said}"
        );
        assert!(what_decides_words(&certain).unwrap().ends_with("no error bar changes the mode."));
        let open =
            outcome(&format!("{EFFECTS}normal_stress_pa = \"[2e4, 6e4]\"\nloading_velocity_m_per_s = 1e-5"));
        let said = operating_point_words(&open).unwrap();
        assert!(said.contains("non-inertial underdamped oscillation or stick-slip, depending on"), "{said}");
        // σ_c = 50 kPa: 40 ± 9.9 kPa lies below it.
        let said = what_decides_words(&open).unwrap();
        assert_eq!(
            said,
            "The error bar of normal stress σ causes 100 % of the width of the band; a measurement of normal stress σ as 40 kPa ± 9.9 kPa would settle the mode."
        );
        let said = what_leaves_words(&open).unwrap();
        assert!(
            said.contains("is stiffness K times 0.8: at 8 MPa/m")
                || said.contains("normal stress σ times 1.25: at 50 kPa"),
            "{said}"
        );
    }

    #[test]
    fn nothing_out_of_reach_is_named() {
        let soft = outcome(
            "direct_effect = 0.01\nevolution_effect = \"0.0100001±0.0000002\"\nnormal_stress_pa = 1e3\nloading_velocity_m_per_s = 1e-12",
        );
        let all = [operating_point_words, range_words, what_leaves_words, what_decides_words];
        let said: String = all.iter().filter_map(|words| words(&soft)).collect();
        assert!(!said.contains("inf") && !said.contains("e-") && said.contains("MPa or more"), "{said}");
    }
}
