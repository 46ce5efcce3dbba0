//! Points and cycles where programs go wrong, with references from independent programs.

pub(crate) mod methods;
pub(crate) mod return_tables;
pub(crate) mod returns;
pub(crate) mod run;
pub(crate) mod tables;
pub(crate) mod textbook;

pub use methods::{Method, MethodScore};
pub use returns::{
    HardReturn, ReturnAnswer, ReturnOutcome, ReturnVerdict, read_hard_returns, run_hard_returns,
};
pub use run::{FamilyOutcome, HardCase, compare_hard_cases, read_hard_cases};
