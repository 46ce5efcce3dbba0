//! An ellipsoid around steady sliding in which every motion decays.
//!
//! In z = (x, y, F/η) the equations are z' = f(z) with f(0) = 0, and f(z) = J̄z with a mean J̄ of the derivative over the segment from 0 to z.
//! For V = zᵀPz this gives V' = zᵀ(J̄ᵀP + PJ̄)z. Where this matrix is negative definite for every J̄ over a box, each ellipsoid V ≤ c inside the box
//! attracts. P solves J(0)ᵀP + PJ(0) = −I to rounding; what is proved depends on P only through the signs.

use super::Constants;
use super::cone::{Cone, Modes};
use super::interval::Interval;
use super::linear::{Square, determinant, inverse, multiply, points};
use crate::friction::EvolutionLaw;

/// The ellipsoid zᵀPz ≤ c.
#[derive(Debug, Clone)]
pub(super) struct Ellipsoid {
    form: Square<3>,
    level: f64,
    /// The diagonal of P⁻¹: |z_i|² ≤ c (P⁻¹)_ii.
    inverse: [Interval; 3],
    /// The modes, where all are real.
    modes: Option<Modes>,
}

/// Levels that are tried, each a tenth of the one before.
const LEVELS: i32 = 40;

impl Ellipsoid {
    /// The largest that is proved to attract, in steps of ten; none where none is.
    pub fn around_steady_sliding(constants: &Constants) -> Option<Self> {
        let at_rest = derivative(constants, &[Interval::ZERO; 3]).map(|row| row.map(|entry| entry.mid));
        let form = points(&lyapunov(&at_rest)?);
        let inverse = diagonal_of_inverse(&form)?;
        (0..LEVELS).find_map(|step| {
            let level = libm::pow(10.0, f64::from(2 - step));
            let reach: [f64; 3] =
                std::array::from_fn(|i| (Interval::point(level) * inverse[i]).sqrt().upper());
            let around = derivative(constants, &reach.map(Interval::symmetric));
            let product = multiply(&form, &around);
            let falls: Square<3> =
                std::array::from_fn(|i| std::array::from_fn(|j| -(product[i][j] + product[j][i])));
            is_positive_definite(&falls).then(|| Self { form, level, inverse, modes: Modes::of(&at_rest) })
        })
    }

    /// Bounds of |x|, |y| and |w| from a box on, if every point of it lies inside.
    pub fn reach_from(&self, z: &[Interval; 3]) -> Option<[f64; 3]> {
        let value = (0..3)
            .fold(Interval::ZERO, |sum, i| (0..3).fold(sum, |sum, j| sum + z[i] * self.form[i][j] * z[j]));
        let value = value.upper();
        (value < self.level).then(|| self.inverse.map(|side| (Interval::point(value) * side).sqrt().upper()))
    }

    /// The cone that a state and all later states are proved to stay in.
    pub fn cone(&self, constants: &Constants, z: &[Interval; 3]) -> Option<Cone<'_>> {
        self.modes.as_ref()?.cone(z, |region| derivative(constants, region))
    }
}

/// The derivative of the rates of x, y and w = F/η over a box around zero.
fn derivative(constants: &Constants, [x, y, w]: &[Interval; 3]) -> Square<3> {
    let Constants { inertia, stiffness, effect_ratio, law } = *constants;
    let (velocity, inverse) = (x.exp(), (-*x).exp());
    let (by_x, by_y) = match law {
        EvolutionLaw::Slip => (-(velocity * (*x + *y + Interval::ONE)), -velocity),
        EvolutionLaw::Aging => (-velocity, -(-*y).exp()),
    };
    let fast = inertia.reciprocal();
    let of_force = [
        fast * (-(stiffness * velocity) + *w * inverse - effect_ratio * by_x),
        -(fast * (effect_ratio * by_y)),
        -(fast * inverse),
    ];
    [[-(*w * inverse), Interval::ZERO, inverse], [by_x, by_y, Interval::ZERO], of_force]
}

/// P with JᵀP + PJ = −I, to rounding: six linear equations.
fn lyapunov(j: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let place = |a: usize, b: usize| PAIRS.iter().position(|&pair| pair == (a.min(b), a.max(b)));
    let mut system = [[0.0; 7]; 6];
    for (row, &(a, b)) in PAIRS.iter().enumerate() {
        for k in 0..3 {
            system[row][place(k, b)?] += j[k][a];
            system[row][place(a, k)?] += j[k][b];
        }
        system[row][6] = if a == b { -1.0 } else { 0.0 };
    }
    let solution = solve(system)?;
    let mut form = [[0.0; 3]; 3];
    for (&(a, b), value) in PAIRS.iter().zip(solution) {
        (form[a][b], form[b][a]) = (value, value);
    }
    Some(form)
}

/// Gauss elimination with pivots.
fn solve(mut system: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for column in 0..6 {
        let pivot =
            (column..6).max_by(|&a, &b| system[a][column].abs().total_cmp(&system[b][column].abs()))?;
        system.swap(column, pivot);
        let pivot_row = system[column];
        if pivot_row[column] == 0.0 {
            return None;
        }
        for (_, row) in system.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column] / pivot_row[column];
            for (entry, of_pivot) in row.iter_mut().zip(pivot_row) {
                *entry -= factor * of_pivot;
            }
        }
    }
    Some(std::array::from_fn(|i| system[i][6] / system[i][i]))
}

/// Sylvester's criterion on a symmetric matrix of intervals.
fn is_positive_definite(m: &Square<3>) -> bool {
    let minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    m[0][0].lower() > 0.0 && minor.lower() > 0.0 && determinant(m).lower() > 0.0
}

/// Encloses the diagonal of the inverse, if the matrix is positive definite.
fn diagonal_of_inverse(m: &Square<3>) -> Option<[Interval; 3]> {
    let inverse = inverse(m).filter(|_| is_positive_definite(m))?;
    Some(std::array::from_fn(|i| inverse[i][i]))
}
