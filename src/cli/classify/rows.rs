//! `classify --points`: signs, class, mode, growth rate and frequency of every row.

use std::io::Write;

use slipmode::csv::{Cells, Remark, RowWork};
use slipmode::scene::Faults;
use slipmode_core::friction::Parameters;
use slipmode_core::number::{Dd, nearest_f64};
use slipmode_core::stability::batch::classify_points;
use slipmode_core::stability::{Classification, InertialThreshold, SpectralClass, classify};

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

/// A sign as a number.
const fn sign_word(sign: i8) -> &'static str {
    match sign {
        1.. => "1",
        0 => "0",
        _ => "-1",
    }
}

fn push_word(word: &str, out: &mut Vec<u8>) {
    out.push(b',');
    out.extend_from_slice(word.as_bytes());
}

/// The word of points on K = K_c, as class and as mode.
pub const NEUTRAL: &str = SpectralClass::Neutral.as_str();

impl RowWork for ClassifyRows {
    /// Reading decides every row, many of them together.
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

    /// A row by the exact values of its decimals.
    fn read(&self, cells: Cells<'_>) -> Result<Classified, Faults> {
        let parameters = cells.parameters()?;
        let found = classify(&parameters, &self.threshold);
        Ok(Classified { found, warnings: slider_warnings(parameters.map(nearest_f64)) })
    }

    /// Rows in double-double, together; those that it does not decide by the exact values.
    fn read_rows(&self, cells: &[Cells<'_>]) -> Vec<Result<Classified, Faults>> {
        let points: Vec<Option<Parameters<Dd>>> = cells.iter().map(|cells| cells.dd_parameters()).collect();
        let known: Vec<Parameters<Dd>> = points.iter().flatten().cloned().collect();
        let mut classified = classify_points(&known, &self.threshold).into_iter();
        let row = |(cells, point): (&Cells<'_>, Option<Parameters<Dd>>)| {
            let found = point.and_then(|point| classified.next().flatten().map(|found| (point, found)));
            let Some((point, found)) = found else { return self.read(*cells) };
            Ok(Classified { found, warnings: slider_warnings(point.map(Dd::hi)) })
        };
        cells.iter().zip(points).map(row).collect()
    }

    fn append(&self, Classified { found, warnings }: &Classified, out: &mut Vec<u8>) -> Remark {
        for word in [
            sign_word(found.transition_sign),
            sign_word(found.boundary_sign),
            found.spectral_class.as_str(),
            slip_mode_word(found),
        ] {
            push_word(word, out);
        }
        // A vector takes every write.
        let _ = write!(out, ",{},{}", found.max_real_per_s, found.max_imaginary_per_s);
        push_word(found.precision_level.as_str(), out);
        Remark { warning: (!warnings.is_empty()).then(|| warnings.join("; ")), ..Remark::default() }
    }
}
