//! `sweep --plan`: some points measured, and from them what the whole sweep will take.

use std::time::Instant;

use serde_json::{Value, json};
use slipmode::sweep::Blocks;
use slipmode_core::number::format::round_digits;

use crate::cli::failure::Failure;
use crate::cli::inputs::SCHEMA;
use crate::cli::sweep::load::{Loaded, Task};
use crate::cli::sweep::points::Points;
use crate::cli::sweep::summed::Summed;
use crate::cli::sweep::work::PointWork;
use crate::cli::terminal;

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
    pub fn measure<W: PointWork>(loaded: &Loaded, points: &Points<W>) -> Result<Self, Failure> {
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

    /// How many blocks there are.
    pub fn blocks(&self) -> u64 {
        self.blocks.count()
    }

    fn block_seconds(&self) -> f64 {
        self.seconds_per_point * self.blocks.points.min(self.blocks.block_points) as f64
    }

    fn shard_minutes(&self, shards: u64) -> f64 {
        self.core_seconds() / 60.0 / shards as f64
    }

    fn json(&self, shards: u64, inputs: &Value) -> Value {
        json!({
            "schema": SCHEMA,
            "inputs": inputs,
            "points": self.blocks.points,
            "block_points": self.blocks.block_points,
            "blocks": self.blocks(),
            "shards": shards,
            "shard_minutes": self.shard_minutes(shards),
            "core_hours": self.core_seconds() / 3600.0,
            "bytes": self.bytes,
            "point_seconds": self.seconds_per_point,
            "block_seconds": self.block_seconds(),
            "measured_points": self.measured_points,
        })
    }

    fn text(&self, shards: u64) -> String {
        let digits = |value| round_digits(value, 3);
        terminal::named_values(&[
            ("points", self.blocks.points.to_string(), ""),
            ("blocks", self.blocks().to_string(), &format!("(of {} points)", self.blocks.block_points)),
            (
                "shards",
                shards.to_string(),
                &format!("(about {} minutes each)", digits(self.shard_minutes(shards))),
            ),
            ("core-hours", digits(self.core_seconds() / 3600.0), ""),
            ("bytes", digits(self.bytes), "(of blocks; the merged file has at most as many)"),
            (
                "a point",
                format!("{} s", digits(self.seconds_per_point)),
                &format!("({} measured on one core)", self.measured_points),
            ),
            (
                "a block",
                format!("{} s", digits(self.block_seconds())),
                "(lost at most, on each thread, if a shard is killed)",
            ),
        ])
    }
}

/// Prints the plan.
pub struct PrintPlan {
    /// How long a shard should take, minutes.
    pub minutes: u64,
    /// Shards, when given.
    pub shards: Option<u64>,
    /// What the JSON object repeats, when one is printed.
    pub inputs: Option<Value>,
}

impl Task for PrintPlan {
    fn perform<W: PointWork>(self, loaded: &Loaded, points: &Points<W>) -> Result<(), Failure> {
        let plan = Plan::measure(loaded, points)?;
        let shards =
            self.shards.map_or_else(|| plan.shards(self.minutes), |shards| shards.min(plan.blocks()));
        match self.inputs {
            Some(inputs) => terminal::print_json(&plan.json(shards, &inputs)),
            None => terminal::print(&plan.text(shards)),
        }
    }
}
