//! A scene with a sweep, read: its section, its digest, and its work.

use std::path::{Path, PathBuf};

use slipmode::archive::sha256_hex;
use slipmode::experiments::Scene;
use slipmode::scene::Limits;
use slipmode::sweep::{PointSource, SweepPoints, SweepSection, SweepWork};
use slipmode_core::dynamics::Options;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::{InertialThreshold, is_allowed_over_box};

use crate::cli::classify::rows::ClassifyRows;
use crate::cli::environment::SOURCE_SHA256;
use crate::cli::failure::Failure;
use crate::cli::input::{lacks, read_small_file};
use crate::cli::options::OVER_BOX;
use crate::cli::simulate::over_box::DEFAULT_RUNS;
use crate::cli::simulate::rows::SimulateRows;
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

/// The program's version with the digest of its sources: other sources may round otherwise.
pub fn version() -> String {
    format!("{} {}", env!("CARGO_PKG_VERSION"), SOURCE_SHA256)
}

/// Reads a scene that has a `[sweep]`.
///
/// # Errors
/// Every fault of the scene.
pub fn load(place: &Path) -> Result<Loaded, Failure> {
    let bytes = read_small_file(place)?;
    let scene = Scene::parse(&place.display().to_string(), &bytes, &Limits::default())?;
    let threshold = scene.threshold();
    let Some(section) = scene.sweep else {
        return Err(lacks(place, "sweep", "a [sweep] section with its work and its points").into());
    };
    let list = match &section.points {
        SweepPoints::List { file } => Some(place.parent().unwrap_or(Path::new("")).join(file)),
        _ => None,
    };
    Ok(Loaded { name: scene.name, section, scene_digest: sha256_hex(&bytes), threshold, list })
}

impl Loaded {
    /// The sweep's points, with the work at each.
    ///
    /// # Errors
    /// When the list is at fault.
    pub fn points(&self) -> Result<Points, Failure> {
        match &self.section.work {
            SweepWork::Classify => {
                if self.section.points.has_error_bars() && !is_allowed_over_box(&self.threshold) {
                    return Err(Failure::Refused(format!(
                        "the sweep needs an inertial_threshold with {OVER_BOX}"
                    )));
                }
                self.with(ClassifyRows::<false> { threshold: self.threshold.clone() }, Vec::new())
            }
            SweepWork::Boundary => self.with(BoundaryRows, Vec::new()),
            SweepWork::AsymptoteError => self.with(AsymptoteRows, Vec::new()),
            SweepWork::Simulate { laws, tolerance } => {
                let options = Options::at(nearest_f64(tolerance));
                // A list has one law for all its rows, or a column for them.
                let work =
                    SimulateRows::<false> { law: laws.first().copied(), options, box_runs: DEFAULT_RUNS };
                self.with(work, laws.clone())
            }
        }
    }

    fn with<W: PointWork + 'static>(&self, work: W, laws: Vec<EvolutionLaw>) -> Result<Points, Failure> {
        let source = PointSource::new(&self.section.points, self.scene_digest.as_bytes());
        Ok(match (&self.list, source) {
            (None, Some(source)) => Points::Made(Box::new(Made { source, laws, work })),
            (list, _) => {
                let place = list.as_deref().unwrap_or(Path::new(""));
                Points::Listed(Listed::new(place, work, self.section.block_points)?)
            }
        })
    }
}
