//! The parameters λ at given κ, quickly: the equation of each arc is prepared once, a root costs one certified Newton step.
//!
//! Where 64-bit cannot decide how many roots there are (next to an asymptote's own σ or to the cusp), there is
//! no answer, and the caller takes the general way of [`ParameterEquation`](super::parameter_equation).

use std::cmp::Ordering;

use crate::number::{Ball, Field};
use crate::stability::parameter_coefficients::StiffnessEquation;
use crate::stability::parameter_quick::{certified_root, positive_range, root_in_f64};
use crate::stability::{Arc, ArcFrame};

/// How far, relative to the terms compared, two 64-bit numbers must lie apart for their order to be certain here: the
/// roundings before it are some dozens, each of 1.1e-16.
const MARGIN: f64 = 1e-12;

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
        let rounded: Vec<f64> = coefficients.iter().map(Ball::to_f64).collect();
        let (low, high) = positive_range(&rounded)?;
        let root = |lower, upper| certified_root(&coefficients, root_in_f64(&rounded, lower, upper)?, bits);
        if self.arc == Arc::Upper {
            return Some(vec![root(low, high)?]);
        }
        let cusp = self.cusp_parameter;
        if certain_sign(&rounded, cusp)? == Ordering::Greater {
            return Some(Vec::new());
        }
        let mut roots = Vec::with_capacity(2);
        if from_end == Ordering::Less {
            let above = root(cusp, high)?;
            (order(above.to_f64(), cusp)? == Ordering::Greater).then(|| roots.push(above))?;
        }
        let below = root(low, cusp)?;
        (order(below.to_f64(), cusp)? == Ordering::Less).then(|| roots.push(below))?;
        Some(roots)
    }
}

/// Which of two positive numbers is larger, when that is clear.
fn order(one: f64, other: f64) -> Option<Ordering> {
    // Written so that what is not a number has no order.
    ((one - other).abs() > MARGIN * (one + other)).then(|| one.total_cmp(&other))
}

/// The sign of the polynomial at x > 0, when it is beyond the rounding of its terms.
fn certain_sign(coefficients: &[f64], x: f64) -> Option<Ordering> {
    let terms = |(value, size): (f64, f64), c: &f64| (value * x + c, size * x + c.abs());
    let (value, size) = coefficients.iter().rev().fold((0.0, 0.0), terms);
    (value.abs() > MARGIN * size).then(|| value.total_cmp(&0.0))
}
