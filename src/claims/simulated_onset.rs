//! At which velocity inertial vibration first appears in the runs of fig 4, and in which unit its caption speaks.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::{Evidence, Finding};
use crate::experiments::Context;
use crate::experiments::onset::{Located, Onset, OnsetOutcome, OtherUnit, SeenOnset};
use crate::scene::Kind;
use slipmode_core::dynamics::Behaviour;
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::Asymptote;
use slipmode_core::theory::emergence;

/// Precision of eq 20's velocity, in bits.
const BITS: u32 = 128;

/// How many times its own leading error bσ/(2KD_c) eq 20 may be off: the next order of the series is of the relative
/// size of the leading one, which is below a tenth where the claim is evaluated.
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

pub(super) fn onset_in_velocity(context: &Context) -> Result<Finding, Finding> {
    let scene = context
        .outcome
        .potentially_unstable()
        .ok_or_else(|| Finding::not_checked("The report has no scene with a < b."))?;
    let (Some(parameters), Some(outcome)) = (scene.slider(), scene.onset.as_ref()) else {
        return Err(Finding::not_checked("The report does not compute the onset of oscillation."));
    };
    let lower = outcome.lines.iter().filter(|line| line.asymptote == Asymptote::InertialLower);
    let compared: Option<Vec<Compared>> = lower.map(|line| compare(context, parameters, line)).collect();
    let compared = compared.ok_or_else(|| Finding::failing("Eq 20 as stated gives no velocity."))?;
    if compared.is_empty() {
        return Err(Finding::not_checked("No line of constant normal stress crosses the lower boundary."));
    }
    let begins = Draft::new("where small deviations begin to oscillate");
    let begins = compared.iter().fold(begins, |draft, line| {
        let stress = line.stress();
        draft
            .part(
                format!("at σ = {stress} Pa the exact boundary and inertial oscillation begin at eq 20"),
                on_the_boundary(line, context.kind),
            )
            .part(format!("at σ = {stress} Pa simulations begin to oscillate there"), in_simulations(line))
    });
    let seen = Draft::new("where the recorded velocity first shows an oscillation");
    let seen = compared.iter().fold(seen, |draft, line| {
        draft.part(format!("at σ = {} Pa it is visible from eq 20 on", line.stress()), visible(line, outcome))
    });
    Ok(unit(of_readings([begins, seen]), &outcome.other_unit).remark(first_peak(&compared)))
}

fn compare<'c>(context: &Context, slider: &Slider<Rational>, line: &'c Onset) -> Option<Compared<'c>> {
    let stress = &line.normal_stress_pa;
    let eq20_m_per_s = emergence::velocity_of(context.equations, "20", slider, stress, BITS)?;
    let excess = line.boundary_velocity_m_per_s.clone() / &eq20_m_per_s - Ball::from(1);
    let leading = slider.evolution_effect.clone() * stress / (slider.stiffness_stress_pa() * 2u32);
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
        libm::log10(located.value / self.eq20_m_per_s.to_f64())
    }

    /// log10 of a velocity over that of the exact boundary.
    fn dex_over_boundary(&self, located: &Located) -> f64 {
        libm::log10(located.value / self.line.boundary_velocity_m_per_s.to_f64())
    }

    /// Least and greatest log10 over eq 20 of what the laws show, for people.
    fn laws(&self, of: fn(&SeenOnset) -> Option<Located>) -> String {
        let places = self.line.seen.iter().filter_map(of).map(|found| self.dex(&found));
        let (low, high) =
            places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), dex| (low.min(dex), high.max(dex)));
        if low > high {
            return "no velocity".into();
        }
        format!("{} to {} dex", round_digits(low, 3), round_digits(high, 3))
    }
}

/// Whether the exact boundary is at eq 20, but for the error that its own series states.
fn on_the_boundary(compared: &Compared, kind: Kind) -> Finding {
    let stress = compared.stress();
    let excess = certain_digits(&compared.excess, 5);
    let velocities = Evidence::Enclosure {
        quantity: format!("σ = {stress} Pa: velocity of eq 20; of the exact boundary; exact/eq 20 − 1"),
        value: format!(
            "{} m/s; {} m/s; {excess}",
            certain_digits(&compared.eq20_m_per_s, 6),
            certain_digits(&compared.line.boundary_velocity_m_per_s, 6)
        ),
    };
    let percent = round_digits(100.0 * compared.excess.to_f64(), 3);
    let allowed = round_digits(100.0 * nearest_f64(&compared.leading) * f64::from(LEADING_ERRORS), 3);
    let begins = libm::log10(1.0 + compared.excess.to_f64());
    let inertial = compared.line.inertial.as_ref().map(|found| (compared.dex(found), found.error_dex));
    let deviations = Deviations::new(Measure::Place, inertial.into_iter().chain([(begins, 0.0)]));
    Finding::from_evidence(velocities)
        .require(compared.is_near(), || {
            format!("it is {percent} % above eq 20, although its series allows at most {allowed} %")
        })
        .near(kind, &deviations)
        .remark(format!("At σ = {stress} Pa the exact boundary is {percent} % above eq 20."))
}

/// Whether simulations begin to oscillate where the exact boundary is.
fn in_simulations(compared: &Compared) -> Finding {
    let finding = compared.line.seen.iter().fold(None, |finding: Option<Finding>, seen| {
        let evidence = seen_evidence(compared, seen);
        let finding = match finding {
            None => Finding::from_evidence(evidence),
            Some(finding) => finding.with_evidence(evidence),
        };
        let law = seen.law.as_str();
        let Some(exists) = &seen.exists else {
            return Some(finding.refuted(format!("{law} law: no oscillation was found")));
        };
        let distance = compared.dex_over_boundary(exists);
        Some(finding.require(distance.abs() <= exists.error_dex, || {
            format!("{law} law: it begins {} dex from the exact boundary", round_digits(distance, 2))
        }))
    });
    finding.unwrap_or_else(|| Finding::not_checked("No law was simulated on this line."))
}

/// Whether a second rise or an undershoot is visible from the velocity of eq 20 on, within the error that its series states.
fn visible(compared: &Compared, outcome: &OnsetOutcome) -> Finding {
    let places = |seen: &SeenOnset| [seen.second_rise, seen.undershoot].into_iter().flatten().collect();
    let shown: Vec<Located> =
        compared.line.seen.iter().flat_map(|seen| -> Vec<Located> { places(seen) }).collect();
    let evidence = compared.line.seen.iter().map(|seen| seen_evidence(compared, seen));
    let finding = evidence.fold(None, |finding: Option<Finding>, evidence| {
        Some(match finding {
            None => Finding::from_evidence(evidence),
            Some(finding) => finding.with_evidence(evidence),
        })
    });
    let Some(finding) = finding else { return Finding::not_checked("No law was simulated on this line.") };
    let allowed = libm::log10(1.0 + f64::from(LEADING_ERRORS) * nearest_f64(&compared.leading));
    let is_near = |found: &Located| compared.dex(found).abs() <= allowed + found.error_dex;
    let part = round_digits(100.0 * nearest_f64(&outcome.visible), 3);
    finding.require(!shown.is_empty() && shown.iter().all(is_near), || {
        format!(
            "a second rise by {part} % of V_l is visible from {}, and an undershoot by {part} % of V_l from {}, above eq 20, depending on the law",
            compared.laws(|seen| seen.second_rise),
            compared.laws(|seen| seen.undershoot)
        )
    })
}

/// What one law's runs on a line show.
fn seen_evidence(compared: &Compared, seen: &SeenOnset) -> Evidence {
    let (stress, law) = (compared.stress(), seen.law.as_str());
    let dex = |found: Option<Located>| {
        found.map_or("none".into(), |found| format!("{} dex", round_digits(compared.dex(&found), 4)))
    };
    let errors = [seen.exists, seen.second_rise, seen.undershoot]
        .map(|found| found.map_or(0.0, |found| found.error_dex));
    Evidence::Simulation {
        quantity: format!(
            "σ = {stress} Pa, {law} law: log10 of the velocity divided by that of eq 20, where small deviations begin to oscillate; where a second rise is visible; where an undershoot is visible"
        ),
        value: format!("{}; {}; {}", dex(seen.exists), dex(seen.second_rise), dex(seen.undershoot)),
        error: format!("{} dex", round_digits(errors.into_iter().fold(0.0, f64::max), 2)),
        runs: 3,
    }
}

/// The caption's unit: Pa, if in it the lines cross the boundary and in the other none does.
fn unit(finding: Finding, others: &[OtherUnit]) -> Finding {
    if others.is_empty() {
        return finding;
    }
    let stresses: Vec<String> =
        others.iter().map(|other| rational_to_decimal(&other.normal_stress_pa, 4)).collect();
    let stresses = stresses.join(" and ");
    let ends_steady = |other: &OtherUnit| other.behaviour != Some(Behaviour::Periodic);
    if others.iter().any(|other| other.has_boundary || !other.always_unstable || ends_steady(other)) {
        return finding.remark(format!("At {stresses} Pa, the normal stresses in the caption's unit, there is an onset too, so the unit is undecided."));
    }
    finding
        .with_supporting(Evidence::Simulation {
            quantity: format!("Long-term behaviour at {stresses} Pa (the caption's unit, MPa) and the velocity of eq 20 there"),
            value: "limit cycle".into(),
            error: "the same at two tolerances".into(),
            runs: others.len(),
        })
        .remark(format!("The unit MPa in the caption of fig 4 must be Pa. At {stresses} Pa, σ exceeds σ_c: steady sliding is unstable at every velocity, there is no boundary in the stable zone, and the runs end on limit cycles instead of decaying. In Pa, the runs agree with everything that the section states about the figure."))
}

/// What the single peak of the blue runs shows.
fn first_peak(compared: &[Compared]) -> String {
    let peaks =
        compared.iter().flat_map(|one| &one.line.seen).filter_map(|seen| seen.peak_excess_at_boundary);
    let (low, high) =
        peaks.fold((f64::INFINITY, 0.0f64), |(low, high), peak| (low.min(peak), high.max(peak)));
    format!(
        "The short peak of the runs next to the onset is no sign of vibration. Steady friction is lower at V_l than at V_l/10, so the spring must shorten by (b−a)σ ln 10/K, which needs V > V_l for a while at every velocity. At the exact boundary, where nothing oscillates, the peak is already {} to {} % of V_l.",
        round_digits(100.0 * low, 3),
        round_digits(100.0 * high, 3)
    )
}
