//! Exact slip modes compared with the simplified map of the asymptotes (fig 7).

pub(crate) mod figures;
pub(crate) mod run;
pub(crate) mod tables;

pub use run::{InertialLine, ThresholdShare, ZonesOutcome};

use crate::experiments::map::run::classify_rectangle;
use crate::experiments::{Work, experiment};
use crate::scene::Rectangle;

experiment! {
    /// `[zones]`: the points whose slip modes are compared.
    pub struct ZonesSection {
        /// The grid.
        pub rectangle: Rectangle = |section, _| section.rectangle(),
    }
    points: |section| section.rectangle.points(),
    outcome: ZonesOutcome,
    tables: [tables::TABLES],
    figures: [figures::FIGURES],
    work: |section| Work::map(&section.rectangle),
    run: |section, earlier, _| {
        let slider = earlier.slider()?;
        // A map of the same rectangle has the exact half already.
        let same = earlier.scene.map.as_ref().is_some_and(|map| map.rectangle == section.rectangle);
        Some(match earlier.map.as_ref().filter(|_| same) {
            Some(map) => run::compare_zones(slider, map),
            None => run::compare_zones(slider, &classify_rectangle(slider, &section.rectangle, &earlier.scene.threshold())),
        })
    },
}
