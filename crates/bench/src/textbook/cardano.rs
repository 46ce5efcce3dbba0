//! Cardano's formula with complex square and cube roots (*Ars magna*, 1545, as every handbook has it).

use num_complex::Complex;

use super::{Reduced, Three};

/// √3/2.
const HALF_ROOT_OF_THREE: f64 = 0.866_025_403_784_438_6;

/// u + v with u³ = −q/2 + √((q/2)² + (p/3)³) and uv = −p/3, then with u turned by a third of a circle either way.
#[must_use]
pub fn cardano(cubic: [f64; 4]) -> Three {
    let Reduced { p, q, shift } = Reduced::of(cubic);
    let (half, third) = (0.5 * q, p / 3.0);
    let inside = half * half + third * third * third;
    if inside >= 0.0 {
        // Real cube roots: one real root and a pair, or a double root.
        let root = inside.sqrt();
        let (u, v) = (libm::cbrt(-half + root), libm::cbrt(-half - root));
        let (re, im) = (-0.5 * (u + v) - shift, HALF_ROOT_OF_THREE * (u - v));
        return [Complex::from(u + v - shift), Complex::new(re, im), Complex::new(re, -im)];
    }
    // u³ is complex although all roots are real; v is its conjugate, so that sums are real.
    let (re, im) = (-half, (-inside).sqrt());
    let modulus = libm::cbrt(libm::hypot(re, im));
    let angle = libm::atan2(im, re) / 3.0;
    let (u_re, u_im) = (modulus * libm::cos(angle), modulus * libm::sin(angle));
    let turned = HALF_ROOT_OF_THREE * 2.0 * u_im;
    [2.0 * u_re - shift, -u_re - turned - shift, -u_re + turned - shift].map(Complex::from)
}
