//! How good the criteria for oscillation are.

use crate::claims::boundary::SERIES_ORDER;
use crate::claims::computed::Asked;
use crate::claims::rule::{Deviations, Measure, enclosed};
use crate::claims::{BITS, Check, Evidence, Finding, Verdict};
use crate::experiments::tolerance::at_most_per_cent;
use crate::experiments::{Context, Need};
use crate::scene::Kind;
use crate::scene::cited;
use slipmode_algebra::Expression;
use slipmode_core::number::Ball;
use slipmode_core::number::format::certain_digits;
use slipmode_core::theory::asymptote_series;
use slipmode_core::theory::sufficient_inertia::sufficient_inertial_parameter;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "sufficient-inertia",
        is_of_runs: false,
        roles: &[],
        needs: &[],
        decide: sufficient_inertia,
    },
    Check {
        name: "errors-of-the-asymptotes",
        is_of_runs: false,
        roles: &asymptote_series::EQUATIONS,
        needs: &[Need::Tolerance],
        decide: errors_of_the_asymptotes,
    },
];

fn sufficient_inertia(context: &Context, asked: Asked) -> Finding {
    let finding = asked.proved();
    let bound = "η > η_c suffices, with (1 − 2η_c)³ = 27 (b/a) η_c², that is η_c = 1/(2 + 6√(b/a) cos(⅓ arccos √(a/b)))";
    let all = "η ≥ 1/8 suffices for all a < b; no smaller bound does";
    let slider = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let sharp = slider.and_then(|slider| sufficient_inertial_parameter(&slider.effect_ratio(), BITS));
    let value = sharp.map(|sharp| certain_digits(&sharp, 6));
    let of_scene = value.as_ref().map(|value| format!(" = {value} at the scene's b/a")).unwrap_or_default();
    let finding = finding
        .on("the upper area, which has real roots at every η")
        .remark(format!("For a < b and K > K_c every point with η > 1 is underdamped, so there the criterion is sufficient: {bound}{of_scene}; {all}."));
    match value {
        None => finding,
        Some(value) => {
            finding.with_evidence(Evidence::Enclosure { quantity: "η_c at the scene's b/a".into(), value })
        }
    }
}

/// The equations with the names of their largest errors.
const NUMBERS: [(&str, &str); 4] = [("15", "eq15"), ("16", "eq16"), ("18", "eq18"), ("20", "eq20")];

fn errors_of_the_asymptotes(context: &Context, asked: Asked) -> Finding {
    let series = match asymptote_series::derive(context.equations, SERIES_ORDER) {
        Ok(series) => series,
        Err(refutation) => return Finding::not_checked(refutation.to_string()),
    };
    let is_exact = series.iter().all(|one| one.coefficients.iter().all(Expression::is_zero));
    let proofs = series.into_iter().map(|series| Ok(series.proof));
    let finding = Finding::from_proofs(proofs).with_premise(asked.proved());
    // It fails by what is proved of the errors: without a proof nothing is known of them.
    if finding.verdict != Verdict::Holds {
        return Finding::not_checked(finding.counter_example.unwrap_or_default());
    }
    let tolerance = context.outcome.potentially_unstable().and_then(|scene| scene.tolerance.as_ref());
    let Some(corners) = tolerance.map(|tolerance| &tolerance.corners) else {
        return match context.kind {
            Kind::Universal => finding.require(is_exact, || {
                cited("{quasi-static-upper, quasi-static-lower, inertial-upper, inertial-lower} have the relative errors of their series")
            }),
            _ => Finding::not_checked("The report computes no error of the asymptotes."),
        };
    };
    let enclosure = |quantity: &str, value: &Ball| Evidence::Enclosure {
        quantity: cited(quantity),
        value: certain_digits(value, 6),
    };
    let upper = corners.upper.as_ref();
    let worst = [
        (
            "15",
            "at the V0 of the corner of {quasi-static-upper, inertial-upper}",
            upper.map(|errors| &errors.quasi_static),
        ),
        ("16", "at the cusp", Some(&corners.cusp.quasi_static)),
        (
            "18",
            "at the V0 of the corner of {quasi-static-upper, inertial-upper}",
            upper.map(|errors| &errors.inertial),
        ),
        ("20", "at the cusp", Some(&corners.cusp.inertial)),
    ];
    let worst = || worst.iter().filter_map(|(number, place, error)| Some((number, place, (*error)?)));
    let listed: Vec<String> = worst()
        .map(|(number, place, error)| format!("{} (eq {number}, {})", at_most_per_cent(error), cited(place)))
        .collect();
    let finding = worst().fold(finding, |finding, (number, place, error)| {
        finding.with_evidence(Evidence::Enclosure {
            quantity: cited(&format!(
                "Largest relative error of eq {number} on its arc, {place} ({})",
                at_most_per_cent(error)
            )),
            value: certain_digits(error, 6),
        })
    });
    let most = |(number, _, error): (&&str, _, &Ball)| {
        let named = NUMBERS.iter().find(|(named, _)| named == number)?;
        Some((*named, at_most_per_cent(error).trim_start_matches('−').to_owned()))
    };
    let most: Vec<_> = worst().filter_map(most).collect();
    let deviations = worst().map(|(_, _, error)| enclosed(error));
    // Without one of the arcs the sentence on all four has no replacement.
    let has_all = most.len() == NUMBERS.len();
    let finding = most
        .into_iter()
        .filter(|_| has_all)
        .fold(finding, |finding, ((_, name), percent)| finding.number(name, percent));
    finding
        .near(context.kind, &Deviations::new(Measure::Value, deviations))
        .remark(format!("The largest relative errors on the arcs of the boundary: {}.", listed.join(", ")))
        .with_evidence(enclosure(
            "V_exact/V_20 − 1 at the σ of the corner of {quasi-static-lower, inertial-lower}",
            &corners.lower_at_corner_normal_stress,
        ))
        .with_evidence(enclosure(
            "Largest log10 distance between the lower arc and the nearer of {quasi-static-lower, inertial-lower}",
            &corners.lower_worst_log10,
        ))
}
