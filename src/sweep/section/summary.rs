//! `[sweep.summary]`: what is kept of a sweep whose rows are too many to keep.

use crate::scene::section::Entry;
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
    pub(crate) fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let bins = section.optionally("bins", |entry| entry.list(ColumnBins::read));
        let by = section.optionally("by", |entry| entry.list(Entry::text));
        let numbers = section.optionally("numbers", |entry| entry.list(ColumnStatistics::read));
        section.finish();
        let bins = bins?.unwrap_or_default();
        let cells =
            bins.iter().fold(1u64, |cells, bins| cells.saturating_mul(u64::from(bins.edges.points) + 1));
        if cells > MOST_SUMMARY_CELLS {
            let allowed =
                format!("at most {MOST_SUMMARY_CELLS} cells in all, those beyond the ends included");
            return entry.refuse(Problem::OutOfRange { allowed });
        }
        Some(Self { bins, by: by?.unwrap_or_default(), numbers: numbers?.unwrap_or_default() })
    }
}

impl ColumnBins {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let column = section.text("column", COLUMN);
        let ends = section.ends();
        let count = section.whole("count", 1..=MOST_SUMMARY_CELLS - 1);
        section.finish();
        let (from, to) = ends?;
        let points = u32::try_from(count? + 1).ok()?;
        Some(Self { column: column?, edges: LogAxis { from, to, points } })
    }
}

impl ColumnStatistics {
    fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let column = section.text("column", COLUMN);
        let words = Statistic::ALL.map(Statistic::as_str).join(", ");
        let statistics = section
            .required("statistics", &format!("a list of {words}"))
            .and_then(|entry| entry.list(|member| member.word(&Statistic::ALL, Statistic::as_str)));
        section.finish();
        let (column, statistics) = (column?, statistics?);
        let repeated = (1..statistics.len()).find(|index| statistics[..*index].contains(&statistics[*index]));
        if let Some(index) = repeated {
            let of = format!("an earlier `{}`", statistics[index].as_str());
            return entry.refuse(Problem::Duplicate { of, folded: false });
        }
        Some(Self { column, statistics })
    }
}
