//! Line charts: several series over linear, logarithmic or signed logarithmic axes.

use super::{Axis, Caption, RegionLabel};

/// One line of a chart. Dash, marker and colour follow from its place in the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Legend entry in figure markup.
    pub label: String,
    /// Points in axis values, in drawing order; one without a place on the axes interrupts the line.
    pub points: Vec<(f64, f64)>,
    /// Whether every point carries a marker; otherwise a few are spread along the line.
    pub marked: bool,
    /// Drawn thin, dashed and grey: a formula that the other series are compared with.
    pub theory: bool,
}

/// A straight line across the chart at one value.
#[derive(Debug, Clone, PartialEq)]
pub enum Reference {
    /// Across at a value of the vertical axis.
    Horizontal {
        /// Value on the vertical axis.
        at: f64,
        /// Text at its right end in figure markup.
        label: String,
    },
    /// Upright at a value of the horizontal axis.
    Vertical {
        /// Value on the horizontal axis.
        at: f64,
        /// Text at its upper end in figure markup.
        label: String,
    },
}

/// A shaded strip across the chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Whether `from` and `to` are values of the vertical axis (a lying strip) or of the horizontal one.
    pub across: bool,
    /// One edge.
    pub from: f64,
    /// The other edge.
    pub to: f64,
    /// Legend entry in figure markup; may be empty.
    pub label: String,
}

/// A chart of lines.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines from the lowest to the topmost.
    pub series: Vec<Series>,
    /// Straight reference lines.
    pub references: Vec<Reference>,
    /// Shaded strips, drawn first.
    pub bands: Vec<Band>,
    /// Words inside the chart.
    pub labels: Vec<RegionLabel>,
}
