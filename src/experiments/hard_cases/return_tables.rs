//! Tables of returns where integrators go wrong: a column per method, and every run.

use crate::experiments::hard_cases::{ReturnAnswer, ReturnOutcome, ReturnVerdict};
use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::dynamics::Failure;
use slipmode_core::number::format::round_digits;
use slipmode_plot::table::{Column, Table, TableRows};

const NEEDS: &[Need] = &[Need::HardCases];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "hard-cycles", needs: NEEDS, make: |context| by_method(context, &ORDINARY) },
    TableMaker { id: "hard-cycles-below-rounding", needs: NEEDS, make: |context| by_method(context, &BELOW) },
    TableMaker { id: "hard-cycles-runs", needs: NEEDS, make: runs },
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
    context.outcome.each(|scene| &scene.hard_cases).flat_map(|(_, found)| &found.returns)
}

/// Columns of a case, which stand first.
fn of_cases<'c, R: Copy>(rows: TableRows<R>, of: impl Fn(R) -> &'c ReturnOutcome) -> TableRows<R> {
    rows.text("family", "Case", |row| &of(row).case.family)
        .text("law", "Law", |row| of(row).case.law.as_str())
        .digits("log_minimum_velocity", "ln(V_min/V_l)", "", 4, |row| of(row).case.log_trough)
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
    let [least, most] = kind.tolerances;
    let answer = |found: &ReturnOutcome, method| {
        let meant = |of: &&ReturnVerdict| of.method == method && (least..most).contains(&of.tolerance);
        found.verdicts.iter().find(meant).map_or_else(|| "not run".into(), short).into()
    };
    of_cases(Table::of(kind.id, kind.title, outcomes(context)), |found| found)
        .columns(METHODS.map(|(name, header)| Column::text(name, header)), |found| {
            METHODS.map(|(_, method)| answer(found, method))
        })
        .unless_empty()
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
    let runs = outcomes(context).flat_map(|found| found.verdicts.iter().map(move |run| (found, run)));
    let answer = |run: &ReturnVerdict| run.answer.as_ref().ok().copied();
    of_cases(Table::of("hard-cycles-runs", "Hard cycles, run by run", runs), |(found, _)| found)
        .text("method", "Method", |(_, run)| run.method)
        .digits("tolerance", "Tolerance", "", 1, |(_, run)| run.tolerance)
        .number("steps", "Steps", "", |(_, run)| answer(run).map(|found| found.steps))
        .number("evaluations", "Right-hand sides", "", |(_, run)| answer(run).map(|found| found.evaluations))
        .digits("error", "Error", "", 1, |(_, run)| answer(run).map(|found| found.error))
        .text("failure", "Failure", |(_, run)| run.answer.as_ref().err().map(ToString::to_string))
        .unless_empty()
}
