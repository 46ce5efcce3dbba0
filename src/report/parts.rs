//! The words over the parts of a report, and which chapters stand under them.

use super::view::ChapterView;
use crate::scene::Part;

/// The heading of a part.
pub(crate) fn title(part: Part) -> &'static str {
    match part {
        Part::CodeVerification => "Code verification: exact",
        Part::SolutionVerification => "Solution verification: the numerical error of these runs",
        Part::Validation => "Validation: the paper compared with computation",
    }
}

/// What the chapters of a part answer, in one sentence.
pub(crate) fn lead(part: Part) -> &'static str {
    match part {
        Part::CodeVerification => {
            "Are the equations and the program right? This is decided by algebra over the rationals and by independent methods."
        }
        Part::SolutionVerification => {
            "How large are the errors of this report’s own runs? They are measured on the runs themselves."
        }
        Part::Validation => {
            "Do the paper’s claims agree with computation? Each answer is a verdict with its evidence."
        }
    }
}

/// The chapters cut where the part changes; no run is empty.
pub(crate) fn runs(chapters: &[ChapterView]) -> Vec<&[ChapterView]> {
    chapters.chunk_by(|one, next| one.part == next.part).collect()
}
