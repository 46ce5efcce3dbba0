//! Lemmas that rest on the rates in a region: runaway, deceleration, and an unbounded variable.

use super::Steps;
use slipmode_algebra::{Expression, Refutation};

/// From every start in the region a variable becomes infinite in finite time.
pub(super) fn runaway(
    steps: &mut Steps<'_>,
    region: &Expression,
    grows: usize,
    growth: &Expression,
) -> Result<(), Refutation> {
    stays(steps, region)?;
    driven(steps, grows)?;
    steps.positive_constant("the constant of growth is positive", growth)?;
    let name = steps.system.state[grows].clone();
    let margin = steps.coordinate_rate(grows) - growth.clone() * steps.system.variable(grows);
    steps.sign_where(
        &format!("in the region, the rate of ln {name} less the constant times {name}"),
        region,
        &margin,
        1,
    )?;
    steps.reason(&format!(
        "A motion that starts in the region stays in it, because the expression of the region rises there. In it d(1/{name})/dt is less \
         than minus the constant, so that the motion exists no longer than 1/(constant·{name}) of its start (comparison principle). \
         If {name} stayed bounded until then, the other variable would too, because its equation is linear (Gronwall's inequality), and \
         the motion could be continued. So {name}, which rises, becomes infinite within that time."
    ));
    Ok(())
}

/// From every start in the region a variable falls for ever.
pub(super) fn deceleration(
    steps: &mut Steps<'_>,
    region: &Expression,
    falls: usize,
) -> Result<(), Refutation> {
    stays(steps, region)?;
    driven(steps, falls)?;
    let name = steps.system.state[falls].clone();
    steps.sign_where(
        &format!("in the region, the rate of {name}"),
        region,
        &steps.system.rates[falls].clone(),
        -1,
    )?;
    steps.reason(&format!(
        "A motion that starts in the region stays in it, because the expression of the region rises there, and {name} falls there. So \
         {name} is bounded, and on bounded times the other variable and the rate of ln {name} are too, because the equation of the \
         other variable is linear (Gronwall's inequality). The motion exists for ever, and {name} falls for ever."
    ));
    Ok(())
}

/// Where every motion leaves every compact set, a variable is unbounded along it.
pub(super) fn unbounded(
    steps: &mut Steps<'_>,
    grows: usize,
    threshold: &Expression,
    growth: &Expression,
) -> Result<(), Refutation> {
    driven(steps, grows)?;
    let (system, other) = (steps.system, 1 - grows);
    let (v, x) = (&system.state[grows], &system.state[other]);
    if !steps.is_positive(other) {
        return Err(steps.refuse(&format!("{x} is positive"), format!("{x} is free")));
    }
    let zero = Expression::integer(0);
    let [gain, loss] = [system.rates[other].with(v, &zero), -system.rates[other].derivative(v).derivative(x)];
    let says = format!("{x} grows at a constant rate and is lost at a rate in proportion to {v} times {x}");
    steps.identity(
        &says,
        &system.rates[other],
        &(gain.clone() - loss.clone() * system.variable(grows) * system.variable(other)),
    )?;
    for (words, constant) in [("the constant rate of growth", &gain), ("the constant of loss", &loss)] {
        let constant = steps.rational(words, constant)?;
        steps.positive_constant(&format!("{words} is positive"), &Expression::from(&constant))?;
    }
    steps.positive_constant("the threshold is positive", threshold)?;
    steps.positive_constant("the growth above the threshold is positive", growth)?;
    let margin = steps.coordinate_rate(grows) - growth.clone();
    let above = system.variable(other) - threshold.clone();
    steps.sign_where(
        &format!("with {x} above the threshold, the rate of ln {v} less the growth"),
        &above,
        &margin,
        1,
    )?;
    steps.reason(&format!(
        "Suppose that {v} stays bounded along a motion that leaves every compact set for good. Then {x} rises where {v}·{x} is small, so \
         that {x} has a positive lower bound, and it grows at most in proportion to time. So the rate of ln {v} is bounded on bounded \
         times, and the motion exists for ever. There are three cases. (1) {x} is above the threshold from some time on: then {v} \
         grows without bound. (2) {x} is below the threshold from some time on: then {v} tends to zero, because the motion leaves every \
         compact set, and {x} rises at nearly its constant rate beyond the threshold. (3) {x} falls through the threshold at \
         arbitrarily late times: there {v} is at least the constant rate over the constant of loss and the threshold, so that the \
         motion visits a compact set at arbitrarily late times. Each case is a contradiction, so that {v} is unbounded."
    ));
    Ok(())
}

/// The expression of a region rises in the region.
fn stays(steps: &mut Steps<'_>, region: &Expression) -> Result<(), Refutation> {
    let rate = steps.system.rate_of(region);
    steps.sign_where("in the region, the rate of the region's expression", region, &rate, 1)
}

/// The motion exists as long as a variable v > 0 is bounded: the other variable obeys a linear equation whose coefficients are
/// polynomials in v, stays positive if it is, and the rate of ln v has a value at v = 0 too.
fn driven(steps: &mut Steps<'_>, index: usize) -> Result<(), Refutation> {
    let (system, other) = (steps.system, 1 - index);
    let (v, x) = (&system.state[index], &system.state[other]);
    let says = format!("while {v} is bounded the motion exists");
    if !steps.is_positive(index) {
        return Err(steps.refuse(&says, format!("{v} is free")));
    }
    let own = steps.rational(&says, &steps.coordinate_rate(index))?;
    let rate = steps.rational(&says, &system.rates[other])?;
    if own.denominator().degree(v) > 0 || rate.denominator().degree(v) > 0 || rate.denominator().degree(x) > 0
    {
        return Err(steps.refuse(&says, format!("a rate has {v} in a divisor, or that of {x} has {x}")));
    }
    let zero = Expression::integer(0);
    let [slope, rest] = [system.rates[other].derivative(x), system.rates[other].with(x, &zero)];
    let slope = Expression::from(&steps.rational(&says, &slope)?);
    if slope.variables().contains(x) {
        return Err(steps.refuse(&says, format!("the rate of {x} is not linear in it")));
    }
    steps.identity(
        &format!("the equation of {x} is linear in it"),
        &system.rates[other],
        &(rest.clone() + slope * system.variable(other)),
    )?;
    if steps.is_positive(other) && !steps.rational(&says, &rest)?.is_zero() {
        steps.sign(&format!("{x} stays positive: its rate at {x} = 0"), &rest, 1)?;
    }
    Ok(())
}
