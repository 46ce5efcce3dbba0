//! Tables of sweeps that ran elsewhere: what they took and would take, and what was found.

use std::collections::BTreeMap;

use crate::experiments::shared::cells::{DigitColumns, Digits};
use crate::experiments::swept::Swept;
use crate::experiments::swept::figures::{
    all, bin_place, measured, simulated, value_place, word_place, worst_by_effect_ratio,
};
use crate::experiments::{Context, Need, TableMaker};
use crate::sweep::SummarySection;
use slipmode_core::number::Rational;
use slipmode_plot::table::Table;

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
    let note = "Wall-clock time on the named machine; predictions are proportional to the number of rows. The scenes and the merged summaries are inputs of this report. Reading them checks that every row is counted once.";
    let per_row = |of: &Swept| of.entry.core_seconds.clone() / Rational::from(of.rows);
    let hours = |of: &Swept, rows: u64| {
        let hours = per_row(of) * Rational::from(rows) / 3600u32;
        hours.cell(CLOCK_DIGITS)
    };
    Table::of("sweeps", "Sweeps that were run separately, and their cost", all(context.outcome))
        .note(note)
        .text("sweep", "Sweep", |of| &of.entry.name)
        .text("title", "Item", |of| &of.title)
        .number("rows", "Rows", "", |of| of.rows)
        .digits("core_seconds", "CPU time", "s", CLOCK_DIGITS, |of| &of.entry.core_seconds)
        .number("rows_per_core_second", "Rows per second and core", "1/s", |of| {
            (&per_row(of).recip()).cell(CLOCK_DIGITS)
        })
        .number("core_hours_for_1e7", "Predicted for 1e7 rows", "core-hours", |of| hours(of, 10_000_000))
        .number("core_hours_for_1e9", "Predicted for 1e9 rows", "core-hours", |of| hours(of, 1_000_000_000))
        .digits("peak_memory_mib", "Peak memory", "MiB", CLOCK_DIGITS, |of| &of.entry.peak_memory_mib)
        .text("machine", "Machine", |of| &of.entry.machine)
        .text("version", "Program", |of| &of.entry.version)
        .text("scene_sha256", "Scene, SHA-256", |of| &of.entry.scene_sha256)
        .text("command", "Command", |of| {
            format!("slipmode sweep {}.toml --out blocks; slipmode merge blocks", of.entry.name)
        })
        .table()
        .into()
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
    let note = "Determined from each trajectory alone. The counts are exact; the grid is a sample. A run without a mode has failed.";
    let share = |law: &str, runs: u64| runs as f64 / of_law.get(law).copied().unwrap_or(1) as f64;
    Table::of("swept-modes", "Slip modes on the refined grid", &counts)
        .note(note)
        .text("law", "Law", |((law, _), _)| law)
        .text("slip_mode", "Slip mode, simulation", |((_, mode), _)| mode)
        .number("runs", "Runs", "", |(_, runs)| *runs)
        .digits("share", "Share of the law's runs", "", DIGITS, |((law, _), runs)| share(law, *runs))
        .table()
        .into()
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
    let note = "For each point, the nearest boundary point in ln σ at the same V0 is compared with its nearer asymptote. Counts are exact; extremes are those of a low-discrepancy sample. Distances are in σ: a factor of 1.26 is 0.1 in log10.";
    let share = |found: &OfAsymptote, at: usize| found.off[at] as f64 / found.near.max(1) as f64;
    Table::of("swept-errors", "Errors of the asymptotes over (β, κ, η)", &by_asymptote(swept, swept.kept()?)?)
        .note(note)
        .text("asymptote", "Nearer asymptote", |(asymptote, _)| asymptote)
        .number("points", "Points", "", |(_, found)| found.points)
        .number("near_points", "Points within a factor of 1.26 of the boundary", "", |(_, found)| found.near)
        .digits("share_off_1_percent", "Of these, error of 1 % or more", "", DIGITS, |(_, found)| {
            share(found, 0)
        })
        .digits("share_off_10_percent", "Of these, error of 10 % or more", "", DIGITS, |(_, found)| {
            share(found, 1)
        })
        .digits("least_error", "Smallest exact/asymptote − 1", "", DIGITS, |(_, found)| found.least)
        .digits("greatest_error", "Largest exact/asymptote − 1", "", DIGITS, |(_, found)| found.greatest)
        .table()
        .into()
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
    let note = "The largest log10 distance from the nearer asymptote: in the sweep (sampled) and at the corners for the two ends of the quarter decade (enclosed).";
    let bins = worst_by_effect_ratio(measured(context.outcome)?)?;
    Table::of("swept-worst", "Largest errors by quarter decades of β", &bins)
        .note(note)
        .digits("effect_ratio_from", "β from", "", DIGITS, |bin| bin.effect_ratio[0])
        .digits("effect_ratio_to", "β to", "", DIGITS, |bin| bin.effect_ratio[1])
        .digits("upper_sampled_log10", "Upper arc, largest in the sweep", "dex", DIGITS, |bin| bin.sampled[0])
        .digits("upper_derived_from_log10", "Upper arc, derived at the first β", "dex", DIGITS, |bin| {
            bin.derived[0][0]
        })
        .digits("upper_derived_to_log10", "Upper arc, derived at the last β", "dex", DIGITS, |bin| {
            bin.derived[1][0]
        })
        .digits("lower_sampled_log10", "Lower arc, largest in the sweep", "dex", DIGITS, |bin| bin.sampled[1])
        .digits("lower_derived_from_log10", "Lower arc, derived at the first β", "dex", DIGITS, |bin| {
            bin.derived[0][1]
        })
        .digits("lower_derived_to_log10", "Lower arc, derived at the last β", "dex", DIGITS, |bin| {
            bin.derived[1][1]
        })
        .table()
        .into()
}
