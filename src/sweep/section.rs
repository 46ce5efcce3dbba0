//! `[sweep]`: points for many machines, and what is computed at each.

mod coordinates;
mod summary;

use crate::scene::section::{Entry, Section};
use crate::scene::sections::NAME_RULE;
use crate::scene::{AllowedRange, ParametersSection, Problem};
pub use coordinates::{Coordinate, Spacing, Span};
use coordinates::{grid_coordinates, sample_coordinates};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;
pub use summary::{ColumnBins, ColumnStatistics, MOST_SUMMARY_CELLS, Statistic, SummarySection};

/// The most points of one sweep, whatever machines there are.
pub const MOST_SWEEP_POINTS: u64 = 1_000_000_000_000;

/// The most points of one block: its lines are held in memory.
const MOST_BLOCK_POINTS: u64 = 1 << 20;

/// `[sweep]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SweepSection {
    /// What is computed at each point.
    pub work: SweepWork,
    /// Where.
    pub points: SweepPoints,
    /// Points of a block; the last one may have fewer.
    pub block_points: u64,
    /// What blocks hold in place of rows.
    pub summary: Option<SummarySection>,
}

/// What a sweep computes at each point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SweepWork {
    /// Signs, spectral class, slip mode, growth rate and frequency.
    Classify,
    /// The distance to the boundary max Im(s) = 0, and the asymptotes' error at its nearest point.
    Boundary,
    /// The asymptotes' error at the nearest point of the boundary at the same V0, and nothing else.
    AsymptoteError,
    /// The nonlinear slider.
    Simulate {
        /// The evolution laws, each once; none when a column of the list chooses it.
        laws: Vec<EvolutionLaw>,
        /// Permitted relative error of peak velocity and period.
        tolerance: Rational,
    },
}

/// The points of a sweep. Coordinates stand in the order of [`crate::scene::Quantity::ALL`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SweepPoints {
    /// Every combination of the axes' values; the last axis varies fastest.
    Grid(Box<[Coordinate; 7]>),
    /// Points of low discrepancy in the box that the spans make.
    Samples {
        /// How many.
        count: u64,
        /// The box.
        coordinates: Box<[Coordinate; 7]>,
    },
    /// The rows of a CSV file, which stands next to the scene.
    List {
        /// The file's name, safe by [`crate::scene::check_name`]; it has no folder.
        file: String,
    },
}

/// The parameters of a scene as they were read: faulty, absent, or sound.
pub(crate) type ReadParameters<'p> = Option<Option<&'p ParametersSection>>;

const WORKS: [&str; 4] = ["classify", "boundary", "asymptote-error", "simulate"];

impl SweepSection {
    pub(crate) fn read(entry: &Entry<'_>, parameters: ReadParameters<'_>) -> Option<Self> {
        let read = |section: &mut Section<'_>| {
            let is_list = section.optional("list").is_some();
            let work = read_work(section, is_list);
            let points = read_points(section, parameters);
            let block_points = section.optionally("block_points", |entry| entry.whole(1..=MOST_BLOCK_POINTS));
            let summary = section.optionally("summary", |entry| entry.table(SummarySection::read));
            let (work, points) = (work?, points?);
            let is_of_points = matches!(work, SweepWork::Boundary | SweepWork::AsymptoteError);
            if is_of_points && points.has_error_bars() {
                let needs = "values without error bars, or the work classify or simulate, which take them";
                section.refuse(Problem::Needs(needs.into()));
            }
            let block_points = block_points.unwrap_or_else(|| work.usual_block_points());
            Some(Self { work, points, block_points, summary })
        };
        entry.table(read)?
    }
}

impl SweepPoints {
    /// Whether a value that is the same at every point has an error bar.
    pub(crate) fn has_error_bars(&self) -> bool {
        let is_uncertain = |coordinate: &Coordinate| match coordinate {
            Coordinate::Fixed(value) => !value.is_certain(),
            Coordinate::Axis { .. } | Coordinate::Anywhere(_) => false,
        };
        match self {
            Self::Grid(coordinates) | Self::Samples { coordinates, .. } => {
                coordinates.iter().any(is_uncertain)
            }
            Self::List { .. } => false,
        }
    }
}

impl SweepWork {
    /// Points of a block that take some seconds.
    fn usual_block_points(&self) -> u64 {
        match self {
            Self::Classify | Self::AsymptoteError => 1 << 18,
            Self::Boundary => 1 << 13,
            Self::Simulate { .. } => 1 << 8,
        }
    }
}

fn read_work(section: &mut Section<'_>, is_list: bool) -> Option<SweepWork> {
    match section.required("work", &WORKS.join(", "))?.word(&WORKS, |word| word) {
        Some("classify") => Some(SweepWork::Classify),
        Some("boundary") => Some(SweepWork::Boundary),
        Some("asymptote-error") => Some(SweepWork::AsymptoteError),
        Some(_) => Some(read_simulate(section, is_list)),
        None => {
            // Their absence or presence is no news if the work is unknown.
            let _ = (section.optional("laws"), section.optional("tolerance"));
            None
        }
    }
}

fn read_simulate(section: &mut Section<'_>, is_list: bool) -> SweepWork {
    let laws = match section.optional("laws") {
        None if is_list => Vec::new(),
        stated => {
            let laws = section.laws();
            if is_list
                && laws.len() > 1
                && let Some(entry) = stated
            {
                let wanted = "one law for a list, or none and a column `law` in its file".into();
                entry.refuse::<()>(Problem::Needs(wanted));
            }
            laws
        }
    };
    let tolerance = section.decimal("tolerance", AllowedRange::SIMULATION_TOLERANCE);
    SweepWork::Simulate { laws, tolerance }
}

/// Exactly one of `grid`, `samples` and `list`.
fn read_points(section: &mut Section<'_>, parameters: ReadParameters<'_>) -> Option<SweepPoints> {
    match ["grid", "samples", "list"].map(|key| section.optional(key)) {
        [Some(grid), None, None] => grid.table(|section| read_grid(section, parameters))?,
        [None, Some(samples), None] => samples.table(|section| read_samples(section, parameters))?,
        [None, None, Some(list)] => {
            list.table(|section| SweepPoints::List { file: section.name("file", NAME_RULE) })
        }
        _ => {
            let one = "exactly one of [sweep.grid], [sweep.samples] and [sweep.list]";
            section.fault("points", Problem::Needs(one.into()));
            None
        }
    }
}

fn read_grid(section: &mut Section<'_>, parameters: ReadParameters<'_>) -> Option<SweepPoints> {
    let coordinates = grid_coordinates(section, parameters)?;
    check_varies(section, &coordinates);
    let points = coordinates.iter().fold(1u64, |product, axis| product.saturating_mul(axis.points()));
    if points > MOST_SWEEP_POINTS {
        let allowed = format!("at most {MOST_SWEEP_POINTS} points in all");
        section.refuse(Problem::OutOfRange { allowed });
    }
    Some(SweepPoints::Grid(Box::new(coordinates)))
}

fn read_samples(section: &mut Section<'_>, parameters: ReadParameters<'_>) -> Option<SweepPoints> {
    let count = section.whole("count", 1..=MOST_SWEEP_POINTS);
    let coordinates = sample_coordinates(section, parameters)?;
    check_varies(section, &coordinates);
    Some(SweepPoints::Samples { count, coordinates: Box::new(coordinates) })
}

/// Identical points have no column that distinguishes them.
fn check_varies(section: &Section<'_>, coordinates: &[Coordinate; 7]) {
    if !coordinates.iter().any(Coordinate::varies) {
        let needs = "at least one quantity that varies: { from = …, to = …, … }";
        section.refuse(Problem::Needs(needs.into()));
    }
}

#[cfg(test)]
mod tests;
