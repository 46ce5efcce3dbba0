//! The constants of Radau IIA with any number of stages, derived with MPFR from the definition of the method.
//!
//! The nodes are the zeros of M(t) = d^{s−1}/dt^{s−1} [t^{s−1} (t − 1)^s]; A integrates the Lagrange polynomials on them.
//! A eigenvector of A to the eigenvalue μ holds the node values of p = Σ μ^k M^{(k+1)}, because μ p and the integral of p differ
//! by a multiple of M; so the eigenvalues are the zeros of Σ μ^k M^{(k)}(0), the denominator of the stability function.
//! (Hairer & Wanner, *Solving Ordinary Differential Equations II*, IV.5 and IV.8, use the same A^{-1} = T Λ T^{-1}.)

use std::sync::OnceLock;

use rug::ops::Pow;
use rug::{Assign, Complex, Float};

use super::dense_matrix::{Matrix, inverse};
use super::scalar::Scalar;
use crate::number::Ball;
use slipmode_algebra::{AlgebraicRoot, UnivariatePolynomial};

/// Bits of all computations here: enough for the constants of every number type in use.
const PRECISION_BITS: u32 = 640;

/// Most stages that a table is kept for.
const MOST_STAGES: usize = 16;

/// The constants of a method.
#[derive(Debug, Clone)]
pub struct Constants<Row, Rows> {
    /// The nodes, ascending; the last is 1.
    pub nodes: Row,
    /// T: columns are the real eigenvector, then real and imaginary part of one of each conjugate pair.
    pub from_modes: Rows,
    /// T^{-1}.
    pub to_modes: Rows,
    /// A^{-1}.
    pub inverse: Rows,
    /// Eigenvalues λ of A^{-1}: the real one, then (Re, Im > 0) of each pair.
    pub eigenvalues: Row,
    /// Weights e of the stages in the error estimate γ0 h f(y_n) + Σ e_i Z_i of order S, γ0 the inverse real eigenvalue.
    pub error_weights: Row,
    /// Row k: weights of the stages in the coefficient of θ^{k+1} of the step polynomial.
    pub dense: Rows,
}

/// The constants of an S-stage method in one number type.
pub type Collocation<R, const S: usize> = Constants<[R; S], [[R; S]; S]>;

/// The constants at 640 bits.
type Table = Constants<Vec<Float>, Matrix>;

impl<R: Scalar, const S: usize> Collocation<R, S> {
    /// The constants, rounded from the ones kept at 640 bits. An even S, or one above 16, does not compile: there is no such method.
    pub(crate) fn new() -> Self {
        const { assert!(S % 2 == 1 && S <= MOST_STAGES) };
        static TABLES: [OnceLock<Table>; MOST_STAGES + 1] = [const { OnceLock::new() }; MOST_STAGES + 1];
        let table = TABLES[S].get_or_init(|| Table::derive(S));
        let row = |source: &[Float]| std::array::from_fn(|i| R::from_float(&source[i]));
        let matrix = |source: &Matrix| std::array::from_fn(|i| row(&source[i]));
        Self {
            nodes: row(&table.nodes),
            from_modes: matrix(&table.from_modes),
            to_modes: matrix(&table.to_modes),
            inverse: matrix(&table.inverse),
            eigenvalues: row(&table.eigenvalues),
            error_weights: row(&table.error_weights),
            dense: matrix(&table.dense),
        }
    }
}

fn real<T>(value: T) -> Float
where
    Float: Assign<T>,
{
    Float::with_val(PRECISION_BITS, value)
}

impl Table {
    fn derive(stages: usize) -> Self {
        let polynomial = node_polynomial(stages);
        let nodes = nodes(&polynomial);
        let polynomial = rounded(&polynomial);
        let basis: Vec<Vec<Float>> = (0..stages).map(|j| lagrange(&polynomial, &nodes[j])).collect();
        let runge_kutta: Matrix = nodes
            .iter()
            .map(|node| basis.iter().map(|l| evaluate(&antiderivative(l), node)).collect())
            .collect();
        let (eigenvalues, from_modes) = modes(&polynomial, &nodes);
        let inverse_matrix = inverse(&runge_kutta);
        let error_weights = error_weights(&nodes, &inverse_matrix, &eigenvalues[0]);
        let dense =
            (0..stages).map(|k| (0..stages).map(|j| real(&basis[j][k] / &nodes[j])).collect()).collect();
        Self {
            to_modes: inverse(&from_modes),
            inverse: inverse_matrix,
            nodes,
            from_modes,
            eigenvalues,
            error_weights,
            dense,
        }
    }
}

/// M, scaled to leading coefficient 1.
fn node_polynomial(stages: usize) -> UnivariatePolynomial {
    let mut power = vec![0; stages];
    power[stages - 1] = 1;
    let zeros_at_one = (0..stages).map(|_| UnivariatePolynomial::from_integers(&[-1, 1]));
    let product = zeros_at_one
        .fold(UnivariatePolynomial::from_integers(&power), |product, factor| product.times(&factor));
    (1..stages).fold(product, |derived, _| derived.derivative()).monic()
}

fn evaluate(polynomial: &[Float], at: &Float) -> Float {
    polynomial.iter().rev().fold(real(0), |sum, c| sum * at + c)
}

fn derivative(polynomial: &[Float]) -> Vec<Float> {
    polynomial.iter().enumerate().skip(1).map(|(k, c)| real(c * k as u32)).collect()
}

fn antiderivative(polynomial: &[Float]) -> Vec<Float> {
    let terms = polynomial.iter().enumerate().map(|(k, c)| real(c / (k + 1) as u32));
    std::iter::once(real(0)).chain(terms).collect()
}

/// The coefficients by ascending power.
fn rounded(polynomial: &UnivariatePolynomial) -> Vec<Float> {
    polynomial.coefficients().iter().map(real).collect()
}

/// The zeros of M, ascending; the last one is 1.
fn nodes(polynomial: &UnivariatePolynomial) -> Vec<Float> {
    let (others, _) = polynomial.divided_by(&UnivariatePolynomial::from_integers(&[-1, 1]));
    let enclosed = AlgebraicRoot::positive(&others).into_iter().map(|root| root.enclosed(PRECISION_BITS));
    let centre = |ball: Ball| real(ball.centre());
    enclosed.map(centre).chain([real(1)]).collect()
}

/// The Lagrange polynomial of one node: M divided by (t − node), scaled to 1 at the node.
fn lagrange(polynomial: &[Float], node: &Float) -> Vec<Float> {
    let mut quotient = vec![real(0); polynomial.len() - 1];
    let mut carry = real(0);
    for k in (0..quotient.len()).rev() {
        carry = carry * node + &polynomial[k + 1];
        quotient[k].assign(&carry);
    }
    let scale = evaluate(&quotient, node);
    quotient.into_iter().map(|c| c / &scale).collect()
}

/// Weights of the stages in the difference between the embedded quadrature of order s and the method.
fn error_weights(nodes: &[Float], inverse_runge_kutta: &Matrix, real_eigenvalue: &Float) -> Vec<Float> {
    let stages = nodes.len();
    let powers = |k: usize| nodes.iter().map(|node| real(node.pow(k as u32))).collect();
    let vandermonde: Matrix = (0..stages).map(powers).collect();
    // The quadrature takes γ0 f(y_n) as well, so the stages must give −γ0 at order one and nothing at the others.
    let solution: Vec<Float> =
        inverse(&vandermonde).iter().map(|row| -real(&row[0] / real_eigenvalue)).collect();
    let weight = |j: usize| {
        let terms = (0..stages).map(|i| real(&solution[i] * &inverse_runge_kutta[i][j]));
        terms.fold(real(0), |sum, term| sum + term)
    };
    (0..stages).map(weight).collect()
}

/// The eigenvalues of A^{-1} and the matrix T of its modes.
fn modes(polynomial: &[Float], nodes: &[Float]) -> (Vec<Float>, Matrix) {
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
    let from_modes = (0..nodes.len()).map(|i| columns.iter().map(|c| c[i].clone()).collect()).collect();
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

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_order_conditions<const S: usize>() {
        let table = Collocation::<f64, S>::new();
        // Stage order: the modes turn λ back into A^{-1}, and A^{-1} applied to c^k is k c^{k−1} for k = 1..S.
        for k in 1..=S as u32 {
            let power = |node: f64, k: u32| libm::pow(node, f64::from(k));
            let values: [f64; S] = table.nodes.map(|c| power(c, k));
            let modes: [f64; S] =
                std::array::from_fn(|i| (0..S).map(|j| table.to_modes[i][j] * values[j]).sum());
            let mut scaled = [table.eigenvalues[0] * modes[0]; S];
            for m in (1..S).step_by(2) {
                let (re, im) = (table.eigenvalues[m], table.eigenvalues[m + 1]);
                scaled[m] = re * modes[m] + im * modes[m + 1];
                scaled[m + 1] = re * modes[m + 1] - im * modes[m];
            }
            for i in 0..S {
                let derivative: f64 = (0..S).map(|j| table.from_modes[i][j] * scaled[j]).sum();
                let exact = f64::from(k) * power(table.nodes[i], k - 1);
                assert!(
                    (derivative - exact).abs() < 1e-11 * (S * S) as f64,
                    "{S} {k} {i}: {derivative} {exact}"
                );
            }
        }
    }

    #[test]
    fn the_modes_satisfy_the_stage_order_conditions() {
        assert_order_conditions::<3>();
        assert_order_conditions::<5>();
        assert_order_conditions::<7>();
        assert_order_conditions::<11>();
    }

    #[test]
    fn the_quadrature_has_order_2s_minus_1_and_no_more() {
        for stages in [3, 5, 7] {
            let polynomial = node_polynomial(stages);
            let (nodes, polynomial) = (nodes(&polynomial), rounded(&polynomial));
            let weights: Vec<Float> = nodes
                .iter()
                .map(|c| evaluate(&antiderivative(&lagrange(&polynomial, c)), &real(1)))
                .collect();
            for order in 1..=2 * stages {
                let terms = nodes.iter().zip(&weights).map(|(c, b)| {
                    Float::with_val(PRECISION_BITS, rug::ops::Pow::pow(c, order as u32 - 1)) * b
                });
                let defect = (terms.fold(real(0), |sum, term| sum + term) * order as u32 - 1u32).abs();
                assert_eq!(defect < 1e-150, order < 2 * stages, "{stages} {order}");
            }
        }
    }

    #[test]
    fn the_three_stage_constants_are_the_known_ones() {
        // Closed forms: c = (4 ∓ √6)/10, 1; the real eigenvalue is 3 + 3^{2/3} − 3^{1/3}.
        let table = Collocation::<f64, 3>::new();
        let root = 6f64.sqrt();
        assert!((table.nodes[0] - (4.0 - root) / 10.0).abs() < 1e-16);
        assert!((table.nodes[1] - (4.0 + root) / 10.0).abs() < 1e-15);
        let cube_root = libm::cbrt(3.0);
        assert!((table.eigenvalues[0] - (3.0 + cube_root * cube_root - cube_root)).abs() < 1e-14);
    }

    #[test]
    fn the_error_estimate_vanishes_on_polynomials_up_to_the_stage_order() {
        // y = t^k from y(0) = 0: Z = c^k and h f(y_n) is 1 for k = 1, else 0.
        let table = Collocation::<f64, 5>::new();
        for k in 1..=5u32 {
            let stages: f64 =
                (0..5).map(|i| table.error_weights[i] * libm::pow(table.nodes[i], f64::from(k))).sum();
            let start = if k == 1 { 1.0 / table.eigenvalues[0] } else { 0.0 };
            assert!((stages + start).abs() < 1e-12, "{k}");
        }
    }
}
