//! The `--points` of a command: rows in, the same rows with their results out, in constant memory.
//!
//! Blocks of rows are worked on in parallel and written in the order of the file, so that the output is the same
//! bytes on any number of threads. While one batch of blocks is worked on, the next is read.

mod cells;
mod header;
mod row_work;
mod rows;
mod work;

use std::io::Write;
use std::path::Path;

use rayon::prelude::*;
use slipmode::scene::{Fault, Faults};

use crate::cli::failure::Failure;
use crate::cli::input::Input;
use crate::cli::output::{Output, machine_write};
use crate::cli::progress::Progress;
pub use cells::push_cell;
use header::Header;
pub use row_work::{Cells, Remark, RowWork};
use rows::{Block, RowReader};
use work::{Work, Worked};

/// The most faults that are reported before the run stops looking for more.
const MOST_FAULTS: usize = 20;

/// Works on every row of `input` and writes to `output` (`-` for the standard streams).
///
/// # Errors
/// When a file cannot be opened, read or written. When a row is at fault, unless `keep_going`: nothing is written then,
/// and up to twenty faults are reported. A fault of the header or of the file's form always stops the run.
pub fn run<W: RowWork>(
    input: &Path,
    output: &Path,
    command: W,
    keep_going: bool,
    progress: Progress,
) -> Result<(), Failure> {
    let input = Input::open(input)?;
    let bar = progress.bytes(input.size);
    let mut reader = RowReader::new(input);
    let file = reader.name().to_string();
    let first = reader.block(1)?;
    let header = Header::read(&file, first.rows().next(), keep_going, &command)?;
    let work = Work { file, header, command, keep_going };
    let mut output = Output::create(output)?;
    output.write_all(&work.header_line()).map_err(|error| machine_write(&error))?;

    let mut counts = Counts::default();
    let mut faults = Faults::new();
    let mut batch = read_batch::<W>(&mut reader)?;
    while !batch.is_empty() && (keep_going || faults.len() < MOST_FAULTS) {
        let is_lost = !keep_going && !faults.is_empty();
        let (worked, next) =
            rayon::join(|| work_batch(&work, &batch, is_lost), || read_batch::<W>(&mut reader));
        for part in worked {
            if keep_going || faults.is_empty() {
                output.write_all(&part.text).map_err(|error| machine_write(&error))?;
            }
            faults.extend(part.faults.iter().take(MOST_FAULTS.saturating_sub(faults.len())).cloned());
            counts.add(part);
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

fn read_batch<W: RowWork>(reader: &mut RowReader) -> Result<Vec<Block>, Fault> {
    let mut batch = Vec::new();
    for _ in 0..rayon::current_num_threads() * W::BLOCKS_PER_THREAD {
        let block = reader.block(W::BLOCK_ROWS)?;
        if block.is_empty() {
            break;
        }
        batch.push(block);
    }
    Ok(batch)
}

fn work_batch<W: RowWork>(work: &Work<W>, batch: &[Block], only_read: bool) -> Vec<Worked> {
    batch.par_iter().with_max_len(1).map(|block| work.block(block, only_read)).collect()
}

/// Rows with at least one fault; the faults of a row follow each other.
fn count_rows(faults: &[Fault]) -> u64 {
    let mut lines: Vec<_> = faults.iter().map(|fault| fault.line).collect();
    lines.dedup();
    lines.len() as u64
}

/// How many rows there were, and how many of them need a word.
#[derive(Debug, Default)]
struct Counts {
    rows: u64,
    faulty: u64,
    unanswered: u64,
    doubtful: u64,
    first_doubt: Option<(u64, String)>,
}

impl Counts {
    fn add(&mut self, part: Worked) {
        self.faulty += count_rows(&part.faults);
        self.unanswered += part.unanswered;
        self.doubtful += part.doubtful;
        self.first_doubt = self.first_doubt.take().or(part.first_doubt);
    }

    /// Says on standard error that rows were passed over, so that nobody takes the output for complete.
    fn tell(&self) {
        if self.faulty > 0 {
            eprintln!("{} of {} rows have an error; see the column `error`", self.faulty, self.rows);
        }
        if self.unanswered > 0 {
            eprintln!("{} of {} rows have no answer; see the column `status`", self.unanswered, self.rows);
        }
        if let Some((row, doubt)) = &self.first_doubt {
            eprintln!("warning: row {row}: {doubt}; {} of {} rows have a warning", self.doubtful, self.rows);
        }
    }
}
