//! Claims Q: the frequency of oscillation and its limits.

use crate::claims::ledger::premise;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::{BITS, Check, Evidence, Finding, Verdict, frequency_turns};
use crate::experiments::frequency::{FrequencyLine, FrequencyOutcome};
use crate::experiments::{Context, Need};
use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational, Real};
use slipmode_core::theory::{frequency, non_inertial, period, strip_frequency};

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "Q1",
        criterion: "Every complex root of eq 8 has |s| < √(K/M) for all parameters, and some roots come arbitrarily close to this bound.",
        not_established: "The frequency of finite-amplitude motion.",
        needs: &[],
        equations: &["8", "21", "22", "natural-frequency"],
        rests_on: &["L3"],
        decide: |context| {
            Finding::from_proof(frequency::bounded(context.equations)).with_premise(premise("Q2", context))
        },
    },
    Check {
        id: "Q3",
        criterion: "At σ = σ_c the ratio of max Im(s) to eq 23 tends to 1 as V0 → 0, max Im(s) rises strictly with V0, and it reaches ω_n.",
        not_established: "By how much the frequency falls at normal stresses close to eq 16.",
        needs: &[Need::Frequency],
        equations: &["8", "12", "21", "23", "natural-frequency"],
        rests_on: &["S6", "Q1"],
        decide: q3,
    },
    Check {
        id: "Q4",
        criterion: "Without inertia and at fixed σ the frequency depends neither on M nor on K.",
        not_established: "Whether the dependence is visible in fig 2, where K is fixed.",
        needs: &[],
        equations: &["8", "10", "12", "14", "23"],
        rests_on: &["B2", "S6"],
        decide: q4,
    },
    Check {
        id: "Q5",
        criterion: "For the paper's values √(K/M) is 100 /s, and 2π/ω_n rounds to the printed period.",
        not_established: "The period of the simulated vibrations: see the N claims.",
        needs: &[],
        equations: &["natural-frequency"],
        rests_on: &[],
        decide: q5,
    },
    Check {
        id: "Q6",
        criterion: "Between eqs 16 and 15, the largest max Im(s)/ω_n tends to 0 with the velocity.",
        not_established: "The equation of the dashed line of fig 3a.",
        needs: &[],
        equations: &[
            "8",
            "9",
            "12",
            "13",
            "14",
            "15",
            "16",
            "20",
            "23",
            "inertial-parameter",
            "natural-frequency",
        ],
        rests_on: &["B2", "Q1"],
        decide: q6,
    },
];

/// The period that the paper prints, s.
fn printed_period_s() -> Rational {
    Rational::from((625, 10_000))
}

fn q3(context: &Context) -> Finding {
    let proved = || Finding::from_proofs([non_inertial::at_critical_stress(context.equations)]);
    let near = near_the_limits(context).into_iter().fold(proved(), Finding::with_supporting);
    let written = Draft::new("on the line σ = σ_c, which is K = K_c without inertia")
        .part("the lower the velocity, the closer the frequency is to eq 23", near)
        .part("the frequency rises with velocity", proved())
        .part(
            "it comes as close to ω_n as one likes",
            proved().on("it is strictly below ω_n at every velocity"),
        );
    let area = Draft::new("in the whole area of low frequency, between eqs 16 and 15").part(
        "at every normal stress the frequency rises with velocity",
        frequency_turns::rises_in_the_area(context),
    );
    of_readings([written, area])
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

fn q4(context: &Context) -> Finding {
    let at_ratio = || Finding::from_proofs([non_inertial::at_stress_ratio(context.equations)]);
    let stiffness = Finding::from_disproof(
        non_inertial::stiffness(context.equations),
        "without inertia K dω²/dK = ω² at K = K_c,qs, so the frequency grows as √K",
    );
    let written = Draft::new("at fixed normal stress, without inertia (eq 14)")
        .part(
            "the frequency does not depend on mass",
            Finding::from_proofs([non_inertial::mass(context.equations)]),
        )
        .part("the frequency does not depend on stiffness", stiffness);
    let ratio = Draft::new("at fixed σ/σ_c, as in fig 2, without inertia")
        .part("the frequency does not depend on mass", at_ratio())
        .part("the frequency does not depend on stiffness", at_ratio());
    of_readings([written, ratio])
        .remark("With inertia the frequency depends on the mass, to the relative order η.")
        .remark(
            "Eq 23 does not contain K because K was replaced by K_c; there the other parameters determine K.",
        )
}

fn q5(context: &Context) -> Finding {
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

fn q6(context: &Context) -> Finding {
    let finding = Finding::from_proofs([
        strip_frequency::prove(context.equations),
        frequency::low_frequency_zone(context.equations),
    ])
    .remark("The paper gives no equation for the dashed line of fig 3a. Two candidates: the line η = 1, on which K = K_c has ω = ω_n/√2, and the line V0 = V_c, where eq 23 equals ω_n. The two cross on σ = σ_c.");
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
