//! The velocity of the least peak (fig 5) as the original scheme sees it.

use rayon::prelude::*;

use super::long_term::{AFFORDABLE_STEPS, converged_cycle, scheme_peak, steps_needed};
use crate::paper::{exactly, model_at};
use slipmode::scene::PlanePoint;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::asymptote::inertial_upper_velocity_m_per_s;

/// How far a step moves the velocity of the least peak at one normal stress.
#[derive(Debug, Clone, PartialEq)]
pub struct SchemeLeastPeak {
    /// The evolution law.
    pub law: EvolutionLaw,
    /// Normal stress, Pa.
    pub normal_stress_pa: f64,
    /// Step in units of √(M/K).
    pub fraction: f64,
    /// log10 of our minimising velocity over that of eq 18.
    pub offset_dex: f64,
    /// log10 of the scheme's minimising velocity over ours.
    pub shift_dex: f64,
    /// Difference of the shifts by all samples and by every second one.
    pub shift_error_dex: f64,
}

/// Samples on either side of eq 18, and their distance in dex.
const SAMPLES: i32 = 8;
const SPACING_DEX: f64 = 0.05;

/// Degree of the polynomial through ln V_peak: peaks and converged values meet the same one, so that what it misses cancels.
const DEGREE: usize = 4;

/// By law and stress, then by step; a case is left out where a cycle is missing, a run is too long or the minimum lies outside.
pub(crate) fn least_peaks_of_scheme(
    parameters: &Slider<Rational>,
    stresses: &[f64],
    fractions: &[f64],
) -> Vec<SchemeLeastPeak> {
    let cases: Vec<(EvolutionLaw, f64)> = EvolutionLaw::ALL
        .into_iter()
        .flat_map(|law| stresses.iter().map(move |&stress| (law, stress)))
        .filter(|_| parameters.has_transition())
        .collect();
    let found: Vec<Vec<SchemeLeastPeak>> =
        cases.par_iter().map(|&(law, stress)| at_stress(parameters, law, stress, fractions)).collect();
    found.into_iter().flatten().collect()
}

fn at_stress(
    parameters: &Slider<Rational>,
    law: EvolutionLaw,
    stress: f64,
    fractions: &[f64],
) -> Vec<SchemeLeastPeak> {
    let eq18 = inertial_upper_velocity_m_per_s(&parameters.map(nearest_f64), &stress);
    let offsets: Vec<f64> = (-SAMPLES..=SAMPLES).map(|i| f64::from(i) * SPACING_DEX + CENTRE_DEX).collect();
    let cycles: Option<Vec<_>> = offsets
        .par_iter()
        .map(|&offset| {
            let velocity = eq18 * libm::exp10(offset);
            let place =
                PlanePoint { loading_velocity_m_per_s: exactly(velocity), normal_stress_pa: exactly(stress) };
            let model = model_at(parameters, &place, law);
            let cycle = converged_cycle(&model)?;
            Some((model, cycle, std::f64::consts::LN_10 * offset))
        })
        .collect();
    let Some(cycles) = cycles else { return Vec::new() };
    let ours: Vec<f64> = cycles.iter().map(|(_, cycle, velocity)| cycle.orbit.peak + velocity).collect();
    let of_step = |&fraction: &f64| {
        let peaks: Option<Vec<f64>> = cycles
            .par_iter()
            .map(|(model, cycle, velocity)| {
                let affordable = steps_needed(model, cycle, fraction) <= AFFORDABLE_STEPS;
                let peak = affordable.then(|| scheme_peak(model, cycle, fraction).ok())??;
                Some(peak.log_peak + velocity)
            })
            .collect();
        let peaks = peaks?;
        let offset_dex = minimiser(&offsets, &ours)?;
        let shift_dex = minimiser(&offsets, &peaks)? - offset_dex;
        let [thin_offsets, thin_ours, thin_peaks] = [&offsets, &ours, &peaks].map(|all| every_second(all));
        let thin = minimiser(&thin_offsets, &thin_peaks)? - minimiser(&thin_offsets, &thin_ours)?;
        let shift_error_dex = (thin - shift_dex).abs();
        Some(SchemeLeastPeak {
            law,
            normal_stress_pa: stress,
            fraction,
            offset_dex,
            shift_dex,
            shift_error_dex,
        })
    };
    fractions.iter().filter_map(of_step).collect()
}

/// Where the samples are centred, dex from eq 18: between the minima of the two laws at the stresses of fig 5.
const CENTRE_DEX: f64 = 0.15;

fn every_second(values: &[f64]) -> Vec<f64> {
    values.iter().step_by(2).copied().collect()
}

/// The minimiser of the least-squares polynomial of degree [`DEGREE`]; none when the minimum lies at an end.
fn minimiser(at: &[f64], values: &[f64]) -> Option<f64> {
    let (&first, &last) = at.first().zip(at.last())?;
    let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
    let fit = least_squares(at.iter().map(|x| (x - middle) / half), values)?;
    let slope = |t: f64| (1..=DEGREE).rev().fold(0.0, |sum, k| sum * t + k as f64 * fit[k]);
    // The only sign change from falling to rising, found on a fine raster and bisected.
    let raster = |i: u32| f64::from(i) / 50.0 - 1.0;
    let (mut low, mut high) =
        (0..100).map(|i| (raster(i), raster(i + 1))).find(|&(a, b)| slope(a) < 0.0 && slope(b) >= 0.0)?;
    for _ in 0..50 {
        let t = 0.5 * (low + high);
        if slope(t) < 0.0 { low = t } else { high = t }
    }
    Some(middle + half * 0.5 * (low + high))
}

/// Coefficients by ascending power from the normal equations: well conditioned for a low degree on [−1, 1].
fn least_squares(at: impl Iterator<Item = f64>, values: &[f64]) -> Option<[f64; DEGREE + 1]> {
    let mut rows = [[0.0; DEGREE + 2]; DEGREE + 1];
    for (t, value) in at.zip(values) {
        let mut powers = [1.0; DEGREE + 2];
        for k in 1..=DEGREE {
            powers[k] = powers[k - 1] * t;
        }
        powers[DEGREE + 1] = *value;
        for (i, row) in rows.iter_mut().enumerate() {
            for (cell, factor) in row.iter_mut().zip(powers) {
                *cell += powers[i] * factor;
            }
        }
    }
    // Gauss and Jordan; the matrix is positive definite, so that no row needs to change places.
    for i in 0..=DEGREE {
        let pivot = rows[i];
        if pivot[i] <= 0.0 {
            return None;
        }
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != i) {
            let factor = row[i] / pivot[i];
            row.iter_mut().zip(pivot).for_each(|(cell, p)| *cell -= factor * p);
        }
    }
    Some(std::array::from_fn(|i| rows[i][DEGREE + 1] / rows[i][i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_minimiser_of_a_sampled_quartic_is_exact_and_a_slope_has_none() {
        let at: Vec<f64> = (0..9).map(|i| f64::from(i) * 0.1).collect();
        let quartic = |x: f64| {
            let t = x - 0.37;
            2.0 + t * t * (1.0 + t + t * t)
        };
        let values: Vec<f64> = at.iter().map(|&x| quartic(x)).collect();
        assert!((minimiser(&at, &values).unwrap() - 0.37).abs() < 1e-10);
        assert_eq!(minimiser(&at, &at), None);
    }
}
