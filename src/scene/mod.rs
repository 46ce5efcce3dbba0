//! Scenes, reports and claims as their files state them: read from text, validated, exact.
//!
//! Every reader takes the bytes of a file and its name, opens nothing, and returns either a valid value or
//! **all** the faults at once, each with file, line, key, value and allowed range.
//! Decimals are taken from their text ([`slipmode_core::number::parse_decimal`]); no number passes through binary.

mod axis;
mod chart_file;
mod cited;
mod claim_computed;
mod claim_formula;
mod claim_library;
mod claim_list;
mod claim_motion;
mod claim_names;
mod claim_scope;
mod claim_subject;
mod csv_problem;
pub(crate) mod document;
mod equations_file;
mod fault;
pub(crate) mod file_text;
mod measured;
mod name;
pub(crate) mod paper;
pub(crate) mod part;
mod proofs_file;
pub(crate) mod quantity;
pub(crate) mod question;
mod range;
pub(crate) mod report_plan;
pub(crate) mod section;
pub(crate) mod sections;
mod sentence;
mod shortened;
mod uncertain;
mod units;
mod verdict;

pub use axis::{Limits, LogAxis, LogCoordinates};
pub use chart_file::{ChartLine, ChartMap, EquationChart, Sampled, read_chart};
pub use cited::cited;
pub use claim_computed::Procedures;
pub(crate) use claim_formula::within_ends;
pub use claim_formula::{
    ClaimFormula, Computed, Crossing, Formula, FormulaCondition, MOST_CLAUSES, OverRows, Premise, Premises,
    Scope, Solved, StatedClaim, StatedReading, Statement,
};
pub use claim_library::{library_ids, library_proofs};
pub use claim_list::{ClaimEntry, library_claim, read_claims, read_equations_and_claims};
pub use claim_motion::{ClaimMotion, MotionSaid};
pub use claim_names::Names;
pub use claim_subject::{InAnswer, Sliders, Subject};
pub use csv_problem::CsvProblem;
pub use equations_file::{read_equations, read_equations_partly};
pub use fault::{Fault, Faults, Problem, is_forbidden, visible};
pub use file_text::{MAX_FILE_BYTES, file_text};
pub(crate) use file_text::{forbidden_character, is_utf16};
pub use measured::{Measured, MeasuredChart, with_rows};
pub use name::{NameError, check_name, nearest, same_name};
pub use paper::{Author, Paper, is_orcid};
pub use part::Part;
pub use proofs_file::{join_proofs, read_proofs};
pub(crate) use quantity::symbols;
pub use quantity::{ParametersSection, all_of};
pub use question::Question;
pub use range::{AllowedRange, parse_value, parse_whole};
pub(crate) use range::{has_between_digits, not_a_number};
pub use report_plan::{Chapter, ReportPlan};
pub use section::of_word;
pub use sections::{PlanePoint, Rectangle};
pub use sentence::{Change, Kind, Sentence, Source, filled};
pub use shortened::{LONGEST_MESSAGE, first_lines};
pub(crate) use shortened::{shortened, with_short_quotations};
pub use slipmode_core::friction::Quantity;
pub(crate) use uncertain::UNITS_DIFFER;
pub use uncertain::Uncertain;
pub use units::with_unit;
pub(crate) use units::{
    read_unit, split_unit, stem_of_key, unit_for, unit_in_any_case, unit_of, unit_of_key,
};
pub use verdict::Verdict;
