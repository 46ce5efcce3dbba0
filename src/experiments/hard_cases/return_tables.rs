//! Tables of returns where integrators go wrong: a column per method, and every run.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::hard_cases::{HardReturn, ReturnAnswer, ReturnOutcome, ReturnVerdict};
use crate::experiments::shared::cells::{count, rounded};
use crate::experiments::unless_empty;
use slipmode_core::dynamics::Failure;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Cell, Column, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker {
        id: "hard-cycles",
        needs: &[Need::HardCases],
        make: |context| by_method(context, &ORDINARY),
    },
    TableMaker {
        id: "hard-cycles-below-rounding",
        needs: &[Need::HardCases],
        make: |context| by_method(context, &BELOW),
    },
    TableMaker { id: "hard-cycles-runs", needs: &[Need::HardCases], make: runs },
];

/// One of the two tables with a column per method.
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

fn outcomes<'c>(context: &'c Context<'_>) -> impl Iterator<Item = &'c ReturnOutcome> {
    context
        .outcome
        .scenes
        .iter()
        .filter_map(|scene| scene.hard_cases.as_ref())
        .flat_map(|found| &found.returns)
}

fn case_columns() -> Vec<Column> {
    vec![
        Column::text("family", "Case"),
        Column::text("law", "Law"),
        Column::number("log_minimum_velocity", "ln(V_min/V_l)", ""),
    ]
}

fn case_cells(case: &HardReturn) -> Vec<Cell> {
    vec![Cell::text(&case.family), Cell::text(case.law.as_str()), rounded(case.log_trough, 4)]
}

const METHODS: [(&str, &str); 6] = [
    ("rodas5p", "Rodas5P"),
    ("radau_5", "Radau IIA 5"),
    ("radau_9", "Radau IIA 9"),
    ("radau_13", "Radau IIA 13"),
    ("taylor_20", "Taylor 20"),
    ("simulation", "simulation"),
];

fn by_method(context: &Context, kind: &Kind) -> Option<Table> {
    let mut columns = case_columns();
    columns.extend(METHODS.map(|(name, header)| Column::text(name, header)));
    let mut table = Table::new(kind.id, kind.title, columns);
    let [least, most] = kind.tolerances;
    for found in outcomes(context) {
        let mut row = case_cells(&found.case);
        row.extend(METHODS.map(|(_, method)| {
            let said = found
                .verdicts
                .iter()
                .find(|verdict| verdict.method == method && (least..most).contains(&verdict.tolerance));
            Cell::text(said.map_or_else(|| "not run".into(), short))
        }));
        table.push(row);
    }
    unless_empty(table)
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
fn short(verdict: &ReturnVerdict) -> String {
    match &verdict.answer {
        Err(failure) => kind_of(failure).into(),
        Ok(ReturnAnswer { error, behaviour: None, .. }) => round_digits(*error, 1),
        Ok(ReturnAnswer { error, behaviour: Some(behaviour), .. }) => {
            format!("{}, estimated {}", behaviour.as_str(), round_digits(*error, 1))
        }
    }
}

fn runs(context: &Context) -> Option<Table> {
    let mut columns = case_columns();
    columns.extend([
        Column::text("method", "Method"),
        Column::number("tolerance", "Tolerance", ""),
        Column::number("steps", "Steps", ""),
        Column::number("evaluations", "Right-hand sides", ""),
        Column::number("error", "Error", ""),
        Column::text("failure", "Failure"),
    ]);
    let mut table = Table::new("hard-cycles-runs", "Hard cycles, run by run", columns);
    for found in outcomes(context) {
        for verdict in &found.verdicts {
            let mut row = case_cells(&found.case);
            row.extend([Cell::text(verdict.method), rounded(verdict.tolerance, 1)]);
            row.extend(match &verdict.answer {
                Ok(answer) => {
                    [count(answer.steps), count(answer.evaluations), rounded(answer.error, 1), Cell::empty()]
                }
                Err(failure) => {
                    [Cell::empty(), Cell::empty(), Cell::empty(), Cell::text(failure.to_string())]
                }
            });
            table.push(row);
        }
    }
    unless_empty(table)
}
