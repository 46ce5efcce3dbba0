//! `[sweep.summary]`: what is kept of a sweep whose rows are too many to keep.

use crate::scene::section::{Entry, Section};
use crate::scene::{AllowedRange, Faults, LogAxis, Problem, nearest};

/// The most cells of a summary: they are held in memory.
pub const MOST_SUMMARY_CELLS: u64 = 1 << 20;

/// `[sweep.summary]`: rows are counted by bins of numbers and by words, and of some columns the extremes and sums are kept.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SummarySection {
    /// Columns of numbers in bins, in the order of the file.
    pub bins: Vec<ColumnBins>,
    /// Columns of words, each word apart.
    pub by: Vec<String>,
    /// Columns of which numbers are kept.
    pub numbers: Vec<ColumnStatistics>,
}

/// `[[sweep.summary.bins]]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnBins {
    /// The column.
    pub column: String,
    /// The edges of the bins: by the magnitude of the number, evenly in its logarithm.
    pub edges: LogAxis,
}

/// `[[sweep.summary.numbers]]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColumnStatistics {
    /// The column.
    pub column: String,
    /// What is kept, each once.
    pub statistics: Vec<Statistic>,
}

/// What is kept of the numbers of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Statistic {
    /// How many cells hold a finite number.
    Count,
    /// The least.
    Least,
    /// The greatest.
    Greatest,
    /// The sum, in the order of points within blocks and of blocks.
    Sum,
}

impl Statistic {
    /// Every statistic.
    pub const ALL: [Self; 4] = [Self::Count, Self::Least, Self::Greatest, Self::Sum];

    /// The word of scenes, and the end of a column's name.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Count => "count",
            Self::Least => "least",
            Self::Greatest => "greatest",
            Self::Sum => "sum",
        }
    }
}

const COLUMN: &str = "the name of a column";

impl SummarySection {
    pub(crate) fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let bins = optional_list(&mut section, "bins", faults, ColumnBins::read);
        let by = optional_list(&mut section, "by", faults, |entry, faults| entry.text(faults));
        let numbers = optional_list(&mut section, "numbers", faults, ColumnStatistics::read);
        section.finish(faults);
        let found = Self { bins: bins?, by: by?, numbers: numbers? };
        let cells = found
            .bins
            .iter()
            .fold(1u64, |cells, bins| cells.saturating_mul(u64::from(bins.edges.points) + 1));
        if cells > MOST_SUMMARY_CELLS {
            let allowed =
                format!("at most {MOST_SUMMARY_CELLS} cells in all, those beyond the ends included");
            faults.push(entry.fault(Problem::OutOfRange { allowed }));
            return None;
        }
        Some(found)
    }
}

/// A list that may be absent, which is the same as one without members.
fn optional_list<T>(
    section: &mut Section<'_>,
    key: &'static str,
    faults: &mut Faults,
    read: impl FnMut(&Entry<'_>, &mut Faults) -> Option<T>,
) -> Option<Vec<T>> {
    match section.optional(key) {
        Some(entry) => entry.list(faults, read),
        None => Some(Vec::new()),
    }
}

impl ColumnBins {
    fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let column = section.required("column", COLUMN, faults).and_then(|entry| entry.text(faults));
        let range = AllowedRange::PHYSICAL;
        let mut end =
            |key| section.required(key, &range.text(), faults).and_then(|entry| entry.decimal(range, faults));
        let (from, to) = (end("from"), end("to"));
        let most = MOST_SUMMARY_CELLS - 1;
        let count = section
            .required("count", &format!("a whole number from 1 to {most}"), faults)
            .and_then(|entry| entry.whole(1..=most, faults));
        section.finish(faults);
        let (from, to) = (from?, to?);
        if from >= to {
            faults.push(entry.fault(if from == to { Problem::EmptyRange } else { Problem::ReversedRange }));
            return None;
        }
        let points = u32::try_from(count? + 1).ok()?;
        Some(Self { column: column?, edges: LogAxis { from, to, points } })
    }
}

impl ColumnStatistics {
    fn read(entry: &Entry<'_>, faults: &mut Faults) -> Option<Self> {
        let mut section = entry.section(faults)?;
        let column = section.required("column", COLUMN, faults).and_then(|entry| entry.text(faults));
        let words = Statistic::ALL.map(Statistic::as_str).join(", ");
        let statistics = section
            .required("statistics", &format!("a list of {words}"), faults)
            .and_then(|entry| entry.list(faults, read_statistic));
        section.finish(faults);
        let (column, statistics) = (column?, statistics?);
        let repeated = (1..statistics.len()).find(|index| statistics[..*index].contains(&statistics[*index]));
        if let Some(index) = repeated {
            let of = format!("an earlier `{}`", statistics[index].as_str());
            faults.push(entry.fault(Problem::Duplicate { of, folded: false }));
            return None;
        }
        Some(Self { column, statistics })
    }
}

fn read_statistic(entry: &Entry<'_>, faults: &mut Faults) -> Option<Statistic> {
    let words = Statistic::ALL.map(Statistic::as_str);
    let text = entry.text(faults)?;
    let found = Statistic::ALL.into_iter().find(|statistic| statistic.as_str() == text);
    if found.is_none() {
        let near = nearest(&text, words).map(str::to_string);
        faults.push(entry.fault(Problem::UnknownWord { nearest: near, allowed: words.join(", ") }));
    }
    found
}
