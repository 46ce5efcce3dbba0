//! What a map says at its points, carried in the drawing for a page that reads it out.

use super::frame::Frame;
use super::svg::{Svg, number};

/// Words at the points of a coarse grid over a map; the same words stand in the map's tables and legend.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Readout {
    /// Horizontal coordinates with their unit, from left to right, even on the axis.
    pub columns: Vec<String>,
    /// Vertical coordinates with their unit, from the lowest, even on the axis.
    pub rows: Vec<String>,
    /// What is said at the points, row by row; parts that many points share are given by their place in `shared`.
    pub cells: Vec<(usize, String)>,
    /// Words that many points share.
    pub shared: Vec<String>,
}

impl Readout {
    /// Lays an invisible plane over the map that carries the words. None of them may hold a `|`.
    pub(crate) fn draw(&self, svg: &mut Svg, frame: &Frame) {
        let cells: Vec<String> = self.cells.iter().map(|(shared, own)| format!("{shared}~{own}")).collect();
        let corner = [number(frame.bounds.left), number(frame.bounds.top)];
        let size = [number(frame.size().0), number(frame.size().1)];
        svg.leaf(
            "rect",
            &[
                ("class", "readout"),
                ("x", &corner[0]),
                ("y", &corner[1]),
                ("width", &size[0]),
                ("height", &size[1]),
                ("fill", "#ffffff"),
                ("fill-opacity", "0"),
                ("data-columns", &self.columns.join("|")),
                ("data-rows", &self.rows.join("|")),
                ("data-shared", &self.shared.join("|")),
                ("data-cells", &cells.join("|")),
            ],
        );
    }
}
