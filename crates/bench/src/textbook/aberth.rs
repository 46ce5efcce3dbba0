//! Simultaneous iteration of all three roots (Ehrlich 1967, Aberth 1973), as root finders for general polynomials do it.

use num_complex::Complex;

use super::Three;

/// Steps after which the iteration counts as ended: at multiple roots it gains one bit or less a step.
const MOST_STEPS: usize = 200;

/// Newton's correction divided by 1 minus itself times the sum over the other approximations of 1/(z_i − z_j), from a circle of the
/// size of the roots; it ends when no root moves by more than its rounding.
#[must_use]
pub fn aberth([c0, c1, c2, c3]: [f64; 4]) -> Three {
    let [a, b, c] = [c2 / c3, c1 / c3, c0 / c3];
    // Three times the size of the roots' centre, or the largest root by Fujiwara's bound.
    let radius = 2.0 * a.abs().max(b.abs().sqrt()).max(libm::cbrt(c.abs()));
    let turn = |k: f64| {
        let angle = std::f64::consts::TAU * k / 3.0 + 0.7;
        Complex::new(radius * libm::cos(angle), radius * libm::sin(angle))
    };
    let mut roots = [turn(0.0), turn(1.0), turn(2.0)];
    for _ in 0..MOST_STEPS {
        let mut moves = false;
        for i in [0, 1, 2] {
            let z = roots[i];
            let value = ((z + a) * z + b) * z + c;
            let slope = (3.0 * z + 2.0 * a) * z + b;
            let others: Complex<f64> = (0..3).filter(|&j| j != i).map(|j| 1.0 / (z - roots[j])).sum();
            let newton = value / slope;
            let correction = newton / (1.0 - newton * others);
            if !(correction.re.is_finite() && correction.im.is_finite()) {
                continue;
            }
            roots[i] = z - correction;
            moves |= libm::hypot(correction.re, correction.im) > f64::EPSILON * libm::hypot(z.re, z.im);
        }
        if !moves {
            break;
        }
    }
    roots.map(real_when_its_imaginary_part_is_rounding)
}

/// Rounding leaves no root exactly real; the books drop an imaginary part below the rounding of the root.
fn real_when_its_imaginary_part_is_rounding(root: Complex<f64>) -> Complex<f64> {
    if root.im.abs() <= 4.0 * f64::EPSILON * root.re.abs() { Complex::from(root.re) } else { root }
}
