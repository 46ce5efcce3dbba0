//! The parameters λ at given κ, quickly: the equation of each arc is prepared once, a root costs one certified Newton step.
//!
//! Where 64-bit cannot decide how many roots there are (next to an asymptote's own σ or to the cusp), there is
//! no answer, and the caller takes the general way of [`ParameterEquation`](super::parameter_equation).

use std::cmp::Ordering;

use crate::number::{Ball, Field};
use crate::stability::parameter_coefficients::StiffnessEquation;
use crate::stability::parameter_quick::{order, quick_roots};
use crate::stability::{Arc, ArcFrame};

/// The equation of one arc with what its roots are told apart by.
#[derive(Debug, Clone)]
pub(crate) struct StiffnessSection {
    arc: Arc,
    equation: StiffnessEquation,
    /// κ of eq 15 or 16: (√β ∓ 1)².
    asymptotic_stiffness: f64,
    cusp_parameter: f64,
}

impl StiffnessSection {
    /// The section of an arc; the cusp's λ matters on the lower one only.
    pub(crate) fn new(arc: Arc, frame: &ArcFrame<Ball>, cusp_parameter: &Ball) -> Self {
        let end = if arc == Arc::Upper { &frame.difference } else { &frame.sum };
        Self {
            arc,
            equation: StiffnessEquation::new(arc, frame),
            asymptotic_stiffness: end.square().to_f64(),
            cusp_parameter: cusp_parameter.to_f64(),
        }
    }

    /// λ of the places with this κ, descending, each with a relative radius of at most 2^−bits.
    pub(crate) fn parameters(&self, stiffness_group: &Ball, bits: u32) -> Option<Vec<Ball>> {
        // κ falls from the quasi-static end's on the upper arc; on the lower one the branch above the cusp starts there.
        let from_end = order(stiffness_group.to_f64(), self.asymptotic_stiffness)?;
        if self.arc == Arc::Upper && from_end == Ordering::Greater {
            return Some(Vec::new());
        }
        let coefficients = self.equation.coefficients(stiffness_group);
        quick_roots(self.arc, &coefficients, from_end == Ordering::Less, self.cusp_parameter, bits)
    }
}
