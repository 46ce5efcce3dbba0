//! Every way to the roots of eq 8 on the hard cases: textbook methods, and each precision level alone.

mod case_tables;
mod cases;
mod method;
mod score;
mod tables;

pub use case_tables::case_table;
pub use cases::{Expected, FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
pub use method::{Method, TEXTBOOK, Textbook, signs_of};
pub use score::{FamilyScores, MethodScore, score_families, wide};
pub use tables::tables;
