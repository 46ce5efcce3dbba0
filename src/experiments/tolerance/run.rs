//! Where each asymptote of a slider is good to a given relative error, and whether its error shrinks as derived.
use crate::experiments::tolerance::ToleranceSection;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational};
use slipmode_core::stability::Asymptote;
use slipmode_core::stability::deviation::{ConvergenceStep, CornerErrors, convergence, corner_errors};
use slipmode_core::stability::tolerance::{Limit, enclosed, limit};

/// How far one asymptote can be used at one tolerance.
#[derive(Debug, Clone)]
pub struct ToleranceRow {
    /// The relative error allowed.
    pub tolerance: Rational,
    /// Where it is reached.
    pub limit: Limit,
    /// V0 in m/s (eqs 15 and 16) or σ in Pa (eqs 18 and 20) there.
    pub in_si: Ball,
}

/// What a user may rely on.
#[derive(Debug, Clone)]
pub struct ToleranceOutcome {
    /// By asymptote, then by tolerance as the scene lists them.
    pub rows: Vec<ToleranceRow>,
    /// The worst errors at this β.
    pub corners: CornerErrors,
    /// Each asymptote followed to its end, decade by decade.
    pub convergence: Vec<(Asymptote, Vec<ConvergenceStep>)>,
}

/// Digits of each enclosure: more than any table or figure shows.
const DIGITS: u32 = 20;

/// Decades over which the order of convergence is measured.
const DECADES: u32 = 8;

/// Computes the limits; asymptotes that do not exist (eqs 15 and 18 for a = b) have no rows.
pub(crate) fn tolerance_limits(
    parameters: &Slider<Rational>,
    section: &ToleranceSection,
) -> ToleranceOutcome {
    let beta = parameters.effect_ratio();
    let slider = enclosed(parameters, DIGITS);
    let rows = Asymptote::ALL
        .into_iter()
        .flat_map(|asymptote| section.relative.iter().map(move |tolerance| (asymptote, tolerance)))
        .filter_map(|(asymptote, tolerance)| {
            let limit = limit(asymptote, &beta, tolerance, DIGITS)?;
            Some(ToleranceRow { tolerance: tolerance.clone(), in_si: limit.in_si(&slider), limit })
        })
        .collect();
    let followed = |asymptote| (asymptote, convergence(asymptote, &beta, DECADES, DIGITS));
    ToleranceOutcome {
        rows,
        corners: corner_errors(&beta, DIGITS),
        convergence: Asymptote::ALL.map(followed).into(),
    }
}
