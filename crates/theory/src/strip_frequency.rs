//! The largest frequency between eqs 16 and 15: in closed form without inertia, and by exact algebra with it.
//!
//! At given V0 the groups are κ and η = λκ with λ = (V0/(ω_n D_c))². A pair x ± iy of eq 8 has ω²/ω_n² = λy². For a given value
//! of this ratio both equations for x and y are linear in κ, which leaves one polynomial in x and λ.

use crate::notation::{coefficients, formula, in_groups, rational};
use crate::{Equations, Role};
use rug::Float;
use slipmode_algebra::{
    AlgebraicRoot, Coefficients, Domain, Expression, Polynomial, Proof, Symbol, UnivariatePolynomial,
    discriminant, horner, in_one_variable, nonzero_real_roots, resultant,
};
use slipmode_core::number::{Ball, Rational};

/// The least λ = (V0/(ω_n D_c))² at which a point between eqs 16 and 15 has the given ω²/ω_n², and the κ of that point.
#[derive(Debug, Clone)]
pub struct FirstReach {
    /// (V0/(ω_n D_c))².
    pub velocity_squared: Ball,
    /// κ = K D_c/(aσ), where the point lies inside and not on eq 16 or 15.
    pub stiffness_group: Option<Ball>,
}

/// The first velocity at which the ratio is reached, decided by counting solutions between all λ where their number changes.
///
/// None when it is not reached, or the equations have another form.
#[must_use]
pub fn first_reach(
    equations: &Equations,
    effect_ratio: &Rational,
    square_ratio: &Rational,
    bits: u32,
) -> Option<FirstReach> {
    let level = Level::of(equations, effect_ratio, square_ratio)?;
    let places = AlgebraicRoot::positive(&level.changes()?);
    let [first, _] = places.first()?.ends();
    if !level.solutions(&(first / 2_u32), bits).is_empty() {
        return None;
    }
    let after = |index: usize| {
        let [_, high] = places[index].ends();
        let next =
            places.get(index + 1).map_or_else(|| Rational::from(&high * 2), |next| next.ends()[0].clone());
        Rational::from(&high + &next) / 2_u32
    };
    let born = (0..places.len()).find(|index| !level.solutions(&after(*index), bits).is_empty())?;
    let velocity_squared = places[born].enclosed(bits);
    // Two solutions just above this λ enclose the one at which they meet.
    let above = velocity_squared.upper().to_rational()? * (Rational::from(1) + (Rational::from(1) >> bits));
    if above > after(born) {
        return None;
    }
    let met = <[Ball; 2]>::try_from(level.solutions(&above, 2 * bits)).ok();
    Some(FirstReach { velocity_squared, stiffness_group: met.map(|[one, other]| enclosing(one, &other)) })
}

/// A ball that contains both.
fn enclosing(one: Ball, other: &Ball) -> Ball {
    let half = (one.clone() - other) / Ball::from(2);
    let radius = half.lower().abs().max(&half.upper().abs());
    (one + other) / Ball::from(2) + Ball::new(Float::new(half.precision_bits()), radius)
}

/// The polynomials of one ratio ω²/ω_n²: κ = −rest/slope, level = 0 for the pairs, strip < 0 between eqs 16 and 15.
struct Level {
    slope: Polynomial,
    rest: Polynomial,
    level: Polynomial,
    strip: Polynomial,
}

impl Level {
    /// From eq 8 at p = x + iy with λy² = ratio, and from the discriminant of eq 14.
    fn of(equations: &Equations, effect_ratio: &Rational, square_ratio: &Rational) -> Option<Self> {
        let proof = Proof::new("strip-frequency", "");
        let [cited, without_inertia] =
            equations.numbers([Role::Characteristic, Role::QuasiStaticCharacteristic]);
        let beta = Expression::Number(effect_ratio.clone());
        let p = Symbol::from("p");
        let value = equations.cubic().with("beta", &beta).with("eta", &formula("lambda*kappa"));
        let slope = value.derivative(&p);
        let curvature = slope.derivative(&p);
        let ratio = || Expression::Number(square_ratio.clone());
        let real = formula("lambda") * value - ratio() * curvature.clone() / formula("2");
        let imaginary = formula("lambda") * slope - ratio() * curvature.derivative(&p) / formula("6");
        let linear = |part: Expression| {
            let function =
                rational(&proof, &[cited], &part.with("p", &formula("x")), &Domain::default()).ok()?;
            let parts = function.numerator().coefficients(&Symbol::from("kappa"));
            <[Polynomial; 2]>::try_from(parts).ok().filter(|_| function.denominator().as_constant().is_some())
        };
        let ([rest, slope], [other_rest, other_slope]) = (linear(imaginary)?, linear(real)?);
        let quadratic = in_groups(&equations.residual(Role::QuasiStaticCharacteristic));
        let [c0, c1, c2]: [Expression; 3] = coefficients(&proof, &[without_inertia], &quadratic, "p").ok()?;
        let discriminant = (c1.power(2) - formula("4") * c2 * c0).with("beta", &beta);
        let strip = rational(&proof, &[without_inertia], &discriminant, &Domain::default()).ok()?;
        let [e0, e1, e2] =
            <[Polynomial; 3]>::try_from(strip.numerator().coefficients(&Symbol::from("kappa"))).ok()?;
        let strip = &(&(&e2 * &rest.pow(2)) - &(&e1 * &(&rest * &slope))) + &(&e0 * &slope.pow(2));
        let level = &(&slope * &other_rest) - &(&other_slope * &rest);
        Some(Self { slope, rest, level, strip })
    }

    /// Where the number of solutions in the strip can change: they are born in pairs, come from infinity or cross an edge.
    fn changes(&self) -> Option<UnivariatePolynomial> {
        let x = Symbol::from("x");
        let leading = self.level.coefficients(&x).pop()?;
        let all = [discriminant(&self.level, &x), resultant(&self.level, &self.strip, &x), leading];
        let product = all.iter().try_fold(UnivariatePolynomial::from_integers(&[1]), |product, change| {
            Some(product.times(&in_one_variable(change, &"lambda".into())?.squarefree()))
        })?;
        Some(product.squarefree())
    }

    /// κ of the points between eqs 16 and 15 that have the ratio at this λ.
    fn solutions(&self, lambda: &Rational, bits: u32) -> Vec<Ball> {
        let value = Polynomial::constant(lambda.clone());
        let at = |polynomial: &Polynomial| {
            in_one_variable(&polynomial.substitute(&Symbol::from("lambda"), &value), &"x".into())
        };
        let all = [&self.level, &self.strip, &self.rest, &self.slope].map(at);
        let [Some(level), Some(strip), Some(rest), Some(slope)] = all else { return Vec::new() };
        let ball = |polynomial: &UnivariatePolynomial, x: &Ball| horner(polynomial.at_precision(2 * bits), x);
        let within = |x: &Ball| ball(&strip, x).sign() == Some(std::cmp::Ordering::Less);
        let all = nonzero_real_roots(&level, bits).into_iter().filter(within);
        all.map(|x| -(ball(&rest, &x) / ball(&slope, &x))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::tests::paper;

    /// The largest λ y² between eqs 16 and 15 on a grid of κ: y from the only real root of eq 8, by bisection.
    fn largest(lambda: f64, beta: f64) -> (f64, f64) {
        let root = beta.sqrt();
        let [low, high] = [(root - 1.0) * (root - 1.0), (root + 1.0) * (root + 1.0)];
        let at = |kappa: f64| {
            let eta = lambda * kappa;
            let value = |p: f64| ((eta * p + 1.0 + eta) * p + kappa + 1.0 - beta) * p + kappa;
            let (mut left, mut right) = (-2.0 / eta - 10.0, -1.0);
            for _ in 0..200 {
                let middle = 0.5 * (left + right);
                *(if value(middle) < 0.0 { &mut left } else { &mut right }) = middle;
            }
            let (sum, product) = (-(1.0 + eta) / eta - left, -kappa / (eta * left));
            (lambda * (product - 0.25 * sum * sum), kappa)
        };
        let places = (1..100_000).map(|i| at(low + (high - low) * f64::from(i) / 100_000.0));
        places.fold((0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best })
    }

    #[test]
    fn a_ratio_is_first_reached_where_a_scan_of_the_strip_first_finds_it() {
        for (beta, ratio) in [((3, 2), (1, 100)), ((11, 10), (1, 100)), ((5, 1), (1, 100)), ((3, 2), (1, 4))]
        {
            let [beta, ratio] = [beta, ratio].map(Rational::from);
            let found = first_reach(&paper(), &beta, &ratio, 80).expect("reached");
            let lambda = found.velocity_squared.to_f64();
            let [beta, ratio] = [beta.to_f64(), ratio.to_f64()];
            assert!(largest(lambda * 0.999, beta).0 < ratio, "{beta} {ratio} {lambda}");
            let (above, place) = largest(lambda * 1.001, beta);
            assert!(above > ratio, "{beta} {ratio} {lambda} {above}");
            // A ratio that is reached on an edge is reached on eq 16.
            let edge = (beta.sqrt() + 1.0) * (beta.sqrt() + 1.0);
            let kappa = found.stiffness_group.map_or(edge, |kappa| kappa.to_f64());
            assert!((place / kappa - 1.0).abs() < 0.05, "{beta} {ratio}: {place} against {kappa}");
        }
    }

    #[test]
    fn at_low_velocity_the_first_reach_is_that_without_inertia() {
        let (beta, ratio) = (Rational::from((3, 2)), Rational::from((1, 1_000_000)));
        let found = first_reach(&paper(), &beta, &ratio, 80).expect("reached");
        // ratio = λβ (1 + 2λ(1 + β) + …) at κ = 1 + β.
        assert!((found.velocity_squared.to_f64() * 1.5e6 - 1.0).abs() < 1e-5);
        assert!((found.stiffness_group.expect("inside").to_f64() - 2.5).abs() < 1e-3);
    }
}
