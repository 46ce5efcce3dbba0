//! What residuals say of noise: its size, and whether neighbours are alike.

/// The noise of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residuals {
    /// Standard deviation of the friction of one sample.
    pub standard_deviation: f64,
    /// Correlation of neighbouring residuals.
    pub autocorrelation: f64,
    /// By how much a variance is larger than for independent samples; 1 where no correlation is significant.
    pub inflation: f64,
    /// Independent samples less parameters.
    pub degrees_of_freedom: f64,
}

/// A correlation of neighbours beyond this many of its standard errors is significant: one record in a hundred has it by chance.
const SIGNIFICANT: f64 = 2.58;
/// The 97.5 % quantile of the normal distribution.
pub(super) const NORMAL_QUANTILE: f64 = 1.959_963_984_540_054;
/// Fewest degrees of freedom that quantiles are taken for.
const FEWEST: f64 = 4.0;

impl Residuals {
    /// The noise that these residuals of a fit with this many parameters show.
    pub fn of(residuals: &[f64], parameters: usize) -> Self {
        let rows = residuals.len() as f64;
        let degrees = (rows - parameters as f64).max(1.0);
        let square = residuals.iter().map(|residual| residual * residual).sum::<f64>();
        let correlation = |lag: usize| {
            let product: f64 =
                residuals.iter().zip(&residuals[lag.min(residuals.len())..]).map(|(a, b)| a * b).sum();
            if square > 0.0 { product / square } else { 0.0 }
        };
        let autocorrelation = correlation(1);
        let is_significant = autocorrelation > SIGNIFICANT / rows.sqrt();
        let inflation = if is_significant { inflation(correlation, residuals.len()) } else { 1.0 };
        Self {
            standard_deviation: (square / degrees).sqrt(),
            autocorrelation,
            inflation,
            degrees_of_freedom: (degrees / inflation).max(FEWEST),
        }
    }

    /// How many standard errors a 95 % interval extends to each side: Student's quantile for the degrees of freedom, and the inflation.
    pub fn half_width(&self) -> f64 {
        student_quantile(self.degrees_of_freedom) * self.inflation.sqrt()
    }
}

/// 1 + 2 Σ ρ_k over the lags before the first pair of neighbours without a positive sum (Geyer 1992, initial positive sequence).
fn inflation(correlation: impl Fn(usize) -> f64, rows: usize) -> f64 {
    let pairs = (1..rows / 4).step_by(2).map(|lag| correlation(lag) + correlation(lag + 1));
    1.0 + 2.0 * pairs.take_while(|pair| *pair > 0.0).sum::<f64>()
}

/// The 97.5 % quantile of Student's distribution by its expansion about the normal one: to 0.3 % from four degrees of freedom on, to 0.8 % from three.
pub(super) fn student_quantile(degrees: f64) -> f64 {
    let z = NORMAL_QUANTILE;
    let z3 = z * z * z;
    let (z5, z7) = (z3 * z * z, z3 * z3 * z);
    z + (z3 + z) / (4.0 * degrees)
        + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * degrees * degrees)
        + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * degrees * degrees * degrees)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipmode_core::number::split_mix::SplitMix64;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (degrees, wanted) in [(4.0, 2.7764), (10.0, 2.2281), (30.0, 2.0423), (1e6, 1.95996)] {
            assert!((student_quantile(degrees) / wanted - 1.0).abs() < 3e-3, "{degrees}");
        }
    }

    #[test]
    fn independent_residuals_widen_nothing_and_correlated_ones_do() {
        let mut random = SplitMix64(1);
        let noise: Vec<f64> = (0..4000).map(|_| random.between(-1.0, 1.0)).collect();
        let independent = Residuals::of(&noise, 4);
        assert_eq!(independent.inflation, 1.0);
        assert!((independent.standard_deviation * 3.0_f64.sqrt() - 1.0).abs() < 0.03);
        // x_i = 0.8 x_{i-1} + noise: the variance of a mean is (1 + 0.8)/(1 − 0.8) = 9 times as large.
        let mut last = 0.0;
        let correlated: Vec<f64> = noise
            .iter()
            .map(|noise| {
                last = 0.8 * last + noise;
                last
            })
            .collect();
        let found = Residuals::of(&correlated, 4);
        assert!(
            (found.autocorrelation - 0.8).abs() < 0.03 && (6.0..12.0).contains(&found.inflation),
            "{found:?}"
        );
    }
}
