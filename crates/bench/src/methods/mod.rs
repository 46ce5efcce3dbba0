//! Every way to the roots of eq 8 on the hard cases: textbook methods, and each precision level alone.

mod score;
mod signs;
mod tables;

pub use score::{FamilyScores, Method, MethodScore, score_families, wide};
pub use signs::{TEXTBOOK, Textbook, signs_of};
pub use tables::tables;
