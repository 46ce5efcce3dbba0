//! Diagrams of work against error: by counts, and by the times of the report's files.

use std::collections::BTreeMap;

use crate::experiments::speed_counts::{RootCount, SpeedCounts};
use crate::experiments::timings::{PeerRow, Timings, micro};
use crate::experiments::{Figure, FigureMaker};
use crate::experiments::{Need, Outcome};
use slipmode_plot::figure::{Axis, Caption, LineChart, Series};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker { id: "speed-roots", needs: &[Need::SpeedCounts], data: &["speed-roots"], make: roots },
    FigureMaker {
        id: "speed-boundary",
        needs: &[Need::SpeedCounts],
        data: &["speed-boundary"],
        make: boundary,
    },
    FigureMaker { id: "speed-sweep", needs: &[Need::SpeedCounts], data: &["speed-sweep"], make: sweep },
    FigureMaker { id: "times-roots", needs: &[Need::Timings], data: &["peers-roots"], make: times_of_roots },
    FigureMaker {
        id: "times-cycle",
        needs: &[Need::Timings],
        data: &["peers-cycles"],
        make: times_of_a_cycle,
    },
];

fn counts(outcome: &Outcome) -> Option<&SpeedCounts> {
    outcome.scenes.iter().find_map(|scene| scene.speed_counts.as_ref())
}

fn timings(outcome: &Outcome) -> Option<&Timings> {
    outcome.scenes.iter().find_map(|scene| scene.timings.as_ref())
}

/// A line with a mark at every point.
fn marked(label: &str, points: Vec<(f64, f64)>) -> Series {
    Series { label: label.into(), points, marked: true, theory: false }
}

/// The axis that holds the values with a little room, from the least to the greatest power of ten where it spans several.
fn log_axis(title: &str, unit: &str, values: impl Iterator<Item = f64>) -> Option<Axis> {
    let (mut least, mut greatest) = (f64::INFINITY, 0.0_f64);
    for value in values.filter(|value| *value > 0.0 && value.is_finite()) {
        (least, greatest) = (least.min(value), greatest.max(value));
    }
    (least <= greatest).then(|| Axis::log10(title, unit, 0.7 * least, 1.5 * greatest))
}

struct Words {
    label: &'static str,
    title: String,
    caption: String,
    description: &'static str,
}

fn chart(id: &str, words: Words, [x, y]: [(&str, &str); 2], series: Vec<Series>) -> Option<Figure> {
    let points = || series.iter().flat_map(|line| line.points.iter().copied());
    let x = log_axis(x.0, x.1, points().map(|point| point.0))?;
    let y = log_axis(y.0, y.1, points().map(|point| point.1))?;
    let caption = Caption::new(id, &words.title, words.description);
    let chart = LineChart {
        caption: caption.clone(),
        x,
        y,
        series,
        references: Vec::new(),
        bands: Vec::new(),
        labels: Vec::new(),
    };
    Some(Figure::new(caption, words.label, &words.caption, chart.svg()))
}

/// Below one digit nothing is right; the axis needs a place for it.
const LEAST_DIGITS: f64 = 1.0;

fn roots(outcome: &Outcome) -> Option<Figure> {
    let rows = &counts(outcome)?.roots;
    let place = |row: &RootCount| Some((f64::from(row.bits), row.digits_right?.max(LEAST_DIGITS)));
    let line = |set: &str| {
        let certified = rows.iter().filter(|row| row.set == set && row.method == "certified");
        marked(&format!("certified, {set}"), certified.filter_map(place).collect())
    };
    let alone = |method: &str| {
        marked(method, rows.iter().filter(|row| row.method == method).filter_map(place).collect())
    };
    let series = vec![
        line("random"),
        line("hard"),
        alone("double-double with bounds"),
        alone("64-bit with bounds"),
        alone("companion eigenvalues"),
        alone("Cardano"),
    ];
    chart(
        "speed-roots",
        Words {
            label: "Figure P1",
            title: "Correct digits against bits of the arithmetic, three roots of a cubic".into(),
            caption: "Correct digits in the worst root of a set, against the bits of the arithmetic. Certified roots use as many additional bits as the cubic loses, a number that is known in advance; the other methods lose digits. The two marks of a method are the two sets of the table. A mark at one digit means that no digit is correct.".into(),
            description: "Correct digits in the worst root against bits of the arithmetic, on logarithmic axes. Certified roots lie on a straight line up to ten thousand digits; 64-bit methods lie below it.",
        },
        [("Bits of the arithmetic", ""), ("Correct digits, worst root", "")],
        series,
    )
}

fn boundary(outcome: &Outcome) -> Option<Figure> {
    let rows = &counts(outcome)?.boundary;
    let line = |route: &str| {
        let of_route = rows.iter().filter(|row| row.route == route);
        marked(route, of_route.filter_map(|row| Some((row.count? as f64, row.digits_right))).collect())
    };
    chart(
        "speed-boundary",
        Words {
            label: "Figure P2",
            title: "Correct digits against evaluations, one point of the boundary".into(),
            caption: "Digits of one point of the boundary against evaluations: exact signs of the discriminant for bisection, one evaluation of the rational curve for any number of digits.".into(),
            description: "Correct digits against the number of evaluations, on logarithmic axes. Bisection gains a third of a digit per evaluation; the curve needs one evaluation for any number of digits.",
        },
        [("Evaluations", ""), ("Correct digits", "")],
        vec![line("bisection"), line("curve")],
    )
}

fn sweep(outcome: &Outcome) -> Option<Figure> {
    let rows = &counts(outcome)?.sweep;
    let per_run = |count: u64, runs: usize| count as f64 / runs.max(1) as f64;
    let line = |label, of: fn(&crate::experiments::speed_counts::SweepCount) -> u64| {
        marked(label, rows.iter().map(|row| (per_run(of(row), row.runs), row.worst_error)).collect())
    };
    chart(
        "speed-sweep",
        Words {
            label: "Figure P3",
            title: "Largest error of a sweep against its work".into(),
            caption: "Largest relative error of peak velocity and period over a sweep of both laws, against steps and right-hand sides per run, one mark per tolerance.".into(),
            description: "Largest relative error of a sweep against steps and evaluations per run, on logarithmic axes. The line of evaluations falls steeply; the line of steps turns back where the method changes.",
        },
        [("Count per run", ""), ("Largest relative error", "")],
        vec![line("right-hand sides", |row| row.evaluations), line("steps", |row| row.steps)],
    )
}

/// Rows by method, in the order of the names, ours first.
fn by_method<'r>(rows: impl Iterator<Item = &'r PeerRow>) -> Vec<(&'r str, Vec<&'r PeerRow>)> {
    let mut methods: BTreeMap<(bool, &str), Vec<&PeerRow>> = BTreeMap::new();
    for row in rows {
        methods.entry((!row.is_ours(), &row.method)).or_default().push(row);
    }
    methods.into_iter().map(|((_, method), rows)| (method, rows)).collect()
}

fn times_of_roots(outcome: &Outcome) -> Option<Figure> {
    let rows = &timings(outcome)?.peers;
    let digits = |row: &PeerRow, set: &str| -> Option<f64> {
        row.work.strip_prefix("roots-")?.strip_suffix(set)?.strip_suffix('-')?.parse().ok()
    };
    let mut series = Vec::new();
    for (method, rows) in by_method(rows.iter()) {
        let line = |set: &str| rows.iter().filter_map(|row| Some((digits(row, set)?, micro(row)))).collect();
        series.push(marked(&escaped(method), line("random")));
        if rows.first().is_some_and(|row| row.is_ours()) {
            series.push(marked(&format!("{method}, hard cubics"), line("hard")));
        }
    }
    series.retain(|line| !line.points.is_empty());
    chart(
        "times-roots",
        Words {
            label: "Figure P4",
            title: "Time of three roots against digits".into(),
            caption: "CPU time of the three roots of one cubic against the requested digits, for random cubics unless stated otherwise. The table has the errors. FLINT's roots and ours are enclosed, the others are not.".into(),
            description: "CPU time of three roots against requested digits, on logarithmic axes, one line for each program.",
        },
        [("Digits", ""), ("CPU time", "µs")],
        series,
    )
}

/// Lines of one diagram: with more a look would repeat.
const MOST_LINES: usize = 6;

/// The error by whose time methods are ranked.
const RANKED_ERROR: f64 = 1e-6;

/// A name in which an underscore is no subscript.
fn escaped(name: &str) -> String {
    name.replace('_', "\\_")
}

/// Errors beyond this are no answer, and below this are rounding.
const SHOWN_ERRORS: std::ops::RangeInclusive<f64> = 1e-14..=1.0;

fn times_of_a_cycle(outcome: &Outcome) -> Option<Figure> {
    let rows = &timings(outcome)?.peers;
    let case = rows
        .iter()
        .map(|row| row.work.as_str())
        .find(|work| work.starts_with("cycles-") && work.ends_with("slip"))?;
    let place = |row: &&PeerRow| {
        let error = row.error_value().filter(|error| row.wrong == 0 && SHOWN_ERRORS.contains(error))?;
        Some((error, micro(row)))
    };
    let mut lines: Vec<(f64, Series)> = by_method(rows.iter().filter(|row| row.work == case))
        .into_iter()
        .map(|(method, rows)| {
            let points: Vec<(f64, f64)> = rows.iter().filter_map(place).collect();
            let met = points.iter().filter(|(error, _)| *error <= RANKED_ERROR).map(|point| point.1);
            (met.fold(f64::INFINITY, f64::min), marked(&escaped(method), points))
        })
        .collect();
    lines.sort_by(|one, other| one.0.total_cmp(&other.0));
    lines.truncate(MOST_LINES);
    let series = lines.into_iter().map(|(_, series)| series).collect();
    chart(
        "times-cycle",
        Words {
            label: "Figure P5",
            title: format!("Time of one cycle against its error, {case}"),
            caption: format!(
                "CPU time of one cycle of `{case}` (V_l = 10^v m/s, σ = 10^s Pa) against its measured error, the larger of the errors of ln V_peak and of the duration. The reference is Radau IIA of order 13 in double-double. One mark per tolerance, for the six fastest methods at an error of 1e-6. There is no mark at a tolerance where a program does not finish."
            ),
            description: "CPU time of one cycle against its measured error, on logarithmic axes, one line for each method.",
        },
        [("Error", ""), ("CPU time", "µs")],
        series,
    )
}
