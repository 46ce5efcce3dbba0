//! Small matrices of intervals, and orthogonal frames with an enclosed inverse.

use crate::interval::{Interval, generously_up, worse};

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

/// The unit matrix.
pub(super) fn unit<const N: usize>() -> Square<N> {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { Interval::ONE } else { Interval::ZERO }))
}

impl<const N: usize> Frame<N> {
    /// The unit vectors.
    pub fn identity() -> Self {
        Self { columns: unit(), inverse: unit() }
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
    pub fn enclosed(q: &[[f64; N]; N]) -> Self {
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

pub(super) fn norm<const N: usize>(v: &[f64; N]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// The unit vector of the part of a vector that is orthogonal to others; none where rounding leaves nothing of it.
fn orthogonal_part<const N: usize>(v: [f64; N], others: &[[f64; N]]) -> Option<[f64; N]> {
    let projected = |v: [f64; N]| {
        others.iter().fold(v, |v, other| {
            let along: f64 = v.iter().zip(other).map(|(a, b)| a * b).sum();
            std::array::from_fn(|i| v[i] - along * other[i])
        })
    };
    // A vector of extreme length is brought to about one first.
    let scale = 1.0 / norm(&v);
    let v = projected(projected(v.map(|c| c * scale)));
    let left = norm(&v);
    if !(left > 1e-12) {
        return None;
    }
    let unit = projected(v.map(|c| c / left));
    let length = norm(&unit);
    Some(unit.map(|c| c / length))
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::tests::exact::{self, exact};
    use slipmode_core::number::split_mix::SplitMix64;

    fn holds(interval: Interval, value: &Rational) -> bool {
        !interval.is_bounded() || exact::holds(interval, value)
    }

    /// The exact inverse by elimination.
    fn exact_inverse<const N: usize>(matrix: &[[f64; N]; N]) -> Vec<Vec<Rational>> {
        let unit = |i: usize, j: usize| Rational::from(u8::from(i == j));
        let mut rows: Vec<Vec<Rational>> = (0..N)
            .map(|i| matrix[i].iter().map(|&c| exact(c)).chain((0..N).map(|j| unit(i, j))).collect())
            .collect();
        for column in 0..N {
            let pivot = (column..N).find(|&i| !rows[i][column].is_zero()).unwrap();
            rows.swap(column, pivot);
            let factor = rows[column][column].clone();
            rows[column].iter_mut().for_each(|c| *c /= &factor);
            let from = rows[column].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
                let factor = row[column].clone();
                row.iter_mut().zip(&from).for_each(|(c, of)| *c -= Rational::from(&factor * of));
            }
        }
        rows.into_iter().map(|row| row[N..].to_vec()).collect()
    }

    fn holds_inverse<const N: usize>(enclosed: &Square<N>, matrix: &[[f64; N]; N]) -> bool {
        let inverse = exact_inverse(matrix);
        (0..N).all(|i| (0..N).all(|j| holds(enclosed[i][j], &inverse[i][j])))
    }

    fn random(random: &mut SplitMix64) -> [[f64; 3]; 3] {
        std::array::from_fn(|_| std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
    }

    /// The inverse of a matrix with errors holds the inverse of each corner, and its determinant holds theirs.
    #[test]
    fn an_inverse_holds_that_of_each_matrix() {
        let mut numbers = SplitMix64(7);
        let mut known = 0;
        for case in 0..200 {
            let (mid, rad) = (random(&mut numbers), [0.0, 1e-9, 1e-2][case % 3]);
            let enclosed = mid.map(|row| row.map(|mid| Interval { mid, rad }));
            let determinants = determinant(&enclosed);
            let found = super::inverse(&enclosed);
            known += usize::from(found.is_some());
            for _ in 0..8 {
                let corner = mid.map(|row| row.map(|c| if numbers.unit() < 0.5 { c - rad } else { c + rad }));
                // Rounding of the corner moves it by less than the radius of nothing else.
                let inside = if rad == 0.0 { mid } else { mid.map(|row| row.map(|c| 0.5 * c)) };
                let member: [[f64; 3]; 3] = std::array::from_fn(|i| {
                    std::array::from_fn(|j| {
                        if rad == 0.0 { inside[i][j] } else { mid[i][j] + 0.99 * (corner[i][j] - mid[i][j]) }
                    })
                });
                let [a, b, c] = member.map(|row| row.map(exact));
                let minor =
                    |i: usize, j: usize| Rational::from(&b[i] * &c[j]) - Rational::from(&b[j] * &c[i]);
                let value =
                    a[0].clone() * minor(1, 2) - a[1].clone() * minor(0, 2) + a[2].clone() * minor(0, 1);
                assert!(holds(determinants, &value), "{member:?} {determinants:?}");
                if let Some(inverse) = &found {
                    assert!(holds_inverse(inverse, &member), "{member:?} {inverse:?}");
                }
            }
        }
        assert!(known > 150, "{known}");
        let singular = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]];
        assert!(super::inverse(&points(&singular)).is_none());
    }

    /// A product holds the products of the ends.
    #[test]
    fn a_product_holds_the_products_of_its_members() {
        let mut numbers = SplitMix64(8);
        for _ in 0..100 {
            let (a, b, rad) = (random(&mut numbers), random(&mut numbers), numbers.unit());
            let around = |matrix: &[[f64; 3]; 3]| matrix.map(|row| row.map(|mid| Interval { mid, rad }));
            let product = multiply(&around(&a), &around(&b));
            for (sign, other) in [(0.0, 0.0), (0.9, 0.9), (-0.9, 0.9), (-0.9, -0.9)] {
                let [a, b] = [(a, sign), (b, other)]
                    .map(|(matrix, sign)| matrix.map(|row| row.map(|c| c + sign * rad)));
                for i in 0..3 {
                    for j in 0..3 {
                        let sum: Rational = (0..3).map(|m| exact(a[i][m]) * exact(b[m][j])).sum();
                        assert!(holds(product[i][j], &sum));
                    }
                }
            }
        }
    }

    /// The enclosed inverse of a frame holds the exact one, also of matrices that are far from orthogonal: scaled by 1 − s, and skew by s.
    #[test]
    fn the_inverse_of_a_frame_holds_the_exact_one() {
        let mut numbers = SplitMix64(9);
        for _ in 0..100 {
            let matrix = random(&mut numbers);
            let frame = Frame::of(&points(&matrix), [1.0, numbers.unit(), 1e-3]);
            let columns = frame.columns.map(|row| row.map(|c| c.mid));
            assert!(frame.inverse[0][0].rad < 1e-14 && holds_inverse(&frame.inverse, &columns));
        }
        let mut bounded = 0;
        for s in [1e-3, 0.02, 0.1, 0.2, 0.28, 0.35, 0.5, 0.9, 0.99] {
            for matrix in [
                [[1.0 - s, 0.0], [0.0, 1.0]],
                [[1.0, s], [0.0, 1.0]],
                [[1.0, 0.0], [-s, 1.0]],
                [[1.0, s], [s, 1.0]],
            ] {
                let enclosed = Frame::enclosed(&matrix).inverse;
                bounded += usize::from(enclosed[0][0].is_bounded());
                assert!(holds_inverse(&enclosed, &matrix), "{matrix:?} {enclosed:?}");
            }
        }
        assert!(bounded > 15, "{bounded}");
    }

    #[test]
    fn the_largest_row_and_the_worse_number_keep_what_is_not_a_number() {
        let nan = f64::NAN;
        assert!(worse(nan, 1.0).is_nan() && worse(1.0, nan).is_nan());
        assert!(worse(1.0, 2.0) == 2.0 && worse(2.0, 1.0) == 2.0);
        let row = |a: f64, b: f64| [Interval::point(a), Interval { mid: b, rad: 0.5 }];
        let largest = largest_row(&[row(-1.0, 2.0), row(0.5, -0.25)]);
        assert!((3.5..3.501).contains(&largest), "{largest}");
        assert!(largest_row(&[row(nan, 0.0), row(1.0, 0.0)]).is_nan());
        assert!(largest_row(&[row(1.0, 0.0), row(nan, 0.0)]).is_nan());
    }
}
