//! `classify --points`: signs, class, mode, growth rate and frequency of every row.

use std::io::Write;

use slipmode::csv::{Cells, Remark, RowWork};
use slipmode::scene::Faults;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::{
    Classification, InertialThreshold, SpectralClass, classify, classify_quickly,
};

use crate::cli::unit_warnings::slider_warnings;

/// Classifies rows.
#[derive(Debug)]
pub struct ClassifyRows {
    /// From which ω/ω_n on an oscillation is called inertial.
    pub threshold: InertialThreshold,
}

/// A row that was read and classified.
#[derive(Debug)]
pub struct Classified {
    /// What it is.
    pub found: Classification,
    /// Values that look like another unit's.
    pub warnings: Vec<String>,
}

/// The slip mode as a word: on K = K_c it is neutral, an oscillation that neither grows nor decays.
pub fn slip_mode_word(found: &Classification) -> &'static str {
    if found.transition_sign == 0 { NEUTRAL } else { found.slip_mode.as_str() }
}

/// The word of points on K = K_c, as class and as mode.
pub const NEUTRAL: &str = SpectralClass::Neutral.as_str();

impl RowWork for ClassifyRows {
    /// Reading decides nearly every row: its short decimals are classified as they are.
    type Input = Classified;
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

    fn read(&self, cells: Cells<'_>) -> Result<Classified, Faults> {
        if let Some(short) = cells.short_parameters()
            && let Some(found) = classify_quickly(&short, &self.threshold)
        {
            return Ok(Classified { found, warnings: slider_warnings(short.map(|value| value.hi())) });
        }
        let parameters = cells.parameters()?;
        let found = classify(&parameters, &self.threshold);
        Ok(Classified { found, warnings: slider_warnings(parameters.map(nearest_f64)) })
    }

    fn append(&self, Classified { found, warnings }: &Classified, out: &mut Vec<u8>) -> Remark {
        // A vector takes every write.
        let _ = write!(
            out,
            ",{},{},{},{},{},{},{}",
            found.transition_sign,
            found.boundary_sign,
            found.spectral_class.as_str(),
            slip_mode_word(found),
            found.max_real_per_s,
            found.max_imaginary_per_s,
            found.precision_level.as_str(),
        );
        Remark { warning: (!warnings.is_empty()).then(|| warnings.join("; ")), ..Remark::default() }
    }
}
