//! Tables of slip modes.

use crate::experiments::shared::Grid;
use crate::experiments::shared::cells::{DigitColumns, Digits};
use crate::experiments::zones::{InertialLine, LineCount, ZonesOutcome};
use crate::experiments::{Context, Need, SceneOutcome, TableMaker};
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
    Table::of("zones", "Slip modes: exact, and by the lines of fig 7", found)
        .note("Areas are counted on the exact map's points, which is a sample: where an area is narrower than the grid, as at a cusp, its parts count apart.")
        .text("scene", "Scene", |(scene, ..)| scene.scene.name.as_str())
        .text("slider", "Slider", |(scene, ..)| scene.slider_words())
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
    let counts = zoned(context)
        .flat_map(|(scene, zones)| zones.inertial_lines.iter().map(move |count| (scene, zones, count)));
    let drawn = |count: &LineCount| count.line == InertialLine::Corners;
    Table::of(
        "inertial-lines",
        "The simplified map of fig 7 with each line between inertial and non-inertial",
        counts,
    )
    .note("The paper gives no equation of this line. Those of the transition and of the asymptotes draw all other lines. Farthest: of the points that are drawn wrong, from where the drawn slip mode is exact, along an axis, on the points of the map.")
    .text("scene", "Scene", |(scene, ..)| scene.scene.name.as_str())
    .text("slider", "Slider", |(scene, ..)| scene.slider_words())
    .text("line", "Line", |(.., count)| cited(count.line.as_str()))
    .number("misplaced", "Points in another slip mode than the exact one", "", |(.., count)| count.misplaced)
    .number("points", "Points", "", |(_, zones, _)| zones.exact.values.len())
    .digits("off_dex", "Farthest", "dex", 4, |(_, zones, count)| drawn(count).then_some(zones.modes_off_dex))
    .table()
    .into()
}

fn lines_on_the_map(context: &Context) -> Option<Table> {
    let found =
        zoned(context).filter_map(|(scene, zones)| Some((scene, zones, &scene.tolerance.as_ref()?.corners)));
    let dex = |error: &Ball| (&((error.clone() + Ball::from(1)).ln() / Ball::from(10).ln())).cell(6);
    Table::of("lines-on-the-map", "The boundary beside the lines of fig 7", found)
        .note("Largest distance of each arc of the boundary from its two lines, which is where these meet. Points where the lines draw another stability or oscillation, and another slip mode with V0 = V_c as the line of inertial oscillation.")
        .text("scene", "Scene", |(scene, ..)| scene.scene.name.as_str())
        .text("slider", "Slider", |(scene, ..)| scene.slider_words())
        .number("upper_worst_dex", "Upper arc", "dex", |(_, _, corners)| {
            corners.upper.as_ref().map_or_else(Cell::empty, |errors| dex(&errors.quasi_static))
        })
        .digits("lower_worst_dex", "Lower arc", "dex", 6, |(_, _, corners)| &corners.lower_worst_log10)
        .number("points", "Points", "", |(_, zones, _)| Cell::from(zones.exact.values.len()).certain())
        .number("areas_misplaced", "Other stability or oscillation", "", |(_, zones, _)| Cell::from(zones.disagreeing_areas).certain())
        .number("modes_misplaced", "Other slip mode", "", |(_, zones, _)| Cell::from(zones.disagreeing_modes).certain())
        .table()
        .into()
}

fn thresholds(context: &Context) -> Option<Table> {
    let note = "The default threshold is √½, the frequency ratio on K = K_c at η = 1.";
    let shares = zoned(context).flat_map(|(scene, zones)| {
        zones.thresholds.iter().map(move |share| (scene.scene.name.as_str(), share))
    });
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
