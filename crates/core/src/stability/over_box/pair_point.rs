//! A point of a box of which two given numbers are roots of eq 8.
//!
//! For such roots and such an r = V0/D_c the point is known but for q = m/k, k and δ = D_c/σ: a/(δk) = r²/N − q r (r + 2X) and
//! b/(δk) = Q (1/N − q). So a, b, k and m leave an interval of δk for each q. The q of a box that leave one are connected, as all three
//! conditions are linear in δk, δm and δ. Nothing is certain here: what the point has is found from its roots.

use super::pair_conditions::TwoRoots;
use super::root_discs::Values;
use crate::number::Interval;
use crate::number::search::golden_section;

/// How near to the best q the search comes, as a part of its range.
const NEAR: f64 = 1e-6;

/// The point, for two roots as their kind says and r. The third root is at most `ceiling`. None if the box has no such point.
pub(super) fn point_with(
    values: &Values,
    kind: TwoRoots,
    roots_and_rate: &[f64; 3],
    ceiling: f64,
) -> Option<[f64; 7]> {
    let [a, b, d, k, m, s, v] = *values;
    let rate = roots_and_rate[2];
    let enclosed = roots_and_rate.map(Interval::point);
    let [sum, product] = kind.sum_and_product(&enclosed).map(Interval::middle);
    let from_pole = kind.pole_product(&enclosed).middle();
    let length = Interval { low: d.low.max(v.low / rate), high: d.high.min(v.high / rate) };
    let delta = Interval { low: length.low / s.high, high: length.high / s.low };
    let steep = rate * (rate + sum);
    // a and b over δk.
    let shares = |q: f64| [rate * rate / product - q * steep, from_pole * (1.0 / product - q)];
    let mut range = [m.low / k.high, m.high / k.low];
    for (value, at_zero) in [(rate * rate / (product * steep), steep > 0.0), (1.0 / product, from_pole > 0.0)]
    {
        let end = usize::from(at_zero);
        range[end] = if at_zero { range[end].min(value) } else { range[end].max(value) };
    }
    if ceiling < 0.0 {
        range[1] = range[1].min(-rate / (product * ceiling));
    }
    let stiffness = |q: f64| [k.low.max(m.low / q), k.high.min(m.high / q)];
    let common = |q: f64| {
        let ([of_a, of_b], [least, most]) = (shares(q), stiffness(q));
        let lows = [a.low / of_a, b.low / of_b, delta.low * least];
        let highs = [a.high / of_a, b.high / of_b, delta.high * most];
        [lows.into_iter().fold(0.0, f64::max), highs.into_iter().fold(f64::INFINITY, f64::min)]
    };
    let lack = |q: f64| {
        let [low, high] = common(q);
        Some(libm::log(low / high)).filter(|lack| !lack.is_nan())
    };
    let q = golden_section(lack, (range[0], range[1]), NEAR * (range[1] - range[0]))?;
    let ([low, high], [of_a, of_b]) = (common(q), shares(q));
    if !(range[0] < range[1] && low <= high) {
        return None;
    }
    let product = 0.5 * (low + high);
    let [least, most] = stiffness(q).map(|end| product / end);
    let delta = 0.5 * (delta.low.max(most) + delta.high.min(least));
    let length = 0.5 * (length.low.max(delta * s.low) + length.high.min(delta * s.high));
    let point = [
        product * of_a,
        product * of_b,
        length,
        product / delta,
        q * product / delta,
        length / delta,
        rate * length,
    ];
    Some(std::array::from_fn(|i| point[i].clamp(values[i].low, values[i].high)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::split_mix::SplitMix64;
    use crate::roots::bounded_roots;
    use crate::stability::over_box::root_discs::cubic;

    #[test]
    fn roots_of_a_point_inside_are_those_of_the_found_point() {
        let mut random = SplitMix64(6);
        let mut found = [0; 2];
        while found.iter().any(|found| *found < 100) {
            let point =
                [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0].map(|x| x * libm::exp10(random.unit() - 0.5));
            let values: Values = point.map(|value| {
                let below = 0.2 * random.unit();
                Interval { low: value * (1.0 - below), high: value * (1.2 - below) }
            });
            let roots = |point: [f64; 7]| {
                let [c0, c1, c2, c3] = cubic(&point.map(Interval::point)).map(Interval::middle);
                let real = bounded_roots([c0, c1, c2, c3]).real.value;
                let half_sum = -0.5 * (c2 / c3 + real);
                [half_sum, -c0 / (c3 * real) - half_sum * half_sum, real]
            };
            let [half_sum, square, _] = roots(point);
            if square.abs() < 1e-3 * half_sum * half_sum {
                continue;
            }
            let width = square.abs().sqrt();
            let (kind, two) = if square > 0.0 {
                (TwoRoots::Pair, [half_sum, square])
            } else {
                (TwoRoots::Real, [half_sum + width, half_sum - width])
            };
            found[usize::from(kind == TwoRoots::Real)] += 1;
            let same = point_with(&values, kind, &[two[0], two[1], point[6] / point[2]], f64::INFINITY);
            let same = same.expect("the point itself is one");
            assert!((0..7).all(|i| values[i].low <= same[i] && same[i] <= values[i].high));
            let again = roots(same);
            for (one, other) in [half_sum, square].into_iter().zip(again) {
                assert!(
                    (one - other).abs() < 1e-9 * (half_sum * half_sum + square.abs()).max(one.abs()),
                    "{values:?} {again:?}"
                );
            }
        }
        // A root beyond what any point of the box has.
        let values = [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0].map(|x| Interval { low: x, high: 1.01 * x });
        assert_eq!(point_with(&values, TwoRoots::Pair, &[3.0, 5.0, 1.0], f64::INFINITY), None);
    }
}
