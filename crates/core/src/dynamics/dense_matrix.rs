//! Inversion of the small MPFR matrices from which the methods' constants come.

use rug::Float;

/// Rows of a square matrix.
pub(super) type Matrix = Vec<Vec<Float>>;

/// The inverse by Gauss-Jordan elimination with row pivoting, in the precision of the entries; the matrix must be regular.
pub(super) fn inverse(matrix: &Matrix) -> Matrix {
    let size = matrix.len();
    let precision = matrix[0][0].prec();
    let mut left = matrix.clone();
    let mut right: Matrix = (0..size)
        .map(|i| (0..size).map(|j| Float::with_val(precision, u32::from(i == j))).collect())
        .collect();
    for column in 0..size {
        let largest = |row: &usize| left[*row][column].clone().abs();
        let pivot_row =
            (column..size).fold(column, |best, row| if largest(&row) > largest(&best) { row } else { best });
        left.swap(column, pivot_row);
        right.swap(column, pivot_row);
        let pivot = left[column][column].clone();
        for entry in left[column].iter_mut().chain(&mut right[column]) {
            *entry /= &pivot;
        }
        for row in (0..size).filter(|&row| row != column) {
            let factor = left[row][column].clone();
            subtract_multiple(&mut left, row, column, &factor);
            subtract_multiple(&mut right, row, column, &factor);
        }
    }
    right
}

fn subtract_multiple(matrix: &mut Matrix, row: usize, from: usize, factor: &Float) {
    let source = matrix[from].clone();
    for (entry, value) in matrix[row].iter_mut().zip(source) {
        *entry -= value * factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_of_a_permuted_hilbert_matrix_is_exact_to_its_condition() {
        let hilbert: Matrix = (0..6)
            .map(|i| (0..6).map(|j| Float::with_val(300, 1) / (1 + (5 - i) + j) as u32).collect())
            .collect();
        let inverse = inverse(&hilbert);
        for (i, row) in hilbert.iter().enumerate() {
            for j in 0..6 {
                let product =
                    row.iter().zip(&inverse).fold(Float::with_val(300, 0), |sum, (entry, column)| {
                        sum + Float::with_val(300, entry * &column[j])
                    });
                // The condition number is 1.5e7; 300 bits leave 80 digits.
                assert!((product - u32::from(i == j)).abs() < 1e-75);
            }
        }
    }
}
