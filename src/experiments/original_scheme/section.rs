//! `[original_scheme]`, `[work_precision]` and `[error_bound]`: what the numerical method does to the answer.

use crate::scene::section::{Entry, Section};
use crate::scene::sections::{axis, check_points};
use crate::scene::{AllowedRange, Faults, Limits, Rectangle};
use slipmode_core::number::Rational;

/// A place of the (V, σ) plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Loading velocity, m/s.
    pub loading_velocity_m_per_s: Rational,
    /// Normal stress, Pa.
    pub normal_stress_pa: Rational,
}

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

/// `[work_precision]`: work against error of the integrators on one period of the limit cycle.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkPrecisionSection {
    /// The returns.
    pub places: Vec<Place>,
}

/// `[error_bound]`: stated errors against true ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ErrorBoundSection {
    /// Triples of groups; each is run with both laws.
    pub groups: u32,
    /// Relative errors requested.
    pub tolerances: Vec<Rational>,
}

const PLACES: &str = "a list of { loading_velocity_m_per_s = …, normal_stress_pa = … }";

impl OriginalSchemeSection {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
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

impl WorkPrecisionSection {
    pub(crate) fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let places = places(&mut section, faults);
        section.finish(faults);
        Some(Self { places: places? })
    }
}

impl ErrorBoundSection {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let most = limits.max_points.min(u64::from(u32::MAX));
        let groups = section
            .required("groups", &format!("a whole number from 1 to {most}"), faults)
            .and_then(|entry| entry.whole(1..=most, faults));
        let tolerances = decimals(&mut section, "tolerances", AllowedRange::SIMULATION_TOLERANCE, faults);
        section.finish(faults);
        Some(Self { groups: u32::try_from(groups?).ok()?, tolerances: tolerances? })
    }
}

fn decimals(
    section: &mut Section<'_>,
    key: &'static str,
    range: AllowedRange,
    faults: &mut Faults,
) -> Option<Vec<Rational>> {
    let allowed = format!("a list of numbers, each {}", range.text());
    let entry = section.required(key, &allowed, faults)?;
    entry.list(faults, |member, faults| member.decimal(range, faults))
}

fn places(section: &mut Section<'_>, faults: &mut Faults) -> Option<Vec<Place>> {
    section.required("places", PLACES, faults)?.list(faults, |member, faults| {
        let mut section = member.section(faults)?;
        let range = AllowedRange::PHYSICAL;
        let mut read =
            |key| section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
        let velocity = read("loading_velocity_m_per_s");
        let stress = read("normal_stress_pa");
        section.finish(faults);
        Some(Place { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? })
    })
}
