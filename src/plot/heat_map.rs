//! Heat maps over two axes: filled contours of a grid of values, with the area of exact zeros left uncoloured.

use super::{Axis, Caption, Line, PointMark, RegionLabel};

/// The colour bar of a heat map: logarithmic, in even steps.
#[derive(Debug, Clone, PartialEq)]
pub struct ColourScale {
    /// Title with figure markup, such as `max Im(*s*)`.
    pub title: String,
    /// Unit, such as `1/s`.
    pub unit: String,
    /// Value at the dark end; smaller positive values take the same colour. Positive.
    pub min: f64,
    /// Value at the bright end; larger values take the same colour.
    pub max: f64,
    /// Number of colour steps between `min` and `max`, 2 to 64.
    pub steps: usize,
}

/// A map of a positive quantity over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Number of grid columns, at least 2; they are even on the axis, the first at `x.min`, the last at `x.max`.
    pub columns: usize,
    /// Values row by row from `y.min` to `y.max`, `columns` in each row; zero or less and NaN are left uncoloured.
    pub values: Vec<f64>,
    /// Colour bar.
    pub colours: ColourScale,
    /// Outlines of the areas where the value is exactly zero, in axis values. Where they are given, the colour
    /// reaches up to them; without them the edge lies half-way between grid points.
    pub zero_areas: Vec<Vec<(f64, f64)>>,
    /// Legend entry for the uncoloured area in figure markup; empty when there is none.
    pub zero_label: String,
    /// Lines over the map.
    pub lines: Vec<Line>,
    /// Marked points.
    pub marks: Vec<PointMark>,
    /// Names of regions.
    pub labels: Vec<RegionLabel>,
}
