//! What residuals say of noise: its size, and whether neighbours are alike.

use std::f64::consts::PI;

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
    /// The step to which what was measured is rounded, 0 where none is seen.
    pub step: f64,
    /// Standard deviation of the noise before this rounding.
    pub noise: f64,
}

/// A correlation of neighbours beyond this many of its standard errors is significant: one record in a hundred has it by chance.
const SIGNIFICANT: f64 = 2.58;
/// The 97.5 % quantile of the normal distribution.
pub(super) const NORMAL_QUANTILE: f64 = 1.959_963_984_540_054;
/// Parts of a step in which the variance is averaged.
const PHASES: usize = 10;
/// Harmonics of the mean error of rounding.
const HARMONICS: i32 = 9;
/// Fewest degrees of freedom that quantiles are taken for.
const FEWEST: f64 = 4.0;

impl Residuals {
    /// The noise that these residuals of a fit with this many parameters show, where the record is rounded to a step.
    pub fn of(residuals: &[f64], parameters: usize, step: f64) -> Self {
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
            step,
            noise: before_rounding(residuals, step),
        }
    }

    /// The largest mean error of rounding with this noise: Σ exp(−2 (π k noise/step)²)/(π k) steps, at most half a step.
    pub fn rounding(&self) -> f64 {
        let harmonic = |k: i32| {
            let turns = PI * f64::from(k);
            let share = turns * self.noise / self.step;
            libm::exp(-2.0 * share * share) / turns
        };
        if self.step > 0.0 { self.step * (1..=HARMONICS).map(harmonic).sum::<f64>().min(0.5) } else { 0.0 }
    }

    /// How many standard errors a 95 % interval extends to each side: Student's quantile for the degrees of freedom, and the inflation.
    pub fn half_width(&self) -> f64 {
        student_quantile(self.degrees_of_freedom) * self.inflation.sqrt()
    }
}

/// The standard deviation before rounding: the variance at a value of the model, on average over all places of it within a step, less
/// step²/12 (Sheppard). A part of the step without values counts as one without noise.
fn before_rounding(residuals: &[f64], step: f64) -> f64 {
    let mut phases = [[0.0f64; 3]; PHASES];
    for residual in residuals.iter().filter(|_| step > 0.0) {
        let phase = ((residual / step).rem_euclid(1.0) * PHASES as f64) as usize;
        let sums = &mut phases[phase.min(PHASES - 1)];
        *sums = [sums[0] + 1.0, sums[1] + residual, sums[2] + residual * residual];
    }
    let variance =
        |[rows, sum, square]: &[f64; 3]| (square - sum * sum / rows.max(1.0)) / (rows - 1.0).max(1.0);
    (phases.iter().map(variance).sum::<f64>() / PHASES as f64 - step * step / 12.0).max(0.0).sqrt()
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
    fn noise_is_found_before_rounding_and_the_mean_error_of_rounding_is_bounded() {
        // (noise, largest mean error): over all values, both in steps.
        for (noise, wanted) in [(0.5, 0.0023), (0.3, 0.054), (0.2, 0.146), (0.1, 0.32), (0.0, 0.5)] {
            let mut random = SplitMix64(3);
            let mut normal = || noise * ((0..12).map(|_| random.unit()).sum::<f64>() - 6.0);
            let rounded: Vec<f64> = (0..40_000u32)
                .map(|row| {
                    let value = 1e-3 * f64::from(row);
                    2.0 * (value - (value + normal()).round())
                })
                .collect();
            let found = Residuals::of(&rounded, 4, 2.0);
            assert!(found.noise / 2.0 < 1.02 * noise + 0.01, "{found:?}");
            // An error of 1 % of the noise, which 40 000 values can have, changes the smallest of the bounds by 10 %.
            let bounds = 0.9 * wanted..1.6 * wanted + 1e-3;
            assert!(bounds.contains(&(found.rounding() / 2.0)), "{noise} {found:?}");
            let even = Residuals::of(&rounded, 4, 1e-9);
            assert_eq!(even.rounding(), 0.0);
        }
    }

    #[test]
    fn independent_residuals_widen_nothing_and_correlated_ones_do() {
        let mut random = SplitMix64(1);
        let noise: Vec<f64> = (0..4000).map(|_| random.between(-1.0, 1.0)).collect();
        let independent = Residuals::of(&noise, 4, 0.0);
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
        let found = Residuals::of(&correlated, 4, 0.0);
        assert!(
            (found.autocorrelation - 0.8).abs() < 0.03 && (6.0..12.0).contains(&found.inflation),
            "{found:?}"
        );
    }
}
