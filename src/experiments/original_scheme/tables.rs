//! Tables of what the numerical method does to the answer.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::error_bound::BoundCheck;
use crate::experiments::original_scheme::{OriginalSchemeOutcome, SchemeSeries, SchemeStep};
use crate::experiments::unless_empty;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "scheme-bias", needs: &[Need::OriginalScheme], make: bias },
    TableMaker { id: "scheme-order", needs: &[Need::OriginalScheme], make: order },
    TableMaker { id: "scheme-transition", needs: &[Need::OriginalScheme], make: transition },
    TableMaker { id: "scheme-map", needs: &[Need::OriginalScheme], make: map },
    TableMaker { id: "scheme-least-peaks", needs: &[Need::OriginalScheme], make: least_peaks },
    TableMaker { id: "work-precision", needs: &[Need::WorkPrecision], make: work },
    TableMaker { id: "error-bound", needs: &[Need::ErrorBound], make: bound },
    TableMaker { id: "error-bound-runs", needs: &[Need::ErrorBound], make: bound_runs },
];

fn number(value: f64, digits: usize) -> Cell {
    Cell::number(round_digits(value, digits))
}

fn optional(value: Option<f64>, digits: usize) -> Cell {
    value.map_or_else(Cell::empty, |value| number(value, digits))
}

fn scheme<'c>(context: &'c Context) -> Option<&'c OriginalSchemeOutcome> {
    context.outcome.scenes.iter().find_map(|scene| scene.original_scheme.as_ref())
}

fn place_cells(series: &SchemeSeries) -> [Cell; 3] {
    [
        Cell::text(series.law.as_str()),
        number(series.place.normal_stress_pa.to_f64(), 4),
        number(series.place.loading_velocity_m_per_s.to_f64(), 4),
    ]
}

fn place_columns() -> Vec<Column> {
    vec![
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
    ]
}

fn bias(context: &Context) -> Option<Table> {
    let mut columns = place_columns();
    columns.extend([
        Column::number("step_over_natural_time", "Step / √(M/K)", ""),
        Column::number("bias_percent", "Bias of the peak velocity", "%"),
        Column::number("spread_percent", "Spread", "%"),
        Column::number("steps", "Steps of the run", ""),
        Column::text("outcome", "Result"),
    ]);
    let mut table = Table::new("scheme-bias", "Bias of the long-term peak velocity under the original scheme", columns)
        .with_note("Each run starts on our limit cycle, adjusts over ten cycles, and is measured over eight. The spread is half the difference between the highest and the lowest of four windows. Runs of more than 1e6 steps are counted, not made.");
    for series in &scheme(context)?.series {
        for step in &series.steps {
            let mut row = place_cells(series).to_vec();
            row.extend(bias_cells(series, step));
            table.push(row);
        }
    }
    unless_empty(table)
}

fn bias_cells(series: &SchemeSeries, step: &SchemeStep) -> [Cell; 5] {
    let found = step.bias(series.log_peak);
    let outcome = match &step.peak {
        None => "too many steps".to_string(),
        Some(Err(failure)) => failure.to_string(),
        Some(Ok(_)) => "run".to_string(),
    };
    [
        number(step.fraction, 4),
        optional(found.map(|(bias, _)| 100.0 * libm::expm1(bias)), 3),
        optional(found.map(|(_, spread)| 100.0 * spread), 1),
        number(step.steps_needed, 3),
        Cell::text(&outcome),
    ]
}

fn order(context: &Context) -> Option<Table> {
    let mut columns = place_columns();
    columns.extend([
        Column::number("order", "Observed order", ""),
        Column::number("order_error", "Its error", ""),
    ]);
    let mut table = Table::new("scheme-order", "Observed order of the original scheme", columns)
        .with_note("Computed from the long-term peaks at three steps, each half of the previous one, without our converged value. The error adds the spreads of the peaks and the difference from the order of the next coarser three steps.");
    for series in &scheme(context)?.series {
        let Some((order, error)) = series.order else { continue };
        let mut row = place_cells(series).to_vec();
        row.extend([number(order, 3), number(error, 1)]);
        table.push(row);
    }
    unless_empty(table)
}

fn transition(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::number("step_over_natural_time", "Step / √(M/K)", ""),
        Column::number("shift_percent", "Relative deviation of the scheme's critical stiffness", "%"),
    ];
    let mut table =
        Table::new("scheme-transition", "Critical stiffness under the original scheme", columns).with_note(
            "From the scheme's own linearisation, which is the same for both laws, bisected to 1e-15 with 256 bits. η is that of K = K_c at this velocity.",
        );
    for row in &scheme(context)?.transition {
        table.push(vec![
            number(row.loading_velocity_m_per_s, 4),
            number(row.fraction, 4),
            number(100.0 * row.shift, 3),
        ]);
    }
    unless_empty(table)
}

fn map(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("step_over_natural_time", "Step / √(M/K)", ""),
        Column::number("points", "Points", ""),
        Column::number("flipped", "Stability changed", ""),
        Column::number("cycles", "Limit cycles run", ""),
        Column::number("left_out", "Left out", ""),
        Column::number("lost", "Lost", ""),
        Column::number("median_bias_percent", "Median size of the bias", "%"),
        Column::number("least_bias_percent", "Smallest bias", "%"),
        Column::number("greatest_bias_percent", "Largest bias", "%"),
    ];
    let mut table = Table::new("scheme-map", "Effect of the original scheme on points of fig 3a", columns)
        .with_note("Stability of the scheme's own linearisation, evaluated with 256 bits, is compared with the exact sign of K − K_c. Left out: limit cycles that would take more than 1e5 steps. Lost: limit cycles whose peak falls below 1/e under the scheme, or that the scheme cannot follow.");
    for row in &scheme(context)?.map {
        let percent = |value: f64| 100.0 * libm::expm1(value);
        table.push(vec![
            Cell::text(row.law.as_str()),
            number(row.fraction, 4),
            Cell::number(row.points.to_string()),
            Cell::number(row.flipped.to_string()),
            Cell::number(row.cycles.to_string()),
            Cell::number(row.left_out.to_string()),
            Cell::number(row.lost.to_string()),
            optional(row.median_bias.map(percent), 2),
            optional(row.bias_range.map(|[low, _]| percent(low)), 2),
            optional(row.bias_range.map(|[_, high]| percent(high)), 2),
        ]);
    }
    unless_empty(table)
}

fn least_peaks(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("step_over_natural_time", "Step / √(M/K)", ""),
        Column::number("offset_dex", "Offset of our minimum from eq 18", "dex"),
        Column::number("shift_dex", "Offset of the scheme's minimum from ours", "dex"),
        Column::number("shift_error_dex", "Error of the shift", "dex"),
    ];
    let mut table = Table::new("scheme-least-peaks", "Velocity of the lowest peak under the original scheme (fig 5)", columns)
        .with_note("Both minima are those of quartics through the same 17 velocities. The error of the shift is its change when every second velocity is left out. A step is missing if a run fails or the minimum leaves the sampled range.");
    for least in &scheme(context)?.least_peaks {
        table.push(vec![
            Cell::text(least.law.as_str()),
            number(least.normal_stress_pa, 4),
            number(least.fraction, 4),
            number(least.offset_dex, 3),
            number(least.shift_dex, 2),
            number(least.shift_error_dex, 1),
        ]);
    }
    unless_empty(table)
}

fn work(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("normal_stress_pa", "Normal stress σ", "Pa"),
        Column::number("loading_velocity_m_per_s", "Loading velocity V0", "m/s"),
        Column::text("method", "Method"),
        Column::number("setting", "Local tolerance, or step / √(M/K)", ""),
        Column::number("steps", "Steps", ""),
        Column::number("evaluations", "Evaluations", ""),
        Column::number("peak_error", "Error of ln(V_peak/V0)", ""),
    ];
    let mut table = Table::new(
        "work-precision",
        "Work against error on one period of the limit cycle, slip law",
        columns,
    );
    for case in context.outcome.scenes.iter().filter_map(|scene| scene.work_precision.as_ref()).flatten() {
        for point in &case.points {
            table.push(vec![
                number(case.place.normal_stress_pa.to_f64(), 4),
                number(case.place.loading_velocity_m_per_s.to_f64(), 4),
                Cell::text(point.method),
                number(point.setting, 4),
                Cell::number(point.steps.to_string()),
                Cell::number(point.evaluations.to_string()),
                number(point.peak_error, 2),
            ]);
        }
    }
    unless_empty(table)
}

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
                number(tolerance, 2),
                Cell::text(observable),
                Cell::number(ratios.len().to_string()),
                Cell::number(failed.to_string()),
                Cell::number(unreferenced.to_string()),
            ];
            row.extend(RATIOS.map(|limit| {
                Cell::number(ratios.iter().filter(|&&ratio| ratio > limit).count().to_string())
            }));
            row.push(optional(ratios.iter().copied().reduce(f64::max), 2));
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
            number(check.groups.inertial_parameter, 5),
            number(check.groups.stiffness_group, 5),
            number(check.groups.effect_ratio, 5),
            Cell::text(check.law.as_str()),
            number(check.tolerance, 2),
            Cell::text(behaviour),
            optional(check.peak_ratio, 2),
            optional(check.period_ratio, 2),
            Cell::text(&check.failure),
        ]);
    }
    unless_empty(table)
}
