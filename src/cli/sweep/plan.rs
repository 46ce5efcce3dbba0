//! `sweep --plan`: some points measured, and from them what the whole sweep will take.

use std::time::Instant;

use serde_json::{Value, json};
use slipmode::sweep::Blocks;
use slipmode_core::number::format::round_digits;

use crate::cli::answer::{Answer, Item};
use crate::cli::failure::Failure;
use crate::cli::sweep::load::Loaded;
use crate::cli::sweep::points::Points;
use crate::cli::sweep::summed::Summed;

/// How long points are measured at least, s, unless a block has no more of them.
const LEAST_SECONDS: f64 = 1.0;
/// Points of the first measurement; each further one has four times as many.
const FIRST_POINTS: u64 = 16;
/// Bytes of a block's heading, about.
const HEADING_BYTES: f64 = 290.0;

/// What a sweep will take on cores like this one.
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    blocks: Blocks,
    measured_points: u64,
    seconds_per_point: f64,
    bytes: f64,
}

impl Plan {
    /// Measures points spread over the sweep on one thread.
    ///
    /// # Errors
    /// When the list cannot be read, or there are too many blocks.
    pub fn measure(loaded: &Loaded, points: &Points) -> Result<Self, Failure> {
        let blocks = points.blocks(loaded.section.block_points)?;
        let most = blocks.points.min(blocks.block_points);
        let mut count = FIRST_POINTS.min(most);
        loop {
            let started = Instant::now();
            let (lines, count_measured) = points.sample(blocks, count)?;
            let seconds = started.elapsed().as_secs_f64();
            if seconds >= LEAST_SECONDS || count >= most {
                let bytes = match &loaded.section.summary {
                    // Every block has about as many keys as the points measured, which are spread over the sweep.
                    Some(section) => {
                        Summed::new(section, &points.columns())?.bytes(&lines)? * blocks.count() as f64
                    }
                    None => lines.text.len() as f64 / count_measured as f64 * blocks.points as f64,
                };
                return Ok(Self {
                    blocks,
                    measured_points: count_measured,
                    seconds_per_point: seconds / count_measured as f64,
                    bytes: bytes + HEADING_BYTES * blocks.count() as f64,
                });
            }
            count = (count * 4).min(most);
        }
    }

    fn core_seconds(&self) -> f64 {
        self.seconds_per_point * self.blocks.points as f64
    }

    /// How many shards take about so many minutes each; at most one a block.
    pub fn shards(&self, minutes: u64) -> u64 {
        let shards = libm::ceil(self.core_seconds() / (minutes as f64 * 60.0));
        // A saturating conversion: whatever the quotient is, a number from 1 to the blocks comes out.
        (shards as u64).clamp(1, self.blocks.count().min(super::MOST_SHARDS))
    }

    fn block_seconds(&self) -> f64 {
        self.seconds_per_point * self.blocks.points.min(self.blocks.block_points) as f64
    }

    fn shard_minutes(&self, shards: u64) -> f64 {
        self.core_seconds() / 60.0 / shards as f64
    }

    fn answer(&self, shards: u64, inputs: &Option<Value>) -> Answer {
        let digits = |value| round_digits(value, 3);
        let Self { blocks: Blocks { points, block_points }, measured_points, seconds_per_point, bytes } =
            *self;
        let (minutes, hours) = (self.shard_minutes(shards), self.core_seconds() / 3600.0);
        Answer::to(inputs)
            .item("points", "points", points)
            .item("blocks", "blocks", self.blocks.count())
            .note(&format!("(of {block_points} points)"))
            .item("shards", "shards", shards)
            .note(&format!("(about {} minutes each)", digits(minutes)))
            .item("core_hours", "core-hours", Item::new(json!(hours), digits(hours)))
            .item("bytes", "bytes", Item::new(json!(bytes), digits(bytes)))
            .note("(of blocks; the merged file has at most as many)")
            .item("point_seconds", "a point", seconds(seconds_per_point))
            .note(&format!("({measured_points} measured on one core)"))
            .item("block_seconds", "a block", seconds(self.block_seconds()))
            .note("(lost at most, on each thread, if a shard is killed)")
            .with("block_points", block_points)
            .with("shard_minutes", minutes)
            .with("measured_points", measured_points)
    }
}

fn seconds(value: f64) -> Item {
    Item::new(json!(value), format!("{} s", round_digits(value, 3)))
}

/// Prints the plan: `shards` when they are given, or as many as take so many minutes each; `inputs` where it is one object.
///
/// # Errors
/// As [`Plan::measure`].
pub fn print_plan(
    loaded: &Loaded,
    minutes: u64,
    shards: Option<u64>,
    inputs: &Option<Value>,
) -> Result<(), Failure> {
    let plan = Plan::measure(loaded, &loaded.points()?)?;
    let shards = shards.map_or_else(|| plan.shards(minutes), |shards| shards.min(plan.blocks.count()));
    plan.answer(shards, inputs).print(inputs.is_some())
}
