//! Zone maps: a plane divided into named regions, told apart by pattern, colour and name.

use super::{Axis, Caption, Line, PointMark, RegionLabel};

/// A region of the plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Zone {
    /// Legend entry in figure markup.
    pub label: String,
    /// Outlines in axis values; an outline inside another is a hole.
    pub outlines: Vec<Vec<(f64, f64)>>,
    /// Pattern and colour, 0 to 7; equal numbers look alike in every figure.
    pub style: usize,
}

/// A plane divided into zones.
#[derive(Debug, Clone, PartialEq)]
pub struct ZoneMap {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Zones, the later ones over the earlier ones.
    pub zones: Vec<Zone>,
    /// Lines over the zones.
    pub lines: Vec<Line>,
    /// Marked points.
    pub marks: Vec<PointMark>,
    /// Names of zones.
    pub labels: Vec<RegionLabel>,
}
