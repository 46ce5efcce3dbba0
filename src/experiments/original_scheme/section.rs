//! `[original_scheme]`: places, steps and points for the fixed-step scheme of the original simulations.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::{AllowedRange, Place, Rectangle};
use slipmode_core::number::Rational;

/// `[original_scheme]`: the fixed-step scheme of the original simulations against converged runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OriginalSchemeSection {
    /// Where the bias of the long-term peak is followed through the steps.
    pub places: Vec<Place>,
    /// Steps in units of √(M/K), as the scene lists them.
    pub steps: Vec<Rational>,
    /// Points of fig 3a at which stability and peak are looked at.
    pub rectangle: Rectangle,
    /// Normal stresses at which the velocity of the least peak is looked for, Pa.
    pub least_peak_stresses_pa: Vec<Rational>,
}

impl ReadSection for OriginalSchemeSection {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let places = section.places("places");
        let [unit, physical] = [AllowedRange::OPEN_UNIT, AllowedRange::PHYSICAL];
        let allowed = |range: AllowedRange| format!("a list of numbers, each {}", range.text());
        let steps = section.decimals("steps", &allowed(unit), unit);
        let rectangle = section.rectangle();
        let stresses = section.decimals("least_peak_stresses_pa", &allowed(physical), physical);
        section.finish();
        let (places, steps, rectangle) = (places?, steps?, rectangle?);
        let points = rectangle.points().saturating_add(places.len() as u64);
        entry.check_points(points.saturating_mul(steps.len() as u64))?;
        Some(Self { places, steps, rectangle, least_peak_stresses_pa: stresses? })
    }
}
