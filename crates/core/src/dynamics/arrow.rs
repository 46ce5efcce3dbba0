//! The Jacobian of the slider, an arrowhead matrix, and the solution of (λ − hJ) d = r without any search for pivots.
//!
//! The velocity couples to both other variables, they never couple to each other; so two eliminations and one division solve
//! the system. The eliminated diagonals λ − hJ_yy and λ have no smaller modulus than Re λ > 0, because J_yy ≤ 0 for
//! both laws: nothing cancels there. Only the last pivot can be small, and it is exactly when the step is.

use std::ops::{Add, Mul, Neg, Sub};

use super::Scalar;
use crate::number::{Complex, fields};

fields! {
    /// The non-zero entries of the Jacobian in the order (x, y, ζ).
    #[derive(Debug, Clone)]
    pub struct Arrow<R>[6] {
        /// ∂x'/∂x.
        pub xx,
        /// ∂x'/∂y.
        pub xy,
        /// ∂x'/∂ζ.
        pub xz,
        /// ∂y'/∂x.
        pub yx,
        /// ∂y'/∂y.
        pub yy,
        /// ∂ζ'/∂x.
        pub zx,
    }
}

/// What the elimination asks of its numbers: a field, with the real scalars acting on it.
pub trait OverReals<R>:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// A real number as one of these.
    fn from_real(value: &R) -> Self;
    /// One over the number.
    fn inverse(&self) -> Self;
    /// The product with a real number.
    fn times_real(&self, factor: &R) -> Self;
}

impl<R: Scalar> OverReals<R> for R {
    #[inline(always)]
    fn from_real(value: &R) -> Self {
        value.clone()
    }
    #[inline(always)]
    fn inverse(&self) -> Self {
        R::from(1) / self
    }
    #[inline(always)]
    fn times_real(&self, factor: &R) -> Self {
        self.clone() * factor
    }
}

impl<R: Scalar> OverReals<R> for Complex<R> {
    #[inline(always)]
    fn from_real(value: &R) -> Self {
        Self::real(value.clone())
    }
    /// Scaled by the larger part: no overflow while operand and result are in range, and no branch to mispredict.
    #[inline(always)]
    fn inverse(&self) -> Self {
        let (re_size, im_size) = (self.re.abs(), self.im.abs());
        let scale = R::from(1) / if re_size < im_size { im_size } else { re_size };
        let Self { re, im } = Self::times_real(self, &scale);
        let factor = scale / (re.square() + im.square());
        Self { re: re * &factor, im: -(im * &factor) }
    }
    #[inline(always)]
    fn times_real(&self, factor: &R) -> Self {
        Self::times_real(self, factor)
    }
}

/// The factorised matrix λ − hJ for one λ, real or complex.
#[derive(Debug, Clone)]
pub struct Factors<C> {
    inverse_y: C,
    inverse_zeta: C,
    inverse_pivot: C,
}

impl<R: Scalar> Factors<Complex<R>> {
    /// The place of factors that are not needed.
    #[inline(always)]
    pub(crate) fn blank() -> Self {
        let zero = Complex::from_real(&R::from(0));
        Self { inverse_y: zero.clone(), inverse_zeta: zero.clone(), inverse_pivot: zero }
    }
}

impl<C> Factors<C> {
    /// Eliminates y and ζ from λ − J, where `jacobian` already carries the step's factor.
    #[must_use]
    #[inline(always)]
    pub fn new<R: Scalar>(lambda: &C, jacobian: &Arrow<R>) -> Self
    where
        C: OverReals<R>,
    {
        let inverse_y = (lambda.clone() - C::from_real(&jacobian.yy)).inverse();
        let inverse_zeta = lambda.inverse();
        let through_y = inverse_y.times_real(&(jacobian.xy.clone() * &jacobian.yx));
        let through_zeta = inverse_zeta.times_real(&(jacobian.xz.clone() * &jacobian.zx));
        let pivot = lambda.clone() - C::from_real(&jacobian.xx) - through_y - through_zeta;
        Self { inverse_y, inverse_zeta, inverse_pivot: pivot.inverse() }
    }

    /// Solves (λ − J) d = r.
    #[must_use]
    #[inline(always)]
    pub fn solve<R: Scalar>(&self, jacobian: &Arrow<R>, [x, y, zeta]: [C; 3]) -> [C; 3]
    where
        C: OverReals<R>,
    {
        let y = y * self.inverse_y.clone();
        let zeta = zeta * self.inverse_zeta.clone();
        let right = x + y.times_real(&jacobian.xy) + zeta.times_real(&jacobian.xz);
        let x = right * self.inverse_pivot.clone();
        let y = y + x.times_real(&jacobian.yx) * self.inverse_y.clone();
        let zeta = zeta + x.times_real(&jacobian.zx) * self.inverse_zeta.clone();
        [x, y, zeta]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn arrow(e: [f64; 6]) -> Arrow<f64> {
        Arrow { xx: e[0], xy: e[1], xz: e[2], yx: e[3], yy: -e[4].abs(), zx: e[5] }
    }

    impl Arrow<f64> {
        /// The product with a column.
        pub(crate) fn times(&self, v: &[f64; 3]) -> [f64; 3] {
            let Self { xx, xy, xz, yx, yy, zx } = *self;
            [xx * v[0] + xy * v[1] + xz * v[2], yx * v[0] + yy * v[1], zx * v[0]]
        }
    }

    proptest! {
        #[test]
        fn the_solution_satisfies_the_system(
            e in prop::array::uniform6(-2.0f64..2.0), r in prop::array::uniform3(-1.0f64..1.0), re in 10.0f64..20.0, im in -9.0f64..9.0
        ) {
            let jacobian = arrow(e);
            let lambda = Complex { re, im };
            let right = r.map(|re| Complex { re, im: 0.25 });
            let d = Factors::new(&lambda, &jacobian).solve(&jacobian, right);
            let product_re = jacobian.times(&[d[0].re, d[1].re, d[2].re]);
            let product_im = jacobian.times(&[d[0].im, d[1].im, d[2].im]);
            for i in 0..3 {
                let left = lambda * d[i] - Complex { re: product_re[i], im: product_im[i] };
                prop_assert!((left.re - right[i].re).abs() < 1e-13 && (left.im - right[i].im).abs() < 1e-13);
            }
        }
    }
}
