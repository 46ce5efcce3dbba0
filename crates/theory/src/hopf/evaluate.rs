//! What is proved at given parameters, exactly.

use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// A²/(K/K_c − 1) to leading order at this η and β, A the amplitude of ln(V/V_l): [`super::HopfCoefficient::square_amplitude`].
/// Nothing where l_1 = 0.
#[must_use]
pub fn square_amplitude(
    law: EvolutionLaw,
    inertial_parameter: &Rational,
    effect_ratio: &Rational,
) -> Option<Rational> {
    let [numerator, divisor] = law.square_amplitude(inertial_parameter, effect_ratio);
    (divisor != 0).then(|| numerator / divisor)
}

/// η_0 = 1/(3 + 2√(β + 3)), below which the aging law is subcritical.
#[must_use]
pub fn degenerate_inertial_parameter(effect_ratio: f64) -> f64 {
    1.0 / (3.0 + 2.0 * (effect_ratio + 3.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::super::{Criticality, closed_form};
    use super::*;
    use slipmode_algebra::{Domain, Expression};
    use slipmode_core::number::nearest_f64;

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

    /// On more points than the degrees in η and ω, so that the two are the same function.
    #[test]
    fn the_amplitude_that_the_program_computes_with_is_the_one_that_is_proved() {
        for law in EvolutionLaw::ALL {
            for (eta, omega) in (1..12).flat_map(|eta| (1..9).map(move |omega| (eta, omega))) {
                let [eta, omega] = [eta, omega].map(Rational::from);
                let proved = [("eta", &eta), ("omega", &omega)]
                    .into_iter()
                    .fold(closed_form::stated("square_amplitude", law), |expression, (name, value)| {
                        expression.with(name, &Expression::Number(value.clone()))
                    });
                let proved = Domain::default().rational_function(&proved).unwrap();
                let [above, below] =
                    [proved.numerator(), proved.denominator()].map(|side| side.as_constant().unwrap());
                let computed = square_amplitude(law, &eta, &(omega.square() + 1)).unwrap();
                assert_eq!(above / below, computed, "{law:?} {eta}");
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
