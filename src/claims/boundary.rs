//! Claims B: the boundary max Im(s) = 0, its areas and its asymptotes.

use crate::claims::exchange::{b6, b7, b8};
use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::Region;
use crate::claims::{Check, Evidence, Finding};
use crate::experiments::{Context, Need, SceneOutcome};
use slipmode_algebra::{Proof, Refutation};
use slipmode_core::theory::areas::{self, Effects};
use slipmode_core::theory::asymptote_series::{self, AsymptoteSeries};
use slipmode_core::theory::{boundary, inertial};

/// The order to which the error series of the asymptotes are evidence.
pub(super) const SERIES_ORDER: usize = 2;

pub(super) const CHECKS: &[Check] = &[
    Check {
        id: "B1",
        criterion: "For a < b the set max Im(s) = 0 has two connected parts over the whole (V, σ) plane, one with positive and one with negative roots.",
        not_established: "The shape of the areas: see the chapter on the boundary.",
        needs: &[Need::Map],
        equations: &["8", "9", "inertial-parameter"],
        rests_on: &["L3"],
        decide: |context| two_areas(context, Effects::Weakening, 1),
    },
    Check {
        id: "B4",
        criterion: "Eq 8 times σD_c/V0 tends to eq 17 as D_c → 0, whose discriminant vanishes at eq 18, and the boundary's upper arc tends to eq 18.",
        not_established: "The distance between boundary and eq 18 at a given D_c: see the chapter on the asymptotes.",
        needs: &[],
        equations: &["8", "15", "16", "17", "18", "20"],
        rests_on: &["L3"],
        decide: |context| {
            let limit = inertial::small_slip_distance(context.equations);
            inertial_asymptote(
                context,
                limit,
                "18",
                "D_c → 0 in eq 8 gives eq 17, whose roots are real up to eq 18",
            )
        },
    },
    Check {
        id: "B5",
        criterion: "Eq 8 tends to s times eq 19 as D_c → ∞, whose discriminant vanishes at eq 20, and the boundary's lower arc tends to eq 20.",
        not_established: "The distance between boundary and eq 20 at a given D_c: see the chapter on the asymptotes.",
        needs: &[],
        equations: &["8", "15", "16", "18", "19", "20"],
        rests_on: &["L3"],
        decide: |context| {
            let limit = inertial::large_slip_distance(context.equations);
            let words = "D_c → ∞ in eq 8 gives eq 19, whose roots are real up to eq 20";
            inertial_asymptote(context, limit, "20", words).remark(
                "The paper describes eq 19 as eq 17 with a − b in place of a. The reverse is true: eq 17 has a − b where eq 19 has a.",
            )
        },
    },
    Check {
        id: "B6",
        criterion: "None of the four equations changes when a and b are exchanged.",
        not_established: "The effect of the exchange on the exact boundary: see B7.",
        needs: &[],
        equations: &["15", "16", "18", "20"],
        rests_on: &["B2", "B4", "B5"],
        decide: b6,
    },
    Check {
        id: "B7",
        criterion: "max Im(s) at every (V, σ) is the same for (a, b) and for (b, a).",
        not_established: "Whether the difference is visible in the printed figure.",
        needs: &[Need::Map],
        equations: &["8", "14"],
        rests_on: &["L3"],
        decide: b7,
    },
    Check {
        id: "B8",
        criterion: "Eqs 15, 16, 18 and 20 give the same lines for (a, b) and for (b, a).",
        not_established: "Which line the authors drew in which figure.",
        needs: &[],
        equations: &["15", "16", "18", "20"],
        rests_on: &["B6"],
        decide: b8,
    },
    Check {
        id: "B9",
        criterion: "Each of the areas (i)-(iv) has a point, for a < b, a = b and a > b.",
        not_established: "Whether the four areas match the slip modes: see Z1.",
        needs: &[],
        equations: &["8", "9", "inertial-parameter"],
        rests_on: &["B1", "S1"],
        decide: b9,
    },
    Check {
        id: "B10",
        criterion: "For a < b the boundary has two ends for each of its connected areas, and each end tends to one of eqs 15, 16, 18 and 20.",
        not_established: "How far the asymptotes are from the boundary: see Z5.",
        needs: &[],
        equations: &["8", "9", "15", "16", "18", "20", "inertial-parameter"],
        rests_on: &["B1", "B4", "B5"],
        decide: b10,
    },
    Check {
        id: "B11",
        criterion: "For a > b the set max Im(s) = 0 has two connected parts over the whole (V, σ) plane, both with negative roots.",
        not_established: "Where the two zones are: see the chapter on the boundary.",
        needs: &[Need::Map],
        equations: &["8", "9", "inertial-parameter"],
        rests_on: &["L3"],
        decide: |context| two_areas(context, Effects::Strengthening, 0),
    },
];

/// B1 and B11: the number of separate areas without imaginary part, and how many of them are unstable.
fn two_areas(context: &Context, effects: Effects, wanted_unstable: usize) -> Finding {
    let areas = match areas::count(context.equations, effects) {
        Ok(areas) => areas,
        Err(refutation) => return Finding::from_proofs([Err(refutation)]),
    };
    let (real, unstable) = (areas.real_areas, areas.unstable_real_areas);
    let scene = match effects {
        Effects::Strengthening => context.outcome.intrinsically_stable(),
        _ => context.outcome.potentially_unstable(),
    };
    let finding = Finding::from_proofs([
        Ok(areas.proof),
        boundary::prove(context.equations),
        boundary::cusp(context.equations),
    ])
    .require(real == 2 && unstable == wanted_unstable, || {
        format!("{real} areas, {unstable} of them unstable")
    })
    .remark("The proof covers all σ > 0 and V > 0, not only the rectangle of the figure.");
    match scene.and_then(areas_on_map) {
        Some(evidence) => finding.with_supporting(evidence),
        None => finding,
    }
}

/// Two ends for each connected area's boundary, which is one curve, and one series for each end.
fn b10(context: &Context) -> Finding {
    let found = areas::count(context.equations, Effects::Weakening)
        .and_then(|areas| Ok((areas, asymptote_series::derive(context.equations, SERIES_ORDER)?)));
    let (areas, series) = match found {
        Ok(found) => found,
        Err(refutation) => return Finding::from_proofs([Err(refutation)]),
    };
    // Two equations for one end have the same series.
    let is_new = |at: &usize| {
        let of = |one: &AsymptoteSeries| (one.quantity, one.coefficients.clone());
        series[..*at].iter().all(|earlier| of(earlier) != of(&series[*at]))
    };
    let (ends, known) = (2 * areas.real_areas, (0..series.len()).filter(is_new).count());
    let proofs = series.into_iter().map(|series| Ok(series.proof));
    Finding::from_proofs([Ok(areas.proof), boundary::prove(context.equations)].into_iter().chain(proofs))
        .require(ends == known, || format!("{ends} ends and {known} different asymptotes"))
        .remark("\"Four different asymptotes can be identified\" is read as: there are no others.")
}

/// How many areas the computed map shows: a look at the picture next to the proof.
fn areas_on_map(scene: &SceneOutcome) -> Option<Evidence> {
    let map = scene.map.as_ref()?;
    let real = map.map(|point| point.max_imaginary_per_s.is_zero());
    Some(Evidence::Sample {
        quantity: "Connected areas with max Im(s) = 0 on the grid of the map".into(),
        value: real.areas_of(&true).to_string(),
        points: map.values.len(),
    })
}

/// B4 and B5: the equation of a limit of eq 8, and that the boundary tends to it.
fn inertial_asymptote(
    context: &Context,
    limit: Result<Proof, Refutation>,
    number: &'static str,
    words: &str,
) -> Finding {
    let tends = asymptote_series::derive(context.equations, SERIES_ORDER).map(|series| {
        series.into_iter().filter(|series| series.equation == number).map(|series| series.proof).collect()
    });
    let tends = tends.map_or_else(
        |refutation| vec![Err(refutation)],
        |proofs: Vec<Proof>| proofs.into_iter().map(Ok).collect(),
    );
    let small = if number == "18" { "κ" } else { "1/κ" };
    of_readings([Draft::new("the limit of eq 8, and the boundary near it").part(words, Finding::from_proof(limit)).part(
        format!("the boundary tends to eq {number}: the relative error in V0 at the same σ is a series in {small} without constant term"),
        Finding::from_proofs(tends),
    )])
}

fn b9(context: &Context) -> Finding {
    let mut proofs = Vec::new();
    let mut complete = Vec::new();
    let mut lacking = Vec::new();
    for effects in Effects::ALL {
        match areas::count(context.equations, effects) {
            Err(refutation) => proofs.push(Err(refutation)),
            Ok(areas) => {
                let names: Vec<&str> = ["(i)", "(ii)", "(iii)", "(iv)"]
                    .into_iter()
                    .zip(areas.exists)
                    .filter_map(|(name, exists)| exists.then_some(name))
                    .collect();
                if names.len() == 4 { &mut complete } else { &mut lacking }.push(format!(
                    "{}: {}",
                    effects.as_str(),
                    names.join(", ")
                ));
                proofs.push(Ok(areas.proof));
            }
        }
    }
    let finding = Finding::from_proofs(proofs);
    if lacking.is_empty() {
        return finding;
    }
    let outside = format!("Existing areas for {}.", lacking.join("; for "));
    finding.within(Region { inside: complete.join("; "), outside })
}
