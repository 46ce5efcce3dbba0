//! Eigenvalues and eigenvectors of the matrix of a collocation method, from its node polynomial M.

use rug::{Complex, Float};

use super::collocation::{PRECISION_BITS, derivative, evaluate};
use super::dense_matrix::Matrix;

/// The eigenvalues of A^{-1} and the matrix T of its modes.
pub(super) fn modes(polynomial: &[Float], nodes: &[Float]) -> (Vec<Float>, Matrix) {
    let mut derivatives = vec![polynomial.to_vec()];
    while derivatives[derivatives.len() - 1].len() > 1 {
        derivatives.push(derivative(&derivatives[derivatives.len() - 1]));
    }
    // Σ λ^{s−k} M^{(k)}(0) = 0, so the coefficient of λ^j is M^{(s−j)}(0).
    let characteristic: Vec<Float> = derivatives.iter().rev().map(|d| d[0].clone()).collect();
    let mut eigenvalues = Vec::new();
    let mut columns = Vec::new();
    for root in complex_zeros(&characteristic) {
        let vector: Vec<Complex> =
            nodes.iter().map(|node| eigenvector_entry(&derivatives, &root, node)).collect();
        let is_real = root.imag().clone().abs() < 1e-30;
        eigenvalues.push(root.real().clone());
        columns.push(vector.iter().map(|z| z.real().clone()).collect::<Vec<_>>());
        if !is_real {
            eigenvalues.push(root.imag().clone());
            columns.push(vector.iter().map(|z| z.imag().clone()).collect());
        }
    }
    let stages = nodes.len();
    let from_modes = (0..stages).map(|i| (0..stages).map(|j| columns[j][i].clone()).collect()).collect();
    (eigenvalues, from_modes)
}

fn eigenvector_entry(derivatives: &[Vec<Float>], eigenvalue: &Complex, node: &Float) -> Complex {
    let mut sum = Complex::new(PRECISION_BITS);
    for d in derivatives[1..].iter().rev() {
        sum = sum / eigenvalue + evaluate(d, node);
    }
    sum
}

/// The real zero first, then of each pair the one in the upper half-plane, by ascending imaginary part (Durand-Kerner).
fn complex_zeros(polynomial: &[Float]) -> Vec<Complex> {
    let degree = polynomial.len() - 1;
    let leading = &polynomial[degree];
    let value = |z: &Complex| {
        polynomial.iter().rev().fold(Complex::new(PRECISION_BITS), |sum, c| sum * z + c) / leading
    };
    let seed = Complex::with_val(PRECISION_BITS, (0.4, 0.9));
    let mut zeros: Vec<Complex> = (0..degree)
        .scan(Complex::with_val(PRECISION_BITS, degree as u32), |power, _| {
            *power *= &seed;
            Some(power.clone())
        })
        .collect();
    for _ in 0..60 + 12 * degree {
        for i in 0..degree {
            let mut step = value(&zeros[i]);
            for j in (0..degree).filter(|&j| j != i) {
                step /= Complex::with_val(PRECISION_BITS, &zeros[i] - &zeros[j]);
            }
            zeros[i] -= step;
        }
    }
    zeros.retain(|z| *z.imag() > -1e-30);
    zeros.sort_by(|a, b| a.imag().total_cmp(b.imag()));
    zeros
}
