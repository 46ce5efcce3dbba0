//! `cargo xtask cluster-test`: a sweep on a real Slurm of three nodes, one of which is killed midway.
//!
//! Slurm's daemons run here, under this program, on ports and in a folder of their own. A machine without Slurm is named and
//! the test skipped, except under continuous integration (`CI` is set), where it is required.

mod cluster;
mod sessions;

use std::thread;
use std::time::Duration;

use crate::prelude::*;
use crate::{machine, verify};
use cluster::Cluster;

/// The programs that the test runs on.
const PROGRAMS: [&str; 5] = ["munged", "slurmctld", "slurmd", "sbatch", "setpriv"];

/// Shards of the array: twice as many as nodes, so that some wait while others run.
const SHARDS: usize = 6;
/// Blocks of the sweep: each shard has eight, and a kill finds it between two.
const BLOCKS: usize = 48;
/// The node that is killed.
const VICTIM: &str = "n2";
/// How long any wait may last.
const PATIENCE: Duration = Duration::from_secs(120);

/// Runs the test.
///
/// # Errors
/// With exit code 1 when the merged bytes differ or another check failed, 2 when Slurm is required and cannot be installed.
pub fn run() -> Result {
    machine::run()?;
    let lacking = if machine::is_root() { machine::provide(&PROGRAMS)? } else { vec!["the rights of root"] };
    if !lacking.is_empty() {
        let message = format!("no {}", lacking.join(", "));
        ensure(!machine::is_continuous_integration(), || Failure::bad_input(&message))?;
        println!("cluster-test: skipped: {message}");
        return Ok(());
    }
    verify::build()?;
    let place = env::temp_dir().join(format!("slipmode-cluster-{}", std::process::id()));
    let result = Cluster::start(&place)
        .and_then(|mut cluster| rehearse(&mut cluster, &place).inspect_err(|_| cluster.tell_logs()));
    // Everything of value is on standard output; what the folder holds is of no use to the next run.
    let _ = fs::remove_dir_all(&place);
    result
}

fn rehearse(cluster: &mut Cluster, place: &Path) -> Result {
    let began = Instant::now();
    let text = |path: &Path| path.display().to_string();
    let scene = text(&root().join("xtask/cluster/scene.toml"));
    let (out, alone) = (text(&place.join("blocks")), text(&place.join("alone")));
    let shards = SHARDS.to_string();
    slipmode(&["sweep", &scene, "--slurm", "--shards", &shards, "--out", &out])?;
    let submit = format!("{out}/submit.sh");
    cluster.submit(&submit, None)?;
    let on_victim = format!("--states=RUNNING --nodelist={VICTIM}");
    let shard =
        wait_for("a task on the node to be killed", || Ok(cluster.tasks(&on_victim)?.first().copied()))?;
    wait_until("its first block", || Ok(blocks_of(&out, shard) > 0))?;
    let (there, killed) = (blocks_of(&out, shard), cluster.kill_node(VICTIM)?);
    println!("cluster-test: {VICTIM} killed with {killed} processes, {there} blocks into shard {shard}");
    wait_until("the other tasks to end", || Ok(cluster.tasks("")?.iter().all(|task| *task == shard)))?;
    let missing = slipmode(&["merge", &out, "--shards", &shards, "--missing"])?;
    let missing = missing.trim_end();
    let wrong = || Failure::check(format!("missing shards `{missing}`, but shard {shard} was killed"));
    ensure(missing == shard.to_string(), wrong)?;
    println!("cluster-test: missing, and submitted again: {missing}");
    cluster.cancel_all()?;
    cluster.submit(&submit, Some(missing))?;
    let (merged, expected) = (format!("{out}/merged.csv"), format!("{alone}/merged.csv"));
    wait_until("the merge", || Ok(Path::new(&merged).is_file()))?;
    slipmode(&["sweep", &scene, "--out", &alone])?;
    slipmode(&["merge", &alone, "-o", &expected])?;
    program("sha256sum", "").args([&merged, &expected]).check()?;
    let wrong = || Failure::check("the cluster's bytes are not those of one process");
    ensure(read(merged.as_ref())? == read(expected.as_ref())?, wrong)?;
    println!("cluster-test: passed in {} s", began.elapsed().as_secs());
    Ok(())
}

/// The blocks of a shard that are there.
fn blocks_of(out: &str, shard: usize) -> usize {
    let name = |block: usize| Path::new(out).join(format!("block-{block:09}.csv"));
    (shard..BLOCKS).step_by(SHARDS).filter(|block| name(*block).is_file()).count()
}

/// Runs the release binary and returns what it printed.
fn slipmode(arguments: &[&str]) -> Result<String> {
    verify::slipmode("--quiet").args(arguments).text()
}

/// Asks again and again until there is an answer.
fn wait_for<T>(what: &str, mut ask: impl FnMut() -> Result<Option<T>>) -> Result<T> {
    let began = Instant::now();
    loop {
        if let Some(answer) = ask()? {
            return Ok(answer);
        }
        let wrong = || Failure::check(format!("waited {} s in vain for {what}", PATIENCE.as_secs()));
        ensure(began.elapsed() <= PATIENCE, wrong)?;
        thread::sleep(Duration::from_millis(50));
    }
}

/// Asks again and again until it is so.
fn wait_until(what: &str, mut ask: impl FnMut() -> Result<bool>) -> Result {
    wait_for(what, || Ok(ask()?.then_some(())))
}
