//! What is zero where two numbers are roots of eq 8, with its derivatives.

use crate::number::Field;

/// How two roots are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TwoRoots {
    /// A pair X ± i√w, by X and w.
    Pair,
    /// Two real roots, by themselves.
    Real,
}

impl TwoRoots {
    /// 2X and N of such two values and r.
    pub(super) fn sum_and_product<T: Field + Copy>(self, [first, second, _]: &[T; 3]) -> [T; 2] {
        match self {
            Self::Pair => [*first + *first, first.square() + *second],
            Self::Real => [*first + *second, *first * *second],
        }
    }

    /// Q = N + r² + 2rX: the product of the distances of both roots from −r.
    pub(super) fn pole_product<T: Field + Copy>(self, [first, second, rate]: &[T; 3]) -> T {
        let from_pole = *rate + *first;
        match self {
            Self::Pair => from_pole.square() + *second,
            Self::Real => from_pole * (*rate + *second),
        }
    }
}

/// Two roots, r = V0/D_c, δ = D_c/σ, a, b, k, m and m N/k.
pub(super) const VARIABLES: usize = 9;

/// How many conditions there are.
pub(super) const CONDITIONS: usize = 5;

/// What the conditions have in common.
pub(super) struct Terms<'v, T> {
    variables: &'v [T; VARIABLES],
    /// r² and 2rX.
    rate_square: T,
    twice: T,
    /// N and Q.
    product: T,
    from_pole: T,
}

impl<'v, T: Field + Copy> Terms<'v, T> {
    pub(super) fn of(kind: TwoRoots, variables: &'v [T; VARIABLES]) -> Self {
        let [first, second, rate, ..] = *variables;
        let [sum, product] = kind.sum_and_product(&[first, second, rate]);
        let from_pole = kind.pole_product(&[first, second, rate]);
        Self { variables, rate_square: rate.square(), twice: rate * sum, product, from_pole }
    }

    /// The equation for a; that for b; both without k, without m, and without δ.
    pub(super) fn condition(&self, which: usize) -> T {
        let [_, _, _, delta, a, b, k, m, share] = *self.variables;
        let Self { rate_square, twice, product, from_pole, .. } = *self;
        let steep = rate_square + twice;
        match which {
            0 => delta * (rate_square * k - m * steep * product) - a * product,
            1 => delta * from_pole * (k - m * product) - b * product,
            2 => rate_square * b - from_pole * (a + delta * m * twice),
            3 => product * (steep * b - a * from_pole) - delta * k * twice * from_pole,
            _ => b * (rate_square - share * steep) - a * (from_pole - share * from_pole),
        }
    }
}

/// The derivatives of the conditions by each variable.
pub(super) struct Slopes<'v, T> {
    /// The conditions themselves.
    pub(super) terms: Terms<'v, T>,
    /// Of r², 2rX, N and Q by the two roots and r.
    of_terms: [[T; 3]; 4],
}

impl<'v, T: Field + Copy> Slopes<'v, T> {
    pub(super) fn of(kind: TwoRoots, variables: &'v [T; VARIABLES]) -> Self {
        let [first, second, rate, ..] = *variables;
        let [zero, one] = [0, 1].map(T::from);
        let twice_rate = rate + rate;
        let [twice, n, q] = match kind {
            TwoRoots::Pair => {
                let (twice_first, from_pole) = (first + first, rate + first);
                let from_pole = from_pole + from_pole;
                [[twice_rate, zero, twice_first], [twice_first, one, zero], [from_pole, one, from_pole]]
            }
            TwoRoots::Real => {
                let (of_first, of_second) = (rate + first, rate + second);
                let q = [of_second, of_first, of_first + of_second];
                [[rate, rate, first + second], [second, first, zero], q]
            }
        };
        Self { terms: Terms::of(kind, variables), of_terms: [[zero, zero, twice_rate], twice, n, q] }
    }

    /// The derivatives of a condition by r², t = 2rX, n = N and q = Q.
    fn by_terms(&self, which: usize) -> [T; 4] {
        let zero = T::from(0);
        let Terms { variables, rate_square: r2, twice: t, product: n, from_pole: q } = self.terms;
        let [_, _, _, delta, a, b, k, m, share] = *variables;
        let (steep, slack, mass) = (r2 + t, k - m * n, delta * m);
        match which {
            0 => [delta * slack, -(mass * n), -(mass * steep + a), zero],
            1 => [zero, zero, -(mass * q + b), delta * slack],
            2 => [b, -(q * mass), zero, -(a + mass * t)],
            3 => {
                let spring = delta * k;
                [n * b, n * b - spring * q, steep * b - a * q, -(n * a + spring * t)]
            }
            _ => {
                let rest = T::from(1) - share;
                [b * rest, -(b * share), zero, -(a * rest)]
            }
        }
    }

    /// The derivatives of a condition by δ, a, b, k, m and m N/k.
    fn by_others(&self, which: usize) -> [T; 6] {
        let zero = T::from(0);
        let Terms { variables, rate_square: r2, twice: t, product: n, from_pole: q } = self.terms;
        let [_, _, _, delta, a, b, k, m, share] = *variables;
        let (steep, slack) = (r2 + t, k - m * n);
        match which {
            0 => [r2 * k - m * steep * n, -n, zero, delta * r2, -(delta * steep * n), zero],
            1 => [q * slack, zero, -n, delta * q, -(delta * q * n), zero],
            2 => [-(q * m * t), -q, r2, zero, -(q * delta * t), zero],
            3 => {
                let tq = t * q;
                [-(k * tq), -(n * q), n * steep, -(delta * tq), zero, zero]
            }
            _ => [zero, -(q - share * q), r2 - share * steep, zero, zero, a * q - b * steep],
        }
    }

    /// The derivative of a condition by one of the two roots or r, of those by the terms.
    fn by_root(&self, by_terms: &[T; 4], root: usize) -> T {
        let each = by_terms.iter().zip(&self.of_terms).map(|(by_term, of_term)| *by_term * of_term[root]);
        each.fold(T::from(0), |sum, part| sum + part)
    }

    /// The derivatives of a condition.
    pub(super) fn condition(&self, which: usize) -> [T; VARIABLES] {
        let by_terms = self.by_terms(which);
        let [first, second, rate] = [0, 1, 2].map(|root| self.by_root(&by_terms, root));
        let [delta, a, b, k, m, share] = self.by_others(which);
        [first, second, rate, delta, a, b, k, m, share]
    }
}

#[cfg(test)]
mod tests {
    use super::super::root_discs::cubic;
    use super::*;
    use crate::number::Interval;
    use crate::number::split_mix::SplitMix64;
    use crate::roots::bounded_roots;

    fn all(kind: TwoRoots, at: &[Interval; VARIABLES]) -> [Interval; CONDITIONS] {
        let terms = Terms::of(kind, at);
        std::array::from_fn(|which| terms.condition(which))
    }

    /// The variables of the two roots beside a real one, by the cubic.
    fn of_roots(values: [f64; 7]) -> Option<(TwoRoots, [f64; VARIABLES])> {
        let [a, b, d, k, m, s, v] = values;
        let [c0, c1, c2, c3] = cubic(&values.map(Interval::point)).map(Interval::middle);
        let real = bounded_roots([c0, c1, c2, c3]).real.value;
        let half_sum = -0.5 * (c2 / c3 + real);
        let product = -c0 / (c3 * real);
        let square = product - half_sum * half_sum;
        let half_width = square.abs().sqrt();
        let (kind, [first, second]) = if square > 0.0 {
            (TwoRoots::Pair, [half_sum, square])
        } else {
            (TwoRoots::Real, [half_sum + half_width, half_sum - half_width])
        };
        (square.abs() > 1e-3 * half_sum * half_sum)
            .then(|| (kind, [first, second, v / d, d / s, a, b, k, m, m * product / k]))
    }

    #[test]
    fn roots_of_the_cubic_meet_all_conditions_and_numbers_beside_them_do_not() {
        let mut random = SplitMix64(4);
        let mut found = [0; 2];
        while found.iter().any(|found| *found < 100) {
            let values =
                [0.01, 0.014, 1.0, 0.005, 1e-4, 1.0, 1.0].map(|x| x * libm::exp10(random.unit() - 0.5));
            let Some((kind, root)) = of_roots(values) else { continue };
            found[usize::from(kind == TwoRoots::Real)] += 1;
            let sizes = |at: [f64; VARIABLES]| all(kind, &at.map(|x| Interval::about(x, 1e-9 * x.abs())));
            assert!(sizes(root).iter().all(|value| value.low <= 0.0 && value.high >= 0.0), "{values:?}");
            for i in 0..3 {
                let mut beside = root;
                beside[i] *= 1.01;
                assert!(sizes(beside).iter().any(|value| value.sign().is_some()), "{i} {values:?}");
            }
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        for (kind, roots) in [(TwoRoots::Pair, [-0.3, 0.7]), (TwoRoots::Real, [-0.3, -0.7])] {
            let at = [roots[0], roots[1], 1.1, 0.9, 0.01, 0.014, 0.005, 0.02, 2.0];
            let points = at.map(Interval::point);
            let slopes = Slopes::of(kind, &points);
            let found: [_; CONDITIONS] = std::array::from_fn(|which| slopes.condition(which));
            for i in 0..VARIABLES {
                let step = 1e-6 * at[i].abs();
                let moved = |sign: f64| {
                    let mut moved = at;
                    moved[i] += sign * step;
                    all(kind, &moved.map(Interval::point)).map(Interval::middle)
                };
                let (above, below) = (moved(1.0), moved(-1.0));
                for which in 0..CONDITIONS {
                    let difference = (above[which] - below[which]) / (2.0 * step);
                    // The difference errs by rounding over the step, and by its square.
                    assert!((found[which][i].middle() - difference).abs() < 1e-8, "{which} {i}");
                }
            }
        }
    }
}
