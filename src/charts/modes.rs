//! Maps of where the roots of a polynomial lie: decided exactly at each point of a grid.

use crate::parallel;

use super::lines::{cells, columns, drawn, heights};
use super::{Point, coordinate, hold, point};
use crate::scene::{ChartMap, EquationChart};
use slipmode_algebra::{RootCounts, UnivariatePolynomial};
use slipmode_core::number::{Ball, Rational};
use slipmode_plot::figure::{Line, LineRole, Zone, ZoneMap, zones_of_grid};
use slipmode_plot::table::{Cell, Column, Table};

slipmode_algebra::named! {
    /// What the roots of a characteristic polynomial say of small disturbances.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    enum Mode {
        /// Every root is real and negative.
        Overdamped = "stable, without oscillation",
        /// Every root has a negative real part, and some are complex.
        Underdamped = "stable, oscillates",
        /// No root has a positive real part, and one lies on the imaginary axis.
        Neutral = "no root to the right of the imaginary axis, one on it",
        /// Every root with a positive real part is real.
        Divergence = "unstable, without oscillation",
        /// A complex root has a positive real part.
        Flutter = "unstable, oscillates",
    }
}

impl Mode {
    fn of(roots: RootCounts) -> Self {
        match roots {
            RootCounts { right: 0, on_axis: 0, real, all, .. } if real == all => Self::Overdamped,
            RootCounts { right: 0, on_axis: 0, .. } => Self::Underdamped,
            RootCounts { right: 0, .. } => Self::Neutral,
            RootCounts { right, positive, .. } if right == positive => Self::Divergence,
            _ => Self::Flutter,
        }
    }

    /// The pattern of the zone, alike to that of the slip mode with the same meaning.
    fn style(self) -> usize {
        match self {
            Self::Overdamped => 0,
            Self::Underdamped => 1,
            Self::Neutral => 5,
            Self::Divergence => 3,
            Self::Flutter => 4,
        }
    }
}

/// What the lines over a map look like, in their order.
const ROLES: [LineRole; 4] = [LineRole::Boundary, LineRole::Asymptote, LineRole::Section, LineRole::Guide];

/// The map with the lines over it, and the table of its points.
pub(super) fn draw(chart: &EquationChart, map: &ChartMap) -> (String, Table) {
    let (x, y) = (&chart.x, &map.y);
    let points = y.values.iter().flat_map(|height| x.values.iter().map(move |along| (along, height)));
    let points: Vec<(&Rational, &Rational)> = points.collect();
    let found: Vec<Option<RootCounts>> =
        parallel::map(&points, |&(along, height)| roots(map, &point([(x, along), (y, height)])));
    let class = |one: &Option<RootCounts>| {
        one.and_then(|roots| Mode::ALL.iter().position(|known| *known == Mode::of(roots)))
    };
    let classes: Vec<usize> = found.iter().map(|one| class(one).unwrap_or(Mode::ALL.len())).collect();
    let outlines = zones_of_grid(&x.axis, &y.axis, x.values.len(), &classes, Mode::ALL.len());
    let zones = Mode::ALL.iter().zip(outlines).filter(|(_, outlines)| !outlines.is_empty());
    let heights = heights(chart);
    let lines = chart.lines.iter().zip(&heights).zip(ROLES.iter().cycle());
    let svg = ZoneMap {
        caption: chart.caption.clone(),
        x: x.axis.clone(),
        y: y.axis.clone(),
        zones: zones
            .map(|(mode, outlines)| Zone { label: mode.as_str().into(), outlines, style: mode.style() })
            .collect(),
        lines: lines
            .map(|((line, heights), role)| Line::new(&line.label, *role, drawn(chart, heights)))
            .collect(),
        marks: Vec::new(),
        labels: Vec::new(),
    };
    (svg.svg(), table(chart, map, &heights, &points, &found))
}

/// Where the roots lie at a point; none where the polynomial is not defined or is zero.
fn roots(map: &ChartMap, at: &Point) -> Option<RootCounts> {
    if !hold(&map.given, at) {
        return None;
    }
    let coefficients = map.coefficients.iter().map(|one| one.rational_value(at));
    UnivariatePolynomial::new(coefficients.collect::<Option<_>>()?).root_counts()
}

fn table(
    chart: &EquationChart,
    map: &ChartMap,
    heights: &[Vec<Option<Ball>>],
    points: &[(&Rational, &Rational)],
    found: &[Option<RootCounts>],
) -> Table {
    let counts = [
        Column::number("roots_right", "Roots with a positive real part", ""),
        Column::number("roots_on_axis", "Roots on the imaginary axis", ""),
        Column::number("real_roots", "Real roots", ""),
        Column::text("mode", "Mode"),
    ];
    let columns = [chart.x.column(), map.y.column()].into_iter().chain(counts).chain(columns(chart));
    let mut table = Table::new(&chart.caption.id, &chart.caption.title, columns.collect()).with_note(
        "Counts of distinct roots, exact at each point; the heights of lines have certain digits. Cells are empty where the polynomial is not defined, or a line has no value.",
    );
    for (place, (&(along, height), roots)) in points.iter().zip(found).enumerate() {
        let count = |of: fn(&RootCounts) -> usize| {
            roots.as_ref().map_or_else(Cell::empty, |roots| Cell::number(of(roots).to_string()).certain())
        };
        let own = [
            coordinate(along),
            coordinate(height),
            count(|roots| roots.right),
            count(|roots| roots.on_axis),
            count(|roots| roots.real),
            roots.map_or_else(Cell::empty, |roots| Cell::text(Mode::of(roots).as_str())),
        ];
        table.push(own.into_iter().chain(cells(heights, place % chart.x.values.len())).collect());
    }
    table
}
