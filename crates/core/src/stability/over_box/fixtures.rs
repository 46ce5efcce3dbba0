//! Points and boxes for tests: of all sizes, and next to every boundary.

use proptest::prelude::*;

use super::corners::Point;
use crate::friction::ParameterBox;
use crate::number::Rational;

/// A quotient of small integers.
fn small() -> impl Strategy<Value = Rational> {
    (1i64..400, 1i64..200).prop_map(Rational::from)
}

/// Points whose three roots −1 − x_i are given: in the lower area (and on its boundary and cusp), or in an upper one.
fn by_roots() -> impl Strategy<Value = Option<Point>> {
    let values = prop::array::uniform7(small());
    (values, 0u8..3, 0u8..4).prop_map(|([x, y, z, a, d, s, v], kind, equal)| {
        let one = Rational::from(1);
        let roots = |x: Rational, y: Rational, z: Rational| match equal {
            0 => [x.clone(), x.clone(), x],
            1 => [x.clone(), x, z],
            _ => [x, y, z],
        };
        let [x, y, z] = match (kind, roots(x, y, z)) {
            (0, roots) => roots,
            (1, [x, y, z]) => [-(x.clone() / (x + 1u32)), -(y.clone() / (y + 1u32)), z],
            (_, [x, y, z]) => [-(x.clone() + 1u32), -(y.clone() + 1u32), z + x + y],
        };
        let sum = x.clone() + &y + &z + 2u32;
        let product =
            |shift: &Rational| (x.clone() + shift) * (y.clone() + shift) * (z.clone() + shift) / &sum;
        let (eta, kappa, beta) = (one.clone() / &sum, product(&one), product(&Rational::new()));
        let positive = eta > 0 && kappa > 0 && beta > 0;
        let k = kappa * &a * &s / &d;
        let m = eta * &s * &a * &d / v.clone().square();
        positive.then(|| [a.clone(), beta * a, d, k, m, s, v])
    })
}

/// Points on the transition.
fn on_transition() -> impl Strategy<Value = Point> {
    prop::array::uniform6(small()).prop_map(|[a, excess, d, m, s, v]| {
        let inertia = m.clone() * v.clone().square() / (a.clone() * &d);
        let k = excess.clone() * (s.clone() + inertia) / &d;
        [a.clone(), a + excess, d, k, m, s, v]
    })
}

/// Points of all kinds.
pub(super) fn any_point() -> impl Strategy<Value = Point> {
    prop_oneof![
        prop::array::uniform7(small()),
        by_roots().prop_filter_map("groups are positive", |point| point),
        on_transition(),
    ]
}

/// Boxes around points of all kinds: wide and thin, with few or all parameters uncertain.
pub(super) fn any_box() -> impl Strategy<Value = (ParameterBox, Point)> {
    let widths = prop_oneof![Just(2i64), Just(5), Just(20), Just(1000), Just(1_000_000_000_000)];
    let ends = prop::array::uniform7((0i64..=10, 0i64..=10, 0u8..4));
    (any_point(), widths, ends).prop_map(|(point, width, ends)| {
        let end = |i: usize, share: i64| {
            let share = if ends[i].2 == 0 { 0 } else { share };
            Rational::from((10 * width + share, 10 * width)) * &point[i]
        };
        let lower = std::array::from_fn(|i| end(i, -ends[i].0));
        let upper = std::array::from_fn(|i| end(i, ends[i].1));
        (ParameterBox { lower, upper }, point)
    })
}
