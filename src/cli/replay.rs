//! `slipmode replay`: checks an archive, computes it again from its inputs, and compares the results.

mod watch;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::cli::archive::{facts, parts, recompute, theorems};
use clap::Args;
use serde_json::json;
use slipmode::archive::{
    Budget, CODECHECK_FILE, Caps, Facts, Files, INPUT_FOLDER, Maker, ReleaseTime, Reproduction, SOURCES_FILE,
    below, digest_faults, reproduction, requests, unpack,
};
use slipmode::report::Product;
use slipmode::scene::{AllowedRange, Limits, first_lines};
use slipmode_core::number::nearest_f64;

use crate::cli::answer::Answer;
use crate::cli::claim::problems;
use crate::cli::example;
use crate::cli::failure::Failure;
use crate::cli::folder::{Source, read_report_from};
use crate::cli::input::read_file_up_to;
use crate::cli::options::Arguments;
use crate::cli::path_text::{json_path, word_of};
use crate::cli::progress::Progress;
use crate::cli::report::{LimitOption, verdicts};
use watch::Watch;

/// Options of `replay`.
#[derive(Debug, Args)]
#[command(after_help = format!("{}\n\n{}", limits_text(), example("replay lab.zip")))]
pub struct Options {
    /// The archive
    #[arg(value_name = "FILE.zip")]
    archive: PathBuf,
    /// Accepts an archive that another build made: a number may differ by one unit in its last digit
    #[arg(long)]
    other_build: bool,
    /// Fails when anything in the archive cannot be verified
    #[arg(long)]
    strict: bool,
    /// One JSON object instead of text: the numbers of verdicts and what differs
    #[arg(long)]
    json: bool,
    /// Multiplies the limits on work, memory, time and digits
    #[arg(long, value_name = "FACTOR", default_value = "1", allow_hyphen_values = true)]
    budget: String,
    #[command(flatten)]
    limit: LimitOption,
}

fn limits_text() -> String {
    let Caps { container_bytes, entries, file_bytes, total_bytes, .. } = Caps::default();
    let mib = |bytes: u64| bytes >> 20;
    format!(
        "Limits: {}; --budget multiplies these. A file of {} MiB, unpacked {} MiB in {entries} files, one of them {} MiB.",
        Budget::default().text(),
        mib(container_bytes),
        mib(total_bytes),
        mib(file_bytes),
    )
}

/// Checks an archive, decides every verdict again, and compares all results.
///
/// # Errors
/// When the archive or its inputs are at fault or ask for too much, or anything differs from the result computed now.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let limits = options.limit.limits()?;
    let mut arguments = Arguments::default();
    let factor = arguments.number("--budget", &options.budget, |text| AllowedRange::BUDGET.parse(text));
    let budget = Budget::default().times(nearest_f64(&arguments.finish(factor)?));
    let opened = open(&options.archive)?;
    let digests = digest_faults(&opened.files);
    if !digests.is_empty() {
        return Err(Failure::Check(first_lines(digests, |more| format!("and {more} more")).join("\n")));
    }
    let this = facts(opened.time);
    let refused = |fault: String| Failure::place(&options.archive, &fault);
    let maker = Maker::of(&opened.files, opened.time, &this).map_err(refused)?;
    if let (Maker::OtherBuild(other), false) = (&maker, options.other_build) {
        return Err(refused(other_build_text(other, &this, &options.archive)));
    }
    let replay = Replay { place: &options.archive, opened: &opened, maker, facts: &this, budget };
    let (product, Reproduction { mut differences, not_verified }) = replay.run(limits, progress)?;
    if options.strict {
        differences.extend(not_verified.iter().map(|line| format!("{line}: cannot be verified")));
    }
    let open: String = not_verified.iter().map(|line| format!("not verified: {line}\n")).collect();
    Answer::to(json!({ "archive": json_path(&options.archive) }))
        .and(verdicts(&product.ledger))
        .with("compared", replay.compared())
        .with("not_verified", &not_verified)
        .with("differences", &differences)
        .text(&format!("{}\n{open}", replay.compared()))
        .print(options.json)?;
    Failure::check_none(of_each_file(differences))
}

/// The first line on each file or claim, then the others: a message that is cut short names all of them, files of theorems last.
fn of_each_file(lines: Vec<String>) -> impl Iterator<Item = String> {
    let mut seen = BTreeSet::new();
    let is_first = |line: &String| seen.insert(line.split(':').next().map(str::to_owned));
    let (mut first, others): (Vec<String>, Vec<String>) = lines.into_iter().partition(is_first);
    first.sort_by_key(|line| line.starts_with("theorems/"));
    first.into_iter().chain(others)
}

fn other_build_text(other: &Facts, this: &Facts, archive: &Path) -> String {
    let build = |facts: &Facts| format!("{} of sources {}", facts.version(), &facts.source_sha256[..12]);
    format!(
        "archived by another build (slipmode {}; this is {}); compare with: slipmode replay --other-build {}",
        build(other),
        build(this),
        word_of(archive)
    )
}

/// An archive, unpacked.
pub struct Opened {
    container: Vec<u8>,
    /// Its files.
    pub files: Files,
    time: ReleaseTime,
}

/// Reads an archive.
///
/// # Errors
/// Every fault of the container.
pub fn open(path: &Path) -> Result<Opened, Failure> {
    let caps = Caps::default();
    let container = read_file_up_to(path, caps.container_bytes)?;
    let (files, time) = unpack(&container, &caps).map_err(|faults| Failure::place_lines(path, faults))?;
    Ok(Opened { container, files, time })
}

/// One replay.
struct Replay<'r> {
    place: &'r Path,
    opened: &'r Opened,
    maker: Maker,
    facts: &'r Facts,
    budget: Budget,
}

impl Replay<'_> {
    fn run(&self, limits: Limits, progress: &Progress) -> Result<(Product, Reproduction), Failure> {
        let inputs = below(&self.opened.files, INPUT_FOLDER);
        let inputs: Files = inputs.map(|(_, path, bytes)| (path.to_string(), bytes.clone())).collect();
        let inside = self.place.join(INPUT_FOLDER);
        let fault = |(path, bytes): (&String, &Vec<u8>)| {
            self.budget.digits_fault(&format!("{INPUT_FOLDER}/{path}"), &String::from_utf8_lossy(bytes))
        };
        self.refuse(inputs.iter().filter_map(fault).collect())?;
        let watch = Watch::start(self.place, self.budget);
        let (folder, read) = read_report_from(Source::Archive(inside.clone(), inputs.clone()), limits)?;
        let requests = requests(folder.plan.scenes.iter().zip(&folder.scenes));
        self.refuse(self.budget.faults(&requests))?;
        watch.name_requests(&requests);
        let product = recompute(&folder, &inside, progress)?;
        let theorems = theorems(&folder, &product.ledger)?;
        let has_codecheck = self.opened.files.contains_key(CODECHECK_FILE);
        let sources = self.opened.files.get(SOURCES_FILE).map(Vec::as_slice);
        let parts = parts(&folder, &read, &product, &theorems, self.facts, has_codecheck, sources);
        let mut found = reproduction(&self.opened.container, &self.opened.files, &parts, &self.maker);
        found.differences.extend(problems(&product.ledger));
        found.not_verified.extend(sources.map(|_| {
            format!("{SOURCES_FILE}: that these are the sources of the program that made the archive")
        }));
        Ok((product, found))
    }

    fn refuse(&self, faults: Vec<String>) -> Result<(), Failure> {
        let lines: Vec<String> =
            faults.iter().map(|fault| format!("{fault}; --budget FACTOR lifts it")).collect();
        if lines.is_empty() { Ok(()) } else { Err(Failure::place_lines(self.place, lines)) }
    }

    /// What was compared, in words.
    fn compared(&self) -> &'static str {
        match self.maker {
            Maker::ThisBuild => "archived by this build: all bytes compared",
            Maker::OtherBuild(_) => {
                "archived by another build: all files compared, numbers up to one unit of their last digit"
            }
        }
    }
}
