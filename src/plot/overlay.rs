//! What is drawn over a map: lines, points and the names of regions.

/// What a line means; it decides colour, width and dash, the same in every figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum LineRole {
    /// The exact boundary max Im(s) = 0: solid, dark.
    Boundary,
    /// An asymptote of the boundary: dashed, dark.
    Asymptote,
    /// The transition K = K_c: solid, white on a dark casing.
    Transition,
    /// A line that only helps the eye: thin and dotted.
    Guide,
}

/// A line over a map.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Legend entry in figure markup; lines with equal labels share one entry, an empty label has none.
    pub label: String,
    /// What the line means.
    pub role: LineRole,
    /// Vertices in axis values; a vertex without a place on the axes interrupts the line.
    pub points: Vec<(f64, f64)>,
}

/// On which side of a point its label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left, ending at the point.
    Left,
    /// To the right, starting at the point.
    Right,
    /// Centred above.
    Above,
    /// Centred below.
    Below,
}

/// A marked point, such as the cusp.
#[derive(Debug, Clone, PartialEq)]
pub struct PointMark {
    /// Label in figure markup; may be empty.
    pub label: String,
    /// Horizontal axis value.
    pub x: f64,
    /// Vertical axis value.
    pub y: f64,
    /// Where the label stands.
    pub side: Side,
}

/// The name of a region or line, centred at a place and set with a halo.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionLabel {
    /// Lines of text in figure markup, from top to bottom.
    pub lines: Vec<String>,
    /// Horizontal axis value of the centre.
    pub x: f64,
    /// Vertical axis value of the centre.
    pub y: f64,
}
