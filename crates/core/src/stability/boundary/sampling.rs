//! Points spread along the arcs, the same ones on every machine.

use std::cmp::Ordering;

use rug::Float;

use crate::number::Ball;
use crate::stability::Arc;
use crate::stability::boundary::{BoundaryCurve, BoundaryPoint, Mark};
use crate::stability::deviation::corner_normal_stress_parameter;
use crate::stability::parameter_equation::ParameterEquation;

/// Bits that place a sample; the points themselves are exact for their λ, wherever it is.
const PLACING_BITS: u32 = 53;

impl BoundaryCurve {
    /// `count` points on each arc, from the quasi-static end to the inertial one, with the marked points in between.
    ///
    /// λ is spaced evenly in its logarithm, and reaches so far that the asymptotes are off by about `end_error` at the
    /// ends: the relative error is 1/(λ√β) at the one and λβ/(1+√β) at the other.
    #[must_use]
    pub fn sample(&self, count: usize, end_error: f64) -> Vec<BoundaryPoint> {
        let mut points = Vec::new();
        for &arc in self.arcs() {
            let mut places: Vec<(Ball, Option<Mark>)> =
                self.sample_parameters(count, end_error).into_iter().map(|place| (place, None)).collect();
            places.extend(self.marked_parameters(arc));
            places.sort_by(|x, y| y.0.centre().partial_cmp(x.0.centre()).unwrap_or(Ordering::Equal));
            points.extend(places.iter().map(|(parameter, mark)| self.point(arc, parameter, *mark)));
        }
        points
    }

    /// The parameters of the samples, exact dyadics, ascending.
    #[must_use]
    pub fn sample_parameters(&self, count: usize, end_error: f64) -> Vec<Ball> {
        let log_ratio = log2(&self.frame.root_ratio);
        let reach = -libm::log2(end_error);
        let low = log2(&self.frame.sum) - 2.0 * log_ratio - reach;
        let high = reach - log_ratio;
        let step = (high - low) / (count.max(2) - 1) as f64;
        (0..count).map(|index| power_of_two(low + step * index as f64)).collect()
    }

    /// λ of the cusp, and of the points at the coordinates of the asymptotes' corner: an arc has its V0 once (upper arc) or twice (lower
    /// arc, whose cusp lies beyond the corner), and the lower arc has the σ of eq 16 once.
    fn marked_parameters(&self, arc: Arc) -> Vec<(Ball, Option<Mark>)> {
        let at_velocity = ParameterEquation::at_corner_velocity(&self.effect_ratio, arc).roots(self.bits);
        let mut marked: Vec<_> =
            at_velocity.into_iter().map(|parameter| (parameter, Some(Mark::CornerVelocity))).collect();
        if arc == Arc::Lower {
            let at_stress = corner_normal_stress_parameter(&self.frame);
            marked.push((self.cusp_parameter.clone(), Some(Mark::Cusp)));
            marked.push((at_stress, Some(Mark::CornerNormalStress)));
        }
        marked
    }

    /// The cusp: the point of the lower arc where σ and V0 are both as large as they get.
    #[must_use]
    pub fn cusp(&self) -> BoundaryPoint {
        self.point(Arc::Lower, &self.cusp_parameter, Some(Mark::Cusp))
    }
}

pub(in crate::stability) fn log2(value: &Ball) -> f64 {
    Float::with_val(PLACING_BITS, value.centre()).log2().to_f64()
}

/// 2^exponent, the fraction by a correctly portable exp2 and the integer exactly.
pub(in crate::stability) fn power_of_two(exponent: f64) -> Ball {
    let whole = exponent.floor();
    let fraction = Float::with_val(PLACING_BITS, libm::exp2(exponent - whole));
    Ball::exact(fraction << whole as i32)
}
