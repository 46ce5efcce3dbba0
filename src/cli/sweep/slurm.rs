//! `sweep --slurm`: a job array and the merge after it, as shell scripts that say what they do.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::sweep::create_folder;
use crate::cli::sweep::load::Loaded;
use crate::cli::sweep::plan::Plan;

/// Writes the scripts for a sweep; `inputs` are repeated by the JSON object, when one is printed.
///
/// # Errors
/// When the list is at fault, a path is not UTF-8, or a file cannot be written.
pub fn write_scripts(
    loaded: &Loaded,
    [scene, out]: [&Path; 2],
    minutes: u64,
    shards: Option<u64>,
    inputs: &Option<Value>,
) -> Result<(), Failure> {
    let points = loaded.points()?;
    let blocks = points.blocks(loaded.section.block_points)?.count();
    let shards = match shards {
        Some(shards) => shards.min(blocks),
        None => Plan::measure(loaded, &points)?.shards(minutes),
    };
    create_folder(out)?;
    let scripts = Scripts {
        name: &loaded.name,
        program: absolute(
            &std::env::current_exe().map_err(|error| Failure::machine("the program's place", &error))?,
        )?,
        scene: absolute(scene)?,
        out: absolute(out)?,
        shards,
        minutes,
    };
    let files =
        [("array.sh", scripts.array()), ("merge.sh", scripts.merge()), ("submit.sh", scripts.submit())];
    for (name, text) in &files {
        Output::create(&out.join(name))?.finish(text)?;
    }
    let plural = if shards == 1 { "" } else { "s" };
    Answer::to(inputs)
        .with("shards", shards)
        .with("output", out)
        .with("files", files.map(|(name, _)| name))
        .text(&format!("{shards} shard{plural}; submit with: sh {}/submit.sh\n", scripts.out))
        .print(inputs.is_some())
}

/// A path as one word of a shell.
fn absolute(path: &Path) -> Result<String, Failure> {
    let path: PathBuf =
        fs::canonicalize(path).map_err(|error| Failure::io(path, "cannot be found", &error))?;
    match path.to_str() {
        Some(text) => Ok(quoted(text)),
        None => Err(Failure::Refused(format!(
            "{}: a script cannot contain a path that is not UTF-8",
            path.display()
        ))),
    }
}

/// A text that the shell takes as it is.
fn quoted(text: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/._-".contains(&byte);
    if text.bytes().all(is_plain) { text.to_string() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

/// What the scripts are made of; paths are quoted.
struct Scripts<'n> {
    name: &'n str,
    program: String,
    scene: String,
    out: String,
    shards: u64,
    minutes: u64,
}

impl Scripts<'_> {
    fn array(&self) -> String {
        let Self { name, program, scene, out, shards, .. } = self;
        // Twice the plan: a slower node must not lose its last block to the limit.
        let limit = self.minutes * 2;
        format!(
            "#!/bin/sh\n\
             # One task of the array computes one shard, on one core. submit.sh lists the tasks.\n\
             #SBATCH --job-name={name}\n\
             #SBATCH --ntasks=1\n\
             #SBATCH --cpus-per-task=1\n\
             # Minutes: twice the planned time of a shard.\n\
             #SBATCH --time={limit}\n\
             # A task whose node fails, or that is preempted, goes back to the queue; it continues after its last complete block.\n\
             #SBATCH --requeue\n\
             #SBATCH --open-mode=append\n\
             exec {program} --threads 1 --quiet sweep {scene} --shard \"$SLURM_ARRAY_TASK_ID/{shards}\" --out {out}\n"
        )
    }

    fn merge(&self) -> String {
        let Self { name, program, out, shards, .. } = self;
        format!(
            "#!/bin/sh\n\
             # Joins the blocks after all tasks of the array have ended, also if some failed.\n\
             # If blocks are missing, exits with 1 and names the shards to submit again in its log.\n\
             #SBATCH --job-name={name}-merge\n\
             #SBATCH --ntasks=1\n\
             #SBATCH --cpus-per-task=1\n\
             #SBATCH --requeue\n\
             exec {program} merge {out} --shards {shards} -o {out}/merged.csv\n"
        )
    }

    fn submit(&self) -> String {
        let Self { program, out, shards, .. } = self;
        let last = shards - 1;
        format!(
            "#!/bin/sh\n\
             # Submits the array, and the merge after it.\n\
             #   sh submit.sh           all {shards} shards, 0 to {last}\n\
             #   sh submit.sh 3,17-19   only these: what `merge {out} --shards {shards} --missing` prints\n\
             # A cluster takes arrays up to its MaxArraySize (`scontrol show config`); `sweep --slurm --shards N` makes fewer.\n\
             set -eu\n\
             tasks=${{1:-0-{last}}}\n\
             array=$(sbatch --parsable --array=\"$tasks\" --output={out}/shard-%a.log {out}/array.sh)\n\
             merge=$(sbatch --parsable --dependency=\"afterany:${{array%%;*}}\" --output={out}/merge-%j.log {out}/merge.sh)\n\
             echo \"array $array, merge $merge, program {program}\"\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_one_word_whatever_it_holds() {
        assert_eq!(quoted("/a/b-c_d.toml"), "/a/b-c_d.toml");
        assert_eq!(quoted("/a b/$HOME"), "'/a b/$HOME'");
        assert_eq!(quoted("it's"), "'it'\\''s'");
    }
}
