//! Where oscillation begins along lines of constant normal stress: theory's velocities next to those of simulations (figs 4 and 6).

use crate::parallel;

use crate::experiments::map::run::exactly;
use crate::experiments::onset::search::Line;
use crate::experiments::onset::theory::{DIGITS, inertial_velocity, stable_boundary, stable_boundary_stress};
use crate::experiments::onset::{Located, OnsetSection, SeenOnset, Swing};
use slipmode_core::dynamics::{Behaviour, Options, simulate};
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational, bits_for_digits, nearest_f64};
use slipmode_core::stability::asymptote::{
    inertial_lower_velocity_m_per_s, quasi_static_lower_normal_stress_pa,
};
use slipmode_core::stability::{Asymptote, InertialThreshold, Section, SlipMode, classify};

/// One line of constant normal stress that crosses the boundary in the stable zone.
#[derive(Debug, Clone)]
pub struct Onset {
    /// σ, Pa.
    pub normal_stress_pa: Rational,
    /// Eq 20, or eq 18 on the upper arc (a > b).
    pub asymptote: Asymptote,
    /// Velocity of the asymptote, m/s.
    pub asymptote_velocity_m_per_s: Ball,
    /// Velocity of the exact boundary, m/s.
    pub boundary_velocity_m_per_s: Ball,
    /// Velocity from which on the exact mode is inertial by the threshold of the scene.
    pub inertial: Option<Located>,
    /// The same by simulation, law by law.
    pub seen: Vec<SeenOnset>,
    /// The runs to show, slowest loading first, with the first law.
    pub shown: Vec<ShownRun>,
    /// The same run at the exact boundary.
    pub at_boundary: Option<ShownRun>,
}

/// One run to show.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownRun {
    /// V_l over the asymptote's velocity.
    pub velocity_over_asymptote: f64,
    /// V_l, m/s.
    pub loading_velocity_m_per_s: f64,
    /// Whether a complex pair exists there, decided exactly.
    pub oscillates: bool,
    /// The slip mode, decided exactly.
    pub slip_mode: SlipMode,
    /// What is seen of the run, with the estimated error; none when it failed.
    pub swing: Option<(Swing, f64)>,
    /// (time in D_c/V_l, V/V_l), evenly in time; empty when the run failed.
    pub history: Vec<(f64, f64)>,
}

/// What a normal stress would mean in another unit.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherUnit {
    /// σ in that unit, as Pa.
    pub normal_stress_pa: Rational,
    /// Whether a boundary of the stable zone exists at that σ.
    pub has_boundary: bool,
    /// Whether steady sliding is unstable there at every velocity (σ > σ_c).
    pub always_unstable: bool,
    /// How a run at the velocity of eq 20 ends there; none when it failed.
    pub behaviour: Option<Behaviour>,
}

/// Where oscillation begins along a line of constant loading velocity, across eq 16.
#[derive(Debug, Clone)]
pub struct StressOnset {
    /// V_l, m/s.
    pub loading_velocity_m_per_s: Rational,
    /// σ of the exact boundary, Pa.
    pub boundary_pa: Ball,
    /// σ by simulation, law by law.
    pub seen: Vec<SeenOnset>,
}

/// Where oscillation begins on each line of a scene.
#[derive(Debug, Clone)]
pub struct OnsetOutcome {
    /// The lines that cross the boundary in the stable zone, in the order of the scene.
    pub lines: Vec<Onset>,
    /// The lines of constant loading velocity that cross the boundary in the stable zone, in the order of the scene.
    pub stress_lines: Vec<StressOnset>,
    /// The normal stresses in the other unit that the scene names.
    pub other_unit: Vec<OtherUnit>,
    /// The visible depth, as in the scene.
    pub visible: Rational,
}

/// Length of the shown runs in natural periods at the fastest of their velocities, and their samples.
const SHOWN_PERIODS: f64 = 4.0;
const SHOWN_SAMPLES: usize = 161;

/// Compares the velocities at every normal stress of the section.
pub(crate) fn onset(
    parameters: &Slider<Rational>,
    section: &OnsetSection,
    threshold: &InertialThreshold,
) -> OnsetOutcome {
    let line = |stress: &Rational| onset_at(parameters, section, threshold, stress);
    let stress_line = |velocity: &Rational| stress_onset(parameters, section, velocity);
    let other = section
        .other_unit_pa
        .iter()
        .flat_map(|unit| section.normal_stress_pa.iter().map(move |stress| stress.clone() * unit));
    OnsetOutcome {
        lines: parallel::flat_map(&section.normal_stress_pa, line),
        stress_lines: parallel::flat_map(&section.loading_velocity_m_per_s, stress_line),
        other_unit: other.map(|stress| in_other_unit(parameters, section, stress)).collect(),
        visible: section.visible.clone(),
    }
}

fn onset_at(
    parameters: &Slider<Rational>,
    section: &OnsetSection,
    threshold: &InertialThreshold,
    stress: &Rational,
) -> Option<Onset> {
    let (arc, boundary) = stable_boundary(parameters, stress)?;
    let asymptote = Asymptote::inertial(arc);
    let bits = bits_for_digits(DIGITS);
    let ball = |value: &Rational| Ball::from_rational(value, bits);
    let asymptote_velocity = asymptote.value(&parameters.map(ball), &ball(stress));
    let tolerance = nearest_f64(&section.tolerance);
    let given = &Section::AtNormalStress(stress.clone());
    let line = |law| Line { parameters, given, law, tolerance };
    let (from, at) = (asymptote_velocity.to_f64(), boundary.to_f64());
    let visible = nearest_f64(&section.visible);
    let first = section.laws.first().map(|&law| line(law));
    let fastest = section.velocity_over_asymptote.iter().map(nearest_f64).fold(0.0, f64::max);
    let until = SHOWN_PERIODS * natural_period(parameters, from * fastest);
    let run = |ratio: f64| Some(shown_run(first.as_ref()?, (stress, threshold), from, ratio, until));
    Some(Onset {
        normal_stress_pa: stress.clone(),
        asymptote,
        inertial: inertial_velocity(parameters, threshold, stress, at),
        seen: parallel::map(&section.laws, |&law| line(law).search(from, at, visible)),
        asymptote_velocity_m_per_s: asymptote_velocity,
        boundary_velocity_m_per_s: boundary,
        shown: section.velocity_over_asymptote.iter().filter_map(|ratio| run(nearest_f64(ratio))).collect(),
        at_boundary: run(at / from),
    })
}

/// 2π/ω_n in units of D_c/V_l at a loading velocity.
fn natural_period(parameters: &Slider<Rational>, velocity: f64) -> f64 {
    let slider = parameters.map(nearest_f64);
    let period_s = std::f64::consts::TAU / slider.natural_angular_frequency_per_s();
    period_s * velocity / slider.critical_slip_distance_m
}

fn stress_onset(
    parameters: &Slider<Rational>,
    section: &OnsetSection,
    velocity: &Rational,
) -> Option<StressOnset> {
    let boundary_pa = stable_boundary_stress(parameters, velocity)?;
    let at = boundary_pa.to_f64();
    let from = quasi_static_lower_normal_stress_pa(&parameters.map(nearest_f64));
    let (tolerance, visible) = (nearest_f64(&section.tolerance), nearest_f64(&section.visible));
    let given = &Section::AtVelocity(velocity.clone());
    let line = |law| Line { parameters, given, law, tolerance };
    Some(StressOnset {
        loading_velocity_m_per_s: velocity.clone(),
        seen: parallel::map(&section.laws, |&law| line(law).search(from, at, visible)),
        boundary_pa,
    })
}

fn shown_run(
    line: &Line,
    (stress, threshold): (&Rational, &InertialThreshold),
    asymptote: f64,
    ratio: f64,
    until: f64,
) -> ShownRun {
    let velocity = asymptote * ratio;
    let theory = classify(&line.parameters.at(stress.clone(), exactly(velocity)), threshold);
    ShownRun {
        velocity_over_asymptote: ratio,
        loading_velocity_m_per_s: velocity,
        oscillates: theory.boundary_sign < 0,
        slip_mode: theory.slip_mode,
        swing: line.swing(libm::log(velocity)).ok(),
        history: line.history(libm::log(velocity), until, SHOWN_SAMPLES).unwrap_or_default(),
    }
}

fn in_other_unit(parameters: &Slider<Rational>, section: &OnsetSection, stress: Rational) -> OtherUnit {
    let velocity = inertial_lower_velocity_m_per_s(&parameters.map(nearest_f64), &nearest_f64(&stress));
    let point = parameters.at(stress.clone(), exactly(velocity));
    let run =
        section.laws.first().map(|&law| simulate(&point, law, &Options::at(nearest_f64(&section.tolerance))));
    OtherUnit {
        has_boundary: stable_boundary(parameters, &stress).is_some(),
        always_unstable: parameters.has_transition() && stress > parameters.critical_normal_stress_pa(),
        behaviour: run.and_then(Result::ok).map(|simulation| simulation.behaviour),
        normal_stress_pa: stress,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::shared::fixtures::with_effects;
    use slipmode_core::friction::EvolutionLaw;
    use slipmode_core::number::parse_decimal;

    fn section(stresses: &[&str]) -> OnsetSection {
        OnsetSection {
            normal_stress_pa: stresses.iter().map(|text| parse_decimal(text).unwrap()).collect(),
            velocity_over_asymptote: vec![Rational::from((1, 2)), Rational::from(5)],
            laws: EvolutionLaw::ALL.to_vec(),
            tolerance: parse_decimal("1e-8").unwrap(),
            visible: parse_decimal("0.01").unwrap(),
            other_unit_pa: Some(Rational::from(1_000_000)),
            loading_velocity_m_per_s: vec![parse_decimal("1e-5").unwrap()],
        }
    }

    #[test]
    fn oscillation_begins_in_simulations_on_the_exact_boundary_and_not_on_its_asymptote() {
        let found =
            onset(&with_effects("0.004", "0.006"), &section(&["1778.28"]), &InertialThreshold::default());
        let [line] = &found.lines[..] else { panic!("one line") };
        let exact = line.boundary_velocity_m_per_s.to_f64();
        let off = libm::log10(exact / line.asymptote_velocity_m_per_s.to_f64());
        for seen in &line.seen {
            let exists = seen.exists.unwrap();
            let distance = libm::log10(exists.value / exact).abs();
            assert!(distance <= exists.error_dex, "{distance:e} {seen:?}");
            assert!(exists.error_dex < 1e-3 * off, "{off} {seen:?}");
            // What is seen comes later than what exists.
            let (rise, undershoot) = (seen.second_rise.unwrap(), seen.undershoot.unwrap());
            assert!(rise.value > 1.1 * exact && undershoot.error_dex < 1e-5, "{seen:?}");
            assert!(undershoot.value > rise.value && rise.error_dex < 1e-5, "{seen:?}");
        }
        assert!(!line.shown[0].oscillates && line.shown[1].oscillates);
    }

    #[test]
    fn across_eq_16_oscillation_begins_in_simulations_on_the_exact_boundary() {
        let found = onset(&with_effects("0.004", "0.006"), &section(&[]), &InertialThreshold::default());
        let [line] = &found.stress_lines[..] else { panic!("one line") };
        let exact = line.boundary_pa.to_f64();
        // Eq 16: K D_c/(√b + √a)² = 100/0.0197980 Pa.
        assert!((exact / 5051.03 - 1.0).abs() < 0.05, "{exact}");
        for seen in &line.seen {
            let exists = seen.exists.unwrap();
            let distance = libm::log10(exists.value / exact).abs();
            assert!(distance <= exists.error_dex && exists.error_dex < 1e-3, "{distance:e} {seen:?}");
            assert!(seen.undershoot.unwrap().value > exact, "{seen:?}");
        }
    }

    #[test]
    fn in_megapascal_there_is_no_boundary_and_every_velocity_is_unstable() {
        let found =
            onset(&with_effects("0.004", "0.006"), &section(&["562.34"]), &InertialThreshold::default());
        let [other] = &found.other_unit[..] else { panic!("one stress") };
        assert!(!other.has_boundary && other.always_unstable);
        assert_eq!(other.behaviour, Some(Behaviour::Periodic));
    }

    #[test]
    fn the_upper_arc_is_an_onset_for_the_intrinsically_stable_slider_only() {
        let stresses = section(&["1e7"]);
        assert!(
            onset(&with_effects("0.004", "0.006"), &stresses, &InertialThreshold::default()).lines.is_empty()
        );
        let found = onset(&with_effects("0.006", "0.004"), &stresses, &InertialThreshold::default());
        assert_eq!(found.lines[0].asymptote, Asymptote::InertialUpper);
    }
}
