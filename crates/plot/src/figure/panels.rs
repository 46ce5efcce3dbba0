//! Small line charts side by side, each with axes of its own: what a single chart would draw on top of each other.

use super::frame::{CANVAS_WIDTH, Frame, SMALL};
use super::legend::Legend;
use super::lines::{LineStyle, draw_lines, series_entries};
use super::path::Point;
use super::svg::{Svg, number};
use super::{Axis, Caption, Reference, Series, palette, rich_text};

/// One small chart.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Panel {
    /// Lines of text above the chart in figure markup; the first is its name, such as `**b** stick-slip`.
    pub heading: Vec<String>,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines from the lowest to the topmost; they look alike in panels that list them in the same order.
    pub series: Vec<Series>,
    /// Straight reference lines.
    pub references: Vec<Reference>,
}

/// Small charts in rows.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Panels {
    /// Id, title and description.
    pub caption: Caption,
    /// Charts in a row, at least 1.
    pub columns: usize,
    /// Height of one chart, in canvas units.
    pub height: f64,
    /// The charts, row by row.
    pub panels: Vec<Panel>,
}

/// Room left of a chart for its tick labels and its title.
const LEFT: f64 = 76.0;
/// Room right of a chart.
const RIGHT: f64 = 18.0;
/// How far a drawn line may lie from the given one, in canvas units: panels are many and looked at as a whole.
const LINE_TOLERANCE: f64 = 0.3;
/// Height of one line of a heading.
const LINE: f64 = 18.0;
/// Room above a heading.
const ABOVE: f64 = 6.0;
/// Room below a chart for its tick labels and its title.
const BELOW: f64 = 56.0;

impl Panels {
    /// The panels as SVG text.
    ///
    /// Panels whose legends are the same share one, in the free place of the last row or below it; others have
    /// their own. A panel with one line has none.
    #[must_use]
    pub fn svg(&self) -> String {
        let shared = self.shared_legend();
        let columns = self.columns.max(1);
        let width = CANVAS_WIDTH / columns as f64;
        let rows: Vec<&[Panel]> = self.panels.chunks(columns).collect();
        let heights: Vec<f64> =
            rows.iter().map(|row| self.row_height(row, width, shared.is_some())).collect();
        let total: f64 = heights.iter().sum();
        let free = rows.last().map(|row| row.len()).filter(|used| *used < columns && rows.len() > 1);
        let below = shared
            .filter(|_| free.is_none())
            .map_or(0.0, |panel| legend(panel, CANVAS_WIDTH - LEFT).height());
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, total + below);
        let mut top = 0.0;
        for (row, height) in rows.iter().zip(&heights) {
            for (column, panel) in row.iter().enumerate() {
                self.draw(&mut svg, panel, (width * column as f64, top), width, shared.is_none());
            }
            top += height;
        }
        if let Some(panel) = shared {
            match free.zip(heights.last()) {
                Some((used, height)) => {
                    let corner = (width * used as f64 + LEFT, total - height + self.head(panel));
                    legend(panel, width - LEFT).draw(&mut svg, corner);
                }
                None => legend(panel, CANVAS_WIDTH - LEFT).draw(&mut svg, (LEFT, total)),
            }
        }
        svg.finish()
    }

    /// The panel whose legend is that of all.
    fn shared_legend(&self) -> Option<&Panel> {
        let first = self.panels.first()?;
        let labels =
            |panel: &Panel| panel.series.iter().map(|series| series.label.clone()).collect::<Vec<_>>();
        let words = labels(first);
        (words.len() > 1 && self.panels.iter().all(|panel| labels(panel) == words)).then_some(first)
    }

    fn head(&self, panel: &Panel) -> f64 {
        ABOVE + LINE * panel.heading.len() as f64
    }

    /// Height of a row: its tallest panel, with its own legend unless they share one.
    fn row_height(&self, row: &[Panel], width: f64, shared: bool) -> f64 {
        let of = |panel: &Panel| {
            let own =
                if shared || panel.series.len() < 2 { 0.0 } else { legend(panel, width - LEFT).height() };
            self.head(panel) + self.height + BELOW + own
        };
        row.iter().map(of).fold(0.0, f64::max)
    }

    fn draw(&self, svg: &mut Svg, panel: &Panel, corner: Point, width: f64, own_legend: bool) {
        let place = (corner.0 + LEFT, corner.1 + self.head(panel));
        let frame = Frame::new(&panel.x, &panel.y, place, (width - LEFT - RIGHT, self.height));
        frame.draw_panel(svg, "panel");
        frame.draw_grid(svg);
        let style = LineStyle { tolerance: LINE_TOLERANCE, markers: panel.series.len() > 1 };
        draw_lines(svg, &frame, &panel.references, &panel.series, style);
        frame.draw_axes(svg);
        for (index, line) in panel.heading.iter().enumerate() {
            let at = [number(place.0), number(corner.1 + ABOVE + LINE * index as f64 + 12.0)];
            let attributes =
                [("class", "ink"), ("fill", palette::INK), ("font-size", "13"), ("x", &at[0]), ("y", &at[1])];
            svg.text(&attributes, &rich_text::to_svg(line, SMALL));
        }
        if own_legend && panel.series.len() > 1 {
            legend(panel, width - LEFT).draw(svg, (place.0, frame.bounds.bottom + BELOW - 4.0));
        }
    }
}

fn legend(panel: &Panel, width: f64) -> Legend<'_> {
    Legend::new(series_entries(&panel.series), width)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panels(count: usize, labels: impl Fn(usize) -> [String; 2]) -> Panels {
        let panel = |index: usize| Panel {
            heading: vec![format!("**{index}**")],
            x: Axis::linear("*t*", "s", 0.0, 1000.0),
            y: Axis::linear("*τ*", "kPa", -1.0, 1.0),
            series: labels(index)
                .map(|label| Series {
                    label,
                    points: vec![(0.0, 0.0), (1000.0, 0.5)],
                    marked: false,
                    joined: true,
                    theory: false,
                })
                .to_vec(),
            references: Vec::new(),
        };
        Panels {
            caption: Caption::new("panels", "Panels", "Lines."),
            columns: 2,
            height: 120.0,
            panels: (0..count).map(panel).collect(),
        }
    }

    #[test]
    fn equal_legends_are_drawn_once_and_different_ones_each() {
        let shared = panels(3, |_| ["one".into(), "other".into()]).svg();
        assert_eq!(shared.matches(">one</text>").count(), 1);
        let own = panels(3, |index| [format!("line {index}"), "other".into()]).svg();
        assert_eq!(own.matches(">other</text>").count(), 3);
    }

    #[test]
    fn tick_labels_leave_room_for_each_other_in_a_narrow_panel() {
        let svg = panels(1, |_| ["one".into(), "other".into()]).svg();
        // 200 apart are 47 units on the canvas: "800" and "1000" fit; a hundred apart would not.
        assert!(svg.contains(">1000</text>") && svg.contains(">800</text>"), "{svg}");
        let mut fine = panels(1, |_| ["one".into(), "other".into()]);
        fine.columns = 4;
        assert!(!fine.svg().contains(">800</text>"));
    }
}
