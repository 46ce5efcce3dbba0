//! Claim N6: at which velocity inertial vibration first appears in the runs of fig 4, and in which unit its caption speaks.

use crate::claims::{Context, Evidence, Finding};
use crate::friction::Parameters;
use crate::number::format::{certain_digits, rational_to_decimal, round_digits};
use crate::number::{Ball, Rational};
use crate::scene::SceneParameters;
use crate::stability::Asymptote;
use crate::study::{Located, Onset, OnsetOutcome, OtherUnit};
use crate::theory::emergence;

/// Precision of eq 20's velocity, in bits.
const BITS: u32 = 128;

/// How many times its own leading error bσ/(2KD_c) eq 20 may be off: the next order of the series is of the relative
/// size of the leading one, which is below a tenth where the claim is asked.
const LEADING_ERRORS: u32 = 2;

/// Eq 20 as the report states it against the velocities found on one line.
struct Compared<'c> {
    line: &'c Onset,
    eq20_m_per_s: Ball,
    /// V_exact/V_20 − 1.
    excess: Ball,
    /// bσ/(2KD_c).
    leading: Rational,
}

pub(super) fn n6(context: &Context) -> Result<Finding, Finding> {
    let scene = context
        .outcome
        .potentially_unstable()
        .ok_or_else(|| Finding::not_checked("The report has no scene with a < b."))?;
    let (Some(parameters), Some(outcome)) = (scene.parameters(), scene.onset.as_ref()) else {
        return Err(Finding::not_checked("The report does not look for the onset of oscillation."));
    };
    let lower = outcome.lines.iter().filter(|line| line.asymptote == Asymptote::InertialLower);
    let compared: Option<Vec<Compared>> = lower.map(|line| compare(context, parameters, line)).collect();
    let compared =
        compared.ok_or_else(|| Finding::from_proofs([]).refuted("Eq 20 as stated gives no velocity."))?;
    if compared.is_empty() {
        return Err(Finding::not_checked("No line of constant normal stress crosses the lower boundary."));
    }
    let finding = compared.iter().fold(Finding::from_proofs([]), judge);
    let finding = outcome.other_unit.iter().fold(finding, judge_unit);
    Ok(finding
        .within(limit(outcome, &compared))
        .remark(first_peak(&compared))
        .remark("The text states no velocity of fig 4. The report's runs take five of fig 3a's quarter decades, two below eq 20 and three above it, as the words on the colours ask."))
}

fn compare<'c>(context: &Context, parameters: &SceneParameters, line: &'c Onset) -> Option<Compared<'c>> {
    let point: Parameters<Rational> = parameters.at(line.normal_stress_pa.clone(), Rational::from(1));
    let eq20_m_per_s = emergence::velocity_of_eq_20(context.equations, &point, BITS)?;
    let excess = line.boundary_velocity_m_per_s.clone() / &eq20_m_per_s - Ball::from(1);
    let twice = point.stiffness_pa_per_m.clone() * &point.critical_slip_distance_m * 2u32;
    let leading = point.evolution_effect.clone() * &point.normal_stress_pa / twice;
    Some(Compared { line, eq20_m_per_s, excess, leading })
}

impl Compared<'_> {
    fn stress(&self) -> String {
        rational_to_decimal(&self.line.normal_stress_pa, 4)
    }

    /// Whether eq 20 is off by no more than twice what its own series says.
    fn is_near(&self) -> bool {
        let most = Ball::from_rational(&(self.leading.clone() * LEADING_ERRORS), BITS);
        self.excess.upper() <= most.lower() && self.excess.lower() >= (-most).upper()
    }

    /// log10 of a velocity over that of eq 20.
    fn dex(&self, located: &Located) -> f64 {
        libm::log10(located.velocity_m_per_s / self.eq20_m_per_s.to_f64())
    }

    /// log10 of a velocity over that of the exact boundary.
    fn from_boundary(&self, located: &Located) -> f64 {
        libm::log10(located.velocity_m_per_s / self.line.boundary_velocity_m_per_s.to_f64())
    }

    fn undershoots(&self) -> impl Iterator<Item = f64> {
        self.line.seen.iter().filter_map(|seen| seen.undershoot.as_ref()).map(|found| self.dex(found))
    }
}

fn judge(finding: Finding, compared: &Compared) -> Finding {
    let line = compared.line;
    let stress = compared.stress();
    let excess = certain_digits(&compared.excess, 5);
    let finding = finding
        .with_evidence(Evidence::Enclosure {
            quantity: format!("σ = {stress} Pa: velocity of eq 20; of the exact boundary; exact/eq 20 − 1"),
            value: format!(
                "{} m/s; {} m/s; {excess}",
                certain_digits(&compared.eq20_m_per_s, 6),
                certain_digits(&line.boundary_velocity_m_per_s, 6)
            ),
        })
        .require(compared.is_near(), || {
            format!(
                "at σ = {stress} Pa oscillation begins at {} times the velocity of eq 20, though its series allows {} % at most",
                round_digits(1.0 + compared.excess.to_f64(), 4),
                round_digits(100.0 * compared.leading.to_f64() * f64::from(LEADING_ERRORS), 3)
            )
        });
    line.seen.iter().fold(finding, |finding, seen| {
        let law = seen.law.as_str();
        let Some(exists) = &seen.exists else {
            return finding.refuted(format!("{law} law, σ = {stress} Pa: no oscillation was found"));
        };
        let distance = compared.from_boundary(exists);
        let undershoot = seen.undershoot.as_ref().map_or("none".into(), |found| {
            format!("{} dex", round_digits(compared.dex(found), 4))
        });
        let error = seen.undershoot.as_ref().map_or(exists.error_dex, |found| found.error_dex.max(exists.error_dex));
        finding
            .with_evidence(Evidence::Simulation {
                quantity: format!("σ = {stress} Pa, {law} law: log10 over eq 20 of the velocity where small deviations begin to oscillate; where an undershoot is first seen"),
                value: format!("{} dex; {undershoot}", round_digits(compared.dex(exists), 4)),
                error: format!("{} dex", round_digits(error, 2)),
                runs: 2,
            })
            .require(distance.abs() <= exists.error_dex, || {
                format!("{law} law, σ = {stress} Pa: simulated oscillation begins {} dex from the exact boundary", round_digits(distance, 2))
            })
    })
}

/// The caption's unit: Pa, if in it the line crosses the boundary and in the other it does not.
fn judge_unit(finding: Finding, other: &OtherUnit) -> Finding {
    let stress = rational_to_decimal(&other.normal_stress_pa, 4);
    let end = other.behaviour.map_or("no result", |behaviour| behaviour.as_str());
    if other.has_boundary {
        return finding.remark(format!(
            "Read in the caption's unit, {stress} Pa has an onset too: the unit is not decided."
        ));
    }
    let always = if other.always_unstable { "steady sliding is unstable at every velocity and" } else { "" };
    finding.remark(format!(
        "The caption says MPa; it must be Pa. At {stress} Pa {always} max Im(s) = 0 is not crossed in the stable zone, no run settles (the one at eq 20 is {end}), and the point lies outside fig 3a; in Pa all of fig 4 follows."
    ))
}

fn limit(outcome: &OnsetOutcome, compared: &[Compared]) -> String {
    let percent = |value: f64| round_digits(100.0 * value, 3);
    let each = |one: &Compared| {
        let seen =
            one.undershoots().fold((f64::INFINITY, 0.0f64), |(low, high), dex| (low.min(dex), high.max(dex)));
        let inertial =
            one.line.inertial.as_ref().map_or("never".into(), |found| {
                format!("{} dex above eq 20", round_digits(one.dex(found), 3))
            });
        format!(
            "at σ = {} Pa oscillation begins {} % above eq 20, is inertial by the threshold from {inertial}, and shows an undershoot of {} % from {} to {} dex above eq 20, depending on the law",
            one.stress(),
            percent(one.excess.to_f64()),
            percent(outcome.visible.to_f64()),
            round_digits(seen.0, 3),
            round_digits(seen.1, 3)
        )
    };
    compared.iter().map(each).collect::<Vec<_>>().join("; ")
}

/// What the single peak of the blue runs shows.
fn first_peak(compared: &[Compared]) -> String {
    let peaks =
        compared.iter().flat_map(|one| &one.line.seen).filter_map(|seen| seen.peak_excess_at_boundary);
    let (low, high) =
        peaks.fold((f64::INFINITY, 0.0f64), |(low, high), peak| (low.min(peak), high.max(peak)));
    format!(
        "The short peak of the runs next to the onset is no sign of vibration: steady friction is lower at V_l than at V_l/10, so that the spring must shorten by (b−a)σ ln 10/K, which takes V > V_l for a while at every velocity. At the exact boundary, where nothing oscillates, it is {} to {} % of V_l already.",
        round_digits(100.0 * low, 3),
        round_digits(100.0 * high, 3)
    )
}
