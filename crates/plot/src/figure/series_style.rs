//! How series differ: by colour, dash and marker together, so that any one of them is enough.

use super::palette;
use super::path::Point;
use super::svg::{Svg, number};

/// Colour, dash and marker of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Look {
    index: Option<usize>,
}

/// Markers along a line that has none of its own.
const SPREAD: usize = 6;

impl Look {
    /// The look of the series with this index.
    pub fn of(index: usize) -> Self {
        Self { index: Some(index % palette::SERIES.len()) }
    }

    /// The look of a formula.
    pub fn theory() -> Self {
        Self { index: None }
    }

    /// Opens a group whose `currentColor` is the series' colour.
    pub fn open(self, svg: &mut Svg) {
        let (class, colour) = match self.index {
            Some(index) => (format!("series s{index}"), palette::SERIES[index]),
            None => ("series theory".into(), palette::FAINT_INK),
        };
        svg.open("g", &[("class", &class), ("color", colour), ("fill", "none"), ("stroke", "currentColor")]);
    }

    /// Draws the line inside such a group.
    pub fn stroke(self, svg: &mut Svg, data: &str) {
        // A formula is a thin solid line: no dash of a series is taken for it.
        let (width, dash) = self.index.map_or(("1.3", ""), |index| ("2.2", palette::DASHES[index]));
        if !data.is_empty() {
            svg.leaf("path", &[("d", data), ("stroke-width", width), ("stroke-dasharray", dash)]);
        }
    }
}

/// Draws the markers of a look around points, inside the look's group; formulas have none.
pub(crate) fn draw_markers(svg: &mut Svg, look: Look, points: &[Point]) {
    let Some(index) = look.index.filter(|_| !points.is_empty()) else { return };
    svg.open("g", &[("class", "marker"), ("fill", palette::PLATE), ("stroke-width", "1.8")]);
    if index == 0 {
        points.iter().for_each(|&point| svg.circle(point, "3.9"));
    } else {
        let data: String = points.iter().map(|&point| outline(index, point)).collect();
        svg.leaf("path", &[("d", &data)]);
    }
    svg.close();
}

/// The outline of a marker that is no circle.
fn outline(index: usize, (x, y): Point) -> String {
    let (dx, dy, rest) = match index {
        1 => (-3.5, -3.5, "h7v7h-7z"),
        2 => (0.0, -4.8, "l4.6 8.2h-9.2z"),
        3 => (0.0, -5.0, "l5 5-5 5-5-5z"),
        4 => (0.0, 4.8, "l4.6-8.2h-9.2z"),
        _ => (-4.0, -4.0, "l8 8m-8 0l8-8"),
    };
    format!("M{} {}{rest}", number(x + dx), number(y + dy))
}

/// Places for a few markers along the visible line, even in length and shifted from series to series.
pub(crate) fn spread(parts: &[Vec<Point>], look: Look) -> Vec<Point> {
    let Some(index) = look.index else { return Vec::new() };
    let segments: Vec<(Point, Point)> =
        parts.iter().flat_map(|part| part.windows(2).map(|pair| (pair[0], pair[1]))).collect();
    let length = |(from, to): (Point, Point)| libm::hypot(to.0 - from.0, to.1 - from.1);
    let total: f64 = segments.iter().map(|&segment| length(segment)).sum();
    let shift = 0.3 + 0.4 * index as f64 / palette::SERIES.len() as f64;
    let mut wanted = (0..SPREAD).map(|i| total * (i as f64 + shift) / SPREAD as f64).peekable();
    let (mut points, mut walked) = (Vec::new(), 0.0);
    for segment in segments {
        let (from, to) = segment;
        let step = length(segment);
        while let Some(&target) = wanted.peek().filter(|&&target| target <= walked + step && step > 0.0) {
            let t = (target - walked) / step;
            points.push((from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1)));
            wanted.next();
        }
        walked += step;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markers_lie_on_the_line_at_even_distances() {
        let line = vec![vec![(0.0, 0.0), (30.0, 0.0), (30.0, 30.0)]];
        let points = spread(&line, Look::of(0));
        assert_eq!(points.len(), SPREAD);
        let along = |p: &Point| p.0 + p.1;
        assert!(points.windows(2).all(|p| (along(&p[1]) - along(&p[0]) - 10.0).abs() < 1e-12), "{points:?}");
        assert!(points.iter().all(|p| p.1 == 0.0 || p.0 == 30.0));
    }

    #[test]
    fn an_empty_line_has_no_markers() {
        assert!(spread(&[], Look::of(3)).is_empty());
        assert!(spread(&[vec![(1.0, 1.0), (1.0, 1.0)]], Look::of(3)).is_empty());
    }
}
