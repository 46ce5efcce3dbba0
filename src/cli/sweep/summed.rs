//! Blocks of a sweep with a summary: their rows are summed up as they are made, and not kept.

use slipmode::sweep::{Blocks, RowPlaces, Summary, SummaryError, SummarySection};

use crate::cli::failure::Failure;
use crate::cli::sweep::points::{Job, Points};
use crate::cli::sweep::work::Lines;

/// How rows are summed up.
pub struct Summed {
    /// A summary of no rows.
    pub empty: Summary,
    places: RowPlaces,
}

impl Summed {
    /// Reads where the columns of rows go.
    ///
    /// # Errors
    /// When the section names a column that rows do not have.
    pub fn new(section: &SummarySection, columns: &[u8]) -> Result<Self, Failure> {
        let (empty, places) = Summary::of_rows(section, columns).map_err(refused)?;
        Ok(Self { empty, places })
    }

    /// How many bytes the summary of these rows has.
    ///
    /// # Errors
    /// When it grows too large.
    pub fn bytes(&self, rows: &Lines) -> Result<f64, Failure> {
        let mut summary = self.empty.clone();
        summary.add_rows(&self.places, &rows.text).map_err(refused)?;
        Ok((self.empty.columns().len() + summary.lines().len()) as f64)
    }

    /// The lines of a block.
    ///
    /// # Errors
    /// When the summary grows too large.
    pub fn lines(&self, points: &Points, blocks: Blocks, job: &Job) -> Result<Lines, Failure> {
        let mut summary = self.empty.clone();
        let mut unanswered = 0;
        for part in points.parts(blocks, job) {
            summary.add_rows(&self.places, &part.text).map_err(refused)?;
            unanswered += part.unanswered;
        }
        Ok(Lines { text: summary.lines(), unanswered })
    }
}

/// A summary that cannot be made.
pub fn refused(error: SummaryError) -> Failure {
    Failure::Refused(error.to_string())
}
