//! Derivatives of a run by its parameters: those of the discrete solution itself, not differences of runs.
//!
//! The stages of a step of Radau IIA satisfy A^{-1} Z = h F(u + Z). Their derivatives W = du/dp + dZ/dp solve the linear system
//! (A^{-1} ⊗ I − h diag J_i) W = (A^{-1} 1) ⊗ du/dp + h ∂F/∂p with the Jacobian J_i of each stage: one elimination for all parameters.

use super::radau::Radau;
use super::{Arrow, Model, State};

/// Stages of the method that [`super::drive`] uses.
pub(super) const STAGES: usize = 5;
/// Unknowns of a step.
const SIZE: usize = 3 * STAGES;

/// What a derivative is taken by: the direction of the change in ln η, ln κ, ln β, and in the logarithm of the unit of time D_c/V_l.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction {
    /// Change of ln η.
    pub log_inertial_parameter: f64,
    /// Change of ln κ.
    pub log_stiffness_group: f64,
    /// Change of ln β.
    pub log_effect_ratio: f64,
    /// Change of ln(D_c/V_l): at a given time in seconds the run is then less far.
    pub log_time_unit: f64,
}

impl Direction {
    /// ∂F/∂p of the rate F of a state.
    fn of_rate(&self, model: &Model<f64>, state: &State<f64>) -> State<f64> {
        let (rate, stiffness) = model.rate_and_stiffness(state);
        let ratio = model.groups().effect_ratio * state[1] * stiffness;
        [
            -self.log_effect_ratio * ratio - (self.log_inertial_parameter + self.log_time_unit) * rate[0],
            -self.log_time_unit * rate[1],
            (self.log_stiffness_group - self.log_time_unit) * rate[2],
        ]
    }
}

/// The derivatives of a state, one for each parameter.
pub type Derivatives<const P: usize> = [State<f64>; P];

/// Derivatives over one step: at its stages, as increments over those at its start.
pub(super) type StageDerivatives<const P: usize> = [Derivatives<P>; STAGES];

/// Carries the derivatives over the last step of a run, which had the length `h` and began at `from`.
pub(super) fn over_step<const P: usize>(
    model: &Model<f64>,
    method: &Radau<f64, STAGES>,
    (from, h): (&State<f64>, f64),
    derivatives: &Derivatives<P>,
    directions: &[Direction; P],
) -> StageDerivatives<P> {
    let (stages, constants) = method.last_stages();
    let mut matrix = [[0.0; SIZE]; SIZE];
    let mut right = [[0.0; P]; SIZE];
    for i in 0..STAGES {
        let state: State<f64> = std::array::from_fn(|c| from[c] + stages[i][c]);
        let jacobian = entries(&model.jacobian(&state));
        let forcing = directions.map(|direction| direction.of_rate(model, &state));
        let row_sum: f64 = constants.inverse[i].iter().sum();
        for c in 0..3 {
            let row = 3 * i + c;
            for (j, coefficient) in constants.inverse[i].iter().enumerate() {
                matrix[row][3 * j + c] = *coefficient;
            }
            for d in 0..3 {
                matrix[row][3 * i + d] -= h * jacobian[c][d];
            }
            for p in 0..P {
                right[row][p] = row_sum * derivatives[p][c] + h * forcing[p][c];
            }
        }
    }
    let solution = solve(matrix, right);
    std::array::from_fn(|i| {
        std::array::from_fn(|p| std::array::from_fn(|c| solution[3 * i + c][p] - derivatives[p][c]))
    })
}

/// The Jacobian with its zeros.
fn entries(arrow: &Arrow<f64>) -> [[f64; 3]; 3] {
    [[arrow.xx, arrow.xy, arrow.xz], [arrow.yx, arrow.yy, 0.0], [arrow.zx, 0.0, 0.0]]
}

/// Gaussian elimination with row pivoting, after each row is divided by its largest entry: rows of x contain 1/η.
fn solve<const P: usize>(mut matrix: [[f64; SIZE]; SIZE], mut right: [[f64; P]; SIZE]) -> [[f64; P]; SIZE] {
    for (row, values) in matrix.iter_mut().zip(&mut right) {
        let largest = row.iter().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
        row.iter_mut().chain(values).for_each(|entry| *entry /= largest);
    }
    for column in 0..SIZE {
        let larger = |best: usize, row: usize| {
            if matrix[row][column].abs() > matrix[best][column].abs() { row } else { best }
        };
        let pivot = (column..SIZE).fold(column, larger);
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let (source, values) = (matrix[column], right[column]);
        for row in column + 1..SIZE {
            let factor = matrix[row][column] / source[column];
            if factor != 0.0 {
                for k in column..SIZE {
                    matrix[row][k] -= factor * source[k];
                }
                for p in 0..P {
                    right[row][p] -= factor * values[p];
                }
            }
        }
    }
    for row in (0..SIZE).rev() {
        let (unknown, known) = right.split_at_mut(row + 1);
        for (p, value) in unknown[row].iter_mut().enumerate() {
            let rest: f64 =
                matrix[row][row + 1..].iter().zip(&*known).map(|(entry, known)| entry * known[p]).sum();
            *value = (*value - rest) / matrix[row][row];
        }
    }
    right
}
