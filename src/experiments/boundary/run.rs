//! The exact boundary of a scene, and whether its three routes agree.

use crate::experiments::boundary::BoundarySection;
use slipmode_core::friction::Slider;
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

/// Computes the boundary.
pub(super) fn boundary_outcome(parameters: &Slider<Rational>, section: BoundarySection) -> BoundaryOutcome {
    let curve = BoundaryCurve::new(parameters, section.digits);
    BoundaryOutcome {
        points: curve.sample(section.points as usize, END_ERROR),
        comparison: compare_routes(parameters, COMPARED_SECTIONS, section.digits),
        digits: section.digits,
    }
}
