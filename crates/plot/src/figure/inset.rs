//! A small map in the corner of a line chart: where the chart's lines lie.

use super::frame::Frame;
use super::line_chart::{LineStyle, draw_lines};
use super::overlay::draw_named_lines;
use super::path::Point;
use super::svg::Svg;
use super::{Axis, Line, Series, palette};

/// A small map.
#[derive(Debug, Clone, PartialEq)]
pub struct Inset {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines of the map.
    pub lines: Vec<Line>,
    /// The places of the chart's series: they look as in the chart when both list them in the same order.
    pub series: Vec<Series>,
}

/// Width and height of the map.
const SIZE: Point = (196.0, 140.0);
/// Room right of the map, and below it for its labels.
const MARGIN: Point = (16.0, 56.0);
/// Room left of the map for its labels, and above it.
const LABELS: Point = (66.0, 10.0);

impl Inset {
    /// Draws the map with its lower right corner at this place.
    pub(crate) fn draw(&self, svg: &mut Svg, (right, bottom): Point) {
        let corner = (right - MARGIN.0 - SIZE.0, bottom - MARGIN.1 - SIZE.1);
        let frame = Frame::new(&self.x, &self.y, corner, SIZE);
        let ground = (corner.0 - LABELS.0, corner.1 - LABELS.1);
        svg.rect(
            ground,
            (right - ground.0 - 1.0, bottom - ground.1 - 1.0),
            &[("class", "panel"), ("fill", palette::PLATE)],
        );
        frame.draw_panel(svg, "panel-map");
        draw_named_lines(svg, &frame, &self.lines, "inset-");
        draw_lines(svg, &frame, &[], &self.series, LineStyle { tolerance: 0.2, markers: false });
        frame.draw_axes(svg);
    }
}
