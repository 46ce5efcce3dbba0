//! Sets of states: c + Q(D p + r), where p is the point of the section from which the orbit started.
//!
//! D encloses the derivative by p, Q is orthogonal and r holds the errors (Lohner, *Enclosing the solutions of ordinary initial and boundary
//! value problems*, 1987).

use super::interval::Interval;
use super::linear::{Frame, Square, apply, multiply, worse};

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
        let padded: Square<M> = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                moved[i].get(j).copied().unwrap_or(if i == j { Interval::ONE } else { Interval::ZERO })
            })
        });
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

    /// Whether all numbers are finite.
    pub fn is_bounded(&self) -> bool {
        self.hull().iter().chain(self.turned.as_flattened()).all(|c| c.is_bounded())
    }
}
