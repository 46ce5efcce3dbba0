//! `classify --points`: rows in, the same rows with their classification out, in constant memory.
//!
//! Blocks of rows are classified in parallel and written in the order of the file, so that the output is the same
//! bytes on any number of threads. While one batch of blocks is classified, the next is read.

mod cells;
mod header;
mod rows;
mod work;

use std::io::Write;
use std::path::Path;

use rayon::prelude::*;
use slipmode::scene::{Fault, Faults};
use slipmode::stability::InertialThreshold;

use crate::cli::failure::Failure;
use crate::cli::input::Input;
use crate::cli::output::{Output, machine_write};
use crate::cli::progress::Progress;
use header::Header;
use rows::{Block, RowReader};
use work::{Work, Worked, header_line};

/// Rows of a block.
const BLOCK_ROWS: usize = 2048;
/// The most faults that are reported before the run stops looking for more.
const MOST_FAULTS: usize = 20;

/// Classifies every row of `input` into `output` (`-` for the standard streams).
///
/// # Errors
/// When a file cannot be opened, read or written. When a row is at fault, unless `keep_going`: nothing is written then,
/// and up to twenty faults are reported. A fault of the header or of the file's form always stops the run.
pub fn run(
    input: &Path,
    output: &Path,
    threshold: InertialThreshold,
    keep_going: bool,
    progress: Progress,
) -> Result<(), Failure> {
    let input = Input::open(input)?;
    let bar = progress.bytes(input.size);
    let mut reader = RowReader::new(input);
    let file = reader.name().to_string();
    let first = reader.block(1)?;
    let header = Header::read(&file, first.rows().next(), keep_going)?;
    let work = Work { file, header, threshold, keep_going };
    let mut output = Output::create(output)?;
    output.write_all(&header_line(&work.header, keep_going)).map_err(|error| machine_write(&error))?;

    let mut counts = Counts::default();
    let mut faults = Faults::new();
    let mut batch = read_batch(&mut reader)?;
    while !batch.is_empty() && (keep_going || faults.len() < MOST_FAULTS) {
        let (worked, next) = rayon::join(|| classify_batch(&work, &batch), || read_batch(&mut reader));
        for part in &worked {
            counts.faulty += count_rows(&part.faults);
            faults.extend(part.faults.iter().take(MOST_FAULTS.saturating_sub(faults.len())).cloned());
            if keep_going || faults.is_empty() {
                output.write_all(&part.text).map_err(|error| machine_write(&error))?;
            }
        }
        counts.rows += batch.iter().map(|block| block.rows().count() as u64).sum::<u64>();
        batch = next?;
        bar.set_position(reader.consumed());
    }
    bar.finish_and_clear();
    if !keep_going && !faults.is_empty() {
        return Err(Failure::Input(faults));
    }
    output.commit()?;
    counts.tell();
    Ok(())
}

fn read_batch(reader: &mut RowReader) -> Result<Vec<Block>, Fault> {
    let mut batch = Vec::new();
    for _ in 0..rayon::current_num_threads() {
        let block = reader.block(BLOCK_ROWS)?;
        if block.is_empty() {
            break;
        }
        batch.push(block);
    }
    Ok(batch)
}

fn classify_batch(work: &Work, batch: &[Block]) -> Vec<Worked> {
    batch.par_iter().map(|block| work.block(block)).collect()
}

/// Rows with at least one fault; the faults of a row follow each other.
fn count_rows(faults: &[Fault]) -> u64 {
    let mut lines: Vec<_> = faults.iter().map(|fault| fault.line).collect();
    lines.dedup();
    lines.len() as u64
}

/// How many rows there were.
#[derive(Debug, Default)]
struct Counts {
    rows: u64,
    faulty: u64,
}

impl Counts {
    /// Says on standard error that rows were passed over, so that nobody takes the output for complete.
    fn tell(&self) {
        if self.faulty > 0 {
            eprintln!("{} of {} rows have an error; see the column `error`", self.faulty, self.rows);
        }
    }
}
