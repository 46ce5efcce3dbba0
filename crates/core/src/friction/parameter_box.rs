//! All values within error bars.

use super::{Parameters, Quantity};
use crate::number::Rational;

/// All parameters between two exact ends, ends included.
///
/// ```
/// use slipmode_core::friction::ParameterBox;
/// use slipmode_core::{friction::Parameters, number::parse_decimal};
///
/// let point = |b: &str| {
///     Parameters::from(["0.004", b, "1e-5", "1e7", "1000", "1e6", "1e-5"].map(|text| parse_decimal(text).unwrap()))
/// };
/// assert!(ParameterBox::new(point("0.005"), point("0.007")).is_some());
/// assert!(ParameterBox::new(point("0.007"), point("0.005")).is_none());
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParameterBox {
    /// a, b, D_c, K, M, σ, V0.
    pub(crate) lower: [Rational; 7],
    pub(crate) upper: [Rational; 7],
}

impl ParameterBox {
    /// The box between two ends, or `None` unless 0 < lower ≤ upper for each parameter.
    #[must_use]
    pub fn new(lower: Parameters<Rational>, upper: Parameters<Rational>) -> Option<Self> {
        let (lower, upper): ([Rational; 7], [Rational; 7]) = (lower.into(), upper.into());
        let ordered = lower.iter().zip(&upper).all(|(low, high)| *low > 0 && low <= high);
        ordered.then_some(Self { lower, upper })
    }

    /// The box of one point, or `None` unless each parameter is positive.
    #[must_use]
    pub fn of(point: Parameters<Rational>) -> Option<Self> {
        Self::new(point.clone(), point)
    }

    /// The box with other ends of a quantity; `None` unless 0 < lower ≤ upper.
    #[must_use]
    pub fn with_ends(mut self, quantity: Quantity, [lower, upper]: [Rational; 2]) -> Option<Self> {
        let is_valid = lower > 0 && lower <= upper;
        (self.lower[quantity as usize], self.upper[quantity as usize]) = (lower, upper);
        is_valid.then_some(self)
    }

    /// The middle of each parameter.
    #[must_use]
    pub fn middle(&self) -> Parameters<Rational> {
        let middle = |i: usize| Rational::from(&self.lower[i] + &self.upper[i]) / 2;
        std::array::from_fn::<_, 7, _>(middle).into()
    }

    /// The least value of each parameter.
    #[must_use]
    pub fn lower(&self) -> Parameters<Rational> {
        self.lower.clone().into()
    }

    /// The greatest value of each parameter.
    #[must_use]
    pub fn upper(&self) -> Parameters<Rational> {
        self.upper.clone().into()
    }

    /// Whether a point lies in the box.
    #[must_use]
    pub fn contains(&self, parameters: &Parameters<Rational>) -> bool {
        let point: [Rational; 7] = parameters.clone().into();
        (0..7).all(|i| self.lower[i] <= point[i] && point[i] <= self.upper[i])
    }
}
