//! The points of the lines that `boundary` computes, as the command states them.

use slipmode::experiments::boundary::{boundary_columns, boundary_row, pair_line_columns, pair_line_row};
use slipmode_core::number::Ball;
use slipmode_core::stability::PairLinePoint;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::table::{Cell, Column};

use crate::cli::answer::Answer;

/// A point of a line.
pub trait Point {
    /// The columns of its table.
    fn columns() -> Vec<Column>;
    /// Its row, with at most so many digits.
    fn row(&self, digits: usize) -> Vec<Cell>;
    /// Its numbers, under the names of their columns.
    fn numbers(&self) -> Vec<(&'static str, &Ball)>;
    /// What it is, apart from its numbers.
    fn words(&self) -> Answer;

    /// States the point, with 64-bit numbers.
    fn part(&self) -> Answer {
        self.numbers().iter().fold(self.words(), |part, (name, ball)| part.with(name, ball.to_f64()))
    }
}

impl Point for BoundaryPoint {
    fn columns() -> Vec<Column> {
        boundary_columns()
    }

    fn row(&self, digits: usize) -> Vec<Cell> {
        boundary_row(self, digits)
    }

    fn numbers(&self) -> Vec<(&'static str, &Ball)> {
        vec![
            ("double_root", &self.double_root),
            ("normal_stress_pa", &self.normal_stress_pa),
            ("loading_velocity_m_per_s", &self.loading_velocity_m_per_s),
            ("asymptote_value", &self.asymptote_value),
            ("relative_error", &self.relative_error),
            ("log10_distance", &self.log10_distance),
            ("condition_number", &self.condition_number),
        ]
    }

    fn words(&self) -> Answer {
        Answer::default()
            .with("arc", self.arc.as_str())
            .with("asymptote", self.asymptote.as_str())
            .with("mark", self.mark.map(|mark| mark.as_str()))
    }
}

impl Point for PairLinePoint {
    fn columns() -> Vec<Column> {
        pair_line_columns()
    }

    fn row(&self, digits: usize) -> Vec<Cell> {
        pair_line_row(self, digits)
    }

    fn numbers(&self) -> Vec<(&'static str, &Ball)> {
        vec![
            ("real_part", &self.real_part),
            ("normal_stress_pa", &self.normal_stress_pa),
            ("loading_velocity_m_per_s", &self.loading_velocity_m_per_s),
            ("asymptote_value", &self.asymptote_value),
            ("relative_error", &self.relative_error),
            ("log10_distance", &self.log10_distance),
        ]
    }

    fn words(&self) -> Answer {
        Answer::default()
            .with("transition_sign", self.transition_sign)
            .with("asymptote", self.asymptote.as_str())
    }
}
