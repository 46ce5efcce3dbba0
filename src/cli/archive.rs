//! `slipmode archive`: a report computed and packed with everything that it rests on.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;
use slipmode::archive::{
    CODECHECK_FILE, Caps, Facts, Files, Parts, ReleaseTime, contents, open_fields, pack, sha256_hex,
};
use slipmode::claims::Ledger;
use slipmode::report::{Folder, Product, produce, without_environment};
use slipmode::theorems::{Published, archived};

use crate::cli::answer::Answer;
use crate::cli::claim::{refuse_contradictions, warn_of_drift};
use crate::cli::environment::{Environment, SOURCE_SHA256, versions};
use crate::cli::failure::Failure;
use crate::cli::folder::{Source, read_report_from};
use crate::cli::options::refuse_stream_beside_json;
use crate::cli::output::{Output, is_stream};
use crate::cli::path_text::{json_path, shown_path};
use crate::cli::progress::Progress;
use crate::cli::report::{LimitOption, published_copy, unrenderable, verdicts};

/// Options of `archive`.
#[derive(Debug, Args)]
pub struct Options {
    /// The report's folder, with report.toml, claims.toml, equations.toml, scenes/ and prose/
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// The archive to write; FILE.timings.json next to it records time and machine; `-` is standard output, without that file
    #[arg(short, long, value_name = "FILE.zip")]
    output: PathBuf,
    /// Also prepares the archive for a CODECHECK certificate: codecheck.yml with the manifest, and LICENSE; authors and reference are those of [paper] in report.toml
    #[arg(long)]
    codecheck: bool,
    /// Also packs the program's sources, so that a reader builds it without a network: FILE is what `cargo xtask sources` made in a checkout; it is not unpacked and checked
    #[arg(long, value_name = "FILE.tar.xz")]
    with_sources: Option<PathBuf>,
    /// One JSON object instead of text: the numbers of verdicts and the archive's SHA-256
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: LimitOption,
}

/// Computes a report and archives it.
///
/// # Errors
/// When the report's files are at fault, when a verdict does not pass the last gate, or when the archive cannot be written.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let environment = Environment::start();
    let time = stated_time(std::env::var_os("SOURCE_DATE_EPOCH"))?;
    refuse_stream_beside_json("--output", Some(&options.output), options.json)?;
    published_copy(&options.folder)?;
    let file = Some(options.output.as_path()).filter(|file| !is_stream(file));
    let mut archive = Output::create(&options.output)?;
    let timings = file.map(|file| Output::create(&timings_file(file))).transpose()?;
    let sources = options.with_sources.as_deref().map(read_sources).transpose()?;
    let (folder, inputs) = read_report_from(Source::Folder(options.folder.clone()), options.limit.limits()?)?;
    let product = recompute(&folder, &options.folder, progress)?;
    refuse_contradictions(&product.ledger)?;
    let facts = facts(time);
    let theorems = theorems(&folder, &product.ledger)?;
    let parts = parts(&folder, &inputs, &product, &theorems, &facts, options.codecheck, sources.as_deref());
    let packed = pack(&contents(&parts), time).map_err(Failure::Refused)?;
    archive.write_all(&packed).and_then(|()| archive.flush())?;
    timings.map_or(Ok(()), |timings| timings.finish(environment.to_json()))?;
    archive.commit()?;
    warn_of_drift(&product.ledger);
    let open = parts.codecheck.map_or_else(Vec::new, open_fields);
    let place = shown_path(&options.output);
    let open_lines: String = open.iter().map(|field| format!("{CODECHECK_FILE}: open: {field}\n")).collect();
    let digest = sha256_hex(&packed);
    Answer::to(json!({ "report": json_path(&options.folder) }))
        .and(verdicts(&product.ledger))
        .text(&format!("{open_lines}{digest}  {place}\n"))
        .with("sha256", &digest)
        .with("codecheck_open_fields", open)
        .with("output", json_path(&options.output))
        .print_beside(options.json, Some(&options.output))
}

/// Computes a report without what depends on the machine.
///
/// # Errors
/// When the report cannot be rendered.
pub fn recompute(folder: &Folder, place: &Path, progress: &Progress) -> Result<Product, Failure> {
    let product = progress.items(|progress| produce(folder, Vec::new(), progress));
    let mut product = product.map_err(|error| unrenderable(place, &error))?;
    // The texts of the report lose what depends on the machine.
    product.files.values_mut().for_each(|text| *text = without_environment(text));
    Ok(product)
}

/// The theorems on the proofs of a ledger, as an archive holds them.
///
/// # Errors
/// When the ledger cannot be read as it is published.
pub fn theorems(folder: &Folder, ledger: &Ledger) -> Result<BTreeMap<String, String>, Failure> {
    let published = Published {
        name: folder.plan.name.clone(),
        ledger: ledger.to_json().into_bytes(),
        claims: folder.claims.clone(),
        equations: folder.equations.clone(),
    };
    archived(&published).map_err(Failure::Refused)
}

/// What is known of this program.
pub fn facts(time: ReleaseTime) -> Facts {
    let versions = versions().map(|(name, version)| (name.to_string(), version)).into();
    Facts { versions, source_sha256: SOURCE_SHA256.into(), time }
}

/// Collects what is archived of a report.
pub fn parts<'p>(
    Folder { plan, .. }: &'p Folder,
    inputs: &'p Files,
    Product { ledger, files: product, .. }: &'p Product,
    theorems: &'p BTreeMap<String, String>,
    facts: &'p Facts,
    has_codecheck: bool,
    sources: Option<&'p [u8]>,
) -> Parts<'p> {
    let codecheck = has_codecheck.then_some(&plan.paper);
    Parts {
        name: &plan.name,
        title: &plan.title,
        inputs,
        product,
        ledger,
        theorems,
        facts,
        sources,
        codecheck,
    }
}

/// Reads a file of sources, which must begin and end like one and fit into an archive that is read again.
fn read_sources(path: &Path) -> Result<Vec<u8>, Failure> {
    let most = Caps::default().file_bytes;
    let bytes = std::fs::read(path).map_err(|error| Failure::place(path, &error.to_string()))?;
    if !bytes.starts_with(XZ) || !bytes.ends_with(XZ_END) {
        return Err(Failure::place(path, "is no whole .tar.xz file (`cargo xtask sources` makes one)"));
    }
    if bytes.len() as u64 > most {
        return Err(Failure::place(path, &format!("has {} bytes (allowed: {most})", bytes.len())));
    }
    Ok(bytes)
}

/// The first and the last bytes of each file that xz has compressed.
const XZ: &[u8] = b"\xfd7zXZ\0";
const XZ_END: &[u8] = b"YZ";

fn stated_time(variable: Option<OsString>) -> Result<ReleaseTime, Failure> {
    let Some(text) = variable else { return Ok(ReleaseTime::UNSTATED) };
    let seconds = text.to_str().and_then(|text| text.parse().ok());
    seconds.and_then(ReleaseTime::from_unix).ok_or_else(|| {
        let allowed = "must be a whole number of seconds since 1970 in the years 1980 to 2107";
        Failure::Refused(format!("environment: SOURCE_DATE_EPOCH = {}: {allowed}", text.display()))
    })
}

fn timings_file(archive: &Path) -> PathBuf {
    let mut name = archive.file_name().unwrap_or_default().to_os_string();
    name.push(".timings.json");
    archive.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stated_time_is_a_number_of_seconds() {
        assert_eq!(stated_time(None).unwrap(), ReleaseTime::UNSTATED);
        assert_eq!(stated_time(Some("315532800".into())).unwrap(), ReleaseTime::UNSTATED);
        for bad in ["", "yesterday", "-1", "0", "1e9", "99999999999"] {
            let Err(Failure::Refused(message)) = stated_time(Some(bad.into())) else { panic!("{bad:?}") };
            assert!(message.contains(&format!("SOURCE_DATE_EPOCH = {bad}")), "{message}");
        }
    }
}
