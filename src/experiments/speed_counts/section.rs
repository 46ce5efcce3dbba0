//! `[speed_counts]`: how much is counted, and to which errors.

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::sections::check_points;
use crate::scene::{AllowedRange, Faults, Limits};
use slipmode_core::number::Rational;

/// `[speed_counts]`: work against error of roots, classes, boundary points and sweeps, by counts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpeedCountsSection {
    /// Cubics of each of the two sets.
    pub cubics: u32,
    /// Digits requested of certified roots and of boundary points.
    pub digits: Vec<u32>,
    /// Points that are classified.
    pub points: u32,
    /// The first of them, which every textbook method classifies too.
    pub textbook_points: u32,
    /// Velocities and stresses of the sweep, each.
    pub sweep_side: u32,
    /// Relative errors requested of the sweep.
    pub tolerances: Vec<Rational>,
}

/// More digits than this take longer than all the rest of a report.
const MOST_DIGITS: u64 = 100_000;

impl ReadSection for SpeedCountsSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let mut count = |section: &mut Section<'_>, key| {
            let most = limits.max_points.min(u64::from(u32::MAX));
            let entry = section.required(key, &format!("a whole number from 1 to {most}"), faults)?;
            u32::try_from(entry.whole(1..=most, faults)?).ok()
        };
        let cubics = count(&mut section, "cubics");
        let points = count(&mut section, "points");
        let textbook_points = count(&mut section, "textbook_points");
        let sweep_side = count(&mut section, "sweep_side");
        let digits = section
            .required("digits", &format!("a list of whole numbers from 1 to {MOST_DIGITS}"), faults)
            .and_then(|entry| {
                entry
                    .list(faults, |member, faults| u32::try_from(member.whole(1..=MOST_DIGITS, faults)?).ok())
            });
        let range = AllowedRange::SIMULATION_TOLERANCE;
        let tolerances = section
            .required("tolerances", &format!("a list of numbers, each {}", range.text()), faults)
            .and_then(|entry| entry.list(faults, |member, faults| member.decimal(range, faults)));
        section.finish(faults);
        let sweep_side = sweep_side?;
        check_points(entry, u64::from(sweep_side).saturating_mul(u64::from(sweep_side)), limits, faults)?;
        Some(Self {
            cubics: cubics?,
            digits: digits?,
            points: points?,
            textbook_points: textbook_points?,
            sweep_side,
            tolerances: tolerances?,
        })
    }
}
