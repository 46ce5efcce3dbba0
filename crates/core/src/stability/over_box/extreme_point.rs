//! Which end of a parameter's range an extreme value needs, by two roots.
//!
//! A parameter p changes a simple root s of eq 8, f(s) = 0, by ds/dp = −G/f′(s) with G = ∂f/∂p at s. For a pair X ± iω with the third
//! root s₃, f′(s) = 2iωm (s − s₃), so that dX/dp has the sign of −Im(G (s̄ − s₃))/ω, and dω/dp that of Re(G (s̄ − s₃)). A real root above the
//! others, or s₃ beside a pair, has f′ > 0, and moves with the sign of −G.
//!
//! With r = V0/D_c and δ = D_c/σ, f = (s + r)(m s² + k) + s (a s/r + a − b)/δ. Up to positive factors G is s + r for k, s² (s + r) for m,
//! s (s + r) for a, −s for b, s (a s + (a − b) r) for σ, m s² + k − a s²/(δr²) for V0, and −r (m s² + k) − (a − b) s/δ for D_c. As f = 0, the last two
//! are b r² s/(s + r) − a s (s + r) and b s²/(s + r), too: where one form's terms cancel, the other's do not. With N = X² + ω² the third root is −r/h for h = mN/k, which is next to 1 for a slider that swings as on its spring alone: what
//! cancels there is written with 1 − h.
//!
//! Where a quantity is extreme, no parameter inside its range changes it. A largest real part that two roots have in common is least only
//! where no parameter lowers both. A double root X parts like ±√(−G dp), so that the largest real part rises for one sign of dp; for the other
//! it changes as the pair's.

use super::corners::{A, B, D, K, M, S, V};
use super::root_discs::Values;
use crate::number::Interval;

/// What is known of two roots and of the parameters at a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known {
    /// X and ω², or two real roots.
    pub roots: [Interval; 2],
    /// r and δ.
    pub rate: Interval,
    pub delta: Interval,
    /// a, b, k and m.
    pub friction: [Interval; 2],
    pub stiffness: Interval,
    pub mass: Interval,
    /// h.
    pub share: Interval,
}

impl Known {
    /// s₃.
    pub(super) fn third(&self) -> Interval {
        -(self.rate / self.share)
    }

    /// How each parameter changes X, up to positive factors.
    pub(super) fn effects_on_real_part(&self) -> Values {
        let Self { roots: [x, square], rate, delta, friction: [a, b], stiffness, mass, share } = *self;
        let (third, rest) = (self.third(), Interval::point(1.0) - share);
        let product = x.square() + square;
        let from_pole = (x + rate).square() + square;
        let twice = x * third * 2.0;
        let of_a = rate * third + twice - product;
        let mut effects = [Interval::LINE; 7];
        effects[A] = of_a;
        effects[B] = -third;
        effects[K] = -(rate * rest / share);
        effects[M] = twice * rate - x * product * 2.0
            + third * x.square() * 3.0
            + rate * (square * rest / share - x.square());
        effects[S] = a * of_a - b * rate * third;
        let machine = stiffness * rest + mass * twice;
        effects[V] = either(
            machine + a / (delta * rate.square()) * (product - twice),
            b * rate.square() / from_pole * (product + rate * third) - a * of_a,
        );
        effects[D] = either(
            -(product + (product + rate * x * 2.0) / share),
            -(rate * machine + (a - b) / delta * third),
        );
        effects
    }

    /// How each parameter changes ω, up to positive factors.
    pub(super) fn effects_on_imaginary_part(&self) -> Values {
        let Self { roots: [x, square], rate, delta, friction: [a, b], stiffness, mass, share } = *self;
        let (third, rest) = (self.third(), Interval::point(1.0) - share);
        let x_square = x.square();
        let (product, difference) = (x_square + square, x_square - square);
        let from_pole = (x + rate).square() + square;
        let (apart, lead) = (rate - third, product - x * third);
        // N and −ω²/h, times r, are next to one another.
        let of_a = x * product + rate * (x_square - square * rest / share) - third * x * (x + rate);
        let mut effects = [Interval::LINE; 7];
        effects[A] = of_a;
        effects[B] = -lead;
        effects[K] = product + rate * x - third * (x + rate);
        effects[M] =
            product * (difference + rate * x) - third * (x * (x_square - square * 3.0) + rate * difference);
        effects[S] = a * of_a - b * rate * lead;
        let machine = x * (stiffness + mass * product) - third * (stiffness * rest + mass * x_square * 2.0);
        effects[V] = either(
            machine - a / (delta * rate.square()) * (x * product - third * difference),
            b * rate.square() / from_pole * (product * (x + apart) - rate * third * x) - a * of_a,
        );
        effects[D] = either(
            product * (product + apart * x) - rate * third * difference,
            -(rate * machine + (a - b) / delta * lead),
        );
        effects
    }

    /// How each parameter changes a real root that has no greater one beside it, or the one beside a pair, up to positive factors.
    pub(super) fn effects_on_real_root(&self, root: Interval) -> Values {
        let Self { rate, delta, friction: [a, b], stiffness, mass, .. } = *self;
        let square = root.square();
        let from_pole = root + rate;
        let mut effects = [Interval::LINE; 7];
        effects[A] = -(root * from_pole);
        effects[B] = root;
        effects[K] = -from_pole;
        effects[M] = -(square * from_pole);
        effects[S] = -(root * (a * root + (a - b) * rate));
        let machine = stiffness + mass * square;
        effects[V] = either(
            a / (delta * rate.square()) * square - machine,
            root * from_pole * (a * from_pole.square() - b * rate.square()),
        );
        effects[D] = either(-(square * from_pole), rate * machine + (a - b) / delta * root);
        effects
    }
}

/// The one of two forms, with the same sign, that is known.
fn either(one: Interval, other: Interval) -> Interval {
    if one.sign().is_some() { one } else { other }
}

#[cfg(test)]
mod tests {
    use super::super::root_discs::cubic;
    use super::*;
    use crate::number::split_mix::SplitMix64;
    use crate::roots::bounded_roots;

    /// X, ω² and the real root beside them; ω² is negative for real roots.
    fn roots(point: &[f64; 7]) -> [f64; 3] {
        let cubic = cubic(point);
        let real = bounded_roots(cubic).real.value;
        let half_sum = -0.5 * (cubic[2] / cubic[3] + real);
        [half_sum, -cubic[0] / (cubic[3] * real) - half_sum * half_sum, real]
    }

    #[test]
    fn effects_have_the_signs_of_differences_of_roots() {
        let mut random = SplitMix64(8);
        let mut compared = [0; 4];
        while compared.iter().any(|compared| *compared < 300) {
            let point =
                [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0].map(|x| x * libm::exp10(random.unit() - 0.5));
            let [x, square, real] = roots(&point);
            if square.abs() < 0.01 * x * x {
                continue;
            }
            let greater = |[x, square, _]: [f64; 3]| x + (-square).sqrt();
            type Part<'p> = (usize, Values, &'p dyn Fn([f64; 3]) -> f64);
            let [a, b, d, k, m, s, v] = point;
            let [rate, delta, a, b, stiffness, mass] = [v / d, d / s, a, b, k, m].map(Interval::point);
            let share = Interval::point(m * (x * x + square) / k);
            let two_roots = [x, square].map(Interval::point);
            let known = Known { roots: two_roots, rate, delta, friction: [a, b], stiffness, mass, share };
            let of_root = |root| known.effects_on_real_root(Interval::point(root));
            let parts: Vec<Part<'_>> = if square > 0.0 {
                assert!((known.third().middle() / real - 1.0).abs() < 1e-9);
                vec![
                    (0, known.effects_on_real_part(), &|[x, ..]| x),
                    (1, known.effects_on_imaginary_part(), &|[_, square, _]| square),
                    (2, of_root(real), &|[.., real]| real),
                ]
            } else if greater(roots(&point)) > real {
                vec![(3, of_root(greater(roots(&point))), &greater)]
            } else {
                continue;
            };
            for (kind, found, value) in parts {
                for i in 0..7 {
                    let moved = |factor: f64| {
                        let mut moved = point;
                        moved[i] *= factor;
                        value(roots(&moved))
                    };
                    let change = moved(1.0 + 1e-5) - moved(1.0 - 1e-5);
                    // Changes that are lost in rounding or in the second order of the difference say nothing.
                    if change.abs() > 1e-9 * value(roots(&point)).abs() {
                        compared[kind] += 1;
                        let middle = found[i].middle();
                        assert!(middle * change > 0.0, "{kind} {i} {middle} {change} {point:?}");
                    }
                }
            }
        }
    }
}
