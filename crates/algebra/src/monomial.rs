//! Products of powers of variables and functions, in lexicographic order.

use std::cmp::Ordering;

use super::Generator;

/// A product of positive powers of distinct variables; the empty product is 1.
///
/// The order is lexicographic with the alphabetically first variable heaviest. It is admissible (1 is least, and
/// products keep the order), which is all that exact division needs.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Monomial(Vec<(Generator, u32)>);

impl Monomial {
    /// The monomial 1.
    #[must_use]
    pub fn one() -> Self {
        Self::default()
    }

    /// variable^exponent.
    #[must_use]
    pub fn power(variable: &(impl AsRef<Generator> + ?Sized), exponent: u32) -> Self {
        if exponent == 0 { Self::one() } else { Self(vec![(variable.as_ref().clone(), exponent)]) }
    }

    /// The factors, variables ascending, exponents positive.
    pub fn factors(&self) -> impl Iterator<Item = &(Generator, u32)> {
        self.0.iter()
    }

    /// The exponent of a variable, 0 when it is absent.
    #[must_use]
    pub fn exponent(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> u32 {
        self.0.iter().find(|(name, _)| name == variable.as_ref()).map_or(0, |(_, exponent)| *exponent)
    }

    /// This monomial with one variable struck out.
    #[must_use]
    pub fn without(&self, variable: &(impl AsRef<Generator> + ?Sized)) -> Self {
        Self(self.0.iter().filter(|(name, _)| name != variable.as_ref()).cloned().collect())
    }

    /// The product of two monomials.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut left, mut right) = (self.0.as_slice(), other.0.as_slice());
        while let ([(name, exponent), more_left @ ..], [(other_name, other_exponent), more_right @ ..]) =
            (left, right)
        {
            let order = name.cmp(other_name);
            let power = match order {
                Ordering::Less => (name, *exponent),
                Ordering::Equal => (name, exponent + other_exponent),
                Ordering::Greater => (other_name, *other_exponent),
            };
            product.push((power.0.clone(), power.1));
            left = if order.is_le() { more_left } else { left };
            right = if order.is_ge() { more_right } else { right };
        }
        product.extend_from_slice(left);
        product.extend_from_slice(right);
        Self(product)
    }

    /// The quotient, if `other` divides this monomial.
    #[must_use]
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        let mut quotient = Vec::with_capacity(self.0.len());
        let mut divisor = other.0.as_slice();
        for (name, exponent) in &self.0 {
            let mut left = *exponent;
            if let [(first, taken), more @ ..] = divisor
                && first == name
            {
                left = left.checked_sub(*taken)?;
                divisor = more;
            }
            if left > 0 {
                quotient.push((name.clone(), left));
            }
        }
        // A variable that this monomial does not have is left over.
        divisor.is_empty().then_some(Self(quotient))
    }

    /// The greatest monomial that divides both.
    pub(crate) fn common_divisor(&self, other: &Self) -> Self {
        let shared =
            self.0.iter().map(|(name, exponent)| (name.clone(), (*exponent).min(other.exponent(name))));
        Self(shared.filter(|(_, exponent)| *exponent > 0).collect())
    }

    /// The monomial whose square this is, if every exponent is even.
    #[must_use]
    pub fn square_root(&self) -> Option<Self> {
        let even = self.0.iter().all(|(_, exponent)| exponent % 2 == 0);
        even.then(|| Self(self.0.iter().map(|(name, exponent)| (name.clone(), exponent / 2)).collect()))
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        for ((left_name, left), (right_name, right)) in self.0.iter().zip(&other.0) {
            // The side that has the earlier variable at all is the heavier one.
            let order = right_name.cmp(left_name).then(left.cmp(right));
            if order != Ordering::Equal {
                return order;
            }
        }
        self.0.len().cmp(&other.0.len())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::Symbol;

    fn monomial(factors: &[(&'static str, u32)]) -> Monomial {
        factors.iter().fold(Monomial::one(), |product, (name, exponent)| {
            product.times(&Monomial::power(&Symbol::from(*name), *exponent))
        })
    }

    #[test]
    fn order_is_kept_by_products() {
        let all = [
            monomial(&[]),
            monomial(&[("y", 3)]),
            monomial(&[("x", 1)]),
            monomial(&[("x", 1), ("y", 1)]),
            monomial(&[("x", 1), ("z", 5)]),
            monomial(&[("x", 2)]),
        ];
        for left in &all {
            assert!(*left >= Monomial::one());
            for right in &all {
                for factor in &all {
                    assert_eq!(left.cmp(right), left.times(factor).cmp(&right.times(factor)));
                }
            }
        }
    }

    proptest! {
        #[test]
        fn exponents_add_and_subtract(one in prop::array::uniform4(0u32..4), other in prop::array::uniform4(0u32..4)) {
            const NAMES: [&str; 4] = ["w", "x", "y", "z"];
            let of = |exponents: [u32; 4]| {
                let powers = NAMES.iter().zip(exponents).map(|(name, exponent)| (*name, exponent));
                Monomial(powers.filter(|(_, power)| *power > 0).map(|(name, power)| (Symbol::from(name).as_ref().clone(), power)).collect())
            };
            let each = |change: fn(u32, u32) -> u32| of(std::array::from_fn(|index| change(one[index], other[index])));
            prop_assert_eq!(of(one).times(&of(other)), each(|one, other| one + other));
            let divides = one.iter().zip(other).all(|(one, other)| *one >= other);
            prop_assert_eq!(of(one).divided_by(&of(other)), divides.then(|| each(u32::saturating_sub)));
            prop_assert_eq!(of(one).common_divisor(&of(other)), each(u32::min));
        }
    }

    #[test]
    fn quotient_undoes_product() {
        let (left, right) = (monomial(&[("x", 2), ("y", 1)]), monomial(&[("x", 1), ("z", 3)]));
        assert_eq!(left.times(&right).divided_by(&right), Some(left.clone()));
        assert_eq!(left.divided_by(&right), None);
        assert_eq!(left.common_divisor(&right), monomial(&[("x", 1)]));
    }
}
