//! How many points of a grid have which signs and which slip mode.

use std::ops::AddAssign;

use super::{GridCell, PrecisionCounts, RowBlock, StreamedGrid};
use crate::stability::{SlipMode, SpectralClass};

/// Counts over a grid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tally {
    by_code: [u64; GridCell::COUNT],
    decided_by: PrecisionCounts,
}

/// Counters that run side by side, so that a run of equal cells does not wait for one memory cell.
const LANES: usize = 4;

/// A counter for every byte, so that no index is checked.
const BYTES: usize = 256;

impl Default for Tally {
    fn default() -> Self {
        Self { by_code: [0; GridCell::COUNT], decided_by: PrecisionCounts::default() }
    }
}

impl Tally {
    /// Counts the points of a grid, in memory that does not depend on their number; `tick` hears of every block.
    ///
    /// `None` unless every coordinate is positive and finite.
    #[must_use]
    pub fn of_grid<V, S>(grid: &StreamedGrid<'_, V, S>, tick: impl Fn(u64) + Sync) -> Option<Self>
    where
        V: Fn(u32) -> f64 + Sync,
        S: Fn(u32) -> f64 + Sync,
    {
        let count = |mut sum: Self, block: RowBlock<'_>| {
            sum.count(block.cells);
            sum.decided_by += block.decided_by;
            tick(block.cells.len() as u64);
            sum
        };
        grid.fold(Self::default, count, |mut left, right| {
            left += right;
            left
        })
    }

    fn count(&mut self, cells: &[GridCell]) {
        let mut counters = [[0u64; BYTES]; LANES];
        for group in cells.chunks(LANES) {
            for (counter, cell) in counters.iter_mut().zip(group) {
                counter[cell.code() % BYTES] += 1;
            }
        }
        for (code, total) in self.by_code.iter_mut().enumerate() {
            *total += counters.iter().map(|counter| counter[code]).sum::<u64>();
        }
    }

    /// The points whose cell is as wanted.
    #[must_use]
    pub fn points_where(&self, wanted: impl Fn(GridCell) -> bool) -> u64 {
        let counted = GridCell::all().zip(self.by_code);
        counted.filter(|(cell, _)| wanted(*cell)).map(|(_, count)| count).sum()
    }

    /// All points.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.by_code.iter().sum()
    }

    /// The points of a class.
    #[must_use]
    pub fn of_class(&self, class: SpectralClass) -> u64 {
        self.points_where(|cell| cell.spectral_class() == class)
    }

    /// The points of a slip mode; those exactly on K = K_c are neutral and have none.
    #[must_use]
    pub fn of_mode(&self, mode: SlipMode) -> u64 {
        self.points_where(|cell| cell.slip_mode() == mode && cell.signs().transition_sign() != 0)
    }

    /// The points exactly on K = K_c.
    #[must_use]
    pub fn on_transition(&self) -> u64 {
        self.points_where(|cell| cell.signs().transition_sign() == 0)
    }

    /// The points exactly on the boundary max Im(s) = 0.
    #[must_use]
    pub fn on_boundary(&self) -> u64 {
        self.points_where(|cell| cell.signs().boundary_sign() == 0)
    }

    /// How many points each precision level decided.
    #[must_use]
    pub const fn decided_by(&self) -> PrecisionCounts {
        self.decided_by
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.by_code.iter_mut().zip(other.by_code).for_each(|(count, more)| *count += more);
        self.decided_by += other.decided_by;
    }
}

#[cfg(test)]
mod tests {
    use super::super::GridAxis;
    use super::*;
    use crate::number::Rational;
    use crate::stability::fixtures::paper;
    use crate::stability::{InertialThreshold, classify};

    fn velocity(index: u32) -> f64 {
        libm::exp10(-7.0 + 8.0 * f64::from(index) / 22.0)
    }

    fn stress(index: u32) -> f64 {
        libm::exp10(2.0 + 7.0 * f64::from(index) / 30.0)
    }

    #[test]
    fn a_streamed_grid_counts_what_point_by_point_classification_finds() {
        let (slider, threshold) = (paper(), InertialThreshold::default());
        let grid = StreamedGrid {
            slider: &slider,
            threshold: &threshold,
            loading_velocities: GridAxis { count: 23, coordinate: velocity },
            normal_stresses: GridAxis { count: 31, coordinate: stress },
        };
        let tally = Tally::of_grid(&grid, |_| ()).unwrap();
        let mut modes = [0; SlipMode::ALL.len()];
        let mut classes = Vec::new();
        for index in 0..23 * 31 {
            let [stress, velocity] =
                [stress(index % 31), velocity(index / 31)].map(|value| Rational::from_f64(value).unwrap());
            let point = slider.at(stress, velocity);
            let found = classify(&point, &threshold);
            modes[found.slip_mode as usize] += 1;
            classes.push(found.spectral_class);
        }
        assert_eq!(SlipMode::ALL.map(|mode| tally.of_mode(mode)), modes);
        assert!(modes.iter().filter(|count| **count > 0).count() >= 5, "{modes:?}");

        let class = |wanted| classes.iter().filter(|class| **class == wanted).count() as u64;
        for wanted in [SpectralClass::StableReal, SpectralClass::UnstableReal, SpectralClass::UnstableComplex]
        {
            assert_eq!(tally.of_class(wanted), class(wanted));
        }
        assert_eq!((tally.points(), tally.on_transition(), tally.on_boundary()), (23 * 31, 0, 0));
    }
}
