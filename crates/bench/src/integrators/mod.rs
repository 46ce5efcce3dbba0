//! The integrators on single cycles: work against error by counts that no machine changes, and cycles where integrators go wrong.
//!
//! [`Rodas5P`] is a method that the library does not use.

#[cfg(test)]
mod checks;
mod figures;
mod hard_cycles;
mod hard_tables;
#[cfg(test)]
mod multi;
mod returns;
mod rodas;
mod work;
mod work_table;

pub use figures::figures;
pub use hard_cycles::{
    HardCycle, HardCycleOutcome, MethodAnswer, MethodVerdict, read_hard_cycles, run_hard_cycles,
};
pub use hard_tables::tables as hard_tables;
pub use returns::{METHODS, MeasuredReturn, ReturnMethod, reference_return};
pub use rodas::Rodas5P;
pub use work::{WorkCase, WorkPoint, work_precision};
pub use work_table::table as work_table;
