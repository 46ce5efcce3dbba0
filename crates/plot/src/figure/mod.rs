//! Figures as data, drawn as SVG: heat maps, line charts, panels of them, zone maps, range charts and layered graphs.
//!
//! A figure is a plain value; `svg()` turns it into text that is the same on every machine: coordinates are rounded
//! to a tenth of a unit, logarithms come from the `libm` crate, and nothing depends on the order of threads.
//! Words in figures (titles, labels, legends) may use a little markup: `*V*` is italic, `**K**` bold, `_0` or `_{qs}` a subscript,
//! `^2` or `^{-3}` a superscript, a backslash takes the next character as it is.
//!
//! Colours: a perceptually even scale for values and a colour-blind-safe set for lines, which also differ by dash
//! and marker. Every element has a class, so that a page can restyle the ink for a dark theme; without a style
//! sheet the presentation attributes give a light plate.
//!
//! ```
//! use slipmode_plot::figure::{Axis, Caption, LineChart, Series};
//!
//! let decay = Series::line("decay", (0..50).map(|i| (f64::from(i), 2f64.powi(-i))).collect());
//! let chart = LineChart {
//!     caption: Caption::new("decay", "A decay", "The line falls steeply and then flattens."),
//!     x: Axis::linear("Time", "s", 0.0, 50.0),
//!     y: Axis::log10("Amplitude", "m", 1e-15, 1.0),
//!     series: vec![decay],
//!     references: Vec::new(),
//! };
//! assert!(chart.svg().starts_with("<svg"));
//! ```

mod axis;
mod contour;
mod covered;
mod family_map;
mod frame;
mod heat_map;
mod inset;
mod layer_places;
mod layers;
mod legend;
mod line_chart;
mod lines;
mod overlay;
mod palette;
mod panels;
mod path;
mod path_data;
mod range_chart;
mod readout;
mod rich_text;
#[cfg(test)]
pub(crate) mod sample;
mod scale;
mod series_style;
mod svg;
#[cfg(test)]
mod tests;
mod ticks;
mod zone_map;
mod zones;

pub use axis::Axis;
pub use family_map::FamilyMap;
pub use heat_map::{ColourScale, HeatMap};
pub use inset::Inset;
pub use layers::{BoxLook, BoxNode, LayeredGraph};
pub use line_chart::LineChart;
pub use lines::{Reference, Series};
pub use overlay::{Line, LineRole, PointMark, RegionLabel, Side};
pub use panels::{Panel, Panels};
pub use path::kept;
pub use range_chart::{RangeChart, RangeRow, Span};
pub use readout::{Readout, Words, packed};
pub use scale::Scale;
pub use svg::within_html;
pub use zone_map::{Zone, ZoneMap, zone_fill};
pub use zones::zones_of_grid;

/// What names a figure: its id and the words read out instead of it.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct Caption {
    /// Name of the file and prefix of every id inside the SVG, `[A-Za-z0-9._-]{1,100}`.
    pub id: String,
    /// Short title, the accessible name of the picture.
    pub title: String,
    /// What the picture shows, for those who cannot see it; plain text.
    pub description: String,
}

impl Caption {
    /// A caption from its three parts.
    #[must_use]
    pub fn new(id: &str, title: &str, description: &str) -> Self {
        Self { id: id.into(), title: title.into(), description: description.into() }
    }
}
