//! The `--points` of a command: rows in, the same rows with their results out, in constant memory.
//!
//! Blocks of rows are worked on in parallel and written in the order of the file, so that the output is the same
//! bytes on any number of threads. While one batch of blocks is worked on, the next is read.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::ProgressBar;
use slipmode::csv::{Block, Counts, Header, RowReader, RowWork, Work};
use slipmode::parallel;
use slipmode::scene::{Fault, Faults, shortened, visible};

use crate::cli::dialect::DialectOptions;
use crate::cli::failure::Failure;
use crate::cli::input::open_csv;
use crate::cli::options::Arguments;
use crate::cli::output::Output;
use crate::cli::progress::Progress;
use crate::cli::terminal;

/// Columns that are not read and are named, and the longest of their names.
const MOST_NAMES: usize = 20;
const LONGEST_NAME: usize = 40;

/// The faults after which the run stops looking for more.
const MOST_FAULTS: usize = 20;

/// What becomes of the rows of `--points`.
#[derive(Debug, Args)]
pub struct RowsOptions {
    /// Where to write the rows; `-` is standard output [default: -]
    #[arg(short, long, value_name = "OUT.csv")]
    pub output: Option<PathBuf>,
    /// Give invalid rows a cell in a column `error` instead of stopping
    #[arg(long)]
    keep_going: bool,
    #[command(flatten)]
    dialect: DialectOptions,
}

impl RowsOptions {
    /// Notes the options that need rows, where there are none; those of a grid can be written, and none is at fault.
    pub fn refuse_without_points(&self, has_grid: bool, arguments: &mut Arguments) {
        let needs = "--points: without rows nothing is written to a file, and none can be at fault";
        arguments.refuse("--output", self.output.is_some() && !has_grid, needs);
        arguments.refuse("--keep-going", self.keep_going, needs);
        self.dialect.refuse(arguments, "--points: no other file is read");
    }
}

/// What is left of the rows when all are done.
#[derive(Debug)]
pub struct Done<K> {
    /// What the command kept of each row, in their order.
    pub kept: Vec<K>,
    /// The first faults of rows that were passed over.
    pub faults: Faults,
    /// The rows, counted.
    pub counts: Counts,
}

/// Works on every row of `input` (`-` is standard input) and writes where the options say.
///
/// # Errors
/// When a file cannot be opened, read or written. When a row is at fault, unless `--keep-going`: nothing is written then,
/// and the first faults are reported. A fault of the header or of the file's form always stops the run.
pub fn run<W: RowWork>(
    input: &Path,
    options: &RowsOptions,
    command: W,
    progress: Progress,
) -> Result<(), Failure> {
    // An output that cannot be written is reported before the work, not after it; a faulty header before the output.
    let rows = open_csv(input, options.dialect.dialect())?;
    let started = Started::new(rows, command, options.keep_going, progress)?;
    let mut output = Output::create(options.output.as_deref().unwrap_or(Path::new("-")))?;
    let done = started.work(&mut output)?;
    output.commit()?;
    print_remarks(&done.counts);
    Ok(())
}

/// A points file whose header is sound.
pub struct Started<W> {
    work: Work<W>,
    reader: RowReader,
    bar: ProgressBar,
}

impl<W: RowWork> Started<W> {
    /// Reads the header of a file, and prints how its columns are read.
    ///
    /// # Errors
    /// When it cannot be read, or its header is at fault.
    pub fn new(
        mut reader: RowReader,
        command: W,
        keep_going: bool,
        progress: Progress,
    ) -> Result<Self, Failure> {
        let bar = progress.bytes(reader.size());
        let file = reader.name().to_string();
        let first = reader.block(1)?;
        let header = command.read_header(&file, first.rows().next(), keep_going)?;
        print_columns(&header);
        Ok(Self { work: Work { file, header, command, keep_going }, reader, bar })
    }

    /// Works on every row.
    ///
    /// # Errors
    /// As [`run`].
    pub fn work(self, output: &mut impl Write) -> Result<Done<W::Kept>, Failure> {
        let Self { work, mut reader, bar } = self;
        output.write_all(&work.header_line())?;
        let mut done = Done { kept: Vec::new(), faults: Faults::new(), counts: Counts::default() };
        let mut faults = Faults::new();
        let mut batch = read_batch::<W>(&mut reader)?;
        while !batch.is_empty() && (work.keep_going || faults.len() < MOST_FAULTS) {
            let is_lost = !work.keep_going && !faults.is_empty();
            let (worked, next) = rayon::join(
                || parallel::map(&batch, |block| work.block(block, is_lost)),
                || read_batch::<W>(&mut reader),
            );
            for mut part in worked {
                if work.keep_going || faults.is_empty() {
                    output.write_all(&part.text)?;
                }
                faults.extend(part.faults.iter().take(MOST_FAULTS.saturating_sub(faults.len())).cloned());
                done.kept.append(&mut part.kept);
                done.counts.add(part.counts);
            }
            batch = next?;
            bar.set_position(reader.consumed());
        }
        bar.finish_and_clear();
        if !work.keep_going && !faults.is_empty() {
            return Err(Failure::Input(faults));
        }
        done.faults = faults;
        Ok(done)
    }
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

/// Prints how the columns are read, and which are not.
pub fn print_columns(header: &Header) {
    header.remarks().iter().for_each(|remark| terminal::message(&format!("in SI: {remark}")));
    print_unread(header.unread());
}

/// Prints the names of columns that are not read.
pub fn print_unread<'n>(names: impl Iterator<Item = &'n str>) {
    let mut unread: Vec<String> = names.map(|name| visible(&shortened(name, LONGEST_NAME))).collect();
    if unread.is_empty() {
        return;
    }
    let more = unread.len().saturating_sub(MOST_NAMES);
    unread.truncate(MOST_NAMES);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    terminal::message(&format!("warning: columns that are not read: {}{more}", unread.join(", ")));
}

/// Prints what is to be said of the rows after the output.
fn print_remarks(counts: &Counts) {
    let Counts { rows, faulty, unanswered, .. } = counts;
    if *faulty > 0 {
        terminal::message(&format!("{faulty} of {rows} rows have an error; see the column `error`"));
    }
    if *unanswered > 0 {
        terminal::message(&format!("{unanswered} of {rows} rows have no result; see the column `status`"));
    }
    print_warnings(counts);
}

/// Prints the first warning, and how many rows have one.
pub fn print_warnings(counts: &Counts) {
    if let Some((row, warning)) = &counts.first_warning {
        terminal::message(&format!(
            "warning: row {row}: {warning}; {} of {} rows have a warning",
            counts.with_warning, counts.rows
        ));
    }
}
