//! The frequency of oscillation and its limits.

use crate::claims::check::{Asked, NO_NUMBER};
use crate::claims::{BITS, Evidence, Finding, Verdict};
use crate::experiments::Context;
use crate::experiments::frequency::{FrequencyLine, FrequencyOutcome};
use crate::scene::cited;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_core::number::{Ball, Real};
use slipmode_theory::strip_frequency;

/// How far eq 23 and ω_n are from the computed line at σ = σ_c.
pub(super) fn near_the_limits(context: &Context) -> Option<Vec<Evidence>> {
    let scene = context.outcome.potentially_unstable()?;
    let outcome = scene.frequency.as_ref()?;
    let line = outcome.lines.iter().find(|line| line.normal_stress_over_critical == 1)?;
    let enclosed = scene.slider()?.map(|value| Ball::from_rational(value, 128));
    let per_metre = enclosed.transition_angular_frequency_over_velocity_per_m().to_f64();
    let natural = enclosed.natural_angular_frequency_per_s().to_f64();
    let ratio = line.max_imaginary_per_s.last().and_then(|w| w.to_f64()).unwrap_or(0.0) / natural;
    let quantity = "max Im(s)/ω_n at the highest velocity of the line";
    let highest = Evidence::sample(quantity, round_digits(ratio, 6), outcome.loading_velocity_m_per_s.len());
    Some(vec![last_velocity_near(outcome, line, per_metre), highest])
}

/// The highest velocity up to which eq 23 is within 1 %.
fn last_velocity_near(outcome: &FrequencyOutcome, line: &FrequencyLine, eq23_per_metre: f64) -> Evidence {
    let near = outcome
        .loading_velocity_m_per_s
        .iter()
        .zip(&line.max_imaginary_per_s)
        .take_while(|(velocity, imaginary)| {
            let ratio = imaginary.to_f64().unwrap_or(0.0) / (eq23_per_metre * **velocity);
            (ratio - 1.0).abs() <= 0.01
        })
        .last();
    Evidence::sample(
        cited("Highest velocity of the line up to which {frequency-limit} has an error below 1 %"),
        near.map_or("none".into(), |(velocity, _)| format!("{} m/s", round_digits(*velocity, 4))),
        outcome.loading_velocity_m_per_s.len(),
    )
}

/// Up to which velocity the frequency is below ω_n over the number that it is asked about.
pub(super) fn largest_in_the_area(context: &Context, asked: Asked) -> Finding {
    let Some((over, number)) = asked.number() else { return Finding::not_checked(NO_NUMBER) };
    let finding = asked.proved();
    let law = "without inertia the largest frequency is √(b/a) V0/D_c, at σ = K D_c/(a + b)";
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let reach = slider.filter(|_| finding.verdict == Verdict::Holds).and_then(|slider| {
        let square = number.square().recip();
        let reach = strip_frequency::first_reach(context.equations, &slider.effect_ratio(), &square, BITS)?;
        Some((slider, reach))
    });
    let Some((slider, reach)) = reach else {
        return finding.on(format!("η ≪ 1: {law}; with inertia (ω/ω_n)² < 2η"));
    };
    let slider = slider.map(|value| Ball::from_rational(value, 2 * BITS));
    let length_per_time = slider.natural_angular_frequency_per_s() * &slider.critical_slip_distance_m;
    let velocity = certain_digits(&(reach.velocity_squared.sqrt() * length_per_time), 6);
    let place = reach.stiffness_group.map_or(" on {quasi-static-lower}".into(), |kappa| {
        format!(" at σ = {} Pa", certain_digits(&(slider.stress_scale_pa() / kappa), 6))
    });
    finding
        .on(cited(&format!(
            "ω < ω_n/{over} everywhere between {{quasi-static-lower, quasi-static-upper}} exactly for V0 below {velocity} m/s, where ω_n/{over} is reached{place}; {law}"
        )))
        .with_evidence(Evidence::enclosure(
            cited(&format!("Least V0 with a frequency of ω_n/{over} between {{quasi-static-lower, quasi-static-upper}}")),
            format!("{velocity} m/s"),
        ))
}
