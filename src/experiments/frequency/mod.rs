//! max Im(s) along lines of constant normal stress (fig 2).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::{FrequencyLine, FrequencyOutcome};

use crate::experiments::work::DECISION_S;
use crate::experiments::{Work, experiment};
use crate::scene::section::Section;
use crate::scene::{AllowedRange, LogAxis, Problem};
use slipmode_core::number::{Rational, parse_decimal};

experiment! {
    /// `[frequency]`: max Im(s) along lines of constant normal stress.
    pub struct FrequencySection {
        /// σ/σ_c of each line, exact (decimals or fractions n/d); positive.
        pub normal_stress_over_critical: Vec<Rational> = |section, key| {
            section.list(key, "a list of ratios > 0", |member| member.number(parse_ratio))
        },
        /// Loading velocities, m/s.
        pub loading_velocity_m_per_s: LogAxis = Section::axis,
    }
    points: |section| {
        let points = u64::from(section.loading_velocity_m_per_s.points);
        points.saturating_mul(section.normal_stress_over_critical.len() as u64)
    },
    requires: CriticalNormalStress,
    outcome: FrequencyOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| {
        let lines = section.normal_stress_over_critical.len() as f64;
        Work::points(f64::from(section.loading_velocity_m_per_s.points) * lines, DECISION_S)
    },
    run: |section, earlier, _| Some(run::frequency_lines(earlier.slider()?, section)),
}

/// A positive ratio: a decimal or a fraction n/d of decimals.
fn parse_ratio(text: &str) -> Result<Rational, Problem> {
    let range = AllowedRange::PHYSICAL;
    let Some((numerator, denominator)) = text.split_once('/') else {
        return range.parse(text);
    };
    let allowed = || format!("{}, as a decimal or a fraction n/d", range.text());
    let form = || Some("a decimal or a fraction n/d".to_string());
    let part = |text| parse_decimal(text).map_err(|reason| Problem::NotANumber { reason, allowed: form() });
    let (numerator, denominator) = (part(numerator)?, part(denominator)?);
    if denominator <= 0 {
        return Err(Problem::NotPositive { allowed: allowed() });
    }
    range.check(numerator / denominator)
}
