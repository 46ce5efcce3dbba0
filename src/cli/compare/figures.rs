//! The figures of a comparison: how far values lie apart, and cycles of the end of both sides drawn over each other.

use slipmode::comparison::recording::Recording;
use slipmode::comparison::{Observable, Reference};
use slipmode::experiments::described::{extent, picture, with_points};
use slipmode::report::FigureView;
use slipmode_core::dynamics::{Behaviour, Options};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::figure::{Caption, LineChart, Series};

use crate::cli::compare::rows::ComparedRow;
use crate::cli::simulate::run::follow;

/// Late cycles drawn, from the first rows that have one.
const MOST_CYCLES: usize = 6;
/// Periods after which our cycle is drawn.
const PERIODS: f64 = 12.0;

/// All figures that the rows have numbers for.
pub fn figures(rows: &[ComparedRow]) -> Vec<FigureView> {
    let cycles = rows.iter().filter_map(long_term_cycles).take(MOST_CYCLES);
    let mut figures: Vec<FigureView> = differences(rows).into_iter().chain(cycles).collect();
    for (index, figure) in figures.iter_mut().enumerate() {
        figure.label = format!("Figure {}", index + 1);
    }
    figures
}

/// Differences from our simulation in units of what is allowed.
fn differences(rows: &[ComparedRow]) -> Option<FigureView> {
    let series: Vec<Series> = Observable::ALL
        .into_iter()
        .map(|of| series(rows, of))
        .filter(|series| !series.points.is_empty())
        .collect();
    let values = series.iter().flat_map(|series| &series.points).map(|(_, y)| y.abs());
    let largest = values.filter(|size| size.is_finite()).fold(1.0, f64::max);
    if series.is_empty() {
        return None;
    }
    let end = libm::exp10(libm::log10(largest).floor() + 1.0);
    let mut chart: LineChart = picture("differences");
    let number = |row: Option<&ComparedRow>, default| row.map_or(default, |row| row.read.number as f64);
    let first = number(rows.first(), 0.0) - 0.5;
    // Five rows at least: a shorter axis would have ticks between its rows.
    (chart.x.min, chart.x.max) = (first, (number(rows.last(), 1.0) + 0.5).max(first + 5.0));
    (chart.y.min, chart.y.max) = (-end, end);
    chart.series = series;
    let caption = "Relative differences between the runs' numbers and our simulation, in units of what the tolerance and the errors of both sides allow. Inside the strip they agree.";
    Some(FigureView::new(&chart.caption, "", caption, chart.svg()).with_data(&["findings"]))
}

/// Marks without a line between them: a point without a place on the axes interrupts it.
fn series<'r>(rows: &'r [ComparedRow], of: Observable) -> Series {
    let findings =
        |row: &'r ComparedRow| row.comparison.findings.iter().map(move |it| (row.read.number as f64, it));
    let all = rows.iter().flat_map(findings);
    let meant = all.filter(|(_, it)| it.observable == of && it.reference == Reference::Simulation);
    let marks = meant.filter_map(|(number, it)| Some((number, it.difference? / it.allowed?)));
    let points = marks.filter(|(_, at)| at.is_finite()).flat_map(|mark| [mark, (f64::NAN, f64::NAN)]);
    Series::marked(of.words(), points.collect())
}

/// The last cycle of a trajectory and of our run, both from their upward crossing of V_l on.
fn long_term_cycles(row: &ComparedRow) -> Option<FigureView> {
    let recording = row.read.run.recording.as_ref()?;
    let level = nearest_f64(&row.read.run.parameters.point.loading_velocity_m_per_s);
    let theirs = last_cycle(recording, level)?;
    let ours = last_cycle(&our_recording(row)?, level)?;
    let both = || theirs.iter().chain(&ours);
    let (lowest, highest) = extent(both().map(|(_, v)| *v))?;
    let end = both().map(|(t, _)| *t).fold(0.0, f64::max);
    let (low, high) = (libm::log10(lowest).floor(), libm::log10(highest).ceil());
    let id = format!("late-cycle-row-{}", row.read.number);
    let description = format!(
        "Velocity over one late cycle of row {}, starting at the upward crossing of the loading velocity: the recorded trajectory, and our simulation.",
        row.read.number
    );
    let mut chart: LineChart = picture("late-cycle");
    chart.caption = Caption::new(&id, &format!("Late cycle of row {}", row.read.number), &description);
    chart.x.max = end;
    (chart.y.min, chart.y.max) = (libm::exp10(low), libm::exp10(high.max(low + 1.0)));
    let chart = with_points(chart, [ours, theirs])?;
    let periods = round_digits(PERIODS, 2);
    let caption = format!(
        "The last cycle of the trajectory of row {}, and the last of {periods} periods of our simulation from its start. Both begin at the upward crossing of the loading velocity.",
        row.read.number
    );
    Some(FigureView::new(&chart.caption, "", &caption, chart.svg()))
}

/// Time since the last upward crossing but one, s, and velocity, m/s; none without two crossings.
fn last_cycle(recording: &Recording, level: f64) -> Option<Vec<(f64, f64)>> {
    let crossings = recording.upward_crossings_s(libm::log(level));
    let [.., begin, end] = crossings[..] else { return None };
    let samples = recording.times_s.iter().zip(&recording.log_velocities);
    let inside = samples.filter(|(time, _)| (begin..=end).contains(*time));
    let mut points = vec![(0.0, level)];
    points.extend(inside.map(|(time, log)| (time - begin, libm::exp(*log))));
    points.push((end - begin, level));
    Some(points)
}

/// Our run from its start as a recording; none unless it ends in a cycle.
fn our_recording(row: &ComparedRow) -> Option<Recording> {
    let found = row.comparison.simulation.as_ref().ok()?;
    let period_s = found.period_s.filter(|_| found.behaviour == Behaviour::Periodic)?;
    let parameters = &row.read.run.parameters;
    let rate_per_s = nearest_f64(&parameters.rate_per_s());
    let options = Options { start: row.read.start, ..Options::at(found.peak_relative_error) };
    let until = PERIODS * period_s * rate_per_s;
    let samples = follow(parameters, row.read.run.law, options, found, (until, None)).ok()?;
    let level = libm::log(nearest_f64(&parameters.point.loading_velocity_m_per_s));
    Some(Recording {
        times_s: samples.iter().map(|sample| sample.time / rate_per_s).collect(),
        log_velocities: samples.iter().map(|sample| sample.state[0] + level).collect(),
        stresses_pa: Vec::new(),
    })
}
