//! Viète's trigonometric formula, with its hyperbolic forms where one root only is real.

use num_complex::Complex;

use super::{Reduced, Three, quadratic};

/// 2√(−p/3)·cos(φ/3 + 2πk/3) with cos φ = (3q/2p)·√(−3/p); the pair of the hyperbolic forms by division.
#[must_use]
pub fn viete(cubic: [f64; 4]) -> Three {
    let Reduced { p, q, shift } = Reduced::of(cubic);
    let discriminant = -(4.0 * p * p * p + 27.0 * q * q);
    if discriminant >= 0.0 && p < 0.0 {
        let radius = 2.0 * (-p / 3.0).sqrt();
        let cosine = (3.0 * q / (p * radius)).clamp(-1.0, 1.0);
        let angle = libm::acos(cosine) / 3.0;
        let third_turn = std::f64::consts::TAU / 3.0;
        return [0.0, 1.0, 2.0].map(|k| Complex::from(radius * libm::cos(angle - k * third_turn) - shift));
    }
    let real = one_real_root(p, q);
    // x³ + px + q = (x − t)(x² + tx + t² + p).
    let pair = quadratic(real, real * real + p);
    [Complex::from(real - shift), pair[0] - shift, pair[1] - shift]
}

/// The only real root of x³ + px + q.
fn one_real_root(p: f64, q: f64) -> f64 {
    if p == 0.0 {
        return libm::cbrt(-q);
    }
    let radius = (p.abs() / 3.0).sqrt();
    let ratio = 1.5 * q / (p * radius);
    if p > 0.0 {
        return -2.0 * radius * libm::sinh(libm::asinh(ratio) / 3.0);
    }
    -2.0 * q.signum() * radius * libm::cosh(libm::acosh(ratio.abs().max(1.0)) / 3.0)
}
