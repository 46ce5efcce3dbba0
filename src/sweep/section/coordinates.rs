//! The coordinates of a sweep's points: each of the seven quantities is one decimal, an axis, or a span.

use crate::scene::section::{Entry, Section};
use crate::scene::{AllowedRange, Faults, ParametersSection, Problem, Quantity, nearest};
use crate::sweep::section::ReadParameters;
use slipmode_core::number::Rational;

/// The most points along one axis: their coordinates are held in memory.
const MOST_AXIS_POINTS: u64 = 1_000_000;

/// How one of the seven quantities goes through a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Coordinate {
    /// The same at every point: the decimal as written.
    Fixed(Rational),
    /// The values of a grid's axis, both ends included.
    Axis {
        /// Between which ends, and how.
        span: Span,
        /// How many, at least 2.
        points: u32,
    },
    /// Any value of a span, for samples.
    Anywhere(Span),
}

/// A stretch between two positive ends, from < to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Span {
    /// The first value.
    pub from: Rational,
    /// The last value.
    pub to: Rational,
    /// What is spread evenly: the value or its logarithm.
    pub spacing: Spacing,
}

/// What is spread evenly over a span.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// The logarithm.
    Logarithmic,
    /// The value itself.
    Linear,
}

impl Coordinate {
    /// How many values a grid takes of it.
    #[must_use]
    pub fn points(&self) -> u64 {
        match self {
            Self::Axis { points, .. } => u64::from(*points),
            Self::Fixed(_) | Self::Anywhere(_) => 1,
        }
    }

    /// Whether it has a column of its own.
    #[must_use]
    pub fn varies(&self) -> bool {
        !matches!(self, Self::Fixed(_))
    }
}

/// The seven of a grid.
pub(crate) fn grid_coordinates(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
    faults: &mut Faults,
) -> Option<[Coordinate; 7]> {
    all_seven(section, parameters, faults, |section, span, faults| {
        let points = section
            .required("points", &format!("a whole number from 2 to {MOST_AXIS_POINTS}"), faults)
            .and_then(|entry| entry.whole(2..=MOST_AXIS_POINTS, faults))?;
        Some(Coordinate::Axis { span: span?, points: u32::try_from(points).ok()? })
    })
}

/// The seven of samples.
pub(crate) fn sample_coordinates(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
    faults: &mut Faults,
) -> Option<[Coordinate; 7]> {
    all_seven(section, parameters, faults, |_, span, _| span.map(Coordinate::Anywhere))
}

/// Makes a coordinate of a table's span, and of what else the table states.
type FromTable = fn(&mut Section<'_>, Option<Span>, &mut Faults) -> Option<Coordinate>;

fn all_seven(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
    faults: &mut Faults,
    from_table: FromTable,
) -> Option<[Coordinate; 7]> {
    let read = Quantity::ALL.map(|quantity| match section.optional(quantity.key()) {
        Some(entry) if entry.is_table() => coordinate_of_table(&entry, faults, from_table),
        Some(entry) => entry.decimal(AllowedRange::PHYSICAL, faults).map(Coordinate::Fixed),
        None => match parameters {
            // What is wrong with the parameters is reported already.
            Some(None) => None,
            Some(Some(parameters)) => {
                of_parameters(parameters, quantity).or_else(|| missing(section, quantity, faults))
            }
            None => missing(section, quantity, faults),
        },
    });
    let [a, b, d, k, m, s, v] = read;
    Some([a?, b?, d?, k?, m?, s?, v?])
}

fn missing(section: &mut Section<'_>, quantity: Quantity, faults: &mut Faults) -> Option<Coordinate> {
    let allowed = format!(
        "a number from {}, {{ from = …, to = …, … }}, or its value in [parameters]",
        AllowedRange::PHYSICAL.text()
    );
    section.required(quantity.key(), &allowed, faults).and(None)
}

fn of_parameters(parameters: &ParametersSection, quantity: Quantity) -> Option<Coordinate> {
    let slider = &parameters.slider;
    let value = match quantity {
        Quantity::DirectEffect => Some(&slider.direct_effect),
        Quantity::EvolutionEffect => Some(&slider.evolution_effect),
        Quantity::CriticalSlipDistance => Some(&slider.critical_slip_distance_m),
        Quantity::Stiffness => Some(&slider.stiffness_pa_per_m),
        Quantity::MassPerArea => Some(&slider.mass_per_area_kg_per_m2),
        Quantity::NormalStress => parameters.normal_stress_pa.as_ref(),
        Quantity::LoadingVelocity => parameters.loading_velocity_m_per_s.as_ref(),
    };
    value.cloned().map(Coordinate::Fixed)
}

fn coordinate_of_table(entry: &Entry<'_>, faults: &mut Faults, from_table: FromTable) -> Option<Coordinate> {
    let mut section = entry.section(faults)?;
    let span = read_span(entry, &mut section, faults);
    let coordinate = from_table(&mut section, span, faults);
    section.finish(faults);
    coordinate
}

fn read_span(entry: &Entry<'_>, section: &mut Section<'_>, faults: &mut Faults) -> Option<Span> {
    let range = AllowedRange::PHYSICAL;
    let mut end =
        |key| section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
    let (from, to) = (end("from"), end("to"));
    let spacing = match section.optional("spacing") {
        Some(entry) => read_spacing(&entry, faults),
        None => Some(Spacing::Logarithmic),
    };
    let (from, to) = (from?, to?);
    if from >= to {
        faults.push(entry.fault(if from == to { Problem::EmptyRange } else { Problem::ReversedRange }));
        return None;
    }
    Some(Span { from, to, spacing: spacing? })
}

fn read_spacing(entry: &Entry<'_>, faults: &mut Faults) -> Option<Spacing> {
    const WORDS: [&str; 2] = ["logarithmic", "linear"];
    match entry.text(faults)?.as_str() {
        "logarithmic" => Some(Spacing::Logarithmic),
        "linear" => Some(Spacing::Linear),
        word => {
            let near = nearest(word, WORDS).map(str::to_string);
            faults.push(entry.fault(Problem::UnknownWord { nearest: near, allowed: WORDS.join(", ") }));
            None
        }
    }
}
