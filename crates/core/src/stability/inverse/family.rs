//! The cubic of eq 8 along one unknown: four polynomials over ℚ.

use rug::Rational;

use crate::friction::{Parameters, Quantity};
use crate::number::Field;
use crate::stability::inverse::Unknown;
use slipmode_algebra::UnivariatePolynomial;

/// The coefficients of eq 8 in s as polynomials in the unknown, times V0 where V0 is the unknown.
pub(super) struct Family {
    cubic: [UnivariatePolynomial; 4],
    /// The degree of the coefficients: 2 in V0, else 1.
    degree: usize,
}

impl Family {
    pub(super) fn new(parameters: &Parameters<Rational>, unknown: Unknown) -> Self {
        let is_velocity = unknown == Unknown::LoadingVelocity;
        let at = |value: u32| {
            let value = Rational::from(value);
            let factor = if is_velocity { value.clone() } else { Rational::from(1) };
            at(parameters, unknown, &value)
                .characteristic_cubic_per_s()
                .map(|coefficient| coefficient * &factor)
        };
        let [first, second, third] = [at(1), at(2), at(3)];
        let cubic = [0, 1, 2, 3].map(|power| {
            let [one, two, three] = [&first, &second, &third].map(|cubic| cubic[power].clone());
            // Eq 8 has no value at V0 = 0. A polynomial of degree 2 has the third difference zero.
            let zero = (one.clone() - &two) * 3_u32 + three;
            UnivariatePolynomial::interpolating(vec![zero, one, two])
        });
        Self { cubic, degree: if is_velocity { 2 } else { 1 } }
    }

    /// A polynomial function of the unknown and the coefficients, of this degree in the coefficients.
    ///
    /// The unknown itself may raise the degree of the result by one for each of them.
    pub(super) fn along(
        &self,
        degree: usize,
        function: impl Fn(&Rational, &[Rational; 4]) -> Rational,
    ) -> UnivariatePolynomial {
        let value = |x: usize| {
            let x = Rational::from(x);
            function(&x, &self.cubic.each_ref().map(|coefficient| coefficient.evaluate(&x)))
        };
        UnivariatePolynomial::interpolating((0..=degree * (self.degree + 1)).map(value).collect())
    }
}

/// The parameters with another value of the unknown.
pub(super) fn at(point: &Parameters<Rational>, unknown: Unknown, value: &Rational) -> Parameters<Rational> {
    let mut values: [Rational; 7] = point.clone().into();
    values[Quantity::from(unknown) as usize].clone_from(value);
    values.into()
}

/// The coefficients of the cubic in h = s − `origin`.
pub(super) fn shifted([c0, c1, c2, c3]: &[Rational; 4], origin: &Rational) -> [Rational; 4] {
    let steep = Rational::from(c3 * origin);
    let value = ((steep.clone() + c2) * origin + c1) * origin + c0;
    let slope = (steep.clone() * 3_u32 + Rational::from(c2 * 2_u32)) * origin + c1;
    [value, slope, steep * 3_u32 + c2, c3.clone()]
}

/// c1c2 − c0c3: zero where two roots sum to zero.
pub(super) fn hurwitz([c0, c1, c2, c3]: &[Rational; 4]) -> Rational {
    Rational::from(c1 * c2) - Rational::from(c0 * c3)
}

/// H = c2² − 3c1c3: half the sum of the squared differences of the roots, times c3².
pub(super) fn spread([_, c1, c2, c3]: &[Rational; 4]) -> Rational {
    c2.square() - Rational::from(c1 * c3) * 3_u32
}

/// 2c2³ − 9c1c2c3 + 27c0c3²: zero where one root is the mean of all three.
pub(super) fn skew([c0, c1, c2, c3]: &[Rational; 4]) -> Rational {
    (c2.square() * 2_u32 - Rational::from(c1 * c3) * 9_u32) * c2 + Rational::from(c0 * c3) * c3 * 27_u32
}

/// A.
pub(super) fn lead([.., lead]: &[Rational; 4]) -> &Rational {
    lead
}
