//! Tables of cycles where integrators go wrong: a column per method.

use super::{HardCycleOutcome, MethodAnswer, MethodVerdict};
use crate::digit_columns::DigitColumns;
use slipmode_core::dynamics::Failure;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Column, Table};

/// One of the two tables.
struct Kind {
    id: &'static str,
    title: &'static str,
    /// Tolerances from here, included, to there, excluded.
    tolerances: [f64; 2],
}

const ORDINARY: Kind = Kind {
    id: "hard-cycles",
    title: "Error of one cycle by method, at a local tolerance of 1e-9; a whole simulation at 1e-8",
    tolerances: [1e-12, 1.0],
};

const BELOW: Kind = Kind {
    id: "hard-cycles-below-rounding",
    title: "Error of one cycle by method, at a local tolerance of 1e-16, below rounding",
    tolerances: [1e-18, 1e-12],
};

const COLUMNS: [(&str, &str); 6] = [
    ("rodas5p", "Rodas5P"),
    ("radau_5", "Radau IIA 5"),
    ("radau_9", "Radau IIA 9"),
    ("radau_13", "Radau IIA 13"),
    ("taylor_20", "Taylor 20"),
    ("simulation", "simulation"),
];

/// The two tables.
#[must_use]
pub fn tables(outcomes: &[HardCycleOutcome]) -> Vec<Table> {
    [ORDINARY, BELOW].iter().map(|kind| by_method(outcomes, kind)).collect()
}

fn by_method(outcomes: &[HardCycleOutcome], kind: &Kind) -> Table {
    let [least, most] = kind.tolerances;
    let answer = |found: &HardCycleOutcome, method| {
        let meant = |of: &&MethodVerdict| of.method == method && (least..most).contains(&of.tolerance);
        found.verdicts.iter().find(meant).map_or_else(|| "not run".into(), short).into()
    };
    Table::of(kind.id, kind.title, outcomes)
        .text("family", "Case", |found| &found.case.family)
        .text("law", "Law", |found| found.case.law.as_str())
        .digits("log_minimum_velocity", "ln(V_min/V_l)", "", 4, |found| found.case.log_trough)
        .columns(COLUMNS.map(|(name, header)| Column::text(name, header)), |found| {
            COLUMNS.map(|(_, method)| answer(found, method))
        })
        .table()
}

/// A failure in a word or two.
const fn kind_of(failure: &Failure) -> &'static str {
    match failure {
        Failure::InvalidStart => "start refused",
        Failure::StepVanished { .. } => "step vanishes",
        Failure::TooManySteps { .. } => "too many steps",
        Failure::Undecided { .. } => "undecided",
        Failure::UnreachableTolerance { .. } => "refused: not attainable",
        _ => "failed",
    }
}

/// A verdict in a few words.
fn short(verdict: &MethodVerdict) -> String {
    match &verdict.answer {
        Err(failure) => kind_of(failure).into(),
        Ok(MethodAnswer { error, behaviour: None }) => round_digits(*error, 1),
        Ok(MethodAnswer { error, behaviour: Some(behaviour) }) => {
            format!("{}, estimated {}", behaviour.as_str(), round_digits(*error, 1))
        }
    }
}
