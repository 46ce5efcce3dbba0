//! Tables of the original scheme: bias, order, transition, and figs 3a and 5 under it.

use super::{SchemeOutcome, SchemeSeries, SchemeStep};
use crate::digit_columns::DigitColumns;
use crate::paper::{place_cells, place_columns};
use slipmode_plot::table::{Table, TableRows};

/// The five tables.
#[must_use]
pub fn tables(found: &SchemeOutcome) -> Vec<Table> {
    vec![bias(found), order(found), transition(found), map(found), least_peaks(found)]
}

/// Columns of law and place, which stand first.
fn at_places<'s, R: Copy>(rows: TableRows<R>, of: impl Fn(R) -> &'s SchemeSeries) -> TableRows<R> {
    rows.text("law", "Law", |row| of(row).law.as_str())
        .columns(place_columns(), |row| place_cells(&of(row).place))
}

fn bias(found: &SchemeOutcome) -> Table {
    let note = "Each run starts on our limit cycle, adjusts over ten cycles, and is measured over eight. The spread is half the difference between the highest and the lowest of four windows. Runs of more than 1e6 steps are counted, not made.";
    let series = found.series.iter();
    let rows = series.flat_map(|series| series.steps.iter().map(move |step| (series, step)));
    let percent = |(series, step): (&SchemeSeries, &SchemeStep), of: fn((f64, f64)) -> f64| {
        step.bias(series.log_peak).map(|found| 100.0 * of(found))
    };
    let title = "Bias of the long-term peak velocity under the original scheme";
    at_places(Table::of("scheme-bias", title, rows), |(series, _)| series)
        .note(note)
        .digits("step_over_natural_time", "Step / √(M/K)", "", 4, |(_, step)| step.fraction)
        .digits("bias_percent", "Bias of the peak velocity", "%", 3, |row| {
            percent(row, |(bias, _)| libm::expm1(bias))
        })
        .digits("spread_percent", "Spread", "%", 1, |row| percent(row, |(_, spread)| spread))
        .digits("steps", "Steps of the run", "", 3, |(_, step)| step.steps_needed)
        .text("outcome", "Result", |(_, step)| match &step.peak {
            None => "too many steps".to_string(),
            Some(Err(failure)) => failure.to_string(),
            Some(Ok(_)) => "run".to_string(),
        })
        .table()
}

fn order(found: &SchemeOutcome) -> Table {
    let note = "Computed from the long-term peaks at three steps, each half of the previous one, without our converged value. The error adds the spreads of the peaks and the difference from the order of the next coarser three steps.";
    let series = &found.series;
    let rows = series.iter().filter_map(|series| Some((series, series.order?)));
    at_places(Table::of("scheme-order", "Observed order of the original scheme", rows), |(series, _)| series)
        .note(note)
        .digits("order", "Observed order", "", 3, |(_, (order, _))| order)
        .digits("order_error", "Its error", "", 1, |(_, (_, error))| error)
        .table()
}

fn transition(found: &SchemeOutcome) -> Table {
    let note = "From the scheme's own linearisation, which is the same for both laws, bisected to 1e-15 with 256 bits. η is that of K = K_c at this velocity.";
    Table::of("scheme-transition", "Critical stiffness under the original scheme", &found.transition)
        .note(note)
        .digits("loading_velocity_m_per_s", "Loading velocity V0", "m/s", 4, |row| {
            row.loading_velocity_m_per_s
        })
        .digits("step_over_natural_time", "Step / √(M/K)", "", 4, |row| row.fraction)
        .digits("shift_percent", "Relative deviation of the scheme's critical stiffness", "%", 3, |row| {
            100.0 * row.shift
        })
        .table()
}

fn map(found: &SchemeOutcome) -> Table {
    let note = "Stability of the scheme's own linearisation, evaluated with 256 bits, is compared with the exact sign of K − K_c. Left out: limit cycles that would take more than 1e5 steps. Lost: limit cycles whose peak falls below 1/e under the scheme, or that the scheme cannot follow.";
    let percent = |value: f64| 100.0 * libm::expm1(value);
    Table::of("scheme-map", "Effect of the original scheme on points of fig 3a", &found.map)
        .note(note)
        .text("law", "Law", |row| row.law.as_str())
        .digits("step_over_natural_time", "Step / √(M/K)", "", 4, |row| row.fraction)
        .number("points", "Points", "", |row| row.points)
        .number("flipped", "Stability changed", "", |row| row.flipped)
        .number("cycles", "Limit cycles run", "", |row| row.cycles)
        .number("left_out", "Left out", "", |row| row.left_out)
        .number("lost", "Lost", "", |row| row.lost)
        .digits("median_bias_percent", "Median size of the bias", "%", 2, |row| row.median_bias.map(percent))
        .digits("least_bias_percent", "Smallest bias", "%", 2, |row| {
            row.bias_range.map(|[low, _]| percent(low))
        })
        .digits("greatest_bias_percent", "Largest bias", "%", 2, |row| {
            row.bias_range.map(|[_, high]| percent(high))
        })
        .table()
}

fn least_peaks(found: &SchemeOutcome) -> Table {
    let note = "Both minima are those of quartics through the same 17 velocities. The error of the shift is its change when every second velocity is left out. A step is missing if a run fails or the minimum leaves the sampled range.";
    Table::of(
        "scheme-least-peaks",
        "Velocity of the lowest peak under the original scheme (fig 5)",
        &found.least_peaks,
    )
    .note(note)
    .text("law", "Law", |least| least.law.as_str())
    .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |least| least.normal_stress_pa)
    .digits("step_over_natural_time", "Step / √(M/K)", "", 4, |least| least.fraction)
    .digits("offset_dex", "Offset of our minimum from eq 18", "dex", 3, |least| least.offset_dex)
    .digits("shift_dex", "Offset of the scheme's minimum from ours", "dex", 2, |least| least.shift_dex)
    .digits("shift_error_dex", "Error of the shift", "dex", 1, |least| least.shift_error_dex)
    .table()
}
