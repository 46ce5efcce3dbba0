//! The proved expressions at given parameters, exactly.

use super::closed_form::square_amplitude as closed_square_amplitude;
use crate::friction::EvolutionLaw;
use crate::number::Rational;
use slipmode_algebra::Expression;

/// A²/(K/K_c − 1) to leading order at this η and β, A the amplitude of ln(V/V_l): [`super::HopfCoefficient::square_amplitude`].
/// Nothing where l_1 = 0.
#[must_use]
pub fn square_amplitude(
    law: EvolutionLaw,
    inertial_parameter: &Rational,
    effect_ratio: &Rational,
) -> Option<Rational> {
    let omega_squared = Rational::from(effect_ratio - 1);
    value(&closed_square_amplitude(law), inertial_parameter, &omega_squared)
}

/// η_0 = 1/(3 + 2√(β + 3)), below which the aging law is subcritical.
#[must_use]
pub fn degenerate_inertial_parameter(effect_ratio: f64) -> f64 {
    1.0 / (3.0 + 2.0 * (effect_ratio + 3.0).sqrt())
}

/// An expression in η and even powers of ω; nothing for any other, and where a denominator vanishes.
fn value(expression: &Expression, eta: &Rational, omega_squared: &Rational) -> Option<Rational> {
    let of = |inner: &Expression| value(inner, eta, omega_squared);
    let raised = |base: Rational, exponent: i32| {
        let power = (0..exponent.unsigned_abs()).fold(Rational::from(1), |power, _| power * &base);
        match exponent {
            0.. => Some(power),
            _ => (power != 0).then(|| power.recip()),
        }
    };
    match expression {
        Expression::Number(number) => Some(number.clone()),
        Expression::Variable(name) => (name.as_str() == "eta").then(|| eta.clone()),
        Expression::Sum(parts) => parts.iter().try_fold(Rational::new(), |sum, part| Some(sum + of(part)?)),
        Expression::Product(parts) => {
            parts.iter().try_fold(Rational::from(1), |product, part| Some(product * of(part)?))
        }
        Expression::Quotient(left, right) => {
            let divisor = of(right)?;
            if divisor == 0 { None } else { Some(of(left)? / divisor) }
        }
        Expression::Negation(inner) => of(inner).map(|inner| -inner),
        Expression::Power(inner, exponent) => match inner.as_ref() {
            Expression::Variable(name) if name.as_str() == "omega" && exponent % 2 == 0 => {
                raised(omega_squared.clone(), exponent / 2)
            }
            _ => raised(of(inner)?, *exponent),
        },
        Expression::Call(..) | Expression::Generic(..) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Criticality;
    use super::*;
    use crate::number::nearest_f64;

    #[test]
    fn small_cycles_stand_below_the_line_where_supercritical_and_above_it_where_subcritical() {
        let rational = |pair: (i32, i32)| Rational::from(pair);
        for law in EvolutionLaw::ALL {
            for eta in [(1, 100_000), (1, 100), (1, 10), (1, 7), (1, 1), (100, 1)] {
                for beta in [(101, 100), (3, 2), (50, 1)] {
                    let (eta, beta) = (rational(eta), rational(beta));
                    let square = square_amplitude(law, &eta, &beta).unwrap();
                    let subcritical = Criticality::of(law, &eta, &beta) == Criticality::Subcritical;
                    assert_eq!(square > 0, subcritical, "{law:?} {eta} {beta}");
                }
            }
        }
    }

    #[test]
    fn a_value_done_by_hand() {
        // Slip law, η = 1, β = 2: −4(2² + 4)/(1·10·2) = −8/5.
        let square = square_amplitude(EvolutionLaw::Slip, &Rational::from(1), &Rational::from(2));
        assert_eq!(square, Some(Rational::from((-8, 5))));
    }

    #[test]
    fn the_limit_of_subcritical_cycles_is_where_the_exact_kind_changes() {
        for beta in [(101, 100), (3, 2), (6, 1), (500, 1)] {
            let beta = Rational::from(beta);
            let limit = degenerate_inertial_parameter(nearest_f64(&beta));
            let of = |factor: f64| {
                Criticality::of(EvolutionLaw::Aging, &Rational::from_f64(limit * factor).unwrap(), &beta)
            };
            assert_eq!(of(1.0 - 1e-12), Criticality::Subcritical);
            assert_eq!(of(1.0 + 1e-12), Criticality::Supercritical);
        }
        // β = 6: η_0 = 1/9, where the coefficient vanishes.
        assert_eq!(square_amplitude(EvolutionLaw::Aging, &Rational::from((1, 9)), &Rational::from(6)), None);
    }
}
