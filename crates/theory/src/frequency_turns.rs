//! Where the frequency falls with velocity: the turning points of max Im(s) along a line of constant normal stress.
//!
//! The roots x ± i√w of eq 8 in groups, with u = |1 + p|² = (1 + x)² + w, determine η and κ: both stand in eq 8 linearly. At
//! constant κ (constant σ) the square of the frequency is proportional to y = η w, so a turning point is a zero of the Jacobian
//! of (κ, y) in (x, u). Eliminating u leaves a polynomial in x and κ. The number of its physical roots is constant between the
//! roots of its discriminant, so one exact count in each interval of κ decides them all.

use std::collections::BTreeMap;

use rug::Rational;

use crate::boundary::solve_for_groups;
use crate::notation::{coefficients, formula, rational};
use crate::{Equations, Role};
use slipmode_algebra::{
    AlgebraicRoot, Expression, Polynomial, Proof, RationalFunction, Refutation, Symbol, UnivariatePolynomial,
    discriminant, in_one_variable, nonzero_real_roots, resultant,
};
use slipmode_core::number::{Ball, Field};

/// Bits of the enclosures: far more than the separation of the roots of polynomials of this degree takes.
const BITS: u32 = 512;

/// An open interval of the stiffness group κ = K D_c/(a σ) in which the number of turning points is the same.
#[derive(Debug, Clone)]
pub struct TurningInterval {
    /// Its lower end, zero for the first.
    pub from: Ball,
    /// Its upper end; none for the last.
    pub to: Option<Ball>,
    /// At how many velocities max Im(s) > 0 turns from rising to falling or back.
    pub turning_points: usize,
}

/// The intervals of κ over the whole axis, for given β = b/a; neighbours with equal counts are joined.
///
/// # Errors
/// When eq 8 is no cubic that is linear in η and κ, or a root cannot be told from a limit of the physical range.
pub fn intervals(equations: &Equations, beta: &Rational) -> Result<Vec<TurningInterval>, Refutation> {
    let turns = Turns::new(equations, beta)?;
    let (ends, samples) = turns.intervals_of_equal_count()?;
    let mut found: Vec<TurningInterval> = Vec::new();
    for (at, inside) in samples.into_iter().enumerate() {
        let turning_points = turns.count(&inside)?;
        let to = ends.get(at).cloned();
        match found.last_mut().filter(|last| last.turning_points == turning_points) {
            Some(last) => last.to = to,
            None => {
                let from = at.checked_sub(1).map_or_else(|| Ball::from(0), |before| ends[before].clone());
                found.push(TurningInterval { from, to, turning_points });
            }
        }
    }
    Ok(found)
}

/// What eq 8 says of turning points at one β.
struct Turns {
    proof: Proof,
    beta: Rational,
    /// η(x, u).
    inertial_parameter: Expression,
    /// The numerator of κ(x, u) − κ, in x, u and κ.
    level: Polynomial,
    /// The numerator of the Jacobian of (κ, y) in (x, u).
    jacobian: Polynomial,
    /// Its zeros at given κ: a polynomial in x and κ, without the factors that are zero at u = 0 or x = 0 for every κ.
    eliminated: Polynomial,
}

impl Turns {
    fn new(equations: &Equations, beta: &Rational) -> Result<Self, Refutation> {
        let proof = Proof::new("frequency-turns", "");
        let [x, u, kappa] = ["x", "u", "kappa"].map(Symbol::from);
        let [eta_at, kappa_at] = groups_of_pair(equations, &proof, beta)?;
        let square = in_place(&proof, "u - (1 + x)^2")?;
        let y = &eta_at * &square;
        let cross =
            |left: &RationalFunction, right: &RationalFunction| &left.derivative(&x) * &right.derivative(&u);
        let jacobian = (&cross(&kappa_at, &y) - &cross(&y, &kappa_at)).numerator().clone();
        let level = (&kappa_at - &RationalFunction::variable("kappa")).numerator().clone();
        let product = resultant(&jacobian, &level, &u);
        let eliminated = product.without_content(kappa.as_ref());
        if eliminated.degree(&x) == 0 {
            return Err(undecided(&proof, "no turning point at any κ"));
        }
        let inertial_parameter = Expression::from(&eta_at);
        Ok(Self { proof, beta: beta.clone(), inertial_parameter, level, jacobian, eliminated })
    }

    /// The ends of the intervals of κ > 0 in which the count is constant, and a value inside each.
    ///
    /// The count changes where roots x meet, or pass through infinity, x = 0, w = 0 or η = 0.
    fn intervals_of_equal_count(&self) -> Result<(Vec<Ball>, Vec<Rational>), Refutation> {
        let (x, kappa) = (Symbol::from("x"), Symbol::from("kappa"));
        let by_power = self.eliminated.coefficients(&x);
        let [Some(first), Some(last)] = [by_power.first(), by_power.last()] else {
            return Err(undecided(&self.proof, "no coefficient"));
        };
        let meet = &(&discriminant(&self.eliminated, &x) * first) * last;
        let no_frequency = in_place(&self.proof, "(1 + x)^2")?.numerator().clone();
        let limits = [no_frequency, Polynomial::constant(self.beta.clone())];
        let changes = limits.iter().fold(meet, |changes, limit| &changes * &self.turns_at(limit));
        let changes = in_one_variable(&changes, &kappa).filter(|changes| !changes.is_zero());
        let changes = changes.ok_or_else(|| undecided(&self.proof, "roots that meet at every κ"))?;
        let isolated = AlgebraicRoot::positive(&changes);
        let ends = isolated.iter().map(|root| root.enclosed(BITS)).collect();
        let edges: Vec<Rational> = isolated.iter().flat_map(AlgebraicRoot::ends).collect();
        let mut samples = Vec::with_capacity(isolated.len() + 1);
        samples.push(edges.first().map_or_else(|| Rational::from(1), |first| first.clone() / 2));
        samples.extend(edges[1.min(edges.len())..].chunks(2).map(|gap| match gap {
            [upper, lower] => Rational::from(upper + lower) / 2,
            _ => gap[0].clone() * 2,
        }));
        samples.truncate(isolated.len() + 1);
        Ok((ends, samples))
    }

    /// A polynomial in κ that is zero where a turning point has this value of u.
    fn turns_at(&self, limit: &Polynomial) -> Polynomial {
        let [x, u, kappa] = ["x", "u", "kappa"].map(Symbol::from);
        let [jacobian, level] = [&self.jacobian, &self.level].map(|part| part.substitute(&u, limit));
        resultant(&jacobian, &level.without_content(kappa.as_ref()), &x)
    }

    /// The number of turning points with η > 0 and w > 0 at one κ.
    fn count(&self, kappa: &Rational) -> Result<usize, Refutation> {
        let (x, u) = (Symbol::from("x"), Symbol::from("u"));
        let value = Polynomial::constant(kappa.clone());
        let at_kappa = |part: &Polynomial| part.substitute(&Symbol::from("kappa"), &value);
        let roots_of = in_one_variable(&at_kappa(&self.eliminated), &x);
        let roots_of = roots_of.ok_or_else(|| undecided(&self.proof, "not a polynomial in x"))?;
        let in_u = |part: &Polynomial| -> Option<Vec<UnivariatePolynomial>> {
            at_kappa(part).coefficients(&u).iter().map(|part| in_one_variable(part, &x)).collect()
        };
        let parts = in_u(&self.jacobian).zip(in_u(&self.level));
        let (jacobian, level) = parts.ok_or_else(|| undecided(&self.proof, "not polynomials in x and u"))?;
        let mut count = 0;
        for root in nonzero_real_roots(&roots_of, BITS) {
            let at =
                |part: &UnivariatePolynomial| part.evaluate_with(&root, |c| Ball::from_rational(c, BITS));
            let common = common_root(jacobian.iter().map(at).collect(), level.iter().map(at).collect());
            let physical = common.and_then(|common| self.is_physical(&root, &common));
            let physical =
                physical.ok_or_else(|| undecided(&self.proof, "a root at a limit of the range"))?;
            count += usize::from(physical);
        }
        Ok(count)
    }

    /// Whether u > 0, w > 0 and η > 0; none where a sign is not certain.
    fn is_physical(&self, x: &Ball, u: &Ball) -> Option<bool> {
        let beta = Ball::from_rational(&self.beta, BITS);
        let values = [("x", x), ("u", u), ("beta", &beta)];
        let values = BTreeMap::from(values.map(|(name, value)| (Symbol::from(name), value.clone())));
        let square = u.clone() - (Ball::from(1) + x.clone()).square();
        let eta = self.inertial_parameter.enclosed(&values, BITS)?;
        let signs: Option<Vec<_>> = [u.clone(), square, eta].iter().map(Ball::sign).collect();
        Some(signs?.iter().all(|sign| sign.is_gt()))
    }
}

/// η and κ as functions of x and u, from the real and the imaginary part of eq 8 at p = x + i√w.
fn groups_of_pair(
    equations: &Equations,
    proof: &Proof,
    beta: &Rational,
) -> Result<[RationalFunction; 2], Refutation> {
    let cited = equations.numbers([Role::Characteristic]);
    let [c0, c1, c2, c3]: [Expression; 4] = coefficients(proof, &cited, &equations.cubic(), "p")?;
    let (two, three) = (Expression::integer(2), Expression::integer(3));
    let (x, w) = (formula("x"), formula("(u - (1 + x)^2)"));
    let square = || x.clone().power(2);
    let real = c0
        + c1.clone() * x.clone()
        + c2.clone() * (square() - w.clone())
        + c3.clone() * (x.clone().power(3) - three.clone() * x.clone() * w.clone());
    let imaginary = c1 + two * c2 * x.clone() + c3 * (three * square() - w);
    let beta = Expression::Number(beta.clone());
    solve_for_groups(proof, &cited, [&real.with("beta", &beta), &imaginary.with("beta", &beta)])
}

fn in_place(proof: &Proof, text: &str) -> Result<RationalFunction, Refutation> {
    rational(proof, &[], &formula(text), &slipmode_algebra::Domain::default())
}

fn undecided(proof: &Proof, found: &str) -> Refutation {
    proof.refute("the turning points of the frequency are counted", &[], found)
}

/// The one common root of two polynomials, as the root of the last remainder of degree 1 in Euclid's algorithm.
///
/// None when a leading coefficient may be zero.
fn common_root(mut left: Vec<Ball>, mut right: Vec<Ball>) -> Option<Ball> {
    if left.len() < right.len() {
        std::mem::swap(&mut left, &mut right);
    }
    while right.len() > 2 {
        while left.len() >= right.len() {
            let (lead, divisor) = (left.pop()?, right.last()?.clone());
            divisor.sign().filter(|sign| sign.is_ne())?;
            let factor = lead / divisor;
            let shift = left.len() + 1 - right.len();
            for (place, coefficient) in right.iter().take(right.len() - 1).enumerate() {
                left[shift + place] = left[shift + place].clone() - factor.clone() * coefficient;
            }
        }
        std::mem::swap(&mut left, &mut right);
    }
    let [constant, slope] = <[Ball; 2]>::try_from(right).ok()?;
    slope.sign().filter(|sign| sign.is_ne())?;
    Some(-constant / slope)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::tests::paper;

    /// max Im(s)² M D_c²/(a σ …) = η w of eq 8 in groups, by Cardano's formula in 64 bits; zero for three real roots.
    fn frequency_squared(beta: f64, kappa: f64, eta: f64) -> f64 {
        let [c2, c1, c0] = [(1.0 + eta) / eta, (kappa + 1.0 - beta) / eta, kappa / eta];
        let (p, q) = (c1 - c2 * c2 / 3.0, 2.0 * c2.powi(3) / 27.0 - c1 * c2 / 3.0 + c0);
        let inside = q * q / 4.0 + p.powi(3) / 27.0;
        let [one, other] = [1.0, -1.0].map(|sign| libm::cbrt(-q / 2.0 + sign * inside.max(0.0).sqrt()));
        0.75 * eta * (one - other).powi(2) * f64::from(inside > 0.0)
    }

    /// How often the frequency turns between η = 1e-6 and 1e4, and whether it is zero in between.
    fn scanned(beta: f64, kappa: f64) -> (usize, bool) {
        let values: Vec<f64> = (0..40_000)
            .map(|i| frequency_squared(beta, kappa, libm::exp10(-3.0 + f64::from(i) / 8e3)))
            .collect();
        let rises: Vec<bool> =
            values.windows(2).filter(|pair| pair[0] != pair[1]).map(|pair| pair[0] < pair[1]).collect();
        (rises.windows(2).filter(|pair| pair[0] != pair[1]).count(), values.contains(&0.0))
    }

    #[test]
    fn the_counts_are_those_of_a_scan_of_the_roots() {
        // For a < b and for a > b: 0 turns, then 2, then from the cusp on a fall to zero and a rise from zero.
        for (beta, sides) in [((3, 2), 0.995), ((2, 3), 0.995)] {
            let beta = Rational::from(beta);
            let found = intervals(&paper(), &beta).unwrap();
            let counts: Vec<usize> = found.iter().map(|one| one.turning_points).collect();
            assert_eq!(counts, [0, 2, 1, 0], "{found:?}");
            let edge = found[1].from.to_f64();
            let near = beta.to_f64();
            assert_eq!(scanned(near, edge * sides), (0, false), "below {edge}");
            assert_eq!(scanned(near, edge / sides), (2, false), "above {edge}");
            // One turn with a frequency above zero; the scan sees another one where it is zero.
            assert_eq!(scanned(near, found[2].from.to_f64() / sides), (2, true), "past the cusp");
        }
    }

    #[test]
    fn the_ends_are_those_of_an_elimination_in_pari_the_cusp_and_eq_16() {
        let found = intervals(&paper(), &Rational::from((3, 2))).unwrap();
        // PARI/GP: the discriminant in w of the discriminant in V0² of the equation of squared differences.
        let edge = slipmode_core::number::parse_decimal("4.1927465532239286612794956357721236339").unwrap();
        let near = (found[1].from.clone() - Ball::from_rational(&edge, BITS)).upper().to_f64().abs();
        assert!(near < 1e-36, "{near}");
        let ends: Vec<f64> = found[2..].iter().map(|one| one.from.to_f64()).collect();
        // The cusp: β = x³/(3x + 2), κ = (1 + x)³/(3x + 2).
        let x = (0..60).fold(2.0_f64, |x, _| libm::cbrt(1.5 * (3.0 * x + 2.0)));
        for (end, expected) in
            ends.iter().zip([(1.0 + x).powi(3) / (3.0 * x + 2.0), (1.0 + 1.5_f64.sqrt()).powi(2)])
        {
            assert!((end / expected - 1.0).abs() < 1e-14, "{end} {expected}");
        }
    }
}
