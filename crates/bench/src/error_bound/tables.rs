//! The table of true and estimated errors.

use super::BoundCheck;
use crate::digit_columns::DigitColumns;
use slipmode_plot::table::Table;

/// The table, by tolerance and observable.
#[must_use]
pub fn table(checks: &[BoundCheck]) -> Table {
    let note = "η from 1e-6 to 1e4, b/a from 0.4 to 3.4, K/K_c from 1e-3 to 10, from a fixed sequence. References: Radau IIA of order 13 in double-double at a local tolerance of 1e-18. Sampled, not proved.";
    let mut tolerances: Vec<f64> = checks.iter().map(|check| check.tolerance).collect();
    tolerances.sort_by(|a, b| b.total_cmp(a));
    tolerances.dedup();
    let runs = |tolerance| checks.iter().filter(move |check| check.tolerance == tolerance);
    let failed = |check: &&BoundCheck| check.periodic.is_none();
    let unreferenced = |check: &&BoundCheck| check.periodic.is_some() && check.peak_ratio.is_none();
    let above = |(tolerance, (_, ratio)): (f64, (_, Ratio)), limit: f64| {
        runs(tolerance).filter_map(ratio).filter(|ratio| *ratio > limit).count()
    };
    let rows = tolerances.into_iter().flat_map(|tolerance| OBSERVABLES.map(|of| (tolerance, of)));
    Table::of("error-bound", "True errors compared with estimated errors: random sliders, both laws", rows)
        .note(note)
        .digits("tolerance", "Tolerance", "", 2, |(tolerance, _)| tolerance)
        .text("observable", "Observable", |(_, (name, _))| name)
        .number("runs", "Runs", "", |(at, (_, ratio))| runs(at).filter_map(ratio).count())
        .number("failed", "Without a result", "", |(at, _)| runs(at).filter(failed).count())
        .number("unreferenced", "Without a reference", "", |(at, _)| runs(at).filter(unreferenced).count())
        .number("above_stated", "True error above the estimated one", "", |row| above(row, 1.0))
        .number("above_tenth", "Above a tenth of it", "", |row| above(row, 0.1))
        .number("above_hundredth", "Above a hundredth of it", "", |row| above(row, 0.01))
        .digits("worst_ratio", "Largest true / estimated error", "", 2, |(at, (_, ratio))| {
            runs(at).filter_map(ratio).reduce(f64::max)
        })
        .table()
}

/// Ratio of true to estimated error of one observable.
type Ratio = fn(&BoundCheck) -> Option<f64>;

/// The observables with the ratio of each.
const OBSERVABLES: [(&str, Ratio); 2] =
    [("peak velocity", |check| check.peak_ratio), ("period", |check| check.period_ratio)];
