//! Both arcs of the boundary in a positive parameter, without a single cancellation.
//!
//! With q = √β the double root of the curve (`curve`) runs over
//!
//! * upper arc: r = ρ(q−1), ρ = λ/(1+λ), and y = 1 + λq;
//! * lower arc: r = −ρ(q+1), ρ = (1+λ)/λ, and y = 1 + q + λq,
//!
//! for 0 < λ < ∞: λ → ∞ is the quasi-static end (eqs 15, 16), λ → 0 the inertial one (eqs 18, 20). Every quantity below
//! is then a quotient of polynomials in λ and q with positive coefficients, except d = q − 1 = (β−1)/(q+1) and the
//! errors of the lower arc, which do change sign. A relative error of a few units in the last place follows for any
//! β, a ≈ b included.

use rug::Rational;

use crate::friction::Groups;
use crate::number::{Ball, Field, Real};
use crate::stability::Arc;

/// A place on the boundary: everything that depends on the arc, λ and β alone.
#[derive(Debug, Clone)]
pub struct ArcPoint<R> {
    /// The double root r of eq 8, in units of V0/D_c.
    pub double_root: R,
    /// η, κ and β.
    pub groups: Groups<R>,
    /// η/κ = (V0/D_c)²·M/K: the square of the velocity in units of D_c·√(K/M).
    pub velocity_squared: R,
}

/// √β and what follows from it, shared by all points of one β.
#[derive(Debug, Clone)]
pub struct ArcFrame<R> {
    /// q = √β.
    pub root_ratio: R,
    /// q + 1.
    pub sum: R,
    /// q − 1 = (β − 1)/(q + 1).
    pub difference: R,
}

impl<R: Field> ArcFrame<R> {
    /// The frame of β, given β − 1 (which the caller knows without cancellation) and √β.
    pub(crate) fn new(excess: R, root_ratio: R) -> Self {
        let sum = root_ratio.clone() + R::from(1);
        let difference = excess / &sum;
        Self { root_ratio, sum, difference }
    }

    /// The point of the arc at the parameter λ > 0. The upper arc degenerates (κ = 0) for a = b.
    pub(crate) fn point(&self, arc: Arc, parameter: &R) -> ArcPoint<R> {
        let terms = self.terms(arc, parameter);
        let double_root = self.double_root(arc, &terms);
        let (scaled, cubic) = (terms.scaled_slope(), double_root.square() * &terms.cubic);
        ArcPoint {
            groups: Groups {
                inertial_parameter: terms.linear.clone() / &scaled,
                stiffness_group: cubic.clone() / scaled,
                effect_ratio: self.root_ratio.square(),
            },
            velocity_squared: terms.linear / cubic,
            double_root,
        }
    }

    /// (1/κ, η/κ) of the same point: all that its coordinates need.
    pub(crate) fn place(&self, arc: Arc, parameter: &R) -> (R, R) {
        let terms = self.terms(arc, parameter);
        let cubic = self.double_root(arc, &terms).square() * &terms.cubic;
        (terms.scaled_slope() / &cubic, terms.linear / cubic)
    }

    fn double_root(&self, arc: Arc, terms: &Terms<R>) -> R {
        match arc {
            Arc::Upper => terms.slope.clone() * &self.difference,
            Arc::Lower => -(terms.slope.clone() * &self.sum),
        }
    }

    /// κ_asymptote/κ − 1 = σ_exact/σ_asymptote − 1 at the same V0, for eq 15 (upper arc) or eq 16 (lower arc).
    ///
    /// Positive all along the upper arc; changes sign once on the lower one.
    pub(crate) fn quasi_static_error(&self, arc: Arc, parameter: &R) -> R {
        let terms = self.terms(arc, parameter);
        let x = self.scaled(parameter);
        let one = R::from(1);
        match arc {
            Arc::Upper => {
                let numerator = R::from(2) + parameter + R::from(3) * &x + R::from(2) * parameter * &x;
                numerator / (parameter.clone() * &terms.cubic)
            }
            Arc::Lower => {
                let next = parameter.clone() + &one;
                let numerator = parameter.clone() - one + next.clone() * (R::from(2) * &x - &self.root_ratio);
                numerator / (next * &terms.cubic)
            }
        }
    }

    /// (V_exact/V_asymptote)² − 1 at the same σ, for eq 18 (upper arc) or eq 20 (lower arc).
    ///
    /// Negative all along the upper arc; changes sign once on the lower one.
    pub(crate) fn inertial_error_of_square(&self, arc: Arc, parameter: &R) -> R {
        let terms = self.terms(arc, parameter);
        let x = self.scaled(parameter);
        let (q, sum) = (&self.root_ratio, &self.sum);
        let x_squared = x.square();
        let y_fourth = terms.y.square().square();
        match arc {
            Arc::Upper => {
                let low = q.clone() * sum * (R::from(2) + R::from(6) * &x);
                let middle = R::from(4) * &x_squared * q * (sum.clone() + R::from(1));
                let high = sum.square() * &x * &x_squared;
                -(x * (low + middle + high) / (sum.square() * y_fourth))
            }
            Arc::Lower => {
                let low = R::from(2) * sum.square() * sum;
                let middle = R::from(6) * sum.square() * &x + R::from(4) * sum * &x_squared;
                let high = x_squared * &x;
                x * ((low + middle) * q - high) / y_fourth
            }
        }
    }

    /// ∂ ln σ/∂ ln(parameter) of the boundary at given V0, for a, b, D_c, K, M and V0.
    ///
    /// Those for a and b have the sum −1. On the upper arc they grow like 1/(√β − 1) as a → b.
    /// From r²dη + dκ = (r/(r+1))dβ along the boundary; the seven inputs enter η, κ and β as powers.
    pub(crate) fn sensitivity(&self, arc: Arc, parameter: &R) -> [R; 6] {
        let x = self.scaled(parameter);
        let (one, q) = (R::from(1), &self.root_ratio);
        let twice_x = x.clone() + &x;
        let near = x.clone() + &one;
        let far = x + &self.sum;
        let mass = (self.sum.clone() + &twice_x) / (R::from(2) * &near * &far);
        let evolution_effect = match arc {
            Arc::Upper => -(q.square() * (parameter.clone() + &one) / (self.difference.clone() * &far)),
            Arc::Lower => -(q.square() * parameter / (self.sum.clone() * &near)),
        };
        let twice_mass = mass.clone() + &mass;
        let direct_effect = -(evolution_effect.clone() + &one);
        let (critical_slip_distance, stiffness) = (one.clone() - &twice_mass, one - &mass);
        [direct_effect, evolution_effect, critical_slip_distance, stiffness, mass, twice_mass]
    }

    /// λq.
    fn scaled(&self, parameter: &R) -> R {
        parameter.clone() * &self.root_ratio
    }

    fn terms(&self, arc: Arc, parameter: &R) -> Terms<R> {
        let x = self.scaled(parameter);
        let next = parameter.clone() + R::from(1);
        let twice_x = x.clone() + &x;
        let linear = self.sum.clone() + &twice_x;
        let cubic = twice_x * (x.clone() + &self.root_ratio) + &linear;
        let (slope, y) = match arc {
            Arc::Upper => (parameter.clone() / &next, x + R::from(1)),
            Arc::Lower => (next / parameter, x + &self.sum),
        };
        Terms { slope, y, linear, cubic }
    }
}

impl ArcFrame<Ball> {
    /// The frame of a rational β; β − 1 is rounded once, however small it is.
    #[must_use]
    pub fn of_rational(effect_ratio: &Rational, bits: u32) -> Self {
        let excess = Ball::from_rational(&Rational::from(effect_ratio - 1_u32), bits);
        Self::new(excess, Ball::from_rational(effect_ratio, bits).sqrt())
    }
}

/// The factors that η, κ, the roots and the errors are made of.
struct Terms<R> {
    /// ρ.
    slope: R,
    /// y.
    y: R,
    /// 1 + q + 2λq.
    linear: R,
    /// 1 + q + 2λq + 2λ(1+λ)q².
    cubic: R,
}

impl<R: Field> Terms<R> {
    /// 2ρy².
    fn scaled_slope(&self) -> R {
        let half = self.slope.clone() * self.y.square();
        half.clone() + half
    }
}

#[cfg(test)]
mod tests;
