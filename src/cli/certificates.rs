//! `slipmode certificates`: proves all certificates of a scene again, or writes new ones.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;
use slipmode::archive::sha256_hex;
use slipmode::experiments::Scene;
use slipmode::experiments::certificates::{CertificateFile, Stored, certify_grid, prove_again, written};
use slipmode_core::friction::EvolutionLaw;

use crate::cli::answer::Answer;
use crate::cli::failure::Failure;
use crate::cli::folder::read_scene;
use crate::cli::input::{lacks, read_small_file};
use crate::cli::options::Arguments;
use crate::cli::output::{Output, is_stream};
use crate::cli::path_text::json_path;
use crate::cli::progress::Progress;
use crate::cli::report::LimitOption;
use crate::cli::words::law_of_word;

/// Options of `certificates`.
#[derive(Debug, Args)]
pub struct Options {
    /// The scene; its section [certificates] names the files
    #[arg(value_name = "SCENE.toml")]
    scene: PathBuf,
    /// Certifies the grid of the scene's [simulations] anew with this law, `slip` or `aging`, instead of proving its files again
    #[arg(long, value_name = "LAW", requires = "output", allow_hyphen_values = true)]
    law: Option<String>,
    /// Where to write the new certificates; `-` is standard output, which otherwise gets the digest of the file
    #[arg(short, long, value_name = "OUT.csv", requires = "law")]
    output: Option<PathBuf>,
    /// One JSON object instead of text: how many certificates there are and how many were proved, or the digest of a new file
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limit: LimitOption,
}

/// Runs the command.
///
/// # Errors
/// When the scene or a file is at fault, an output cannot be written, or a certificate is not proved again.
pub fn run(options: &Options, progress: &Progress) -> Result<(), Failure> {
    let mut arguments = Arguments::default();
    let law = options.law.as_ref().and_then(|word| arguments.number("--law", word, law_of_word));
    let output = options.output.as_deref();
    arguments.refuse_stream("--output", output.filter(|_| options.json), "the object");
    let law = arguments.finish(Some(law))?;
    match law.zip(output) {
        Some((law, place)) => options.certify(law, place, *progress),
        None => options.prove(*progress),
    }
}

impl Options {
    fn certify(&self, law: EvolutionLaw, place: &Path, progress: Progress) -> Result<(), Failure> {
        let bytes = read_small_file(&self.scene)?;
        let scene = Scene::parse(&self.scene.display().to_string(), &bytes, &self.limit.limits()?)?;
        let (Some(section), Some(parameters)) = (&scene.simulations, &scene.parameters) else {
            let allowed = "a grid of loading velocities and normal stresses";
            return Err(lacks(&self.scene, "simulations", allowed).into());
        };
        let is_stdout = is_stream(place);
        let output = Output::create(place)?;
        let rows = progress.spinner("certifying", || certify_grid(&parameters.slider, section, law));
        let text = written(&rows);
        let digest = sha256_hex(text.as_bytes());
        output.finish(text)?;
        let line = if is_stdout { String::new() } else { format!("sha256 = \"{digest}\"\n") };
        Answer::to(json!({ "scene": json_path(&self.scene), "law": law.as_str() }))
            .with("points", rows.len())
            .with("certificates", rows.iter().filter(|row| row.certificate.is_ok()).count())
            .with("sha256", &digest)
            .with("output", json_path(place))
            .text(&line)
            .print(self.json)
    }

    fn prove(&self, progress: Progress) -> Result<(), Failure> {
        let lone = read_scene(&self.scene, self.limit.limits()?)?;
        let Some(section) = &lone.scene.certificates else {
            let allowed = "a section that names files of certificates";
            return Err(lacks(&self.scene, "certificates", allowed).into());
        };
        let of = |file: &CertificateFile| lone.references.certificates.get(&file.name).cloned();
        let rows: Vec<Stored> = section.files.iter().filter_map(of).flatten().collect();
        let all: Vec<usize> = (0..rows.len()).collect();
        let again = progress.spinner("proving again", || prove_again(&rows, &all));
        let refused: Vec<String> = again
            .iter()
            .filter_map(|one| Some(format!("{}: {}", rows[one.row].place(), one.refusal.as_ref()?)))
            .collect();
        let proved = again.len() - refused.len();
        let rest = match rows.len() - again.len() {
            0 => String::new(),
            without => format!("; {without} of {} points have none", rows.len()),
        };
        Answer::to(json!({ "scene": json_path(&self.scene) }))
            .with("points", rows.len())
            .with("certificates", again.len())
            .with("proved_again", proved)
            .with("refused", &refused)
            .text(&format!("{proved} of {} certificates proved again{rest}\n", again.len()))
            .print(self.json)?;
        Failure::check_none(refused)
    }
}
