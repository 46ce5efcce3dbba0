//! Maps of a family of curves of which one member is shown at a time, moved by stored steps: a page chooses, a reader
//! without scripts sees the base member.

use super::frame::{CANVAS_WIDTH, Frame};
use super::legend::Legend;
use super::overlay::{draw_marks, draw_whole_lines, legend_entries};
use super::path::Point;
use super::svg::{Svg, number};
use super::{Axis, Caption, Line, PointMark};

/// A family of curves over two logarithmic axes.
#[derive(Debug, Clone, PartialEq)]
pub struct FamilyMap {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The lines of each member.
    pub members: Vec<Vec<Line>>,
    /// The member that is shown at first.
    pub base: usize,
    /// Ways to move all members: of each, the steps in decades along the two axes. The map starts with no step.
    pub moves: Vec<Vec<(f64, f64)>>,
    /// Decades beyond the axes up to which lines are kept, so that they come into view when they are moved.
    pub margin: i32,
    /// Marked points, which do not move.
    pub marks: Vec<PointMark>,
}

/// Upper left corner of the map on the canvas.
const CORNER: Point = (80.0, 14.0);
/// Width and height of the map.
const SIZE: Point = (544.0, 440.0);

impl FamilyMap {
    /// The map as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let frame = Frame::new(&self.x, &self.y, CORNER, SIZE);
        let shown = self.members.get(self.base).map_or(&[][..], Vec::as_slice);
        let legend = Legend::new(legend_entries(shown), CANVAS_WIDTH - CORNER.0);
        let below = frame.bounds.bottom + 60.0;
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, below + legend.height());
        frame.draw_panel(&mut svg, "panel-map");
        frame.open_window(&mut svg, "window");
        self.draw_members(&mut svg, &frame);
        svg.close();
        draw_marks(&mut svg, &frame, &self.marks);
        frame.draw_axes(&mut svg);
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    /// All members inside one group for each way to move them.
    fn draw_members(&self, svg: &mut Svg, frame: &Frame) {
        let (x, y) = (wider(&self.x, self.margin), wider(&self.y, self.margin));
        let unit = (decade(&self.x) * SIZE.0, decade(&self.y) * SIZE.1);
        let room = (f64::from(self.margin) * unit.0, f64::from(self.margin) * unit.1);
        let corner = (frame.bounds.left - room.0, frame.bounds.top - room.1);
        let wide = Frame::new(&x, &y, corner, (SIZE.0 + 2.0 * room.0, SIZE.1 + 2.0 * room.1));
        for steps in &self.moves {
            // Up on the axis is down on the canvas.
            let place = |&(dx, dy): &(f64, f64)| {
                format!("translate({} {})", number(dx * unit.0), number(-dy * unit.1))
            };
            let steps = steps.iter().map(place).collect::<Vec<_>>().join("|");
            svg.open("g", &[("class", "moved"), ("data-steps", &steps)]);
        }
        for (index, lines) in self.members.iter().enumerate() {
            let display = if index == self.base { "" } else { "none" };
            svg.open("g", &[("class", "member"), ("display", display)]);
            draw_whole_lines(svg, &wide, lines, &format!("{index}-"));
            svg.close();
        }
        self.moves.iter().for_each(|_| svg.close());
    }
}

/// A logarithmic axis with some decades more on either side.
fn wider(axis: &Axis, decades: i32) -> Axis {
    let factor = libm::exp10(f64::from(decades));
    Axis { min: axis.min / factor, max: axis.max * factor, ..axis.clone() }
}

/// The share of an axis that a decade takes.
fn decade(axis: &Axis) -> f64 {
    1.0 / (libm::log10(axis.max) - libm::log10(axis.min))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::LineRole;

    fn map() -> FamilyMap {
        let line = |stress: f64| Line {
            label: "l".into(),
            role: LineRole::Boundary,
            points: vec![(1e-4, stress), (1e4, stress)],
        };
        FamilyMap {
            caption: Caption::new("f", "t", "d"),
            x: Axis::log10("V", "m/s", 1.0, 1e2),
            y: Axis::log10("S", "Pa", 1.0, 1e4),
            members: vec![vec![line(10.0)], vec![line(1e5)]],
            base: 0,
            moves: vec![vec![(0.0, 0.0), (1.0, -1.0)]],
            margin: 2,
            marks: Vec::new(),
        }
    }

    #[test]
    fn one_member_is_shown_and_the_others_are_there() {
        let svg = map().svg();
        assert_eq!(svg.matches("class=\"member\"").count(), 2);
        assert_eq!(svg.matches("display=\"none\"").count(), 1);
    }

    #[test]
    fn a_decade_is_a_step_and_lines_beyond_the_edge_are_kept() {
        let svg = map().svg();
        // 544 over two decades, 440 over four; the second line lies a decade above the window.
        assert!(svg.contains("data-steps=\"translate(0 0)|translate(272 110)\""), "{svg}");
        assert!(svg.contains("d=\"M-464-96h1632\""), "{svg}");
    }
}
