//! Lines whose height is the value of an expression, enclosed by balls.

use crate::parallel;

use super::{Point, coordinate, hold, point};
use crate::experiments::shared::cells::Digits;
use crate::scene::{ChartLine, EquationChart};
use slipmode_core::number::{Ball, nearest_f64};
use slipmode_plot::figure::{LineChart, Series};
use slipmode_plot::table::{Cell, Column, Table};

/// Bits of the balls, in turn; the second one is for values that nearly cancel.
const BITS: [u32; 2] = [128, 1024];

/// Digits of the table, as far as they are certain.
const DIGITS: usize = 12;

/// Relative radius, as a power of two, of a ball that has all digits of the table.
const SHARP: f64 = -48.0;

/// The chart of the lines, and the table of their numbers.
pub(super) fn draw(chart: &EquationChart) -> (String, Table) {
    let heights = heights(chart);
    let series = chart.lines.iter().zip(&heights);
    let svg = LineChart {
        caption: chart.caption.clone(),
        x: chart.x.axis.clone(),
        y: chart.y.clone(),
        series: series.map(|(line, heights)| Series::line(&line.label, drawn(chart, heights))).collect(),
        references: Vec::new(),
    };
    (svg.svg(), table(chart, &heights))
}

/// The heights of each line at the values of the horizontal axis.
pub(super) fn heights(chart: &EquationChart) -> Vec<Vec<Option<Ball>>> {
    let points: Vec<Point> = chart.x.values.iter().map(|value| point([(&chart.x, value)])).collect();
    chart.lines.iter().map(|line| parallel::map(&points, |at| height(line, at))).collect()
}

/// The points of a line; one without a height interrupts it.
pub(super) fn drawn(chart: &EquationChart, heights: &[Option<Ball>]) -> Vec<(f64, f64)> {
    let height = |one: &Option<Ball>| one.as_ref().map_or(f64::NAN, Ball::to_f64);
    chart.x.values.iter().zip(heights).map(|(x, one)| (nearest_f64(x), height(one))).collect()
}

/// The height at a point; none where the expression has no value, or none that is certain.
fn height(line: &ChartLine, at: &Point) -> Option<Ball> {
    if !hold(&line.given, at) {
        return None;
    }
    let enclosed = |bits: u32| {
        let balls = at.iter().map(|(name, value)| (name.clone(), Ball::from_rational(value, bits)));
        line.value.enclosed(&balls.collect(), bits)
    };
    let first = enclosed(BITS[0]);
    let is_sharp = first.as_ref().is_some_and(|ball| ball.is_exact() || ball.relative_radius_log2() < SHARP);
    if is_sharp { first } else { enclosed(BITS[1]) }
}

/// The table of a chart of lines.
fn table(chart: &EquationChart, heights: &[Vec<Option<Ball>>]) -> Table {
    let x = &chart.x;
    let columns = [x.column()].into_iter().chain(columns(chart));
    let mut table = Table::new(&chart.caption.id, &chart.caption.title, columns.collect()).with_note(
        "Digits are certain: each value is enclosed. A cell is empty where the expression has no value.",
    );
    for (row, value) in x.values.iter().enumerate() {
        table.push([coordinate(value)].into_iter().chain(cells(heights, row)).collect());
    }
    table
}

/// A column for each line.
pub(super) fn columns(chart: &EquationChart) -> impl Iterator<Item = Column> {
    chart.lines.iter().map(|line| Column::number(&line.column, &line.label, &chart.y.unit))
}

/// The heights of all lines at one value of the horizontal axis.
pub(super) fn cells(heights: &[Vec<Option<Ball>>], place: usize) -> impl Iterator<Item = Cell> {
    heights.iter().map(move |line| line[place].as_ref().cell(DIGITS))
}
