//! Small matrices of intervals, and orthogonal frames with an enclosed inverse.

use super::interval::{Interval, generously_up};

/// A square matrix of intervals.
pub(super) type Square<const N: usize> = [[Interval; N]; N];

/// A product of matrices; loops rather than closures, which the compiler leaves as calls.
pub(super) fn multiply<const N: usize, const M: usize, const K: usize>(
    a: &[[Interval; M]; N],
    b: &[[Interval; K]; M],
) -> [[Interval; K]; N] {
    let mut product = [[Interval::ZERO; K]; N];
    for i in 0..N {
        for j in 0..K {
            for m in 0..M {
                product[i][j] = product[i][j] + a[i][m] * b[m][j];
            }
        }
    }
    product
}

/// A matrix times a vector.
pub(super) fn apply<const N: usize, const M: usize>(
    a: &[[Interval; M]; N],
    v: &[Interval; M],
) -> [Interval; N] {
    multiply(a, &v.map(|c| [c])).map(|[c]| c)
}

/// The determinant.
pub(super) fn determinant(m: &Square<3>) -> Interval {
    m[0][0] * cofactor(m, 0, 0) + m[0][1] * cofactor(m, 0, 1) + m[0][2] * cofactor(m, 0, 2)
}

fn cofactor(m: &Square<3>, i: usize, j: usize) -> Interval {
    let [[a, b], [c, d]] = [(i + 1) % 3, (i + 2) % 3].map(|i| [m[i][(j + 1) % 3], m[i][(j + 2) % 3]]);
    a * d - b * c
}

/// Encloses the inverse; none where the determinant may be zero.
pub(super) fn inverse(m: &Square<3>) -> Option<Square<3>> {
    let factor = determinant(m).reciprocal();
    let is_known = factor.is_bounded();
    is_known.then(|| std::array::from_fn(|i| std::array::from_fn(|j| cofactor(m, j, i) * factor)))
}

/// A point matrix as intervals.
pub(super) fn points<const N: usize>(a: &[[f64; N]; N]) -> Square<N> {
    a.map(|row| row.map(Interval::point))
}

/// A frame: columns that are orthonormal to rounding, the longest of the scaled columns first.
#[derive(Debug, Clone)]
pub(super) struct Frame<const N: usize> {
    pub columns: Square<N>,
    pub inverse: Square<N>,
}

impl<const N: usize> Frame<N> {
    /// The unit vectors.
    pub fn identity() -> Self {
        let unit: Square<N> = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { Interval::ONE } else { Interval::ZERO })
        });
        Self { columns: unit, inverse: unit }
    }

    /// Gram-Schmidt, twice, on the columns of a matrix in the order of their lengths times `weights`.
    pub fn of(matrix: &Square<N>, weights: [f64; N]) -> Self {
        let column = |j: usize| -> [f64; N] { std::array::from_fn(|i| matrix[i][j].mid) };
        let mut order: [usize; N] = std::array::from_fn(|j| j);
        let length = |j: usize| weights[j] * norm(&column(j));
        order.sort_by(|&a, &b| length(b).total_cmp(&length(a)));
        let mut frame: Vec<[f64; N]> = Vec::with_capacity(N);
        let units = (0..N).map(|i| std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 }));
        for candidate in order.into_iter().map(column).chain(units) {
            if frame.len() < N
                && let Some(unit) = orthogonal_part(candidate, &frame)
            {
                frame.push(unit);
            }
        }
        Self::enclosed(&std::array::from_fn(|i| std::array::from_fn(|j| frame[j][i])))
    }

    /// With E = I − QᵀQ and ‖E‖ ≤ e < 1 in the norm of largest row sums, Q⁻¹ = (I − E)⁻¹Qᵀ is within ‖Qᵀ‖ e/(1 − e) of Qᵀ.
    fn enclosed(q: &[[f64; N]; N]) -> Self {
        let columns = points(q);
        let transposed: Square<N> = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
        let gram = multiply(&transposed, &columns);
        let defect: Square<N> = std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { Interval::ONE - gram[i][j] } else { -gram[i][j] })
        });
        let e = largest_row(&defect);
        let distance =
            if e < 0.5 { generously_up(2.0 * e * largest_row(&transposed)) } else { f64::INFINITY };
        Self { columns, inverse: transposed.map(|row| row.map(|entry| entry.widened(distance))) }
    }
}

/// The largest sum of sizes in a row.
pub(super) fn largest_row<const N: usize, const M: usize>(matrix: &[[Interval; M]; N]) -> f64 {
    matrix.iter().map(|row| generously_up(row.iter().map(|entry| entry.magnitude()).sum())).fold(0.0, worse)
}

/// The larger of two numbers; not a number if one of them is not.
pub(super) fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// The unit vector of the part of a vector that is orthogonal to others; none where rounding leaves nothing of it.
fn orthogonal_part<const N: usize>(mut v: [f64; N], others: &[[f64; N]]) -> Option<[f64; N]> {
    let before = norm(&v);
    // A vector of extreme length is brought to about one first.
    let scale = 1.0 / before;
    v = v.map(|c| c * scale);
    for _ in 0..2 {
        for other in others {
            let along: f64 = v.iter().zip(other).map(|(a, b)| a * b).sum();
            v = std::array::from_fn(|i| v[i] - along * other[i]);
        }
    }
    let left = norm(&v);
    if !(left > 1e-12) {
        return None;
    }
    let mut unit = v.map(|c| c / left);
    for other in others {
        let along: f64 = unit.iter().zip(other).map(|(a, b)| a * b).sum();
        unit = std::array::from_fn(|i| unit[i] - along * other[i]);
    }
    let length = norm(&unit);
    Some(unit.map(|c| c / length))
}
