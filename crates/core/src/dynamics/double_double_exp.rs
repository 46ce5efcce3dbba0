//! The exponential in double-double: reduction by ln 2 and by 2^8, a Taylor series, eight doublings of e^r − 1.
//!
//! The series of e^r − 1 for |r| < 0.3466/256 is cut after r^12/12!, a relative error below 2^-120.
//! A doubling (e ↦ 2e + e²) adds about one unit of relative error; the reduction's absolute error is k·2^-150.

use crate::number::Dd;

/// ln 2 in four parts: the first two have 32 bits, so that their products with k < 2^20 are exact.
const LN_2: [f64; 4] =
    [0.6931471803691238, 1.9082149288430703e-10, 4.275175589747649e-20, -9.89608398339473e-37];

/// 1/n! for n = 1 to 12, head and tail.
#[rustfmt::skip]
const INVERSE_FACTORIALS: [[f64; 2]; 12] = [
    [1.0, 0.0],
    [0.5, 0.0],
    [0.16666666666666666, 9.25185853854297e-18],
    [0.041666666666666664, 2.3129646346357427e-18],
    [0.008333333333333333, 1.1564823173178714e-19],
    [0.001388888888888889, -5.300543954373577e-20],
    [0.0001984126984126984, 1.7209558293420705e-22],
    [2.48015873015873e-05, 2.1511947866775882e-23],
    [2.7557319223985893e-06, -1.858393274046472e-22],
    [2.755731922398589e-07, 2.3767714622250297e-23],
    [2.505210838544172e-08, -1.448814070935912e-24],
    [2.08767569878681e-09, -1.20734505911326e-25],
];

const DOUBLINGS: i32 = 8;

/// e^x and e^x − 1; overflows to a value that is not finite, underflows to zero.
pub(super) fn double_double_exponentials(x: Dd) -> (Dd, Dd) {
    let one = Dd::from(1);
    let multiple = libm::rint(x.hi() * std::f64::consts::LOG2_E);
    if multiple.abs() > 1100.0 || !x.is_finite() {
        let saturated = libm::exp(x.hi());
        return (Dd::from(saturated), Dd::from(saturated - 1.0));
    }
    let reduced = reduce(x, multiple);
    let mut excess = series_of_excess(reduced.scale(1.0 / f64::from(1 << DOUBLINGS)));
    for _ in 0..DOUBLINGS {
        excess = excess.scale(2.0) + excess * excess;
    }
    if multiple == 0.0 {
        return (excess + one, excess);
    }
    // Two factors, because 2^multiple alone may leave the normal range.
    let half = libm::floor(multiple / 2.0);
    let exponential = (excess + one).scale(libm::exp2(half)).scale(libm::exp2(multiple - half));
    (exponential, exponential - one)
}

fn reduce(x: Dd, multiple: f64) -> Dd {
    let head = x - Dd::from(multiple * LN_2[0]) - Dd::from(multiple * LN_2[1]);
    head - Dd::exact_product(multiple, LN_2[2]) - Dd::from(multiple * LN_2[3])
}

fn series_of_excess(r: Dd) -> Dd {
    let coefficient = |[head, tail]: [f64; 2]| Dd::exact_sum(head, tail);
    let mut sum = coefficient(INVERSE_FACTORIALS[11]);
    for &term in INVERSE_FACTORIALS[..11].iter().rev() {
        sum = sum * r + coefficient(term);
    }
    sum * r
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::Float;

    fn relative_error(value: Dd, exact: &Float) -> f64 {
        let value = Float::with_val(300, value.hi()) + value.lo();
        (Float::with_val(300, &value - exact) / exact).to_f64().abs()
    }

    proptest! {
        #[test]
        fn both_exponentials_keep_thirty_digits(head in -600.0f64..600.0, tail in -1.0f64..1.0) {
            let x = Dd::exact_sum(head, head * tail * 1e-17);
            let exact = Float::with_val(300, x.hi()) + x.lo();
            let (exponential, excess) = double_double_exponentials(x);
            prop_assert!(relative_error(exponential, &exact.clone().exp()) < 32.0 * Dd::UNIT);
            prop_assert!(relative_error(excess, &exact.exp_m1()) < 64.0 * Dd::UNIT);
        }

        #[test]
        fn the_excess_is_accurate_relative_to_itself_near_zero(exponent in -60i32..-1, sign in prop::bool::ANY) {
            let x = libm::exp2(f64::from(exponent)) * if sign { -1.1 } else { 0.7 };
            let (_, excess) = double_double_exponentials(Dd::from(x));
            prop_assert!(relative_error(excess, &Float::with_val(300, x).exp_m1()) < 64.0 * Dd::UNIT);
        }
    }
}
