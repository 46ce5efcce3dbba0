//! Figures of sweeps that ran elsewhere: what both laws do on a fine grid, and the asymptotes' worst errors in many points.

use crate::experiments::map::figures::heat_map;
use crate::experiments::shared::Grid;
use crate::experiments::swept::Swept;
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use crate::sweep::{SummarySection, SweepWork};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;
use slipmode_core::stability::SlipMode;
use slipmode_core::stability::deviation::{CornerErrors, corner_errors};

pub(crate) const FIGURES: &[Drawer] = &[
    ("swept-laws", |outcome, words| laws_map(outcome.potentially_unstable()?, simulated(outcome)?, words)),
    ("swept-errors", |outcome, words| worst_errors(&worst_by_effect_ratio(measured(outcome)?)?, words)),
];

/// Every sweep.
pub(crate) fn all(outcome: &Outcome) -> impl Iterator<Item = &Swept> {
    outcome.scenes.iter().filter_map(|scene| scene.swept.as_ref()).flatten()
}

/// The first sweep of simulations.
pub(crate) fn simulated(outcome: &Outcome) -> Option<&Swept> {
    all(outcome).find(|swept| matches!(swept.section.work, SweepWork::Simulate { .. }))
}

/// The first sweep of the asymptotes' errors.
pub(crate) fn measured(outcome: &Outcome) -> Option<&Swept> {
    all(outcome).find(|swept| swept.section.work == SweepWork::AsymptoteError)
}

/// The place of a key among the cells of a row's key: bins come first, in the order of the scene.
pub(crate) fn bin_place(kept: &SummarySection, column: &str) -> Option<usize> {
    kept.bins.iter().position(|bins| bins.column == column)
}

/// The place of a column of words.
pub(crate) fn word_place(kept: &SummarySection, column: &str) -> Option<usize> {
    kept.by.iter().position(|name| name == column).map(|place| kept.bins.len() + place)
}

/// The place of a statistic, by the name of its column, among the values of a row.
pub(crate) fn value_place(kept: &SummarySection, name: &str) -> Option<usize> {
    let names = kept.numbers.iter().flat_map(|numbers| {
        numbers.statistics.iter().map(|statistic| format!("{}_{}", numbers.column, statistic.as_str()))
    });
    names.into_iter().position(|found| found == name)
}

fn laws_map(scene: &SceneOutcome, swept: &Swept, words: &Words) -> Option<String> {
    let kept = swept.kept()?;
    let places = [bin_place(kept, "loading_velocity_m_per_s")?, bin_place(kept, "normal_stress_pa")?];
    let edges = places.map(|place| kept.bins[place].edges.coordinates());
    let [columns, rows] = [edges[0].len() - 1, edges[1].len() - 1];
    let centres = |edges: &Vec<f64>| edges.windows(2).map(|ends| (ends[0] * ends[1]).sqrt()).collect();
    let grid = Grid {
        loading_velocity_m_per_s: centres(&edges[0]),
        normal_stress_pa: centres(&edges[1]),
        values: law_means(swept, kept, places, columns, rows)?,
    };
    let excess = |_, [slip, aging]: &[f64; 2]| {
        // Equal peaks are a limit cycle too: coloured like every excess below the scale.
        if *slip > 0.0 { (aging / slip - 1.0).max(f64::MIN_POSITIVE) } else { 0.0 }
    };
    let mut map = heat_map(scene, words, &grid, excess)?;
    let highest = map.values.iter().copied().fold(0.0, f64::max);
    map.colours.max = libm::exp10((libm::log10(highest) * 2.0).ceil().max(-3.0) / 2.0);
    highest.is_normal().then(|| map.svg())
}

/// The mean peak velocity of limit cycles of either law, cell by cell, σ by σ; 0 where there are none.
fn law_means(
    swept: &Swept,
    kept: &SummarySection,
    [x, y]: [usize; 2],
    columns: usize,
    rows: usize,
) -> Option<Vec<[f64; 2]>> {
    let (law, mode) = (word_place(kept, "law")?, word_place(kept, "slip_mode")?);
    let sum = value_place(kept, "peak_velocity_m_per_s_sum")?;
    let cycles = [SlipMode::StickSlip, SlipMode::HarmonicVibration].map(SlipMode::as_str);
    let mut totals = vec![[(0.0, 0u64); 2]; columns * rows];
    for row in swept.summary.sorted() {
        let key: Vec<&str> = row.key().collect();
        let bin = |place: usize| key.get(place)?.parse::<usize>().ok()?.checked_sub(1);
        let (Some(column), Some(line)) = (bin(x), bin(y)) else { continue };
        let of_law = usize::from(key.get(law) == Some(&EvolutionLaw::Aging.as_str()));
        let is_cycle = key.get(mode).is_some_and(|mode| cycles.contains(mode));
        if let (true, Some(cell)) = (is_cycle && column < columns, totals.get_mut(line * columns + column)) {
            cell[of_law].0 += row.values.get(sum).copied().flatten().unwrap_or(0.0);
            cell[of_law].1 += row.rows;
        }
    }
    let mean = |(sum, count): (f64, u64)| if count > 0 { sum / count as f64 } else { 0.0 };
    Some(totals.into_iter().map(|cell| cell.map(mean)).collect())
}

/// The worst distances, log10, of a bin of β: of the upper and of the lower arc.
#[derive(Debug, Clone)]
pub(crate) struct WorstOfBin {
    /// The bin's ends.
    pub effect_ratio: [f64; 2],
    /// The largest in the sweep.
    pub sampled: [f64; 2],
    /// What is derived at either end; none on the upper arc for a = b.
    pub derived: [[Option<f64>; 2]; 2],
}

/// The worst errors of a sweep by bins of β, next to the derived ones.
pub(crate) fn worst_by_effect_ratio(swept: &Swept) -> Option<Vec<WorstOfBin>> {
    let kept = swept.kept()?;
    let beta = bin_place(kept, "evolution_effect")?;
    let asymptote = word_place(kept, "asymptote")?;
    let extremes =
        ["least", "greatest"].map(|end| value_place(kept, &format!("asymptote_relative_error_{end}")));
    let edges = kept.bins[beta].edges.coordinates();
    let derived: Vec<[Option<f64>; 2]> = edges.iter().map(|edge| derived_worst(*edge)).collect();
    let mut worst: Vec<WorstOfBin> = (0..edges.len() - 1)
        .map(|bin| WorstOfBin {
            effect_ratio: [edges[bin], edges[bin + 1]],
            sampled: [0.0; 2],
            derived: [derived[bin], derived[bin + 1]],
        })
        .collect();
    for row in swept.summary.sorted() {
        let key: Vec<&str> = row.key().collect();
        let bin = key.get(beta).and_then(|bin| bin.parse::<usize>().ok()?.checked_sub(1));
        let arc = match key.get(asymptote).copied() {
            Some("eq15" | "eq18") => 0,
            Some("eq16" | "eq20") => 1,
            _ => continue,
        };
        let Some(bin) = bin.and_then(|bin| worst.get_mut(bin)) else { continue };
        for place in extremes {
            let error = row.values.get(place?).copied().flatten().unwrap_or(0.0);
            bin.sampled[arc] = bin.sampled[arc].max((libm::log1p(error) / core::f64::consts::LN_10).abs());
        }
    }
    Some(worst)
}

/// Digits of what is derived: more than the table shows.
const DIGITS: u32 = 12;

fn derived_worst(effect_ratio: f64) -> [Option<f64>; 2] {
    let CornerErrors { upper_worst_log10, lower_worst_log10, .. } =
        corner_errors(&Rational::from_f64(effect_ratio).unwrap_or_default(), DIGITS);
    [upper_worst_log10.map(|worst| worst.to_f64()), Some(lower_worst_log10.to_f64())]
}

/// Points of a derived line in a bin.
const DERIVED_A_BIN: i32 = 6;

fn worst_errors(worst: &[WorstOfBin], words: &Words) -> Option<String> {
    let ratios = worst.iter().flat_map(|bin| within(bin.effect_ratio));
    let derived: Vec<(f64, [Option<f64>; 2])> = ratios.map(|beta| (beta, derived_worst(beta))).collect();
    let line = |arc: usize| {
        derived.iter().map(|(beta, worst)| (*beta, worst[arc].unwrap_or(f64::NAN))).collect::<Vec<_>>()
    };
    let stairs = |arc: usize| {
        worst.iter().flat_map(|bin| bin.effect_ratio.map(|end| (end, bin.sampled[arc]))).collect()
    };
    words.line_chart([line(0), stairs(0), line(1), stairs(1)])
}

/// Places from one end of a bin to the other, evenly in the logarithm.
fn within([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..=DERIVED_A_BIN).map(move |step| {
        let share = f64::from(step) / f64::from(DERIVED_A_BIN);
        // The ends themselves, so that neighbouring bins meet.
        if step == DERIVED_A_BIN { to } else { from * libm::pow(to / from, share) }
    })
}
