//! A table of peak velocities, what is known besides, and why it has no fit.

use slipmode_core::number::format::{Side, rounded};
use slipmode_core::{dynamics::DEEP, friction::EvolutionLaw};

use super::residuals::{NORMAL_QUANTILE, student_quantile};

/// Fewest rows: with fewer, two unknowns leave no estimate of the noise.
pub const LEAST_ROWS: usize = 5;

/// The smallest ratio of the greatest and the least load velocity.
pub(super) const LEAST_RANGE: f64 = 3.0;

/// S and K/K_c,qs.
pub(super) const UNKNOWNS: f64 = 2.0;

/// A mean peak velocity at one velocity of the load point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakRow {
    /// V_l, m/s.
    pub load_m_per_s: f64,
    /// V_peak, m/s.
    pub peak_m_per_s: f64,
    /// Its standard error over V_peak; 1 in every row of a table without errors.
    pub relative_error: f64,
    /// The normal stress over that of the first row.
    pub stress: f64,
}

/// What is known besides the table.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PeakGiven {
    /// The evolution laws.
    pub laws: Vec<EvolutionLaw>,
    /// The least and the greatest b/a.
    pub effect_ratio: [f64; 2],
    /// The least and the greatest D_c √(K/M), m/s.
    pub slip_velocity_m_per_s: Option<[f64; 2]>,
    /// The largest part of a peak that the machine's bandwidth hides.
    pub hidden: f64,
    /// Whether the rows have errors; else the scatter of the peaks gives their error.
    pub has_errors: bool,
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PeakFailure {
    /// Too few rows.
    #[error("{0} rows (wanted: at least {LEAST_ROWS})")]
    TooFewRows(usize),
    /// Too narrow a range.
    #[error("the load velocities span a factor of {0:.3} (wanted: at least {LEAST_RANGE})")]
    Narrow(f64),
    /// A load velocity near the peak.
    #[error(
        "row {}, column loading_velocity_m_per_s: {load:e} m/s is {} V_18, V_18 = (b - a) sigma/(2 sqrt(K M)) = {eq18:.3e} m/s (wanted: at most {DEEP} V_18, deep stick-slip)", .row + 1, rounded(*.over, 3, Side::Above)
    )]
    Fast {
        /// The row, counted from 0.
        row: usize,
        /// V_l, m/s.
        load: f64,
        /// V_l/V_18.
        over: f64,
        /// V_18, m/s.
        eq18: f64,
    },
    /// The peaks do not follow the law.
    #[error(
        "the peaks are not those of deep stick-slip with the {0} law: they require K/K_c,qs above {DEEP}, or fall too steeply"
    )]
    NotDeep(EvolutionLaw),
    /// The peaks do not fall.
    #[error("the peaks do not fall as the load velocity rises: they set no bound of (b - a) sigma/sqrt(K M)")]
    Flat,
}

/// The variance of the peaks over that of their errors, and the quantile for it. Peaks that scatter more than their errors have larger ones.
pub(super) fn noise(rows: &[PeakRow], given: &PeakGiven, cost: f64, unknowns: f64) -> [f64; 2] {
    let degrees = rows.len() as f64 - unknowns;
    let scatter = (cost / (rows.len() as f64 - UNKNOWNS)).max(f64::MIN_POSITIVE);
    if given.has_errors { [scatter.max(1.0), NORMAL_QUANTILE] } else { [scatter, student_quantile(degrees)] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_velocity_beyond_the_limit_is_not_rounded_down_to_it() {
        let message =
            |over: f64| PeakFailure::Fast { row: 0, load: 2e-3, over, eq18: 2e-3 / over }.to_string();
        assert!(message(0.104).contains("0.104 V_18") && message(0.100_04).contains("0.101 V_18"));
    }
}
