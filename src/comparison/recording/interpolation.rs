//! Between samples: where a curve passes a level, and how high it is near its highest sample, with an error.

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

/// The largest or the least value of a curve near its samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Its estimated absolute error.
    pub error: f64,
}

impl Extreme {
    /// Of nothing.
    pub const NONE: Self = Self { value: f64::NAN, error: f64::NAN };

    /// The extreme next to the largest (`sign` 1) or the least sample (`sign` −1): the vertex of the parabola through it and its
    /// neighbours, and the largest next term of Newton's form as error.
    ///
    /// Where the curvature changes by as much as it is, from one sample to the next, the parabola means nothing: the sample itself,
    /// and the range of the five samples around it.
    pub fn near(times: &[f64], values: &[f64], index: usize, sign: f64) -> Self {
        let around = index.saturating_sub(2)..(index + 3).min(values.len());
        let (t, f, best) = (&times[around.clone()], &values[around], values[index]);
        let farthest = f.iter().map(|value| (best - value).abs()).fold(0.0, f64::max);
        let unresolved = Self { value: best, error: farthest };
        if t.len() < 5 || t[2] != times[index] {
            return unresolved;
        }
        let slope = |at: usize| (f[at + 1] - f[at]) / (t[at + 1] - t[at]);
        let bend = |at: usize| (slope(at) - slope(at - 1)) / (t[at + 1] - t[at - 1]);
        // value(t) = best + p·t + q·t², t from the sample itself.
        let (q, sides) = (bend(2), [t[2] - t[1], t[3] - t[2]]);
        let p = slope(1) + q * sides[0];
        let changes = [bend(1) - q, bend(3) - q].map(f64::abs);
        if sign * q >= 0.0 || changes[0].max(changes[1]) >= q.abs() {
            return unresolved;
        }
        let next = (changes[0] / (t[3] - t[0])).max(changes[1] / (t[4] - t[1]));
        let side = sides[usize::from(p * sign > 0.0)];
        // The product of the distances from the three samples is at most half of side²·width.
        Self { value: best - p * p / (4.0 * q), error: 0.5 * next * side * side * (t[3] - t[1]) }
    }

    /// The middle between the outermost sample and the farthest value that can be, where that is the more certain.
    pub fn within(self, sample: f64, farthest: f64) -> Self {
        let middle = Self { value: 0.5 * (sample + farthest), error: 0.5 * (farthest - sample).abs() };
        if middle.error < self.error { middle } else { self }
    }

    /// Largest of two, or least with `sign` −1; the larger of their errors.
    pub fn outermost(self, other: Self, sign: f64) -> Self {
        let value = if sign * other.value > sign * self.value { other.value } else { self.value };
        Self { value, error: self.error.max(other.error) }
    }
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
        let times = [-2.0, -1.0, 0.25, 0.75, 1.5];
        let values = times.map(|t: f64| 3.0 - 2.0 * (t - 0.1) * (t - 0.1));
        let found = Extreme::near(&times, &values, 2, 1.0);
        assert!((found.value - 3.0).abs() < 1e-14 && found.error < 1e-14);
        let low = values.map(|value| -value);
        assert!((Extreme::near(&times, &low, 2, -1.0).value + 3.0).abs() < 1e-14);
        assert_eq!(Extreme::near(&times, &values, 0, 1.0).value, values[0]);
    }

    #[test]
    fn the_error_of_an_extreme_covers_the_truth() {
        for step in 1..40_u32 {
            for phase in 0..7_u32 {
                let h = 0.025 * f64::from(step);
                let times: Vec<f64> = (0..160)
                    .map(|i| h * (f64::from(i) + f64::from(phase) / 7.0))
                    .take_while(|t| *t < 3.0)
                    .collect();
                // A wave of a curvature that changes; its largest value is e at t = π/2.
                let values: Vec<f64> = times.iter().map(|t| libm::exp(libm::sin(*t))).collect();
                let best =
                    (0..times.len()).max_by(|one, other| values[*one].total_cmp(&values[*other])).unwrap();
                let found = Extreme::near(&times, &values, best, 1.0);
                let off = (found.value - std::f64::consts::E).abs();
                assert!(off <= found.error + 1e-14, "{h} {phase}: {off} {found:?}");
            }
        }
    }

    #[test]
    fn the_corner_of_a_sawtooth_is_no_parabola() {
        let times = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let values = [0.9, 0.95, 1.0, 0.0, 0.05, 0.1];
        assert_eq!(Extreme::near(&times, &values, 2, 1.0), Extreme { value: 1.0, error: 1.0 });
        assert_eq!(Extreme::near(&times, &values, 3, -1.0), Extreme { value: 0.0, error: 1.0 });
    }
}
