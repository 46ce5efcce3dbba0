//! Tables of sweeps that ran elsewhere: what they took and would take, and what was found.

use std::collections::BTreeMap;

use crate::experiments::shared::cells::Digits;
use crate::experiments::swept::Swept;
use crate::experiments::swept::figures::{
    all, bin_place, measured, simulated, value_place, word_place, worst_by_effect_ratio,
};
use crate::experiments::{Context, Need, TableMaker, table_of};
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
    let per_row = |of: &Swept| of.entry.core_seconds.clone() / Rational::from(of.rows);
    let hours = |of: &Swept, rows: u64| {
        let hours = per_row(of) * Rational::from(rows) / 3600u32;
        hours.cell(CLOCK_DIGITS)
    };
    table_of("sweeps", all(context.outcome))
        .text("sweep", |of| &of.entry.name)
        .text("title", |of| &of.title)
        .number("rows", |of| of.rows)
        .digits("core_seconds", CLOCK_DIGITS, |of| &of.entry.core_seconds)
        .number("rows_per_core_second", |of| (&per_row(of).recip()).cell(CLOCK_DIGITS))
        .number("core_hours_for_1e7", |of| hours(of, 10_000_000))
        .number("core_hours_for_1e9", |of| hours(of, 1_000_000_000))
        .digits("peak_memory_mib", CLOCK_DIGITS, |of| &of.entry.peak_memory_mib)
        .text("machine", |of| &of.entry.machine)
        .text("version", |of| &of.entry.version)
        .text("scene_sha256", |of| &of.entry.scene_sha256)
        .text("command", |of| {
            format!("slipmode sweep {}.toml --out blocks; slipmode merge blocks", of.entry.name)
        })
        .table()
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
    let share = |law: &str, runs: u64| runs as f64 / of_law.get(law).copied().unwrap_or(1) as f64;
    table_of("swept-modes", &counts)
        .text("law", |((law, _), _)| law)
        .text("slip_mode", |((_, mode), _)| mode)
        .number("runs", |(_, runs)| *runs)
        .digits("share", DIGITS, |((law, _), runs)| share(law, *runs))
        .table()
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
    let share = |found: &OfAsymptote, at: usize| found.off[at] as f64 / found.near.max(1) as f64;
    table_of("swept-errors", &by_asymptote(swept, swept.kept()?)?)
        .text("asymptote", |(asymptote, _)| asymptote)
        .number("points", |(_, found)| found.points)
        .number("near_points", |(_, found)| found.near)
        .digits("share_off_1_percent", DIGITS, |(_, found)| share(found, 0))
        .digits("share_off_10_percent", DIGITS, |(_, found)| share(found, 1))
        .digits("least_error", DIGITS, |(_, found)| found.least)
        .digits("greatest_error", DIGITS, |(_, found)| found.greatest)
        .table()
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
    let bins = worst_by_effect_ratio(measured(context.outcome)?)?;
    table_of("swept-worst", &bins)
        .digits("effect_ratio_from", DIGITS, |bin| bin.effect_ratio[0])
        .digits("effect_ratio_to", DIGITS, |bin| bin.effect_ratio[1])
        .digits("upper_sampled_log10", DIGITS, |bin| bin.sampled[0])
        .digits("upper_derived_from_log10", DIGITS, |bin| bin.derived[0][0])
        .digits("upper_derived_to_log10", DIGITS, |bin| bin.derived[1][0])
        .digits("lower_sampled_log10", DIGITS, |bin| bin.sampled[1])
        .digits("lower_derived_from_log10", DIGITS, |bin| bin.derived[0][1])
        .digits("lower_derived_to_log10", DIGITS, |bin| bin.derived[1][1])
        .table()
}
