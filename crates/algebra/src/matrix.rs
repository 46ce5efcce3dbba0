//! Determinants without fractions, and what is made of them: resultants and discriminants.

use super::{Generator, Polynomial};

/// The determinant of a square matrix by Bareiss' fraction-free elimination: every division is exact.
#[must_use]
pub fn determinant(matrix: &[Vec<Polynomial>]) -> Polynomial {
    let mut rows = matrix.to_vec();
    let mut previous = Polynomial::one();
    let mut negative = false;
    for step in 0..rows.len().saturating_sub(1) {
        let Some(pivot) = (step..rows.len()).find(|&row| !rows[row][step].is_zero()) else {
            return Polynomial::zero();
        };
        if pivot != step {
            rows.swap(pivot, step);
            negative = !negative;
        }
        eliminate_below(&mut rows, step, &previous);
        previous = rows[step][step].clone();
    }
    let last = rows.last().and_then(|row| row.last()).cloned().unwrap_or_else(Polynomial::one);
    if negative { -&last } else { last }
}

fn eliminate_below(rows: &mut [Vec<Polynomial>], step: usize, previous: &Polynomial) {
    let (done, below) = rows.split_at_mut(step + 1);
    let pivot_row = &done[step];
    for row in below {
        for column in step + 1..pivot_row.len() {
            let cross = &(&row[column] * &pivot_row[step]) - &(&row[step] * &pivot_row[column]);
            // Sylvester's identity makes this division exact (Bareiss 1968).
            row[column] = cross.divide_exact(previous).unwrap_or(cross);
        }
    }
}

/// The resultant with respect to one variable: zero exactly where both have a common root or drop in degree.
#[must_use]
pub fn resultant(
    left: &Polynomial,
    right: &Polynomial,
    variable: &(impl AsRef<Generator> + ?Sized),
) -> Polynomial {
    determinant(&sylvester(left, right, variable))
}

/// The rows of the matrix whose determinant is the resultant: the left polynomial as often as the degree of the right one says,
/// moved by one column from row to row, and the right one likewise.
#[must_use]
pub fn sylvester(
    left: &Polynomial,
    right: &Polynomial,
    variable: &(impl AsRef<Generator> + ?Sized),
) -> Vec<Vec<Polynomial>> {
    let (left, right) = (left.coefficients(variable), right.coefficients(variable));
    let (left_degree, right_degree) = (left.len() - 1, right.len() - 1);
    let row = |coefficients: &[Polynomial], shift: usize| {
        let mut row = vec![Polynomial::zero(); left_degree + right_degree];
        row[shift..shift + coefficients.len()].clone_from_slice(coefficients);
        row[shift..shift + coefficients.len()].reverse();
        row
    };
    let upper = (0..right_degree).map(|shift| row(&left, shift));
    upper.chain((0..left_degree).map(|shift| row(&right, shift))).collect()
}

/// The discriminant with respect to one variable: resultant with the derivative, divided by the leading
/// coefficient, signed so that it is positive when all roots are real and distinct in degrees 2 and 3.
///
/// Degree at least 1; the zero polynomial has discriminant zero.
#[must_use]
pub fn discriminant(polynomial: &Polynomial, variable: &(impl AsRef<Generator> + ?Sized)) -> Polynomial {
    let degree = polynomial.degree(variable);
    let leading = polynomial.coefficients(variable).pop().unwrap_or_default();
    let resultant = resultant(polynomial, &polynomial.derivative(variable), variable);
    let quotient = resultant.divide_exact(&leading).unwrap_or_default();
    if degree * degree.saturating_sub(1) / 2 % 2 == 1 { -&quotient } else { quotient }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Domain, Expression, RationalFunction, Symbol};

    fn variable(name: &'static str) -> Polynomial {
        Polynomial::variable(name)
    }

    #[test]
    fn discriminant_of_a_quadratic() {
        let (a, b, c, x) = (variable("a"), variable("b"), variable("c"), variable("x"));
        let quadratic = &(&(&a * &x.pow(2)) + &(&b * &x)) + &c;
        let four = Polynomial::constant(rug::Rational::from(4));
        let expected = &b.pow(2) - &(&four * &(&a * &c));
        assert_eq!(discriminant(&quadratic, &Symbol::from("x")), expected);
    }

    #[test]
    fn discriminant_of_a_product_is_the_product_of_squared_differences() {
        let (p, q, r, x) = (variable("p"), variable("q"), variable("r"), variable("x"));
        let cubic = &(&(&x - &p) * &(&x - &q)) * &(&x - &r);
        let differences = &(&(&p - &q) * &(&q - &r)) * &(&p - &r);
        assert_eq!(discriminant(&cubic, &Symbol::from("x")), differences.pow(2));
    }

    #[test]
    fn determinant_needs_row_exchanges() {
        let (zero, one) = (Polynomial::zero(), Polynomial::one());
        let exchange = vec![vec![zero.clone(), one.clone()], vec![one, zero]];
        assert_eq!(determinant(&exchange), -&Polynomial::one());
    }

    /// The polynomial with these coefficients in x, by ascending power.
    fn polynomial(coefficients: &[i32]) -> Polynomial {
        let term = |(power, value): (u32, &i32)| variable("x").pow(power).scale(&(*value).into());
        (0..).zip(coefficients).map(term).fold(Polynomial::zero(), |sum, term| &sum + &term)
    }

    proptest! {
        #[test]
        fn determinants_are_those_written_out(size in 0..5_usize, entries in prop::collection::vec((-2..3, -1..2), 16)) {
            let rows: Vec<Vec<Polynomial>> =
                entries.chunks(4).take(size).map(|row| row[..size].iter().map(|(a, b)| polynomial(&[*a, *b])).collect()).collect();
            let written: Vec<Vec<Expression>> = rows.iter().map(|row| row.iter().map(Expression::from).collect()).collect();
            let wanted = Domain::default().rational_function(&crate::written_out(&written)).expect("a polynomial");
            prop_assert_eq!(RationalFunction::from(determinant(&rows)), wanted);
        }

        /// With roots a of a polynomial that begins with c, the resultant with q is the product of all q(a) times a power of c.
        #[test]
        fn resultants_and_discriminants_are_those_of_built_in_roots(
            roots in prop::collection::vec(-3..4, 1..5), leading in prop::sample::select(vec![-2, 1, 3]), other in prop::collection::vec(-3..4, 1..4)
        ) {
            let (x, right) = (Symbol::from("x"), polynomial(&other));
            let left = roots.iter().fold(polynomial(&[leading]), |product, root| &product * &polynomial(&[-root, 1]));
            let at = |root: &i32| right.evaluate(&[(x.clone(), (*root).into())].into()).expect("a number");
            let power = |exponent: u32| Polynomial::constant(leading.pow(exponent).into());
            let values = roots.iter().fold(rug::Rational::from(1), |product, root| product * at(root));
            prop_assert_eq!(resultant(&left, &right, &x), power(right.degree(&x)).scale(&values));
            let pairs = (0..roots.len()).flat_map(|one| (0..one).map(move |other| (one, other)));
            let differences: i32 = pairs.map(|(one, other)| (roots[one] - roots[other]).pow(2)).product();
            prop_assert_eq!(discriminant(&left, &x), power(2 * roots.len() as u32 - 2).scale(&differences.into()));
        }
    }
}
