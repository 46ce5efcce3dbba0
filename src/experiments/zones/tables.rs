//! Tables of slip modes.

use crate::experiments::shared::Grid;
use crate::experiments::shared::cells::Digits;
use crate::experiments::zones::{InertialLine, ZonesOutcome};
use crate::experiments::{Context, Need, SceneOutcome, TableMaker, table_of};
use crate::scene::cited;
use slipmode_core::number::Ball;
use slipmode_core::stability::SlipMode;
use slipmode_plot::table::{Cell, Table};

const NEEDS: &[Need] = &[Need::Map, Need::Zones];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "zones", needs: NEEDS, make: zones },
    TableMaker { id: "inertial-lines", needs: NEEDS, make: inertial_lines },
    TableMaker { id: "thresholds", needs: NEEDS, make: thresholds },
    TableMaker {
        id: "lines-on-the-map",
        needs: &[Need::Map, Need::Zones, Need::Tolerance],
        make: lines_on_the_map,
    },
];

/// The scenes with zones.
fn zoned<'c>(context: &'c Context) -> impl Iterator<Item = (&'c SceneOutcome, &'c ZonesOutcome)> {
    context.outcome.scenes.iter().filter_map(|scene| Some((scene, scene.zones.as_ref()?)))
}

fn zones(context: &Context) -> Option<Table> {
    let modes = zoned(context).flat_map(|(scene, zones)| {
        let points = |grid: &Grid<SlipMode>, mode| grid.values.iter().filter(|value| **value == mode).count();
        let counted = move |mode| {
            (scene, zones, mode, [&zones.exact, &zones.simplified].map(|grid| points(grid, mode)))
        };
        SlipMode::ALL.map(counted)
    });
    let found = modes.filter(|(.., [exact, simplified])| exact + simplified > 0);
    table_of("zones", found)
        .text("scene", |(scene, ..)| scene.scene.name.as_str())
        .text("slider", |(scene, ..)| scene.slider_words())
        .text("slip_mode", |(_, _, mode, _)| mode.as_str())
        .number("points_exact", |(.., [exact, _])| exact)
        .number("points_simplified", |(.., [_, simplified])| simplified)
        .number("areas", |(_, zones, mode, _)| zones.exact.areas_of(&mode))
        .table()
}

fn inertial_lines(context: &Context) -> Option<Table> {
    let counts = zoned(context).flat_map(|(scene, zones)| {
        zones.inertial_lines.iter().map(move |(line, count)| (scene, zones, *line, count))
    });
    table_of("inertial-lines", counts)
        .text("scene", |(scene, ..)| scene.scene.name.as_str())
        .text("slider", |(scene, ..)| scene.slider_words())
        .text("line", |(_, _, line, _)| cited(line.as_str()))
        .number("misplaced", |(.., misplaced)| *misplaced)
        .number("points", |(_, zones, ..)| zones.exact.values.len())
        .digits("off_dex", 4, |(_, zones, line, _)| {
            (line == InertialLine::Corners).then_some(zones.modes_off_dex)
        })
        .table()
}

fn lines_on_the_map(context: &Context) -> Option<Table> {
    let found =
        zoned(context).filter_map(|(scene, zones)| Some((scene, zones, &scene.tolerance.as_ref()?.corners)));
    let dex = |error: &Ball| (&((error.clone() + Ball::from(1)).ln() / Ball::from(10).ln())).cell(6);
    table_of("lines-on-the-map", found)
        .text("scene", |(scene, ..)| scene.scene.name.as_str())
        .text("slider", |(scene, ..)| scene.slider_words())
        .number("upper_worst_dex", |(.., corners)| {
            corners.upper.as_ref().map(|upper| dex(&upper.quasi_static))
        })
        .digits("lower_worst_dex", 6, |(_, _, corners)| &corners.lower_worst_log10)
        .number("points", |(_, zones, _)| Cell::from(zones.exact.values.len()).certain())
        .number("areas_misplaced", |(_, zones, _)| Cell::from(zones.disagreeing_areas).certain())
        .number("modes_misplaced", |(_, zones, _)| Cell::from(zones.disagreeing_modes).certain())
        .table()
}

fn thresholds(context: &Context) -> Option<Table> {
    let shares = zoned(context).flat_map(|(scene, zones)| {
        zones.thresholds.iter().map(move |share| (scene.scene.name.as_str(), share))
    });
    table_of("thresholds", shares)
        .text("scene", |(name, _)| name)
        .digits("frequency_ratio", 4, |(_, share)| share.frequency_ratio)
        .number("oscillating", |(_, share)| share.oscillating)
        .number("inertial", |(_, share)| share.inertial)
        .number("moved", |(_, share)| share.moved)
        .table()
}
