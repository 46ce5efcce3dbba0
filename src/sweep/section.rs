//! `[sweep]`: points for many machines, and what is computed at each.

mod coordinates;
mod summary;

use crate::scene::laws::read_laws;
use crate::scene::section::{Entry, Section};
use crate::scene::sections::{NAME_RULE, safe_name};
use crate::scene::{AllowedRange, Faults, ParametersSection, Problem, nearest};
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

/// The parameters of a scene as they were read: absent, faulty, or sound.
pub(crate) type ReadParameters<'p> = Option<Option<&'p ParametersSection>>;

const WORKS: [&str; 4] = ["classify", "boundary", "asymptote-error", "simulate"];

impl SweepSection {
    pub(crate) fn read(
        entry: &Entry<'_>,
        parameters: ReadParameters<'_>,
        faults: &mut Faults,
    ) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let is_list = section.optional("list").is_some();
        let work = read_work(&mut section, is_list, faults);
        let points = read_points(&mut section, parameters, faults);
        let block_points = match section.optional("block_points") {
            Some(entry) => entry.whole(1..=MOST_BLOCK_POINTS, faults),
            None => work.as_ref().map(SweepWork::usual_block_points),
        };
        let summary = section.optional("summary").map(|entry| SummarySection::read(&entry, faults));
        section.finish(faults);
        let summary = match summary {
            None => None,
            Some(read) => Some(read?),
        };
        Some(Self { work: work?, points: points?, block_points: block_points?, summary })
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

fn read_work(section: &mut Section<'_>, is_list: bool, faults: &mut Faults) -> Option<SweepWork> {
    let entry = section.required("work", &WORKS.join(", "), faults)?;
    match entry.text(faults)?.as_str() {
        "classify" => Some(SweepWork::Classify),
        "boundary" => Some(SweepWork::Boundary),
        "asymptote-error" => Some(SweepWork::AsymptoteError),
        "simulate" => read_simulate(section, is_list, faults),
        word => {
            let near = nearest(word, WORKS).map(str::to_string);
            faults.push(entry.fault(Problem::UnknownWord { nearest: near, allowed: WORKS.join(", ") }));
            // Their absence or presence is no news if the work is unknown.
            let _ = (section.optional("laws"), section.optional("tolerance"));
            None
        }
    }
}

fn read_simulate(section: &mut Section<'_>, is_list: bool, faults: &mut Faults) -> Option<SweepWork> {
    const LAWS: &str = "a list of \"slip\" and \"aging\"";
    let laws = match section.optional("laws") {
        None if is_list => Some(Vec::new()),
        None => section.required("laws", LAWS, faults).map(|_| Vec::new()),
        Some(entry) => read_laws(&entry, faults).filter(|laws| {
            let fits = !is_list || laws.len() == 1;
            if !fits {
                let wanted = "one law for a list, or none and a column `law` in its file".into();
                faults.push(entry.fault(Problem::Needs(wanted)));
            }
            fits
        }),
    };
    let range = AllowedRange::SIMULATION_TOLERANCE;
    let tolerance =
        section.required("tolerance", &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
    Some(SweepWork::Simulate { laws: laws?, tolerance: tolerance? })
}

/// Exactly one of `grid`, `samples` and `list`.
fn read_points(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
    faults: &mut Faults,
) -> Option<SweepPoints> {
    let places = [section.optional("grid"), section.optional("samples"), section.optional("list")];
    if places.iter().flatten().count() != 1 {
        let one = "exactly one of [sweep.grid], [sweep.samples] and [sweep.list]";
        faults.push(section.fault("points", Problem::Needs(one.into())));
        return None;
    }
    let [grid, samples, list] = places;
    if let Some(entry) = grid {
        return read_grid(&entry, parameters, faults);
    }
    if let Some(entry) = samples {
        return read_samples(&entry, parameters, faults);
    }
    let mut section = list?.section(faults)?;
    let file = section.required("file", NAME_RULE, faults).and_then(|entry| safe_name(&entry, faults));
    section.finish(faults);
    Some(SweepPoints::List { file: file? })
}

fn read_grid(entry: &Entry<'_>, parameters: ReadParameters<'_>, faults: &mut Faults) -> Option<SweepPoints> {
    let mut section = entry.section(faults)?;
    let coordinates = grid_coordinates(&mut section, parameters, faults);
    section.finish(faults);
    let coordinates = check_varies(entry, coordinates?, faults)?;
    let points = coordinates.iter().fold(1u64, |product, axis| product.saturating_mul(axis.points()));
    if points > MOST_SWEEP_POINTS {
        let allowed = format!("at most {MOST_SWEEP_POINTS} points in all");
        faults.push(entry.fault(Problem::OutOfRange { allowed }));
        return None;
    }
    Some(SweepPoints::Grid(Box::new(coordinates)))
}

fn read_samples(
    entry: &Entry<'_>,
    parameters: ReadParameters<'_>,
    faults: &mut Faults,
) -> Option<SweepPoints> {
    let mut section = entry.section(faults)?;
    let count = section
        .required("count", &format!("a whole number from 1 to {MOST_SWEEP_POINTS}"), faults)
        .and_then(|entry| entry.whole(1..=MOST_SWEEP_POINTS, faults));
    let coordinates = sample_coordinates(&mut section, parameters, faults);
    section.finish(faults);
    let coordinates = check_varies(entry, coordinates?, faults)?;
    Some(SweepPoints::Samples { count: count?, coordinates: Box::new(coordinates) })
}

/// Identical points have no column that distinguishes them.
fn check_varies(
    entry: &Entry<'_>,
    coordinates: [Coordinate; 7],
    faults: &mut Faults,
) -> Option<[Coordinate; 7]> {
    if coordinates.iter().any(Coordinate::varies) {
        return Some(coordinates);
    }
    faults.push(
        entry.fault(Problem::Needs("at least one quantity that varies: { from = …, to = …, … }".into())),
    );
    None
}

#[cfg(test)]
mod tests;
