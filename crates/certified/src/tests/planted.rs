//! Planted faults in the arithmetic and in the tube, and the comparisons that notice them.

use rug::Float;

use crate::Constants;
use crate::interval::{Interval, UNIT, up};
use crate::lanes::{Lanes, product};
use crate::manifold::{Manifold, Tube};
use crate::motion::{Motion, States};
use crate::set::{COORDINATES, Set};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::split_mix::SplitMix64;

/// An operation on intervals, and on numbers of 400 bits.
type Operation = (fn(Interval, Interval) -> Interval, fn(&Float, &Float) -> Float);

/// How often the exact result of two of the ends lies outside.
fn violations((enclosed, exact): Operation, operands: &[[Interval; 2]]) -> usize {
    let ends = |c: Interval| [c.rad, -c.rad].map(|rad| Float::with_val(400, c.mid) + rad);
    let misses = |&[a, b]: &[Interval; 2]| {
        let found = enclosed(a, b);
        let is_outside = |x: &Float, y: &Float| (exact(x, y) - found.mid).abs() > found.rad;
        ends(a).iter().any(|x| ends(b).iter().any(|y| is_outside(x, y)))
    };
    operands.iter().filter(|operands| misses(operands)).count()
}

fn sum(x: &Float, y: &Float) -> Float {
    Float::with_val(400, x + y)
}

fn times(x: &Float, y: &Float) -> Float {
    Float::with_val(400, x * y)
}

fn series(a: Interval, b: Interval) -> Interval {
    product(&[Lanes::<1>::all(a).into()], &[Lanes::all(b).into()], 0).lane(0)
}

const RIGHT: [Operation; 5] = [
    (|a, b| a + b, sum),
    (|a, b| a * b, times),
    (series, times),
    (|a, _| a.reciprocal(), |x, _| Float::with_val(400, x.recip_ref())),
    (|a, _| a.exp(), |x, _| Float::with_val(400, x.exp_ref())),
];

/// The error of the centre left out.
const CENTRE_AS_EXACT: [Operation; 5] = [
    (|a, b| Interval { mid: a.mid + b.mid, rad: up(a.rad + b.rad) }, RIGHT[0].1),
    (|a, b| Interval { mid: a.mid * b.mid, rad: up(spread(a, b)) }, RIGHT[1].1),
    (|a, b| Interval { mid: series(a, b).mid, rad: up(spread(a, b)) }, RIGHT[2].1),
    (|a, _| Interval { mid: a.reciprocal().mid, rad: 0.0 }, RIGHT[3].1),
    (|a, _| Interval { mid: a.exp().mid, rad: 0.0 }, RIGHT[4].1),
];

/// The radius rounded to nearest; the radius without the product of the radii.
const RADIUS_TOO_SMALL: [Operation; 3] = [
    (|a, b| Interval { mid: a.mid + b.mid, rad: a.rad + b.rad + UNIT * (a.mid + b.mid).abs() }, RIGHT[0].1),
    (|a, b| Interval { mid: a.mid * b.mid, rad: spread(a, b) + UNIT * (a.mid * b.mid).abs() }, RIGHT[1].1),
    (|a, b| Interval { mid: a.mid * b.mid, rad: up(a.mid.abs() * b.rad + a.rad * b.mid.abs()) }, RIGHT[1].1),
];

fn spread(a: Interval, b: Interval) -> f64 {
    a.mid.abs() * b.rad + a.rad * (b.mid.abs() + b.rad)
}

#[test]
fn rounding_inward_is_noticed() {
    let mut random = SplitMix64(1);
    let mut number = || 0.5 + random.unit();
    let numbers: Vec<[Interval; 2]> =
        (0..1000).map(|_| [Interval::point(number()), Interval::point(number())]).collect();
    let widths: Vec<[Interval; 2]> =
        (0..1000).map(|_| [Interval::symmetric(number()), Interval::symmetric(number())]).collect();
    for right in RIGHT {
        assert_eq!(violations(right, &numbers), 0);
    }
    for right in &RIGHT[..3] {
        assert_eq!(violations(*right, &widths), 0);
    }
    let mut noticed = 0;
    for wrong in CENTRE_AS_EXACT {
        noticed += usize::from(violations(wrong, &numbers) > 400);
    }
    for wrong in RADIUS_TOO_SMALL {
        noticed += usize::from(violations(wrong, &widths) > 200);
    }
    assert_eq!(noticed, CENTRE_AS_EXACT.len() + RADIUS_TOO_SMALL.len());
}

/// y and the time at which a motion crosses a velocity a little above its start.
fn crossing(constants: &Constants, states: States) -> [Interval; 2] {
    let mut motion = Motion::new(constants, states, 100_000);
    motion.may_stick = false;
    loop {
        if let Some(crossing) = motion.advance(Some(-0.999)).unwrap() {
            return [crossing.centre[0], motion.observed.duration];
        }
    }
}

/// A slider that is off the slow manifold: its tube holds the motion of the whole slider, and a tube of no width does not.
#[test]
fn a_dropped_tube_misses_the_whole_slider() {
    let mut noticed = 0;
    for law in EvolutionLaw::ALL {
        for off in [1e-6, -1e-5] {
            let constants = Constants {
                inertia: Interval::point(1e-4),
                stiffness: Interval::point(0.3),
                effect_ratio: Interval::point(1.5),
                law,
            };
            let [x, y] = [-1.0, 1.0].map(Interval::point);
            let manifold = Manifold::over(&constants, &[x, y]);
            let force = manifold.inertia * (manifold.rate + Interval::point(off));
            let none = [Interval::ZERO; COORDINATES];
            let whole = crossing(&constants, States::Inertial(Set::new(none, [x, y, force], [none; 3])));
            let within = |distance: f64| {
                let tube = Tube { distance, slopes: [0.0; COORDINATES] };
                crossing(&constants, States::Stuck(Set::new(none, [x, y], [none; 2]), tube))
            };
            let meets = |a: Interval, b: Interval| a.lower() <= b.upper() && b.lower() <= a.upper();
            let agrees = |found: [Interval; 2]| (0..2).all(|i| meets(found[i], whole[i]));
            assert!(agrees(within(off.abs())), "{law:?} {off:e} {whole:?} {:?}", within(off.abs()));
            noticed += usize::from(!agrees(within(0.0)));
        }
    }
    assert_eq!(noticed, 4);
}
