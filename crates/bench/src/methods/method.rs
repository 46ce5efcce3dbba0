//! The ways to the roots of eq 8 that are compared, and the signs that are read off the roots of a textbook method.

use crate::textbook::{Three, aberth, cardano, companion, newton, viete};

/// A way to the roots of eq 8.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Cardano's formula.
    Cardano,
    /// Viète's trigonometric formula.
    Viete,
    /// Eigenvalues of the companion matrix.
    Companion,
    /// Newton's iteration with deflation.
    Newton,
    /// Aberth's simultaneous iteration.
    Aberth,
    /// Our 64-bit roots with their error bounds.
    Ours64,
    /// Our double-double roots with their error bounds.
    DoubleDouble,
    /// Our certified roots.
    Certified,
}

impl Method {
    /// All of them, the textbook first.
    pub const ALL: [Self; 8] = [
        Self::Cardano,
        Self::Viete,
        Self::Companion,
        Self::Newton,
        Self::Aberth,
        Self::Ours64,
        Self::DoubleDouble,
        Self::Certified,
    ];

    /// The name in tables.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Cardano => "Cardano",
            Self::Viete => "trigonometric",
            Self::Companion => "companion eigenvalues",
            Self::Newton => "Newton and deflation",
            Self::Aberth => "Aberth",
            Self::Ours64 => "64-bit with bounds",
            Self::DoubleDouble => "double-double with bounds",
            Self::Certified => "certified",
        }
    }
}

/// The name in tables, and the solver of a 64-bit cubic.
pub type Textbook = (&'static str, fn([f64; 4]) -> Three);

/// Every textbook method.
pub const TEXTBOOK: [Textbook; 5] = [
    (Method::Cardano.as_str(), cardano),
    (Method::Viete.as_str(), viete),
    (Method::Companion.as_str(), companion),
    (Method::Newton.as_str(), newton),
    (Method::Aberth.as_str(), aberth),
];

/// The signs of K − K_c and of the discriminant, read off the roots as they come; none when one of them is not finite.
pub fn signs_of(roots: &Three) -> Option<(i8, i8)> {
    if roots.iter().any(|root| !root.re.is_finite() || !root.im.is_finite()) {
        return None;
    }
    let real = roots.iter().map(|root| root.re).fold(f64::NEG_INFINITY, f64::max);
    let is_complex = roots.iter().any(|root| root.im > 0.0);
    let [first, second, third] = roots;
    let coincide = first == second || second == third || third == first;
    let boundary = if is_complex { -1 } else { i8::from(!coincide) };
    Some((i8::from(real < 0.0) - i8::from(real > 0.0), boundary))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;

    #[test]
    fn signs_are_those_of_the_largest_real_part_and_of_the_kind_of_the_roots() {
        let real = |roots: [f64; 3]| roots.map(Complex::from);
        let pair = [Complex::from(-1.0), Complex::new(0.5, 2.0), Complex::new(0.5, -2.0)];
        assert_eq!(signs_of(&real([-1.0, -2.0, -3.0])), Some((1, 1)));
        assert_eq!(signs_of(&real([-1.0, 2.0, 2.0])), Some((-1, 0)));
        assert_eq!(signs_of(&pair), Some((-1, -1)));
        assert_eq!(signs_of(&real([0.0, -1.0, f64::NAN])), None);
    }
}
