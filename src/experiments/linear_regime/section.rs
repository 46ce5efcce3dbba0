//! `[linear_regime]`: small disturbances at a few points (V, σ).

use crate::scene::section::{Entry, ReadSection, Section};
use crate::scene::{AllowedRange, PlanePoint};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// `[linear_regime]`: small disturbances along the eigenvectors, against the roots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LinearRegimeSection {
    /// The points.
    pub points: Vec<PlanePoint>,
    /// The evolution laws, each once.
    pub laws: Vec<EvolutionLaw>,
    /// Sizes of the start, each once.
    pub amplitudes: Vec<Rational>,
}

/// Starts of a linear regime at one point: one for each real root, two for a pair.
const STARTS_PER_POINT: u64 = 3;

impl ReadSection for LinearRegimeSection {
    fn read(section: &mut Section<'_>) -> Self {
        let range = AllowedRange::AMPLITUDE;
        let sizes =
            |entry: &Entry<'_>| entry.distinct(|_| "an earlier member".into(), |size| size.decimal(range));
        let read = Self {
            points: section.places("points"),
            laws: section.laws(),
            amplitudes: section.read("amplitudes", &format!("a list of sizes, each {}", range.text()), sizes),
        };
        let lists = [read.points.len(), read.laws.len(), read.amplitudes.len()];
        section.check_points(product(&lists).saturating_mul(STARTS_PER_POINT));
        read
    }
}

pub(crate) fn product(lengths: &[usize]) -> u64 {
    lengths.iter().fold(1, |product, &length| product.saturating_mul(length as u64))
}
