//! Paths: lines cut at the edges of a box, needless vertices removed.

/// A point on the canvas, in its units.
pub(crate) type Point = (f64, f64);

/// An upright box on the canvas.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

/// The parts of a line inside the bounds (Liang and Barsky), each with at least two points; `None` interrupts the line.
pub(crate) fn clip_line(points: &[Option<Point>], bounds: Bounds) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let (Some(from), Some(to)) = (pair[0], pair[1]) else { continue };
        let Some((start, end)) = clip_segment(from, to, bounds) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&start) => part.push(end),
            _ => parts.push(vec![start, end]),
        }
    }
    parts
}

fn clip_segment(from: Point, to: Point, bounds: Bounds) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (step, room) in [
        (-dx, from.0 - bounds.left),
        (dx, bounds.right - from.0),
        (-dy, from.1 - bounds.top),
        (dy, bounds.bottom - from.1),
    ] {
        if step == 0.0 && room < 0.0 {
            return None;
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else if step > 0.0 {
            leave = leave.min(room / step);
        }
    }
    let at = |t: f64| (from.0 + t * dx, from.1 + t * dy);
    let start = if enter > 0.0 { at(enter) } else { from };
    let end = if leave < 1.0 { at(leave) } else { to };
    (enter <= leave).then_some((start, end))
}

/// The part of a polygon inside the bounds (Sutherland and Hodgman).
pub(crate) fn clip_polygon(points: &[Point], bounds: Bounds) -> Vec<Point> {
    let rooms: [fn(Point, Bounds) -> f64; 4] =
        [|p, b| p.0 - b.left, |p, b| b.right - p.0, |p, b| p.1 - b.top, |p, b| b.bottom - p.1];
    let mut polygon = points.to_vec();
    for room in rooms {
        let mut kept = Vec::with_capacity(polygon.len() + 4);
        for (index, &to) in polygon.iter().enumerate() {
            let from = polygon[(index + polygon.len() - 1) % polygon.len()];
            let (before, after) = (room(from, bounds), room(to, bounds));
            if (before < 0.0) != (after < 0.0) {
                let t = before / (before - after);
                kept.push((from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1)));
            }
            if after >= 0.0 {
                kept.push(to);
            }
        }
        polygon = kept;
    }
    polygon
}

/// The line without the vertices that lie within `tolerance` of it (Douglas and Peucker).
pub(crate) fn simplify(points: &[Point], tolerance: f64) -> Vec<Point> {
    simplify_where(points, |_, _, farthest| farthest <= tolerance)
}

/// The line with the vertices between two others left out where `straight` accepts these two and the distance of the
/// farthest vertex between them.
pub(crate) fn simplify_where(points: &[Point], straight: impl Fn(Point, Point, f64) -> bool) -> Vec<Point> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((first, last)) = open.pop() {
        let (from, to) = (points[first], points[last]);
        let far = (first + 1..last).map(|index| (distance(points[index], from, to), index)).fold(
            None,
            |best: Option<(f64, usize)>, far| {
                if best.is_none_or(|best| far.0 > best.0) { Some(far) } else { best }
            },
        );
        if let Some((farthest, index)) = far
            && !straight(from, to, farthest)
        {
            keep[index] = true;
            open.extend([(first, index), (index, last)]);
        }
    }
    points.iter().zip(&keep).filter(|(_, kept)| **kept).map(|(&point, _)| point).collect()
}

/// Distance of a point from the segment between two others.
pub(crate) fn distance(point: Point, from: Point, to: Point) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / length } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    let (ex, ey) = (point.0 - from.0 - along * dx, point.1 - from.1 - along * dy);
    (ex * ex + ey * ey).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Bounds = Bounds { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };

    #[test]
    fn a_line_is_cut_where_it_leaves_and_enters() {
        let line =
            [Some((-5.0, 5.0)), Some((5.0, 5.0)), Some((5.0, 20.0)), Some((8.0, 20.0)), Some((8.0, 5.0))];
        let parts = clip_line(&line, BOX);
        assert_eq!(parts, [vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)], vec![(8.0, 10.0), (8.0, 5.0)]]);
        let gap = [Some((1.0, 1.0)), None, Some((2.0, 2.0)), Some((3.0, 3.0))];
        assert_eq!(clip_line(&gap, BOX), [vec![(2.0, 2.0), (3.0, 3.0)]]);
    }

    #[test]
    fn a_polygon_that_covers_the_box_becomes_the_box() {
        let around = [(-5.0, -5.0), (15.0, -5.0), (15.0, 15.0), (-5.0, 15.0)];
        let mut cut = clip_polygon(&around, BOX);
        cut.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(cut, [(0.0, 0.0), (0.0, 10.0), (10.0, 0.0), (10.0, 10.0)]);
        assert!(clip_polygon(&[(20.0, 0.0), (30.0, 0.0), (25.0, 5.0)], BOX).is_empty());
    }

    #[test]
    fn simplification_stays_within_its_tolerance() {
        let circle: Vec<Point> = (0..=400)
            .map(|i| {
                let angle = f64::from(i) * std::f64::consts::TAU / 400.0;
                (100.0 * libm::cos(angle), 100.0 * libm::sin(angle))
            })
            .collect();
        let few = simplify(&circle, 0.1);
        assert!(few.len() < 130, "{}", few.len());
        for &point in &circle {
            let nearest = few.windows(2).map(|p| distance(point, p[0], p[1])).fold(f64::INFINITY, f64::min);
            assert!(nearest <= 0.1);
        }
    }
}
