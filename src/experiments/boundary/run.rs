//! The exact boundary of a scene, and whether its three routes agree.

use crate::scene::{BoundarySection, SceneParameters};
use slipmode_core::number::Rational;
use slipmode_core::stability::boundary::{BoundaryCurve, BoundaryPoint, RouteComparison, compare_routes};

/// The boundary of one slider.
#[derive(Debug, Clone)]
pub struct BoundaryOutcome {
    /// Points along the arcs, cusp and corners among them, by the rational curve.
    pub points: Vec<BoundaryPoint>,
    /// The three routes side by side on sections through points of both arcs.
    pub comparison: RouteComparison,
    /// The digits requested.
    pub digits: u32,
}

/// How far off the asymptotes are at the ends of the sampled arcs: beyond, arc and asymptote are one line in any figure.
pub const END_ERROR: f64 = 1e-9;

/// Sections per arc on which the routes are compared: enough to meet every regime of both arcs, cheap enough for a scene.
const COMPARED_SECTIONS: usize = 24;

/// Computes the boundary; σ and V0 of the parameters play no part in it.
#[must_use]
pub fn boundary_outcome(parameters: &SceneParameters, section: BoundarySection) -> BoundaryOutcome {
    let anywhere = parameters.at(Rational::from(1), Rational::from(1));
    let curve = BoundaryCurve::new(&anywhere, section.digits);
    BoundaryOutcome {
        points: curve.sample(section.points as usize, END_ERROR),
        comparison: compare_routes(&anywhere, COMPARED_SECTIONS, section.digits),
        digits: section.digits,
    }
}
