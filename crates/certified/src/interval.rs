//! Intervals of 64-bit numbers as a centre and a radius, rounded outward without the machine's rounding modes.
//!
//! With u = 2^−53 every operation to nearest errs by at most u times its result, or by 2^−1075 where it underflows. The radius takes this error
//! of the centre. The radius itself comes from sums of products of numbers that are not negative, in at most eight operations;
//! [`up`] raises the result by more than these can have lost.
//!
//! Products of wide intervals lose much: [0, 2]² becomes [−2, 4]. Boxes of parameters, which are wide, use the intervals by their ends in `number`.

use std::ops::{Add, Mul, Neg, Sub};

use rug::{Float, Rational, float::Round};

use slipmode_core::{dynamics::exponentials, number::nearest_f64};

/// u, the largest relative error of one operation.
pub(super) const UNIT: f64 = f64::EPSILON / 2.0;

/// More than all that underflow can have taken from one radius.
///
/// The smallest normal number would do. But the radius of an exact zero is this number, and its products with numbers below one would be
/// subnormal: some processors take a hundred times as long for those.
const TINY: f64 = 1e-290;

/// The error of e^x in units of u is below five (proved in `quick_exp`), and that of e^x − 1 below ten.
const UNITS_OF_EXP: f64 = 6.0;

/// The largest and the smallest exponent whose exponential the bound covers.
const EXPONENTS: [f64; 2] = [-700.0, 700.0];

/// At least the true value of a sum that was computed in at most eight operations on numbers that are not negative.
#[inline(always)]
pub(super) fn up(value: f64) -> f64 {
    value * (1.0 + 16.0 * UNIT) + TINY
}

/// At least the true value of a bound that was computed in fewer than a million operations on numbers that are not negative.
#[inline(always)]
pub(super) fn generously_up(value: f64) -> f64 {
    value * (1.0 + 1e-9) + TINY
}

/// All numbers within `rad` of `mid`. An operation without a bounded result gives an infinite or undefined radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    pub mid: f64,
    pub rad: f64,
}

impl Interval {
    pub const ZERO: Self = Self::point(0.0);
    pub const ONE: Self = Self::point(1.0);
    const UNBOUNDED: Self = Self { mid: 0.0, rad: f64::INFINITY };

    /// One number.
    pub const fn point(mid: f64) -> Self {
        Self { mid, rad: 0.0 }
    }

    /// [−rad, rad].
    pub const fn symmetric(rad: f64) -> Self {
        Self { mid: 0.0, rad }
    }

    /// The smallest interval of this form, to rounding, from `low` to `high`.
    pub fn between(low: f64, high: f64) -> Self {
        let mid = 0.5 * low + 0.5 * high;
        // The differences are rounded; the next number above them is not below the true ones.
        Self { mid, rad: (high - mid).max(mid - low).next_up() }
    }

    /// Encloses a rational.
    pub fn of_rational(value: &Rational) -> Self {
        Self::over([value; 2])
    }

    /// Encloses all numbers between two rationals, in either order.
    pub fn over([first, last]: [&Rational; 2]) -> Self {
        let mid = nearest_f64(&(Rational::from(first + last) / 2));
        let distance = |end: &Rational| Rational::from_f64(mid).map(|mid| (mid - end).abs());
        let rad = distance(first).max(distance(last)).map_or(f64::INFINITY, |distance| {
            Float::with_val_round(53, &distance, Round::Up).0.to_f64_round(Round::Up)
        });
        Self { mid, rad }
    }

    /// A number not above any in the interval.
    pub fn lower(self) -> f64 {
        (self.mid - self.rad).next_down()
    }

    /// A number not below any in the interval.
    pub fn upper(self) -> f64 {
        (self.mid + self.rad).next_up()
    }

    /// The largest absolute value.
    pub fn magnitude(self) -> f64 {
        up(self.mid.abs() + self.rad)
    }

    /// A number not above any absolute value; zero where zero lies inside.
    pub fn mignitude(self) -> f64 {
        (self.mid.abs() - self.rad).next_down().max(0.0)
    }

    /// Whether every number of this interval lies in the interior of the other.
    pub fn is_inside(self, other: Self) -> bool {
        up((self.mid - other.mid).abs() + self.rad) < other.rad
    }

    /// Whether this number may lie inside; true where nothing is known.
    pub fn may_contain(self, value: f64) -> bool {
        let is_outside = self.upper() < value || self.lower() > value;
        !is_outside
    }

    /// The smallest interval that holds both; not a number where one of them is not.
    pub fn hull(self, other: Self) -> Self {
        Self::between(-worse(-self.lower(), -other.lower()), worse(self.upper(), other.upper()))
    }

    /// The same with a larger radius.
    pub fn widened(self, by: f64) -> Self {
        Self { mid: self.mid, rad: up(self.rad + by) }
    }

    /// Whether both ends are known.
    pub const fn is_bounded(self) -> bool {
        self.mid.is_finite() && self.rad.is_finite()
    }

    /// e to the power of the interval; unbounded beyond the range of the proved error.
    pub fn exp(self) -> Self {
        let [least, largest] = EXPONENTS;
        if !(self.mid - self.rad > least && self.mid + self.rad < largest) {
            return Self::UNBOUNDED;
        }
        let (mid, _) = exponentials(self.mid);
        // e^{c±r} is within e^c (e^r − 1) of e^c; the products below add a few units to the ten of e^r − 1.
        let (_, excess) = exponentials(self.rad);
        let own_error = UNITS_OF_EXP * UNIT * mid;
        let spread = (mid + own_error) * (excess * (1.0 + 32.0 * UNIT));
        Self { mid, rad: up(own_error + spread) }
    }

    /// The reciprocal; unbounded where zero may lie inside.
    pub fn reciprocal(self) -> Self {
        let least = self.mid.abs() - self.rad;
        if least.is_nan() || least <= 0.0 {
            return Self::UNBOUNDED;
        }
        let mid = 1.0 / self.mid;
        // The two roundings of the divisor: |c| − r may be too large by a unit of |c|.
        let least = (least - 2.0 * UNIT * self.mid.abs()).next_down();
        if least.is_nan() || least <= 0.0 {
            return Self::UNBOUNDED;
        }
        Self { mid, rad: up(self.rad / least * mid.abs() * (1.0 + 4.0 * UNIT) + UNIT * mid.abs()) }
    }

    /// The square root of a positive interval; unbounded elsewhere.
    pub fn sqrt(self) -> Self {
        let low = self.lower();
        if low.is_nan() || low < 0.0 {
            return Self::UNBOUNDED;
        }
        Self::between(low.sqrt().next_down(), self.upper().sqrt().next_up())
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mid = self.mid + other.mid;
        Self { mid, rad: up(self.rad + other.rad + UNIT * mid.abs()) }
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { mid: -self.mid, rad: self.rad }
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mid = self.mid * other.mid;
        let spread = self.mid.abs() * other.rad + self.rad * (other.mid.abs() + other.rad);
        Self { mid, rad: up(spread + UNIT * mid.abs()) }
    }
}

/// The larger of two numbers; not a number if one of them is not.
pub(super) fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn holds(interval: Interval, exact: &Float) -> bool {
        let distance = Float::with_val(400, exact - interval.mid).abs();
        distance <= interval.rad
    }

    /// Points of an interval: its ends and some between, exactly.
    fn points(interval: Interval) -> Vec<Float> {
        [-1.0, -0.37, 0.0, 0.61, 1.0]
            .map(|part| Float::with_val(400, part) * interval.rad + interval.mid)
            .into()
    }

    fn intervals() -> impl Strategy<Value = Interval> {
        (-1.0f64..1.0, -60i32..60, 0.0f64..1.0, -40i32..4).prop_map(|(mid, scale, rad, relative)| {
            let mid = libm::scalbn(mid, scale);
            Interval { mid, rad: mid.abs() * libm::scalbn(rad, relative) }
        })
    }

    proptest! {
        #[test]
        fn every_operation_contains_the_exact_result(a in intervals(), b in intervals()) {
            for x in points(a) {
                for y in points(b) {
                    prop_assert!(holds(a + b, &Float::with_val(400, &x + &y)));
                    prop_assert!(holds(a - b, &Float::with_val(400, &x - &y)));
                    prop_assert!(holds(a * b, &Float::with_val(400, &x * &y)));
                    if b.reciprocal().is_bounded() {
                        prop_assert!(holds(b.reciprocal(), &Float::with_val(400, y.recip_ref())));
                    }
                }
                if a.mid > 2.0 * a.rad {
                    prop_assert!(holds(a.sqrt(), &Float::with_val(400, x.sqrt_ref())));
                }
            }
        }

        #[test]
        fn exponentials_contain_the_exact_result(mid in -690.0f64..690.0, rad in 0.0f64..3.0, scale in -60i32..1) {
            let interval = Interval { mid, rad: libm::scalbn(rad, scale) };
            for x in points(interval) {
                prop_assert!(holds(interval.exp(), &x.exp()));
            }
            let tight = Interval::point(mid).exp();
            // Below e^−632 what every radius gets for underflow is more than the rest.
            prop_assert!(tight.rad < 8.0 * UNIT * tight.mid + 2.0 * TINY);
        }
    }

    #[test]
    fn underflow_and_overflow_lose_nothing() {
        let small = Interval::point(1e-200);
        let product = small * small;
        assert!(
            product.mid == 0.0
                && product.rad > 0.0
                && holds(product, &(Float::with_val(400, 1e-200) * 1e-200))
        );
        let large = Interval::point(1e200);
        assert!(!(large * large).is_bounded() && !Interval::point(1000.0).exp().is_bounded());
        assert!(!Interval { mid: 1.0, rad: 1.0 }.reciprocal().is_bounded());
        assert!(Interval { mid: f64::NAN, rad: 0.0 }.may_contain(1.0));
        assert!(!Interval { mid: f64::NAN, rad: 0.0 }.is_inside(Interval { mid: 0.0, rad: 1.0 }));
    }

    /// The hull of two intervals holds both, and has no bound where one of them has none.
    #[test]
    fn a_hull_holds_both_and_forgets_nothing() {
        let (low, high) = (Interval::between(-3.0, -2.0), Interval::between(1.0, 5.0));
        for hull in [low.hull(high), high.hull(low)] {
            assert!((-3.001..=-3.0).contains(&hull.lower()) && (5.0..5.001).contains(&hull.upper()));
        }
        let unknown = f64::NAN;
        for lost in [
            Interval { mid: unknown, rad: 0.0 },
            Interval { mid: 0.0, rad: unknown },
            Interval { mid: f64::INFINITY, rad: f64::INFINITY },
        ] {
            for hull in [lost.hull(low), low.hull(lost)] {
                assert!(!hull.is_bounded() && hull.may_contain(100.0), "{hull:?}");
                assert!(!hull.is_inside(Interval::symmetric(1e300)), "{hull:?}");
            }
        }
    }

    /// Bounds of the exact ends, where rounding alone decides.
    #[test]
    fn ends_and_sizes_are_bounds() {
        let mut random = slipmode_core::number::split_mix::SplitMix64(5);
        let exact = |value: f64| Float::with_val(400, value);
        for _ in 0..2000 {
            let interval = Interval {
                mid: 2.0 * random.unit() - 1.0,
                rad: random.unit() * [1.0, 1e-3][usize::from(random.unit() < 0.5)],
            };
            let [mid, rad] = [exact(interval.mid), exact(interval.rad)];
            let (low, high) = (mid.clone() - &rad, mid.clone() + &rad);
            assert!(interval.lower() <= low && interval.upper() >= high);
            assert!(interval.magnitude() >= mid.clone().abs() + &rad);
            assert!(interval.mignitude() <= (mid.clone().abs() - &rad).max(&exact(0.0)));
            let between = Interval::between(low.to_f64(), high.to_f64());
            assert!(holds(between, &exact(low.to_f64())) && holds(between, &exact(high.to_f64())));
            let by = random.unit();
            let wide = interval.widened(by);
            assert!(holds(wide, &(high.clone() + by)) && holds(wide, &(low.clone() - by)));
            assert!(
                !interval.is_inside(interval)
                    && !interval.is_inside(Interval { mid: interval.mid, rad: interval.rad.next_down() })
            );
            assert!(holds(interval, &high) && interval.may_contain(interval.mid));
            // The value next to an end is not lost.
            assert!(interval.may_contain(high.to_f64()) && interval.may_contain(low.to_f64()));
        }
    }

    /// Close to an interval that holds zero, a reciprocal has the exact ends inside or no bound; the same of exponentials beyond their range.
    #[test]
    fn extreme_reciprocals_and_exponentials_are_right_or_unbounded() {
        let mut bounded = 0;
        for mid in [1.0, 1.5, 1.0 - UNIT, 3.7e-5, -2.0_f64] {
            for k in 1..=53 {
                let interval = Interval { mid, rad: mid.abs() * (1.0 - libm::scalbn(1.0, -k)) };
                let found = interval.reciprocal();
                if found.is_bounded() {
                    bounded += 1;
                    let ends = [interval.rad, -interval.rad].map(|rad| Float::with_val(400, mid) + rad);
                    let reciprocals = ends.map(|end| Float::with_val(400, end.recip_ref()));
                    assert!(reciprocals.iter().all(|end| holds(found, end)), "{interval:?} {found:?}");
                }
            }
        }
        assert!(bounded > 200, "{bounded}");
        let extreme = [698.0, 705.0, 709.9, -705.0, -745.0, 1e10, -1e10, 1e300];
        for mid in (-40..=40).map(|k| 50.0 * f64::from(k)).chain(extreme) {
            for rad in [0.0, 1e-3, 10.0, 900.0] {
                let interval = Interval { mid, rad };
                let found = interval.exp();
                if found.is_bounded() {
                    let ends = points(interval).into_iter().map(Float::exp);
                    assert!(ends.into_iter().all(|end| holds(found, &end)), "{interval:?} {found:?}");
                }
            }
        }
        for low in [-1.0, -1e-300, f64::NAN] {
            assert!(!Interval { mid: low, rad: 0.5 }.sqrt().is_bounded());
        }
    }

    /// What lies inside another interval does so exactly, and not at its ends.
    #[test]
    fn an_interval_inside_another_one_is_so_exactly() {
        let mut random = slipmode_core::number::split_mix::SplitMix64(6);
        let exact = |value: f64| Float::with_val(400, value);
        let mut inside = 0;
        for case in 0..6000 {
            let inner = Interval { mid: 2.0 * random.unit() - 1.0, rad: random.unit() };
            let mid = inner.mid + 1e-3 * random.unit();
            let mut rad = inner.rad + (mid - inner.mid).abs();
            for _ in 0..case % 24 {
                rad = rad.next_up();
            }
            let outer = Interval { mid, rad };
            if inner.is_inside(outer) {
                inside += 1;
                let ends = |c: Interval| [-1.0, 1.0].map(|sign| exact(c.mid) + sign * exact(c.rad));
                let ([low, high], [least, largest]) = (ends(inner), ends(outer));
                assert!(least < low && high < largest, "{inner:?} {outer:?}");
            }
        }
        assert!(inside > 10, "{inside}");
    }

    #[test]
    fn a_decimal_is_enclosed() {
        let third = Rational::from((1, 3));
        let enclosed = Interval::of_rational(&third);
        assert!(enclosed.rad > 0.0 && enclosed.rad < 1e-16);
        assert!(holds(enclosed, &Float::with_val(400, &third)));
        let three = Rational::from(3);
        assert_eq!(Interval::of_rational(&three), Interval::point(3.0));
        let between = Interval::over([&three, &third]);
        assert!([&three, &third].iter().all(|end| holds(between, &Float::with_val(400, *end))));
        // Each end can be the farther one from the rounded middle.
        for n in 1..200 {
            let (first, last) = (Rational::from((n, 7)), Rational::from((3 * n + 1, 11)));
            for between in [Interval::over([&first, &last]), Interval::over([&last, &first])] {
                assert!([&first, &last].iter().all(|end| holds(between, &Float::with_val(400, *end))), "{n}");
            }
        }
    }
}
