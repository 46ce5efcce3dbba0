//! The frequency of oscillation and its limits.

use crate::claims::computed::Asked;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::{BITS, Check, Evidence, Finding, Show, Verdict};
use crate::experiments::frequency::{FrequencyLine, FrequencyOutcome};
use crate::experiments::{Context, Need};
use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational, Real};
use slipmode_core::theory::{period, strip_frequency};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "natural-period",
        is_of_runs: false,
        needs: &[],
        decide: |context, _| natural_period(context),
    },
    Check {
        name: "largest-frequency-in-the-area",
        is_of_runs: false,
        needs: &[],
        decide: largest_in_the_area,
    },
];

pub(super) const SHOWS: &[Show] =
    &[Show { name: "frequency-near-its-limits", needs: &[Need::Frequency], evidence: near_the_limits }];

/// The period that the paper prints, s.
fn printed_period_s() -> Rational {
    Rational::from((625, 10_000))
}

/// How far eq 23 and ω_n are from the computed line at σ = σ_c.
fn near_the_limits(context: &Context) -> Vec<Evidence> {
    let Some(scene) = context.outcome.potentially_unstable() else { return Vec::new() };
    let (Some(parameters), Some(outcome)) = (scene.slider(), &scene.frequency) else { return Vec::new() };
    let one = Rational::from(1);
    let Some(line) = outcome.lines.iter().find(|line| line.normal_stress_over_critical == one) else {
        return Vec::new();
    };
    let enclosed = parameters.map(|value| Ball::from_rational(value, 128));
    let per_metre = enclosed.transition_angular_frequency_over_velocity_per_m().to_f64();
    let natural = enclosed.natural_angular_frequency_per_s().to_f64();
    let highest = Evidence::Sample {
        quantity: "max Im(s)/ω_n at the highest velocity of the line".into(),
        value: round_digits(
            line.max_imaginary_per_s.last().and_then(|w| w.to_f64()).unwrap_or(0.0) / natural,
            6,
        ),
        points: outcome.loading_velocity_m_per_s.len(),
    };
    vec![last_velocity_near(outcome, line, per_metre), highest]
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
    Evidence::Sample {
        quantity: "Highest velocity of the line up to which eq 23 has an error below 1 %".into(),
        value: near.map_or("none".into(), |(velocity, _)| format!("{} m/s", round_digits(*velocity, 4))),
        points: outcome.loading_velocity_m_per_s.len(),
    }
}

fn natural_period(context: &Context) -> Finding {
    let Some(parameters) = context.outcome.potentially_unstable().and_then(|scene| scene.slider()) else {
        return Finding::not_checked("No scene of the report has a < b, so K and M are unknown.");
    };
    match period::natural(
        context.equations,
        &parameters.stiffness_pa_per_m,
        &parameters.mass_per_area_kg_per_m2,
    ) {
        Err(refutation) => Finding::from_proofs([Err(refutation)]),
        Ok(natural) => {
            let printed = printed_period_s();
            let [low, high] = &natural.period_s;
            let finding = || Finding::from_proofs([Ok(natural.proof.clone())]);
            let angular = finding()
                .require(natural.natural_angular_frequency_per_s.to_string() == "100", || {
                    format!("ω_n = {} /s", natural.natural_angular_frequency_per_s)
                });
            // A printed number is right where the exact one rounds to it.
            let half = Rational::from((1, 20_000));
            let rounds = *low >= printed.clone() - &half && *high <= printed.clone() + half;
            let period = rational_to_decimal(low, 5);
            let own = finding()
                .require(rounds, || {
                    format!("2π/ω_n = {period} s, not {} s", rational_to_decimal(&printed, 5))
                })
                .number("period", format!("{} s", rational_to_decimal(low, 3)));
            of_readings([Draft::new("the printed numbers")
                .part("ω_n is 100 /s", angular)
                .part("the period is 0.0625 s", own)])
        }
    }
}

/// The share of ω_n below which a frequency is called far below it.
const FAR_BELOW: (i32, i32) = (1, 10);

fn largest_in_the_area(context: &Context, asked: Asked) -> Finding {
    let finding = asked.proved();
    let law = "without inertia the largest frequency is √(b/a) V0/D_c, at σ = K D_c/(a + b)";
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let reach = slider.filter(|_| finding.verdict == Verdict::Holds).and_then(|slider| {
        let square = Rational::from(FAR_BELOW) * Rational::from(FAR_BELOW);
        Some((
            slider,
            strip_frequency::first_reach(context.equations, &slider.effect_ratio(), &square, BITS)?,
        ))
    });
    let Some((slider, reach)) = reach else {
        return finding.on(format!("η ≪ 1: {law}; with inertia (ω/ω_n)² < 2η"));
    };
    let slider = slider.map(|value| Ball::from_rational(value, 2 * BITS));
    let length_per_time = slider.natural_angular_frequency_per_s() * &slider.critical_slip_distance_m;
    let velocity = certain_digits(&(reach.velocity_squared.sqrt() * length_per_time), 6);
    let stress = reach.stiffness_group.map(|kappa| {
        let stress = slider.stiffness_pa_per_m.clone() * &slider.critical_slip_distance_m
            / &slider.direct_effect
            / kappa;
        format!("{} Pa", certain_digits(&stress, 6))
    });
    let place = stress.as_ref().map_or_else(|| " on eq 16".into(), |stress| format!(" at σ = {stress}"));
    finding
        .on(format!(
            "ω < ω_n/10 everywhere between eqs 16 and 15 exactly for V0 below {velocity} m/s, where ω_n/10 is reached{place}; {law}"
        ))
        .with_evidence(Evidence::Enclosure {
            quantity: "Least V0 with a frequency of ω_n/10 between eqs 16 and 15".into(),
            value: format!("{velocity} m/s"),
        })
}
