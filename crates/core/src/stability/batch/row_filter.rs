//! The 64-bit filter of one grid row: two polynomials in σ with a proven bound on their rounding error.
//!
//! With k = K·D_c, m = M·V0²/D_c and δ = a − b, eq 8 times aσ has the coefficients k, k + δσ, aσ + m, m. Its discriminant is a
//! quartic in σ, and a·D_c·(K − K_c) = ka + δm + δaσ is linear. A row computes those coefficients once in
//! balls, so that the inner loop is two Horner schemes for values and two for their error bounds.
//!
//! **The bound.** σ is scaled by a power of two to x ≤ 1, the coefficients q_i by another so that the largest lies
//! in [1/2, 1]. Horner's scheme of degree 4 with separate products and sums errs by at most γ₈·Σ|q_i|x^i (γ_n = nu/(1−nu),
//! u = 2^-53), rounding q_i to f64 by u|q_i| and by the radius r_i of its ball. The bound is evaluated in 64-bit itself with
//! e_i = 2^-48·|q_i| + r_i: 32u leaves room for γ₉ and for the bound's own rounding. All intermediate values are
//! at most 5, so nothing overflows; underflow contributes less than 30·2^-1074 and is covered by 2^-1000. The computed bound can
//! lack 10u of the radii's part, but a value larger than it has the sign of the polynomial: `proofs/Rounding.v` proves this.

use rug::Float;

use crate::number::{Ball, Field};

/// Relative part of the error bound.
const RELATIVE_BOUND: f64 = 1.0 / (1u64 << 48) as f64;

/// Absolute part of the error bound, for underflow: 2^-1000.
const ABSOLUTE_BOUND: f64 = f64::from_bits((1023 - 1000) << 52);

/// The discriminant of (k, k + δσ, aσ + m, m), by ascending power of σ.
pub(super) fn boundary_quartic<R: Field>(a: &R, difference: &R, k: &R, m: &R) -> [R; 5] {
    let integer = R::from;
    let (aa, dd, ad) = (a.square(), difference.square(), a.clone() * difference);
    let (kk, mm, km) = (k.square(), m.square(), k.clone() * m);
    let first = integer(20) * a - integer(12) * difference;
    let second = integer(20) * difference - integer(12) * a;
    [
        -(integer(4) * &km * (k.clone() + m).square()),
        (first * k + second * m) * &km,
        aa.clone() * &kk + mm * &dd + (integer(22) * &ad - integer(12) * (aa.clone() + &dd)) * &km,
        (integer(2) * &ad - integer(4) * &aa) * a * k
            + (integer(2) * &ad - integer(4) * &dd) * difference * m,
        ad.square(),
    ]
}

/// a·D_c·(K − K_c) = a²σ·(κ + (1−β)(1+η)) = ka + δm + δaσ, by ascending power of σ.
fn transition_line<R: Field>(a: &R, difference: &R, k: &R, m: &R) -> [R; 2] {
    [k.clone() * a + difference.clone() * m, difference.clone() * a]
}

/// A polynomial in 64-bit with the polynomial that bounds its error.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundedPolynomial<const N: usize> {
    value: [f64; N],
    bound: [f64; N],
}

impl<const N: usize> BoundedPolynomial<N> {
    /// The coefficients for x = σ/2^e, scaled by one power of two to a maximum in [1/2, 1], with those of the bound.
    pub(super) fn scaled(coefficients: &[Ball; N], stress_exponent: i32) -> Self {
        let at_unit_stress =
            |power: usize, exponent: i32| i64::from(exponent) + power as i64 * i64::from(stress_exponent);
        let exponents = coefficients.iter().enumerate();
        let largest = exponents
            .filter_map(|(i, c)| c.centre().get_exp().map(|exponent| at_unit_stress(i, exponent)))
            .max();
        let scale = |power: usize, value: &Float| {
            let (mantissa, exponent) = value.to_f64_exp();
            let shift = at_unit_stress(power, exponent) - largest.unwrap_or(0);
            libm::ldexp(mantissa, shift.clamp(-5000, 5000) as i32)
        };
        let value: [f64; N] = std::array::from_fn(|power| scale(power, coefficients[power].centre()));
        // A radius of 32 bits is exact in f64 unless it underflows, which the absolute part covers.
        let mut bound: [f64; N] = std::array::from_fn(|power| {
            RELATIVE_BOUND * value[power].abs() + scale(power, &coefficients[power].radius())
        });
        bound[0] += ABSOLUTE_BOUND;
        Self { value, bound }
    }

    /// Value and bound at x ≥ 0 by Horner's scheme.
    #[inline(always)]
    pub(super) fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut bound) = (self.value[N - 1], self.bound[N - 1]);
        for power in (0..N - 1).rev() {
            value = value * x + self.value[power];
            bound = bound * x + self.bound[power];
        }
        (value, bound)
    }
}

/// The two polynomials of a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct RowFilter {
    pub(super) boundary: BoundedPolynomial<5>,
    pub(super) transition: BoundedPolynomial<2>,
}

impl RowFilter {
    /// The filter for a, δ, k and m as balls, and σ scaled by 2^-`stress_exponent`.
    pub(super) fn new(a: &Ball, difference: &Ball, k: &Ball, m: &Ball, stress_exponent: i32) -> Self {
        Self {
            boundary: BoundedPolynomial::scaled(&boundary_quartic(a, difference, k, m), stress_exponent),
            transition: BoundedPolynomial::scaled(&transition_line(a, difference, k, m), stress_exponent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Rational;
    use crate::roots::discriminant;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_quartic_in_normal_stress_is_the_discriminant(
            values in prop::array::uniform5(1i64..1000),
        ) {
            let [a, b, k, m, s] = values.map(Rational::from);
            let difference = a.clone() - b;
            let cubic = [k.clone(), k.clone() + difference.clone() * &s, a.clone() * &s + &m, m.clone()];
            let quartic = boundary_quartic(&a, &difference, &k, &m);
            let value = quartic.into_iter().rev().fold(Rational::new(), |sum, q| sum * &s + q);
            prop_assert_eq!(value, discriminant(&cubic));
        }
    }
}
