//! The report folder of a comparison: the page, its Markdown, tables and figures.

use slipmode::report::{
    ChapterView, ProvenanceView, ReportView, figure_and_table_files, render_html, render_markdown,
};

use crate::cli::compare::figures::figures;
use crate::cli::compare::rows::{ComparedRow, counts, within_error_bars};
use crate::cli::compare::tables::tables;
use crate::cli::environment::{ENVIRONMENT_FILE, Environment};
use crate::cli::failure::Failure;
use crate::cli::points::Done;
use crate::cli::tree::Files;

const SUBTITLE: &str = "Runs of other programs compared with the linear theory and with our simulation";
const HOW: &str = "Each number is compared with our simulation of the same slider and, for decaying oscillations, with the roots of the linear theory. If an error is larger than the tolerance, the number is not compared. Otherwise it agrees if it differs by at most the stated tolerance plus the errors of both sides, and else it differs.\n\nA trajectory is compared by its long-term behaviour: its first cycle is left out, the rest decides between a limit cycle and a decay, and the last cycle gives peak, period and stress drop. The error of the period comes from the same reduction of every second sample, those of peak and stress drop from the samples around them, and all from the change between the last cycles, too. If a slip lies between two samples, its peak is not compared. Periods are times between upward crossings of the loading velocity.\n\nA mode is also compared with the linear theory, unless our own simulation departs from the theory.\n";
const WITHIN: &str = "\nParameters with error bars: a value that differs at the middle values is compared with the range over the error bars. The range is sampled: it comes from runs at the middle, at every corner and at points spread between, and no proof says that other values stay inside. Each value is compared on its own, so that two values may agree at different parameters. In the figure, the difference is then that from the range.\n";

/// All files of the folder.
///
/// # Errors
/// When the page cannot be rendered: an error of this program.
pub fn files(made: ProvenanceView, done: &Done<ComparedRow>, on: &Environment) -> Result<Files, Failure> {
    let rows = &done.kept;
    let (figures, tables) = (figures(rows), tables(rows));
    let mut files = figure_and_table_files(&figures, &tables);
    let how = format!("{HOW}{}", within_error_bars(rows).map_or("", |_| WITHIN));
    let placed: String = figures.iter().map(|figure| format!("[[figure:{}]]\n\n", figure.id)).collect();
    let chapter = |id: &str, title: &str, text_markdown: String| ChapterView {
        id: id.into(),
        title: title.into(),
        part: None,
        text_markdown,
    };
    let view = ReportView {
        title: "Comparison of runs".into(),
        subtitle: SUBTITLE.into(),
        summary_markdown: summary(rows, done.counts.faulty),
        chapters: vec![
            chapter("verdicts", "Verdicts", format!("[[table:runs]]\n\n{placed}")),
            chapter("numbers", "Numbers", "[[table:findings]]\n".into()),
            chapter("method", "How runs are compared", how),
        ],
        figures,
        tables,
        provenance: made,
        environment: on.facts(),
        ..ReportView::default()
    };
    let unrenderable = |error| Failure::machine("the report cannot be made", &error);
    files.insert("index.html".into(), render_html(&view).map_err(unrenderable)?);
    files.insert("report.md".into(), render_markdown(&view).map_err(unrenderable)?);
    files.insert(ENVIRONMENT_FILE.into(), on.to_json());
    Ok(files)
}

fn summary(rows: &[ComparedRow], faulty: u64) -> String {
    let [agree, differ, not_compared] = counts(rows);
    let invalid = match faulty {
        0 => String::new(),
        1 => " 1 further row of the file is invalid and was left out.".to_string(),
        _ => format!(" {faulty} further rows of the file are invalid and were left out."),
    };
    let within = within_error_bars(rows)
        .map(|within| format!(" ({within} of them only within the error bars of their parameters, sampled)"))
        .unwrap_or_default();
    format!(
        "Of {} runs, **{agree} agree**{within}, **{differ} differ** and **{not_compared} could not be compared**.{invalid}\n",
        rows.len(),
    )
}
