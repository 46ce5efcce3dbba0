//! A lemma for systems in which a product of both variables moves by itself.

use super::Steps;
use slipmode_algebra::{Expression, Refutation};

/// From every start a variable falls from some time on for ever, and tends to zero.
pub(super) fn late_deceleration(
    steps: &mut Steps<'_>,
    quantity: &Expression,
    falls: usize,
) -> Result<(), Refutation> {
    let (system, other) = (steps.system, 1 - falls);
    let (v, x) = (&system.state[falls], &system.state[other]);
    let says = format!("the quantity w is a positive constant times {v}·{x}");
    if !(steps.is_positive(0) && steps.is_positive(1)) {
        return Err(steps.refuse(&says, "a state variable is free".into()));
    }
    let product = system.variable(falls) * system.variable(other);
    let factor = steps.multiple(&says, quantity, &product)?;
    steps.positive_constant("that constant is positive", &factor)?;
    // The quantity w as a parameter of the certificates.
    let ratio = steps.fresh();
    let w = Expression::variable(&ratio);
    let value = w.clone() / (factor * system.variable(other));
    let by_itself = |steps: &mut Steps<'_>, says: String, expression: Expression| {
        // The expression is multiplied out first. A divisor w that is left is refused: what depends on w is a polynomial in it.
        let plain = Expression::from(&steps.rational(&says, &expression)?);
        let in_ratio = Expression::from(&steps.rational(&says, &plain.with(v, &value))?);
        if in_ratio.variables().contains(x) {
            return Err(steps.refuse(&says, format!("{in_ratio} contains {x}")));
        }
        let back = in_ratio.with(&ratio, quantity);
        steps.identity(&says, &expression, &back).map(|()| in_ratio)
    };
    let relative = system.rate_of(quantity) / quantity.clone();
    let fall = by_itself(
        steps,
        format!("{x} times the rate of ln w depends on w alone"),
        system.variable(other) * relative,
    )?;
    let clock = by_itself(steps, format!("the rate of {x} depends on w alone"), system.rates[other].clone())?;
    let course = system.variable(other) * steps.coordinate_rate(falls);
    let course = by_itself(steps, format!("{x} times the rate of ln {v} depends on w alone"), course)?;
    let at_zero = |expression: &Expression| expression.with(&ratio, &Expression::integer(0));
    steps.sign(
        &format!("{x} times the rate of ln w is negative for w > 0"),
        &fall.with(&ratio, quantity),
        -1,
    )?;
    steps.sign("and at w = 0", &at_zero(&fall), -1)?;
    steps.sign(&format!("the rate of {x} at w = 0"), &at_zero(&clock), 1)?;
    steps.sign(&format!("{x} times the rate of ln {v} at w = 0"), &at_zero(&course), -1)?;
    steps.reason(&format!(
        "In the time τ with dτ = dt/{x}, w obeys an equation of its own, d(ln w)/dτ = F(w), with F negative for w ≥ 0 and continuous. So w \
         exists for all τ, falls, and tends to zero. d(ln {x})/dτ = G(w) is bounded and tends to G(0) > 0, so that {x} is finite and \
         positive for all τ and tends to infinity, and so does t, the integral of {x} over τ: the motion exists for ever. The rate of \
         ln {v} in τ tends to its value at w = 0, which is negative. From some time on it is negative for ever: {v} falls, and tends \
         to zero, because {v} is a constant times w/{x}."
    ));
    Ok(())
}
