//! Range charts: for each row, over which stretch of an axis something is good enough, and to what level.

use super::frame::{CANVAS_WIDTH, Frame, NORMAL, SMALL};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::path::Point;
use super::svg::{Svg, number};
use super::{Axis, Caption, palette, rich_text};

/// A stretch of the axis.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
pub struct Span {
    /// Value at one end; values beyond the axis are cut off at its edge.
    pub from: f64,
    /// Value at the other end.
    pub to: f64,
    /// Index into [`RangeChart::levels`].
    pub level: usize,
}

/// A row of the chart.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RangeRow {
    /// Name of the row in figure markup, such as `eq. 15`.
    pub label: String,
    /// Second, smaller line of the name; may be empty.
    pub detail: String,
    /// Stretches, drawn in their order, so that the stricter level comes after the looser one it lies in.
    pub spans: Vec<Span>,
}

/// Where something is good enough: rows of nested bars along one axis.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
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

/// Left edge and top of the bars on the canvas.
const CORNER: Point = (168.0, 14.0);
/// Width of the bars' axis.
const WIDTH: f64 = 452.0;
/// Height of a row.
const ROW: f64 = 46.0;
/// Height of the loosest bar; each stricter one is a little lower, so that the one around it shows.
const BAR: f64 = 26.0;

impl RangeChart {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let height = ROW * self.rows.len().max(1) as f64;
        let rows_axis = Axis::linear("", "", 0.0, 1.0);
        let frame = Frame::new(&self.axis, &rows_axis, CORNER, (WIDTH, height));
        let legend = Legend::new(self.legend_entries(), WIDTH);
        let below = frame.bounds.bottom + 60.0;
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, below + legend.height());
        frame.draw_panel(&mut svg, "panel");
        frame.draw_upright_grid(&mut svg);
        for (index, row) in self.rows.iter().enumerate() {
            let middle = CORNER.1 + ROW * (index as f64 + 0.5);
            row.spans.iter().for_each(|span| self.draw_span(&mut svg, &frame, middle, span));
            draw_name(&mut svg, middle, row);
        }
        frame.draw_lower_axis(&mut svg);
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    fn draw_span(&self, svg: &mut Svg, frame: &Frame, middle: f64, span: &Span) {
        let (Some(one), Some(two)) = (self.axis.position(span.from), self.axis.position(span.to)) else {
            return;
        };
        let (low, high) = (one.min(two).clamp(0.0, 1.0), one.max(two).clamp(0.0, 1.0));
        if high <= low {
            return;
        }
        let (left, right) = (frame.place_unit((low, 0.0)).0, frame.place_unit((high, 0.0)).0);
        draw_bar(svg, (left, middle), (right - left, bar_height(span.level)), span.level);
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let entry = |(level, words): (usize, &String)| {
            Entry::new(words, move |svg, at| draw_bar(svg, at, (KEY_WIDTH - 8.0, 14.0), level))
        };
        self.levels.iter().enumerate().map(entry).collect()
    }
}

fn look(level: usize) -> usize {
    level.min(palette::LEVELS.len() - 1)
}

fn bar_height(level: usize) -> f64 {
    BAR - 6.0 * look(level) as f64
}

fn draw_bar(svg: &mut Svg, (left, middle): Point, (width, height): Point, level: usize) {
    let class = format!("level level-{}", look(level));
    svg.rect(
        (left, middle - height / 2.0),
        (width, height),
        &[("class", &class), ("fill", palette::LEVELS[look(level)]), ("stroke", palette::LEVELS[2])],
    );
}

fn draw_name(svg: &mut Svg, middle: f64, row: &RangeRow) {
    let x = number(CORNER.0 - 12.0);
    let lift = if row.detail.is_empty() { 5.0 } else { -2.0 };
    let rows = [
        (lift, &row.label, NORMAL, "14", palette::INK, "ink"),
        (15.0, &row.detail, SMALL, "12.5", palette::FAINT_INK, "ink faint"),
    ];
    for (shift, markup, size, font_size, fill, class) in rows.into_iter().filter(|row| !row.1.is_empty()) {
        let y = number(middle + shift);
        let attributes = [
            ("class", class),
            ("x", x.as_str()),
            ("y", &y),
            ("text-anchor", "end"),
            ("font-size", font_size),
            ("fill", fill),
        ];
        svg.text(&attributes, &rich_text::to_svg(markup, size));
    }
}
