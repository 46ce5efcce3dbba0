//! Grids of any size in constant memory: blocks of rows are classified, counted, and forgotten.
//!
//! The σ axis is cut into blocks; for each, the rows of constant V0 are classified in parallel. What is kept is one block of
//! coordinates and one row of cells per thread.

use std::ops::AddAssign;

use rug::Rational;

use super::grid::GridKernel;
use super::parallel;
use super::{GridCell, PrecisionCounts};
use crate::friction::Slider;
use crate::stability::{InertialThreshold, SlipMode, SpectralClass};

/// The most σ of a block: its coordinates fit the second-level cache, and a row's preparation is a small part of its work.
const BLOCK: u32 = 1 << 15;

/// One axis of a streamed grid: the number of coordinates, and each by its index, in SI.
#[derive(Debug, Clone, Copy)]
pub struct GridAxis<F> {
    /// How many coordinates there are.
    pub count: u32,
    /// The coordinate of an index below `count`.
    pub coordinate: F,
}

/// What is classified.
#[derive(Debug, Clone, Copy)]
pub struct StreamedGrid<'a, V, S> {
    /// Material and machine.
    pub slider: &'a Slider<Rational>,
    /// From which ω/ω_n on an oscillation is called inertial.
    pub threshold: &'a InertialThreshold,
    /// V0, m/s.
    pub loading_velocities: GridAxis<V>,
    /// σ, Pa.
    pub normal_stresses: GridAxis<S>,
}

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

impl<V, S> StreamedGrid<'_, V, S>
where
    V: Fn(u32) -> f64 + Sync,
    S: Fn(u32) -> f64 + Sync,
{
    /// Classifies every point exactly and counts, in memory that does not depend on the number of points; `tick` hears of
    /// every block of a row.
    ///
    /// `None` unless every coordinate is positive and finite.
    #[must_use]
    pub fn tally(&self, tick: impl Fn(u64) + Sync) -> Option<Tally> {
        let stresses = &self.normal_stresses;
        let mut total = Tally::default();
        for first in (0..stresses.count).step_by(BLOCK as usize) {
            let width = BLOCK.min(stresses.count - first);
            let coordinates: Vec<f64> = parallel::map((first..first + width).collect(), &stresses.coordinate);
            let kernel = GridKernel::new(self.slider, self.threshold, &coordinates)?;
            total += self.tally_rows(&kernel, &tick)?;
        }
        Some(total)
    }

    fn tally_rows(&self, kernel: &GridKernel, tick: &(impl Fn(u64) + Sync)) -> Option<Tally> {
        let axis = &self.loading_velocities;
        parallel::fold_in_stretches(
            axis.count,
            || (Tally::default(), vec![GridCell::UNDECIDED; kernel.width()]),
            |(mut sum, mut cells), loading_velocity| {
                sum.decided_by += kernel.classify_row((axis.coordinate)(loading_velocity), &mut cells)?;
                sum.count(&cells);
                tick(cells.len() as u64);
                Some((sum, cells))
            },
            |(sum, _)| sum,
            |mut left, right| {
                left += right;
                left
            },
        )
    }
}

impl Tally {
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
    pub(crate) fn points_where(&self, wanted: impl Fn(GridCell) -> bool) -> u64 {
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
    use super::*;
    use crate::stability::classify;
    use crate::stability::fixtures::paper;

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
        let tally = grid.tally(|_| ()).unwrap();
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

    fn points_of(velocities: u32, stresses: u32) -> (Tally, u64) {
        let (slider, threshold) = (paper(), InertialThreshold::default());
        let grid = StreamedGrid {
            slider: &slider,
            threshold: &threshold,
            loading_velocities: GridAxis { count: velocities, coordinate: |i| 1e-6 * f64::from(i + 1) },
            normal_stresses: GridAxis { count: stresses, coordinate: |i| 1e3 + f64::from(i) },
        };
        let ticks = std::sync::atomic::AtomicU64::new(0);
        let tally = grid.tally(|points| _ = ticks.fetch_add(points, std::sync::atomic::Ordering::Relaxed));
        (tally.unwrap(), ticks.into_inner())
    }

    #[cfg(feature = "rayon")]
    #[test]
    fn every_block_is_counted_once_on_any_number_of_threads() {
        let width = BLOCK + 7;
        let (expected, _) = points_of(3, width);
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let (tally, ticks) = pool.install(|| points_of(3, width));
            assert_eq!((tally.points(), ticks), (3 * u64::from(width), 3 * u64::from(width)));
            assert_eq!(tally, expected);
        }
        assert_eq!((points_of(0, 3), points_of(3, 0)), ((Tally::default(), 0), (Tally::default(), 0)));
    }

    #[test]
    fn a_coordinate_that_is_not_positive_ends_the_count() {
        let (slider, threshold) = (paper(), InertialThreshold::default());
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let at = move |i: u32| if i == 2 { bad } else { 1.0 };
            let one = |_: u32| 1.0;
            let grid = StreamedGrid {
                slider: &slider,
                threshold: &threshold,
                loading_velocities: GridAxis { count: 3, coordinate: at },
                normal_stresses: GridAxis { count: 3, coordinate: one },
            };
            assert!(grid.tally(|_| ()).is_none());
            let grid = StreamedGrid {
                slider: &slider,
                threshold: &threshold,
                loading_velocities: GridAxis { count: 3, coordinate: one },
                normal_stresses: GridAxis { count: 3, coordinate: at },
            };
            assert!(grid.tally(|_| ()).is_none());
        }
    }
}
