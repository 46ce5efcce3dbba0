//! Sets of states: c + Q(D p + r), where p is the point of the section from which the orbit started.
//!
//! D encloses the derivative by p, Q is orthogonal and r holds the errors (Lohner, *Enclosing the solutions of ordinary initial and boundary
//! value problems*, 1987).

use crate::interval::{Interval, worse};
use crate::linear::{Frame, Square, apply, multiply, unit};

/// The coordinates of the section.
pub(super) const COORDINATES: usize = 2;

/// A derivative by the coordinates of the section.
pub(super) type Derivative<const N: usize> = [[Interval; COORDINATES]; N];

/// A set of states.
#[derive(Debug, Clone)]
pub(super) struct Set<const N: usize> {
    /// The box of p.
    pub section: [Interval; COORDINATES],
    /// c.
    pub centre: [f64; N],
    frame: Frame<N>,
    /// D and r, in the frame.
    turned: Derivative<N>,
    errors: [Interval; N],
}

impl<const N: usize> Set<N> {
    /// Points known to be in a box when p = 0, with their derivative by p.
    pub fn new(section: [Interval; COORDINATES], state: [Interval; N], derivative: Derivative<N>) -> Self {
        Self {
            section,
            centre: state.map(|c| c.mid),
            frame: Frame::identity(),
            turned: derivative,
            errors: state.map(|c| Interval::symmetric(c.rad)),
        }
    }

    /// All states.
    pub fn hull(&self) -> [Interval; N] {
        let offsets = self.offsets();
        std::array::from_fn(|i| Interval::point(self.centre[i]) + offsets[i])
    }

    /// All states less the centre.
    pub fn offsets(&self) -> [Interval; N] {
        let along = apply(&self.turned, &self.section);
        apply(&self.frame.columns, &std::array::from_fn(|i| along[i] + self.errors[i]))
    }

    /// The states with p = 0.
    pub fn at_centre(&self) -> [Interval; N] {
        let offsets = apply(&self.frame.columns, &self.errors);
        std::array::from_fn(|i| Interval::point(self.centre[i]) + offsets[i])
    }

    /// What linear forms make of the states with p = 0, less the centre, and of the derivative by p.
    ///
    /// Forms that nearly vanish along a column of the frame lose nothing here, unlike forms of the hull.
    pub fn seen_by<const K: usize>(&self, forms: &[[Interval; N]; K]) -> ([Interval; K], Derivative<K>) {
        let turned = multiply(forms, &self.frame.columns);
        (apply(&turned, &self.errors), multiply(&turned, &self.turned))
    }

    /// The derivative by p.
    pub fn derivative(&self) -> Derivative<N> {
        multiply(&self.frame.columns, &self.turned)
    }

    /// The image under a map that takes the centre into `image`, with derivatives in `slope` over the whole set; the derivative by p
    /// gains `extra`.
    pub fn mapped(&self, image: [Interval; N], slope: &Square<N>, extra: &Derivative<N>) -> Self {
        let along = apply(&self.turned, &self.section);
        let weights = std::array::from_fn(|i| worse((along[i] + self.errors[i]).magnitude(), 1e-300));
        let moved = multiply(slope, &self.frame.columns);
        self.seen_in(Frame::of(&moved, weights), image, &moved, extra)
    }

    /// The image under a map into M > N dimensions that takes the centre into `image`, with derivatives in `slope` over the whole set; the
    /// derivative by p gains `extra`.
    pub fn lifted<const M: usize>(
        &self,
        image: [Interval; M],
        slope: &[[Interval; N]; M],
        extra: &Derivative<M>,
    ) -> Set<M> {
        let moved = multiply(slope, &self.frame.columns);
        let unit: Square<M> = unit();
        let padded =
            std::array::from_fn(|i| std::array::from_fn(|j| *moved[i].get(j).unwrap_or(&unit[i][j])));
        self.seen_in(Frame::of(&padded, [1.0; M]), image, &moved, extra)
    }

    /// The image in a frame, where `moved` holds the images of the columns of the old one.
    fn seen_in<const M: usize>(
        &self,
        frame: Frame<M>,
        image: [Interval; M],
        moved: &[[Interval; N]; M],
        extra: &Derivative<M>,
    ) -> Set<M> {
        let turn = multiply(&frame.inverse, moved);
        let (carried, gained) = (multiply(&turn, &self.turned), multiply(&frame.inverse, extra));
        let errors = apply(&turn, &self.errors);
        let new = apply(&frame.inverse, &image.map(|c| Interval::symmetric(c.rad)));
        Set {
            section: self.section,
            centre: image.map(|c| c.mid),
            turned: std::array::from_fn(|i| std::array::from_fn(|j| carried[i][j] + gained[i][j])),
            errors: std::array::from_fn(|i| errors[i] + new[i]),
            frame,
        }
    }
}

/// The sizes of the columns of a derivative, in the norm of the largest entry.
pub(super) fn column_sizes<const N: usize>(derivative: &Derivative<N>) -> [f64; COORDINATES] {
    std::array::from_fn(|j| derivative.iter().fold(0.0, |largest, row| worse(largest, row[j].magnitude())))
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;
    use crate::tests::exact::{exact, holds};
    use slipmode_core::number::split_mix::SplitMix64;

    /// One state of a set with its derivative by p, exactly.
    struct Member<const N: usize> {
        p: [Rational; COORDINATES],
        /// What the errors are at this state, in parts of their largest size.
        part: f64,
        state: [Rational; N],
        derivative: [[Rational; COORDINATES]; N],
    }

    impl<const N: usize> Member<N> {
        /// The image under z → image + slope (z − c) + extra p.
        fn mapped<const M: usize>(
            self,
            centre: &[f64; N],
            image: &[Interval; M],
            slope: &[[f64; N]; M],
            extra: &Derivative<M>,
        ) -> Member<M> {
            let end = |c: Interval| exact(c.mid) + exact(c.rad) * exact(self.part);
            let times = |i: usize, of: &dyn Fn(usize) -> Rational| -> Rational {
                (0..N).map(|k| exact(slope[i][k]) * of(k)).sum()
            };
            let state = std::array::from_fn(|i| {
                let gained: Rational = (0..COORDINATES).map(|j| end(extra[i][j]) * self.p[j].clone()).sum();
                end(image[i]) + times(i, &|k| self.state[k].clone() - exact(centre[k])) + gained
            });
            let derivative = std::array::from_fn(|i| {
                std::array::from_fn(|j| times(i, &|k| self.derivative[k][j].clone()) + end(extra[i][j]))
            });
            Member { p: self.p, part: self.part, state, derivative }
        }

        fn assert_held(&self, set: &Set<N>) {
            let (hull, offsets, at_centre, derivative) =
                (set.hull(), set.offsets(), set.at_centre(), set.derivative());
            let forms: [[f64; N]; 2] =
                std::array::from_fn(|i| std::array::from_fn(|k| [0.5, -1.25, 3.0][(i + k) % 3]));
            let (seen, seen_derivative) = set.seen_by(&forms.map(|form| form.map(Interval::point)));
            for i in 0..N {
                assert!(holds(hull[i], &self.state[i]), "{i} {hull:?}");
                assert!(holds(offsets[i], &(self.state[i].clone() - exact(set.centre[i]))));
                assert!(
                    (0..COORDINATES).all(|j| holds(derivative[i][j], &self.derivative[i][j])),
                    "{i} {derivative:?}"
                );
                if self.p.iter().all(Rational::is_zero) {
                    assert!(holds(at_centre[i], &self.state[i]), "{i} {at_centre:?}");
                }
            }
            for (i, form) in forms.iter().enumerate() {
                let of = |values: &dyn Fn(usize) -> Rational| -> Rational {
                    (0..N).map(|k| exact(form[k]) * values(k)).sum()
                };
                if self.p.iter().all(Rational::is_zero) {
                    assert!(
                        holds(seen[i], &of(&|k| self.state[k].clone() - exact(set.centre[k]))),
                        "{i} {seen:?}"
                    );
                }
                assert!(
                    (0..COORDINATES)
                        .all(|j| holds(seen_derivative[i][j], &of(&|k| self.derivative[k][j].clone())))
                );
            }
        }
    }

    /// Sets under chains of linear maps, from points to wide ones: each member stays inside, exactly, with its derivative.
    #[test]
    fn a_set_holds_its_members_under_each_linear_map() {
        let mut random = SplitMix64(11);
        for case in 0..60 {
            let width = [0.0, 1e-12, 0.5][case % 3];
            let mut number = || 2.0 * random.unit() - 1.0;
            let section = [0; COORDINATES].map(|_| width * number().abs());
            let state = [0; 3].map(|_| Interval { mid: number(), rad: width * number().abs() });
            let slopes: [[f64; COORDINATES]; 3] = [[0; COORDINATES]; 3].map(|row| row.map(|_| number()));
            let derivative = slopes.map(|row| row.map(Interval::point));
            let start = Set::new(section.map(Interval::symmetric), state, derivative);
            let parts = [
                (0.0, 0.0, 0.0),
                (1.0, 1.0, 1.0),
                (-1.0, 1.0, -1.0),
                (0.0, 0.0, 1.0),
                (0.0, 0.0, -1.0),
                (1.0, -1.0, 0.5),
            ];
            let mut members: Vec<Member<3>> = parts
                .iter()
                .map(|&(first, second, part)| {
                    let p = [exact(first * section[0]), exact(second * section[1])];
                    let state = std::array::from_fn(|i| {
                        let along: Rational =
                            (0..COORDINATES).map(|j| exact(slopes[i][j]) * p[j].clone()).sum();
                        exact(state[i].mid) + exact(state[i].rad) * exact(part) + along
                    });
                    Member { p, part, state, derivative: slopes.map(|row| row.map(exact)) }
                })
                .collect();
            let mut set = start;
            members.iter().for_each(|member| member.assert_held(&set));
            for _ in 0..4 {
                let image = [0; 3].map(|_| Interval { mid: number(), rad: width * number().abs() });
                let slope: Square<3> = [[0; 3]; 3].map(|row| row.map(|_| Interval::point(number())));
                let extra: Derivative<3> =
                    [[0; COORDINATES]; 3].map(|row| row.map(|_| Interval { mid: number(), rad: width }));
                let centre = set.centre;
                let mids = slope.map(|row| row.map(|c| c.mid));
                members =
                    members.into_iter().map(|member| member.mapped(&centre, &image, &mids, &extra)).collect();
                // In a frame that is orthogonal to some digits only, too.
                let skew = 1e-3 * number();
                let frame = Frame::enclosed(&[[1.0, skew, 0.0], [0.0, 1.0, -skew], [skew, 0.0, 1.0]]);
                let moved = multiply(&slope, &set.frame.columns);
                let skewed = set.seen_in(frame, image, &moved, &extra);
                set = set.mapped(image, &slope, &extra);
                for set in [&set, &skewed] {
                    members.iter().for_each(|member| member.assert_held(set));
                }
            }
            // From two dimensions into three.
            let plane = Set::new(
                section.map(Interval::symmetric),
                [state[0], state[1]],
                [derivative[0], derivative[1]],
            );
            let image = [0; 3].map(|_| Interval { mid: number(), rad: width * number().abs() });
            let slope: [[f64; 2]; 3] = [[0; 2]; 3].map(|row| row.map(|_| number()));
            let extra = [[0; COORDINATES]; 3].map(|row| row.map(|_| Interval { mid: number(), rad: width }));
            let lifted = plane.lifted(image, &slope.map(|row| row.map(Interval::point)), &extra);
            for (first, second, part) in parts {
                let p = [exact(first * section[0]), exact(second * section[1])];
                let state = std::array::from_fn(|i| {
                    let along: Rational = (0..COORDINATES).map(|j| exact(slopes[i][j]) * p[j].clone()).sum();
                    exact(state[i].mid) + exact(state[i].rad) * exact(part) + along
                });
                let derivative = [slopes[0].map(exact), slopes[1].map(exact)];
                let member = Member { p, part, state, derivative };
                member.mapped(&plane.centre, &image, &slope, &extra).assert_held(&lifted);
            }
        }
    }

    /// In a frame that is orthogonal to some digits only, what a derivative gains is what it was.
    #[test]
    fn a_gained_derivative_is_held_in_a_skew_frame() {
        let nothing = [[Interval::ZERO; COORDINATES]; 3];
        let set = Set::new([Interval::ZERO; COORDINATES], [Interval::ZERO; 3], nothing);
        for skew in [0.0, 1e-6, -0.01] {
            let frame = Frame::enclosed(&[[1.0, skew, 0.0], [0.0, 1.0, -skew], [skew, 0.0, 1.0]]);
            let gained = [[1.0, -2.0], [0.5, 3.0], [-1.0, 0.25]];
            let extra = gained.map(|row| row.map(Interval::point));
            let found =
                set.seen_in(frame, [Interval::ZERO; 3], &[[Interval::ZERO; 3]; 3], &extra).derivative();
            assert!(
                (0..3).all(|i| (0..2).all(|j| holds(found[i][j], &exact(gained[i][j])))),
                "{skew} {found:?}"
            );
        }
    }
}
