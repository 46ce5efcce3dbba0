//! The boundary max Im(s) = 0: its areas and its asymptotes.

use crate::claims::check::Asked;
use crate::claims::{Evidence, Finding};
use crate::experiments::{Context, SceneOutcome};
use slipmode_theory::asymptote_series::{self, AsymptoteSeries};

/// The order to which the error series of the asymptotes are evidence.
pub(super) const SERIES_ORDER: usize = 2;

/// The error series of the equations of these numbers, each of which belongs to an end of the boundary of its own.
pub(super) fn error_series(context: &Context, asked: Asked) -> Finding {
    let series = match asymptote_series::derive(context.equations, SERIES_ORDER) {
        Ok(series) => series,
        Err(refutation) => return Finding::from_proofs([Err(refutation)]),
    };
    let named: Vec<&AsymptoteSeries> =
        series.iter().filter(|series| asked.of.contains(&series.equation)).collect();
    if named.len() != asked.of.len() {
        return Finding::not_checked(format!(
            "Not each of these is the number of one asymptote: {}.",
            asked.of.join(", ")
        ));
    }
    // Two equations for one end have the same series.
    let is_new = |at: &usize| {
        let of = |one: &AsymptoteSeries| (one.quantity, one.coefficients.clone());
        named[..*at].iter().all(|earlier| of(earlier) != of(named[*at]))
    };
    let (wanted, known) = (asked.of.len(), (0..named.len()).filter(is_new).count());
    Finding::from_proofs(named.iter().map(|series| Ok(series.proof.clone())))
        .require(wanted == known, || format!("{wanted} equations and {known} different asymptotes"))
}

/// How many areas the computed map shows: a look at the picture next to the proof.
pub(super) fn areas_on_map(scene: Option<&SceneOutcome>) -> Option<Vec<Evidence>> {
    let map = scene?.map.as_ref()?;
    let real = map.map(|point| point.max_imaginary_per_s.is_zero());
    let quantity = "Connected areas with max Im(s) = 0 on the grid of the map";
    Some(vec![Evidence::sample(quantity, real.areas_of(&true).to_string(), map.values.len())])
}
