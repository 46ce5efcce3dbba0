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

impl Bounds {
    /// A box with its upper left corner, width and height.
    pub fn new((left, top): Point, (width, height): Point) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    /// Width and height.
    pub fn size(&self) -> Point {
        (self.right - self.left, self.bottom - self.top)
    }
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
    let places: Vec<[f64; 2]> = points.iter().map(|&point| point.into()).collect();
    let keep = kept(&places, |first, last, farthest| straight(points[first], points[last], farthest));
    points.iter().zip(keep).filter(|(_, kept)| *kept).map(|(&point, _)| point).collect()
}

/// Which points of a curve to keep: those between two others are left out where `straight` accepts the indices of these two and the
/// distance of the farthest point between them (Douglas and Peucker). The first and the last point are always kept.
///
/// Distances are Euclidean in N coordinates and no projection lengthens them, so one choice serves every pair of coordinates
/// that a figure may draw.
pub fn kept<const N: usize>(points: &[[f64; N]], straight: impl Fn(usize, usize, f64) -> bool) -> Vec<bool> {
    let mut keep = vec![false; points.len()];
    let Some(last) = points.len().checked_sub(1) else { return keep };
    (keep[0], keep[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((first, last)) = open.pop() {
        let far = (first + 1..last)
            .map(|index| (distance(&points[index], &points[first], &points[last]), index))
            .reduce(|best, far| if far.0 > best.0 { far } else { best });
        if let Some((farthest, index)) = far
            && !straight(first, last, farthest)
        {
            keep[index] = true;
            open.extend([(first, index), (index, last)]);
        }
    }
    keep
}

/// Distance of a point from the segment between two others.
pub(crate) fn distance<const N: usize>(point: &[f64; N], from: &[f64; N], to: &[f64; N]) -> f64 {
    let dot = |one: [f64; N], other: [f64; N]| (0..N).map(|i| one[i] * other[i]).sum::<f64>();
    let difference = |to: &[f64; N]| std::array::from_fn(|i| to[i] - from[i]);
    let (segment, way): ([f64; N], [f64; N]) = (difference(to), difference(point));
    let square = dot(segment, segment);
    let share = if square > 0.0 { (dot(way, segment) / square).clamp(0.0, 1.0) } else { 0.0 };
    let rest = std::array::from_fn(|i| way[i] - share * segment[i]);
    dot(rest, rest).sqrt()
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
            let nearest = few
                .windows(2)
                .map(|p| distance::<2>(&point.into(), &p[0].into(), &p[1].into()))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest <= 0.1);
        }
    }

    #[test]
    fn every_point_left_out_lies_within_the_tolerance_of_the_line_kept() {
        let wave = |i: u32| {
            let t = f64::from(i) / 1000.0;
            [t, libm::sin(20.0 * t), libm::exp(-3.0 * t)]
        };
        let points: Vec<[f64; 3]> = (0..=1000).map(wave).collect();
        let keep = kept(&points, |_, _, far| far <= 1e-2);
        let chosen: Vec<[f64; 3]> =
            points.iter().zip(&keep).filter(|(_, keep)| **keep).map(|(point, _)| *point).collect();
        assert!(chosen.len() < 100, "{}", chosen.len());
        for point in &points {
            let nearest = chosen
                .windows(2)
                .map(|pair| distance(point, &pair[0], &pair[1]))
                .fold(f64::INFINITY, f64::min);
            assert!(nearest <= 1e-2, "{nearest}");
        }
    }

    #[test]
    fn a_straight_line_keeps_its_ends_and_nothing_has_nothing_to_keep() {
        let line: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i), 2.0 * f64::from(i)]).collect();
        assert_eq!(kept(&line, |_, _, far| far <= 1e-9).iter().filter(|keep| **keep).count(), 2);
        assert!(kept::<2>(&[], |_, _, far| far <= 1.0).is_empty());
    }
}
