//! Range charts: for each row, over which stretch of an axis something is good enough, and to what level.

use super::{Axis, Caption};

/// A stretch of the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Value at one end; values beyond the axis are cut off at its edge.
    pub from: f64,
    /// Value at the other end.
    pub to: f64,
    /// Index into [`RangeChart::levels`].
    pub level: usize,
}

/// A row of the chart.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeRow {
    /// Name of the row in figure markup, such as `eq. 15`.
    pub label: String,
    /// Second, smaller line of the name; may be empty.
    pub detail: String,
    /// Stretches, drawn in their order, so that the stricter level comes after the looser one it lies in.
    pub spans: Vec<Span>,
}

/// Where something is good enough: rows of nested bars along one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeChart {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub axis: Axis,
    /// Names of the levels from the loosest to the strictest, in figure markup, such as `within 10 %`.
    pub levels: Vec<String>,
    /// Rows from top to bottom.
    pub rows: Vec<RangeRow>,
}
