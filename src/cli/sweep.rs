//! `slipmode sweep`: the points of a scene in fixed blocks, as many as belong to one shard; its plan; its Slurm scripts.

mod asymptote_rows;
pub mod block_file;
mod boundary_rows;
mod load;
mod plan;
mod points;
mod slurm;
pub mod summed;
mod work;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use clap::Args;
use indicatif::ProgressBar;
use rayon::prelude::*;
use serde_json::{Value, json};
use slipmode::scene::Problem;
use slipmode::sweep::{Blocks, Shard};

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::options::Arguments;
use crate::cli::path_text::json_path;
use crate::cli::progress::Progress;
use crate::cli::terminal;
use block_file::{Content, OpenBlock, Origin, write_block};
use load::Loaded;
use points::{Job, Points};
use summed::Summed;

/// Options of `sweep`.
#[derive(Debug, Args)]
pub struct Options {
    /// The scene: a TOML file with a section [sweep]
    scene: PathBuf,
    /// The shard to compute: block k belongs to shard k mod N; shards are counted from 0 [default: 0/1]
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    shard: Option<String>,
    /// The folder of the blocks; valid blocks in it are not computed again
    #[arg(long, value_name = "DIR", required_unless_present = "plan")]
    out: Option<PathBuf>,
    /// Measure some points, print points, blocks, shards, core-hours and bytes, and compute nothing
    #[arg(long, conflicts_with = "slurm")]
    plan: bool,
    /// Write a job array for Slurm and the merge after it into DIR, and compute nothing
    #[arg(long)]
    slurm: bool,
    /// With --plan or --slurm: target time of a shard on one core, minutes [default: 30]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    minutes: Option<String>,
    /// With --plan or --slurm: the number of shards [default: computed from --minutes]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    shards: Option<String>,
    /// Print one JSON object: the blocks of the shard, the plan, or the scripts
    #[arg(long)]
    json: bool,
}

/// How long a shard takes unless the command line says otherwise, in minutes.
const DEFAULT_MINUTES: u64 = 30;
/// The longest shard, in minutes: a week.
const MOST_MINUTES: u64 = 7 * 24 * 60;
/// The most shards of a job array.
pub const MOST_SHARDS: u64 = 1_000_000;

/// Runs the command.
///
/// # Errors
/// When the arguments or the scene are at fault, a file cannot be read or written, or the folder has another sweep's blocks.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let shard = options.shard.as_deref().unwrap_or("0/1");
    let shard = arguments.number("--shard", shard, |text| {
        let allowed = "I/N with whole numbers 0 <= I < N".to_string();
        Shard::parse(text).ok_or(Problem::OutOfRange { allowed })
    });
    let minutes = arguments.whole("--minutes", options.minutes.as_deref(), 1..=MOST_MINUTES);
    let minutes = minutes.unwrap_or(DEFAULT_MINUTES);
    let shards = arguments.whole("--shards", options.shards.as_deref(), 1..=MOST_SHARDS);
    let computes_nothing = options.plan || options.slurm;
    let needs = "neither --plan nor --slurm, which compute no shard";
    arguments.refuse("--shard", computes_nothing && options.shard.is_some(), needs);
    let needs = "--plan or --slurm: a shard takes as long as it takes";
    arguments.refuse("--minutes", !computes_nothing && options.minutes.is_some(), needs);
    let needs = "--plan or --slurm; `--shard I/N` computes one of N";
    arguments.refuse("--shards", !computes_nothing && shards.is_some(), needs);
    let needs = "no --shards: their number says how long each takes";
    arguments.refuse("--minutes", options.plan && shards.is_some() && options.minutes.is_some(), needs);
    arguments.refuse("--out", options.plan && options.out.is_some(), "no --plan, which writes nothing");
    let shard = arguments.finish(shard)?;
    let loaded = load::load(&options.scene)?;
    let inputs = options.json.then(
        || json!({ "scene": json_path(&options.scene), "minutes": computes_nothing.then_some(minutes) }),
    );
    match &options.out {
        Some(out) if options.slurm => {
            slurm::write_scripts(&loaded, [&options.scene, out], minutes, shards, &inputs)
        }
        Some(out) if !options.plan => compute_shard(&loaded, shard, out, *progress, inputs),
        _ => plan::print_plan(&loaded, minutes, shards, &inputs),
    }
}

/// Computes the blocks of a shard that are not there; `inputs` are repeated by the JSON object, when one is printed.
fn compute_shard(
    loaded: &Loaded,
    shard: Shard,
    out: &Path,
    progress: Progress,
    inputs: Option<Value>,
) -> Result<(), Failure> {
    let points = loaded.points()?;
    let blocks = points.blocks(loaded.section.block_points)?;
    let columns = points.columns();
    let summed = loaded.section.summary.as_ref().map(|section| Summed::new(section, &columns)).transpose()?;
    fs::create_dir_all(out).map_err(Failure::io(out, "cannot be created"))?;
    let origin = Origin {
        scene: points.digest(&loaded.scene_digest),
        version: load::version(),
        blocks: blocks.count(),
        content: summed.as_ref().map_or(Content::Rows, |summed| Content::Summary(summed.empty.key_count())),
    };
    let shard_blocks = blocks.of_shard(shard).count() as u64;
    let writer = BlockWriter {
        points: &points,
        blocks,
        columns: summed.as_ref().map_or(columns, |summed| summed.empty.columns()),
        summed,
        origin,
        out,
        bar: progress.count(shard_blocks),
        computed: AtomicU64::new(0),
        unanswered: AtomicU64::new(0),
    };
    // Blocks start in their order, each on one thread: what a kill can lose is one block a thread.
    let done = points.jobs(blocks, shard)?.par_bridge().try_for_each(|job| writer.write(&job?));
    writer.bar.finish_and_clear();
    done?;
    let unanswered = writer.unanswered.into_inner();
    if unanswered > 0 {
        let points = terminal::count_of(unanswered, "point");
        terminal::message(&format!("{points} without a result; see the columns `status` or `error`"));
    }
    let Some(inputs) = inputs else { return Ok(()) };
    Answer::to(inputs)
        .with("scene_sha256", &loaded.scene_digest)
        .with("shard", json!({ "index": shard.index, "count": shard.count }))
        .with("blocks", shard_blocks)
        .with("computed_blocks", writer.computed.into_inner())
        .with("points_without_result", unanswered)
        .with("output", json_path(out))
        .print(true)
}

/// Writes blocks from any thread.
struct BlockWriter<'p> {
    points: &'p Points,
    blocks: Blocks,
    columns: Vec<u8>,
    summed: Option<Summed>,
    origin: Origin,
    out: &'p Path,
    bar: ProgressBar,
    computed: AtomicU64,
    unanswered: AtomicU64,
}

impl BlockWriter<'_> {
    fn write(&self, job: &Job) -> Result<(), Failure> {
        if !self.holds(job.block)? {
            let lines = match &self.summed {
                Some(summed) => summed.lines(self.points, self.blocks, job)?,
                None => self.points.lines(self.blocks, job),
            };
            let range = self.blocks.range(job.block);
            let number = (job.block, range.end - range.start);
            write_block(self.out, &self.origin, number, &self.columns, &lines.text)?;
            self.computed.fetch_add(1, Ordering::Relaxed);
            self.unanswered.fetch_add(lines.unanswered, Ordering::Relaxed);
        }
        self.bar.inc(1);
        Ok(())
    }

    /// Whether a block is there and sound. A damaged one is computed again; one of another sweep is never overwritten.
    fn holds(&self, block: u64) -> Result<bool, Failure> {
        let Ok(open) = OpenBlock::open(self.out, block)? else { return Ok(false) };
        let heading = open.heading.clone();
        // The digest comes first: a flipped bit of the heading must not look like another scene.
        let Ok(contents) = open.copy(true, &mut std::io::sink())? else { return Ok(false) };
        if let Some(difference) = heading.origin.difference(&self.origin) {
            let place = self.out.join(block_file::block_name(block));
            let why = format!("{difference}; choose another folder, or remove its blocks");
            return Err(Failure::place(&place, &why));
        }
        let range = self.blocks.range(block);
        let is_ours = (heading.block, heading.points) == (block, range.end - range.start);
        Ok(is_ours && contents.fault.is_none() && contents.columns == self.columns)
    }
}
