//! Samples of a curve thinned to those that a drawing needs.

/// Which of the points to keep, so that the line through them leaves out none by more than `tolerance` (Douglas and Peucker).
///
/// Distances are Euclidean in N coordinates and no projection lengthens them, so one choice serves every pair of coordinates
/// that a figure may draw. The first and the last point are always kept.
#[must_use]
pub(crate) fn kept<const N: usize>(points: &[[f64; N]], tolerance: f64) -> Vec<bool> {
    let mut keep = vec![false; points.len()];
    let Some(last) = points.len().checked_sub(1) else { return keep };
    (keep[0], keep[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((first, last)) = open.pop() {
        let farthest = (first + 1..last)
            .map(|index| (distance(&points[index], &points[first], &points[last]), index))
            .fold(
                (tolerance, None),
                |best, (far, index)| if far > best.0 { (far, Some(index)) } else { best },
            );
        if let (_, Some(index)) = farthest {
            keep[index] = true;
            open.extend([(first, index), (index, last)]);
        }
    }
    keep
}

/// Distance of a point from the segment between two others.
fn distance<const N: usize>(point: &[f64; N], from: &[f64; N], to: &[f64; N]) -> f64 {
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

    #[test]
    fn every_point_left_out_lies_within_the_tolerance_of_the_line_kept() {
        let wave = |i: u32| {
            let t = f64::from(i) / 1000.0;
            [t, libm::sin(20.0 * t), libm::exp(-3.0 * t)]
        };
        let points: Vec<[f64; 3]> = (0..=1000).map(wave).collect();
        let keep = kept(&points, 1e-2);
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
        assert_eq!(kept(&line, 1e-9).iter().filter(|keep| **keep).count(), 2);
        assert!(kept::<2>(&[], 1.0).is_empty());
    }
}
