//! Tables of the onset of oscillation: velocities of theory and simulations, and the runs of fig 4.

use crate::experiments::onset::{Located, Onset};
use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "onset", needs: &[Need::Onset], make: onset },
    TableMaker { id: "onset-runs", needs: &[Need::Onset], make: runs },
];

fn lines<'c>(context: &'c Context) -> impl Iterator<Item = (&'c str, &'c Onset)> {
    let found = context.outcome.each(|scene| &scene.onset);
    found.flat_map(|(name, found)| found.lines.iter().map(move |line| (name, line)))
}

/// log10 of a velocity over that of the asymptote.
fn dex(line: &Onset, velocity: f64) -> f64 {
    libm::log10(velocity / line.asymptote_velocity_m_per_s.to_f64())
}

fn onset(context: &Context) -> Option<Table> {
    let note = "Velocities in dex are log10 of the ratio to that of the asymptote (eq 20; eq 18 on the upper arc). The exact boundary is enclosed and the threshold is decided exactly. Simulated oscillation begins where the squared frequency of small deviations extrapolates to zero. Oscillation is visible if V, after its first peak above V_l in the run from V_l/10, rises again, or falls below V_l, by the scene's visible fraction of V_l.";
    let rows = lines(context).flat_map(|(name, line)| line.seen.iter().map(move |seen| (name, line, seen)));
    let located = |line, found: Option<&Located>| found.map(|found| dex(line, found.value));
    let error = |found: Option<&Located>| found.map(|found| found.error_dex);
    Table::of("onset", "Onset of oscillation at given normal stress", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .text("law", "Law", |(.., seen)| seen.law.as_str())
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(_, line, _)| &line.normal_stress_pa)
        .text("asymptote", "Asymptote", |(_, line, _)| line.asymptote.as_str())
        .digits("asymptote_velocity_m_per_s", "Velocity of the asymptote", "m/s", 6, |(_, line, _)| {
            &line.asymptote_velocity_m_per_s
        })
        .digits("boundary_velocity_m_per_s", "Velocity of the exact boundary", "m/s", 6, |(_, line, _)| {
            &line.boundary_velocity_m_per_s
        })
        .digits("boundary_dex", "Exact boundary", "dex", 4, |(_, line, _)| {
            dex(line, line.boundary_velocity_m_per_s.to_f64())
        })
        .digits("simulated_dex", "Oscillation in simulations", "dex", 4, |(_, line, seen)| {
            located(line, seen.exists.as_ref())
        })
        .digits("simulated_error_dex", "Its error", "dex", 1, |(.., seen)| error(seen.exists.as_ref()))
        .digits("inertial_dex", "Inertial by the threshold", "dex", 4, |(_, line, _)| {
            located(line, line.inertial.as_ref())
        })
        .digits("second_rise_dex", "Second rise visible", "dex", 4, |(_, line, seen)| {
            located(line, seen.second_rise.as_ref())
        })
        .digits("undershoot_dex", "Undershoot visible", "dex", 4, |(_, line, seen)| {
            located(line, seen.undershoot.as_ref())
        })
        .digits("seen_error_dex", "Error of the visible onset", "dex", 1, |(.., seen)| {
            error(seen.undershoot.as_ref())
        })
        .digits("peak_excess_at_boundary", "V_peak/V_l − 1 at the boundary", "", 3, |(.., seen)| {
            seen.peak_excess_at_boundary
        })
        .table()
        .into()
}

fn runs(context: &Context) -> Option<Table> {
    let note = "Samples of the runs of fig 4, equally spaced in time.";
    let runs = lines(context).flat_map(|(name, line)| line.shown.iter().map(move |run| (name, line, run)));
    let rows = runs.flat_map(|(name, line, run)| run.history.iter().map(move |at| (name, line, run, at)));
    Table::of("onset-runs", "Runs on either side of the onset", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .digits("normal_stress_pa", "Normal stress σ", "Pa", 4, |(_, line, ..)| &line.normal_stress_pa)
        .digits("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", 4, |(_, _, run, _)| {
            run.loading_velocity_m_per_s
        })
        .digits("loaded_distance_over_slip_distance", "V_l t/D_c", "", 4, |(.., at)| at.0)
        .digits("velocity_over_loading_velocity", "V/V_l", "", 5, |(.., at)| at.1)
        .table()
        .into()
}
