//! Filled contours: outlines of the area where a grid of values lies above a level (marching squares).

use std::collections::BTreeMap;

use super::path::Point;

/// For each pattern of corners inside (1 lower left, 2 lower right, 4 upper right, 8 upper left), the segments that
/// cross the cell from edge to edge (0 lower, 1 right, 2 upper, 3 left) with the inside on their left.
/// Two opposite corners are never joined through the cell.
const SEGMENTS: [&[(usize, usize)]; 16] = [
    &[],
    &[(0, 3)],
    &[(1, 0)],
    &[(1, 3)],
    &[(2, 1)],
    &[(0, 3), (2, 1)],
    &[(2, 0)],
    &[(2, 3)],
    &[(3, 2)],
    &[(0, 2)],
    &[(1, 0), (3, 2)],
    &[(1, 2)],
    &[(3, 1)],
    &[(0, 1)],
    &[(3, 0)],
    &[],
];

/// A grid with a ring of outside points around it, so that every outline closes along the frame.
struct Grid<'a> {
    values: &'a [f64],
    columns: usize,
    rows: usize,
    inside: &'a dyn Fn(f64) -> bool,
    crossing: &'a dyn Fn(f64, f64) -> f64,
}

/// Closed outlines of the area that is inside, in coordinates from 0 to 1 over the grid.
///
/// `values` are rows of `columns` points each, at least two of both. `crossing(outside, inside)` says where between an
/// outside and an inside value the edge lies: 0 at the outside point, 1 at the inside point.
pub(crate) fn outlines(
    values: &[f64],
    columns: usize,
    inside: &dyn Fn(f64) -> bool,
    crossing: &dyn Fn(f64, f64) -> f64,
) -> Vec<Vec<Point>> {
    if columns < 2 || values.len() < 2 * columns {
        return Vec::new();
    }
    let grid = Grid { values, columns, rows: values.len() / columns, inside, crossing };
    let mut next = grid.links();
    let mut loops = Vec::new();
    while let Some((mut edge, mut to)) = next.pop_first() {
        let mut outline = vec![grid.point(edge)];
        while let Some(after) = next.remove(&to) {
            (edge, to) = (to, after);
            outline.push(grid.point(edge));
        }
        loops.push(outline);
    }
    loops
}

/// The areas that the outlines of all classes leave free, where the four corners of a cell have three classes or more, or two
/// crosswise: each with the class that the most of the corners have.
pub(super) fn areas_between(classes: &[usize], columns: usize) -> Vec<(usize, Vec<Point>)> {
    if columns < 2 {
        return Vec::new();
    }
    let rows = classes.len() / columns;
    let cells = (0..rows.saturating_sub(1)).flat_map(|row| (0..columns - 1).map(move |column| (column, row)));
    let (wide, high) = ((columns - 1) as f64, rows.saturating_sub(1) as f64);
    let area = |(column, row): (usize, usize)| {
        let places = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, up)| (column + right, row + up));
        let found = places.map(|(column, row)| classes[row * columns + column]);
        let middle = |at: usize| {
            let ((x, y), (next_x, next_y)) = (places[at], places[(at + 1) % 4]);
            ((x + next_x) as f64 / 2.0 / wide, (y + next_y) as f64 / 2.0 / high)
        };
        let outline: Vec<Point> = (0..4).filter(|&at| found[at] != found[(at + 1) % 4]).map(middle).collect();
        let votes = |class: usize| found.iter().filter(|&&other| other == class).count();
        // The first of those with as many votes.
        let most = found.into_iter().rev().max_by_key(|&class| votes(class));
        most.filter(|_| outline.len() > 2).map(|class| (class, outline))
    };
    cells.filter_map(area).collect()
}

impl Grid<'_> {
    /// Points in a row, the ring included.
    fn width(&self) -> usize {
        self.columns + 2
    }

    fn value(&self, column: usize, row: usize) -> Option<f64> {
        let ring = column == 0 || row == 0 || column > self.columns || row > self.rows;
        if ring { None } else { Some(self.values[(row - 1) * self.columns + column - 1]) }
    }

    fn is_inside(&self, column: usize, row: usize) -> bool {
        self.value(column, row).is_some_and(self.inside)
    }

    /// For each grid edge where an outline enters a cell, the edge where it leaves it.
    fn links(&self) -> BTreeMap<usize, usize> {
        let mut next = BTreeMap::new();
        let mut lower = self.inside_of_row(0);
        for row in 0..=self.rows {
            let upper = self.inside_of_row(row + 1);
            for (column, (low, high)) in lower.windows(2).zip(upper.windows(2)).enumerate() {
                let corners = [low[0], low[1], high[1], high[0]];
                let bits = corners.iter().enumerate();
                let pattern = bits.map(|(bit, &is_inside)| usize::from(is_inside) << bit).sum::<usize>();
                for &(from, to) in SEGMENTS[pattern] {
                    let edges = self.edges(column, row);
                    next.insert(edges[from], edges[to]);
                }
            }
            lower = upper;
        }
        next
    }

    /// Which points of a row are inside, the ring included.
    fn inside_of_row(&self, row: usize) -> Vec<bool> {
        (0..self.width()).map(|column| self.is_inside(column, row)).collect()
    }

    /// Numbers of a cell's lower, right, upper and left edge: even ones lie, odd ones stand.
    fn edges(&self, column: usize, row: usize) -> [usize; 4] {
        let at = 2 * (row * self.width() + column);
        [at, at + 3, at + 2 * self.width(), at + 1]
    }

    /// Where the outline crosses a grid edge.
    fn point(&self, edge: usize) -> Point {
        let (column, row) = (edge / 2 % self.width(), edge / 2 / self.width());
        let other = if edge.is_multiple_of(2) { (column + 1, row) } else { (column, row + 1) };
        let (from, to) = (self.place(column, row), self.place(other.0, other.1));
        let first_inside = self.is_inside(column, row);
        let at = match (self.value(column, row), self.value(other.0, other.1)) {
            (Some(one), Some(two)) if first_inside => 1.0 - (self.crossing)(two, one).clamp(0.0, 1.0),
            (Some(one), Some(two)) => (self.crossing)(one, two).clamp(0.0, 1.0),
            _ => 0.0,
        };
        (from.0 + at * (to.0 - from.0), from.1 + at * (to.1 - from.1))
    }

    /// Coordinates of a point; those of the ring lie on the frame.
    fn place(&self, column: usize, row: usize) -> Point {
        let along = |index: usize, count: usize| (index.clamp(1, count) - 1) as f64 / (count - 1) as f64;
        (along(column, self.columns), along(row, self.rows))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(outline: &[Point]) -> f64 {
        let pairs = outline.iter().zip(outline.iter().cycle().skip(1));
        pairs.map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>() / 2.0
    }

    fn half(_: f64, _: f64) -> f64 {
        0.5
    }

    #[test]
    fn everything_inside_gives_the_whole_frame_counterclockwise() {
        let loops = outlines(&[1.0; 12], 4, &|v| v > 0.0, &half);
        assert_eq!(loops.len(), 1);
        assert!((area(&loops[0]) - 1.0).abs() < 1e-15);
        assert!(outlines(&[0.0; 12], 4, &|v| v > 0.0, &half).is_empty());
    }

    #[test]
    fn a_hole_runs_the_other_way() {
        let mut values = [1.0; 25];
        values[12] = 0.0;
        let loops = outlines(&values, 5, &|v| v > 0.0, &half);
        let areas: Vec<f64> = loops.iter().map(|l| area(l)).collect();
        assert_eq!(areas.len(), 2);
        assert!(areas.iter().any(|a| *a < 0.0) && areas.iter().any(|a| *a > 0.9), "{areas:?}");
    }

    #[test]
    fn a_plane_is_cut_where_the_level_lies() {
        let values: Vec<f64> = (0..25).map(|i| f64::from(i % 5) / 4.0).collect();
        let level = 0.4;
        let crossing = |low: f64, high: f64| (level - low) / (high - low);
        let loops = outlines(&values, 5, &|v| v >= level, &crossing);
        assert!((area(&loops[0]) - 0.6).abs() < 1e-15);
    }

    #[test]
    fn a_value_that_is_no_number_is_outside() {
        let loops = outlines(&[f64::NAN, 1.0, 1.0, 1.0, 1.0, 1.0], 3, &|v| v > 0.0, &half);
        assert!((area(&loops[0]) - 0.9375).abs() < 1e-15, "{}", area(&loops[0]));
    }
}
