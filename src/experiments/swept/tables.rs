//! Tables of sweeps that ran elsewhere: what they took and would take, and what was found.

use std::collections::BTreeMap;

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::swept::Swept;
use crate::experiments::swept::figures::{
    all, bin_place, measured, simulated, value_place, word_place, worst_by_effect_ratio,
};
use crate::experiments::unless_empty;
use crate::sweep::SummarySection;
use slipmode_core::number::Rational;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "sweeps", needs: &[Need::Swept], make: sweeps },
    TableMaker { id: "swept-modes", needs: &[Need::Swept], make: modes },
    TableMaker { id: "swept-errors", needs: &[Need::Swept], make: errors },
    TableMaker { id: "swept-worst", needs: &[Need::Swept], make: worst },
];

/// Digits of what was measured with a clock.
const CLOCK_DIGITS: usize = 3;
/// Digits of shares and errors.
const DIGITS: usize = 4;

fn sweeps(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("sweep", "Sweep"),
        Column::text("title", "Item"),
        Column::number("rows", "Rows", ""),
        Column::number("core_seconds", "CPU time", "s"),
        Column::number("rows_per_core_second", "Rows per second and core", "1/s"),
        Column::number("core_hours_for_1e7", "Predicted for 1e7 rows", "core-hours"),
        Column::number("core_hours_for_1e9", "Predicted for 1e9 rows", "core-hours"),
        Column::number("peak_memory_mib", "Peak memory", "MiB"),
        Column::text("machine", "Machine"),
        Column::text("version", "Program"),
        Column::text("scene_sha256", "Scene, SHA-256"),
        Column::text("command", "Command"),
    ];
    let mut table = Table::new("sweeps", "Sweeps that were run separately, and their cost", columns)
        .with_note("Wall-clock time on the named machine; predictions are proportional to the number of rows. The scenes and the merged summaries are inputs of this report. Reading them checks that every row is counted once.");
    for swept in all(context.outcome) {
        let entry = &swept.entry;
        let per_row = entry.core_seconds.clone() / Rational::from(swept.rows);
        let hours = |rows: u64| {
            rational_to_decimal(&(per_row.clone() * Rational::from(rows) / 3600u32), CLOCK_DIGITS)
        };
        table.push(vec![
            Cell::text(&entry.name),
            Cell::text(&swept.title),
            count(swept.rows),
            Cell::number(rational_to_decimal(&entry.core_seconds, CLOCK_DIGITS)),
            Cell::number(rational_to_decimal(&per_row.clone().recip(), CLOCK_DIGITS)),
            Cell::number(hours(10_000_000)),
            Cell::number(hours(1_000_000_000)),
            Cell::number(rational_to_decimal(&entry.peak_memory_mib, CLOCK_DIGITS)),
            Cell::text(&entry.machine),
            Cell::text(&entry.version),
            Cell::text(&entry.scene_sha256),
            Cell::text(format!("slipmode sweep {}.toml --out blocks; slipmode merge blocks", entry.name)),
        ]);
    }
    unless_empty(table)
}

fn modes(context: &Context) -> Option<Table> {
    let swept = simulated(context.outcome)?;
    let kept = swept.kept()?;
    let (law, mode) = (word_place(kept, "law")?, word_place(kept, "slip_mode")?);
    let mut counts: BTreeMap<(String, String), u64> = BTreeMap::new();
    let mut of_law: BTreeMap<String, u64> = BTreeMap::new();
    for row in swept.summary.sorted() {
        let key: Vec<&str> = row.key().collect();
        let word = |place: usize| key.get(place).copied().unwrap_or_default().to_string();
        *counts.entry((word(law), word(mode))).or_default() += row.rows;
        *of_law.entry(word(law)).or_default() += row.rows;
    }
    let columns = vec![
        Column::text("law", "Law"),
        Column::text("slip_mode", "Slip mode, simulation"),
        Column::number("runs", "Runs", ""),
        Column::number("share", "Share of the law's runs", ""),
    ];
    let mut table = Table::new("swept-modes", "Slip modes on the refined grid", columns)
        .with_note("Determined from each trajectory alone. The counts are exact; the grid is a sample. A run without a mode has failed.");
    for ((law, mode), runs) in counts {
        let share = runs as f64 / of_law.get(&law).copied().unwrap_or(1) as f64;
        table.push(vec![
            Cell::text(&law),
            if mode.is_empty() { Cell::empty() } else { Cell::text(&mode) },
            count(runs),
            rounded(share, DIGITS),
        ]);
    }
    unless_empty(table)
}

/// What a sweep says of one asymptote.
#[derive(Default)]
struct OfAsymptote {
    points: u64,
    near: u64,
    /// Points near the boundary where the error is 1 % or more, and 10 % or more.
    off: [u64; 2],
    least: Option<f64>,
    greatest: Option<f64>,
}

fn errors(context: &Context) -> Option<Table> {
    let swept = measured(context.outcome)?;
    let columns = vec![
        Column::text("asymptote", "Nearer asymptote"),
        Column::number("points", "Points", ""),
        Column::number("near_points", "Points within a factor of 1.26 of the boundary", ""),
        Column::number("share_off_1_percent", "Of these, error of 1 % or more", ""),
        Column::number("share_off_10_percent", "Of these, error of 10 % or more", ""),
        Column::number("least_error", "Smallest exact/asymptote − 1", ""),
        Column::number("greatest_error", "Largest exact/asymptote − 1", ""),
    ];
    let mut table = Table::new("swept-errors", "Errors of the asymptotes over (β, κ, η)", columns)
        .with_note("For each point, the nearest boundary point in ln σ at the same V0 is compared with its nearer asymptote. Counts are exact; extremes are those of a low-discrepancy sample. Distances are in σ: a factor of 1.26 is 0.1 in log10.");
    for (asymptote, found) in by_asymptote(swept, swept.kept()?)? {
        let share = |count: u64| rounded(count as f64 / found.near.max(1) as f64, DIGITS);
        let extreme = |value: Option<f64>| value.map_or_else(Cell::empty, |value| rounded(value, DIGITS));
        table.push(vec![
            if asymptote.is_empty() { Cell::empty() } else { Cell::text(&asymptote) },
            count(found.points),
            count(found.near),
            share(found.off[0]),
            share(found.off[1]),
            extreme(found.least),
            extreme(found.greatest),
        ]);
    }
    unless_empty(table)
}

fn by_asymptote(swept: &Swept, kept: &SummarySection) -> Option<BTreeMap<String, OfAsymptote>> {
    let asymptote = word_place(kept, "asymptote")?;
    let distance = bin_place(kept, "log10_normal_stress_distance")?;
    let error = bin_place(kept, "asymptote_relative_error")?;
    let least = value_place(kept, "asymptote_relative_error_least")?;
    let greatest = value_place(kept, "asymptote_relative_error_greatest")?;
    let edges = kept.bins[error].edges.coordinates();
    let mut found: BTreeMap<String, OfAsymptote> = BTreeMap::new();
    for row in swept.summary.sorted() {
        let key: Vec<&str> = row.key().collect();
        let of = found.entry(key.get(asymptote).copied().unwrap_or_default().to_string()).or_default();
        of.points += row.rows;
        if key.get(distance) == Some(&"0") {
            of.near += row.rows;
            // The lower edge of bin k is edge k − 1.
            let bin: usize = key.get(error).and_then(|bin| bin.parse().ok()).unwrap_or_default();
            let from = bin.checked_sub(1).and_then(|edge| edges.get(edge).copied()).unwrap_or(0.0);
            for (count, limit) in of.off.iter_mut().zip([0.01, 0.1]) {
                // Edges are powers of ten to some units in the last place.
                *count += if from > limit * 0.999 { row.rows } else { 0 };
            }
        }
        let value = |place: usize| row.values.get(place).copied().flatten();
        of.least = [of.least, value(least)].into_iter().flatten().reduce(f64::min);
        of.greatest = [of.greatest, value(greatest)].into_iter().flatten().reduce(f64::max);
    }
    Some(found)
}

fn worst(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("effect_ratio_from", "β from", ""),
        Column::number("effect_ratio_to", "β to", ""),
        Column::number("upper_sampled_log10", "Upper arc, largest in the sweep", "dex"),
        Column::number("upper_derived_from_log10", "Upper arc, derived at the first β", "dex"),
        Column::number("upper_derived_to_log10", "Upper arc, derived at the last β", "dex"),
        Column::number("lower_sampled_log10", "Lower arc, largest in the sweep", "dex"),
        Column::number("lower_derived_from_log10", "Lower arc, derived at the first β", "dex"),
        Column::number("lower_derived_to_log10", "Lower arc, derived at the last β", "dex"),
    ];
    let mut table = Table::new("swept-worst", "Largest errors by quarter decades of β", columns)
        .with_note("The largest log10 distance from the nearer asymptote: in the sweep (sampled) and at the corners for the two ends of the quarter decade (enclosed).");
    for bin in worst_by_effect_ratio(measured(context.outcome)?)? {
        let number = |value: f64| rounded(value, DIGITS);
        let derived = |end: usize, arc: usize| bin.derived[end][arc].map_or_else(Cell::empty, number);
        table.push(vec![
            number(bin.effect_ratio[0]),
            number(bin.effect_ratio[1]),
            number(bin.sampled[0]),
            derived(0, 0),
            derived(1, 0),
            number(bin.sampled[1]),
            derived(0, 1),
            derived(1, 1),
        ]);
    }
    unless_empty(table)
}
