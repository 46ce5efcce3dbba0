//! Numbers that are known to lie between two bounds.

use std::fmt;

use crate::number::Ball;
use crate::number::format::certain_digits;

/// A number that certainly lies in an interval, such as a root or a point of the boundary.
#[derive(Debug, Clone)]
pub struct Enclosed {
    ball: Ball,
    digits: usize,
}

impl Enclosed {
    pub(super) fn new(ball: Ball, digits: u32) -> Self {
        Self { ball, digits: digits as usize }
    }

    /// The middle of the interval, rounded to 64 bits.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.ball.to_f64()
    }

    /// Whether the number is exactly zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.ball.is_exact() && self.ball.centre().is_zero()
    }

    /// The digits that are certain, at most so many as were requested.
    #[must_use]
    pub fn digits(&self) -> String {
        certain_digits(&self.ball, self.digits)
    }
}

/// The certain digits.
impl fmt::Display for Enclosed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&self.digits())
    }
}
