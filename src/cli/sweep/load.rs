//! A scene with a sweep, read: its section, its digest, and its work.

use std::path::{Path, PathBuf};

use slipmode::archive::sha256_hex;
use slipmode::experiments::Scene;
use slipmode::scene::{Fault, Limits, Problem};
use slipmode::sweep::{PointSource, SweepPoints, SweepSection, SweepWork};
use slipmode_core::dynamics::Start;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::InertialThreshold;

use crate::cli::classify::rows::ClassifyRows;
use crate::cli::environment::SOURCE_SHA256;
use crate::cli::failure::Failure;
use crate::cli::input::read_small_file;
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
    /// SHA-256 of the scene's file.
    pub scene_digest: String,
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
    format!("{} {}", env!("CARGO_PKG_VERSION"), SOURCE_SHA256)
}

/// Reads a scene that has a `[sweep]`.
///
/// # Errors
/// Every fault of the scene.
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
    Ok(Loaded { name: scene.name, section, scene_digest: sha256_hex(&bytes), threshold, list })
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
        let source = PointSource::new(&self.section.points, self.scene_digest.as_bytes());
        let points = match (&self.list, source) {
            (None, Some(source)) => Points::Made(Box::new(Made { source, laws, work })),
            (list, _) => {
                let place = list.as_deref().unwrap_or(Path::new(""));
                Points::Listed(Listed::new(place, work, self.section.block_points)?)
            }
        };
        task.perform(self, &points)
    }
}
