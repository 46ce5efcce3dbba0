//! Tables of the original scheme: bias, order, transition, and figs 3a and 5 under it.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::original_scheme::{OriginalSchemeOutcome, SchemeSeries, SchemeStep};
use crate::experiments::shared::cells::{count, rounded, rounded_or_empty};
use crate::experiments::unless_empty;
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "scheme-bias", needs: &[Need::OriginalScheme], make: bias },
    TableMaker { id: "scheme-order", needs: &[Need::OriginalScheme], make: order },
    TableMaker { id: "scheme-transition", needs: &[Need::OriginalScheme], make: transition },
    TableMaker { id: "scheme-map", needs: &[Need::OriginalScheme], make: map },
    TableMaker { id: "scheme-least-peaks", needs: &[Need::OriginalScheme], make: least_peaks },
];

fn scheme<'c>(context: &'c Context) -> Option<&'c OriginalSchemeOutcome> {
    context.outcome.scenes.iter().find_map(|scene| scene.original_scheme.as_ref())
}

fn place_cells(series: &SchemeSeries) -> [Cell; 3] {
    [
        Cell::text(series.law.as_str()),
        rounded(nearest_f64(&series.place.normal_stress_pa), 4),
        rounded(nearest_f64(&series.place.loading_velocity_m_per_s), 4),
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
        rounded(step.fraction, 4),
        rounded_or_empty(found.map(|(bias, _)| 100.0 * libm::expm1(bias)), 3),
        rounded_or_empty(found.map(|(_, spread)| 100.0 * spread), 1),
        rounded(step.steps_needed, 3),
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
        row.extend([rounded(order, 3), rounded(error, 1)]);
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
            rounded(row.loading_velocity_m_per_s, 4),
            rounded(row.fraction, 4),
            rounded(100.0 * row.shift, 3),
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
            rounded(row.fraction, 4),
            count(row.points),
            count(row.flipped),
            count(row.cycles),
            count(row.left_out),
            count(row.lost),
            rounded_or_empty(row.median_bias.map(percent), 2),
            rounded_or_empty(row.bias_range.map(|[low, _]| percent(low)), 2),
            rounded_or_empty(row.bias_range.map(|[_, high]| percent(high)), 2),
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
            rounded(least.normal_stress_pa, 4),
            rounded(least.fraction, 4),
            rounded(least.offset_dex, 3),
            rounded(least.shift_dex, 2),
            rounded(least.shift_error_dex, 1),
        ]);
    }
    unless_empty(table)
}
