//! `[sweep.summary]`: what is kept of a sweep whose rows are too many to keep.

use crate::scene::section::{Entry, Section};
use crate::scene::{LogAxis, Problem};

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

slipmode_algebra::named! {
    /// What is kept of the numbers of a column.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Statistic {
        /// How many cells hold a finite number.
        Count = "count",
        /// The least.
        Least = "least",
        /// The greatest.
        Greatest = "greatest",
        /// The sum, in the order of points within blocks and of blocks.
        Sum = "sum",
    }
}

const COLUMN: &str = "the name of a column";

impl SummarySection {
    pub(crate) fn read(section: &mut Section<'_>) -> Self {
        let bins = |entry: &Entry<'_>| entry.list(|member| member.table(ColumnBins::read));
        let numbers = |entry: &Entry<'_>| entry.list(|member| member.table(ColumnStatistics::read));
        let read = Self {
            bins: section.optionally("bins", bins).unwrap_or_default(),
            by: section.optionally("by", |entry| entry.list(Entry::text)).unwrap_or_default(),
            numbers: section.optionally("numbers", numbers).unwrap_or_default(),
        };
        let counts = read.bins.iter().map(|bins| u64::from(bins.edges.points) + 1);
        if counts.fold(1, u64::saturating_mul) > MOST_SUMMARY_CELLS {
            let allowed =
                format!("at most {MOST_SUMMARY_CELLS} cells in all, those beyond the ends included");
            section.refuse(Problem::OutOfRange { allowed });
        }
        read
    }
}

impl ColumnBins {
    fn read(section: &mut Section<'_>) -> Self {
        let column = section.text("column", COLUMN);
        let (from, to) = section.ends();
        let count: u32 = section.whole("count", 1..=MOST_SUMMARY_CELLS - 1);
        Self { column, edges: LogAxis { from, to, points: count + 1 } }
    }
}

impl ColumnStatistics {
    fn read(section: &mut Section<'_>) -> Self {
        let column = section.text("column", COLUMN);
        let words = format!("a list of {}", Statistic::ALL.map(Statistic::as_str).join(", "));
        let word = |member: &Entry<'_>| member.word(&Statistic::ALL, Statistic::as_str);
        let statistics = section.list("statistics", &words, word);
        let repeated = (1..statistics.len()).find(|index| statistics[..*index].contains(&statistics[*index]));
        if let Some(index) = repeated {
            let of = format!("an earlier `{}`", statistics[index].as_str());
            section.refuse(Problem::Duplicate { of, folded: false });
        }
        Self { column, statistics }
    }
}
