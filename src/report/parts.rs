//! The words over the parts of a report, and which chapters stand under them.

use super::view::ChapterView;
use crate::scene::Part;

/// The heading of a part.
pub(crate) fn title(part: Part) -> &'static str {
    match part {
        Part::CodeVerification => "Code verification: exact",
        Part::SolutionVerification => "Solution verification: the numerical error of these runs",
        Part::Validation => "Validation: the paper against computation",
    }
}

/// What the chapters of a part answer, in one sentence.
pub(crate) fn lead(part: Part) -> &'static str {
    match part {
        Part::CodeVerification => {
            "Are the equations and the program right? Decided by algebra over the rationals and by routes that share nothing."
        }
        Part::SolutionVerification => {
            "How far may the numbers of this report’s own runs be off? Measured on the runs themselves."
        }
        Part::Validation => {
            "Does what the paper says agree with what was computed? Each answer is a verdict with its evidence."
        }
    }
}

/// The chapters cut where the part changes; no run is empty.
pub(crate) fn runs(chapters: &[ChapterView]) -> Vec<&[ChapterView]> {
    chapters.chunk_by(|one, next| one.part == next.part).collect()
}
