//! `slipmode merge`: every block exactly once, of one scene and one program; otherwise a refusal that names what is wrong.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::sweep::{Shard, Summary, SummaryError, array_string};

use crate::cli::failure::Failure;
use crate::cli::options::Arguments;
use crate::cli::output::{Output, machine_write};
use crate::cli::sweep::MOST_SHARDS;
use crate::cli::sweep::block_file::{Content, OpenBlock, Origin, Unsound, block_name, block_of_name};
use crate::cli::sweep::summed::refused;
use crate::cli::terminal;

/// Options of `merge`.
#[derive(Debug, Args)]
pub struct Options {
    /// The folder of the blocks
    folder: PathBuf,
    /// Where to write the rows; `-` is standard output
    #[arg(short, long, value_name = "OUT.csv", default_value = "-", conflicts_with = "missing")]
    output: PathBuf,
    /// Only print the shards whose blocks are missing or damaged, as an array string; nothing if all blocks are valid
    #[arg(long)]
    missing: bool,
    /// Number of shards, used to name the missing ones [default: as many as blocks]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    shards: Option<String>,
}

/// The most faults that are reported before the rest is left out.
const MOST_FAULTS: usize = 20;

/// Runs the command.
///
/// # Errors
/// With exit code 1 when blocks are missing; with 2 when one is damaged or belongs elsewhere, or a file cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let shards = arguments.whole("--shards", options.shards.as_deref(), 1..=MOST_SHARDS);
    arguments.finish()?;
    let folder = Folder::read(&options.folder)?;
    let shards = shards.unwrap_or(folder.origin.blocks);
    let found = folder.look(shards, options.missing)?;
    if options.missing {
        if let Some(refusal) = refusal(&found.foreign) {
            return Err(refusal);
        }
        let missing = array_string(found.missing.union(&found.damaged_shards).copied());
        return terminal::print(&if missing.is_empty() { missing } else { format!("{missing}\n") });
    }
    if let Some(refusal) = refusal(&[found.foreign, found.damaged].concat()) {
        return Err(refusal);
    }
    if !found.missing.is_empty() {
        let missing = array_string(found.missing);
        return Err(Failure::Check(format!(
            "{}: {} of {} blocks are missing; the shards to run, of {shards}: {missing}",
            options.folder.display(),
            found.missing_blocks,
            folder.origin.blocks,
        )));
    }
    folder.write(&options.output)
}

/// A folder of blocks.
struct Folder<'f> {
    place: &'f Path,
    origin: Origin,
    reference: u64,
    last: u64,
    strays: Vec<String>,
}

/// What is wrong with the blocks.
#[derive(Default)]
struct Found {
    /// The shards of blocks that are not there.
    missing: BTreeSet<u64>,
    missing_blocks: u64,
    /// The shards of blocks that do not hold.
    damaged_shards: BTreeSet<u64>,
    damaged: Vec<String>,
    /// Blocks of another scene, program version or number of blocks, and files that are no block of this sweep.
    foreign: Vec<String>,
}

/// One refusal of all faults, the first twenty reported.
fn refusal(faults: &[String]) -> Option<Failure> {
    let mut lines: Vec<String> = faults.iter().take(MOST_FAULTS).cloned().collect();
    if faults.len() > MOST_FAULTS {
        lines.push("and more like these".into());
    }
    (!lines.is_empty()).then(|| Failure::Refused(lines.join("\n")))
}

impl<'f> Folder<'f> {
    /// Looks through a folder for the first block with a sound heading: it says what the others have to be.
    fn read(place: &'f Path) -> Result<Self, Failure> {
        let cannot = |error| Failure::io(place, "cannot be read", &error);
        let mut first: Option<(u64, Origin)> = None;
        let mut last = 0;
        let mut strays = Vec::new();
        for entry in fs::read_dir(place).map_err(cannot)? {
            let name = entry.map_err(cannot)?.file_name();
            let name = name.to_string_lossy();
            let block = block_of_name(&name);
            last = last.max(block.unwrap_or_default());
            match block {
                Some(block) if first.as_ref().is_none_or(|(least, _)| block < *least) => {
                    if let Ok(open) = OpenBlock::open(place, block) {
                        first = Some((block, open.heading.origin));
                    }
                }
                None if name.starts_with("block-") => strays.push(name.into_owned()),
                _ => {}
            }
        }
        strays.sort();
        let none = || Failure::Refused(format!("{}: has no valid block; run every shard", place.display()));
        let (reference, origin) = first.ok_or_else(none)?;
        Ok(Self { place, origin, reference, last, strays })
    }

    fn naming(&self, name: &str, reason: &str) -> String {
        format!("{}: {reason}", self.place.join(name).display())
    }

    /// Looks at every block; at its content too when `thoroughly`.
    fn look(&self, shards: u64, thoroughly: bool) -> Result<Found, Failure> {
        let stray = |name: &String| self.naming(name, "is not the name of a block: a copy?");
        let mut found = Found { foreign: self.strays.iter().map(stray).collect(), ..Found::default() };
        if self.last >= self.origin.blocks {
            let beyond = format!("is beyond the {} blocks of this sweep", self.origin.blocks);
            found.foreign.push(self.naming(&block_name(self.last), &beyond));
        }
        for block in 0..self.origin.blocks {
            let shard = Shard::of_block(block, shards);
            match self.state(block, thoroughly)? {
                State::Sound => {}
                State::Missing => {
                    found.missing.insert(shard);
                    found.missing_blocks += 1;
                }
                State::Damaged(reason) => {
                    found.damaged_shards.insert(shard);
                    keep(&mut found.damaged, reason);
                }
                State::Foreign(reason) => keep(&mut found.foreign, reason),
            }
        }
        Ok(found)
    }

    fn state(&self, block: u64, thoroughly: bool) -> Result<State, Failure> {
        let name = block_name(block);
        let open = match OpenBlock::open(self.place, block) {
            Ok(open) => open,
            Err(Unsound::Missing) => return Ok(State::Missing),
            Err(Unsound::Damaged(reason)) => return Ok(State::Damaged(self.naming(&name, &reason))),
            Err(Unsound::Unreadable(error)) => {
                return Err(Failure::io(&self.place.join(name), "cannot be read", &error));
            }
        };
        if let Some(difference) = open.heading.origin.difference(&self.origin) {
            let beside = format!("{difference}, as in {}", block_name(self.reference));
            return Ok(State::Foreign(self.naming(&name, &beside)));
        }
        if thoroughly && let Err(Unsound::Damaged(reason)) = open.copy(true, &mut std::io::sink())? {
            return Ok(State::Damaged(self.naming(&name, &reason)));
        }
        Ok(State::Sound)
    }

    /// Writes all blocks one after the other, or their summaries put together; each is compared with its digest on the way.
    fn write(&self, output: &Path) -> Result<(), Failure> {
        let mut output = Output::create(output)?;
        match self.origin.content {
            Content::Rows => {
                for block in 0..self.origin.blocks {
                    self.copy(block, block == 0, &mut output)?;
                }
            }
            Content::Summary(keys) => {
                let summary = self.summary(keys)?;
                let written = output.write_all(&summary.columns()).and(output.write_all(&summary.lines()));
                written.map_err(|error| machine_write(&error))?;
            }
        }
        output.commit()
    }

    /// The summaries of all blocks, added in their order.
    fn summary(&self, keys: usize) -> Result<Summary, Failure> {
        let mut whole: Option<Summary> = None;
        for block in 0..self.origin.blocks {
            let mut text = Vec::new();
            let columns = self.copy(block, true, &mut text)?;
            let (columns, lines) = text.split_at(columns.min(text.len()));
            if whole.is_none() {
                whole = Some(Summary::of_columns(columns, keys).map_err(refused)?);
            }
            if let Some(whole) = &mut whole {
                let named = |error: SummaryError| {
                    Failure::Refused(self.naming(&block_name(block), &error.to_string()))
                };
                whole.add_summary(lines).map_err(named)?;
            }
        }
        whole.ok_or_else(|| Failure::Refused("there are no blocks".into()))
    }

    /// Copies a block's CSV and returns the length of its line of column names.
    fn copy(&self, block: u64, with_columns: bool, out: &mut impl Write) -> Result<usize, Failure> {
        let gone = |reason: &str| Failure::Refused(self.naming(&block_name(block), reason));
        let Ok(open) = OpenBlock::open(self.place, block) else {
            return Err(gone("changed while the blocks were merged"));
        };
        let columns = usize::try_from(open.heading.columns).unwrap_or(usize::MAX);
        match open.copy(with_columns, out)? {
            Err(Unsound::Damaged(reason)) => Err(gone(&reason)),
            _ => Ok(columns),
        }
    }
}

/// How one block is.
enum State {
    Sound,
    Missing,
    Damaged(String),
    Foreign(String),
}

/// Keeps one fault more than are reported, so that memory does not grow with the blocks.
fn keep(faults: &mut Vec<String>, fault: String) {
    if faults.len() <= MOST_FAULTS {
        faults.push(fault);
    }
}
