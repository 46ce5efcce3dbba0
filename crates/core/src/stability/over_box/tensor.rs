//! Polynomials on the unit cube, whose Bernstein coefficients enclose their values there.

use rug::Integer;

use super::coefficient::Coefficient;
use crate::number::Rational;
use slipmode_algebra::UnivariatePolynomial;

/// The number of variables.
pub(super) const AXES: usize = 3;

/// A polynomial in three variables, each from 0 to 1, in the power basis or in Bernstein's.
#[derive(Debug, Clone)]
pub(super) struct Tensor<T> {
    /// Degree plus one in each variable.
    size: [usize; AXES],
    coefficients: Vec<T>,
}

impl<T: Coefficient> Tensor<T> {
    /// A constant.
    pub(super) fn constant(value: T) -> Self {
        Self { size: [1; AXES], coefficients: vec![value] }
    }

    /// The polynomial that goes from `start` to `end` with one variable.
    pub(super) fn line(axis: usize, start: T, end: &T) -> Self {
        let mut slope = start.clone();
        slope.times(&T::whole(&Integer::from(-1)));
        slope.add(end);
        let mut size = [1; AXES];
        size[axis] = 2;
        Self { size, coefficients: vec![start, slope] }
    }

    fn index(&self, [i, j, k]: [usize; AXES]) -> usize {
        (i * self.size[1] + j) * self.size[2] + k
    }

    fn places(size: [usize; AXES]) -> impl Iterator<Item = [usize; AXES]> {
        (0..size[0]).flat_map(move |i| (0..size[1]).flat_map(move |j| (0..size[2]).map(move |k| [i, j, k])))
    }

    /// The product of two polynomials in the power basis.
    pub(super) fn times(&self, other: &Self) -> Self {
        let size = std::array::from_fn(|axis| self.size[axis] + other.size[axis] - 1);
        let mut product = Self { size, coefficients: vec![T::default(); size.iter().product()] };
        for (left, p) in self.coefficients.iter().zip(Self::places(self.size)).filter(|(c, _)| !c.is_zero()) {
            for (right, q) in other.coefficients.iter().zip(Self::places(other.size)) {
                let at = product.index(std::array::from_fn(|axis| p[axis] + q[axis]));
                product.coefficients[at].add_product(left, right);
            }
        }
        product
    }

    /// The polynomial times a number.
    pub(super) fn scaled(mut self, factor: &Integer) -> Self {
        let factor = T::whole(factor);
        self.coefficients.iter_mut().for_each(|value| value.times(&factor));
        self
    }

    /// The sum of two polynomials in the power basis.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let size = std::array::from_fn(|axis| self.size[axis].max(other.size[axis]));
        let mut sum = Self { size, coefficients: vec![T::default(); size.iter().product()] };
        for part in [self, other] {
            for (value, place) in part.coefficients.iter().zip(Self::places(part.size)) {
                let at = sum.index(place);
                sum.coefficients[at].add(value);
            }
        }
        sum
    }

    /// The difference of two polynomials in the power basis.
    pub(super) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.clone().scaled(&Integer::from(-1)))
    }

    /// A positive multiple in Bernstein's basis, from the power basis.
    pub(super) fn into_bernstein(self) -> Self {
        (0..AXES).fold(self, |tensor, axis| {
            let degree = tensor.size[axis] as u32 - 1;
            tensor.along(axis, |powers| to_bernstein(powers, degree))
        })
    }

    /// Positive multiples of the same polynomial on the two halves of the cube, in Bernstein's basis.
    pub(super) fn halves(&self, axis: usize) -> [Self; 2] {
        let degree = self.size[axis] - 1;
        let lower = self.along(axis, |values| lower_half(values, degree));
        let upper = self.along(axis, |values| {
            values.reverse();
            lower_half(values, degree);
            values.reverse();
        });
        [lower, upper]
    }

    /// Each line of coefficients along an axis, changed.
    fn along(&self, axis: usize, change: impl Fn(&mut Vec<T>)) -> Self {
        let mut changed = self.clone();
        if self.size[axis] == 1 {
            return changed;
        }
        let mut start_size = self.size;
        start_size[axis] = 1;
        let mut line = Vec::with_capacity(self.size[axis]);
        for mut place in Self::places(start_size) {
            line.clear();
            for step in 0..self.size[axis] {
                place[axis] = step;
                line.push(changed.coefficients[self.index(place)].clone());
            }
            change(&mut line);
            for (step, value) in line.drain(..).enumerate() {
                place[axis] = step;
                changed.coefficients[self.index(place)] = value;
            }
        }
        changed
    }

    /// Whether every coefficient passes; with Bernstein's, so does every value if the test is a sign.
    pub(super) fn all(&self, test: impl Fn(&T) -> bool) -> bool {
        self.coefficients.iter().all(test)
    }

    /// The value at a corner of the cube, from Bernstein's basis, up to a positive factor.
    pub(super) fn at_corner(&self, corner: [bool; AXES]) -> &T {
        let place = std::array::from_fn(|axis| if corner[axis] { self.size[axis] - 1 } else { 0 });
        &self.coefficients[self.index(place)]
    }
}

impl Tensor<Integer> {
    /// A polynomial in the first variable alone, as one over ℚ.
    pub(super) fn univariate(&self) -> UnivariatePolynomial {
        UnivariatePolynomial::new(self.coefficients.iter().map(Rational::from).collect())
    }
}

/// From c_i to Σ_{i ≤ j} C(j, i)/C(n, i)·c_i, times the least common multiple of the divisors.
fn to_bernstein<T: Coefficient>(powers: &mut [T], degree: u32) {
    let binomials =
        || (0..=degree).scan(1, move |next, i| Some(std::mem::replace(next, *next * (degree - i) / (i + 1))));
    let common =
        binomials().fold(1, |common: u32, binomial| common / greatest_divisor(common, binomial) * binomial);
    for (binomial, power) in binomials().zip(powers.iter_mut()) {
        power.times_small(common / binomial);
    }
    add_lower_neighbours(powers);
}

fn greatest_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_divisor(b, a % b) }
}

/// De Casteljau's coefficients of the lower half, times 2^degree.
fn lower_half<T: Coefficient>(values: &mut [T], degree: usize) {
    add_lower_neighbours(values);
    for (i, value) in values.iter_mut().enumerate() {
        value.times_small(1 << (degree - i));
    }
}

/// From c_i to Σ_{i ≤ j} C(j, i)·c_i.
fn add_lower_neighbours<T: Coefficient>(values: &mut [T]) {
    for step in 1..values.len() {
        for i in (step..values.len()).rev() {
            let (left, right) = values.split_at_mut(i);
            right[0].add(&left[i - 1]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn evaluate(tensor: &Tensor<Integer>, at: [i64; AXES], of: i64) -> Rational {
        let power = |axis: usize, exponent: usize| {
            (0..exponent).fold(Rational::from(1), |value, _| value * Rational::from((at[axis], of)))
        };
        let terms = tensor.coefficients.iter().zip(Tensor::<Integer>::places(tensor.size));
        terms.fold(Rational::new(), |sum, (c, [i, j, k])| {
            sum + Rational::from(c) * power(0, i) * power(1, j) * power(2, k)
        })
    }

    fn example() -> Tensor<Integer> {
        let line = |axis, start: i32, end: i32| Tensor::line(axis, Integer::from(start), &Integer::from(end));
        let square = line(0, -3, 5).times(&line(0, 2, 1)).plus(&line(1, 7, -4));
        square.times(&square).times(&line(2, 3, 1)).minus(&line(2, 40, 50))
    }

    #[test]
    fn corners_of_every_half_have_the_sign_of_the_value_there() {
        let power = example();
        let whole = power.clone().into_bernstein();
        for axis in 0..AXES {
            for (half, tensor) in whole.halves(axis).iter().enumerate() {
                for corner in 0..8 {
                    let bit = |axis: usize| corner >> axis & 1 == 1;
                    let at = std::array::from_fn(|other| match other == axis {
                        true => half as i64 + i64::from(bit(other)),
                        false => 2 * i64::from(bit(other)),
                    });
                    let value = tensor.at_corner(std::array::from_fn(bit)).cmp0();
                    assert_eq!(value, evaluate(&power, at, 2).cmp0(), "{axis} {half} {corner}");
                }
            }
        }
    }

    #[test]
    fn coefficients_of_one_sign_enclose_the_values() {
        // u² − u + 1/2 on [0, 1]: Bernstein coefficients 1/2, 0, 1/2; both halves are positive.
        let line = Tensor::line(0, Integer::new(), &Integer::from(1));
        let half = Tensor::constant(Integer::from(1));
        let twice = line.times(&line).minus(&line).scaled(&Integer::from(2)).plus(&half).into_bernstein();
        assert!(twice.all(|value| *value >= 0) && !twice.all(|value| *value > 0));
        assert!(twice.halves(0).iter().all(|part| part.all(|value| *value > 0)));
    }
}
