//! The simplified maps, and the lines that divide them.

use std::collections::BTreeSet;

use crate::claims::computed::Asked;
use crate::claims::rule::{Deviations, Measure, enclosed};
use crate::claims::{Check, Evidence, Finding};
use crate::experiments::zones::{InertialLine, LineCount, ZonesOutcome};
use crate::experiments::{Context, Need, SceneOutcome};
use crate::scene::{Kind, cited};
use slipmode_core::number::Ball;
use slipmode_core::number::format::{certain_digits, round_digits};
use slipmode_core::stability::SlipMode;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "number-of-slip-modes",
        is_of_runs: false,
        roles: &[],
        needs: &[Need::Map, Need::Zones],
        decide: number_of_modes,
    },
    Check {
        name: "lines-on-the-map",
        is_of_runs: false,
        roles: &[],
        needs: &[Need::Map, Need::Zones, Need::Tolerance],
        decide: lines_on_the_map,
    },
    Check {
        name: "line-of-inertial-oscillation",
        is_of_runs: false,
        roles: &[],
        needs: &[Need::Map, Need::Zones],
        decide: |context, _| inertial_line(context),
    },
    Check {
        name: "zones-by-straight-lines",
        is_of_runs: false,
        roles: &[],
        needs: &[Need::Map, Need::Zones],
        decide: by_straight_lines,
    },
];

/// The first scene with a < b or with a > b, and its zones.
fn zones_of<'c>(context: &Context<'c>, case: &str) -> Result<(&'c SceneOutcome, &'c ZonesOutcome), Finding> {
    let scene = match case {
        "a < b" => context.outcome.potentially_unstable(),
        "a > b" => context.outcome.intrinsically_stable(),
        _ => None,
    };
    let zones = scene.and_then(|scene| Some((scene, scene.zones.as_ref()?)));
    zones.ok_or_else(|| Finding::not_checked(format!("The report has no zones for {case}.")))
}

/// Whether the exact map has this many slip modes.
fn number_of_modes(context: &Context, asked: Asked) -> Finding {
    let [case, number] = asked.of else { return Finding::from_proofs([]) };
    let zones = match zones_of(context, case) {
        Ok((_, zones)) => zones,
        Err(undecided) => return undecided,
    };
    let modes: BTreeSet<&str> = zones.exact.values.iter().map(|mode| mode.as_str()).collect();
    let found = modes.len();
    Finding::from_evidence(modes_evidence(zones, &modes, case)).require(found.to_string() == *number, || {
        format!("{found} slip modes: {}", modes.iter().copied().collect::<Vec<_>>().join(", "))
    })
}

/// Whether the boundary is near the lines that divide the map of fig 7, and how many points they put elsewhere.
fn lines_on_the_map(context: &Context, asked: Asked) -> Finding {
    let case = asked.first();
    let (scene, zones) = match zones_of(context, case) {
        Ok(found) => found,
        Err(undecided) => return undecided,
    };
    let points = zones.exact.values.len();
    lines_near(scene, context.kind)
        .with_supporting(Evidence::Sample {
            quantity: format!("Points where fig 7's zones and the exact slip modes differ, {case} (stability or oscillation; slip mode)"),
            value: format!("{}; {}", zones.disagreeing_areas, zones.disagreeing_modes),
            points,
        })
        .remark(format!(
            "The lines give the wrong stability or oscillation on {} % of the points of the map for {case}.",
            percent(zones.disagreeing_areas, points)
        ))
}

/// Whether the boundary is near the lines of eqs 15, 16, 18 and 20. On each arc the error is largest where its two lines meet.
fn lines_near(scene: &SceneOutcome, kind: Kind) -> Finding {
    let Some(found) = scene.tolerance.as_ref() else {
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

/// Whether one of the lines between inertial and non-inertial oscillation leaves every point in its slip mode.
fn inertial_line(context: &Context) -> Finding {
    let zones = context.outcome.potentially_unstable().and_then(|scene| scene.zones.as_ref());
    let Some((zones, best)) = zones.and_then(|zones| Some((zones, best_line(zones)?))) else {
        return Finding::not_checked("The report has no zones for a < b.");
    };
    let (points, lines) = (zones.exact.values.len(), zones.inertial_lines.len());
    let finding = Finding::from_evidence(Evidence::Sample {
        quantity: format!(
            "Points that the best of {lines} lines ({}) leaves in another slip mode",
            cited(best.line.as_str())
        ),
        value: best.misplaced.to_string(),
        points,
    });
    finding.require(best.misplaced == 0, || format!("the paper has no equation for it, and the best of {lines} lines leaves {} % of the points in another slip mode", percent(best.misplaced, points)))
}

/// Whether the map with straight lines between the corners puts every point into its slip mode.
fn by_straight_lines(context: &Context, asked: Asked) -> Finding {
    let case = asked.first();
    let zones = match zones_of(context, case) {
        Ok((_, zones)) => zones,
        Err(undecided) => return undecided,
    };
    match zones.inertial_lines.iter().find(|count| count.line == InertialLine::Corners) {
        None => Finding::not_checked(format!("The report has no zones for {case}.")),
        Some(straight) => drawn_map(zones, straight, case, context.kind),
    }
}

/// The map with the straight line between the corners: how often it is wrong, next to the other lines.
fn drawn_map(zones: &ZonesOutcome, straight: &LineCount, case: &str, kind: Kind) -> Finding {
    let points = zones.exact.values.len();
    let counts = zones
        .inertial_lines
        .iter()
        .map(|count| format!("{}: {}", cited(count.line.as_str()), count.misplaced));
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
