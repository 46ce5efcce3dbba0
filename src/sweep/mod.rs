//! Sweeps for many machines: what a scene states of them, their points, their blocks, and summaries of their rows.

pub(crate) mod blocks;
pub(crate) mod csv_records;
pub(crate) mod low_discrepancy;
pub(crate) mod points;
pub(crate) mod section;
pub(crate) mod summary;

pub use blocks::{Blocks, Shard, array_string};
pub use low_discrepancy::LowDiscrepancy;
pub use points::{PointSource, Varying};
pub use section::{
    ColumnBins, ColumnStatistics, Coordinate, MOST_SUMMARY_CELLS, MOST_SWEEP_POINTS, Spacing, Span,
    Statistic, SummarySection, SweepPoints, SweepSection, SweepWork,
};
pub use summary::{RowPlaces, Summary, SummaryError, SummaryRow};
