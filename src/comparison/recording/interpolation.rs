//! Between samples: where a curve passes a level, and how high it is between the three highest samples.

/// Halvings of a bisection: below the spacing of 64-bit numbers.
const HALVINGS: u32 = 60;

/// The time at which the curve through samples `index` and `index + 1` passes the level.
///
/// The cubic through the two and their neighbours, where there are any, is followed by bisection, so that the answer
/// lies between the two samples whatever their neighbours do.
pub fn crossing(times: &[f64], values: &[f64], index: usize, level: f64) -> f64 {
    let from = index.saturating_sub(1);
    let to = (index + 3).min(times.len());
    let curve = Newton::through(&times[from..to], &values[from..to]);
    let (mut low, mut high) = (times[index], times[index + 1]);
    let rises = values[index + 1] > values[index];
    for _ in 0..HALVINGS {
        let middle = low + 0.5 * (high - low);
        if (curve.at(middle) < level) == rises {
            low = middle;
        } else {
            high = middle;
        }
    }
    low + 0.5 * (high - low)
}

/// The vertex of the parabola through a sample and its neighbours; the sample itself at an end.
///
/// With `sign` 1 the sample is the highest of the three, with −1 the lowest.
pub fn vertex(times: &[f64], values: &[f64], index: usize, sign: f64) -> f64 {
    let best = values[index];
    let (Some(before), Some(after)) = (index.checked_sub(1), times.get(index + 1)) else { return best };
    let (left, right) = (times[index] - times[before], after - times[index]);
    let (fall_left, fall_right) = (sign * (best - values[before]), sign * (best - values[index + 1]));
    // sign·value(t) = sign·best + p·t − q·t², t from the sample itself.
    let q = (fall_left / left + fall_right / right) / (left + right);
    let p = (fall_left * right / left - fall_right * left / right) / (left + right);
    let rise = p * p / (4.0 * q);
    if rise.is_finite() && q > 0.0 { best + sign * rise } else { best }
}

/// A polynomial through up to four samples, in Newton's form.
struct Newton<'t> {
    times: &'t [f64],
    coefficients: [f64; 4],
}

impl<'t> Newton<'t> {
    fn through(times: &'t [f64], values: &[f64]) -> Self {
        let mut coefficients = [0.0; 4];
        coefficients[..values.len()].copy_from_slice(values);
        for order in 1..times.len() {
            for index in (order..times.len()).rev() {
                let span = times[index] - times[index - order];
                coefficients[index] = (coefficients[index] - coefficients[index - 1]) / span;
            }
        }
        Self { times, coefficients }
    }

    fn at(&self, time: f64) -> f64 {
        let pairs = self.times.iter().zip(self.coefficients).rev();
        pairs.fold(0.0, |sum, (node, coefficient)| sum * (time - node) + coefficient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_where_it_passes_the_level() {
        let times = [0.0, 1.0, 2.5, 3.0];
        let values = times.map(|t: f64| t * t * t - 2.0);
        assert!((crossing(&times, &values, 1, 0.0) - libm::cbrt(2.0)).abs() < 1e-14);
        // With two samples only, the line between them.
        assert!((crossing(&times[1..3], &values[1..3], 0, 0.0) - (1.0 + 1.5 / 14.625)).abs() < 1e-14);
    }

    #[test]
    fn a_parabola_has_its_vertex_wherever_the_samples_lie() {
        let times = [-1.0, 0.25, 0.75];
        let values = times.map(|t: f64| 3.0 - 2.0 * (t - 0.1) * (t - 0.1));
        assert!((vertex(&times, &values, 1, 1.0) - 3.0).abs() < 1e-14);
        let low = values.map(|value| -value);
        assert!((vertex(&times, &low, 1, -1.0) + 3.0).abs() < 1e-14);
        assert_eq!(vertex(&times, &values, 0, 1.0), values[0]);
    }
}
