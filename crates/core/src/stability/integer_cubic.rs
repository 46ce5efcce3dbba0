//! Eq 8 of a point of 64-bit numbers in exact integers, without a quotient: for the points that double-double leaves open.
//!
//! Times aσD_c the groups are MV0², KD_c² and bσD_c. Of binary fractions these are integers times one power of two, so that neither a
//! common denominator nor a greatest common divisor is looked for. P and Q of the depressed cubic are then exact, and next to a triple
//! root, where their terms cancel, the roots lose nothing.

use rug::Integer;

use super::certain_signs::{BoundedGroups, InputError};
use super::point_values::{FIELDS, PointValues};
use crate::friction::{Parameters, cubic_of_terms};
use crate::number::dispatch::{Kernel, run_on_widest_unit};
use crate::number::{Dd, Field};
use crate::roots::{Bounded, Depressed};

/// Bound on the relative error of P and Q as double-doubles: each leading part loses a unit at most, and the divisor takes three operations.
const ERROR: f64 = 8.0 * Dd::UNIT;

/// P and Q below this, or above its reciprocal, are left to certified enclosures: no product of three over- or underflows inside.
const SMALLEST: f64 = 1e-90;

/// Eq 8 of a point in integers.
#[derive(Debug)]
pub(super) struct IntegerCubic {
    depressed: Depressed,
    /// aσD_c in the same unit.
    direct: Integer,
}

impl IntegerCubic {
    /// The cubic of seven positive finite numbers.
    pub(super) fn of(point: &Parameters<f64>) -> Option<Self> {
        let [a, b, length, stiffness, mass, stress, velocity] = <[f64; 7]>::from(point.clone());
        let products = [
            [stiffness, length, length],
            [a, stress, length],
            [b, stress, length],
            [mass, velocity, velocity],
        ];
        let products = products.map(product);
        let unit = products.iter().map(|(_, exponent)| *exponent).min()?;
        let terms = products.map(|(integer, exponent)| integer << exponent.abs_diff(unit));
        let depressed = Depressed::of_integers(cubic_of_terms(terms.each_ref()))?;
        let [_, direct, ..] = terms;
        Some(Self { depressed, direct })
    }

    /// The signs of K − K_c and of the discriminant.
    pub(super) fn signs(&self) -> [i8; 2] {
        [self.depressed.hurwitz().cmp0() as i8, self.depressed.discriminant_sign()]
    }

    /// What double-double then says of the point.
    pub(super) fn values(&self, point: &Parameters<Dd>) -> PointValues<f64> {
        let Depressed { linear, constant, .. } = &self.depressed;
        let [linear, constant, direct] = [linear, constant, &self.direct].map(leading);
        // Beyond ±1000 the quotient lies far outside the range in any case, as no leading part exceeds 2^126.
        let over_direct = |exponent: i32, power: i32| (exponent - power * direct.1).clamp(-1000, 1000);
        let mut values = PointValues::from([0.0; FIELDS]);
        run_on_widest_unit(OfDepressed {
            point,
            linear: (linear.0, over_direct(linear.1, 2)),
            constant: (constant.0, over_direct(constant.1, 3)),
            direct: direct.0,
            values: &mut values,
        });
        values
    }
}

/// P and Q times powers of two, over powers of aσD_c.
struct OfDepressed<'a> {
    point: &'a Parameters<Dd>,
    linear: (Dd, i32),
    constant: (Dd, i32),
    direct: Dd,
    values: &'a mut PointValues<f64>,
}

impl Kernel for OfDepressed<'_> {
    #[inline(always)]
    fn run(self) {
        let (groups, is_usable) = BoundedGroups::with_range(self.point, InputError::None);
        let square = self.direct.square();
        let linear = self.linear.0 / square;
        let constant = self.constant.0 / (square * self.direct);
        let [linear, constant] =
            [(linear, self.linear.1), (constant, self.constant.1)].map(|(value, exponent)| {
                let value = value.scale(libm::exp2(f64::from(exponent)));
                Bounded { value, error: ERROR * value.hi().abs() }
            });
        let in_range = |bounded: &Bounded<Dd>| {
            bounded.error == 0.0 || (SMALLEST..1.0 / SMALLEST).contains(&bounded.value.hi().abs())
        };
        let roots = groups.cubic().roots_of_depressed(&linear, &constant);
        let is_usable = is_usable & in_range(&linear) & in_range(&constant);
        *self.values = PointValues::of_roots(&roots, self.point.rate_per_s(), is_usable);
    }
}

/// The product of three positive numbers as an integer and a power of two.
fn product(factors: [f64; 3]) -> (Integer, i32) {
    let [first, second, third] = factors.map(|factor| {
        let (fraction, exponent) = libm::frexp(factor);
        ((fraction * (1u64 << f64::MANTISSA_DIGITS) as f64) as u64, exponent - f64::MANTISSA_DIGITS as i32)
    });
    let integer = Integer::from(u128::from(first.0) * u128::from(second.0)) * third.0;
    (integer, first.1 + second.1 + third.1)
}

/// An integer as a double-double times a power of two, to a relative [`Dd::UNIT`].
fn leading(value: &Integer) -> (Dd, i32) {
    let excess = value.significant_bits().saturating_sub(126);
    let top = Integer::from(value >> excess).to_i128_wrapping();
    let high = top as f64;
    (Dd::exact_sum(high, (top - high as i128) as f64), excess as i32)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::number::Rational;
    use crate::stability::fixtures::{double_root_and_effect_ratio, inertial_parameter, stiffness_group};
    use crate::stability::{boundary_sign, transition_sign};

    fn assert_exact_signs(inputs: [f64; 7]) -> [i8; 2] {
        let point = Parameters::from(inputs);
        let groups = point.map(|value| Rational::from_f64(*value).unwrap()).groups();
        let found = IntegerCubic::of(&point).unwrap().signs();
        assert_eq!(found, [transition_sign(&groups), boundary_sign(&groups)], "{inputs:?}");
        found
    }

    proptest! {
        #[test]
        fn the_signs_are_those_over_the_rationals(
            exponents in prop::array::uniform7(-300f64..300.0), near in prop::array::uniform7(-3f64..3.0),
        ) {
            assert_exact_signs(exponents.map(libm::exp10));
            assert_exact_signs(near.map(libm::exp10));
        }

        #[test]
        fn also_next_to_a_double_root((r, beta) in double_root_and_effect_ratio(), last in -2i64..3) {
            let groups = [beta.clone(), stiffness_group(&r, &beta), inertial_parameter(&r, &beta)];
            let [beta, kappa, eta] = groups.map(|group| group.to_f64());
            prop_assume!([beta, kappa, eta].iter().all(|group| group.is_normal()));
            let beside = f64::from_bits(kappa.to_bits().wrapping_add_signed(last));
            assert_exact_signs([1.0, beta, 1.0, beside, eta, 1.0, 1.0]);
        }
    }

    #[test]
    fn limits_are_met_exactly_and_subnormal_inputs_are_numbers() {
        // The cusp at b = a, here in units of 2^-40; K = K_c; the smallest of all inputs.
        let small = 2f64.powi(-40);
        assert_eq!(assert_exact_signs([small, small, 1.0, 3.375 * small, 0.125 * small, 1.0, 1.0]), [1, 0]);
        assert_eq!(assert_exact_signs([1.0, 1.5, 1.0, 1.0, 1.0, 1.0, 1.0])[0], 0);
        assert_exact_signs([f64::from_bits(1); 7]);
        assert_exact_signs([f64::MAX; 7]);
    }
}
