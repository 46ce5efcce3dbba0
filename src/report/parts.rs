//! The words over the parts of a report, and which chapters stand under them.

use super::view::ChapterView;
use crate::scene::Part;

/// The deep link of a part.
pub(crate) fn anchor(part: Part) -> String {
    format!("part-{}", part.as_str())
}

/// The heading of a part.
pub(crate) fn title(part: Part) -> &'static str {
    match part {
        Part::Validation => "Validation: the paper compared with computation",
        Part::NewResults => "New results",
        Part::CodeVerification => "Code verification: exact",
        Part::SolutionVerification => "Solution verification: the numerical error of these runs",
        Part::Speed => "Speed",
        Part::Appendix => "Appendices",
        Part::Paper => "What of the paper holds for this slider",
    }
}

/// What the chapters of a part answer, in one sentence.
pub(crate) fn lead(part: Part) -> &'static str {
    match part {
        Part::Validation => {
            "Do the paper’s claims agree with computation? Each answer is a verdict with its evidence."
        }
        Part::NewResults => "What follows beyond the paper? Each result is a claim with its evidence.",
        Part::CodeVerification => {
            "Are the equations and the program right? This is decided by algebra over the rationals and by independent methods."
        }
        Part::SolutionVerification => {
            "How large are the errors of this report’s own runs? They are measured on the runs themselves."
        }
        Part::Speed => "What do the results cost? Work is compared with error by counts and by times.",
        Part::Appendix => "What supports the report.",
        Part::Paper => {
            "Which claims and formulas of the paper hold for this slider? The verdicts, the formulas with their errors, all runs, and the ledger of claims."
        }
    }
}

/// The chapters cut where the part changes, before the ledger and after it; no run is empty.
pub(crate) fn runs(chapters: &[ChapterView]) -> [Vec<&[ChapterView]>; 2] {
    let follows = |chapter: &ChapterView| chapter.part.is_some_and(Part::follows_ledger);
    let (before, after) = chapters.split_at(chapters.iter().position(follows).unwrap_or(chapters.len()));
    [before, after].map(|side| side.chunk_by(|one, next| one.part == next.part).collect())
}
