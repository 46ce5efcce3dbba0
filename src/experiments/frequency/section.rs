//! `[frequency]`: lines of constant normal stress.

use crate::scene::section::{Entry, ReadSection, Section};
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
    fn read(section: &mut Section<'_>) -> Self {
        let ratio = |member: &Entry<'_>| member.number(parse_ratio);
        let read = Self {
            normal_stress_over_critical: section.list(
                "normal_stress_over_critical",
                "a list of ratios > 0",
                ratio,
            ),
            loading_velocity_m_per_s: section.axis("loading_velocity_m_per_s"),
        };
        let points = u64::from(read.loading_velocity_m_per_s.points);
        section.check_points(points.saturating_mul(read.normal_stress_over_critical.len() as u64));
        read
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
