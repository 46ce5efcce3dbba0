//! Eq 16 as critical damping, and what the five runs of fig 4 show on either side of eq 20.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::{Evidence, Finding};
use crate::experiments::onset::{Located, Onset, SeenOnset, ShownRun, StressOnset, Swing};
use crate::experiments::{Context, SceneOutcome};
use crate::scene::Kind;
use slipmode_core::friction::Slider;
use slipmode_core::number::format::{certain_digits, rational_to_decimal, round_digits};
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::{Asymptote, SlipMode};
use slipmode_core::theory::emergence;

/// Precision of eq 16's normal stress, in bits.
const BITS: u32 = 128;

/// How many times its own leading error η eq 16 may be off, as eq 20.
const LEADING_ERRORS: u32 = 2;

/// Eq 16 as the report states it against what is found on one line of constant loading velocity.
struct Crossed<'c> {
    line: &'c StressOnset,
    eq16_pa: Ball,
    /// η at eq 16, the relative error that the next order of the expansion gives.
    leading: Rational,
}

fn scene<'c>(context: &'c Context) -> Result<(&'c SceneOutcome, &'c Slider<Rational>), Finding> {
    let scene = context.outcome.potentially_unstable();
    scene
        .and_then(|scene| Some((scene, scene.slider()?)))
        .ok_or_else(|| Finding::not_checked("The report has no scene with a < b."))
}

pub(super) fn onset_in_normal_stress(context: &Context) -> Result<Finding, Finding> {
    let (scene, slider) = scene(context)?;
    let lines = scene.onset.as_ref().map_or(&[][..], |found| &found.stress_lines);
    if lines.is_empty() {
        return Err(Finding::not_checked("The report simulates no line of constant velocity across eq 16."));
    }
    let eq16_pa = emergence::normal_stress_of_eq_16(context.equations, slider, BITS)
        .ok_or_else(|| Finding::failing("Eq 16 as stated gives no normal stress."))?;
    let crossed: Vec<Crossed> = lines.iter().map(|line| Crossed::new(line, slider, &eq16_pa)).collect();
    let begins = Draft::new("where small deviations begin to oscillate");
    let begins = crossed.iter().fold(begins, |draft, line| {
        let velocity = line.velocity();
        draft
            .part(
                format!("at V_l = {velocity} m/s the exact boundary is at eq 16"),
                line.on_the_boundary(context.kind),
            )
            .part(
                format!("at V_l = {velocity} m/s simulations begin to oscillate there"),
                line.in_simulations(),
            )
    });
    let seen = Draft::new("where the recorded velocity first shows an oscillation");
    let seen = crossed.iter().fold(seen, |draft, line| {
        draft.part(format!("at V_l = {} m/s it is visible from eq 16 on", line.velocity()), line.visible())
    });
    Ok(of_readings([begins, seen]))
}

impl<'c> Crossed<'c> {
    fn new(line: &'c StressOnset, slider: &Slider<Rational>, eq16_pa: &Ball) -> Self {
        let stress = Rational::from_f64(eq16_pa.to_f64()).unwrap_or_default();
        let velocity = line.loading_velocity_m_per_s.clone();
        let leading = slider.at(stress, velocity).groups().inertial_parameter;
        Self { line, eq16_pa: eq16_pa.clone(), leading }
    }

    fn velocity(&self) -> String {
        rational_to_decimal(&self.line.loading_velocity_m_per_s, 4)
    }

    fn on_the_boundary(&self, kind: Kind) -> Finding {
        let excess = self.line.boundary_pa.clone() / &self.eq16_pa - Ball::from(1);
        let most = Ball::from_rational(&(self.leading.clone() * LEADING_ERRORS), BITS);
        let is_near = excess.upper() <= most.lower() && excess.lower() >= (-most).upper();
        let leading = round_digits(nearest_f64(&self.leading), 4);
        let digits = certain_digits(&excess, 4);
        Finding::from_evidence(Evidence::Enclosure {
            quantity: format!(
                "V_l = {} m/s: σ of eq 16; of the exact boundary; exact/eq 16 − 1; η at eq 16",
                self.velocity()
            ),
            value: format!(
                "{} Pa; {} Pa; {digits}; {leading}",
                certain_digits(&self.eq16_pa, 8),
                certain_digits(&self.line.boundary_pa, 8)
            ),
        })
        .require(is_near, || {
            format!("it differs by a relative {digits}, although the next order allows at most {LEADING_ERRORS} × {leading}")
        })
        .near(kind, &Deviations::new(Measure::Place, [(libm::log10(1.0 + excess.to_f64()), 0.0)]))
    }

    fn in_simulations(&self) -> Finding {
        let boundary = self.line.boundary_pa.to_f64();
        self.line.seen.iter().fold(self.with_seen(), |finding, seen| {
            let law = seen.law.as_str();
            let Some(exists) = &seen.exists else {
                return finding.refuted(format!("{law} law: no oscillation was found"));
            };
            let distance = libm::log10(exists.value / boundary);
            finding.require(distance.abs() <= exists.error_dex, || {
                format!("{law} law: it begins {} dex from the exact boundary", round_digits(distance, 2))
            })
        })
    }

    fn visible(&self) -> Finding {
        let shown = || self.line.seen.iter().flat_map(|seen| [seen.second_rise, seen.undershoot]);
        let allowed = libm::log10(1.0 + f64::from(LEADING_ERRORS) * nearest_f64(&self.leading));
        let is_near = |found: Option<Located>| {
            found.is_some_and(|found| self.dex(&found).abs() <= allowed + found.error_dex)
        };
        let places = |of: fn(&SeenOnset) -> Option<Located>| {
            let place = |seen: &SeenOnset| {
                let dex = of(seen)
                    .map_or("nowhere".into(), |found| format!("{} dex", round_digits(self.dex(&found), 3)));
                format!("{} law {dex}", seen.law.as_str())
            };
            self.line.seen.iter().map(place).collect::<Vec<_>>().join(", ")
        };
        self.with_seen().require(shown().all(is_near), || {
            format!(
                "a second rise is visible from {} and an undershoot from {} above eq 16",
                places(|seen| seen.second_rise),
                places(|seen| seen.undershoot)
            )
        })
    }

    /// log10 of a normal stress over that of eq 16.
    fn dex(&self, located: &Located) -> f64 {
        libm::log10(located.value / self.eq16_pa.to_f64())
    }

    /// A finding that starts from what all laws show on the line.
    fn with_seen(&self) -> Finding {
        let finding = self.line.seen.iter().fold(None, |finding: Option<Finding>, seen| {
            let evidence = self.evidence(seen);
            Some(match finding {
                None => Finding::from_evidence(evidence),
                Some(finding) => finding.with_evidence(evidence),
            })
        });
        finding.unwrap_or_else(|| Finding::not_checked("No law was simulated on this line."))
    }

    fn evidence(&self, seen: &SeenOnset) -> Evidence {
        let places = [seen.exists, seen.second_rise, seen.undershoot];
        let dex = |found: Option<Located>| {
            found.map_or("none".into(), |found| format!("{} dex", round_digits(self.dex(&found), 4)))
        };
        let errors = places.map(|found| found.map_or(0.0, |found| found.error_dex));
        Evidence::Simulation {
            quantity: format!(
                "V_l = {} m/s, {} law: log10 of σ divided by that of eq 16, where small deviations begin to oscillate; where a second rise is visible; where an undershoot is visible",
                self.velocity(),
                seen.law.as_str()
            ),
            value: places.map(dex).join("; "),
            error: format!("{} dex", round_digits(errors.into_iter().fold(0.0, f64::max), 2)),
            runs: places.len(),
        }
    }
}

/// The colours of fig 4 by rising velocity.
const COLOURS: [&str; 5] = ["purple", "green", "blue", "red", "black"];

/// One run of fig 4 with what is seen of it.
struct Coloured<'c> {
    colour: &'static str,
    run: &'c ShownRun,
    swing: Swing,
    error: f64,
}

pub(super) fn visible_onset(context: &Context) -> Result<Finding, Finding> {
    let (scene, _) = scene(context)?;
    let missing =
        || Finding::not_checked("The report does not have five runs at each normal stress of fig 4.");
    let found = scene.onset.as_ref().ok_or_else(missing)?;
    let visible = nearest_f64(&found.visible);
    let lines: Vec<&Onset> =
        found.lines.iter().filter(|line| line.asymptote == Asymptote::InertialLower).collect();
    let draft = Draft::new("the colours as five quarter decades around eq 20");
    let mut draft = (!lines.is_empty()).then_some(draft).ok_or_else(missing)?;
    let mut below = Vec::new();
    for line in lines {
        let runs = coloured(line).ok_or_else(missing)?;
        let stress = rational_to_decimal(&line.normal_stress_pa, 4);
        let [purple, green, blue, red, black] = &runs[..] else { return Err(missing()) };
        draft = draft
            .part(
                format!("σ = {stress} Pa: purple and green show no vibration"),
                no_vibration(&[purple, green]),
            )
            .part(
                format!("σ = {stress} Pa: blue shows a short peak and no vibration"),
                one_peak(blue, visible),
            )
            .part(
                format!("σ = {stress} Pa: red and black vibrate near the natural frequency"),
                vibrate(&[red, black], visible),
            );
        below.extend([purple.swing.overshoot, green.swing.overshoot]);
    }
    let least = below.into_iter().fold(f64::INFINITY, f64::min);
    Ok(of_readings([draft]).remark(format!(
        "The short peak does not single out the blue runs: purple and green have it too, {} % of V_l and more above V_l.",
        round_digits(100.0 * least, 3)
    )))
}

fn coloured(line: &Onset) -> Option<Vec<Coloured<'_>>> {
    let colour = |(colour, run): (&&'static str, &'_ ShownRun)| run.swing.map(|_| *colour);
    let complete = line.shown.len() == COLOURS.len()
        && COLOURS.iter().zip(&line.shown).all(|pair| colour(pair).is_some());
    let runs = COLOURS.into_iter().zip(&line.shown);
    let runs = runs
        .filter_map(|(colour, run)| run.swing.map(|(swing, error)| Coloured { colour, run, swing, error }));
    complete.then(|| runs.collect())
}

/// Evidence from some of the runs.
fn from_runs(runs: &[&Coloured]) -> Finding {
    let ratio = |one: &&Coloured| {
        format!("{} at {} V_20", one.colour, round_digits(one.run.velocity_over_asymptote, 3))
    };
    let value = |one: &&Coloured| {
        let shares = [one.swing.overshoot, one.swing.second_rise, one.swing.undershoot];
        shares.map(|share| round_digits(share, 4)).join(", ")
    };
    let join = |text: &dyn Fn(&&Coloured) -> String| runs.iter().map(text).collect::<Vec<_>>().join("; ");
    let error = runs.iter().map(|one| one.error).fold(0.0, f64::max);
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!("{}: first peak above V_l, second rise, undershoot, in V_l", join(&ratio)),
        value: join(&value),
        error: format!("{} of V_l", round_digits(error, 1)),
        runs: runs.len(),
    })
}

fn no_vibration(runs: &[&Coloured]) -> Finding {
    let vibrates =
        |one: &&&Coloured| one.run.oscillates || one.swing.second_rise.max(one.swing.undershoot) > one.error;
    let wrong = runs.iter().find(vibrates);
    from_runs(runs).require(wrong.is_none(), || {
        wrong.map_or_else(String::new, |one| format!("{} oscillates", one.colour))
    })
}

fn one_peak(blue: &Coloured, visible: f64) -> Finding {
    let seen = blue.swing.second_rise.max(blue.swing.undershoot);
    from_runs(&[blue])
        .require(blue.run.oscillates, || "blue lies below the exact boundary".into())
        .require(blue.swing.overshoot > visible, || "V has no peak above V_l".into())
        .require(seen < visible, || format!("V swings by {} V_l after its peak", round_digits(seen, 3)))
}

fn vibrate(runs: &[&Coloured], visible: f64) -> Finding {
    let inertial = |one: &&&Coloured| one.run.slip_mode != SlipMode::InertialUnderdampedOscillation;
    let still = |one: &&&Coloured| one.swing.second_rise < visible;
    let names = |wrong: Option<&&Coloured>| wrong.map_or_else(String::new, |one| one.colour.to_string());
    let (slow, still) = (runs.iter().find(inertial), runs.iter().find(still));
    from_runs(runs)
        .require(slow.is_none(), || format!("{} is not inertial", names(slow)))
        .require(still.is_none(), || format!("{} shows no second rise", names(still)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::Verdict;

    fn shown(oscillates: bool, slip_mode: SlipMode) -> ShownRun {
        ShownRun {
            velocity_over_asymptote: 1.0,
            loading_velocity_m_per_s: 1e-3,
            oscillates,
            slip_mode,
            swing: None,
            history: Vec::new(),
        }
    }

    fn coloured(run: &ShownRun, second_rise: f64) -> Coloured<'_> {
        Coloured {
            colour: "blue",
            run,
            swing: Swing { overshoot: 0.2, undershoot: 0.0, second_rise },
            error: 1e-6,
        }
    }

    #[test]
    fn each_colour_of_fig_4_is_refuted_by_a_run_of_another_kind() {
        let (visible, inertial) = (0.01, SlipMode::InertialUnderdampedOscillation);
        let [below, above] = [(false, SlipMode::OverdampedStableSliding), (true, inertial)]
            .map(|(oscillates, mode)| shown(oscillates, mode));
        let quiet = coloured(&below, 0.0);
        assert_eq!(no_vibration(&[&quiet]).verdict, Verdict::Holds);
        assert_eq!(no_vibration(&[&coloured(&below, 0.1)]).verdict, Verdict::Fails);
        assert_eq!(one_peak(&coloured(&above, 1e-3), visible).verdict, Verdict::Holds);
        assert_eq!(one_peak(&quiet, visible).verdict, Verdict::Fails);
        assert_eq!(one_peak(&coloured(&above, 0.1), visible).verdict, Verdict::Fails);
        assert_eq!(vibrate(&[&coloured(&above, 0.1)], visible).verdict, Verdict::Holds);
        assert_eq!(vibrate(&[&coloured(&above, 1e-3)], visible).verdict, Verdict::Fails);
        assert_eq!(vibrate(&[&coloured(&below, 0.1)], visible).verdict, Verdict::Fails);
    }
}
