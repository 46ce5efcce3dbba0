//! Grids of any size in constant memory: blocks of rows are classified, handed to a fold, and forgotten.
//!
//! The σ axis is cut into blocks; for each, the rows of constant V0 are classified in parallel. What is kept is one block of
//! coordinates and one row of cells per thread.

use rug::Rational;

use super::grid::GridKernel;
use super::parallel;
use super::{GridCell, PrecisionCounts};
use crate::friction::Slider;
use crate::stability::InertialThreshold;

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

/// Part of a row of constant V0, classified.
#[derive(Debug, Clone, Copy)]
pub struct RowBlock<'a> {
    /// The index of V0.
    pub loading_velocity: u32,
    /// The index of the first cell's σ; the others follow.
    pub first_normal_stress: u32,
    /// The cells.
    pub cells: &'a [GridCell],
    /// How many of them each precision level decided.
    pub decided_by: PrecisionCounts,
}

impl<V, S> StreamedGrid<'_, V, S>
where
    V: Fn(u32) -> f64 + Sync,
    S: Fn(u32) -> f64 + Sync,
{
    /// Classifies every point exactly and folds the blocks, in memory that does not depend on the number of points.
    ///
    /// Blocks reach `fold` and `merge` in a fixed order (σ block by σ block, V0 by V0), cut at places that depend on the
    /// threads: the result does not depend on them when `merge` is associative with `empty` as its neutral element.
    /// `None` unless every coordinate is positive and finite.
    pub fn fold<T: Send>(
        &self,
        empty: impl Fn() -> T + Sync,
        fold: impl Fn(T, RowBlock<'_>) -> T + Sync,
        merge: impl Fn(T, T) -> T + Sync,
    ) -> Option<T> {
        let stresses = &self.normal_stresses;
        let mut total = empty();
        for first in (0..stresses.count).step_by(BLOCK as usize) {
            let width = BLOCK.min(stresses.count - first);
            let coordinates: Vec<f64> = parallel::map((first..first + width).collect(), &stresses.coordinate);
            let kernel = GridKernel::new(self.slider, self.threshold, &coordinates)?;
            total = merge(total, self.fold_rows(first, &kernel, &empty, &fold, &merge)?);
        }
        Some(total)
    }

    fn fold_rows<T: Send>(
        &self,
        first_normal_stress: u32,
        kernel: &GridKernel,
        empty: &(impl Fn() -> T + Sync),
        fold: &(impl Fn(T, RowBlock<'_>) -> T + Sync),
        merge: &(impl Fn(T, T) -> T + Sync),
    ) -> Option<T> {
        let axis = &self.loading_velocities;
        let scratch = || vec![GridCell::UNDECIDED; kernel.width()];
        parallel::fold_in_stretches(
            axis.count,
            || (empty(), scratch()),
            |(sum, mut cells): (T, Vec<GridCell>), loading_velocity| {
                let decided_by = kernel.classify_row((axis.coordinate)(loading_velocity), &mut cells)?;
                let block = RowBlock { loading_velocity, first_normal_stress, cells: &cells, decided_by };
                Some((fold(sum, block), cells))
            },
            |(sum, _)| sum,
            merge,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::fixtures::paper;

    fn indices(velocities: u32, stresses: u32) -> Vec<(u32, u32, usize)> {
        let (slider, threshold) = (paper(), InertialThreshold::default());
        let grid = StreamedGrid {
            slider: &slider,
            threshold: &threshold,
            loading_velocities: GridAxis { count: velocities, coordinate: |i| 1e-6 * f64::from(i + 1) },
            normal_stresses: GridAxis { count: stresses, coordinate: |i| 1e3 + f64::from(i) },
        };
        let note = |mut seen: Vec<_>, block: RowBlock<'_>| {
            seen.push((block.first_normal_stress, block.loading_velocity, block.cells.len()));
            seen
        };
        grid.fold(Vec::new, note, |left, right| [left, right].concat()).unwrap()
    }

    #[cfg(feature = "rayon")]
    #[test]
    fn blocks_come_once_and_in_order_on_any_number_of_threads() {
        let width = BLOCK + 7;
        let expected: Vec<_> = [(0, BLOCK as usize), (BLOCK, 7)]
            .into_iter()
            .flat_map(|(first, cells)| (0..3).map(move |velocity| (first, velocity, cells)))
            .collect();
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            assert_eq!(pool.install(|| indices(3, width)), expected);
        }
        assert!(indices(0, 3).is_empty() && indices(3, 0).is_empty());
    }

    #[test]
    fn a_coordinate_that_is_not_positive_ends_the_fold() {
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
            assert!(grid.fold(|| (), |(), _| (), |(), ()| ()).is_none());
            let grid = StreamedGrid {
                slider: &slider,
                threshold: &threshold,
                loading_velocities: GridAxis { count: 3, coordinate: one },
                normal_stresses: GridAxis { count: 3, coordinate: at },
            };
            assert!(grid.fold(|| (), |(), _| (), |(), ()| ()).is_none());
        }
    }
}
