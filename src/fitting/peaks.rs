//! (b − a)σ/√(KM) from the peak velocities of deep stick-slip over the load velocity: least squares with the law of the peak, and
//! intervals by its profile.
//!
//! The law has two unknowns: the scale S = (b − a)σ/√(KM) = 2 V_18, and K/K_c,qs = D_c √(K/M)/S. The scale is held, K/K_c,qs is fitted
//! between its bounds, and the sum of squares is a function of S alone.

use super::peak_rows::{LEAST_RANGE, LEAST_ROWS, PeakFailure, PeakGiven, PeakRow, UNKNOWNS, noise};
use crate::parallel;
use slipmode_core::dynamics::{DEEP, PeakLaw};
use slipmode_core::friction::EvolutionLaw;

use super::peak_profile::{Case, CaseFit};

/// The fit of one law.
#[derive(Debug, Clone)]
pub struct PeakFit {
    /// The law.
    pub law: EvolutionLaw,
    /// The fit at the middle b/a and half of the bounded loss of the spring.
    pub central: CaseFit,
    /// The least and the greatest S over b/a.
    pub over_effect_ratio: [f64; 2],
    /// S without and with all of the loss that the law bounds.
    pub over_loss: [f64; 2],
    /// The ends of the 95 % interval over all of these, and over what the bandwidth hides.
    pub ends: [Option<f64>; 2],
    /// V_peak of each row by the law, m/s.
    pub peaks_m_per_s: Vec<f64>,
    /// The same at the ends of the interval from the noise; empty where there is no bound.
    pub band_m_per_s: [Vec<f64>; 2],
    /// The standard deviation of V_peak over V_peak, or of its residuals over their errors.
    pub scatter: f64,
    /// The least sum of squares over b/a and the loss, for the comparison of laws.
    cost: f64,
}

/// Fits of the laws, the better one first.
#[derive(Debug, Clone)]
pub struct PeakFits {
    /// The fits.
    pub laws: Vec<PeakFit>,
    /// How the other law compares.
    pub comparison: Option<PeakComparison>,
    /// Laws that have no such peaks in deep stick-slip.
    pub without_fit: Vec<EvolutionLaw>,
    /// The ends of the 95 % interval over the laws that the table does not exclude.
    pub ends: [Option<f64>; 2],
}

/// Two laws on the same table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakComparison {
    /// The root of the excess of the worse law's sum of squares over the variance of a peak.
    pub distance: f64,
    /// Beyond this the table tells the laws apart.
    pub quantile: f64,
}

impl PeakComparison {
    /// Whether the worse law is excluded. If it is true, this happens in one table of forty at most: the excess is the largest for a law
    /// that differs from it by as much as the excess itself, and then it has the distribution of Student's quantile.
    pub(crate) fn tells_apart(&self) -> bool {
        self.distance > self.quantile
    }
}

/// b/a with which simulated peaks of deep stick-slip follow their law: next to 1 the stress drop is not large against aσ.
pub const EFFECT_RATIOS: [f64; 2] = [1.2, 5.0];
/// b/a and parts of the spring's loss between their ends, at which the law is fitted.
const COUNT: u32 = 5;
const LOSSES: [f64; 3] = [0.5, 0.0, 1.0];

/// Checks a table and fits the laws to it.
///
/// # Errors
/// When the method does not hold for the table.
pub fn fit_peaks(rows: &[PeakRow], given: &PeakGiven) -> Result<PeakFits, PeakFailure> {
    if rows.len() < LEAST_ROWS {
        return Err(PeakFailure::TooFewRows(rows.len()));
    }
    let loads = || rows.iter().map(|row| row.load_m_per_s);
    let range = loads().fold(0.0, f64::max) / loads().fold(f64::INFINITY, f64::min);
    if range < LEAST_RANGE {
        return Err(PeakFailure::Narrow(range));
    }
    let found: Vec<Result<PeakFit, PeakFailure>> =
        given.laws.iter().map(|law| fit_law(rows, given, *law)).collect();
    let pairs = given.laws.iter().zip(&found);
    let without_fit = pairs.filter(|(_, fit)| fit.is_err()).map(|(law, _)| *law).collect();
    let failure = found.iter().find_map(|fit| fit.as_ref().err()).cloned();
    let mut laws: Vec<PeakFit> = found.into_iter().flatten().collect();
    laws.sort_by(|one, other| one.cost.total_cmp(&other.cost));
    let comparison = match &laws[..] {
        [better, worse] => {
            let [variance, quantile] = noise(rows, given, better.cost, UNKNOWNS + 1.0);
            Some(PeakComparison { distance: ((worse.cost - better.cost) / variance).sqrt(), quantile })
        }
        _ => None,
    };
    let kept = if comparison.is_some_and(|found| found.tells_apart()) { 1 } else { laws.len() };
    let ends = union(laws[..kept].iter().map(|fit| fit.ends));
    match failure.filter(|_| laws.is_empty()) {
        Some(failure) => Err(failure),
        None => Ok(PeakFits { laws, comparison, without_fit, ends }),
    }
}

/// The least of the lower ends and the greatest of the upper ones.
fn union(ends: impl Iterator<Item = [Option<f64>; 2]> + Clone) -> [Option<f64>; 2] {
    let side = |side: usize, of: fn(f64, f64) -> f64| {
        ends.clone().map(|ends| ends[side]).reduce(|one, other| Some(of(one?, other?))).flatten()
    };
    [side(0, f64::min), side(1, f64::max)]
}

fn fit_law(rows: &[PeakRow], given: &PeakGiven, law: EvolutionLaw) -> Result<PeakFit, PeakFailure> {
    let [low, high] = given.effect_ratio.map(|ratio| libm::log(ratio - 1.0));
    let count = if low < high { COUNT } else { 1 };
    let part = |n: u32| f64::from(n) / f64::from((count - 1).max(1));
    let ratios: Vec<f64> = (0..count).map(|n| 1.0 + libm::exp(low + (high - low) * part(n))).collect();
    let at = |ratio: &f64| {
        let peak_law = PeakLaw::new(law, *ratio);
        LOSSES.map(|loss| Case { rows, given, law: peak_law, loss, deepest: DEEP })
    };
    let cases: Vec<Case> = ratios.iter().flat_map(at).collect();
    let fits: Vec<Result<CaseFit, PeakFailure>> = parallel::map(&cases, |case| case.fit());
    // A b/a with which the peaks are not those of deep stick-slip is not that of this table.
    let possible: Vec<usize> =
        (0..fits.len()).step_by(LOSSES.len()).filter(|place| fits[*place].is_ok()).collect();
    let middle = possible.get(possible.len() / 2).copied().unwrap_or(0);
    let central = fits[middle].clone()?;
    for (index, row) in rows.iter().enumerate() {
        let eq18 = 0.5 * central.scale_m_per_s * row.stress;
        let over = row.load_m_per_s / eq18;
        if over > DEEP {
            return Err(PeakFailure::Fast { row: index, load: row.load_m_per_s, over, eq18 });
        }
    }
    let scales = |of: &[Result<CaseFit, PeakFailure>]| {
        let scales = of.iter().flatten().map(|fit| fit.scale_m_per_s);
        scales.fold([f64::INFINITY, 0.0], |[low, high], scale: f64| [low.min(scale), high.max(scale)])
    };
    let unspent: Vec<Result<CaseFit, PeakFailure>> = fits.iter().step_by(LOSSES.len()).cloned().collect();
    let [low, high] = union(fits.iter().flatten().map(|fit| fit.ends));
    let peaks = |residuals: &[f64]| -> Vec<f64> {
        rows.iter().zip(residuals).map(|(row, residual)| row.peak_m_per_s * libm::exp(-residual)).collect()
    };
    let held = |end: Option<f64>| cases[middle].held(libm::log(end?));
    let band_m_per_s = central.ends.map(|end| held(end).map_or_else(Vec::new, |held| peaks(&held.residuals)));
    Ok(PeakFit {
        law,
        over_effect_ratio: scales(&unspent),
        over_loss: scales(&fits[middle..middle + LOSSES.len()]),
        ends: [low, high.map(|high| high / (1.0 - given.hidden))],
        scatter: (central.cost / (rows.len() as f64 - UNKNOWNS)).sqrt(),
        cost: fits.iter().flatten().map(|fit| fit.cost).fold(f64::INFINITY, f64::min),
        peaks_m_per_s: peaks(&central.residuals),
        band_m_per_s,
        central,
    })
}

/// The largest part of a peak that a machine hides whose −3 dB frequency is this many natural frequencies.
///
/// To first order in 1/A the slip is half of a sine at the natural frequency. A low-pass of first order gives a sine of 1/√(1 + (f_n/f)²)
/// of its height and a positive transient, so that its peak is never lower; a steeper low-pass of the same −3 dB frequency takes less.
#[must_use]
pub fn hidden_part(bandwidth_over_natural: f64) -> f64 {
    let ratio = 1.0 / bandwidth_over_natural;
    1.0 - 1.0 / (1.0 + ratio * ratio).sqrt()
}
