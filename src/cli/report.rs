//! `slipmode run`, `report` and `verify`: scenes and report folders in, folders of pages, tables and figures out.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;
use slipmode::claims::{Entry, Ledger, Strength, Verdict, verdict_words};
use slipmode::report::{
    PAGE_BUDGET_BYTES, Product, ReportError, produce, produce_scene, without_environment,
};
use slipmode::scene::{Limits, Source, first_lines};

use crate::cli::answer::Answer;
use crate::cli::claim::{print_warnings, problems, refuse_contradictions, verify_claim, warn_of_drift};
use crate::cli::environment::{ENVIRONMENT_FILE, Environment};
use crate::cli::failure::Failure;
use crate::cli::folder::{read_report, read_scene};
use crate::cli::options::{Arguments, refuse_stream_beside_json};
use crate::cli::output::{Output, OutputFolder, note_input_folder};
use crate::cli::path_text::{json_path, shown_path, word_of};
use crate::cli::planted_faults::verify_planted_faults;
use crate::cli::progress::Progress;
use crate::cli::terminal::count_of;
use crate::cli::tree::{Files, differences, listing};

/// The file name of a report's page.
const PAGE: &str = "index.html";

/// The files of a report besides its tables and figures.
const REPORT_FILES: [&str; 5] = [PAGE, "ledger.json", "ledger.md", "report.md", "theorems.md"];

/// The limit on grids, shared by the commands that read scenes.
#[derive(Debug, Args)]
pub struct LimitOption {
    /// Raises the limit on the points of one grid, line or sweep [default: 4194304]
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    max_points: Option<String>,
}

impl LimitOption {
    pub fn limits(&self) -> Result<Limits, Failure> {
        let mut arguments = Arguments::default();
        let given = arguments.whole("--max-points", self.max_points.as_deref(), 2..=u64::MAX);
        arguments.finish(Some(given.map_or_else(Limits::default, |max_points| Limits { max_points })))
    }
}

/// Options of `run`.
#[derive(Debug, Args)]
pub struct RunOptions {
    /// The scene
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// The folder to write [default: target/run/NAME, with the scene's name]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// One JSON object instead of text: the tables and figures, and their folder
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: LimitOption,
}

/// Options of `report` and `verify`.
#[derive(Debug, Args)]
pub struct ReportOptions {
    /// The report's folder, with report.toml, claims.toml, equations.toml, scenes/ and prose/
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// The folder to write [default: target/report/NAME, with the report's name]
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    /// Writes what a published copy contains: no versions and times but in environment.json, and no page if report.toml has `publish_page = false`
    #[arg(long)]
    for_publication: bool,
    /// One JSON object instead of text: the numbers of verdicts and the page's place; of `verify` also claims and differences
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: LimitOption,
}

/// Options of `verify`.
#[derive(Debug, Args)]
pub struct VerifyOptions {
    #[command(flatten)]
    report: ReportOptions,
    /// Decides only this claim, writes nothing, and prints the evidence
    #[arg(long, value_name = "ID", conflicts_with_all = ["output", "for_publication", "json"])]
    claim: Option<String>,
    /// Alters the equations one place at a time, writes nothing, and prints which claims notice
    #[arg(long, conflicts_with_all = ["output", "for_publication", "claim", "json"])]
    planted_faults: bool,
    /// Also writes the result as a file in the form of JUnit, with a test for each claim; `-` is standard output, without the text or --json
    #[arg(long, value_name = "FILE.xml", conflicts_with_all = ["claim", "planted_faults"])]
    junit: Option<PathBuf>,
}

/// Computes all that a scene states, and writes its tables and figures.
///
/// # Errors
/// When the scene is at fault or the folder cannot be written.
pub fn run(options: &RunOptions, progress: &Progress) -> Result<(), Failure> {
    let environment = Environment::start();
    let lone = read_scene(&options.scene, options.limit.limits()?)?;
    let place = options.output.clone().unwrap_or_else(|| Path::new("target/run").join(&lone.scene.name));
    let output = OutputFolder::create(&place, &[])?;
    let mut files =
        progress.items(|progress| produce_scene(&lone.scene, &lone.equations, &lone.references, progress));
    let (names, listing) = (json!(files.keys().collect::<Vec<_>>()), listing(&files, &place));
    files.insert(ENVIRONMENT_FILE.into(), environment.to_json());
    output.commit(&files)?;
    Answer::to(json!({ "scene": json_path(&options.scene) }))
        .with("output", json_path(&place))
        .with("files", names)
        .text(&listing)
        .print(options.json)
}

/// Makes a report.
///
/// # Errors
/// When the report's files are at fault or the folder cannot be written, and when a verdict does not pass the last gate.
pub fn report(options: &ReportOptions, progress: &Progress) -> Result<(), Failure> {
    let Made { product, place, publish_page, output, files } = make(options, progress)?;
    output.commit(&files)?;
    warn_of_drift(&product.ledger);
    let sound = refuse_contradictions(&product.ledger);
    let main_file = if options.for_publication && !publish_page { "report.md" } else { PAGE };
    let place = place.join(main_file);
    Answer::to(json!({ "report": json_path(&options.folder) }))
        .and(verdicts(&product.ledger))
        .with("operating_points", &product.ledger.operating_points)
        .with("output", json_path(&place))
        .text(&format!("{}\n", shown_path(&place)))
        .print(options.json)?;
    sound
}

/// Makes a report and compares it with its published copy.
///
/// # Errors
/// When a verdict is not the recorded one or a published byte moved; and as [`report`].
pub fn verify(options: &VerifyOptions, progress: &Progress) -> Result<(), Failure> {
    let VerifyOptions { report: options, claim, planted_faults, junit } = options;
    if *planted_faults {
        return verify_planted_faults(&read_report(&options.folder, options.limit.limits()?)?, progress);
    }
    if let Some(id) = claim {
        return verify_claim(&read_report(&options.folder, options.limit.limits()?)?, id, progress);
    }
    refuse_stream_beside_json("--junit", junit.as_deref(), options.json)?;
    let mut junit_output = junit.as_deref().map(Output::create).transpose()?;
    let published = published_copy(&options.folder)?;
    let Made { product, place, publish_page, output, files } = make(options, progress)?;
    let mut moved = if published.exists() {
        differences(&published_files(&product.files, publish_page), &published)?
    } else {
        Vec::new()
    };
    moved.extend(product.files.get(PAGE).and_then(|page| over_budget(page.len())));
    let mut drift = problems(&product.ledger);
    drift.extend(product.ledger.overstated().map(|entry| {
        let stated = verdict_words(entry.finding.verdict, entry.finding.strength);
        format!("{}: `{stated}` is stronger than its weakest part", entry.id)
    }));
    let (steps, argued) = product.ledger.proof_steps();
    let steps = count_of(steps, "distinct proof step");
    let place = place.join(PAGE);
    let copy =
        if published.exists() { "" } else { "there is no published copy: only the verdicts were compared\n" };
    let answer = Answer::to(json!({ "report": json_path(&options.folder) }))
        .list("claims", product.ledger.claims.iter().map(claim_part))
        .and(verdicts(&product.ledger))
        .text(&format!("{steps}, {argued} of them without a certificate\n"))
        .text(&format!("{}\n{copy}", shown_path(&place)))
        .with("operating_points", &product.ledger.operating_points)
        .with("output", json_path(&place))
        .with("has_published_copy", published.exists())
        .with("differences", drift.iter().chain(&moved).collect::<Vec<_>>());
    if let Some(junit) = &mut junit_output {
        let result = slipmode::report::junit(&product.ledger, &drift, &moved);
        let result = result.map_err(|error| unrenderable(&options.folder, &error))?;
        junit.write_all(result.as_bytes()).and_then(|()| junit.flush())?;
    }
    output.commit(&files)?;
    junit_output.map_or(Ok(()), Output::commit)?;
    if junit.as_deref() != Some(Path::new("-")) {
        answer.print(options.json)?;
    }
    refuse_differences(drift, moved, &options.folder)
}

/// A failure that lists the first verdicts and files that differ, if any does.
fn refuse_differences(drift: Vec<String>, moved: Vec<String>, folder: &Path) -> Result<(), Failure> {
    if drift.is_empty() && moved.is_empty() {
        return Ok(());
    }
    let [verdicts, files] = [count_of(drift.len(), "verdict"), count_of(moved.len(), "file")];
    let counts = format!("differences: {verdicts}, {files}");
    let hint = format!(
        "check the differences; `slipmode report {} -o NEW --for-publication` writes the copy to publish",
        word_of(folder)
    );
    let differences =
        first_lines(drift.into_iter().chain(moved), |more| format!("and {more} more; --json lists all"));
    let lines: Vec<String> = differences.into_iter().chain([counts, hint]).collect();
    Err(Failure::Check(lines.join("\n")))
}

/// What is wrong with a page of this size, if anything.
fn over_budget(bytes: usize) -> Option<String> {
    (bytes > PAGE_BUDGET_BYTES).then(|| format!("{PAGE}: {bytes} bytes (allowed: {PAGE_BUDGET_BYTES})"))
}

/// A report that was computed, with its folder and the files to write there.
struct Made {
    product: Product,
    place: PathBuf,
    publish_page: bool,
    output: OutputFolder,
    files: Files,
}

/// Reads and computes a report.
fn make(options: &ReportOptions, progress: &Progress) -> Result<Made, Failure> {
    let environment = Environment::start();
    let folder = read_report(&options.folder, options.limit.limits()?)?;
    let name = &folder.plan.name;
    let place = options.output.clone().unwrap_or_else(|| Path::new("target/report").join(name));
    let output = OutputFolder::create(&place, &REPORT_FILES)?;
    let product = progress.items(|progress| produce(&folder, environment.facts(), progress));
    let product = product.map_err(|error| unrenderable(&options.folder, &error))?;
    print_warnings(&product.ledger);
    let publish_page = folder.plan.publish_page;
    let mut files = published_files(&product.files, publish_page || !options.for_publication);
    if options.for_publication {
        files.values_mut().for_each(|text| *text = without_environment(text));
    }
    files.insert(ENVIRONMENT_FILE.into(), environment.to_json());
    Ok(Made { product, place, publish_page, output, files })
}

/// The folder of a report's published copy, in which the command writes nothing then.
///
/// # Errors
/// When something else is there, such as a link to a folder that is not mounted, or an output of the command lies there.
pub fn published_copy(folder: &Path) -> Result<PathBuf, Failure> {
    let place = folder.join("published");
    if place.symlink_metadata().is_ok() && !place.is_dir() {
        return Err(Failure::place(&place, "is no folder and no link to one"));
    }
    note_input_folder(&place).map_err(|why| Failure::place(&place, why))?;
    Ok(place)
}

/// The files of a report, with the page or without it.
fn published_files(files: &Files, with_page: bool) -> Files {
    files.iter().filter(|(name, _)| with_page || *name != PAGE).map(|(k, v)| (k.clone(), v.clone())).collect()
}

pub fn unrenderable(folder: &Path, error: &ReportError) -> Failure {
    Failure::place_lines(folder, error.to_string().lines())
}

/// States a claim with its verdict.
fn claim_part(entry: &Entry) -> Answer {
    Answer::default()
        .text(&claim_line(entry))
        .with("id", &entry.id)
        .with("verdict", entry.finding.verdict.as_str())
        .with("recorded", entry.expected.as_str())
        .with("strength", entry.finding.strength)
        .with("error_bars", entry.error_bars)
}

/// A line with the verdict on a claim, its strength, and its limit, its counter-example or why it was not checked.
pub fn claim_line(entry: &Entry) -> String {
    let finding = &entry.finding;
    let reason = finding.remarks.first().filter(|_| finding.verdict == Verdict::NotChecked);
    let [first, second] = match finding.verdict {
        Verdict::Fails => [&finding.counter_example, &finding.limit],
        _ => [&finding.limit, &finding.counter_example],
    };
    let because = first.as_ref().or(second.as_ref()).or(reason).map_or("", String::as_str);
    let strength = finding.strength.map_or("", Strength::as_str);
    let line = format!("{:<4} {:<13} {strength:<14}  {because}", entry.id, finding.verdict);
    format!("{}\n", line.trim_end())
}

/// Counts the claims of each verdict, under the verdict's word.
pub fn verdicts(ledger: &Ledger) -> Answer {
    let all = [Verdict::Holds, Verdict::HoldsWithin, Verdict::Fails, Verdict::NotChecked];
    let count = |verdict| ledger.claims.iter().filter(|entry| entry.finding.verdict == verdict).count();
    let counts = all.into_iter().fold(Answer::default(), |counts, it| counts.with(it.as_str(), count(it)));
    Answer::default().text(&summary(ledger)).part("verdicts", counts)
}

/// How many claims have each verdict: those of the paper, and apart from them those of each other source.
fn summary(ledger: &Ledger) -> String {
    let line = |source: Source| {
        let name = match source {
            Source::Paper => "claim",
            Source::Standard => "standard result",
            Source::Question => "question",
            Source::Assumption => "assumption",
            Source::Result => "own result",
        };
        let claims = count_of(ledger.of(source).count(), name);
        let count = |verdict, one, several| match ledger.count(source, verdict) {
            1 => format!("1 {one}"),
            count => format!("{count} {several}"),
        };
        format!(
            "{claims}: {}, {}, {}, {}\n",
            count(Verdict::Holds, "holds", "hold"),
            count(Verdict::HoldsWithin, "holds within a limit", "hold within a limit"),
            count(Verdict::Fails, "fails", "fail"),
            count(Verdict::NotChecked, "not checked", "not checked"),
        )
    };
    let has_others = ledger.of(Source::Paper).count() < ledger.claims.len();
    let is_shown = |source: &Source| match source {
        Source::Paper => !has_others || ledger.of(Source::Paper).next().is_some(),
        other => ledger.of(*other).next().is_some(),
    };
    Source::ALL.into_iter().filter(is_shown).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_over_the_budget_fails_and_one_at_it_does_not() {
        assert_eq!(over_budget(PAGE_BUDGET_BYTES), None);
        assert!(over_budget(PAGE_BUDGET_BYTES + 1).is_some_and(|fault| fault.contains("1048577 bytes")));
    }
}
