//! `sweep --slurm`: a job array and the merge after it, as shell scripts that say what they do.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::output::Output;
use crate::cli::path_text::{json_path, word_of};
use crate::cli::sweep::load::Loaded;
use crate::cli::sweep::plan::Plan;
use crate::cli::terminal::count_of;

/// Writes the scripts for a sweep; `inputs` are repeated by the JSON object, when one is printed.
///
/// # Errors
/// When the list is at fault, a path is not UTF-8 or has a line break, or a file cannot be written.
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
    fs::create_dir_all(out).map_err(Failure::io(out, "cannot be created"))?;
    let program = std::env::current_exe().map_err(|error| Failure::machine("the program's place", &error))?;
    let [program, scene, script_out] = [&*program, scene, out].map(absolute);
    let (name, program, scene, script_out) = (&loaded.name, program?, scene?, script_out?);
    let array = format!(
        include_str!("array.sh"),
        name = name,
        // Twice the plan: a slower node must not lose its last block to the limit.
        limit = minutes * 2,
        program = program,
        scene = scene,
        shards = shards,
        out = script_out,
    );
    let merge =
        format!(include_str!("merge.sh"), name = name, program = program, shards = shards, out = script_out,);
    let submit = format!(
        include_str!("submit.sh"),
        program = program,
        shards = shards,
        last = shards - 1,
        out = script_out,
    );
    let files = [("array.sh", array), ("merge.sh", merge), ("submit.sh", submit)];
    for (name, text) in &files {
        Output::create(&out.join(name))?.finish(text)?;
    }
    Answer::to(inputs)
        .with("shards", shards)
        .with("output", json_path(out))
        .with("files", files.map(|(name, _)| name))
        .text(&format!("{}; submit with: sh {script_out}/submit.sh\n", count_of(shards, "shard")))
        .print(inputs.is_some())
}

/// A path as one word of a shell, without a line break: it also stands in comments.
fn absolute(path: &Path) -> Result<String, Failure> {
    let path = fs::canonicalize(path).map_err(Failure::io(path, "cannot be found"))?;
    match path.to_str() {
        Some(text) if !text.contains(char::is_control) => Ok(word_of(&path)),
        _ => {
            Err(Failure::place(&path, "a script cannot contain a path that is not UTF-8 or has a line break"))
        }
    }
}
