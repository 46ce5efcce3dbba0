//! Shares of slip modes by probability: random points of a box, with the error of the sample. Nothing here is certain.

use super::ParameterBox;
use crate::friction::{Parameters, SlipMode};
use crate::number::split_mix::SplitMix64;
use crate::number::{Dd, Rational, nearest_f64};
use crate::stability::{InertialThreshold, classify, classify_quickly};

slipmode_algebra::named! {
    /// How values are distributed about the middle of their error bars, each on its own.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Distribution {
        /// The error is one standard deviation. Values that are not positive are drawn again.
        Normal = "normal",
        /// All values within the error bars are equally probable, and no others occur.
        Uniform = "uniform",
    }
}

/// The share of a slip mode among random points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampledShare {
    /// The mode.
    pub mode: SlipMode,
    /// The number of points that have it, divided by that of all points.
    pub share: f64,
    /// The standard error of the share. It is that of (n + 2)/(N + 4) for n of N points, so that it is not 0 where n is 0 or N.
    pub sampling_error: f64,
}

/// The shares of all slip modes among random points, the same ones in every run.
#[must_use]
pub fn sampled_shares(
    region: &ParameterBox,
    threshold: &InertialThreshold,
    distribution: Distribution,
    samples: u32,
) -> [SampledShare; SlipMode::ALL.len()] {
    let (lower, upper) = (region.lower.each_ref().map(nearest_f64), region.upper.each_ref().map(nearest_f64));
    let mut random = SplitMix64(17);
    let mut counts = [0u32; SlipMode::ALL.len()];
    for _ in 0..samples {
        let point: [f64; 7] = std::array::from_fn(|i| match distribution {
            _ if !region.is_wide(i) => lower[i],
            Distribution::Uniform => random.between(lower[i], upper[i]),
            Distribution::Normal => positive_normal(lower[i], upper[i], &mut random),
        });
        let mode = mode_of(point, threshold);
        for (known, count) in SlipMode::ALL.into_iter().zip(&mut counts) {
            *count += u32::from(known == mode);
        }
    }
    std::array::from_fn(|i| {
        let (count, all) = (f64::from(counts[i]), f64::from(samples));
        let shifted = (count + 2.0) / (all + 4.0);
        let sampling_error = (shifted * (1.0 - shifted) / (all + 4.0)).sqrt();
        SampledShare { mode: SlipMode::ALL[i], share: count / all, sampling_error }
    })
}

/// A normal number with the ends one standard deviation from its mean.
fn positive_normal(lower: f64, upper: f64, random: &mut SplitMix64) -> f64 {
    let (mean, deviation) = (lower + (upper - lower) / 2.0, (upper - lower) / 2.0);
    loop {
        // The polar method of Marsaglia.
        let (x, y) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let square = x * x + y * y;
        if square > 0.0 && square < 1.0 {
            let value = mean + deviation * x * (-2.0 * libm::log(square) / square).sqrt();
            if value > 0.0 {
                return value;
            }
        }
    }
}

fn mode_of(point: [f64; 7], threshold: &InertialThreshold) -> SlipMode {
    if let Some(found) = classify_quickly(&Parameters::from(point.map(Dd::from)), threshold) {
        return found.slip_mode;
    }
    let exact = point.map(|value| Rational::from_f64(value).unwrap_or_default());
    classify(&Parameters::from(exact), threshold).slip_mode
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::parse_decimal;

    /// The share of stick-slip where b alone is uncertain, a ± 1 about the transition at b = 2, with ends as given.
    fn stick_slip(lower: &str, upper: &str, distribution: Distribution) -> SampledShare {
        let point = |b: &str| {
            let texts = ["0.01", b, "1e-5", "1e7", "1e-9", "1e4", "1e-6"];
            Parameters::from(texts.map(|text| parse_decimal(text).unwrap()))
        };
        let region = ParameterBox::new(point(lower), point(upper)).unwrap();
        let shares = sampled_shares(&region, &InertialThreshold::default(), distribution, 40_000);
        assert!((shares.iter().map(|share| share.share).sum::<f64>() - 1.0).abs() < 1e-12);
        shares.into_iter().find(|share| share.mode == SlipMode::StickSlip).unwrap()
    }

    #[test]
    fn shares_are_those_of_the_distribution_within_four_sampling_errors() {
        // K_c = (b - a) sigma/D_c without mass: K = K_c at b = 0.02. 0.02 is the mean plus half a standard deviation.
        for (distribution, ends, expected) in [
            (Distribution::Uniform, ["0.016", "0.026"], 0.6),
            (Distribution::Normal, ["0.017", "0.021"], 0.308_537_5),
        ] {
            let found = stick_slip(ends[0], ends[1], distribution);
            let off = (found.share - expected).abs() / found.sampling_error;
            assert!(off < 4.0, "{distribution:?}: {found:?}");
        }
        let none = stick_slip("0.011", "0.012", Distribution::Uniform);
        assert!(none.share == 0.0 && none.sampling_error > 0.0);
    }
}
