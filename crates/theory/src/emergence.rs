//! The velocity of an asymptote in numbers, from the equations as the report states them.

use std::collections::BTreeMap;

use crate::{Equations, Role};
use slipmode_algebra::Symbol;
use slipmode_core::friction::Slider;
use slipmode_core::number::{Ball, Rational};

/// The velocity at which an equation is met at this σ, m/s, enclosed.
///
/// None when the equation contains other quantities or its left side over its right is not in proportion to V_0.
#[must_use]
pub fn velocity_of(
    equations: &Equations,
    role: Role,
    slider: &Slider<Rational>,
    normal_stress_pa: &Rational,
    precision_bits: u32,
) -> Option<Ball> {
    let ball = |value: &Rational| Ball::from_rational(value, precision_bits);
    let ratio_at = |velocity: Ball| {
        let mut values = of_slider(slider, precision_bits);
        values.extend([("sigma", ball(normal_stress_pa)), ("V_0", velocity)].map(named));
        let equation = equations.with_role(role);
        let left = equation.left.enclosed(&values, precision_bits)?;
        Some(left / equation.right.enclosed(&values, precision_bits)?)
    };
    let one = || ball(&Rational::from(1));
    let velocity = one() / ratio_at(one())?;
    let met = ratio_at(velocity.clone())?;
    (met.overlaps(&one()) && velocity.lower() > 0).then_some(velocity)
}

/// The slider's quantities by their symbols.
fn of_slider(slider: &Slider<Rational>, precision_bits: u32) -> BTreeMap<Symbol, Ball> {
    let quantities = [
        ("a", &slider.direct_effect),
        ("b", &slider.evolution_effect),
        ("D_c", &slider.critical_slip_distance_m),
        ("K", &slider.stiffness_pa_per_m),
        ("M", &slider.mass_per_area_kg_per_m2),
    ];
    quantities.map(|(name, value)| named((name, Ball::from_rational(value, precision_bits)))).into()
}

fn named((name, value): (&'static str, Ball)) -> (Symbol, Ball) {
    (name.into(), value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn velocity(text: Option<&str>) -> Option<Ball> {
        let equations = crate::equations::tests::paper();
        let equations = text.map_or(equations.clone(), |text| equations.altered("20", text).unwrap());
        let slider = Slider::from([
            Rational::from((4, 1000)),
            Rational::from((6, 1000)),
            Rational::from((1, 100_000)),
            Rational::from(10_000_000),
            Rational::from(1000),
        ]);
        velocity_of(&equations, Role::InertialLower, &slider, &Rational::from(1000), 128)
    }

    #[test]
    fn the_velocity_is_the_one_that_meets_the_equation_as_stated() {
        // aσ/(2√(MK)) = 4/(2·10^5).
        assert!(velocity(None).unwrap().contains(&Rational::from((1, 50_000))));
        let with_b = velocity(Some("2*V_0*sqrt(M*K)/(b*sigma) = 1")).unwrap();
        assert!(with_b.contains(&Rational::from((3, 100_000))));
    }

    #[test]
    fn an_equation_that_is_not_in_proportion_to_the_velocity_gives_none() {
        assert!(velocity(Some("2*V_0^2*sqrt(M*K)/(a*sigma) = 1")).is_none());
    }
}
