//! Power laws by least squares in the logarithms.

/// y = factor · x^exponent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    pub factor: f64,
    pub exponent: f64,
}

impl PowerLaw {
    /// The law with the least squared residuals of ln y; none for fewer than two different sizes or without positive values.
    pub fn fit(points: &[(f64, f64)]) -> Option<Self> {
        if points.iter().any(|(x, y)| *x <= 0.0 || *y <= 0.0) {
            return None;
        }
        let count = points.len() as f64;
        let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
        let mean_x = logs.iter().map(|(x, _)| x).sum::<f64>() / count;
        let mean_y = logs.iter().map(|(_, y)| y).sum::<f64>() / count;
        let spread: f64 = logs.iter().map(|(x, _)| (x - mean_x).powi(2)).sum();
        let shared: f64 = logs.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
        let exponent = shared / spread;
        exponent.is_finite().then(|| Self { factor: (mean_y - exponent * mean_x).exp(), exponent })
    }

    /// The value at a size.
    pub fn at(&self, size: f64) -> f64 {
        self.factor * size.powf(self.exponent)
    }

    /// The largest factor between a value and the law, at least 1.
    pub fn worst_residual(&self, points: &[(f64, f64)]) -> f64 {
        points.iter().map(|(x, y)| (y / self.at(*x)).ln().abs().exp()).fold(1.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_found_and_a_residual_is_stated() {
        let exact: Vec<(f64, f64)> = [1.0, 10.0, 100.0].map(|x: f64| (x, 3.0 * x.powf(1.5))).to_vec();
        let law = PowerLaw::fit(&exact).unwrap();
        assert!((law.exponent - 1.5).abs() < 1e-12 && (law.factor - 3.0).abs() < 1e-12);
        assert!(law.worst_residual(&exact) < 1.0 + 1e-12);
        assert!((law.worst_residual(&[(1.0, 6.0)]) - 2.0).abs() < 1e-12);
        assert!((law.worst_residual(&[(1.0, 1.5)]) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn too_few_or_impossible_points_have_no_law() {
        for points in [&[][..], &[(1.0, 1.0)], &[(2.0, 1.0), (2.0, 3.0)], &[(1.0, 0.0), (2.0, 1.0)]] {
            assert_eq!(PowerLaw::fit(points), None);
        }
    }
}
