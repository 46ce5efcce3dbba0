//! The slip modes of the sliders that a record allows, with their correlations: sampled.

use nalgebra::DVector;

use super::estimate::Fit;
use super::parameter::Parameter;
use slipmode_core::friction::{OperatingPoint, Parameters, Slider};
use slipmode_core::number::Rational;
use slipmode_core::number::split_mix::SplitMix64;
use slipmode_core::stability::{InertialThreshold, SlipMode, classify};

/// Samples of the slider.
pub const SAMPLES: u32 = 2000;
/// Where the sequence of random numbers starts.
const SEED: u64 = 38;

/// The slip modes of sliders drawn from the normal distribution of the fit, each decided exactly, with their counts, the most frequent first.
///
/// None for a fit without mass, which has no slip mode.
pub(crate) fn sampled_modes(
    fit: &Fit,
    point: &OperatingPoint<Rational>,
    threshold: &InertialThreshold,
) -> Option<Vec<(SlipMode, u32)>> {
    let mass = fit.given.mass_per_area_kg_per_m2?;
    let factor = fit.covariance.clone().cholesky()?.unpack();
    let mut random = SplitMix64(SEED);
    let mut counts: Vec<(SlipMode, u32)> = Vec::new();
    for _ in 0..SAMPLES {
        let normal = DVector::from_fn(fit.estimates.len(), |_, _| normal(&mut random));
        let offsets = &factor * normal;
        let mut sample = fit.point;
        for (estimate, offset) in fit.estimates.iter().zip(offsets.iter()) {
            sample[estimate.parameter as usize] += offset;
        }
        let [a, b, d, k, ..] = Parameter::ALL.map(|parameter| parameter.at(&sample));
        let values = [a, b, d, k, mass].map(Rational::from_f64);
        let [Some(a), Some(b), Some(d), Some(k), Some(m)] = values else { continue };
        let parameters = Parameters { slider: Slider::from([a, b, d, k, m]), point: point.clone() };
        let mode = classify(&parameters, threshold).slip_mode;
        match counts.iter_mut().find(|(known, _)| *known == mode) {
            Some((_, count)) => *count += 1,
            None => counts.push((mode, 1)),
        }
    }
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    Some(counts)
}

/// A normally distributed number, by the method of Box and Muller.
fn normal(random: &mut SplitMix64) -> f64 {
    let radius = (-2.0 * libm::log(1.0 - random.unit())).sqrt();
    radius * libm::cos(std::f64::consts::TAU * random.unit())
}
