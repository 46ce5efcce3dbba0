//! An approximate root of F with an estimate of its error: 64-bit arithmetic, then double-double arithmetic.

use crate::number::Dd;

/// Newton steps in 64-bit arithmetic; each converges quadratically or halves the bracket.
const MOST_STEPS: u32 = 60;

/// Newton steps in double-double arithmetic: one from a good start, more from a start next to a double root of F.
const MOST_DOUBLE_DOUBLE_STEPS: u32 = 10;

/// The relative error at which double-double arithmetic stops.
const GOOD: f64 = 1.0 / (1u128 << 90) as f64;

/// A relative error of the value of a polynomial in double-double arithmetic, in terms of the sum of its terms' magnitudes.
const ROUNDING: f64 = 16.0 * Dd::UNIT;

/// The same for the slope in 64-bit arithmetic.
const SLOPE_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A root of F, and F next to it. The error is an estimate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    pub(super) root: Dd,
    /// The distance to the root, estimated.
    pub(super) error: f64,
    /// What F is there.
    pub(super) values: Values,
    /// Double-double steps.
    pub(super) steps: u32,
}

/// F in 64-bit arithmetic.
#[derive(Debug, Clone, Copy)]
pub(super) struct Values {
    pub(super) value: f64,
    /// F′.
    pub(super) slope: f64,
    /// F″.
    pub(super) curvature: f64,
    /// Σ|c_k x^k|.
    pub(super) terms: f64,
    /// Σ|k c_k x^(k−1)|.
    pub(super) slope_terms: f64,
}

pub(super) fn values(coefficients: &[f64], x: f64) -> Values {
    let zero = Values { value: 0.0, slope: 0.0, curvature: 0.0, terms: 0.0, slope_terms: 0.0 };
    let size = x.abs();
    let mut all = coefficients.iter().rev().fold(zero, |v, c| Values {
        curvature: v.curvature * x + v.slope,
        slope_terms: v.slope_terms * size + v.terms,
        slope: v.slope * x + v.value,
        terms: v.terms * size + c.abs(),
        value: v.value * x + c,
    });
    all.curvature *= 2.0;
    all
}

/// The root of F between an end at which F is negative and one at which it is positive, in 64-bit arithmetic.
///
/// The signs at the ends are known beforehand; rounding can hide them.
pub(super) fn root_between(
    coefficients: &[f64],
    (mut negative, mut positive): (f64, f64),
    start: f64,
) -> f64 {
    let mut x = start;
    for _ in 0..MOST_STEPS {
        let (value, slope) = coefficients
            .iter()
            .rev()
            .fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value));
        let step = value / slope;
        if step.abs() <= 1e-13 * x.abs() {
            return x - step;
        }
        *(if value < 0.0 { &mut negative } else { &mut positive }) = x;
        let next = x - step;
        let inside = (next - negative) * (next - positive) < 0.0;
        x = if inside { next } else { negative + 0.5 * (positive - negative) };
    }
    x
}

impl Start {
    /// Newton steps in double-double arithmetic until they no longer help; none beyond the range of 64-bit numbers.
    pub(super) fn polished(coefficients: &[Dd], x: f64) -> Option<Self> {
        let leading: Vec<f64> = coefficients.iter().map(Dd::hi).collect();
        let mut root = Dd::from(x);
        let mut best: Option<Self> = None;
        for steps in 1..=MOST_DOUBLE_DOUBLE_STEPS {
            let value = coefficients.iter().rev().fold(Dd::from(0.0), |value, c| value * root + c);
            let at = values(&leading, root.hi());
            let Values { slope, curvature, terms, slope_terms, .. } = at;
            let step = value.hi() / slope;
            let relative = SLOPE_ROUNDING * slope_terms / slope.abs() + (curvature * step / slope).abs();
            let error = step.abs() * relative + ROUNDING * terms / slope.abs();
            root = root - Dd::from(step);
            if !(error.is_finite() && root.is_finite()) {
                return None;
            }
            let gained = best.is_none_or(|before| error < 0.25 * before.error);
            if !gained {
                break;
            }
            best = Some(Self { root, error, values: at, steps });
            if error <= GOOD * root.hi().abs() {
                break;
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_found_from_either_end_and_improved_to_ninety_bits() {
        let polynomial = [-2.0, 0.0, 1.0];
        for start in [0.5, 1.0, 3.0] {
            let root = root_between(&polynomial, (0.0, 4.0), start);
            assert!((root - std::f64::consts::SQRT_2).abs() < 1e-15);
        }
        let start = Start::polished(&polynomial.map(Dd::from), 1.4).unwrap();
        let square = start.root * start.root - Dd::from(2.0);
        assert!(square.hi().abs() < 4.0 * start.error && start.error < 1e-26, "{start:?}");
        assert!(Start::polished(&[0.0; 3].map(Dd::from), 1.0).is_none());
    }
}
