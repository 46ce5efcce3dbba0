//! `[frequency]`: lines of constant normal stress.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{AllowedRange, LogAxis, Problem};
use slipmode_core::number::{Rational, parse_decimal};

/// `[frequency]`: max Im(s) along lines of constant normal stress.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FrequencySection {
    /// σ/σ_c of each line, exact (decimals or fractions n/d); positive.
    pub normal_stress_over_critical: Vec<Rational>,
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
}

impl ReadSection for FrequencySection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let ratios = section
            .required("normal_stress_over_critical", "a list of ratios > 0")
            .and_then(|entry| entry.list(|member| member.number(parse_ratio)));
        let velocity = section.axis("loading_velocity_m_per_s");
        section.finish();
        let frequency = Self { normal_stress_over_critical: ratios?, loading_velocity_m_per_s: velocity? };
        let points = u64::from(frequency.loading_velocity_m_per_s.points)
            .saturating_mul(frequency.normal_stress_over_critical.len() as u64);
        entry.check_points(points)?;
        Some(frequency)
    }
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
