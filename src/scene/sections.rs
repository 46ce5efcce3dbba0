//! Values that several sections have: rectangles, axes, names, lists of ratios.

use crate::scene::section::{Entry, Section};
use crate::scene::{AllowedRange, Faults, Limits, LogAxis, Problem, check_name};
use slipmode_core::number::Rational;

/// A rectangle of the (V, σ) plane with a logarithmic grid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rectangle {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
    /// Normal stresses, Pa.
    pub normal_stress_pa: LogAxis,
}

impl Rectangle {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let velocity = axis(&mut section, "loading_velocity_m_per_s", limits, faults);
        let stress = axis(&mut section, "normal_stress_pa", limits, faults);
        section.finish(faults);
        let rectangle = Self { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? };
        let points = u64::from(rectangle.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(rectangle.normal_stress_pa.points));
        check_points(entry, points, limits, faults)?;
        Some(rectangle)
    }
}

/// The rule of [`check_name`] as messages state it.
pub(crate) const NAME_RULE: &str = "A-Z a-z 0-9 . _ -, at most 100 characters";

/// A text that can be a file name everywhere.
pub(crate) fn safe_name(entry: &Entry<'_>, faults: &mut Faults) -> Option<String> {
    let name = entry.text(faults)?;
    match check_name(&name) {
        Ok(()) => Some(name),
        Err(error) => {
            faults.push(entry.fault(Problem::BadName(error)));
            None
        }
    }
}

pub(crate) fn open_unit_list(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<Rational>> {
    entry.list(faults, |member, faults| member.decimal(AllowedRange::OPEN_UNIT, faults))
}

/// `{ from, to, points }` with positive ends in ascending order.
pub(crate) fn axis(
    section: &mut Section<'_>,
    key: &'static str,
    limits: &Limits,
    faults: &mut Faults,
) -> Option<LogAxis> {
    let entry = section.required(key, "{ from = …, to = …, points = … }", faults)?;
    let mut section = entry.section(faults)?;
    let mut end = |section: &mut Section<'_>, key| {
        let allowed = AllowedRange::PHYSICAL;
        section.required(key, &allowed.text(), faults).and_then(|entry| entry.decimal(allowed, faults))
    };
    let from = end(&mut section, "from");
    let to = end(&mut section, "to");
    let points = points(&mut section, limits, faults);
    section.finish(faults);
    let (from, to) = (from?, to?);
    if from >= to {
        let problem = if from == to { Problem::EmptyRange } else { Problem::ReversedRange };
        faults.push(entry.fault(problem));
        return None;
    }
    Some(LogAxis { from, to, points: points? })
}

/// `points`: from 2 to the limit.
pub(crate) fn points(section: &mut Section<'_>, limits: &Limits, faults: &mut Faults) -> Option<u32> {
    let allowed = format!("a whole number from 2 to {}", limits.max_points);
    let entry = section.required("points", &allowed, faults)?;
    let points = entry.whole(2..=u64::MAX, faults)?;
    check_points(&entry, points, limits, faults)?;
    let count = u32::try_from(points).ok();
    if count.is_none() {
        let allowed = format!("at most {} points along one axis, for any limit", u32::MAX);
        faults.push(entry.fault(Problem::OutOfRange { allowed }));
    }
    count
}

pub(crate) fn check_points(
    entry: &Entry<'_>,
    points: u64,
    limits: &Limits,
    faults: &mut Faults,
) -> Option<()> {
    if points <= limits.max_points {
        return Some(());
    }
    faults.push(entry.fault(Problem::TooManyPoints { points: points.to_string(), limit: limits.max_points }));
    None
}

/// A list of numbers of a range.
pub(crate) fn decimals(
    section: &mut Section<'_>,
    key: &'static str,
    range: AllowedRange,
    faults: &mut Faults,
) -> Option<Vec<Rational>> {
    let allowed = format!("a list of numbers, each {}", range.text());
    let entry = section.required(key, &allowed, faults)?;
    entry.list(faults, |member, faults| member.decimal(range, faults))
}

/// A place of the (V, σ) plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Loading velocity, m/s.
    pub loading_velocity_m_per_s: Rational,
    /// Normal stress, Pa.
    pub normal_stress_pa: Rational,
}

const PLACES: &str = "a list of { loading_velocity_m_per_s = …, normal_stress_pa = … }";

/// A list of places.
pub(crate) fn places(section: &mut Section<'_>, faults: &mut Faults) -> Option<Vec<Place>> {
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
