//! Textbook root finders in 64-bit, as comparators: what eq 8 gets from them where it is hard, right or wrong.
//!
//! None of them is used for an answer. Each is written as the books have it, without a repair for its known weaknesses.

mod aberth;
mod cardano;
mod companion;
mod newton;
mod viete;

pub use aberth::aberth;
pub use cardano::cardano;
pub use companion::companion;
pub use newton::newton;
pub use viete::viete;

use num_complex::Complex;

/// Three roots in no particular order; parts that are not finite are failures of the method.
pub type Three = [Complex<f64>; 3];

/// x³ + px + q after x = z − c2/(3c3), and that shift c2/(3c3).
pub(super) struct Reduced {
    p: f64,
    q: f64,
    shift: f64,
}

impl Reduced {
    /// Divides by c3 and removes the square.
    fn of([c0, c1, c2, c3]: [f64; 4]) -> Self {
        let (a, b, c) = (c2 / c3, c1 / c3, c0 / c3);
        Self { p: b - a * a / 3.0, q: 2.0 * a * a * a / 27.0 - a * b / 3.0 + c, shift: a / 3.0 }
    }
}

/// The roots of x² + bx + c by the formula of the books.
pub(super) fn quadratic(b: f64, c: f64) -> [Complex<f64>; 2] {
    let discriminant = b * b - 4.0 * c;
    if discriminant < 0.0 {
        let im = 0.5 * (-discriminant).sqrt();
        return [Complex::new(-0.5 * b, im), Complex::new(-0.5 * b, -im)];
    }
    let half = 0.5 * discriminant.sqrt();
    [Complex::from(-0.5 * b + half), Complex::from(-0.5 * b - half)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const METHODS: [fn([f64; 4]) -> Three; 5] = [cardano, viete, companion, newton, aberth];

    /// Checks that each expected root is met by a found one.
    fn assert_roots(cubic: [f64; 4], expected: [Complex<f64>; 3], tolerance: f64) {
        for method in METHODS {
            let found = method(cubic);
            for root in expected {
                let nearest =
                    found.iter().map(|z| (z.re - root.re).abs() + (z.im - root.im).abs()).fold(9e9, f64::min);
                assert!(nearest < tolerance, "{cubic:?}: {found:?}");
            }
        }
    }

    #[test]
    fn all_of_them_find_three_real_roots() {
        assert_roots([-6.0, 11.0, -6.0, 1.0], [1.0, 2.0, 3.0].map(Complex::from), 1e-13);
        assert_roots([3.0, -10.75, -5.5, 2.0], [-1.5, 0.25, 4.0].map(Complex::from), 1e-13);
    }

    #[test]
    fn all_of_them_find_a_pair() {
        let pair = |re, im| Complex::new(re, im);
        // (x + 2)(x² + 2x + 5), and (x − 3)(x² + 1) times −2, where p > 0.
        assert_roots([10.0, 9.0, 4.0, 1.0], [pair(-2.0, 0.0), pair(-1.0, 2.0), pair(-1.0, -2.0)], 1e-13);
        assert_roots([6.0, -2.0, 6.0, -2.0], [pair(3.0, 0.0), pair(0.0, 1.0), pair(0.0, -1.0)], 1e-13);
    }

    #[test]
    fn none_of_them_survives_coefficients_that_overflow_when_divided() {
        for method in METHODS {
            let found = method([1.0, 1.0, 1.0, 1e-320]);
            assert!(found.iter().any(|z| !z.re.is_finite() || !z.im.is_finite()), "{found:?}");
        }
    }
}
