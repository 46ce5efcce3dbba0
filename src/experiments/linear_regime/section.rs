//! `[linear_regime]`: small disturbances at a few points (V, σ).

use crate::scene::laws::read_laws;
use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::sections::check_points;
use crate::scene::{AllowedRange, Faults, Limits, Problem};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[linear_regime]`: small disturbances along the eigenvectors, against the roots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinearRegimeSection {
    /// V (m/s) and σ (Pa) of each point.
    pub points: Vec<[Rational; 2]>,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Sizes of the start, each once.
    pub amplitudes: Vec<Rational>,
}

/// Starts of a linear regime at one point: one for each real root, two for a pair.
const STARTS_PER_POINT: u64 = 3;

impl ReadSection for LinearRegimeSection {
    fn read(entry: &Entry<'_>, limits: &Limits, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let points = points(&mut section, faults);
        let laws = laws(&mut section, faults);
        let range = AllowedRange::AMPLITUDE;
        let amplitudes = section
            .required("amplitudes", &format!("a list of sizes, each {}", range.text()), faults)
            .and_then(|entry| distinct(&entry, range, faults));
        section.finish(faults);
        let read = Self { points: points?, laws: laws?, amplitudes: amplitudes? };
        let lists = [read.points.len(), read.laws.len(), read.amplitudes.len()];
        check_points(entry, product(&lists).saturating_mul(STARTS_PER_POINT), limits, faults)?;
        Some(read)
    }
}

pub(crate) fn product(lengths: &[usize]) -> u64 {
    lengths.iter().fold(1, |product, &length| product.saturating_mul(length as u64))
}

pub(crate) fn laws(section: &mut Section<'_>, faults: &mut Faults) -> Option<Vec<EvolutionLaw>> {
    let entry = section.required("laws", "a list of \"slip\" and \"aging\"", faults)?;
    read_laws(&entry, faults)
}

/// `points`: a list of `{ loading_velocity_m_per_s = …, normal_stress_pa = … }`.
pub(crate) fn points(section: &mut Section<'_>, faults: &mut Faults) -> Option<Vec<[Rational; 2]>> {
    let allowed = "a list of { loading_velocity_m_per_s = …, normal_stress_pa = … }";
    section.required("points", allowed, faults)?.list(faults, |member, faults| {
        let mut section = member.section(faults)?;
        let range = AllowedRange::PHYSICAL;
        let mut value = |section: &mut Section<'_>, key| {
            section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults))
        };
        let velocity = value(&mut section, "loading_velocity_m_per_s");
        let stress = value(&mut section, "normal_stress_pa");
        section.finish(faults);
        Some([velocity?, stress?])
    })
}

/// A list of decimals of which none occurs twice.
fn distinct(entry: &Entry<'_>, range: AllowedRange, faults: &mut Faults) -> Option<Vec<Rational>> {
    let mut seen: Vec<Rational> = Vec::new();
    entry.list(faults, |member, faults| {
        let value = member.decimal(range, faults)?;
        if seen.contains(&value) {
            let of = "an earlier member".to_owned();
            faults.push(member.fault(Problem::Duplicate { of, folded: false }));
            return None;
        }
        seen.push(value.clone());
        Some(value)
    })
}
