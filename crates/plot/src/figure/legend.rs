//! Legends: rows of keys below the chart, broken to its width.

use std::collections::BTreeSet;

use super::frame::SMALL;
use super::path::Point;
use super::svg::Svg;
use super::{palette, rich_text};

/// Width of the sample before an entry's words.
pub(crate) const KEY_WIDTH: f64 = 34.0;

/// Height of a row.
const ROW: f64 = 22.0;

/// Space between entries.
const GAP: f64 = 20.0;

/// Draws a sample at a point.
type Key<'a> = Box<dyn Fn(&mut Svg, Point) + 'a>;

/// One entry: a sample drawn around a point, and its words.
pub(crate) struct Entry<'a> {
    /// Words in figure markup.
    label: String,
    /// Draws the sample, given the left end of its middle line; it is [`KEY_WIDTH`] − 6 wide.
    key: Key<'a>,
}

impl<'a> Entry<'a> {
    pub fn new(label: &str, key: impl Fn(&mut Svg, Point) + 'a) -> Self {
        Self { label: label.to_owned(), key: Box::new(key) }
    }
}

/// Rows of entries that fit a width.
pub(crate) struct Legend<'a> {
    /// Each entry with the left end of its middle line.
    entries: Vec<(Point, Entry<'a>)>,
    rows: usize,
}

impl<'a> Legend<'a> {
    /// Lays the entries out in rows of at most `width`; entries without words or with words already seen are left out.
    pub fn new(entries: Vec<Entry<'a>>, width: f64) -> Self {
        let mut seen = BTreeSet::from([String::new()]);
        let (mut placed, mut rows, mut right) = (Vec::new(), 0, f64::INFINITY);
        for entry in entries.into_iter().filter(|entry| seen.insert(entry.label.clone())) {
            let needed = KEY_WIDTH + rich_text::width(&entry.label, SMALL);
            if right + needed > width {
                rows += 1;
                right = 0.0;
            }
            placed.push(((right, ROW * (rows as f64 - 0.5)), entry));
            right += needed + GAP;
        }
        Self { entries: placed, rows }
    }

    /// Height on the canvas.
    pub fn height(&self) -> f64 {
        if self.rows == 0 { 0.0 } else { self.rows as f64 * ROW + 6.0 }
    }

    /// Draws the legend with its upper left corner at `corner`.
    pub fn draw(&self, svg: &mut Svg, corner: Point) {
        if self.rows == 0 {
            return;
        }
        svg.open("g", &[("class", "ink legend"), ("fill", palette::INK), ("font-size", "13")]);
        for ((left, middle), entry) in &self.entries {
            let (x, y) = (corner.0 + left, corner.1 + middle);
            (entry.key)(svg, (x, y));
            svg.words((x + KEY_WIDTH, y + 4.5), &entry.label, SMALL);
        }
        svg.close();
    }
}
