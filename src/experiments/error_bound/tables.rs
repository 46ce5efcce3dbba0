//! Tables of true and estimated errors.

use crate::experiments::error_bound::BoundCheck;
use crate::experiments::shared::cells::{count, rounded, rounded_or_empty};
use crate::experiments::{Context, Need, TableMaker, unless_empty};
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "error-bound", needs: &[Need::ErrorBound], make: bound },
    TableMaker { id: "error-bound-runs", needs: &[Need::ErrorBound], make: bound_runs },
];

fn checks<'c>(context: &'c Context) -> impl Iterator<Item = &'c BoundCheck> {
    context.outcome.scenes.iter().filter_map(|scene| scene.error_bound.as_ref()).flatten()
}

/// Ratios of true to estimated error above which runs are counted.
const RATIOS: [f64; 3] = [1.0, 0.1, 0.01];

fn bound(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("tolerance", "Tolerance", ""),
        Column::text("observable", "Observable"),
        Column::number("runs", "Runs", ""),
        Column::number("failed", "Without a result", ""),
        Column::number("unreferenced", "Without a reference", ""),
        Column::number("above_stated", "True error above the estimated one", ""),
        Column::number("above_tenth", "Above a tenth of it", ""),
        Column::number("above_hundredth", "Above a hundredth of it", ""),
        Column::number("worst_ratio", "Largest true / estimated error", ""),
    ];
    let mut table = Table::new("error-bound", "True errors compared with estimated errors: random sliders, both laws", columns)
        .with_note("η from 1e-6 to 1e4, b/a from 0.4 to 3.4, K/K_c from 1e-3 to 10, from a fixed sequence. References: Radau IIA of order 13 in double-double at a local tolerance of 1e-18. Sampled, not proved.");
    let mut tolerances: Vec<f64> = checks(context).map(|check| check.tolerance).collect();
    tolerances.sort_by(|a, b| b.total_cmp(a));
    tolerances.dedup();
    for tolerance in tolerances {
        let runs = || checks(context).filter(|check| check.tolerance == tolerance);
        let failed = runs().filter(|check| check.periodic.is_none()).count();
        let unreferenced =
            runs().filter(|check| check.periodic.is_some() && check.peak_ratio.is_none()).count();
        for (observable, ratio) in observables() {
            let ratios: Vec<f64> = runs().filter_map(ratio).collect();
            let mut row = vec![
                rounded(tolerance, 2),
                Cell::text(observable),
                count(ratios.len()),
                count(failed),
                count(unreferenced),
            ];
            row.extend(RATIOS.map(|limit| {
                Cell::number(ratios.iter().filter(|&&ratio| ratio > limit).count().to_string())
            }));
            row.push(rounded_or_empty(ratios.iter().copied().reduce(f64::max), 2));
            table.push(row);
        }
    }
    unless_empty(table)
}

/// Ratio of true to estimated error of one observable.
type Ratio = fn(&BoundCheck) -> Option<f64>;

/// The observables with the ratio of each.
fn observables() -> [(&'static str, Ratio); 2] {
    [("peak velocity", |check| check.peak_ratio), ("period", |check| check.period_ratio)]
}

fn bound_runs(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("inertial_parameter", "η", ""),
        Column::number("stiffness_group", "κ", ""),
        Column::number("effect_ratio", "b/a", ""),
        Column::text("law", "Law"),
        Column::number("tolerance", "Tolerance", ""),
        Column::text("behaviour", "Long-term behaviour"),
        Column::number("peak_ratio", "Peak: true / estimated error", ""),
        Column::number("period_ratio", "Period: true / estimated error", ""),
        Column::text("failure", "Failure"),
    ];
    let mut table = Table::new("error-bound-runs", "Estimated and true errors, run by run", columns);
    for check in checks(context) {
        let behaviour = check.periodic.map_or("", |periodic| if periodic { "periodic" } else { "decaying" });
        table.push(vec![
            rounded(check.groups.inertial_parameter, 5),
            rounded(check.groups.stiffness_group, 5),
            rounded(check.groups.effect_ratio, 5),
            Cell::text(check.law.as_str()),
            rounded(check.tolerance, 2),
            Cell::text(behaviour),
            rounded_or_empty(check.peak_ratio, 2),
            rounded_or_empty(check.period_ratio, 2),
            Cell::text(&check.failure),
        ]);
    }
    unless_empty(table)
}
