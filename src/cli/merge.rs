//! `slipmode merge`: every block exactly once, of one scene and one program; otherwise a refusal that names what is wrong.

mod whole;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;
use slipmode::sweep::{Shard, array_string};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::options::Arguments;
use crate::cli::output::Output;
use crate::cli::path_text::{json_path, shown_path};
use crate::cli::sweep::MOST_SHARDS;
use crate::cli::sweep::block_file::{Contents, Heading, OpenBlock, Origin, block_name, block_of_name};
use whole::Whole;

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
    /// One JSON object instead of text: blocks, and shards to run; needs a file for the rows, or --missing
    #[arg(long)]
    json: bool,
}

/// The most faults that are reported one by one.
const MOST_FAULTS: usize = 20;

/// Runs the command.
///
/// # Errors
/// With exit code 1 when blocks are missing; with 2 when one is damaged or belongs elsewhere, or a file cannot be written.
pub fn run(options: &Options) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let shards = arguments.whole("--shards", options.shards.as_deref(), 1..=MOST_SHARDS);
    let rows = Some(options.output.as_path()).filter(|_| options.json && !options.missing);
    arguments.refuse_stream("--output", rows, "the object");
    let shards = arguments.finish(Some(shards))?;
    let folder = Folder::read(&options.folder)?;
    let shards = shards.unwrap_or(folder.origin.blocks);
    if options.missing {
        let found = folder.join(shards, Whole::Checked)?.0;
        if let Some(refusal) = refusal(&found.foreign) {
            return Err(refusal);
        }
        let missing: BTreeSet<u64> = found.missing.union(&found.damaged_shards).copied().collect();
        let line = array_string(missing.clone());
        let line = if line.is_empty() { line } else { format!("{line}\n") };
        return options.answer(&folder, shards, &missing).text(&line).print(options.json);
    }
    let whole = Whole::of(folder.origin.content, Output::create(&options.output)?);
    let (found, whole) = folder.join(shards, whole)?;
    if let Some(refusal) = refusal(&[found.foreign, found.damaged].concat()) {
        return Err(refusal);
    }
    // Without --json nothing is printed: standard output may have the rows.
    let answer = options.answer(&folder, shards, &found.missing);
    if !found.missing.is_empty() {
        answer.print(options.json)?;
        let missing = array_string(found.missing);
        return Err(Failure::Check(format!(
            "{}: {} of {} blocks are missing; the shards to run, of {shards}: {missing}",
            shown_path(&options.folder),
            found.missing_blocks,
            folder.origin.blocks,
        )));
    }
    whole.commit()?;
    answer.print(options.json)
}

impl Options {
    /// States the sweep, and the shards that are to run.
    fn answer(&self, folder: &Folder<'_>, shards: u64, missing: &BTreeSet<u64>) -> Answer {
        Answer::to(json!({ "folder": json_path(&self.folder), "shards": shards }))
            .with("version", &folder.origin.version)
            .with("scene_sha256", &folder.origin.scene)
            .with("blocks", folder.origin.blocks)
            .with("missing_shards", missing)
            .with("output", (!self.missing && missing.is_empty()).then(|| json_path(&self.output)))
    }
}

/// A folder of blocks.
struct Folder<'f> {
    place: &'f Path,
    present: BTreeSet<u64>,
    strays: Vec<String>,
    /// The first block whose digest is right: it says what the others have to be.
    reference: u64,
    origin: Origin,
    points: u64,
    columns: Vec<u8>,
}

/// What is wrong with the blocks.
#[derive(Default)]
struct BlockFaults {
    /// The shards of blocks that are not there.
    missing: BTreeSet<u64>,
    missing_blocks: u64,
    /// The shards of blocks that are damaged.
    damaged_shards: BTreeSet<u64>,
    damaged: Vec<String>,
    /// Blocks of another scene, program version or number of blocks, and files that are no block of this sweep.
    foreign: Vec<String>,
}

/// One refusal of all faults, the first ones reported one by one.
fn refusal(faults: &[String]) -> Option<Failure> {
    let mut lines: Vec<String> = faults.iter().take(MOST_FAULTS).cloned().collect();
    if faults.len() > MOST_FAULTS {
        lines.push("and more like these".into());
    }
    (!lines.is_empty()).then(|| Failure::Refused(lines.join("\n")))
}

impl<'f> Folder<'f> {
    /// Lists a folder and finds the first block whose digest is right.
    fn read(place: &'f Path) -> Result<Self, Failure> {
        let cannot = Failure::io(place, "cannot be read");
        let (mut present, mut strays) = (BTreeSet::new(), Vec::new());
        for entry in fs::read_dir(place).map_err(&cannot)? {
            let name = entry.map_err(&cannot)?.file_name();
            let name = name.to_string_lossy();
            match block_of_name(&name) {
                Some(block) => drop(present.insert(block)),
                None if name.starts_with("block-") => strays.push(name.into_owned()),
                None => {}
            }
        }
        strays.sort();
        for block in present.iter().copied() {
            let Ok(Ok(open)) = OpenBlock::open(place, block) else { continue };
            let heading = open.heading.clone();
            let Ok(contents) = open.copy(true, &mut std::io::sink())? else { continue };
            if let Some(fault) = heading.origin.count_fault() {
                return Err(Failure::place(&place.join(block_name(block)), &fault));
            }
            let (origin, points, columns) = (heading.origin, heading.points, contents.columns);
            return Ok(Self { place, present, strays, reference: block, origin, points, columns });
        }
        Err(Failure::place(place, "has no valid block; run every shard"))
    }

    fn naming(&self, name: &str, reason: &str) -> String {
        format!("{}: {reason}", shown_path(&self.place.join(name)))
    }

    /// Joins all blocks, and finds everything that is wrong with them.
    fn join(&self, shards: u64, mut whole: Whole) -> Result<(BlockFaults, Whole), Failure> {
        let stray = |name: &String| self.naming(name, "is not the name of a block: a copy?");
        let mut found =
            BlockFaults { foreign: self.strays.iter().map(stray).collect(), ..BlockFaults::default() };
        let blocks = self.origin.blocks;
        if let Some(last) = self.present.last().filter(|last| **last >= blocks) {
            let beyond = format!("is beyond the {blocks} blocks of this sweep");
            found.foreign.push(self.naming(&block_name(*last), &beyond));
        }
        for block in 0..blocks {
            let (shard, name) = (Shard::of_block(block, shards), block_name(block));
            if !self.present.contains(&block) {
                found.missing.insert(shard);
                found.missing_blocks += 1;
                continue;
            }
            match self.add(block, &mut whole)? {
                State::Sound => {}
                State::Damaged(reason) => {
                    found.damaged_shards.insert(shard);
                    keep(&mut found.damaged, self.naming(&name, &reason));
                }
                State::Foreign(reason) => keep(&mut found.foreign, self.naming(&name, &reason)),
            }
        }
        Ok((found, whole))
    }

    /// Adds a block to the whole, and checks its digest, then its origin, then its rows and columns.
    fn add(&self, block: u64, whole: &mut Whole) -> Result<State, Failure> {
        let open = match OpenBlock::open(self.place, block)? {
            Ok(open) => open,
            Err(reason) => return Ok(State::Damaged(reason)),
        };
        let heading = open.heading.clone();
        let contents = match whole.copy(open, block == 0)? {
            Ok(contents) => contents,
            Err(reason) => return Ok(State::Damaged(reason)),
        };
        if let Some(difference) = heading.origin.difference(&self.origin) {
            return Ok(State::Foreign(format!("{difference}, as in {}", block_name(self.reference))));
        }
        let fault = self.misplaced(block, &heading, &contents).or(contents.fault);
        Ok(match fault.or_else(|| whole.add_summary(&contents.columns, heading.points).err()) {
            Some(reason) => State::Damaged(reason),
            None => State::Sound,
        })
    }

    /// How a block of this sweep is not the one that its name and the other blocks ask for, if it is not.
    fn misplaced(&self, block: u64, heading: &Heading, contents: &Contents) -> Option<String> {
        if heading.block != block {
            return Some(format!("contains block {}: duplicated or renamed", heading.block));
        }
        let is_last = block + 1 == self.origin.blocks;
        if heading.points > self.points || (heading.points < self.points && !is_last) {
            let other = block_name(self.reference);
            return Some(format!("has {} points, not {} as in {other}", heading.points, self.points));
        }
        (contents.columns != self.columns)
            .then(|| format!("has other columns than {}", block_name(self.reference)))
    }
}

/// How one block is.
enum State {
    Sound,
    Damaged(String),
    Foreign(String),
}

/// Keeps one fault more than are reported, so that memory does not grow with the blocks.
fn keep(faults: &mut Vec<String>, fault: String) {
    if faults.len() <= MOST_FAULTS {
        faults.push(fault);
    }
}
