//! The two roots beside a real one, over a part of a box: the square of their imaginary part, also where they become real.
//!
//! The roots are h ± i√w. With F = Re f(h + i√w) and G = Im f(h + i√w)/√w, both polynomials in h and w, F = G = 0. Where the real root is
//! simple, h and w are smooth functions of the parameters, also at w = 0, where the root itself has no derivative. With
//! T = c2 + 3c3 h, which is c3 times the distance of h from the real root, dw = (T dF + c3 w dG)/(T² + c3² w).

use super::corners::{A, B, D, K, M, S, V};
use super::root_discs::{Values, cubic};
use crate::number::Interval;

/// The pair over a part.
pub(super) struct Pair {
    /// w: negative where the two roots are real.
    square: Interval,
    /// The derivatives of w by each parameter.
    slopes: [Interval; 7],
}

impl Pair {
    /// The pair of a part with its h and its −w, and the −w at a point of the part. None where a derivative has no bound.
    pub(super) fn of(
        values: &Values,
        [half_sum, negative_square]: [Interval; 2],
        at_point: Interval,
        point: &Values,
    ) -> Option<Self> {
        let square = -negative_square;
        let slopes = slopes(values, half_sum, square);
        let change = (0..7).map(|i| slopes[i] * (values[i] - point[i])).reduce(|sum, change| sum + change)?;
        let is_known = slopes.iter().all(|slope| slope.is_finite());
        is_known.then(|| Self { square: square.intersection(change - at_point), slopes })
    }

    /// The upper root's imaginary part, 0 where both roots are real.
    pub(super) fn height(&self) -> Interval {
        self.square.square_root()
    }

    /// The derivatives of w, which have the signs of those of the imaginary part.
    pub(super) const fn slopes(&self) -> [Interval; 7] {
        self.slopes
    }
}

fn slopes(values: &Values, h: Interval, w: Interval) -> [Interval; 7] {
    let [.., c2, c3] = cubic(values);
    let turned = c2 + c3 * h * 3.0;
    let scale = turned.square() + c3.square() * w;
    let (square, cube) = (h.square() - w, h * (h.square() - w * 3.0));
    coefficient_slopes(values).map(|[d0, d1, d2, d3]| {
        let real = d0 + d1 * h + d2 * square + d3 * cube;
        let imaginary = d1 + d2 * h * 2.0 + d3 * (h.square() * 3.0 - w);
        (turned * real + c3 * w * imaginary) / scale
    })
}

/// The derivatives of the four coefficients by each parameter.
pub(super) fn coefficient_slopes(values: &Values) -> [[Interval; 4]; 7] {
    let [a, b, d, k, m, s, v] = *values;
    let [zero, one] = [0.0, 1.0].map(Interval::point);
    let mut slopes = [[zero; 4]; 7];
    slopes[A] = [zero, s / d, s / v, zero];
    slopes[B] = [zero, -s / d, zero, zero];
    slopes[D] = [k * v, s * (a - b), m * v, zero].map(|value| -value / d.square());
    slopes[K] = [v / d, one, zero, zero];
    slopes[M] = [zero, zero, v / d, one];
    slopes[S] = [zero, (a - b) / d, a / v, zero];
    slopes[V] = [k / d, zero, m / d - s * a / v.square(), zero];
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// h and w of the two roots beside the lowest real one.
    fn beside_lowest(values: [f64; 7]) -> [f64; 2] {
        let [c0, c1, c2, c3] = cubic(&values.map(Interval::point)).map(Interval::middle);
        let newton = |z: f64| z - (((c3 * z + c2) * z + c1) * z + c0) / ((3.0 * c3 * z + 2.0 * c2) * z + c1);
        let lowest = (0..60).fold(-100.0, |z, _| newton(z));
        let half_sum = -0.5 * (c2 / c3 + lowest);
        [half_sum, -c0 / (c3 * lowest) - half_sum * half_sum]
    }

    #[test]
    fn derivatives_agree_with_differences_on_both_sides_of_a_double_root() {
        let mut signs = Vec::new();
        for b in [1.0, 2.6, 2.9, 3.4, 6.0] {
            let values = [1.0, b, 1.0, 0.25, 0.5, 1.0, 1.0];
            let [half_sum, square] = beside_lowest(values);
            signs.push(square > 0.0);
            let found =
                slopes(&values.map(Interval::point), Interval::point(half_sum), Interval::point(square));
            for (i, found) in found.iter().enumerate() {
                let step = 1e-5;
                let moved = |sign: f64| {
                    let mut moved = values;
                    moved[i] += sign * step;
                    beside_lowest(moved)[1]
                };
                let difference = (moved(1.0) - moved(-1.0)) / (2.0 * step);
                // The difference errs by the square of the step and by rounding over the step.
                assert!((found.middle() - difference).abs() < 1e-8 * difference.abs().max(1.0), "{b} {i}");
            }
        }
        assert!(signs.contains(&true) && signs.contains(&false));
    }
}
