//! Newton's iteration from outside all roots, division by the root found, and the quadratic formula.

use num_complex::Complex;

use super::{Three, quadratic};

/// More steps than an iteration from Cauchy's bound needs: it gains at least a factor of 3/2 each, then doubles digits.
const MOST_STEPS: usize = 4000;

/// One real root by Newton from Cauchy's bound on the side of the real line where one must be, the others by deflation.
#[must_use]
pub fn newton([c0, c1, c2, c3]: [f64; 4]) -> Three {
    let [a, b, c] = [c2 / c3, c1 / c3, c0 / c3];
    let bound = 1.0 + a.abs().max(b.abs()).max(c.abs());
    // The inflection's height tells on which side of it the cubic has a real root for certain.
    let inflection = -a / 3.0;
    let height = ((inflection + a) * inflection + b) * inflection + c;
    let mut x = if height > 0.0 { -bound } else { bound };
    for _ in 0..MOST_STEPS {
        let value = ((x + a) * x + b) * x + c;
        let slope = (3.0 * x + 2.0 * a) * x + b;
        let next = x - value / slope;
        // Monotone until rounding turns it round.
        if !(next.is_finite() && (height > 0.0 && next > x || height <= 0.0 && next < x)) {
            break;
        }
        x = next;
    }
    let linear = a + x;
    let pair = quadratic(linear, b + linear * x);
    [Complex::from(x), pair[0], pair[1]]
}
