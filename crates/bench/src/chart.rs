//! A line chart as data: the report that shows it draws it.

use slipmode_plot::figure::Series;

/// A chart on logarithmic axes, with its words.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// The id by which prose places it.
    pub id: &'static str,
    /// Label such as `Figure P1`.
    pub label: &'static str,
    /// One line that says what it shows.
    pub title: String,
    /// What it shows and what to look at, in Markdown.
    pub caption: String,
    /// Description for those who cannot see it.
    pub description: &'static str,
    /// Ids of the tables that hold its numbers.
    pub data: &'static [&'static str],
    /// Horizontal axis.
    pub x: LogAxis,
    /// Vertical axis.
    pub y: LogAxis,
    /// Lines.
    pub series: Vec<Series>,
    /// An upright line at a value of the horizontal axis, and its words.
    pub vertical: Option<(f64, &'static str)>,
}

/// Title, unit and ends of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogAxis {
    /// Title.
    pub title: &'static str,
    /// Unit; empty for pure numbers.
    pub unit: &'static str,
    /// Where it begins and ends; none to follow from the points.
    pub ends: Option<[f64; 2]>,
}

impl LogAxis {
    /// An axis whose ends follow from the points.
    #[must_use]
    pub const fn new(title: &'static str, unit: &'static str) -> Self {
        Self { title, unit, ends: None }
    }

    /// The same axis from one value to another.
    #[must_use]
    pub const fn between(mut self, from: f64, to: f64) -> Self {
        self.ends = Some([from, to]);
        self
    }
}

/// The ends of an axis that shows these values with a little room; none without a positive one.
#[must_use]
pub fn ends(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
        (least, greatest) = (least.min(value), greatest.max(value));
    }
    (least <= greatest).then_some([0.7 * least, 1.5 * greatest])
}

/// A line with a mark at every point.
pub(crate) fn marked(label: &str, points: Vec<(f64, f64)>) -> Series {
    Series::marked(label, points)
}
