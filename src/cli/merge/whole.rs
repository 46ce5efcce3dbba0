//! What the blocks of a sweep are joined to.

use slipmode::sweep::Summary;

use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::sweep::block_file::{Content, Contents, OpenBlock};

/// What the blocks are joined to.
pub enum Whole {
    /// Nothing: they are only checked.
    Checked,
    /// Their rows, one block after the other.
    Rows(Output),
    /// Their summaries, added in their order.
    Summary(Box<SummaryOutput>),
}

/// A summary of all blocks so far, and where it is written at the end.
pub struct SummaryOutput {
    output: Output,
    keys: usize,
    whole: Option<Summary>,
    /// The CSV of the block that was read last.
    csv: Vec<u8>,
}

impl Whole {
    pub fn of(content: Content, output: Output) -> Self {
        match content {
            Content::Rows => Self::Rows(output),
            Content::Summary(keys) => {
                Self::Summary(Box::new(SummaryOutput { output, keys, whole: None, csv: Vec::new() }))
            }
        }
    }

    /// Copies a block's CSV; what is wrong with the block is the inner error.
    pub fn copy(&mut self, open: OpenBlock, is_first: bool) -> Result<Result<Contents, String>, Failure> {
        match self {
            Self::Checked => open.copy(true, &mut std::io::sink()),
            Self::Rows(output) => open.copy(is_first, output),
            Self::Summary(summary) => {
                summary.csv.clear();
                open.copy(true, &mut summary.csv)
            }
        }
    }

    /// Adds the summary of the block that was copied last; its rows have to be as many as its points.
    pub fn add_summary(&mut self, columns: &[u8], points: u64) -> Result<(), String> {
        let Self::Summary(summary) = self else { return Ok(()) };
        let lines = summary.csv.get(columns.len()..).unwrap_or_default();
        let whole = match &mut summary.whole {
            Some(whole) => whole,
            empty => {
                let new = Summary::of_columns(columns, summary.keys).map_err(|error| error.to_string())?;
                empty.insert(new)
            }
        };
        let rows = whole.add_summary(lines).map_err(|error| error.to_string())?;
        if rows == points { Ok(()) } else { Err(format!("sums up {rows} rows, not {points}")) }
    }

    pub fn commit(self) -> Result<(), Failure> {
        match self {
            Self::Checked => Ok(()),
            Self::Rows(output) => output.commit(),
            Self::Summary(summary) => {
                let SummaryOutput { output, whole, .. } = *summary;
                let whole = whole.ok_or_else(|| Failure::Refused("there are no blocks".into()))?;
                output.finish([whole.columns(), whole.lines()].concat())
            }
        }
    }
}
