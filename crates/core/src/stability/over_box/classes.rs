//! Which spectral classes a box contains: decided exactly by corners and by the path of `lower_area`.
//!
//! Each set but the lower area is monotone: growth of some parameters leads into it, growth of the others out of it.
//! So a box lies inside exactly when its worst corner does, and meets the set exactly when its best corner does.
//! The three areas of real roots and {K ≤ K_c} are closed and have no common point. A box is connected, so it
//! contains a complex pair unless it lies in one area.

use rug::Complete;

use super::Met;
use super::corners::{A, B, Corner, D, Filtered, K, M, Point, S, State, V, middle};
use super::lower_area;
use crate::friction::Parameters;
use crate::stability::SpectralClass;

/// K < K_c: up in b, M, σ, V0, and down in a, D_c, K. The corner that is nearest to it, or deepest inside.
pub(super) const LEAST_STABLE: Corner = Corner::high(&[B, M, S, V]);

/// All real, two roots positive: up in σ, b and down in a, D_c, K, M, V0.
const UNSTABLE_REAL: Corner = Corner::high(&[B, S]);

/// All real, two roots between −1 and 0: up in a, σ and down in b, D_c, K, M, V0.
const UPPER: Corner = Corner::high(&[A, S]);

/// A corner, and the area of real roots that it may be outside of.
type WayOut = (Corner, fn(State) -> bool);

/// The sets that a box meets.
pub(super) struct Classes<'a> {
    /// The least and the greatest sign of K − K_c.
    pub(super) transition: [i8; 2],
    /// An enclosure of the signs of the discriminant; the least one is attained.
    pub(super) boundary: [i8; 2],
    pub(super) unstable_real: Met<'a>,
    pub(super) unstable_complex: Met<'a>,
    pub(super) neutral: Met<'a>,
    pub(super) stable_complex: Met<'a>,
    pub(super) upper: Met<'a>,
    pub(super) lower: Met<'a>,
}

impl<'a> Classes<'a> {
    /// The least and the greatest sign of K − K_c.
    pub(super) fn transition_signs(filtered: &Filtered<'_>) -> [i8; 2] {
        [LEAST_STABLE, LEAST_STABLE.opposite()].map(|corner| filtered.at_corner(corner).transition)
    }

    /// Decides all of them.
    pub(super) fn of(filtered: &'a Filtered<'_>) -> Self {
        let if_at = |at: Corner, is_inside: fn(State) -> bool| {
            if is_inside(filtered.at_corner(at)) { Met::at_corner(filtered, at) } else { Met::NOWHERE }
        };
        let [least, most] = [LEAST_STABLE, LEAST_STABLE.opposite()];
        let transition = Self::transition_signs(filtered);
        let unstable_real = if_at(UNSTABLE_REAL, State::is_unstable_real);
        let upper = if_at(UPPER, State::is_upper);
        let lower = lower_area::meets(filtered);
        let way_out: [WayOut; 1] = [(UNSTABLE_REAL.opposite(), State::is_unstable_real)];
        let unstable_complex = outside(filtered, least, &way_out, SpectralClass::UnstableComplex);
        let ways_out: [WayOut; 3] = [
            (UPPER.opposite(), State::is_upper),
            (lower_area::LEAST, State::is_lower),
            (lower_area::LEAST.opposite(), State::is_lower),
        ];
        let stable_complex = outside(filtered, most, &ways_out, SpectralClass::StableComplex);
        let neutral = neutral(filtered, transition);
        let has = |sets: &[&Met]| sets.iter().any(|met| met.is_somewhere());
        let boundary = [
            if has(&[&unstable_complex, &neutral, &stable_complex]) { -1 } else { least_of_real(filtered) },
            if has(&[&unstable_real, &upper, &lower]) { 1 } else { -1 },
        ];
        Self { transition, boundary, unstable_real, unstable_complex, neutral, stable_complex, upper, lower }
    }
}

/// The least sign of the discriminant in a box without complex pairs: the corners that decide whether it lies in an area
/// are the first to reach the area's boundary.
fn least_of_real(filtered: &Filtered<'_>) -> i8 {
    let corners =
        [UNSTABLE_REAL.opposite(), UPPER.opposite(), lower_area::LEAST, lower_area::LEAST.opposite()];
    corners.into_iter().map(|corner| filtered.at_corner(corner).boundary).fold(1, i8::min)
}

/// A point of a class with a complex pair, from a corner that is in it or in an area of real roots beside it.
///
/// `ways_out` are corners, one of which is outside that area if the box does not lie inside.
fn outside<'a>(
    filtered: &'a Filtered<'_>,
    start: Corner,
    ways_out: &[WayOut],
    class: SpectralClass,
) -> Met<'a> {
    let state = filtered.at_corner(start);
    if state.class == class {
        return Met::at_corner(filtered, start);
    }
    let leads_out =
        |&&(corner, is_inside): &&WayOut| is_inside(state) && !is_inside(filtered.at_corner(corner));
    ways_out.iter().find(leads_out).map_or(Met::NOWHERE, |&(corner, is_inside)| {
        let ends = move || [start, corner].map(|corner| filtered.region.corner(corner));
        Met::found_by(move || filtered.between(ends(), is_inside, |_, state| state.class == class))
    })
}

/// A point on K = K_c.
fn neutral<'a>(filtered: &'a Filtered<'_>, transition: [i8; 2]) -> Met<'a> {
    let [least, most] = [LEAST_STABLE, LEAST_STABLE.opposite()];
    match transition {
        [0, _] => Met::at_corner(filtered, least),
        [_, 0] => Met::at_corner(filtered, most),
        [-1, 1] => Met::found_by(move || {
            on_transition(filtered, filtered.region.corner(least), filtered.region.corner(most))
        }),
        _ => Met::NOWHERE,
    }
}

/// The parameters in which K a D_c² − (b − a)(σ a D_c + M V0²) is linear; none of its values is free of them.
const LINEAR: [usize; 4] = [K, B, S, M];

/// A rational point on K = K_c between two corners. The transition crosses the box along the linear parameters
/// for some rational a, D_c and V0, unless these parameters are certain.
fn on_transition(filtered: &Filtered<'_>, mut unstable: Point, mut stable: Point) -> Option<Point> {
    if !LINEAR.iter().any(|i| filtered.region.is_wide(*i)) {
        return None;
    }
    let ends = [unstable.clone(), stable.clone()];
    let with_linear = |other: &Point, end: &Point| -> Point {
        std::array::from_fn(|i| if LINEAR.contains(&i) { end[i].clone() } else { other[i].clone() })
    };
    loop {
        let middle = middle(&unstable, &stable);
        let [low, high] = [&ends[0], &ends[1]].map(|end| with_linear(&middle, end));
        if filtered.at(&low).transition > 0 {
            stable = middle;
        } else if filtered.at(&high).transition < 0 {
            unstable = middle;
        } else {
            return linear_crossing(low, &high);
        }
    }
}

/// The point on K = K_c as the linear parameters change one by one, from K ≤ K_c to K ≥ K_c.
fn linear_crossing(mut from: Point, to: &Point) -> Option<Point> {
    // (K − K_c) times positive factors.
    let value = |point: &Point| {
        let scale = point[A].clone().square() * &point[S] * &point[D];
        Parameters::from(point.clone()).groups().transition_margin() * scale
    };
    for parameter in LINEAR {
        let mut next = from.clone();
        next[parameter] = to[parameter].clone();
        let [start, end] = [value(&from), value(&next)];
        if start == 0 {
            return Some(from);
        }
        if end >= 0 {
            let share = start.clone() / (start - end);
            next[parameter] = (&next[parameter] - &from[parameter]).complete() * share + &from[parameter];
            return Some(next);
        }
        from = next;
    }
    None
}
