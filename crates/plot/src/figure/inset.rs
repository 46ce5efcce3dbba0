//! Small maps in line charts, where they cover none of the lines.

use super::frame::Frame;
use super::lines::{LineStyle, draw_lines};
use super::overlay::draw_named_lines;
use super::path::{Bounds, Point, clip_line};
use super::svg::Svg;
use super::{Axis, Line, Series, palette};

/// A small map in a corner of a line chart: where the chart's lines lie.
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

/// Widths and heights of the map, the preferred one first.
const INSET_SIZES: [Point; 3] = [(196.0, 140.0), (168.0, 120.0), (140.0, 100.0)];
/// Room around the map and its labels in which no line of the chart lies.
const CLEARANCE: f64 = 4.0;
/// Room right of the map, and below it for its labels.
const MARGIN: Point = (16.0, 56.0);
/// Room left of the map for its labels, and above it.
const LABELS: Point = (66.0, 10.0);

impl Inset {
    /// The size of the map and its plate in a chart: the corner, or the smaller map, where it covers least of the lines.
    pub(super) fn place(&self, chart: Bounds, lines: &[Vec<Point>]) -> (Point, Bounds) {
        let places = INSET_SIZES.iter().flat_map(|&size| {
            let (width, height) = (size.0 + MARGIN.0 + LABELS.0 - 1.0, size.1 + MARGIN.1 + LABELS.1 - 1.0);
            let (left, right) = (chart.left + 1.0, chart.right - 1.0 - width);
            let (top, bottom) = (chart.top + 1.0, chart.bottom - 1.0 - height);
            let corners = [(right, bottom), (left, top), (left, bottom), (right, top)];
            corners.map(|corner| (size, Bounds::new(corner, (width, height))))
        });
        let covered = |plate: &Bounds| {
            let (width, height) = plate.size();
            let corner = (plate.left - CLEARANCE, plate.top - CLEARANCE);
            let around = Bounds::new(corner, (width + 2.0 * CLEARANCE, height + 2.0 * CLEARANCE));
            let placed = lines.iter().map(|line| line.iter().copied().map(Some).collect::<Vec<_>>());
            let parts = placed.flat_map(|line| clip_line(&line, around)).collect::<Vec<_>>();
            let steps = parts.iter().flat_map(|part| part.windows(2));
            steps.map(|step| libm::hypot(step[1].0 - step[0].0, step[1].1 - step[0].1)).sum::<f64>()
        };
        let places = places.map(|place| (covered(&place.1), place));
        let least = places.reduce(|best, other| if other.0 < best.0 { other } else { best });
        least.map_or((INSET_SIZES[0], chart), |(_, place)| place)
    }

    /// Draws the map on its plate.
    pub(super) fn draw(&self, svg: &mut Svg, (size, plate): (Point, Bounds)) {
        let ground = (plate.left, plate.top);
        let frame = Frame::new(&self.x, &self.y, (ground.0 + LABELS.0, ground.1 + LABELS.1), size);
        svg.rect(ground, plate.size(), &[("class", "panel"), ("fill", palette::PLATE)]);
        frame.draw_panel(svg, "panel-map");
        draw_named_lines(svg, &frame, &self.lines, "inset-");
        draw_lines(svg, &frame, &[], &self.series, LineStyle { tolerance: 0.2, markers: false });
        frame.draw_axes(svg);
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::{frequency_chart, inset};
    use super::*;

    const CHART: Bounds = Bounds { left: 80.0, top: 14.0, right: 624.0, bottom: 374.0 };

    /// The plate for lines with this one point, which is as long as a pixel.
    fn plate(points: &[Point]) -> (Point, Bounds) {
        inset().place(CHART, &points.iter().map(|&(x, y)| vec![(x, y), (x + 1.0, y)]).collect::<Vec<_>>())
    }

    #[test]
    fn the_map_is_where_no_line_is() {
        let corners = [(600.0, 360.0), (90.0, 30.0), (90.0, 360.0), (600.0, 30.0)];
        for taken in 0..4 {
            let (size, plate) = plate(&corners[..taken]);
            let (x, y) = corners[taken];
            assert_eq!(size, INSET_SIZES[0]);
            assert!(
                (plate.left..plate.right).contains(&x) && (plate.top..plate.bottom).contains(&y),
                "{taken}"
            );
        }
        // At the corner of every large plate, and not of smaller ones.
        let inner = [(350.0, 170.0), (355.0, 218.0), (355.0, 170.0), (350.0, 218.0)];
        assert!(plate(&inner).0 < INSET_SIZES[0]);
    }

    #[test]
    fn a_line_through_the_lower_right_corner_stays_visible() {
        let mut chart = frequency_chart();
        let across = vec![(1e-6, 1e-2), (1e-1, 1e2)];
        chart.series = vec![Series::line("across", across)];
        chart.references.clear();
        let svg = chart.svg_with(Some(&inset()));
        // The frame of the map, in the upper left corner.
        assert!(svg.contains("<rect x=\"147\" y=\"25\" width=\"196\""), "{svg:.4000}");
    }
}
