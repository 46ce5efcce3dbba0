//! Whether the frequency rises with velocity in the whole area of low frequency.

use crate::claims::check::Asked;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::scene::cited;
use slipmode_core::number::Ball;
use slipmode_core::number::format::{Side, certain_digits, rounded};
use slipmode_core::stability::asymptote;
use slipmode_theory::frequency_turns::{self, TurningInterval};

/// Digits of the ratios of normal stresses.
const DIGITS: usize = 10;

/// Bits that give these digits.
const BITS: u32 = 128;

/// Where between eqs 16 and 15 max Im(s) rises with velocity, from the number of its turning points at each normal stress.
pub(super) fn rises_in_the_area(context: &Context, _: Asked) -> Finding {
    let strip = match turns_in_strip(context) {
        Ok(strip) => strip,
        Err(undecided) => return undecided,
    };
    let counts: Vec<String> = strip.iter().map(|(turns, _)| turns.to_string()).collect();
    let counts = || {
        Finding::from_evidence(enclosure(
            "Turning points of max Im(s) in V0, from {quasi-static-upper} down to {quasi-static-lower}",
            &counts.join(", "),
        ))
    };
    let [(0, _), (2, falls), (1, stops)] = &strip[..] else {
        return counts()
            .require(strip.iter().all(|(turns, _)| *turns == 0), || "max Im(s) has turning points".into());
    };
    let rising =
        counts().with_evidence(enclosure("σ/σ₁₆ below which max Im(s) falls with V0 somewhere", falls));
    let falling = counts()
        .number("falls", falls.parse().map_or_else(|_| falls.clone(), |it| rounded(it, 3, Side::Above)))
        .with_evidence(enclosure("σ/σ₁₆ below which max Im(s) falls to zero and rises again, at the cusp", stops))
        .refuted(cited(&format!("the frequency falls in a range of velocities; below {stops} times the stress of {{quasi-static-lower}} it falls to zero, so that the oscillation ends and starts again")));
    of_readings([Draft::new(&cited("in the whole area between {quasi-static-lower, quasi-static-upper}"))
        .part(cited(&format!("it rises with velocity from {falls} times the stress of {{quasi-static-lower}} up to {{quasi-static-upper}}")), rising)
        .part(cited(&format!("it rises with velocity from {{quasi-static-lower}} up to {falls} times its stress")), falling)])
}

fn enclosure(quantity: &str, value: &str) -> Evidence {
    Evidence::enclosure(cited(quantity), value)
}

/// The numbers of turning points of max Im(s) from eq 15 down to eq 16, each with the σ/σ₁₆ at which it begins.
fn turns_in_strip(context: &Context) -> Result<Vec<(usize, String)>, Finding> {
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let slider =
        slider.ok_or_else(|| Finding::not_checked("No scene of the report has a < b, so b/a is unknown."))?;
    let intervals = frequency_turns::intervals(context.equations, &slider.effect_ratio())
        .map_err(|refutation| Finding::not_checked(refutation.to_string()))?;
    let slider = slider.map(|value| Ball::from_rational(value, BITS));
    let scale = slider.stress_scale_pa();
    // κ on eqs 15 and 16.
    let first = scale.clone() / asymptote::quasi_static_upper_normal_stress_pa(&slider);
    let last = scale / asymptote::quasi_static_lower_normal_stress_pa(&slider);
    let is_between = |one: &&TurningInterval| {
        let begins = one.from.upper() < last.lower();
        begins && one.to.as_ref().is_none_or(|to| to.lower() > first.upper())
    };
    let stress_over_eq_16 = |kappa: &Ball| match kappa.contains_zero() {
        true => "∞".into(),
        false => certain_digits(&(last.clone() / kappa), DIGITS),
    };
    let between = intervals.iter().filter(is_between);
    Ok(between.map(|one| (one.turning_points, stress_over_eq_16(&one.from))).collect())
}
