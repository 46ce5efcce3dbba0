//! `slipmode replay`: an archive checked, computed anew from its inputs, and compared with the results it holds.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::archive::{
    Caps, Files, INPUT_FOLDER, Parts, Promise, REPORT_FOLDER, VERSIONS_FILE, compare_file, container_fault,
    contents, digest_faults, ledger_differences, unpack,
};
use slipmode::report::{Folder, Product, produce};
use slipmode::scene::Limits;

use crate::cli::archive::{facts, machine_free};
use crate::cli::failure::Failure;
use crate::cli::folder::{Source, read_report_from};
use crate::cli::input::read_file_up_to;
use crate::cli::progress::Progress;
use crate::cli::report::{LimitOption, drift, summary, unrenderable};
use crate::cli::terminal;

/// Options of `replay`.
#[derive(Debug, Args)]
pub struct Options {
    /// The archive
    #[arg(value_name = "FILE.zip")]
    archive: PathBuf,
    #[command(flatten)]
    limit: LimitOption,
}

/// Checks an archive, decides every verdict again, and compares all results.
///
/// # Errors
/// When the archive or its inputs are at fault, or anything differs from the result computed now.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let limits = options.limit.limits()?;
    let opened = open(&options.archive)?;
    let digests = digest_faults(&opened.files);
    if !digests.is_empty() {
        return Err(Failure::Check(digests.join("\n")));
    }
    let replayed = replay(&options.archive, &opened, limits, progress)?;
    terminal::print(&format!("{}{}\n", summary(&replayed.product.ledger), replayed.promise_kept))?;
    if replayed.differences.is_empty() {
        Ok(())
    } else {
        Err(Failure::Check(replayed.differences.join("\n")))
    }
}

/// An archive, unpacked.
pub struct Opened {
    container: Vec<u8>,
    /// Its files.
    pub files: Files,
    time: slipmode::archive::ReleaseTime,
}

/// Reads an archive.
///
/// # Errors
/// Every fault of the container.
pub fn open(path: &Path) -> Result<Opened, Failure> {
    let caps = Caps::default();
    let container = read_file_up_to(path, caps.container_bytes)?;
    let named = |faults: Vec<String>| {
        let lines: Vec<String> = faults.iter().map(|fault| format!("{}: {fault}", path.display())).collect();
        Failure::Refused(lines.join("\n"))
    };
    let (files, time) = unpack(&container, &caps).map_err(named)?;
    Ok(Opened { container, files, time })
}

struct Replayed {
    product: Product,
    promise_kept: &'static str,
    differences: Vec<String>,
}

fn replay(path: &Path, opened: &Opened, limits: Limits, progress: &Progress) -> Result<Replayed, Failure> {
    let inputs = below(&opened.files, INPUT_FOLDER);
    let inside = path.join(INPUT_FOLDER);
    let (folder, read) = read_report_from(Source::Archive(inside.clone(), inputs.clone()), limits)?;
    let product = recompute(&folder, &inside, progress)?;
    let mut differences: Vec<String> = inputs
        .keys()
        .filter(|path| !read.contains_key(*path))
        .map(|path| format!("{INPUT_FOLDER}/{path}: the report does not refer to it"))
        .collect();
    differences.extend(drift(&product.ledger));
    let facts = facts(opened.time);
    let (name, title) = (&folder.plan.name, &folder.plan.title);
    let parts =
        Parts { name, title, inputs: &read, product: &product.files, ledger: &product.ledger, facts: &facts };
    let computed = contents(&parts);
    let same_program = opened.files.get(VERSIONS_FILE) == computed.get(VERSIONS_FILE);
    let promise_kept = if same_program {
        differences.extend(byte_differences(&opened.files, &computed));
        differences.extend(container_fault(&opened.container, &opened.files, opened.time));
        "archived by the same program: all bytes compared"
    } else {
        differences.extend(number_differences(&opened.files, &computed)?);
        "archived by another build: verdicts and tables compared to their last digits; pages, figures and metadata may differ"
    };
    Ok(Replayed { product, promise_kept, differences })
}

/// Computes a report without what depends on the machine.
///
/// # Errors
/// When the report cannot be rendered.
pub fn recompute(folder: &Folder, place: &Path, progress: &Progress) -> Result<Product, Failure> {
    let command = format!("slipmode report reports/{}", folder.plan.name);
    let mut product = progress
        .items(|progress| produce(folder, &command, Vec::new(), progress))
        .map_err(|error| unrenderable(place, &error))?;
    machine_free(&mut product);
    Ok(product)
}

fn below(files: &Files, folder: &str) -> Files {
    let prefix = format!("{folder}/");
    let inside = files.iter().filter_map(|(path, bytes)| Some((path.strip_prefix(&prefix)?, bytes)));
    inside.map(|(path, bytes)| (path.to_string(), bytes.clone())).collect()
}

fn byte_differences(archived: &Files, computed: &Files) -> Vec<String> {
    let paths: BTreeSet<&String> = archived.keys().chain(computed.keys()).collect();
    let mut found = Vec::new();
    for path in paths {
        match (archived.get(path), computed.get(path)) {
            (Some(old), Some(new)) => found.extend(compare_file(path, old, new, Promise::Bytes)),
            (Some(_), None) => found.push(format!("{path}: archived, but not made by the report")),
            (None, _) => found.push(format!("{path}: made by the report, but not archived")),
        }
    }
    found
}

fn number_differences(archived: &Files, computed: &Files) -> Result<Vec<String>, Failure> {
    let ledger = format!("{REPORT_FOLDER}/ledger.json");
    let empty = Vec::new();
    let of = |files: &'_ Files| files.get(&ledger).unwrap_or(&empty).clone();
    let mut found = ledger_differences(&of(archived), &of(computed)).map_err(Failure::Refused)?;
    let tables =
        computed.iter().filter(|(path, _)| path.ends_with(".csv") && path.starts_with(REPORT_FOLDER));
    for (path, new) in tables {
        match archived.get(path) {
            Some(old) => found.extend(compare_file(path, old, new, Promise::Numbers)),
            None => found.push(format!("{path}: made by the report, but not archived")),
        }
    }
    Ok(found)
}
