//! The clock of a run: a sum whose terms may differ by sixty orders of magnitude.

use super::Scalar;

/// A sum that carries its rounding error along.
#[derive(Debug, Clone)]
pub(super) struct Clock<R> {
    sum: R,
    carry: R,
}

impl<R: Scalar> Clock<R> {
    pub fn zero() -> Self {
        Self { sum: R::from(0), carry: R::from(0) }
    }

    pub fn advance(&mut self, step: &R) {
        // Fast two-sum of the larger and the smaller term.
        let (large, small) = if self.sum < *step { (step, &self.sum) } else { (&self.sum, step) };
        let sum = large.clone() + small;
        self.carry = self.carry.clone() + (small.clone() - (sum.clone() - large));
        self.sum = sum;
    }

    /// The time since the clock was set to zero.
    pub(crate) fn elapsed(&self) -> R {
        self.sum.clone() + &self.carry
    }
}
