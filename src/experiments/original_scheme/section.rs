//! `[original_scheme]`: places, steps and points for the fixed-step scheme of the original simulations.

use crate::scene::section::{Entry, ReadSection};
use crate::scene::sections::{Place, axis, check_points, decimals, places};
use crate::scene::{AllowedRange, Faults, Limits, Rectangle};
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
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let places = places(&mut section, faults);
        let steps = decimals(&mut section, "steps", AllowedRange::OPEN_UNIT, faults);
        let velocity = axis(&mut section, "loading_velocity_m_per_s", limits, faults);
        let stress = axis(&mut section, "normal_stress_pa", limits, faults);
        let stresses = decimals(&mut section, "least_peak_stresses_pa", AllowedRange::PHYSICAL, faults);
        section.finish(faults);
        let rectangle = Rectangle { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? };
        let (places, steps) = (places?, steps?);
        let points = u64::from(rectangle.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(rectangle.normal_stress_pa.points))
            .saturating_add(places.len() as u64)
            .saturating_mul(steps.len() as u64);
        check_points(entry, points, limits, faults)?;
        Some(Self { places, steps, rectangle, least_peak_stresses_pa: stresses? })
    }
}
