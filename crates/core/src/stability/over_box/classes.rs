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
pub(super) struct Classes {
    /// The least and the greatest sign of K − K_c.
    pub(super) transition: [i8; 2],
    /// An enclosure of the signs of the discriminant; the least one is attained.
    pub(super) boundary: [i8; 2],
    pub(super) unstable_real: Met,
    pub(super) unstable_complex: Met,
    pub(super) neutral: Met,
    pub(super) stable_complex: Met,
    pub(super) upper: Met,
    pub(super) lower: Met,
}

impl Classes {
    /// The least and the greatest sign of K − K_c.
    pub(super) fn transition_signs(filtered: &Filtered<'_>) -> [i8; 2] {
        [LEAST_STABLE, LEAST_STABLE.opposite()].map(|corner| filtered.at_corner(corner).transition)
    }

    /// Decides all of them.
    pub(super) fn of(filtered: &Filtered<'_>) -> Self {
        let corner = |corner: Corner| filtered.region.corner(corner);
        let if_at = |at: Corner, is_inside: fn(State) -> bool| {
            if is_inside(filtered.at_corner(at)) { Met::at(corner(at)) } else { Met::Nowhere }
        };
        let [least, most] = [LEAST_STABLE, LEAST_STABLE.opposite()];
        let transition = Self::transition_signs(filtered);
        let unstable_real = if_at(UNSTABLE_REAL, State::is_unstable_real);
        let upper = if_at(UPPER, State::is_upper);
        let lower = lower_area::meets(filtered);
        let unstable_complex = if transition[0] < 0 {
            outside(
                filtered,
                least,
                &[(UNSTABLE_REAL.opposite(), State::is_unstable_real)],
                SpectralClass::UnstableComplex,
            )
        } else {
            Met::Nowhere
        };
        let stable_complex = if transition[1] > 0 {
            let ways_out: [WayOut; 3] = [
                (UPPER.opposite(), State::is_upper),
                (lower_area::LEAST, State::is_lower),
                (lower_area::LEAST.opposite(), State::is_lower),
            ];
            outside(filtered, most, &ways_out, SpectralClass::StableComplex)
        } else {
            Met::Nowhere
        };
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
fn outside(filtered: &Filtered<'_>, start: Corner, ways_out: &[WayOut], class: SpectralClass) -> Met {
    let state = filtered.at_corner(start);
    let from = filtered.region.corner(start);
    if state.class == class {
        return Met::at(from);
    }
    for (corner, is_inside) in ways_out.iter().filter(|(_, is_inside)| is_inside(state)) {
        if is_inside(filtered.at_corner(*corner)) {
            continue;
        }
        let ends = [from, filtered.region.corner(*corner)];
        let found = filtered.between(ends, is_inside, |_, state| state.class == class);
        return found.map_or(Met::WithoutWitness, Met::at);
    }
    Met::Nowhere
}

/// A point on K = K_c.
fn neutral(filtered: &Filtered<'_>, transition: [i8; 2]) -> Met {
    let [least, most] = [LEAST_STABLE, LEAST_STABLE.opposite()];
    match transition {
        [0, _] => Met::at(filtered.region.corner(least)),
        [_, 0] => Met::at(filtered.region.corner(most)),
        [-1, 1] => on_transition(filtered, filtered.region.corner(least), filtered.region.corner(most)),
        _ => Met::Nowhere,
    }
}

/// The parameters in which K a D_c² − (b − a)(σ a D_c + M V0²) is linear; none of its values is free of them.
const LINEAR: [usize; 4] = [K, B, S, M];

/// A rational point on K = K_c between two corners. The transition crosses the box along the linear parameters
/// for some rational a, D_c and V0, unless these parameters are certain.
fn on_transition(filtered: &Filtered<'_>, mut unstable: Point, mut stable: Point) -> Met {
    if !LINEAR.iter().any(|i| filtered.region.is_wide(*i)) {
        return Met::WithoutWitness;
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
            return linear_crossing(low, &high).map_or(Met::WithoutWitness, Met::at);
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
