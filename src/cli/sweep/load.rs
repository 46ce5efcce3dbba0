//! A scene with a sweep, read: its section, its digest, and its work.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};
use slipmode::archive::sha256_hex;
use slipmode::experiments::Scene;
use slipmode::scene::{Fault, Limits, Problem};
use slipmode::sweep::PointSource;
use slipmode::sweep::{SweepPoints, SweepSection, SweepWork};
use slipmode_core::dynamics::Start;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::InertialThreshold;

use crate::cli::classify::rows::ClassifyRows;
use crate::cli::failure::Failure;
use crate::cli::input::{read_small_file, unreadable};
use crate::cli::simulate::rows::SimulateRows;
use crate::cli::simulate::run::Settings;
use crate::cli::sweep::asymptote_rows::AsymptoteRows;
use crate::cli::sweep::boundary_rows::BoundaryRows;
use crate::cli::sweep::points::{Listed, Points};
use crate::cli::sweep::work::{Made, PointWork};

/// A scene with a sweep.
pub struct Loaded {
    /// The scene's name.
    pub name: String,
    /// Its section.
    pub section: SweepSection,
    /// SHA-256 of the scene's file, and of the list that it names.
    pub digest: String,
    threshold: InertialThreshold,
    list: Option<PathBuf>,
}

/// What is done with the points, whatever the work at each is.
pub trait Task {
    /// Does it.
    ///
    /// # Errors
    /// Whatever the task meets.
    fn perform<W: PointWork>(self, loaded: &Loaded, points: &Points<W>) -> Result<(), Failure>;
}

/// The program's version with the digest of its sources: other sources may round otherwise.
pub fn version() -> String {
    format!("{} {}", env!("CARGO_PKG_VERSION"), env!("SLIPMODE_SOURCE_SHA256"))
}

/// Reads a scene that has a `[sweep]`.
///
/// # Errors
/// Every fault of the scene; a list that cannot be read.
pub fn load(place: &Path) -> Result<Loaded, Failure> {
    let file = place.display().to_string();
    let bytes = read_small_file(place)?;
    let scene = Scene::parse(&file, &bytes, &Limits::default())?;
    let threshold = scene.threshold();
    let Some(section) = scene.sweep else {
        let allowed = "a [sweep] section with its work and its points".into();
        return Err(Fault {
            file,
            line: None,
            key: "sweep".into(),
            value: None,
            problem: Problem::Missing { allowed },
        }
        .into());
    };
    let list = match &section.points {
        SweepPoints::List { file } => Some(place.parent().unwrap_or(Path::new("")).join(file)),
        _ => None,
    };
    let mut digest = sha256_hex(&bytes);
    if let Some(list) = &list {
        digest = sha256_hex(format!("{digest} {}", file_digest(list)?).as_bytes());
    }
    Ok(Loaded { name: scene.name, section, digest, threshold, list })
}

/// The digest of a file of any size.
fn file_digest(place: &Path) -> Result<String, Failure> {
    let cannot = |error: io::Error| Failure::from(unreadable(place, &error));
    let mut file = File::open(place).map_err(cannot)?;
    let (mut digest, mut buffer) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer).map_err(cannot)? {
            0 => return Ok(digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect()),
            count => digest.update(&buffer[..count]),
        }
    }
}

impl Loaded {
    /// Does a task with the sweep's points.
    ///
    /// # Errors
    /// When the list is at fault, and whatever the task meets.
    pub fn perform(&self, task: impl Task) -> Result<(), Failure> {
        match &self.section.work {
            SweepWork::Classify => {
                self.with(ClassifyRows { threshold: self.threshold.clone() }, Vec::new(), task)
            }
            SweepWork::Boundary => self.with(BoundaryRows, Vec::new(), task),
            SweepWork::AsymptoteError => self.with(AsymptoteRows, Vec::new(), task),
            SweepWork::Simulate { laws, tolerance } => {
                let tolerance = nearest_f64(tolerance);
                let settings = Settings { tolerance, start: Start::default() };
                // A list has one law for all its rows, or a column for them.
                let law = laws.first().copied();
                self.with(SimulateRows { law, settings }, laws.clone(), task)
            }
        }
    }

    fn with<W: PointWork>(&self, work: W, laws: Vec<EvolutionLaw>, task: impl Task) -> Result<(), Failure> {
        let points = match (&self.list, PointSource::new(&self.section.points, self.digest.as_bytes())) {
            (None, Some(source)) => Points::Made(Box::new(Made { source, laws, work })),
            (list, _) => Points::Listed(Listed::new(list.as_deref().unwrap_or(Path::new("")), work)?),
        };
        task.perform(self, &points)
    }
}
