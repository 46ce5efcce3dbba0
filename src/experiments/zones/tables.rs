//! Tables of slip modes.

use crate::experiments::shared::Grid;
use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use crate::scene::cited;
use slipmode_core::stability::SlipMode;
use slipmode_plot::table::Table;

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "zones", needs: &[Need::Map, Need::Zones], make: zones },
    TableMaker { id: "inertial-lines", needs: &[Need::Map, Need::Zones], make: inertial_lines },
    TableMaker { id: "thresholds", needs: &[Need::Map, Need::Zones], make: thresholds },
];

fn zones(context: &Context) -> Option<Table> {
    let modes = context.outcome.each(|scene| &scene.zones).flat_map(|(name, zones)| {
        let points = |grid: &Grid<SlipMode>, mode| grid.values.iter().filter(|value| **value == mode).count();
        let counted =
            move |mode| (name, zones, mode, [&zones.exact, &zones.simplified].map(|grid| points(grid, mode)));
        SlipMode::ALL.map(counted)
    });
    let found = modes.filter(|(.., [exact, simplified])| exact + simplified > 0);
    Table::of("zones", "Slip modes: exact, and by the lines of fig 7", found)
        .note("Areas are counted on the exact map's points, which is a sample: where an area is narrower than the grid, as at a cusp, its parts count apart.")
        .text("scene", "Scene", |(name, ..)| name)
        .text("slip_mode", "Slip mode", |(_, _, mode, _)| mode.as_str())
        .number("points_exact", "Points, exact", "", |(.., [exact, _])| exact)
        .number("points_simplified", "Points, simplified map", "", |(.., [_, simplified])| simplified)
        .number("areas", "Connected areas on the grid", "", |(_, zones, mode, _)| {
            zones.exact.areas_of(&mode)
        })
        .table()
        .into()
}

fn inertial_lines(context: &Context) -> Option<Table> {
    let zoned = context.outcome.each(|scene| &scene.zones);
    let counts =
        zoned.flat_map(|(name, zones)| zones.inertial_lines.iter().map(move |count| (name, zones, count)));
    Table::of(
        "inertial-lines",
        "The simplified map of fig 7 with each line between inertial and non-inertial",
        counts,
    )
    .note("The paper gives no equation of this line. Those of the transition and of the asymptotes draw all other lines.")
    .text("scene", "Scene", |(name, ..)| name)
    .text("line", "Line", |(.., count)| cited(count.line.as_str()))
    .number("misplaced", "Points in another slip mode than the exact one", "", |(.., count)| count.misplaced)
    .number("points", "Points", "", |(_, zones, _)| zones.exact.values.len())
    .table()
    .into()
}

fn thresholds(context: &Context) -> Option<Table> {
    let note = "The default threshold is √½, the frequency ratio on K = K_c at η = 1.";
    let zoned = context.outcome.each(|scene| &scene.zones);
    let shares = zoned.flat_map(|(name, zones)| zones.thresholds.iter().map(move |share| (name, share)));
    Table::of(
        "thresholds",
        "Dependence of the map on the threshold between inertial and non-inertial",
        shares,
    )
    .note(note)
    .text("scene", "Scene", |(name, _)| name)
    .digits("frequency_ratio", "Threshold ω/ω_n", "", 4, |(_, share)| share.frequency_ratio)
    .number("oscillating", "Oscillating points", "", |(_, share)| share.oscillating)
    .number("inertial", "Of them inertial", "", |(_, share)| share.inertial)
    .number("moved", "Points whose mode differs from the default's", "", |(_, share)| share.moved)
    .table()
    .into()
}
