//! max Im(s) along lines of constant normal stress (fig 2).

pub(crate) mod figures;
pub(crate) mod run;

pub use run::{FrequencyLine, FrequencyOutcome, frequency_lines};
