//! Claims Z: the simplified maps, and what the criteria for vibration depend on.

use std::collections::BTreeSet;

use crate::claims::criteria::{z2, z5};
use crate::claims::ledger::premise;
use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure, enclosed};
use crate::claims::{Check, Evidence, Finding};
use crate::experiments::zones::{InertialLine, LineCount, ZonesOutcome};
use crate::experiments::{Context, Need, SceneOutcome};
use crate::scene::Kind;
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_core::stability::SlipMode;
use slipmode_core::theory::{asymptote_series, frequency};

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "Z1",
        criterion: "The exact map has five slip modes for a < b and four for a > b, and the boundary is within a quarter decade of the lines of the named equations.",
        not_established: "Whether simulations show the same modes: see the N claims.",
        needs: &[Need::Map, Need::Zones, Need::Tolerance],
        equations: &["8", "9", "12", "13", "20", "23", "inertial-parameter", "natural-frequency"],
        rests_on: &["B1", "B9", "S1"],
        decide: z1,
    },
    Check {
        id: "Z2",
        criterion: "Points exist with η > 1 and no underdamped oscillation.",
        not_established: "The usefulness of η > 1 as a rule of thumb for a given apparatus.",
        needs: &[],
        equations: &["8", "9"],
        rests_on: &["B1"],
        decide: z2,
    },
    Check {
        id: "Z5",
        criterion: "Each criterion is an identity of the linear theory or has a quantified error.",
        not_established: "The effect of finite disturbances.",
        needs: &[Need::Tolerance],
        equations: &["8", "9", "14", "15", "16", "17", "18", "19", "20", "23"],
        rests_on: &["B2", "B4", "B5", "S1", "S6"],
        decide: z5,
    },
    Check {
        id: "Z7",
        criterion: "Each boundary between slip modes has an equation of the paper that it tends to or that draws it on the map.",
        not_established: "Whether simulated motion changes at the same place: see the N claims.",
        needs: &[Need::Map, Need::Zones],
        equations: &["8", "9", "12", "13", "15", "16", "18", "20"],
        rests_on: &["S4", "B10"],
        decide: z7,
    },
    Check {
        id: "Z8",
        criterion: "The map of eqs 9, 15, 16, 18 and 20 and a straight line between the corners of the asymptotes puts every point into its exact slip mode.",
        not_established: "The line that fig 7 shows: the text does not define it, and the straight line is an assumption.",
        needs: &[Need::Map, Need::Zones],
        equations: &[],
        rests_on: &["Z1"],
        decide: z8,
    },
];

fn z1(context: &Context) -> Finding {
    let scenes = [
        (context.outcome.potentially_unstable(), 5, "a < b"),
        (context.outcome.intrinsically_stable(), 4, "a > b"),
    ];
    let proved = Finding::from_proof(frequency::low_frequency_zone(context.equations))
        .with_premise(premise("S1", context));
    let mut draft = Draft::new("the zones of the exact map, and the lines between them")
        .part("at low frequency the area between eqs 15 and 16 is one zone, which K = K_c divides", proved);
    for (scene, expected, case) in scenes {
        let Some(zones) = scene.and_then(|scene: &SceneOutcome| scene.zones.as_ref()) else {
            return Finding::not_checked(format!("The report has no zones for {case}."));
        };
        let modes: BTreeSet<&str> = zones.exact.values.iter().map(|mode| mode.as_str()).collect();
        let found = modes.len();
        let counted = Finding::from_evidence(modes_evidence(zones, &modes, case))
            .require(found == expected, || {
                format!("{found} slip modes: {}", modes.iter().copied().collect::<Vec<_>>().join(", "))
            });
        let points = zones.exact.values.len();
        let drawn = lines_near(scene, context.kind)
            .with_supporting(Evidence::Sample {
                quantity: format!("Points where fig 7's zones and the exact slip modes differ, {case} (stability or oscillation; slip mode)"),
                value: format!("{}; {}", zones.disagreeing_areas, zones.disagreeing_modes),
                points,
            })
            .remark(format!(
                "The lines give the wrong stability or oscillation on {} % of the points of the map for {case}.",
                percent(zones.disagreeing_areas, points)
            ));
        draft = draft
            .part(format!("{case}: {expected} slip modes"), counted)
            .part(format!("{case}: the lines are where stability or oscillation change"), drawn);
    }
    of_readings([draft])
        .remark("The line between inertial and non-inertial oscillation follows from none of the five equations. It needs a threshold on ω/ω_n, or another line such as V0 = V_c.")
}

/// Whether the boundary is near the lines of eqs 15, 16, 18 and 20. On each arc the error is largest where its two lines meet.
fn lines_near(scene: Option<&SceneOutcome>, kind: Kind) -> Finding {
    let Some(found) = scene.and_then(|scene| scene.tolerance.as_ref()) else {
        return Finding::not_checked("The report computes no error of the asymptotes.");
    };
    let upper = found
        .corners
        .upper
        .as_ref()
        .map(|pair| (pair.quasi_static.clone() + Ball::from(1)).ln() / Ball::from(10).ln());
    let dex = [upper, Some(found.corners.lower_worst_log10.clone())];
    let evidence = Evidence::Enclosure {
        quantity: "Largest log10 distance of the upper and of the lower arc from their lines".into(),
        value: dex.iter().flatten().map(|dex| certain_digits(dex, 6)).collect::<Vec<_>>().join("; "),
    };
    let deviations = dex.iter().flatten().map(enclosed);
    Finding::from_evidence(evidence).near(kind, &Deviations::new(Measure::Place, deviations))
}

/// A distance on the map, with the step of its grid as its error.
fn place(zones: &ZonesOutcome, off_dex: f64) -> Deviations {
    let step = |axis: &[f64]| match axis {
        [first, second, ..] => libm::log10(second / first),
        _ => 0.0,
    };
    let step = step(&zones.exact.loading_velocity_m_per_s).max(step(&zones.exact.normal_stress_pa));
    Deviations::new(Measure::Place, [(off_dex, step)])
}

/// The best of the lines that could divide inertial from non-inertial oscillation.
fn best_line(zones: &ZonesOutcome) -> Option<&LineCount> {
    zones.inertial_lines.iter().min_by_key(|count| count.misplaced)
}

fn z7(context: &Context) -> Finding {
    let series = match asymptote_series::derive(context.equations, 1) {
        Ok(series) => series,
        Err(refutation) => return Finding::from_proofs([Err(refutation)]),
    };
    let tends = |numbers: [&str; 2]| {
        let named = series.iter().filter(|series| numbers.contains(&series.equation));
        Finding::from_proofs(named.map(|series| Ok(series.proof.clone())))
    };
    let zones = context.outcome.potentially_unstable().and_then(|scene| scene.zones.as_ref());
    let inertial = match zones.and_then(|zones| Some((zones, best_line(zones)?))) {
        None => Finding::not_checked("The report has no zones for a < b."),
        Some((zones, best)) => {
            let points = zones.exact.values.len();
            let finding = Finding::from_evidence(Evidence::Sample {
                quantity: format!(
                    "Points that the best of {} lines ({}) leaves in another slip mode",
                    zones.inertial_lines.len(),
                    best.line.as_str()
                ),
                value: best.misplaced.to_string(),
                points,
            });
            finding.require(best.misplaced == 0, || format!("the paper has no equation for it, and the best of {} lines leaves {} % of the points in another slip mode", zones.inertial_lines.len(), percent(best.misplaced, points)))
        }
    };
    of_readings([Draft::new("every boundary between slip modes has an asymptotic equation")
        .part("overdamped and underdamped: eqs 16 and 20", tends(["16", "20"]))
        .part("stick-slip with real roots and with a complex pair: eqs 15 and 18", tends(["15", "18"]))
        .part("stable and unstable: eqs 12 and 13", premise("S4", context))
        .part("inertial and non-inertial", inertial)])
}

fn z8(context: &Context) -> Finding {
    let scenes = [
        (context.outcome.potentially_unstable(), "a < b"),
        (context.outcome.intrinsically_stable(), "a > b"),
    ];
    let part = |draft: Draft, (scene, case): (Option<&SceneOutcome>, &str)| {
        let zones = scene.and_then(|scene| scene.zones.as_ref());
        let straight = zones
            .and_then(|zones| zones.inertial_lines.iter().find(|count| count.line == InertialLine::Corners));
        draft.part(
            case,
            match zones.zip(straight) {
                None => Finding::not_checked(format!("The report has no zones for {case}.")),
                Some((zones, straight)) => drawn_map(zones, straight, case, context.kind),
            },
        )
    };
    of_readings([scenes
        .into_iter()
        .fold(Draft::new("the lines divide the plane into the zones of fig 7"), part)])
}

/// The map with the straight line between the corners: how often it is wrong, next to the other lines.
fn drawn_map(zones: &ZonesOutcome, straight: &LineCount, case: &str, kind: Kind) -> Finding {
    let points = zones.exact.values.len();
    let counts =
        zones.inertial_lines.iter().map(|count| format!("{}: {}", count.line.as_str(), count.misplaced));
    let finding = Finding::from_evidence(Evidence::Sample {
        quantity: "Points in another slip mode than the exact one, for each line".into(),
        value: counts.collect::<Vec<_>>().join("; "),
        points,
    });
    finding.near(kind, &place(zones, zones.modes_off_dex)).remark(format!(
        "{case}: {} % of the points of the map are in another slip mode.",
        percent(straight.misplaced, points)
    ))
}

fn percent(part: usize, whole: usize) -> String {
    #[expect(clippy::cast_precision_loss, reason = "counts of grid points are far below 2^53")]
    round_digits(100.0 * part as f64 / whole as f64, 2)
}

fn modes_evidence(zones: &ZonesOutcome, modes: &BTreeSet<&str>, case: &str) -> Evidence {
    let areas: Vec<String> = SlipMode::ALL
        .iter()
        .filter(|mode| modes.contains(mode.as_str()))
        .map(|mode| format!("{} ({})", mode.as_str(), zones.exact.areas_of(mode)))
        .collect();
    Evidence::Sample {
        quantity: format!("Slip modes on the exact map for {case}, each with its number of connected areas"),
        value: areas.join(", "),
        points: zones.exact.values.len(),
    }
}
