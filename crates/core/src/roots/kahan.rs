//! Kahan's iteration for one real root of a cubic (*To solve a real cubic equation*, 1986).

/// The root of x³ = x + 1: it bounds the distance of the root from the inflection point, for both shapes of the cubic.
const OUTSIDE: f64 = 1.324_717_957_244_746;

/// Steps of [`kahan_root_without_branches`]: a start within a factor of 2 of the distance has 53 bits after seven.
const STEPS: usize = 8;

/// Kahan's iteration in 64-bit: from outside the three roots to the one farthest from the inflection point, monotonically.
pub(super) fn kahan_root(cubic: [f64; 4]) -> f64 {
    let [_, _, c2, c3] = cubic;
    let evaluate = |x: f64| value_and_slope(cubic, x);
    let inflection = -(c2 / c3) / 3.0;
    let (value, slope) = evaluate(inflection);
    let height = value / c3;
    let direction = if height < 0.0 { -1.0 } else { 1.0 };
    let descent = -slope / c3;
    let mut reach = libm::cbrt(height.abs());
    if descent > 0.0 {
        reach = OUTSIDE * reach.max(descent.sqrt());
    }
    let mut next = inflection - direction * reach;
    let mut root = inflection;
    if next == inflection {
        return root;
    }
    let mut first = true;
    while first || direction * next > direction * root {
        first = false;
        root = next;
        let (value, slope) = evaluate(root);
        next = root - value / slope;
    }
    root
}

/// The same root by the same iteration, with a rough cube root at its start and a fixed number of steps: for vector units.
#[inline(always)]
pub(super) fn kahan_root_without_branches(cubic: [f64; 4]) -> f64 {
    let [_, _, c2, c3] = cubic;
    let evaluate = |x: f64| value_and_slope(cubic, x);
    let inflection = -c2 / (3.0 * c3);
    let (value, slope) = evaluate(inflection);
    let height = value / c3;
    let descent = -slope / c3;
    let below = rough_cube_root(height.abs());
    let outside = OUTSIDE * below.max(descent.max(0.0).sqrt());
    let reach = if descent > 0.0 { outside } else { below };
    let mut root = inflection - if height < 0.0 { -reach } else { reach };
    for _ in 0..STEPS {
        let (value, slope) = evaluate(root);
        root -= value / slope;
    }
    root
}

#[inline(always)]
fn value_and_slope([c0, c1, c2, c3]: [f64; 4], x: f64) -> (f64, f64) {
    let lead = c3 * x;
    let first = lead + c2;
    let second = first * x + c1;
    (second * x + c0, (lead + first) * x + second)
}

/// The cube root of x ≥ 0 to 6 %, by a third of the exponent (Kahan); 1e-103 for zero.
#[inline(always)]
fn rough_cube_root(x: f64) -> f64 {
    // The upper half of the bits, times 2^32/3 rounded up, is a third of it in the upper half of the product.
    let third = ((x.to_bits() >> 32) * 0x5555_5556) >> 32;
    f64::from_bits((third + 715_094_163) << 32)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_third_of_the_exponent_is_a_cube_root_to_6_percent(exponent in -300.0f64..300.0) {
            let x = libm::exp10(exponent);
            prop_assert!((rough_cube_root(x) / libm::cbrt(x) - 1.0).abs() < 0.06);
        }

        #[test]
        fn both_iterations_end_at_the_same_root(roots in prop::array::uniform3(-9.0f64..9.0), gap in 1.0f64..9.0) {
            // One root apart from the two others: it is well conditioned.
            let [a, b, mut c] = roots;
            c += if c > 0.0 { 20.0 * gap } else { -20.0 * gap };
            let cubic = [-a * b * c, a * b + b * c + c * a, -(a + b + c), 1.0];
            let [one, other] = [kahan_root(cubic), kahan_root_without_branches(cubic)];
            prop_assert!((one - other).abs() <= 1e-13 * one.abs(), "{one} {other}");
        }
    }
}
