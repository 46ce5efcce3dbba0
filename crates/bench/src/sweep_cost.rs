//! `cargo xtask sweep-cost`: memory, scaling and overhead of sweeps, measured on the profile `dist` of the command line.
//!
//! Wall times are what scaling and overhead are about, so that this wants a machine without other work. Nothing of it enters
//! what `verify` compares.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use crate::cost::measure::{Measured, once};
use crate::{process, repository};

/// Points over the three groups: a work of a microsecond, so that whatever else a sweep does would show.
const SCENE: &str = "name = \"cost\"\ntitle = \"Cost\"\n[parameters]\ndirect_effect = 1\nevolution_effect = 1\n\
    critical_slip_distance_m = 1\nstiffness_pa_per_m = 1\nmass_per_area_kg_per_m2 = 1\nnormal_stress_pa = 1\n\
    loading_velocity_m_per_s = 1\n[sweep]\nwork = \"asymptote-error\"\nblock_points = BLOCK\n[sweep.samples]\ncount = COUNT\n\
    evolution_effect = { from = 1e-3, to = 1e3 }\nstiffness_pa_per_m = { from = 1e-4, to = 1e6 }\n\
    mass_per_area_kg_per_m2 = { from = 1e-6, to = 1e4 }\n";
const SUMMARY: &str = "[sweep.summary]\nby = [\"asymptote\"]\n[[sweep.summary.bins]]\ncolumn = \"evolution_effect\"\n\
    from = 1e-3\nto = 1e3\ncount = 24\n[[sweep.summary.numbers]]\ncolumn = \"asymptote_relative_error\"\n\
    statistics = [\"least\", \"greatest\"]\n";

/// Points of a usual block of this work.
const USUAL_BLOCK: u64 = 1 << 18;
/// How long a shard is whose overhead is asked for, s.
const SHARD_S: f64 = 300.0;

/// The program and the folder in which it runs.
struct SweepPlace {
    program: PathBuf,
    folder: PathBuf,
}

/// Measures and prints Markdown.
///
/// # Errors
/// When the build or a measured command fails, or a file cannot be written.
pub fn run() -> Result<(), String> {
    let place =
        SweepPlace { program: process::build_dist()?, folder: repository::root().join("target/sweep-cost") };
    let _ = fs::remove_dir_all(&place.folder);
    fs::create_dir_all(&place.folder).map_err(|error| place.cannot(&error))?;
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    println!(
        "Command: `cargo xtask sweep-cost`. {cores} cores, {}, profile `dist`.\n",
        process::rustc_version()
    );
    print!("{}", memory(&place)?);
    print!("{}", scaling(&place)?);
    print!("{}", overhead(&place)?);
    fs::remove_dir_all(&place.folder).map_err(|error| place.cannot(&error))
}

impl SweepPlace {
    fn cannot(&self, error: &std::io::Error) -> String {
        format!("{}: {error}", self.folder.display())
    }

    /// Writes the scene of so many points in such blocks, and takes the folder of its blocks away.
    fn scene(&self, points: u64, block: u64, summary: bool) -> Result<(), String> {
        let text = SCENE.replace("COUNT", &points.to_string()).replace("BLOCK", &block.to_string());
        let text = if summary { text + SUMMARY } else { text };
        let _ = fs::remove_dir_all(self.folder.join("blocks"));
        fs::write(self.folder.join("cost.toml"), text).map_err(|error| self.cannot(&error))
    }

    fn measure(&self, command: &str) -> Result<Measured, String> {
        let arguments: Vec<String> = command.split_whitespace().map(String::from).collect();
        eprintln!("sweep-cost: slipmode {command}");
        once(&self.program, &arguments, Path::new(&self.folder))
    }

    fn sweep(&self, options: &str) -> Result<Measured, String> {
        self.measure(&format!("sweep cost.toml --out blocks --quiet {options}"))
    }
}

/// Peak memory of sweep and merge against points: rows that are kept, and rows that are summed up.
fn memory(place: &SweepPlace) -> Result<String, String> {
    let mut text = String::from(
        "| blocks hold | points | sweep, CPU s | sweep, peak MiB | merge, CPU s | merge, peak MiB |\n|---|---|---|---|---|---|\n",
    );
    let cases = [
        ("rows", false, 6),
        ("rows", false, 7),
        ("a summary", true, 6),
        ("a summary", true, 7),
        ("a summary", true, 8),
    ];
    for (holds, summary, power) in cases {
        let points = 10_u64.pow(power);
        place.scene(points, USUAL_BLOCK, summary)?;
        let swept = place.sweep("")?;
        let merged = place.measure("merge blocks -o merged.csv")?;
        let mib = |measured: Measured| measured.peak_kib as f64 / 1024.0;
        let _ = writeln!(
            text,
            "| {holds} | 10^{power} | {:.2} | {:.1} | {:.2} | {:.1} |",
            swept.cpu_s,
            mib(swept),
            merged.cpu_s,
            mib(merged)
        );
        let _ = fs::remove_file(place.folder.join("merged.csv"));
    }
    Ok(text + "\n")
}

/// Runs of a comparison; the fastest counts.
const RUNS: usize = 3;

/// The wall time of a run that finds no block.
fn fresh(place: &SweepPlace, points: u64, block: u64, options: &str) -> Result<f64, String> {
    place.scene(points, block, true)?;
    Ok(place.sweep(options)?.wall_s)
}

/// The least wall time of some fresh runs.
fn fastest(place: &SweepPlace, points: u64, block: u64, options: &str) -> Result<f64, String> {
    let mut least = f64::INFINITY;
    for _ in 0..RUNS {
        least = least.min(fresh(place, points, block, options)?);
    }
    Ok(least)
}

/// Wall time with one thread and with two, asked in turn so that both meet the same machine.
fn scaling(place: &SweepPlace) -> Result<String, String> {
    const POINTS: u64 = 40 * USUAL_BLOCK;
    let (mut one, mut two) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..RUNS {
        one = one.min(fresh(place, POINTS, USUAL_BLOCK, "--threads 1")?);
        two = two.min(fresh(place, POINTS, USUAL_BLOCK, "--threads 2")?);
    }
    Ok(format!(
        "Scaling, {POINTS} points: 1 thread {one:.2} s, 2 threads {two:.2} s, {:.2} times as fast.\n\n",
        one / two
    ))
}

/// What a shard takes besides its points: the start, and each block's heading, digest and sync.
fn overhead(place: &SweepPlace) -> Result<String, String> {
    const BLOCKS: u64 = 1000;
    const POINTS: u64 = 1_000_000;
    let start = fastest(place, 1, 1, "--threads 1")?;
    let whole = fastest(place, POINTS, POINTS, "--threads 1")?;
    let cut = fastest(place, POINTS, POINTS / BLOCKS, "--threads 1")?;
    let block = ((cut - whole) / (BLOCKS - 1) as f64).max(0.0);
    let point = (whole - start) / POINTS as f64;
    let blocks = SHARD_S / (point * USUAL_BLOCK as f64);
    let share = (start + blocks * block) / SHARD_S;
    Ok(format!(
        "Overhead: start and one block {:.1} ms, each further block {:.3} ms; a shard of {SHARD_S} s has {blocks:.0} blocks of \
         {USUAL_BLOCK} points, and all of this is {:.4} % of it.\n",
        start * 1e3,
        block * 1e3,
        share * 100.0
    ))
}
