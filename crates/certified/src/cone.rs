//! A cone around the slowest real mode of steady sliding, which a decay does not leave: from there on each quantity has one sign.
//!
//! The equations are z' = J̄z, where J̄ lies in the enclosure of the derivative over a box around zero. With approximate
//! eigenvectors T of J(0), slowest first, u = T⁻¹z obeys u' = Au, where A is nearly diagonal. On the side |u_i| = γ_i s u_1 of the cone
//! |u_i| ≤ γ_i s u_1 ≤ γ_i U, i = 2, 3 and s = ±1, which the box holds,
//!
//! ```text
//! (|u_i| − γ_i s u_1)' ≤ s u_1 (A_ii γ_i + |A_i1| + |A_ij| γ_j − γ_i (A_11 − |A_12| γ_2 − |A_13| γ_3))
//! ```
//!
//! Where A_11 + |A_12| γ_2 + |A_13| γ_3 < 0, s u_1 falls to zero; where the right-hand side is negative too, no motion leaves the cone, and
//! all end in steady sliding. A linear form ℓ of z is
//! s u_1 times a number in s(ℓT_1 ± |ℓT_2| γ_2 ± |ℓT_3| γ_3).

use crate::interval::{Interval, generously_up, worse};
use crate::linear::{Square, apply, inverse, multiply, norm, points};
use slipmode_core::roots::{Pair, bounded_roots};

/// The sides γ_i over what the state, and the coupling of the modes, need at least.
const SPARE: f64 = 2.0;
/// A wider side is not tried: the slowest mode does not decide the signs yet.
const LARGEST_SIDE: f64 = 1e3;

/// The modes of steady sliding.
#[derive(Debug, Clone)]
pub(super) struct Modes {
    /// T and T⁻¹.
    vectors: Square<3>,
    inverse: Square<3>,
}

/// A state in a cone that no later state leaves.
pub(super) struct Cone<'m> {
    modes: &'m Modes,
    /// s u_1 at most, with the sign s.
    size: f64,
    sign: f64,
    /// γ_2 and γ_3.
    sides: [f64; 2],
}

impl Modes {
    /// Those of a matrix with three real eigenvalues; none of others.
    pub fn of(matrix: &[[f64; 3]; 3]) -> Option<Self> {
        let minor = |i: usize, j: usize| matrix[i][i] * matrix[j][j] - matrix[i][j] * matrix[j][i];
        let trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
        let spectrum =
            bounded_roots([-determinant(matrix), minor(0, 1) + minor(0, 2) + minor(1, 2), -trace, 1.0]);
        let Pair::Real(pair) = spectrum.pair else { return None };
        let mut rates = [spectrum.real.value, pair[0].value, pair[1].value];
        rates.sort_by(|a, b| b.total_cmp(a));
        let columns = rates.map(|rate| eigenvector(matrix, rate));
        let vectors = points(&std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])));
        Some(Self { inverse: inverse(&vectors)?, vectors })
    }

    /// The cone that holds a state and all later ones, for rates with this derivative over boxes around zero; none where no cone is proved to.
    pub fn cone(
        &self,
        state: &[Interval; 3],
        derivative: impl Fn(&[Interval; 3]) -> Square<3>,
    ) -> Option<Cone<'_>> {
        let u = apply(&self.inverse, state);
        let (least, size) = (u[0].mignitude(), u[0].magnitude());
        let ratios = [1, 2].map(|i| SPARE * u[i].magnitude() / least);
        if !(ratios[0] < LARGEST_SIDE && ratios[1] < LARGEST_SIDE) {
            return None;
        }
        let coupling_within = |sides: [f64; 2]| {
            let [second, third] = sides.map(|side| generously_up(side * size));
            let region = apply(&self.vectors, &[size, second, third].map(Interval::symmetric));
            multiply(&self.inverse, &multiply(&derivative(&region), &self.vectors))
        };
        let a = coupling_within(ratios);
        let sides = [1, 2].map(|i| {
            let coupling = a[i][0].magnitude() / (a[0][0].lower() - a[i][i].upper());
            ratios[i - 1].max(SPARE * coupling)
        });
        let a = coupling_within(sides);
        let coupled = generously_up(a[0][1].magnitude() * sides[0] + a[0][2].magnitude() * sides[1]);
        let slowest = (a[0][0].lower() - coupled).next_down();
        let is_closed = |i: usize| {
            let (side, other) = (sides[i - 1], sides[2 - i]);
            let gained = a[i][0].magnitude() + a[i][3 - i].magnitude() * other;
            let change =
                Interval::point(side) * (Interval::point(a[i][i].upper()) - Interval::point(slowest));
            side > 0.0 && (change.upper() + generously_up(gained)).next_up() < 0.0
        };
        let falls = (a[0][0].upper() + coupled).next_up() < 0.0;
        let is_proved = falls && is_closed(1) && is_closed(2);
        let holds = [1, 2].iter().all(|&i| generously_up(u[i].magnitude()) < sides[i - 1] * least);
        let sign = u[0].mid.signum();
        (is_proved && holds).then_some(Cone { modes: self, size, sign, sides })
    }
}

impl Cone<'_> {
    /// At least the largest value of a linear form, from here on.
    pub fn largest(&self, form: &[Interval; 3]) -> f64 {
        let [along, second, third] = multiply(&[*form], &self.modes.vectors)[0];
        let spread = second.magnitude() * self.sides[0] + third.magnitude() * self.sides[1];
        let factor = (Interval::point(self.sign) * along).widened(generously_up(spread));
        generously_up(self.size * worse(factor.upper(), 0.0))
    }
}

fn cross([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> [f64; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0].iter().zip(cross(m[1], m[2])).map(|(a, b)| a * b).sum()
}

/// A vector that the matrix less the eigenvalue nearly maps to zero: the longest product of two of its rows, at length one.
fn eigenvector(matrix: &[[f64; 3]; 3], rate: f64) -> [f64; 3] {
    let shifted = |i: usize, j: usize| if i == j { matrix[i][j] - rate } else { matrix[i][j] };
    let rows = [0, 1, 2].map(|i| unit(std::array::from_fn(|j| shifted(i, j))));
    let products = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| cross(rows[i], rows[j]));
    let longest = products.into_iter().max_by(|a, b| norm(a).total_cmp(&norm(b)));
    unit(longest.unwrap_or_default())
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = norm(&v);
    v.map(|c| c / length)
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;
    use slipmode_core::number::split_mix::SplitMix64;

    /// Modes of the rates −1/3, −2 and −8 along (1, 1, 1), (1, −1, 0) and (1, 1, −2).
    const MATRIX: [[f64; 3]; 3] = [
        [-22.0 / 9.0, -4.0 / 9.0, 23.0 / 9.0],
        [-4.0 / 9.0, -22.0 / 9.0, 23.0 / 9.0],
        [23.0 / 9.0, 23.0 / 9.0, -49.0 / 9.0],
    ];

    fn widened(by: f64) -> Square<3> {
        points(&MATRIX).map(|row| row.map(|entry| entry.widened(by)))
    }

    #[test]
    fn a_state_near_the_slowest_mode_stays_in_its_cone_and_others_are_refused() {
        let modes = Modes::of(&MATRIX).unwrap();
        let state = |along: f64, off: f64| [along, along + off, along].map(Interval::point);
        for sign in [1.0, -1.0] {
            let cone = modes.cone(&state(sign * 1e-3, 1e-5), |_| widened(1e-3)).unwrap();
            // The sum decays alone: it keeps its sign, and its size is the largest now.
            let (sum, now) = ([Interval::point(sign); 3], 3e-3 + sign * 1e-5);
            let [largest, least] = [cone.largest(&sum), cone.largest(&sum.map(|c| -c))];
            assert!(
                largest >= now && largest < 1.001 * now && least < 1e-200,
                "{largest:e} {least:e} {now:e}"
            );
        }
        // Too far from the slow mode, modes too strongly coupled, and a slow mode that may grow.
        assert!(modes.cone(&state(1e-5, 1e-3), |_| widened(1e-1)).is_none());
        assert!(modes.cone(&state(1e-3, 1e-5), |_| widened(1.0)).is_none());
        let mut growing = widened(1e-3);
        (0..3).for_each(|i| growing[i][i] = growing[i][i].widened(0.4));
        assert!(modes.cone(&state(1e-3, 1e-5), |_| growing).is_none());
        // A pair of complex modes has no such cone.
        assert!(Modes::of(&[[-1.0, 2.0, 0.0], [-2.0, -1.0, 0.0], [0.0, 0.0, -3.0]]).is_none());
    }

    /// The bounds hold along the motion of a linear system.
    #[test]
    fn the_bound_of_a_form_holds_along_the_motion() {
        let modes = Modes::of(&MATRIX).unwrap();
        let mut state = [2e-3, 1.9e-3, 2.1e-3];
        let cone = modes.cone(&state.map(Interval::point), |_| widened(1e-6)).unwrap();
        let forms = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [1.0, -2.0, 0.5]];
        let bounds = forms.map(|form| cone.largest(&form.map(Interval::point)));
        for _ in 0..20_000 {
            let rates: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| MATRIX[i][j] * state[j]).sum());
            state = std::array::from_fn(|i| state[i] + 1e-3 * rates[i]);
            for (form, bound) in forms.iter().zip(bounds) {
                let value: f64 = form.iter().zip(&state).map(|(a, b)| a * b).sum();
                assert!(value <= bound, "{value:e} {bound:e}");
            }
        }
    }

    /// Diagonal modes with random couplings: each cone that is found holds the state, lies in the box of its derivative, and no rate within
    /// the enclosure leads out of it or away from zero.
    #[test]
    fn no_rate_leads_out_of_a_cone() {
        let unit: [[f64; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
        let modes = Modes { vectors: points(&unit), inverse: points(&unit) };
        let mut random = SplitMix64(1);
        let mut found = 0;
        for case in 0..40_000 {
            // A slow mode that coupling can turn into a growing one.
            let slowest = if case % 2 == 0 { -1.0 } else { -0.1 };
            let mut up_to = |most: f64| most * random.unit();
            let size = up_to(1.0) * up_to(1.0);
            let coupling: Square<3> = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let mid = if i == j { [slowest, -2.0, -4.0][i] } else { size * (up_to(4.0) - 2.0) };
                    Interval { mid, rad: size * up_to(1.0) }
                })
            });
            let u: [Interval; 3] = std::array::from_fn(|i| {
                let mid = if i == 0 { 1.0 } else { up_to(2.0) - 1.0 };
                Interval { mid, rad: up_to(0.5) }
            });
            let regions = RefCell::new(Vec::new());
            let Some(cone) = modes.cone(&u, |region| {
                regions.borrow_mut().push(*region);
                coupling
            }) else {
                continue;
            };
            found += 1;
            let side = [1.0, cone.sides[0], cone.sides[1]];
            for i in 1..3 {
                assert!(u[i].magnitude() <= side[i] * (u[0].mid - u[0].rad), "{u:?} {side:?}");
            }
            assert!(cone.size >= u[0].mid + u[0].rad);
            let region = regions.borrow().last().copied().unwrap();
            assert!((0..3).all(|i| region[i].upper() >= cone.size * side[i] * (1.0 - 1e-15)), "{region:?}");
            for corner in 0..4_u32 {
                let sign = |bit: u32| if corner >> bit & 1 == 0 { 1.0 } else { -1.0 };
                let at = [1.0, sign(0) * side[1], sign(1) * side[2]];
                // The largest value of each rate along a direction, over the enclosure.
                let largest = |i: usize, along: f64| -> f64 {
                    let term =
                        |j: usize| along * coupling[i][j].mid * at[j] + coupling[i][j].rad * at[j].abs();
                    (0..3).map(term).sum()
                };
                assert!(largest(0, 1.0) < 0.0, "{coupling:?} {side:?}");
                for i in 1..3 {
                    let outward = largest(i, at[i].signum()) + side[i] * largest(0, -1.0);
                    assert!(outward < 0.0, "{coupling:?} {side:?} {outward}");
                }
                let form: [f64; 3] = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
                let bound = cone.largest(&form.map(Interval::point));
                let value: f64 = (0..3).map(|i| form[i] * cone.size * at[i]).sum();
                assert!(value <= bound, "{form:?} {at:?} {value} {bound}");
            }
        }
        assert!(found > 100, "{found}");
    }
}
