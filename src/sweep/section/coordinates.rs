//! The coordinates of a sweep's points: each of the seven quantities is one decimal, an axis, or a span.

use crate::scene::section::Section;
use crate::scene::{AllowedRange, Quantity, Uncertain, all_of};
use crate::sweep::section::ReadParameters;
use slipmode_core::number::Rational;

/// The most points along one axis: their coordinates are held in memory.
const MOST_AXIS_POINTS: u64 = 1_000_000;

/// How one of the seven quantities goes through a sweep.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Coordinate {
    /// The same at every point: the decimal as written, perhaps with an error bar.
    Fixed(Uncertain),
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

slipmode_algebra::named! {
    /// What is spread evenly over a span.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Spacing {
        /// The logarithm.
        Logarithmic = "logarithmic",
        /// The value itself.
        Linear = "linear",
    }
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
) -> Option<[Coordinate; 7]> {
    all_seven(section, parameters, |section, span| {
        let points = section.whole("points", 2..=MOST_AXIS_POINTS);
        Coordinate::Axis { span, points }
    })
}

/// The seven of samples.
pub(crate) fn sample_coordinates(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
) -> Option<[Coordinate; 7]> {
    all_seven(section, parameters, |_, span| Coordinate::Anywhere(span))
}

/// What a table is read as, after its span.
type FromTable = fn(&mut Section<'_>, Span) -> Coordinate;

fn all_seven(
    section: &mut Section<'_>,
    parameters: ReadParameters<'_>,
    from_table: FromTable,
) -> Option<[Coordinate; 7]> {
    let read = Quantity::ALL.map(|quantity| match section.optional(quantity.as_str()) {
        Some(entry) if entry.is_table() => entry.table(|section| coordinate_of_table(section, from_table)),
        Some(entry) => entry.uncertain(AllowedRange::PHYSICAL).map(Coordinate::Fixed),
        // What is wrong with the parameters is reported already.
        None => match parameters?.and_then(|parameters| parameters.uncertain(quantity)) {
            Some(value) => Some(Coordinate::Fixed(value)),
            None => {
                let allowed = format!(
                    "a number from {}, {{ from = …, to = …, … }}, or its value in [parameters]",
                    AllowedRange::PHYSICAL.text()
                );
                section.required(quantity.as_str(), &allowed).and(None)
            }
        },
    });
    all_of(read)
}

fn coordinate_of_table(section: &mut Section<'_>, from_table: FromTable) -> Coordinate {
    let (from, to) = section.ends();
    let spacing = section.optionally("spacing", |entry| entry.word(&Spacing::ALL, Spacing::as_str));
    from_table(section, Span { from, to, spacing: spacing.unwrap_or(Spacing::Logarithmic) })
}
