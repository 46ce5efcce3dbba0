//! Tables of the onset of oscillation: velocities of theory and simulations, and the runs of fig 4.

use crate::experiments::onset::{Located, Onset};
use crate::experiments::shared::cells::{RoundedColumns, decimal, rounded};
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::number::format::certain_digits;
use slipmode_plot::table::{Cell, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "onset", needs: &[Need::Onset], make: onset },
    TableMaker { id: "onset-runs", needs: &[Need::Onset], make: runs },
];

fn lines<'c>(context: &'c Context) -> impl Iterator<Item = (&'c str, &'c Onset)> {
    let found = context.outcome.each(|scene| &scene.onset);
    found.flat_map(|(name, found)| found.lines.iter().map(move |line| (name, line)))
}

/// log10 of a velocity over that of the asymptote.
fn dex(line: &Onset, velocity: f64, digits: usize) -> Cell {
    rounded(libm::log10(velocity / line.asymptote_velocity_m_per_s.to_f64()), digits)
}

fn onset(context: &Context) -> Option<Table> {
    let note = "Velocities in dex are log10 of the ratio to that of the asymptote (eq 20; eq 18 on the upper arc). The exact boundary is enclosed and the threshold is decided exactly. Simulated oscillation begins where the squared frequency of small deviations extrapolates to zero. Oscillation is visible if V, after its first peak above V_l in the run from V_l/10, rises again, or falls below V_l, by the scene's visible fraction of V_l.";
    let rows = lines(context).flat_map(|(name, line)| line.seen.iter().map(move |seen| (name, line, seen)));
    let located = |line, found: Option<&Located>| found.map(|found| dex(line, found.velocity_m_per_s, 4));
    let error = |found: Option<&Located>| rounded(found.map(|found| found.error_dex), 1);
    let six = |ball| Cell::number(certain_digits(ball, 6));
    Table::of("onset", "Onset of oscillation at given normal stress", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .text("law", "Law", |(.., seen)| seen.law.as_str())
        .number("normal_stress_pa", "Normal stress σ", "Pa", |(_, line, _)| {
            decimal(&line.normal_stress_pa, 4)
        })
        .text("asymptote", "Asymptote", |(_, line, _)| line.asymptote.as_str())
        .number("asymptote_velocity_m_per_s", "Velocity of the asymptote", "m/s", |(_, line, _)| {
            six(&line.asymptote_velocity_m_per_s)
        })
        .number("boundary_velocity_m_per_s", "Velocity of the exact boundary", "m/s", |(_, line, _)| {
            six(&line.boundary_velocity_m_per_s)
        })
        .number("boundary_dex", "Exact boundary", "dex", |(_, line, _)| {
            dex(line, line.boundary_velocity_m_per_s.to_f64(), 4)
        })
        .number("simulated_dex", "Oscillation in simulations", "dex", |(_, line, seen)| {
            located(line, seen.exists.as_ref())
        })
        .number("simulated_error_dex", "Its error", "dex", |(.., seen)| error(seen.exists.as_ref()))
        .number("inertial_dex", "Inertial by the threshold", "dex", |(_, line, _)| {
            located(line, line.inertial.as_ref())
        })
        .number("second_rise_dex", "Second rise visible", "dex", |(_, line, seen)| {
            located(line, seen.second_rise.as_ref())
        })
        .number("undershoot_dex", "Undershoot visible", "dex", |(_, line, seen)| {
            located(line, seen.undershoot.as_ref())
        })
        .number("seen_error_dex", "Error of the visible onset", "dex", |(.., seen)| {
            error(seen.undershoot.as_ref())
        })
        .rounded("peak_excess_at_boundary", "V_peak/V_l − 1 at the boundary", "", 3, |(.., seen)| {
            seen.peak_excess_at_boundary
        })
        .unless_empty()
}

fn runs(context: &Context) -> Option<Table> {
    let note = "Samples of the runs of fig 4, equally spaced in time.";
    let runs = lines(context).flat_map(|(name, line)| line.shown.iter().map(move |run| (name, line, run)));
    let rows = runs.flat_map(|(name, line, run)| run.history.iter().map(move |at| (name, line, run, at)));
    Table::of("onset-runs", "Runs on either side of the onset", rows)
        .note(note)
        .text("scene", "Scene", |(name, ..)| name)
        .number("normal_stress_pa", "Normal stress σ", "Pa", |(_, line, ..)| {
            decimal(&line.normal_stress_pa, 4)
        })
        .rounded("loading_velocity_m_per_s", "Loading velocity V_l", "m/s", 4, |(_, _, run, _)| {
            run.loading_velocity_m_per_s
        })
        .rounded("loaded_distance_over_slip_distance", "V_l t/D_c", "", 4, |(.., at)| at.0)
        .rounded("velocity_over_loading_velocity", "V/V_l", "", 5, |(.., at)| at.1)
        .unless_empty()
}
