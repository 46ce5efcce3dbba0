//! The sections of a scene: what each asks for, and how it is read.

use crate::scene::section::{Entry, Section};
use crate::scene::{AllowedRange, Faults, Limits, LogAxis, Problem, check_name};
use slipmode_core::number::{Rational, parse_decimal};

/// A rectangle of the (V, σ) plane with a logarithmic grid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rectangle {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
    /// Normal stresses, Pa.
    pub normal_stress_pa: LogAxis,
}

/// `[boundary]`: the exact boundary along its arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundarySection {
    /// Points on each arc.
    pub points: u32,
    /// Certified decimal digits of each coordinate.
    pub digits: u32,
}

/// `[frequency]`: max Im(s) along lines of constant normal stress.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FrequencySection {
    /// σ/σ_c of each line, exact (decimals or fractions n/d); positive.
    pub normal_stress_over_critical: Vec<Rational>,
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
}

/// `[effect_ratio_sweep]`: the asymptotes' worst errors against β = b/a.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EffectRatioSweep {
    /// β.
    pub effect_ratio: LogAxis,
    /// Distances |β − 1| at which a → b is looked at from both sides; each strictly between 0 and 1.
    pub near_equal: Vec<Rational>,
}

/// `[tolerance]`: where each asymptote is good to a relative error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToleranceSection {
    /// Relative errors, each strictly between 0 and 1.
    pub relative: Vec<Rational>,
}

/// `[hard_cases]`: a file of points with references from independent programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HardCases {
    /// The file's name, safe by [`check_name`]; it has no folder.
    pub file: String,
    /// The name of a file of returns, if any.
    pub returns: Option<String>,
}

/// The largest number of digits that may be requested.
const MOST_DIGITS: u64 = 1_000_000;

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

impl BoundarySection {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let points = points(&mut section, limits, faults);
        let digits = section
            .required("digits", &format!("1 to {MOST_DIGITS}"), faults)
            .and_then(|entry| entry.whole(1..=MOST_DIGITS, faults));
        section.finish(faults);
        Some(Self { points: points?, digits: u32::try_from(digits?).ok()? })
    }
}

impl FrequencySection {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let ratios = section
            .required("normal_stress_over_critical", "a list of ratios > 0", faults)
            .and_then(|entry| entry.list(faults, |member, faults| member.number(faults, parse_ratio)));
        let velocity = axis(&mut section, "loading_velocity_m_per_s", limits, faults);
        section.finish(faults);
        let frequency = Self { normal_stress_over_critical: ratios?, loading_velocity_m_per_s: velocity? };
        let points = u64::from(frequency.loading_velocity_m_per_s.points)
            .saturating_mul(frequency.normal_stress_over_critical.len() as u64);
        check_points(entry, points, limits, faults)?;
        Some(frequency)
    }
}

impl EffectRatioSweep {
    pub(crate) fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let effect_ratio = axis(&mut section, "effect_ratio", limits, faults);
        let near_equal = match section.optional("near_equal") {
            Some(entry) => open_unit_list(&entry, faults),
            None => Some(Vec::new()),
        };
        section.finish(faults);
        Some(Self { effect_ratio: effect_ratio?, near_equal: near_equal? })
    }
}

impl ToleranceSection {
    pub(crate) fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let relative = section
            .required("relative", "a list of relative errors, each 0 < value < 1", faults)
            .and_then(|entry| open_unit_list(&entry, faults));
        section.finish(faults);
        Some(Self { relative: relative? })
    }
}

impl HardCases {
    pub(crate) fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let file = section
            .required("file", "the name of a file", faults)
            .and_then(|entry| safe_name(&entry, faults));
        let returns = section.optional("cycles").map(|entry| safe_name(&entry, faults));
        section.finish(faults);
        let returns = match returns {
            None => None,
            Some(name) => Some(name?),
        };
        Some(Self { file: file?, returns })
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

fn open_unit_list(entry: &Entry<'_>, faults: &mut Faults) -> Option<Vec<Rational>> {
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
fn points(section: &mut Section<'_>, limits: &Limits, faults: &mut Faults) -> Option<u32> {
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

/// A positive ratio: a decimal or a fraction n/d of decimals.
fn parse_ratio(text: &str) -> Result<Rational, Problem> {
    let range = AllowedRange::PHYSICAL;
    let Some((numerator, denominator)) = text.split_once('/') else {
        return range.parse(text);
    };
    let allowed = || format!("{}, as a decimal or a fraction n/d", range.text());
    let part =
        |text| parse_decimal(text).map_err(|reason| Problem::NotANumber { reason, allowed: allowed() });
    let (numerator, denominator) = (part(numerator)?, part(denominator)?);
    if denominator <= 0 {
        return Err(Problem::NotPositive { allowed: allowed() });
    }
    range.check(numerator / denominator)
}
