//! The depressed form y³ + Py + Q of a rational cubic, in exact integers.
//!
//! With y = 3c3·x + c2 the coefficients are P = 3(3c3c1 − c2²) and Q = 2c2³ − 9c3c2c1 + 27c3²c0. Its outermost real root
//! is always well-conditioned in P and Q, also where roots of the cubic coincide (f'(y) ≥ 2y² when P < 0; when P > 0
//! all terms of f' are positive), and P, Q and the discriminant are computed exactly. So nothing is lost
//! next to a double or triple root; what is lost is the shift by c2, and that is known in advance.

use std::cell::OnceCell;

use rug::{Complete, Integer, Rational};

/// An integer cubic lead·x³ + quadratic·x² + … and its depressed form.
#[derive(Debug, Clone)]
pub(crate) struct Depressed {
    /// The integer coefficients by ascending power, the last positive.
    pub(crate) cubic: [Integer; 4],
    /// P.
    pub(crate) linear: Integer,
    /// Q.
    pub(crate) constant: Integer,
    discriminant: OnceCell<Integer>,
}

/// How far from 1 the ratio of 4|P|³ and 27Q² is seen to be in 64-bit: some ten roundings are far below.
const CLEARLY: f64 = 1e-12;

impl Depressed {
    /// The depressed form, or `None` when the leading coefficient is zero.
    pub(crate) fn of(cubic: &[Rational; 4]) -> Option<Self> {
        if cubic[3].is_zero() {
            return None;
        }
        Self::of_integers(integer_coefficients(cubic))
    }

    /// The same of integer coefficients by ascending power; `None` unless the last is positive.
    pub(crate) fn of_integers(cubic: [Integer; 4]) -> Option<Self> {
        let [c0, c1, c2, c3] = &cubic;
        if *c3 <= 0 {
            return None;
        }
        let outer = (c3 * c1).complete();
        let square = c2.square_ref().complete();
        let third = &outer * 3u32 - square.clone();
        let constant = (square * 2u32 - outer * 9u32) * c2 + c3.square_ref().complete() * c0 * 27u32;
        Some(Self { linear: third * 3u32, constant, discriminant: OnceCell::new(), cubic })
    }

    /// c3.
    pub(crate) const fn lead(&self) -> &Integer {
        &self.cubic[3]
    }

    /// c2.
    pub(crate) const fn quadratic(&self) -> &Integer {
        &self.cubic[2]
    }

    /// −(4P³ + 27Q²) = Π(yᵢ − yⱼ)² = 729·c3²·Δ.
    pub(crate) fn discriminant(&self) -> &Integer {
        self.discriminant.get_or_init(|| {
            // P/3 keeps the numbers short: 4P³ + 27Q² = 27(4(P/3)³ + Q²).
            let third = self.linear.div_exact_u_ref(3).complete();
            (third.square_ref().complete() * &third * 4u32 + self.constant.square_ref().complete()) * -27
        })
    }

    /// The sign of the cubic's discriminant.
    pub(crate) fn discriminant_sign(&self) -> i8 {
        if self.linear >= 0 {
            return if self.linear.is_zero() && self.constant.is_zero() { 0 } else { -1 };
        }
        let [(linear, of_linear), (constant, of_constant)] =
            [&self.linear, &self.constant].map(|value| value.to_f64_exp());
        let power = 3 * i64::from(of_linear) - 2 * i64::from(of_constant);
        // Two numbers of half to one, and a power of two beyond which the ratio is clear as well.
        let power = libm::exp2(power.clamp(-100, 100) as f64);
        let ratio = 4.0 * linear.abs() * linear * linear * power / (27.0 * constant * constant);
        if ratio > 1.0 + CLEARLY {
            1
        } else if ratio < 1.0 - CLEARLY {
            -1
        } else {
            self.discriminant().cmp0() as i8
        }
    }

    /// c1c2 − c0c3 = −c3²·Π(rᵢ + rⱼ): zero when two roots sum to zero. For eq 8 it has the sign of K − K_c (Routh-Hurwitz).
    pub(crate) fn hurwitz(&self) -> Integer {
        let [c0, c1, c2, c3] = &self.cubic;
        (c1 * c2).complete() - (c0 * c3).complete()
    }

    /// The smallest k with |P| ≤ 2^2k and |Q| ≤ 2^3k: every root y is at most 2^(k+1) in modulus.
    pub(crate) fn scale_log2(&self) -> i32 {
        bits(&self.linear).div_ceil(2).max(bits(&self.constant).div_ceil(3)) as i32
    }
}

/// Bits of |value|: 2^(bits−1) ≤ |value| < 2^bits, zero for zero.
pub(crate) fn bits(value: &Integer) -> u32 {
    value.significant_bits()
}

/// The cubic times the common denominator, and times −1 if that makes the leading coefficient positive.
pub(super) fn integer_coefficients(cubic: &[Rational; 4]) -> [Integer; 4] {
    let mut common = cubic[0].denom().clone();
    for coefficient in &cubic[1..] {
        common.lcm_mut(coefficient.denom());
    }
    if common == 1 && cubic[3] > 0 {
        return cubic.each_ref().map(|coefficient| coefficient.numer().clone());
    }
    if cubic[3] < 0 {
        common = -common;
    }
    cubic.each_ref().map(|coefficient| {
        let factor = common.div_exact_ref(coefficient.denom()).complete();
        factor * coefficient.numer()
    })
}
