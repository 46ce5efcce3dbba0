//! The least sum of squares over some coordinates, by the method of Levenberg and Marquardt.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use super::parameter::{Parameter, Point};
use super::problem::{Evaluated, FINE, FitProblem, MEDIUM, sum_of_squares};

/// A minimum.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// Where it is.
    pub point: Point,
    /// The residuals there with their derivatives.
    pub evaluated: Evaluated,
    /// The sum of their squares.
    pub cost: f64,
    /// Runs that the search made.
    pub runs: usize,
    /// Whether the search ended by itself.
    pub is_converged: bool,
}

/// Relative change of the sum of squares and of the coordinates, and cosine of residuals and derivatives, below which a search ends.
const TOLERANCE: f64 = 1e-11;

/// How long and how exactly to search.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Runs for each coordinate, at most.
    patience: usize,
    /// The permitted local error of the runs.
    local_tolerance: f64,
}

/// A search to the end.
pub const LONG: Effort = Effort { patience: 30, local_tolerance: FINE };
/// A search from next to its end, along a profile.
pub const NEAR: Effort = Effort { patience: 8, local_tolerance: FINE };
/// A search that only tells which start is best.
pub const SHORT: Effort = Effort { patience: 5, local_tolerance: MEDIUM };

/// Searches the least sum of squares over these parameters; the others stay. None where the start has no run.
pub fn minimise(
    problem: FitProblem<'_>,
    start: &Point,
    free: &[Parameter],
    effort: Effort,
) -> Option<Minimum> {
    let Effort { patience, local_tolerance } = effort;
    let evaluated = Some(problem.evaluate(start, local_tolerance, true)?);
    let search = Search { problem, free, local_tolerance, point: *start, evaluated };
    let method = LevenbergMarquardt::new().with_tol(TOLERANCE).with_patience(patience);
    let (search, report) = method.minimize(search);
    let evaluated = search.evaluated?;
    let cost = sum_of_squares(&evaluated.residuals);
    // Without a possible improvement, the rounding of the runs is reached.
    let is_converged = report.termination.was_successful()
        || matches!(report.termination, TerminationReason::NoImprovementPossible(_));
    Some(Minimum { point: search.point, evaluated, cost, runs: report.number_of_evaluations, is_converged })
}

/// A search in progress.
struct Search<'r> {
    problem: FitProblem<'r>,
    free: &'r [Parameter],
    local_tolerance: f64,
    point: Point,
    evaluated: Option<Evaluated>,
}

/// The residual of every sample where the slider has no run: the step is then refused.
const WITHOUT_RUN: f64 = 1e6;

impl LeastSquaresProblem<f64, Dyn, Dyn> for Search<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, values: &DVector<f64>) {
        for (parameter, value) in self.free.iter().zip(values.iter()) {
            self.point[*parameter as usize] = *value;
        }
        self.evaluated = self.problem.evaluate(&self.point, self.local_tolerance, true);
    }

    fn params(&self) -> DVector<f64> {
        let values = self.free.iter().map(|parameter| self.point[*parameter as usize]);
        DVector::from_iterator(self.free.len(), values)
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(match &self.evaluated {
            Some(evaluated) => DVector::from_column_slice(&evaluated.residuals),
            None => DVector::from_element(self.problem.record.rows(), WITHOUT_RUN),
        })
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let rows = &self.evaluated.as_ref()?.derivatives;
        Some(DMatrix::from_fn(rows.len(), self.free.len(), |row, column| {
            rows[row][self.free[column] as usize]
        }))
    }
}

/// The inverse of the normal equations over some parameters: the covariance for residuals of variance 1. None where it is singular.
pub fn covariance(evaluated: &Evaluated, free: &[Parameter]) -> Option<DMatrix<f64>> {
    let entry = |one: Parameter, other: Parameter| -> f64 {
        evaluated.derivatives.iter().map(|row| row[one as usize] * row[other as usize]).sum()
    };
    let normal = DMatrix::from_fn(free.len(), free.len(), |i, j| entry(free[i], free[j]));
    // Scaled to a unit diagonal, so that the units of the parameters do not matter.
    let scale: Vec<f64> = (0..free.len()).map(|i| normal[(i, i)].sqrt()).collect();
    let scaled = DMatrix::from_fn(free.len(), free.len(), |i, j| normal[(i, j)] / (scale[i] * scale[j]));
    let inverse = scaled.cholesky()?.inverse();
    let covariance = DMatrix::from_fn(free.len(), free.len(), |i, j| inverse[(i, j)] / (scale[i] * scale[j]));
    covariance.iter().all(|entry| entry.is_finite()).then_some(covariance)
}
