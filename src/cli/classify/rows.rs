//! `classify --points`: signs, class, mode, growth rate and frequency of every row.

use std::io::Write;

use slipmode::csv::{Cells, Remark, RowWork};
use slipmode::scene::{Faults, Problem};
use slipmode_core::stability::{Classification, InertialThreshold, classify, classify_quickly};

/// Classifies rows.
#[derive(Debug)]
pub struct ClassifyRows {
    /// From which ω/ω_n on an oscillation is called inertial.
    pub threshold: InertialThreshold,
}

impl RowWork for ClassifyRows {
    /// Reading decides nearly every row: its short decimals are classified as they are.
    type Input = Classification;
    type Kept = ();

    const APPENDED: &'static [&'static str] = &[
        "transition_sign",
        "boundary_sign",
        "spectral_class",
        "slip_mode",
        "max_real_per_s",
        "max_imaginary_per_s",
        "rung",
    ];
    const BLOCK_ROWS: usize = 2048;
    const BLOCKS_PER_THREAD: usize = 1;

    fn header_faults(&self, _names: &[String]) -> Vec<(String, Problem)> {
        Vec::new()
    }

    fn read(&self, cells: Cells<'_>) -> Result<Classification, Faults> {
        match cells.short_parameters().and_then(|short| classify_quickly(&short, &self.threshold)) {
            Some(found) => Ok(found),
            None => Ok(classify(&cells.parameters()?, &self.threshold)),
        }
    }

    fn append(&self, found: &Classification, out: &mut Vec<u8>) -> Remark {
        // A vector takes every write.
        let _ = write!(
            out,
            ",{},{},{},{},{},{},{}",
            found.transition_sign,
            found.boundary_sign,
            found.spectral_class.as_str(),
            found.slip_mode.as_str(),
            found.max_real_per_s,
            found.max_imaginary_per_s,
            found.precision_level.as_str(),
        );
        Remark::default()
    }
}
