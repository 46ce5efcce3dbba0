//! e^x and e^x − 1 in f64 together, without branches, so that those of several stages overlap; with a bound of the error.
//!
//! x = k ln 2 + r with |r| ≤ 0.3466, q = e^r − 1 by its Taylor polynomial of degree 13, e^x = 2^k (1 + q), e^x − 1 = (2^k − 1) + 2^k q.
//! With u = 2^−53: the reduction leaves r with an error of u |r| + 4e-7 u (k·LN_2_HIGH and the first difference are exact, k·LN_2_LOW is below
//! 2e-7; for k = 0 r is x). The second part counts next to e^r, not next to a small r: e^x − 1 is no smaller than 2/7 for k ≠ 0.
//! The polynomial lacks |r|^13/14! < 2e-17 of q. q = r + r² P, where the second term is below 0.22 |r| and its
//! parts err by at most 10 u of it: 1 + 0.22 · 10 + 1 units with the last sum and r itself, so less than 5 u of q. Hence
//! e^x errs by less than u + 0.42/0.58 · 5 u < 5 u. For k ≠ 0, e^x − 1 adds an exact 2^k − 1 (or one rounding) to a product of at most
//! 1.5 of its size: less than 1.5 · 5 u + 2 u < 10 u. Both are twice the worst seen.

/// High part of ln 2, whose products with |k| < 2^20 are exact, and the rest.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// 1.5·2^52: adding it rounds to an integer, which then stands in the lowest bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Beyond these the exponential is treated as infinite, and as 2e-308.
const LARGEST: f64 = 709.0;
const LEAST: f64 = -708.0;

/// 1/2!, 1/3!, … 1/13!.
const INVERSE_FACTORIALS: [f64; 12] = [
    1.0 / 2.0,
    1.0 / 6.0,
    1.0 / 24.0,
    1.0 / 120.0,
    1.0 / 720.0,
    1.0 / 5_040.0,
    1.0 / 40_320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
];

/// e^x and e^x − 1.
#[inline(always)]
pub fn exponentials(x: f64) -> (f64, f64) {
    let low = if x < LEAST { LEAST } else { x };
    let clamped = if low > LARGEST { LARGEST } else { low };
    let shifted = clamped * std::f64::consts::LOG2_E + ROUNDER;
    let k = shifted - ROUNDER;
    // The lowest twelve bits of the sum are k, those above fall out of the exponent's field.
    let scale = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    let r = (clamped - k * LN_2_HIGH) - k * LN_2_LOW;
    let c = &INVERSE_FACTORIALS;
    let r2 = r * r;
    let r4 = r2 * r2;
    let low = (c[0] + c[1] * r) + (c[2] + c[3] * r) * r2;
    let middle = (c[4] + c[5] * r) + (c[6] + c[7] * r) * r2;
    let high = (c[8] + c[9] * r) + (c[10] + c[11] * r) * r2;
    let q = r + r2 * (low + r4 * (middle + r4 * high));
    let exponential = scale * (1.0 + q);
    let excess = (scale - 1.0) + scale * q;
    if x > LARGEST { (f64::INFINITY, f64::INFINITY) } else { (exponential, excess) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Float;

    /// Errors of both in units of 2^-53.
    fn errors(x: f64) -> [f64; 2] {
        let (exponential, excess) = exponentials(x);
        let error = |value: f64, exact: Float| {
            let difference = Float::with_val(200, value - &exact).to_f64().abs();
            if difference == 0.0 { 0.0 } else { difference / exact.to_f64().abs() * libm::exp2(53.0) }
        };
        [error(exponential, Float::with_val(200, x).exp()), error(excess, Float::with_val(200, x).exp_m1())]
    }

    #[test]
    fn the_errors_keep_their_bounds() {
        // Every binade down to 1e-300, the borders between two k, and a dense walk over the range.
        let binades = (-1000..10).map(|n| 1.37 * libm::exp2(f64::from(n)));
        let borders = (-40..40).flat_map(|k| {
            let border = (f64::from(k) + 0.5) * std::f64::consts::LN_2;
            [border, border.next_up(), border.next_down(), border - 0.003]
        });
        let walk = (0..200_000).map(|i| -700.0 + f64::from(i) * 0.007_000_3);
        let near_zero = (0..50_000).map(|i| (f64::from(i) - 25_000.0) * 4.1e-5);
        let mut worst = [0.0f64; 2];
        for x in binades.chain(borders).chain(walk).chain(near_zero) {
            for x in [x, -x] {
                if x.abs() < 700.0 {
                    let found = errors(x);
                    worst = [worst[0].max(found[0]), worst[1].max(found[1])];
                }
            }
        }
        assert!(worst[0] < 2.5 && worst[1] < 5.0, "{worst:?}");
    }

    #[test]
    fn the_ends_of_the_range_are_infinite_tiny_and_not_a_number() {
        assert_eq!(exponentials(f64::INFINITY), (f64::INFINITY, f64::INFINITY));
        assert_eq!(exponentials(0.0), (1.0, 0.0));
        let (tiny, excess) = exponentials(f64::NEG_INFINITY);
        assert!(tiny > 0.0 && tiny < 1e-307 && excess == -1.0);
        assert!(exponentials(f64::NAN).0.is_nan() && exponentials(f64::NAN).1.is_nan());
    }
}
