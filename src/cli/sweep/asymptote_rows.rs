//! The work `asymptote-error`: how wrong the asymptotes are at the boundary's place nearest to a point, and nothing else.

use slipmode::csv::{Cells, Remark, RowWork};
use slipmode::scene::Faults;
use slipmode_core::stability::{Arc, NearestPlace};

/// Measures the asymptotes.
#[derive(Debug, Clone, Copy)]
pub struct AsymptoteRows;

impl RowWork for AsymptoteRows {
    type Input = Option<NearestPlace>;
    type Kept = ();

    const APPENDED: &'static [&'static str] =
        &["log10_normal_stress_distance", "arc", "asymptote", "asymptote_relative_error"];
    const BLOCK_ROWS: usize = 1024;
    const BLOCKS_PER_THREAD: usize = 4;

    fn needs_for_errors(&self) -> Option<&'static str> {
        Some("no errors: a sweep computes exact points; remove it")
    }

    fn read(&self, cells: Cells<'_>) -> Result<Self::Input, Faults> {
        Ok(NearestPlace::of(&cells.parameters()?))
    }

    fn append(&self, place: &Self::Input, out: &mut Vec<u8>) -> Remark {
        let text = match place {
            // As many digits as are certain of a number of the order of 1.
            Some(NearestPlace { log10_normal_stress_distance, arc, asymptote, relative_error }) => {
                let arc = if *arc == Arc::Upper { "upper" } else { "lower" };
                format!(
                    ",{log10_normal_stress_distance:.8e},{arc},{},{relative_error:.8e}",
                    asymptote.as_str()
                )
            }
            None => ",".repeat(Self::APPENDED.len()),
        };
        out.extend_from_slice(text.as_bytes());
        Remark::default()
    }
}
