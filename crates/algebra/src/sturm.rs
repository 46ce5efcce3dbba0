//! Real roots of a polynomial over ℚ: exact counts by Sturm's theorem, isolation by bisection on exact signs.

use std::cmp::Ordering;

use rug::{Integer, Rational};

use crate::UnivariatePolynomial;

/// Where one real root of a polynomial is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum IsolatingInterval {
    /// The root is this rational.
    Exact(Rational),
    /// The root is the only one between these rationals, neither of which is a root; they have one sign.
    Between(Rational, Rational),
}

/// Sturm's sequence of the squarefree part of a polynomial: counts distinct real roots exactly.
#[derive(Debug, Clone)]
pub struct SturmSequence {
    members: Vec<Vec<Integer>>,
}

impl SturmSequence {
    /// The sequence p, p′, −(p mod p′), …; each member scaled by a positive number to coprime integers.
    #[must_use]
    pub fn new(polynomial: &UnivariatePolynomial) -> Self {
        let mut current = polynomial.squarefree().primitive();
        let mut next = current.derivative().primitive();
        let mut members = vec![integers(&current)];
        while !next.is_zero() {
            members.push(integers(&next));
            let remainder = current.divided_by(&next).1.primitive().scaled(&Rational::from(-1));
            (current, next) = (next, remainder);
        }
        Self { members }
    }

    /// The number of distinct real roots in `lower < x ≤ upper`; 0 for the zero polynomial and for empty intervals.
    #[must_use]
    pub fn count_roots(&self, lower: &Rational, upper: &Rational) -> usize {
        self.variations(lower).saturating_sub(self.variations(upper))
    }

    /// Sign changes along the sequence, zeros left out.
    fn variations(&self, x: &Rational) -> usize {
        let signs = self.members.iter().map(|member| sign_at(member, x));
        sign_changes(&signs.filter(|sign| sign.is_ne()).collect::<Vec<_>>())
    }

    fn sign(&self, x: &Rational) -> Ordering {
        sign_at(&self.members[0], x)
    }
}

impl UnivariatePolynomial {
    /// The number of distinct real roots in `lower < x ≤ upper`, by Sturm's theorem.
    #[must_use]
    pub fn count_roots(&self, lower: &Rational, upper: &Rational) -> usize {
        SturmSequence::new(self).count_roots(lower, upper)
    }

    /// Disjoint enclosures of all distinct positive roots, ascending.
    ///
    /// Ends of intervals are dyadic; a root found to be dyadic on the way is returned exactly.
    /// The exponent is bisected before the mantissa, so that roots tens of thousands of decades apart cost little.
    #[must_use]
    pub fn isolate_positive_roots(&self) -> Vec<IsolatingInterval> {
        let Some((low, high)) = positive_root_exponents(self) else { return Vec::new() };
        let sequence = SturmSequence::new(self);
        let mut roots = Vec::new();
        bisect(&sequence, power_of_two(low), power_of_two(high), &mut roots);
        roots
    }

    /// Whether this polynomial has a root in an isolating interval of another one; the zero polynomial has every one.
    pub(crate) fn has_root_in(&self, interval: &IsolatingInterval) -> bool {
        match interval {
            _ if self.degree().unwrap_or(0) == 0 => self.is_zero(),
            IsolatingInterval::Exact(root) => self.evaluate(root) == 0,
            IsolatingInterval::Between(lower, upper) => self.count_roots(lower, upper) > 0,
        }
    }
}

/// How often the sign changes along a list without zeros.
pub(super) fn sign_changes(signs: &[Ordering]) -> usize {
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Appends the roots of `lower < x ≤ upper`; the order is ascending because the left half goes first.
fn bisect(sequence: &SturmSequence, lower: Rational, upper: Rational, roots: &mut Vec<IsolatingInterval>) {
    let count = sequence.count_roots(&lower, &upper);
    let end_is_root = sequence.sign(&upper) == Ordering::Equal;
    match (count, end_is_root) {
        (0, _) => {}
        (1, true) => roots.push(IsolatingInterval::Exact(upper)),
        // A root at the open end would spoil the change of sign over the interval.
        (1, false) if sequence.sign(&lower) != Ordering::Equal => {
            roots.push(IsolatingInterval::Between(lower, upper));
        }
        _ => {
            let middle = middle(&lower, &upper);
            bisect(sequence, lower, middle.clone(), roots);
            bisect(sequence, middle, upper, roots);
        }
    }
}

/// A point between two positive numbers: the middle exponent while they are more than a factor 4 apart, then the mean.
fn middle(lower: &Rational, upper: &Rational) -> Rational {
    let (low, high) = (binary_exponent(lower), binary_exponent(upper));
    if high - low > 2 { power_of_two(low + (high - low) / 2) } else { Rational::from(lower + upper) / 2 }
}

/// e with 2^(e−1) ≤ x < 2^(e+1) for positive x.
fn binary_exponent(x: &Rational) -> i64 {
    i64::from(x.numer().significant_bits()) - i64::from(x.denom().significant_bits())
}

/// 2^exponent.
fn power_of_two(exponent: i64) -> Rational {
    let magnitude = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
    if exponent < 0 { Rational::from(1) >> magnitude } else { Rational::from(1) << magnitude }
}

/// Exponents l < h of two such that every positive root is in 2^l < x < 2^h (Cauchy's bound for p and its reverse).
///
/// None when the polynomial has fewer than two non-zero terms, and so no positive root.
fn positive_root_exponents(polynomial: &UnivariatePolynomial) -> Option<(i64, i64)> {
    let nonzero = polynomial.coefficients().iter().filter(|c| **c != 0);
    let nonzero: Vec<i64> = nonzero.map(binary_exponent).collect();
    let (first, last) = (*nonzero.first()?, *nonzero.last()?);
    let largest = *nonzero.iter().max()?;
    // |c_i/c_n| < 2^(e_i − e_n + 2), hence |x| < 1 + 2^(…) < 2^(… + 1).
    let bound = |end: i64| (largest - end + 2).max(0) + 1;
    (nonzero.len() > 1).then(|| (-bound(first), bound(last)))
}

fn integers(polynomial: &UnivariatePolynomial) -> Vec<Integer> {
    polynomial.coefficients().iter().map(|coefficient| coefficient.numer().clone()).collect()
}

/// The sign at n/d (d > 0) of the polynomial, from the integer Σ c_i n^i d^(degree−i).
fn sign_at(member: &[Integer], x: &Rational) -> Ordering {
    let mut value = Integer::new();
    let mut denominator_power = Integer::from(1);
    for coefficient in member.iter().rev() {
        value *= x.numer();
        value += Integer::from(coefficient * &denominator_power);
        denominator_power *= x.denom();
    }
    value.cmp0()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn from_roots(roots: &[(i64, i64)]) -> UnivariatePolynomial {
        roots.iter().fold(UnivariatePolynomial::from_integers(&[1]), |product, (numerator, denominator)| {
            product.times(&UnivariatePolynomial::from_integers(&[-numerator, *denominator]))
        })
    }

    #[test]
    fn counts_are_of_distinct_roots_in_the_half_open_interval() {
        let p = from_roots(&[(1, 2), (1, 2), (3, 1), (-4, 1)])
            .times(&UnivariatePolynomial::from_integers(&[1, 0, 1]));
        let at = |value: i32| Rational::from(value);
        assert_eq!(p.count_roots(&at(-100), &at(100)), 3);
        assert_eq!(p.count_roots(&at(0), &at(3)), 2);
        assert_eq!(p.count_roots(&at(3), &at(100)), 0);
        assert_eq!(p.count_roots(&at(-4), &at(0)), 0);
        assert_eq!(UnivariatePolynomial::from_integers(&[]).count_roots(&at(0), &at(1)), 0);
        assert_eq!(UnivariatePolynomial::from_integers(&[7]).isolate_positive_roots(), []);
    }

    #[test]
    fn roots_twenty_thousand_decades_apart_are_isolated() {
        let far = Rational::from(Integer::from(10) << 33_000_u32);
        let near = Rational::from(far.recip_ref());
        let factor =
            |root: &Rational| UnivariatePolynomial::new(vec![Rational::from(-root), Rational::from(1)]);
        let p = factor(&far).times(&factor(&near)).times(&factor(&Rational::from(-3)));
        let roots = p.isolate_positive_roots();
        assert_eq!(roots.len(), 2);
        let IsolatingInterval::Between(lower, upper) = &roots[1] else { panic!("the root is not dyadic") };
        assert!(*lower < far && far < *upper);
    }

    proptest! {
        #[test]
        fn every_positive_root_lies_in_its_interval(mut roots in prop::collection::vec((-60_i64..60, 1_i64..9), 1..6)) {
            let p = from_roots(&roots);
            roots.sort_by(|x, y| Rational::from(*x).cmp(&Rational::from(*y)));
            roots.dedup_by(|x, y| Rational::from(*x) == Rational::from(*y));
            roots.retain(|(numerator, _)| *numerator > 0);
            let intervals = p.isolate_positive_roots();
            prop_assert_eq!(intervals.len(), roots.len());
            for (interval, root) in intervals.iter().zip(&roots) {
                let root = Rational::from(*root);
                match interval {
                    IsolatingInterval::Exact(value) => prop_assert_eq!(value, &root),
                    IsolatingInterval::Between(lower, upper) => prop_assert!(*lower < root && root < *upper),
                }
            }
        }

        #[test]
        fn counts_are_those_of_the_known_roots(
            roots in prop::collection::vec((-60_i64..60, 1_i64..9), 0..5),
            squares in prop::collection::vec(1_i64..50, 0..3),
            ends in prop::collection::vec((-70_i64..70, 1_i64..9), 2),
        ) {
            // x² + n has no root, and x² − n² has two.
            let p = squares.iter().fold(from_roots(&roots), |p, n| p.times(&UnivariatePolynomial::from_integers(&[*n, 0, 1])));
            let known: std::collections::BTreeSet<Rational> = roots.iter().map(|root| Rational::from(*root)).collect();
            let [lower, upper] = [0, 1].map(|index| Rational::from(ends[index]));
            let between = known.iter().filter(|root| lower < **root && **root <= upper).count();
            prop_assert_eq!(p.count_roots(&lower, &upper), between);
        }

        /// Each interval holds one root and has none at its ends, and none is left out; roots need not be rational.
        #[test]
        fn intervals_are_apart_and_hold_all_positive_roots(
            coefficients in prop::collection::vec(-30_i64..30, 1..8),
            shift in 0_u32..90,
            dyadic in prop::collection::vec(-4_i32..5, 0..3),
        ) {
            let scaled: Vec<Rational> = coefficients.iter().zip(0_u32..).map(|(c, power)| Rational::from(*c) << (shift * power)).collect();
            // Roots at ends of intervals, which are powers of two.
            let p = dyadic.iter().fold(UnivariatePolynomial::new(scaled), |p, exponent| {
                p.times(&UnivariatePolynomial::new(vec![-(Rational::from(1) << *exponent), Rational::from(1)]))
            });
            let intervals = p.isolate_positive_roots();
            let far = Rational::from(1) << 100_u32;
            prop_assert_eq!(intervals.len(), if p.is_zero() { 0 } else { p.count_roots(&Rational::new(), &far) });
            let mut end = Rational::new();
            for interval in &intervals {
                let (lower, upper) = match interval {
                    IsolatingInterval::Exact(root) => {
                        prop_assert!(p.evaluate(root) == 0);
                        (root.clone(), root.clone())
                    }
                    IsolatingInterval::Between(lower, upper) => {
                        prop_assert!(p.evaluate(lower) != 0 && p.evaluate(upper) != 0 && lower < upper);
                        prop_assert_eq!(p.count_roots(lower, upper), 1);
                        (lower.clone(), upper.clone())
                    }
                };
                prop_assert!(lower > 0 && lower >= end);
                end = upper;
            }
        }

        #[test]
        fn another_polynomial_has_a_root_in_an_interval_where_they_share_it(
            (shared, own, other) in (-20_i64..20, -20_i64..20, -20_i64..20),
        ) {
            let square = |n: i64| UnivariatePolynomial::from_integers(&[-n, 0, 1]);
            let p = square(shared).times(&from_roots(&[(own, 1)]));
            let q = p.gcd(&square(shared).times(&square(other)));
            for interval in p.isolate_positive_roots() {
                let is_own = match &interval {
                    IsolatingInterval::Exact(root) => *root == own,
                    IsolatingInterval::Between(lower, upper) => *lower < own && own < *upper,
                };
                let is_shared = !is_own || [shared, other].contains(&(own * own));
                prop_assert_eq!(q.has_root_in(&interval), is_shared, "{:?}", interval);
                prop_assert!(UnivariatePolynomial::from_integers(&[]).has_root_in(&interval));
                prop_assert!(!UnivariatePolynomial::from_integers(&[3]).has_root_in(&interval));
            }
        }
    }
}
