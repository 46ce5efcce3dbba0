//! Lemmas that rest on a quantity with one hilltop: conserved, or with a rate of one sign.

use super::Steps;
use slipmode_algebra::{Expression, Refutation};

/// Every motion is periodic.
pub(super) fn periodic(steps: &mut Steps<'_>, quantity: &Expression) -> Result<(), Refutation> {
    let rate = steps.system.rate_of(quantity);
    steps.identity("the rate of the quantity along the motion", &rate, &Expression::integer(0))?;
    hilltop(steps, quantity)?;
    // The motion runs along the level lines with this speed: it stops only where the gradient vanishes.
    let says = "the rates of the two coordinates by the gradient of the quantity";
    let [first, second] = [0, 1].map(|index| steps.slope(quantity, index));
    let factor = steps.quotient(says, &steps.coordinate_rate(1), &first)?;
    steps.identity(
        "the rate of the second coordinate is a factor times the slope along the first",
        &steps.coordinate_rate(1),
        &(factor.clone() * first),
    )?;
    steps.identity(
        "the rate of the first coordinate is minus that factor times the slope along the second",
        &steps.coordinate_rate(0),
        &-(factor.clone() * second),
    )?;
    steps.some_sign("that factor", &factor)?;
    steps.reason(
        "A strictly concave function on the plane with a greatest value has compact convex sets of larger values. Below the greatest \
         value its gradient does not vanish, so that each level is one closed curve (implicit function theorem). A motion stays on its \
         level, and its speed there has a positive lower bound. It runs around the whole curve and returns: it is periodic. The motion \
         at the greatest value rests. A convex function is minus a concave one.",
    );
    Ok(())
}

/// Every motion approaches the steady state.
pub(super) fn attraction(
    steps: &mut Steps<'_>,
    quantity: &Expression,
    zero: &Expression,
) -> Result<(), Refutation> {
    lyapunov(steps, quantity, zero, 1)?;
    steps.reason(
        "A strictly concave function on the plane with a greatest value has compact sets of larger values. The quantity never falls, so \
         that each motion stays in such a set and exists for ever. By LaSalle's invariance principle it approaches the largest invariant \
         set in which the rate of the quantity is zero. A motion in that set stays on the curve, and rests there only at the steady \
         state. Every motion approaches the steady state. A convex function is minus a concave one.",
    );
    Ok(())
}

/// Every motion off the steady state leaves every compact set for good.
pub(super) fn repulsion(
    steps: &mut Steps<'_>,
    quantity: &Expression,
    zero: &Expression,
) -> Result<(), Refutation> {
    lyapunov(steps, quantity, zero, -1)?;
    steps.reason(
        "The quantity never rises. Suppose that it stays above some value for ever along a motion off the steady state. The motion then \
         stays in a compact set, because a strictly concave function with a greatest value has compact sets of larger values. By \
         LaSalle's invariance principle it approaches the largest invariant set in which the rate of the quantity is zero, which is the \
         steady state. The quantity would then approach its greatest value, but it starts below it and never rises: a contradiction. \
         So the quantity falls below every value, and the motion leaves every compact set for good. A convex function is minus a \
         concave one.",
    );
    Ok(())
}

/// The rate of the quantity has a sign but on a curve, which the motion leaves but at the steady state. `towards` is 1 where the
/// quantity moves to its extreme value and −1 where it moves away.
fn lyapunov(
    steps: &mut Steps<'_>,
    quantity: &Expression,
    zero: &Expression,
    towards: i8,
) -> Result<(), Refutation> {
    let rate = steps.system.rate_of(quantity);
    let says = "the rate of the quantity along the motion is a factor times a square";
    let square = zero.clone().power(2);
    let factor = steps.quotient(says, &rate, &square)?;
    steps
        .identity(says, &rate, &(factor.clone() * square))
        .map_err(|_| steps.refuse(says, format!("the factor would be {factor}")))?;
    let curvature = hilltop(steps, quantity)?;
    let direction = if towards > 0 { "towards" } else { "away from" };
    let sign = -curvature * towards;
    steps.sign(
        &format!("that factor has the sign with which the quantity moves {direction} its extreme value"),
        &factor,
        sign,
    )?;
    off_the_curve(steps, zero)
}

/// On the curve zero = 0 the motion stays on the curve only at the steady state.
fn off_the_curve(steps: &mut Steps<'_>, zero: &Expression) -> Result<(), Refutation> {
    let says = "the curve on which the rate of the quantity is zero";
    let system = steps.system;
    let linear = |index: &usize| {
        let slope = steps.rational(says, &zero.derivative(&system.state[*index]));
        slope.is_ok_and(|slope| {
            !slope.is_zero() && !Expression::from(&slope).variables().contains(&system.state[*index])
        })
    };
    let solved = [0, 1].into_iter().find(linear);
    let solved =
        solved.ok_or_else(|| steps.refuse(says, format!("{zero} is linear in neither state variable")))?;
    let slope = zero.derivative(&system.state[solved]);
    let rest = zero.with(&system.state[solved], &Expression::integer(0));
    steps.some_sign("the slope of the curve's expression in one variable, so that each value of the other has one point of the curve,", &slope)?;
    let on_curve = steps.quotient(says, &-rest, &slope)?;
    let name = &system.state[solved];
    let leaving = system.rate_of(zero).with(name, &on_curve);
    let distance = system.variable(1 - solved) - steps.steady(says)?[1 - solved].clone();
    let says = "the rate at which a motion leaves the curve is a factor times the distance from the steady state along it";
    let factor = steps.multiple(says, &leaving, &distance)?;
    steps.some_sign("that factor", &factor).map(|_| ())
}

/// The quantity is strictly concave (−1) or convex (+1) in the coordinates, with its extreme value at the steady state, where the
/// rates vanish.
fn hilltop(steps: &mut Steps<'_>, quantity: &Expression) -> Result<i8, Refutation> {
    let says = "the quantity has its extreme value at the steady state";
    let system = steps.system;
    let steady = steps.steady(says)?;
    let zero = Expression::integer(0);
    let slopes = [0, 1].map(|index| steps.slope(quantity, index));
    for index in [0, 1] {
        let name = &system.state[index];
        if steps.is_positive(index) {
            steps.sign(&format!("the steady state of {name} is positive"), &steady[index], 1)?;
        }
        steps.identity(
            &format!("the rate of {name} at the steady state"),
            &system.at_rest(&system.rates[index]),
            &zero,
        )?;
        steps.identity(
            &format!("the slope of the quantity along {name} there"),
            &system.at_rest(&slopes[index]),
            &zero,
        )?;
    }
    let [aa, ab, bb] = [(0, 0), (0, 1), (1, 1)].map(|(row, column)| steps.slope(&slopes[row], column));
    let sign = steps.some_sign("the second slope of the quantity along the first coordinate", &aa)?;
    let determinant = aa * bb - ab.power(2);
    steps.sign(
        "the determinant of its second slopes is positive: strictly concave or convex",
        &determinant,
        1,
    )?;
    Ok(sign)
}
