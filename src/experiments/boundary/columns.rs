//! What a point of a line states, the same in tables, on the command line and in JSON: one list for the boundary, one for the line of a
//! frequency or damping ratio.

use rug::Float;

use slipmode_core::number::Ball;
use slipmode_core::number::format::certain_digits;
use slipmode_core::stability::PairLinePoint;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::table::{Cell, Column};

/// What stands in a column.
#[derive(Debug)]
pub enum Stated<'p> {
    /// A word, or none.
    Word(Option<&'static str>),
    /// A sign.
    Sign(i8),
    /// A number.
    Number(&'p Ball),
    /// A number of order one, which shows as 0 where it vanishes.
    OfOrderOne(&'p Ball),
}
use Stated::{Number, OfOrderOne, Sign, Word};

/// Name, header and unit of a column, which words do not have, and what a point states there.
pub type PointColumn<P> = (&'static str, &'static str, Option<&'static str>, fn(&P) -> Stated<'_>);

/// A point of a line.
pub trait LinePoint: Sized + 'static {
    /// Everything that it states.
    const STATES: &'static [PointColumn<Self>];

    /// The columns of its table.
    #[must_use]
    fn columns() -> Vec<Column> {
        let column = |(name, header, unit, _): &PointColumn<Self>| {
            unit.map_or_else(|| Column::text(name, header), |unit| Column::number(name, header, unit))
        };
        Self::STATES.iter().map(column).collect()
    }

    /// Its row, with at most so many digits, all of which are certain.
    fn row(&self, digits: usize) -> Vec<Cell> {
        let cell = |(.., state): &PointColumn<Self>| match state(self) {
            Word(word) => Cell::text(word.unwrap_or_default()),
            Sign(sign) => Cell::number(sign.to_string()),
            OfOrderOne(ball) if vanishes(ball, digits) => Cell::number("0"),
            Number(ball) | OfOrderOne(ball) => Cell::number(certain_digits(ball, digits)),
        };
        Self::STATES.iter().map(cell).collect()
    }

    /// Its numbers, under the names of their columns.
    fn numbers(&self) -> Vec<(&'static str, &Ball)> {
        let number = |&(name, .., state): &PointColumn<Self>| match state(self) {
            Number(ball) | OfOrderOne(ball) => Some((name, ball)),
            Word(_) | Sign(_) => None,
        };
        Self::STATES.iter().filter_map(number).collect()
    }
}

impl LinePoint for BoundaryPoint {
    const STATES: &'static [PointColumn<Self>] = &[
        ("arc", "Arc", None, |point| Word(Some(point.arc.as_str()))),
        ("double_root", "Double root r", Some(""), |point| Number(&point.double_root)),
        ("normal_stress_pa", "Normal stress σ", Some("Pa"), |point| Number(&point.normal_stress_pa)),
        ("loading_velocity_m_per_s", "Loading velocity V0", Some("m/s"), |point| {
            Number(&point.loading_velocity_m_per_s)
        }),
        ("asymptote", "Nearest asymptote", None, |point| Word(Some(point.asymptote.as_str()))),
        ("asymptote_value", "Its value", Some("Pa or m/s"), |point| Number(&point.asymptote_value)),
        ("relative_error", "exact/asymptote − 1", Some(""), |point| OfOrderOne(&point.relative_error)),
        ("log10_distance", "log10 distance", Some(""), |point| OfOrderOne(&point.log10_distance)),
        ("condition_number", "Condition number", Some(""), |point| OfOrderOne(&point.condition_number)),
        ("mark", "Mark", None, |point| Word(point.mark.map(|mark| mark.as_str()))),
    ];
}

impl LinePoint for PairLinePoint {
    const STATES: &'static [PointColumn<Self>] = &[
        ("transition_sign", "Sign of K − K_c", Some(""), |point| Sign(point.transition_sign)),
        ("real_part", "Re(s) in V0/D_c", Some(""), |point| OfOrderOne(&point.real_part)),
        ("normal_stress_pa", "Normal stress σ", Some("Pa"), |point| Number(&point.normal_stress_pa)),
        ("loading_velocity_m_per_s", "Loading velocity V0", Some("m/s"), |point| {
            Number(&point.loading_velocity_m_per_s)
        }),
        ("asymptote", "Nearest asymptote", None, |point| Word(Some(point.asymptote.as_str()))),
        ("asymptote_value", "Its value", Some("m/s or Pa"), |point| Number(&point.asymptote_value)),
        ("relative_error", "exact/asymptote − 1", Some(""), |point| OfOrderOne(&point.relative_error)),
        ("log10_distance", "log10 distance", Some(""), |point| OfOrderOne(&point.log10_distance)),
    ];
}

/// Whether a number of order one is zero to all digits: where the asymptote meets the boundary, the enclosure of its error
/// is tiny and around zero.
#[must_use]
pub fn vanishes(ball: &Ball, digits: usize) -> bool {
    let decimals = -(digits as f64) * std::f64::consts::LOG2_10;
    let is_tiny = |radius: &Float| radius.get_exp().is_some_and(|exponent| f64::from(exponent) < decimals);
    ball.contains_zero() && (ball.is_exact() || is_tiny(&ball.radius()))
}
