//! The points of a sweep from both kinds of source, block by block.

use std::path::{Path, PathBuf};

use slipmode::sweep::{Blocks, Shard};

use crate::cli::failure::Failure;
use crate::cli::input::Input;
use crate::cli::points::{Block, Header, RowReader, RowWork, Work};
use crate::cli::sweep::work::{Lines, Made, PointWork, listed_lines};

/// The most blocks, each of which is a file.
const MOST_BLOCKS: u64 = 10_000_000;

/// Where points come from, with the work at each.
pub enum Points<W> {
    /// From the scene.
    Made(Box<Made<W>>),
    /// From a CSV file.
    Listed(Listed<W>),
}

/// The rows of a CSV file.
pub struct Listed<W> {
    place: PathBuf,
    work: Work<W>,
    rows: u64,
}

/// A block to be worked on.
pub struct Job {
    /// Its number.
    pub block: u64,
    rows: Option<Block>,
}

/// Points of a part of a block whose rows are not kept.
const PART_POINTS: u64 = 1 << 12;
/// Rows read at a time where they are only counted.
const COUNTED_ROWS: usize = 4096;

impl<W: RowWork> Listed<W> {
    /// Reads the header of a file and counts its rows.
    ///
    /// # Errors
    /// When it cannot be read, or its header or form is at fault.
    pub fn new(place: &Path, command: W) -> Result<Self, Failure> {
        let mut reader = RowReader::new(Input::open(place)?);
        let file = reader.name().to_string();
        let first = reader.block(1)?;
        // A faulty row gets a cell that says so: one of them must not cost the others their results.
        let keep_going = true;
        let header = Header::read(&file, first.rows().next(), keep_going, &command)?;
        let mut rows = 0;
        loop {
            let block = reader.block(COUNTED_ROWS)?;
            if block.is_empty() {
                break;
            }
            rows += block.rows().count() as u64;
        }
        Ok(Self { place: place.to_path_buf(), work: Work { file, header, command, keep_going }, rows })
    }

    /// A reader behind the header.
    fn reader(&self) -> Result<RowReader, Failure> {
        let mut reader = RowReader::new(Input::open(&self.place)?);
        reader.block(1)?;
        Ok(reader)
    }
}

impl<W: PointWork> Points<W> {
    /// The blocks of the sweep.
    ///
    /// # Errors
    /// When there are more of them than a folder should hold.
    pub fn blocks(&self, block_points: u64) -> Result<Blocks, Failure> {
        let points = match self {
            Self::Made(made) => made.count(),
            Self::Listed(listed) => listed.rows,
        };
        let blocks = Blocks { points, block_points };
        match blocks.count() {
            0 => Err(Failure::Refused("the sweep has no points".into())),
            count if count > MOST_BLOCKS => Err(Failure::Refused(format!(
                "{points} points make {count} blocks of {block_points} (allowed: at most {MOST_BLOCKS} blocks; \
                 sweep.block_points sets their size)"
            ))),
            _ => Ok(blocks),
        }
    }

    /// The line of column names.
    pub fn columns(&self) -> Vec<u8> {
        match self {
            Self::Made(made) => made.columns(),
            Self::Listed(listed) => listed.work.header_line(),
        }
    }

    /// The blocks of a shard in their order, those of a list with their rows.
    ///
    /// # Errors
    /// When the list cannot be opened.
    pub fn jobs(
        &self,
        blocks: Blocks,
        shard: Shard,
    ) -> Result<Box<dyn Iterator<Item = Result<Job, Failure>> + Send>, Failure> {
        match self {
            Self::Made(_) => Ok(Box::new(blocks.of_shard(shard).map(|block| Ok(Job { block, rows: None })))),
            Self::Listed(listed) => {
                let mut reader = listed.reader()?;
                let read = move |block: u64| -> Result<Option<Job>, Failure> {
                    let range = blocks.range(block);
                    let wanted = usize::try_from(range.end - range.start).unwrap_or(usize::MAX);
                    let rows = reader.block(wanted)?;
                    if rows.rows().count() != wanted {
                        return Err(Failure::Refused(format!(
                            "{}: changed while it was read",
                            reader.name()
                        )));
                    }
                    let is_ours = Shard::of_block(block, shard.count) == shard.index;
                    Ok(is_ours.then_some(Job { block, rows: Some(rows) }))
                };
                Ok(Box::new((0..blocks.count()).map(read).filter_map(Result::transpose)))
            }
        }
    }

    /// The lines of a block.
    pub fn lines(&self, blocks: Blocks, job: &Job) -> Lines {
        match (self, &job.rows) {
            (Self::Listed(listed), Some(rows)) => listed_lines(&listed.work, rows),
            (Self::Made(made), _) => made.lines(blocks.range(job.block)),
            (Self::Listed(_), None) => Lines::default(),
        }
    }

    /// The lines of a block in parts that take little memory; those of a list, whose rows were read already, in one.
    pub fn parts(&self, blocks: Blocks, job: &Job) -> impl Iterator<Item = Lines> {
        let range = blocks.range(job.block);
        let step = if job.rows.is_some() { u64::MAX } else { PART_POINTS };
        let starts = std::iter::successors(Some(range.start), move |start| start.checked_add(step))
            .take_while(move |start| *start < range.end);
        starts.map(move |start| match self {
            Self::Made(made) => made.lines(start..range.end.min(start.saturating_add(step))),
            Self::Listed(_) => self.lines(blocks, job),
        })
    }

    /// The lines of `count` points spread evenly over the sweep, or of a list's first rows; and how many they are.
    ///
    /// # Errors
    /// When the list cannot be read.
    pub fn sample(&self, blocks: Blocks, count: u64) -> Result<(Lines, u64), Failure> {
        let count = count.clamp(1, blocks.points);
        match self {
            Self::Made(made) => {
                let number =
                    |index| (u128::from(blocks.points) * (2 * index + 1) / (2 * u128::from(count))) as u64;
                Ok((made.lines((0..u128::from(count)).map(number)), count))
            }
            Self::Listed(listed) => {
                let rows = listed.reader()?.block(usize::try_from(count).unwrap_or(usize::MAX))?;
                Ok((listed_lines(&listed.work, &rows), count))
            }
        }
    }
}
