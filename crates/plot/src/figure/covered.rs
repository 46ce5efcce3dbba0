//! Outlines below areas that are painted over them: what is covered takes a short course.

use super::path::{Point, distance, simplify, simplify_where};

/// Outlines of areas that are painted later, none of them with a hole.
pub(crate) struct Covers(Vec<Vec<Point>>);

/// How far a point may lie outside of an area that covers it, in canvas units.
const MARGIN: f64 = 0.25;

/// Distance between the points of a line at which it is looked whether an area covers it, in canvas units.
const STEP: f64 = 0.5;

impl Covers {
    /// Areas by their outlines on the canvas.
    pub fn new(areas: Vec<Vec<Point>>) -> Self {
        Self(areas)
    }

    /// A closed outline without the vertices that lie within `tolerance` of it, and without covered ones where a
    /// straight line past them is covered too. Its last point is its first.
    pub fn simplify(&self, outline: &[Point], tolerance: f64) -> Vec<Point> {
        let covers: Vec<Option<usize>> =
            (0..outline.len()).map(|at| self.cover(outline[at], outline[(at + 1) % outline.len()])).collect();
        // A run that goes on from the last point to the first would be cut there.
        let start =
            (0..outline.len()).find(|&at| covers[at] != covers[(at + outline.len() - 1) % outline.len()]);
        let start = start.unwrap_or(0);
        let around = |at: usize| (start + at) % outline.len();
        let mut kept: Vec<Point> = Vec::new();
        let mut from = 0;
        while from < outline.len() {
            let cover = covers[around(from)];
            let run = (from..outline.len()).take_while(|&at| covers[around(at)] == cover).count();
            let points: Vec<Point> = (from..=from + run).map(|at| outline[around(at)]).collect();
            kept.pop();
            kept.extend(match cover {
                None => simplify(&points, tolerance),
                Some(area) => simplify_where(&points, |one, other, _| self.covers(area, one, other)),
            });
            from += run;
        }
        kept
    }

    /// The area that covers a straight line.
    fn cover(&self, from: Point, to: Point) -> Option<usize> {
        (0..self.0.len()).find(|&area| self.covers(area, from, to))
    }

    fn covers(&self, area: usize, from: Point, to: Point) -> bool {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let count = libm::ceil(libm::hypot(dx, dy) / STEP).max(1.0) as usize;
        (0..=count)
            .map(|index| index as f64 / count as f64)
            .all(|t| is_within(&self.0[area], (from.0 + t * dx, from.1 + t * dy)))
    }
}

/// Whether a point lies in an area or within the margin of its outline.
fn is_within(area: &[Point], point: Point) -> bool {
    let edges = || area.iter().zip(area.iter().cycle().skip(1));
    let crossed = edges().filter(|(from, to)| {
        (from.1 > point.1) != (to.1 > point.1)
            && point.0 < from.0 + (point.1 - from.1) / (to.1 - from.1) * (to.0 - from.0)
    });
    crossed.count() % 2 == 1
        || edges().any(|(&from, &to)| distance::<2>(&point.into(), &from.into(), &to.into()) <= MARGIN)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Point; 3] = [(0.0, 0.0), (40.0, 0.0), (0.0, 40.0)];

    /// The area beyond the slanted side of the triangle in a square of side 40, with a stair of steps of 2 below the side.
    fn stair() -> Vec<Point> {
        let steps = (0..20).flat_map(|i| [(2 * i, 38 - 2 * i), (2 * i + 2, 38 - 2 * i)]).take(39);
        let stair = steps.map(|(x, y)| (f64::from(x), f64::from(y)));
        [(40.0, 0.0), (40.0, 40.0), (0.0, 40.0)].into_iter().chain(stair).collect()
    }

    #[test]
    fn a_covered_stair_becomes_a_straight_line() {
        let short = Covers::new(vec![TRIANGLE.to_vec()]).simplify(&stair(), 0.4);
        assert!(short.len() <= 6, "{short:?}");
        assert!(
            TRIANGLE[1..].iter().chain(&[(40.0, 40.0)]).all(|corner| short.contains(corner)),
            "{short:?}"
        );
    }

    #[test]
    fn without_a_cover_or_beyond_one_an_outline_keeps_its_course() {
        let far = TRIANGLE.iter().map(|&(x, y)| (x - 100.0, y)).collect();
        for covers in [Covers::new(Vec::new()), Covers::new(vec![far])] {
            let kept = covers.simplify(&stair(), 0.4);
            assert_eq!(kept, [stair(), vec![stair()[0]]].concat());
        }
    }

    #[test]
    fn no_short_course_leaves_the_area_that_covers_it() {
        // Two arms with a gap between them: a stair from one arm to the other goes around the gap.
        let arms = [
            (0.0, 0.0),
            (10.0, 0.0),
            (10.0, 30.0),
            (20.0, 30.0),
            (20.0, 0.0),
            (30.0, 0.0),
            (30.0, 40.0),
            (0.0, 40.0),
        ];
        let around = [
            (5.0, 0.0),
            (5.0, 20.0),
            (6.0, 35.0),
            (24.0, 35.0),
            (25.0, 20.0),
            (25.0, 0.0),
            (25.0, -9.0),
            (5.0, -9.0),
        ];
        let short = Covers::new(vec![arms.to_vec()]).simplify(&around, 0.1);
        let below = |y: f64| {
            short.windows(2).all(|pair| {
                (pair[0].0 - 15.0) * (pair[1].0 - 15.0) > 0.0
                    || pair[0].1.min(pair[1].1) > y
                    || pair[0].1.max(pair[1].1) < 0.0
            })
        };
        assert!(short.len() < around.len() && below(29.0), "{short:?}");
    }

    #[test]
    fn an_outline_that_is_covered_whole_vanishes() {
        let inside = [(1.0, 1.0), (9.0, 1.0), (1.0, 9.0)];
        let kept = Covers::new(vec![TRIANGLE.to_vec()]).simplify(&inside, 0.1);
        assert!(kept.iter().all(|&point| point == inside[0]), "{kept:?}");
    }
}
