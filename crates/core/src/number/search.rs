//! Zeros, borders and minima of functions that are dear to evaluate and may have no value.

/// A minimum of a smooth function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Minimum {
    /// Where.
    pub at: f64,
    /// Estimated error of the place.
    pub error: f64,
    /// The second derivative there.
    pub curvature: f64,
}

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// The zero between two places of different sign, to `width` (Illinois variant of the false position).
pub fn zero_between(
    function: impl Fn(f64) -> Option<f64>,
    [(low, at_low), (high, at_high)]: [(f64, f64); 2],
    width: f64,
) -> Option<f64> {
    let (mut a, mut fa, mut b, mut fb) = (low, at_low, high, at_high);
    // Halving alone would need fewer steps than this for any width above 1e-13 of the bracket.
    for _ in 0..60 {
        if fb == 0.0 || (b - a).abs() <= width {
            break;
        }
        let c = b - fb * (b - a) / (fb - fa);
        let fc = function(c)?;
        if (fc < 0.0) == (fb < 0.0) {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        let step = (c - b).abs();
        (b, fb) = (c, fc);
        if step <= 0.1 * width {
            break;
        }
    }
    Some(b)
}

/// The border between two places with different answers, to `width`: the last places with either answer.
pub fn border_between(
    holds: impl Fn(f64) -> Option<bool>,
    (mut without, mut with): (f64, f64),
    width: f64,
) -> Option<(f64, f64)> {
    while (with - without).abs() > width {
        let middle = 0.5 * (with + without);
        if holds(middle)? {
            with = middle;
        } else {
            without = middle;
        }
    }
    Some((without, with))
}

/// The minimum between two ends: golden section down to `step`, then zeros of the derivative on five points.
///
/// The error is what the three inner points alone would change, which bounds the truncation of the five, and what the
/// `noise` of the values can move. Nothing where the function has no value or is not convex.
pub fn minimum_between(
    function: impl Fn(f64) -> Option<f64>,
    (low, high): (f64, f64),
    step: f64,
    noise: f64,
) -> Option<Minimum> {
    let mut centre = golden_section(&function, (low, high), 2.0 * step)?;
    for _ in 0..6 {
        let mut f = [0.0; 5];
        for (value, place) in f.iter_mut().zip([-2.0f64, -1.0, 0.0, 1.0, 2.0]) {
            *value = function(place.mul_add(step, centre))?;
        }
        let slope = (f[0] - 8.0 * f[1] + 8.0 * f[3] - f[4]) / (12.0 * step);
        let curvature = (-f[0] + 16.0 * f[1] - 30.0 * f[2] + 16.0 * f[3] - f[4]) / (12.0 * step * step);
        let plain_slope = (f[3] - f[1]) / (2.0 * step);
        let plain_curvature = (f[3] - 2.0 * f[2] + f[1]) / (step * step);
        if curvature <= 0.0 || plain_curvature <= 0.0 {
            return None;
        }
        let shift = -slope / curvature;
        if shift.abs() <= 0.05 * step {
            let truncation = (plain_slope / plain_curvature - slope / curvature).abs();
            let error = truncation + 2.0 * noise / (step * curvature);
            return Some(Minimum { at: centre + shift, error, curvature });
        }
        centre += shift.clamp(-2.0 * step, 2.0 * step);
    }
    None
}

/// The minimiser of a function with one minimum between two ends, to `width`: a place at which the function was evaluated.
pub fn golden_section(
    function: impl Fn(f64) -> Option<f64>,
    (mut low, mut high): (f64, f64),
    width: f64,
) -> Option<f64> {
    let mut left = high - GOLDEN * (high - low);
    let mut right = low + GOLDEN * (high - low);
    let (mut at_left, mut at_right) = (function(left)?, function(right)?);
    // Ends that are next to each other have nothing between them.
    while high - low > width && low < left && left < right && right < high {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = function(left)?;
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = function(right)?;
        }
    }
    Some(if at_left < at_right { left } else { right })
}

/// The value of the polynomial through points (x, y), none of them at equal x (Neville's scheme).
pub fn interpolated(points: &[(f64, f64)], at: f64) -> f64 {
    let mut values: Vec<f64> = points.iter().map(|point| point.1).collect();
    for order in 1..points.len() {
        for n in 0..points.len() - order {
            let (left, right) = (points[n].0, points[n + order].0);
            values[n] += (at - left) * (values[n + 1] - values[n]) / (right - left);
        }
    }
    values.first().copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_minimum_is_found_within_its_error() {
        // ln cosh has the curvature 1 at its minimum; the cubic term makes the stencil work.
        let function = |x: f64| Some(libm::log(libm::cosh(x - 0.3)) + 0.1 * libm::pow(x - 0.3, 3.0));
        let found = minimum_between(function, (-0.4, 0.6), 0.05, 1e-10).unwrap();
        assert!((found.at - 0.3).abs() <= found.error && found.error < 1e-3, "{found:?}");
        assert!((found.curvature - 1.0).abs() < 1e-3, "{found:?}");
    }

    #[test]
    fn a_hole_or_a_ridge_has_no_minimum() {
        assert_eq!(minimum_between(|x| (x < 0.2).then_some(x * x), (-0.5, 0.5), 0.05, 0.0), None);
        assert_eq!(minimum_between(|x| Some(-x * x), (-0.5, 0.6), 0.05, 0.0), None);
    }

    #[test]
    fn a_search_narrower_than_rounding_ends() {
        let ends = (1.0, 1.0 + 8.0 * f64::EPSILON);
        let found = golden_section(|x| Some(-x), ends, 1e-20).unwrap();
        assert!(ends.0 < found && found <= ends.1, "{found:e}");
    }

    #[test]
    fn zeros_and_borders_are_found_to_their_width() {
        let found = zero_between(|x| Some(libm::exp(x) - 2.0), [(0.0, -1.0), (2.0, 5.4)], 1e-10).unwrap();
        assert!((found - std::f64::consts::LN_2).abs() < 1e-9, "{found}");
        let (without, with) = border_between(|x| Some(x > 0.7), (0.0, 1.0), 1e-6).unwrap();
        assert!(without <= 0.7 && 0.7 < with && with - without <= 1e-6);
        assert_eq!(border_between(|x| (x < 0.6).then_some(false), (0.0, 1.0), 1e-6), None);
    }

    #[test]
    fn a_cubic_is_extrapolated_exactly() {
        let cubic = |x: f64| (x, 2.0 + x * (1.0 - x * (3.0 - x)));
        let value = interpolated(&[cubic(0.5), cubic(1.0), cubic(2.0), cubic(3.0)], 0.0);
        assert!((value - 2.0).abs() < 1e-12, "{value}");
    }
}
