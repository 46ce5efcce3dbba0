//! How many roots of a polynomial over ℚ lie on which side of the imaginary axis, and how many of them are real: exact counts.

use rug::{Integer, Rational};

use crate::sturm::sign_changes;
use crate::{SturmSequence, UnivariatePolynomial};

/// Numbers of distinct roots of a polynomial.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct RootCounts {
    /// All of them.
    pub all: usize,
    /// Those that are real.
    pub real: usize,
    /// Those with a positive real part.
    pub right: usize,
    /// Those that are real and positive.
    pub positive: usize,
    /// Those on the imaginary axis.
    pub on_axis: usize,
}

impl UnivariatePolynomial {
    /// Where the distinct roots lie; none for the zero polynomial, which has every number as a root.
    ///
    /// Roots of which the opposite is a root too are taken out by a greatest common divisor and counted by their squares. The others
    /// are counted by the winding of the polynomial along the imaginary axis, a Cauchy index (Hermite 1856).
    #[must_use]
    pub fn root_counts(&self) -> Option<RootCounts> {
        let distinct = Some(self).filter(|one| !one.is_zero())?.squarefree();
        let opposite = distinct.gcd(&distinct.mirrored());
        let others = distinct.divided_by(&opposite).0;
        let zero = usize::from(opposite.coefficients()[0] == 0);
        // What is left of these is even: a polynomial in the square.
        let squares = Self::new(opposite.coefficients().iter().skip(zero).step_by(2).cloned().collect());
        let [negative_squares, _] = squares.real_roots();
        let [negative, positive] = distinct.real_roots();
        Some(RootCounts {
            all: distinct.degree().unwrap_or(0),
            real: negative + zero + positive,
            right: squares.degree().unwrap_or(0) - negative_squares + others.right_by_winding(),
            positive,
            on_axis: zero + 2 * negative_squares,
        })
    }

    /// The polynomial of −x.
    pub(crate) fn mirrored(&self) -> Self {
        let mut coefficients = self.coefficients().to_vec();
        coefficients.iter_mut().skip(1).step_by(2).for_each(|value| *value *= -1);
        Self::new(coefficients)
    }

    /// How many distinct negative roots there are, and how many positive ones.
    fn real_roots(&self) -> [usize; 2] {
        let Some((leading, lower @ [first, ..])) = self.coefficients().split_last() else { return [0; 2] };
        let ratios = lower.iter().map(|one| Rational::from(one / leading).abs());
        // Cauchy's bound, as a power of two.
        let bound: Rational = ratios.fold(Rational::new(), |most, one| most.max(one)) + 1;
        let bound = Rational::from(Integer::from(1) << (bound.ceil().numer().significant_bits() + 1));
        let sequence = SturmSequence::new(self);
        let zero = usize::from(*first == 0);
        let up_to_zero = sequence.count_roots(&Rational::from(-&bound), &Rational::new());
        [up_to_zero - zero, sequence.count_roots(&Rational::new(), &bound)]
    }

    /// The roots right of the imaginary axis, for a polynomial of which no two roots are opposite: half of the degree less the turns of
    /// its value along the axis.
    fn right_by_winding(&self) -> usize {
        let degree = self.degree().unwrap_or(0);
        // i^power, without the i of the odd ones.
        let part = |parity: usize| {
            let turned = |(power, value): (usize, &Rational)| match (power % 2 == parity, power / 2 % 2) {
                (false, _) => Rational::new(),
                (true, 0) => value.clone(),
                (true, _) => Rational::from(-value),
            };
            Self::new(self.coefficients().iter().enumerate().map(turned).collect())
        };
        let (even, odd) = (part(0), part(1));
        let turns = match degree % 2 {
            0 => -cauchy_index(even, odd),
            _ => cauchy_index(odd, even),
        };
        usize::try_from((degree as i64 - turns) / 2).unwrap_or(0)
    }
}

/// Jumps of `above/below` from −∞ to +∞ less those back, over the whole line.
fn cauchy_index(below: UnivariatePolynomial, above: UnivariatePolynomial) -> i64 {
    let (mut current, mut next) = (below, above);
    let (mut before, mut after) = (Vec::new(), Vec::new());
    while let Some(leading) = current.coefficients().last() {
        let sign = leading.cmp0();
        after.push(sign);
        before.push(if current.degree().unwrap_or(0) % 2 == 0 { sign } else { sign.reverse() });
        if next.is_zero() {
            break;
        }
        let remainder = current.divided_by(&next).1.primitive().scaled(&Rational::from(-1));
        (current, next) = (next, remainder);
    }
    sign_changes(&before) as i64 - sign_changes(&after) as i64
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// Roots are built in: real ones, pairs x ± iy, each perhaps with its opposite, and repeated ones.
        #[test]
        fn the_counts_are_those_of_built_in_roots(
            real in prop::collection::btree_set(-6_i64..7, 0..4),
            pairs in prop::collection::btree_set((-4_i64..5, 1_i64..5), 0..4),
            repeated in any::<bool>(),
            scale in prop::sample::select(vec![-7_i64, 1, 3]),
        ) {
            let linear = real.iter().map(|root| UnivariatePolynomial::from_integers(&[-root, 1]));
            let quadratic = pairs.iter().map(|(x, y)| UnivariatePolynomial::from_integers(&[x * x + y * y, -2 * x, 1]));
            let factors: Vec<UnivariatePolynomial> = linear.chain(quadratic).collect();
            let once = factors.iter().fold(UnivariatePolynomial::from_integers(&[scale]), |product, one| product.times(one));
            let p = factors.first().filter(|_| repeated).map_or(once.clone(), |one| once.times(one));
            let positive = real.iter().filter(|root| **root > 0).count();
            let wanted = RootCounts {
                all: real.len() + 2 * pairs.len(),
                real: real.len(),
                right: positive + 2 * pairs.iter().filter(|(x, _)| *x > 0).count(),
                positive,
                on_axis: usize::from(real.contains(&0)) + 2 * pairs.iter().filter(|(x, _)| *x == 0).count(),
            };
            prop_assert_eq!(p.root_counts(), Some(wanted));
        }
    }

    #[test]
    fn the_zero_polynomial_has_no_counts_and_another_constant_has_no_roots() {
        assert_eq!(UnivariatePolynomial::from_integers(&[]).root_counts(), None);
        assert_eq!(UnivariatePolynomial::from_integers(&[-3]).root_counts(), Some(RootCounts::default()));
    }

    #[test]
    fn the_bound_of_the_roots_lies_beyond_them() {
        for root in (-40..41).filter(|root| *root != 0) {
            for scale in [1, 9] {
                let p = UnivariatePolynomial::new(vec![
                    Rational::from((-root, scale)),
                    Rational::from((1, scale)),
                ]);
                let counts = p.root_counts().expect("not zero");
                assert_eq!((counts.real, counts.positive), (1, usize::from(root > 0)), "{root}/{scale}");
            }
        }
    }
}
