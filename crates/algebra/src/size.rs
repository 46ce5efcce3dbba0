//! How large an expression becomes when it is multiplied out, estimated from above before that is done.

use std::collections::BTreeSet;

use rug::{Integer, Rational};
use thiserror::Error;

use super::{Expression, Function, Generator, Polynomial};

/// An upper bound on a polynomial's number of terms, total degree, and the length of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// The number of terms.
    pub terms: u64,
    /// The total degree.
    pub degree: u64,
    /// The bits of the numbers that are written in it, multiplied out: `((2^64)^64)^64` has 262 144.
    pub bits: u64,
}

/// An expression that would become too large.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("multiplied out it may have {}", self.excess())]
pub struct TooLarge {
    /// The bound on what it becomes.
    pub found: Extent,
    /// What is allowed.
    pub largest: Extent,
}

impl TooLarge {
    fn excess(&self) -> String {
        let Self { found, largest } = self;
        if found.bits > largest.bits {
            return format!("numbers of {} bits (allowed: {} bits)", Count(found.bits), largest.bits);
        }
        let (terms, degree) = (Count(found.terms), Count(found.degree));
        format!(
            "{terms} terms and degree {degree} (allowed: {} terms, degree {})",
            largest.terms, largest.degree
        )
    }
}

/// A number that may have been too large to count.
struct Count(u64);

impl std::fmt::Display for Count {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0 {
            u64::MAX => formatter.write_str("more than 10^19"),
            count => write!(formatter, "{count}"),
        }
    }
}

/// A function of which nothing is known is a polynomial at a point: its numbers grow with each function in the argument of another one.
const DEGREE_OF_A_POINT: u64 = 3;

impl Extent {
    const ONE: Self = Self { terms: 1, degree: 0, bits: 0 };

    /// Of a polynomial as it is.
    #[must_use]
    pub fn of(polynomial: &Polynomial) -> Self {
        let bits = |number: &Integer| u64::from(number.significant_bits());
        let of = |coefficient: &Rational| bits(coefficient.numer()) + bits(coefficient.denom());
        Self {
            terms: polynomial.term_count() as u64,
            degree: polynomial.total_degree().into(),
            bits: polynomial.terms().map(|(_, coefficient)| of(coefficient)).max().unwrap_or_default(),
        }
    }

    /// Of a product: it has no more terms than there are powers of its variables up to their degrees.
    #[must_use]
    pub fn of_product(left: &Polynomial, right: &Polynomial) -> Self {
        let names: BTreeSet<_> = left.generators().into_iter().chain(right.generators()).collect();
        let powers = |name: &Generator| u64::from(left.degree(name)) + u64::from(right.degree(name)) + 1;
        let dense = names.iter().fold(1_u64, |count, name| count.saturating_mul(powers(name)));
        let product = Self::of(left).times(Self::of(right));
        Self { terms: product.terms.min(dense), ..product }
    }

    /// Of the sum of two such polynomials.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            terms: self.terms.saturating_add(other.terms),
            degree: self.degree.max(other.degree),
            bits: self.bits.saturating_add(other.bits),
        }
    }

    /// Of their product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self {
            terms: self.terms.saturating_mul(other.terms),
            degree: self.degree.saturating_add(other.degree),
            bits: self.bits.saturating_add(other.bits),
        }
    }

    /// Of a power: a sum of n terms to the power k has at most (n + k − 1)!/(k!(n − 1)!) terms.
    #[must_use]
    pub fn power(self, exponent: u32) -> Self {
        let others = self.terms.saturating_sub(1);
        let terms = (1..=u64::from(exponent))
            .try_fold(1_u64, |count, step| Some(count.checked_mul(others.checked_add(step)?)? / step));
        Self {
            terms: terms.unwrap_or(u64::MAX),
            degree: self.degree.saturating_mul(exponent.into()),
            bits: self.bits.saturating_mul(exponent.into()),
        }
    }

    /// # Errors
    /// When it is larger than allowed.
    pub fn within(self, largest: Self) -> Result<(), TooLarge> {
        if self.terms > largest.terms || self.degree > largest.degree || self.bits > largest.bits {
            return Err(TooLarge { found: self, largest });
        }
        Ok(())
    }
}

impl Expression {
    /// Checks that neither numerator nor denominator, nor those of a function's argument, become too large.
    ///
    /// # Errors
    /// With the bound that is exceeded.
    pub fn check_extent(&self, largest: Extent) -> Result<(), TooLarge> {
        self.extents(largest).map(|_| ())
    }

    /// Bounds of numerator and denominator.
    fn extents(&self, largest: Extent) -> Result<[Extent; 2], TooLarge> {
        let go = |inner: &Self| inner.extents(largest);
        let found = match self {
            Self::Number(value) => [value.numer(), value.denom()]
                .map(|part| Extent { bits: part.significant_bits().into(), ..Extent::ONE }),
            Self::Variable(_) => [Extent { degree: 1, ..Extent::ONE }, Extent::ONE],
            Self::Sum(parts) => parts
                .iter()
                .try_fold(None, |sum: Option<[Extent; 2]>, part| {
                    let [above, below] = go(part)?;
                    Ok(Some(sum.map_or([above, below], |[sum, divisor]| {
                        [sum.times(below).plus(above.times(divisor)), divisor.times(below)]
                    })))
                })?
                .unwrap_or([Extent::ONE; 2]),
            Self::Product(parts) => parts.iter().try_fold([Extent::ONE; 2], |[product, divisor], part| {
                let [above, below] = go(part)?;
                Ok([product.times(above), divisor.times(below)])
            })?,
            Self::Quotient(left, right) => {
                let ([above, below], [upper, lower]) = (go(left)?, go(right)?);
                [above.times(lower), below.times(upper)]
            }
            Self::Negation(inner) => go(inner)?,
            Self::Power(inner, exponent) => {
                let [above, below] = go(inner)?.map(|side| side.power(exponent.unsigned_abs()));
                if *exponent < 0 { [below, above] } else { [above, below] }
            }
            Self::Call(_, inner) | Self::Generic(_, inner) => {
                let [above, below] = go(inner)?;
                let inside = if matches!(self, Self::Call(Function::Abs, _)) { above.terms } else { 1 };
                // Each function is one more level of the chain rule.
                let inner = above.degree.max(below.degree);
                let degree = match self {
                    Self::Generic(..) => inner.saturating_mul(DEGREE_OF_A_POINT).saturating_add(1),
                    _ => inner.saturating_add(1),
                };
                [Extent { terms: inside, degree, bits: above.bits.saturating_add(below.bits) }, Extent::ONE]
            }
        };
        found.into_iter().try_for_each(|side| side.within(largest))?;
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> Option<String> {
        let largest = Extent { terms: 100, degree: 12, bits: 1000 };
        text.parse::<Expression>()
            .expect("in the grammar")
            .check_extent(largest)
            .err()
            .map(|error| error.to_string())
    }

    #[test]
    fn bounds_are_those_of_the_binomial_formula() {
        assert_eq!(error("(a + b)^12"), None);
        assert_eq!(error("1/(a + b + c)^12"), None);
        assert!(error("(a + b + c)^13").is_some_and(|error| error.contains("degree 13")));
        assert!(error("(a + b + c + d)^9").is_some_and(|error| error.contains("220 terms")));
        assert!(error("exp((a + b + c + d)^9)").is_some());
    }

    #[test]
    fn functions_in_arguments_of_functions_multiply_degrees() {
        let extent = |text: &str| {
            let expression = Expression::try_from(text.to_owned()).expect("of a certificate");
            expression.check_extent(Extent { terms: 100, degree: 64, bits: 1000 })
        };
        assert_eq!(extent("f(f(f(x)))*f'(f(x))"), Ok(()));
        assert!(extent("f(f(f(f(x))))").is_err() && extent("f(x^22)").is_err());
    }

    #[test]
    fn a_sum_counts_the_products_with_the_divisors_of_the_other_terms() {
        assert_eq!(error("1/(a + b) + 1/(c + d)"), None);
        let many: Vec<String> = (0..12).map(|n| format!("1/(a{n} + b{n})")).collect();
        assert!(error(&many.join(" + ")).is_some());
    }

    #[test]
    fn a_tower_of_numbers_is_refused_before_it_is_computed() {
        assert_eq!(error("(2^64)^4*a"), None);
        let refused = error("((((2^64)^64)^64)^64)^64").unwrap();
        assert!(refused.ends_with("numbers of 8192 bits (allowed: 1000 bits)"), "{refused}");
        assert!(error("a/(10^64)^64").is_some());
    }

    #[test]
    fn what_cannot_be_counted_is_refused_too() {
        let text = "((((a + b)^64 + c)^64 + d)^64 + e)^64";
        assert!(error(text).is_some());
    }
}
