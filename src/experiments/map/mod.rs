//! max Im(s), spectral class and slip mode on a (V, σ) grid (figs 1, 6a and 7).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

use crate::experiments::shared::Grid;
use crate::experiments::{Work, experiment};
use crate::scene::Rectangle;
use slipmode_core::stability::Classification;

experiment! {
    /// `[map]`: the points that are classified.
    pub struct MapSection {
        /// The grid.
        pub rectangle: Rectangle = |section, _| section.rectangle(),
    }
    points: |section| section.rectangle.points(),
    outcome: Grid<Classification>,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| Work::map(&section.rectangle),
    run: |section, earlier, _| Some(run::classify_rectangle(earlier.slider()?, &section.rectangle, &earlier.scene.threshold())),
}
