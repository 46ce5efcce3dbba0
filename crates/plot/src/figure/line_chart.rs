//! Line charts: several series over linear, logarithmic or signed logarithmic axes.

use super::frame::{CANVAS_WIDTH, Frame};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::lines::{LineStyle, draw_lines, place_reference, series_entries};
use super::path::Point;
use super::svg::Svg;
use super::{Axis, Caption, Inset, Reference, Series};

/// A chart of lines.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LineChart {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines from the lowest to the topmost.
    pub series: Vec<Series>,
    /// Reference lines and shaded strips.
    pub references: Vec<Reference>,
}

/// Upper left corner of the chart on the canvas.
const CORNER: Point = (80.0, 14.0);
/// Width and height of the chart.
const SIZE: Point = (544.0, 360.0);
/// How far a drawn line may lie from the given one, in canvas units.
const LINE_TOLERANCE: f64 = 0.15;

impl LineChart {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg_with(None)
    }

    /// The chart as SVG text, with a small map where it covers no line, or least of them.
    #[must_use]
    pub fn svg_with(&self, inset: Option<&Inset>) -> String {
        let frame = Frame::new(&self.x, &self.y, CORNER, SIZE);
        let legend = Legend::new(self.legend_entries(), CANVAS_WIDTH - CORNER.0);
        let below = frame.bounds.bottom + 60.0;
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, below + legend.height());
        frame.draw_panel(&mut svg, "panel");
        for (index, (edges, _)) in self.bands().enumerate() {
            draw_band(&mut svg, &frame, index, edges);
        }
        frame.draw_grid(&mut svg);
        let style = LineStyle { tolerance: LINE_TOLERANCE, markers: true };
        draw_lines(&mut svg, &frame, &self.references, &self.series, style);
        frame.draw_axes(&mut svg);
        if let Some(inset) = inset {
            inset.draw(&mut svg, inset.place(frame.bounds, &self.lines_on(&frame)));
        }
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    /// The visible parts of the series and of the reference lines on the canvas.
    fn lines_on(&self, frame: &Frame) -> Vec<Vec<Point>> {
        let series = self.series.iter().flat_map(|series| frame.visible_line(&series.points));
        let places = self.references.iter().filter_map(|reference| place_reference(frame, reference));
        series.chain(places.map(|place| place.ends.into())).collect()
    }

    /// The edges of the strips, and their legend entries.
    fn bands(&self) -> impl Iterator<Item = ([f64; 2], &String)> {
        self.references.iter().filter_map(|reference| match reference {
            Reference::Band { from, to, label } => Some(([*from, *to], label)),
            _ => None,
        })
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let key = |index| {
            move |svg: &mut Svg, (x, y): Point| {
                let (class, fill) = band_look(index);
                svg.rect((x + 3.0, y - 7.0), (KEY_WIDTH - 13.0, 14.0), &[("class", &class), ("fill", fill)]);
            }
        };
        let bands = self.bands().enumerate().map(|(index, (_, label))| Entry::new(label, key(index)));
        series_entries(&self.series).into_iter().chain(bands).collect()
    }
}

fn band_look(index: usize) -> (String, &'static str) {
    const FILLS: [&str; 3] = ["#edf3f9", "#d9e7f3", "#c0d8ec"];
    let look = index % FILLS.len();
    (format!("band band-{look}"), FILLS[look])
}

fn draw_band(svg: &mut Svg, frame: &Frame, index: usize, edges: [f64; 2]) {
    let [Some(one), Some(two)] = edges.map(|edge| frame.y.position(edge)) else { return };
    let (low, high) = (one.min(two).clamp(0.0, 1.0), one.max(two).clamp(0.0, 1.0));
    let (from, to) = (frame.place_unit((0.0, high)), frame.place_unit((1.0, low)));
    let (class, fill) = band_look(index);
    svg.rect(from, (to.0 - from.0, to.1 - from.1), &[("class", &class), ("fill", fill)]);
}
