//! An ellipsoid around steady sliding in which every motion decays.
//!
//! In z = (x, y, F/η) the equations are z' = f(z) with f(0) = 0, and f(z) = J̄z with a mean J̄ of the derivative over the segment from 0 to z.
//! For V = zᵀPz this gives V' = zᵀ(J̄ᵀP + PJ̄)z. Where this matrix is negative definite for every J̄ over a box, each ellipsoid V ≤ c inside the box
//! attracts. P solves J(0)ᵀP + PJ(0) = −I to rounding; what is proved depends on P only through the signs.

use crate::Constants;
use crate::cone::{Cone, Modes};
use crate::interval::Interval;
use crate::linear::{Square, determinant, inverse, multiply, points};
use slipmode_core::friction::EvolutionLaw;

/// The ellipsoid zᵀPz ≤ c.
#[derive(Debug, Clone)]
pub(super) struct Ellipsoid {
    form: Square<3>,
    level: f64,
    /// The diagonal of P⁻¹: |z_i|² ≤ c (P⁻¹)_ii.
    inverse: [Interval; 3],
    /// The modes, where all are real.
    modes: Option<Modes>,
}

/// Levels that are tried, each a tenth of the one before.
const LEVELS: i32 = 40;

impl Ellipsoid {
    /// The largest that is proved to attract, in steps of ten; none where none is.
    pub fn around_steady_sliding(constants: &Constants) -> Option<Self> {
        let at_rest = derivative(constants, &[Interval::ZERO; 3]).map(|row| row.map(|entry| entry.mid));
        let form = points(&lyapunov(&at_rest)?);
        let inverse = diagonal_of_inverse(&form)?;
        (0..LEVELS).find_map(|step| {
            let level = libm::pow(10.0, f64::from(2 - step));
            let around = derivative(constants, &reach(level, &inverse).map(Interval::symmetric));
            is_positive_definite(&fall(&form, &around)).then(|| Self {
                form,
                level,
                inverse,
                modes: Modes::of(&at_rest),
            })
        })
    }

    /// Bounds of |x|, |y| and |w| from a box on, if every point of it lies inside.
    pub fn reach_from(&self, z: &[Interval; 3]) -> Option<[f64; 3]> {
        let value = (0..3)
            .fold(Interval::ZERO, |sum, i| (0..3).fold(sum, |sum, j| sum + z[i] * self.form[i][j] * z[j]));
        let value = value.upper();
        (value < self.level).then(|| reach(value, &self.inverse))
    }

    /// The cone that a state and all later states are proved to stay in.
    pub fn cone(&self, constants: &Constants, z: &[Interval; 3]) -> Option<Cone<'_>> {
        self.modes.as_ref()?.cone(z, |region| derivative(constants, region))
    }
}

/// The largest |x|, |y| and |w| of zᵀPz ≤ `level`, from the diagonal of P⁻¹.
fn reach(level: f64, inverse: &[Interval; 3]) -> [f64; 3] {
    inverse.map(|side| (Interval::point(level) * side).sqrt().upper())
}

/// −(JᵀP + PJ).
fn fall(form: &Square<3>, j: &Square<3>) -> Square<3> {
    let product = multiply(form, j);
    std::array::from_fn(|a| std::array::from_fn(|b| -(product[a][b] + product[b][a])))
}

/// The derivative of the rates of x, y and w = F/η over a box around zero.
fn derivative(constants: &Constants, [x, y, w]: &[Interval; 3]) -> Square<3> {
    let Constants { inertia, stiffness, effect_ratio, law } = *constants;
    let (velocity, inverse) = (x.exp(), (-*x).exp());
    let (by_x, by_y) = match law {
        EvolutionLaw::Slip => (-(velocity * (*x + *y + Interval::ONE)), -velocity),
        EvolutionLaw::Aging => (-velocity, -(-*y).exp()),
    };
    let fast = inertia.reciprocal();
    let of_force = [
        fast * (-(stiffness * velocity) + *w * inverse - effect_ratio * by_x),
        -(fast * (effect_ratio * by_y)),
        -(fast * inverse),
    ];
    [[-(*w * inverse), Interval::ZERO, inverse], [by_x, by_y, Interval::ZERO], of_force]
}

/// P with JᵀP + PJ = −I, to rounding: six linear equations.
fn lyapunov(j: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    const PAIRS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let place = |a: usize, b: usize| PAIRS.iter().position(|&pair| pair == (a.min(b), a.max(b)));
    let mut system = [[0.0; 7]; 6];
    for (row, &(a, b)) in PAIRS.iter().enumerate() {
        for k in 0..3 {
            system[row][place(k, b)?] += j[k][a];
            system[row][place(a, k)?] += j[k][b];
        }
        system[row][6] = if a == b { -1.0 } else { 0.0 };
    }
    let solution = solve(system)?;
    let mut form = [[0.0; 3]; 3];
    for (&(a, b), value) in PAIRS.iter().zip(solution) {
        (form[a][b], form[b][a]) = (value, value);
    }
    Some(form)
}

/// Gauss elimination with pivots.
fn solve(mut system: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for column in 0..6 {
        let pivot =
            (column..6).max_by(|&a, &b| system[a][column].abs().total_cmp(&system[b][column].abs()))?;
        system.swap(column, pivot);
        let pivot_row = system[column];
        if pivot_row[column] == 0.0 {
            return None;
        }
        for (_, row) in system.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            let factor = row[column] / pivot_row[column];
            for (entry, of_pivot) in row.iter_mut().zip(pivot_row) {
                *entry -= factor * of_pivot;
            }
        }
    }
    Some(std::array::from_fn(|i| system[i][6] / system[i][i]))
}

/// Sylvester's criterion on a symmetric matrix of intervals.
fn is_positive_definite(m: &Square<3>) -> bool {
    let minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    m[0][0].lower() > 0.0 && minor.lower() > 0.0 && determinant(m).lower() > 0.0
}

/// Encloses the diagonal of the inverse, if the matrix is positive definite.
fn diagonal_of_inverse(m: &Square<3>) -> Option<[Interval; 3]> {
    let inverse = inverse(m).filter(|_| is_positive_definite(m))?;
    Some(std::array::from_fn(|i| inverse[i][i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::members::Slider;
    use slipmode_core::number::split_mix::SplitMix64;

    /// The rates of x, y and F/η.
    fn rates(slider: Slider, [x, y, w]: [f64; 3]) -> [f64; 3] {
        let [speed, state_rate] = [w * libm::exp(-x), slider.state_rate(x, y)];
        let force_rate = -slider.stiffness * libm::expm1(x) - speed - slider.effect_ratio * state_rate;
        [speed, state_rate, force_rate / slider.inertia]
    }

    fn sliders() -> impl Iterator<Item = Slider> {
        EvolutionLaw::ALL.into_iter().flat_map(|law| {
            [(0.01, 0.6), (0.5, 1.5), (20.0, 20.0)].map(|(inertia, stiffness)| Slider {
                inertia,
                stiffness,
                effect_ratio: 1.5,
                law,
            })
        })
    }

    /// Near and far from zero the derivative over a box holds the difference quotients in it.
    #[test]
    fn the_derivative_holds_difference_quotients() {
        for slider in sliders() {
            for centre in [[0.0; 3], [0.5, -0.3, 0.2], [-1.0, 0.4, -0.3]] {
                let over = derivative(&slider.constants(), &centre.map(Interval::point));
                for j in [0, 1, 2] {
                    let moved = |by: f64| {
                        rates(
                            slider,
                            std::array::from_fn(|i| if i == j { centre[i] + by } else { centre[i] }),
                        )
                    };
                    let (before, after) = (moved(-1e-5), moved(1e-5));
                    for (i, row) in over.iter().enumerate() {
                        let slope = (after[i] - before[i]) / 2e-5;
                        let error = 1e-7 * (1.0 + slope.abs());
                        assert!(row[j].widened(error).may_contain(slope), "{slider:?} {i} {j} {slope}");
                    }
                }
            }
        }
    }

    /// On the surface of the ellipsoid V falls, and it reaches no further than stated; the next ellipsoid would be refused or is too large.
    #[test]
    fn the_form_falls_on_the_whole_ellipsoid() {
        let mut random = SplitMix64(1);
        for slider in sliders() {
            let constants = slider.constants();
            let ellipsoid = Ellipsoid::around_steady_sliding(&constants).unwrap();
            let form = ellipsoid.form.map(|row| row.map(|c| c.mid));
            let product = |z: [f64; 3], by: [f64; 3]| -> f64 {
                (0..3).map(|i| (0..3).map(|j| z[i] * form[i][j] * by[j]).sum::<f64>()).sum()
            };
            for _ in 0..2000 {
                let direction: [f64; 3] = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
                // A fifth of the surface and of all smaller ones.
                for part in [1.0, 0.3, 1e-2] {
                    let scale = part * (ellipsoid.level / product(direction, direction)).sqrt();
                    let z = direction.map(|c| scale * c);
                    assert!(product(z, rates(slider, z)) < 0.0, "{slider:?} {z:?} grows");
                    let reach = ellipsoid.reach_from(&z.map(|c| Interval::point(0.999 * c))).unwrap();
                    assert!((0..3).all(|i| 0.999 * z[i].abs() <= reach[i]), "{slider:?} {z:?} {reach:?}");
                    if part == 1.0 {
                        assert!(ellipsoid.reach_from(&z.map(|c| Interval::point(1.001 * c))).is_none());
                        assert!(
                            ellipsoid
                                .reach_from(&z.map(|c| Interval { mid: 0.99 * c, rad: 0.1 * c.abs() }))
                                .is_none()
                        );
                    }
                }
            }
            // The farthest point in each coordinate.
            let inverse = inverse(&ellipsoid.form).unwrap();
            for i in 0..3 {
                let scale = 0.999 * (ellipsoid.level / inverse[i][i].mid).sqrt();
                let z: [f64; 3] = std::array::from_fn(|j| scale * inverse[j][i].mid);
                assert!(
                    ellipsoid.reach_from(&z.map(Interval::point)).unwrap()[i] >= z[i].abs() * (1.0 - 1e-12)
                );
            }
        }
    }

    /// −(JᵀP + PJ) of whole numbers.
    #[test]
    fn the_fall_of_a_form_is_symmetric() {
        let form = [[2.0, 1.0, 0.0], [1.0, 3.0, -1.0], [0.0, -1.0, 5.0]];
        let j = [[1.0, 2.0, 3.0], [-4.0, 5.0, 6.0], [7.0, -8.0, 9.0]];
        let found = fall(&points(&form), &points(&j));
        for a in 0..3 {
            for b in 0..3 {
                let exact: f64 = (0..3).map(|k| -(j[k][a] * form[k][b] + form[a][k] * j[k][b])).sum();
                assert!(
                    found[a][b].may_contain(exact) && found[a][b].rad < 1e-12,
                    "{a} {b} {exact} {found:?}"
                );
            }
        }
    }

    /// The reach is at least √(level · side) for each side of a wide interval.
    #[test]
    fn a_reach_counts_the_largest_sides() {
        let sides =
            [Interval { mid: 2.0, rad: 0.5 }, Interval { mid: 1e-3, rad: 1e-5 }, Interval::point(7.0)];
        for level in [1e-9, 0.3, 100.0] {
            let found = reach(level, &sides);
            for (bound, side) in found.into_iter().zip(sides) {
                let exact = level * (side.mid + side.rad);
                assert!(bound * bound >= exact * (1.0 - 1e-15) && bound * bound < exact * (1.0 + 1e-12));
            }
        }
    }

    /// Each leading minor can be the only one that is not positive.
    #[test]
    fn sylvesters_criterion_needs_every_minor() {
        let is_positive = |[a, b, c, d]: [f64; 4], rad: f64| {
            let matrix = [[a, 0.0, d], [0.0, b, 0.0], [d, 0.0, c]];
            is_positive_definite(&matrix.map(|row| row.map(|mid| Interval { mid, rad })))
        };
        assert!(is_positive([1.0, 1.0, 1.0, 0.5], 0.0) && is_positive([1.0, 1.0, 1.0, 0.5], 0.01));
        for negative in
            [[-1.0, -1.0, 1.0, 0.0], [1.0, -1.0, -1.0, 0.0], [1.0, 1.0, 1.0, 1.5], [-1.0, -1.0, -1.0, 0.0]]
        {
            assert!(!is_positive(negative, 0.0), "{negative:?}");
        }
        assert!(!is_positive([1.0, 1.0, 1.0, 0.5], 0.6) && !is_positive([1.0, 0.0, 1.0, 0.0], 0.0));
    }

    /// At random sliders: what is proved to attract does, on the surface of the ellipsoid and inside, and nothing is proved where steady sliding
    /// repels.
    #[test]
    fn no_slider_has_an_ellipsoid_that_motions_leave() {
        let mut random = SplitMix64(2);
        let mut proved = 0;
        for case in 0..400 {
            let mut decades = |from: f64, to: f64| libm::pow(10.0, from + (to - from) * random.unit());
            let slider = Slider {
                inertia: decades(-3.0, 3.0),
                stiffness: decades(-1.5, 2.0),
                effect_ratio: decades(-1.0, 1.0),
                law: EvolutionLaw::ALL[case % 2],
            };
            let Some(ellipsoid) = Ellipsoid::around_steady_sliding(&slider.constants()) else { continue };
            proved += 1;
            let form = ellipsoid.form.map(|row| row.map(|c| c.mid));
            let product = |z: [f64; 3], by: [f64; 3]| -> f64 {
                (0..3).map(|i| (0..3).map(|j| z[i] * form[i][j] * by[j]).sum::<f64>()).sum()
            };
            for _ in 0..300 {
                let direction: [f64; 3] = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
                let stretched = std::array::from_fn(|i| direction[i] * ellipsoid.inverse[i].mid.sqrt());
                for direction in [direction, stretched] {
                    assert!(product(direction, direction) > 0.0, "{slider:?} no ellipsoid");
                    for part in [1.0, 0.1] {
                        let scale = part * (ellipsoid.level / product(direction, direction)).sqrt();
                        let z = direction.map(|c| scale * c);
                        let (change, size) = (product(z, rates(slider, z)), product(z, z));
                        assert!(change < 1e-12 * size, "{slider:?} {z:?} {change}");
                    }
                }
            }
        }
        assert!(proved > 100, "{proved}");
    }

    /// An indefinite form has no ellipsoid, though the diagonal of its inverse is positive.
    #[test]
    fn an_indefinite_form_is_refused() {
        let third = 1.0 / 3.0;
        // The inverse of [[1, 2, 0], [2, 1, 0], [0, 0, 1]].
        let indefinite = [[-third, 2.0 * third, 0.0], [2.0 * third, -third, 0.0], [0.0, 0.0, 1.0]];
        let inverted = inverse(&points(&indefinite)).unwrap();
        assert!((0..3).all(|i| inverted[i][i].lower() > 0.9));
        assert!(diagonal_of_inverse(&points(&indefinite)).is_none());
    }
}
