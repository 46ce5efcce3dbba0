//! One section of the boundary in the groups, and its crossings.

use crate::friction::OperatingPoint;
use crate::number::{Ball, Field, Real};
use crate::stability::Arc;
use crate::stability::boundary::by_curve::GUARD_BITS;
use crate::stability::boundary::{BoundaryCurve, Section};
use crate::stability::double_root::{DoubleRoot, GivenGroup};
use crate::stability::parameter_equation::ParameterEquation;

/// Bits that a coordinate of a section has beyond the digits requested.
const COORDINATE_BITS: u32 = 4;

/// A section in the groups.
pub(super) struct SectionLine<'c> {
    curve: &'c BoundaryCurve,
    section: &'c Section,
    pub(super) given: GivenGroup,
    /// κ or g.
    pub(super) value: Ball,
    /// σ or V0.
    coordinate: Ball,
}

impl<'c> SectionLine<'c> {
    pub(super) fn new(curve: &'c BoundaryCurve, section: &'c Section) -> Self {
        let (given, coordinate) = match section {
            Section::AtNormalStress(stress) => (GivenGroup::StiffnessGroup, stress),
            Section::AtVelocity(velocity) => (GivenGroup::VelocitySquared, velocity),
        };
        let coordinate = Ball::from_rational(coordinate, curve.section_bits);
        let value = match given {
            GivenGroup::StiffnessGroup => curve.section_stress_scale_pa.clone() / &coordinate,
            GivenGroup::VelocitySquared => {
                (coordinate.clone() / &curve.section_velocity_scale_m_per_s).square()
            }
        };
        Self { curve, section, given, value, coordinate }
    }

    /// Every crossing: from its double root, or from its λ for an arc on which the former gives no answer.
    pub(super) fn each<T>(
        &self,
        quickly: impl Fn(DoubleRoot) -> Option<T>,
        generally: impl Fn(Arc, Ball) -> T,
    ) -> Vec<T> {
        let curve = self.curve;
        let bits = curve.bits - GUARD_BITS + COORDINATE_BITS;
        let mut all = Vec::with_capacity(3);
        for &arc in curve.arcs() {
            let found = curve.constants.found(arc, self.given, &self.value, bits);
            let quick: Option<Vec<T>> = found.and_then(|found| found.into_iter().map(&quickly).collect());
            let general =
                || self.parameters(arc).into_iter().map(|parameter| generally(arc, parameter)).collect();
            all.extend(quick.unwrap_or_else(general));
        }
        all
    }

    /// λ by the equation with √β, whose number of solutions is decided exactly.
    fn parameters(&self, arc: Arc) -> Vec<Ball> {
        let curve = self.curve;
        let equation = match self.section {
            Section::AtVelocity(velocity) => {
                let velocity_squared = Section::velocity_squared(&curve.slider, velocity);
                ParameterEquation::at_velocity(&curve.effect_ratio, arc, velocity_squared)
            }
            Section::AtNormalStress(stress) => {
                let stiffness_group = Section::stiffness_group(&curve.slider, stress);
                ParameterEquation::at_stiffness(&curve.effect_ratio, arc, stiffness_group)
            }
        };
        equation.roots(curve.bits)
    }

    /// σ and V0 where the unknown group is known: 1/κ at given V0, g at given σ.
    pub(super) fn position(&self, unknown: &Ball) -> OperatingPoint<Ball> {
        let (curve, given) = (self.curve, self.coordinate.clone());
        match self.given {
            GivenGroup::StiffnessGroup => OperatingPoint {
                normal_stress_pa: given,
                loading_velocity_m_per_s: unknown.sqrt() * &curve.section_velocity_scale_m_per_s,
            },
            GivenGroup::VelocitySquared => OperatingPoint {
                normal_stress_pa: unknown.clone() * &curve.section_stress_scale_pa,
                loading_velocity_m_per_s: given,
            },
        }
    }

    /// The unknown group at a parameter λ.
    pub(super) fn unknown(&self, arc: Arc, parameter: &Ball) -> Ball {
        let frame = &self.curve.frame;
        match self.given {
            GivenGroup::StiffnessGroup => frame.velocity_squared(arc, parameter),
            GivenGroup::VelocitySquared => frame.place(arc, parameter).0,
        }
    }
}
