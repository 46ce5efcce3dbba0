//! One section of the boundary in the groups, and its crossings: the points of the boundary at a given V0 or σ.

use crate::friction::OperatingPoint;
use crate::number::{Ball, Field, Real};
use crate::stability::Arc;
use crate::stability::boundary::by_curve::GUARD_BITS;
use crate::stability::boundary::{BoundaryCrossing, BoundaryCurve, BoundaryPoint, Section};
use crate::stability::double_root::{DoubleRoot, GivenGroup, Work, exactly};

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

    /// Every crossing: from its double root, or from the unknown group and λ for an arc on which 64-bit numbers give no answer.
    pub(super) fn each<T>(
        &self,
        quickly: impl Fn(DoubleRoot) -> Option<T>,
        generally: impl Fn(Arc, &Ball, &Ball) -> T,
    ) -> Vec<T> {
        let curve = self.curve;
        let bits = curve.bits - GUARD_BITS + COORDINATE_BITS;
        let mut all = Vec::with_capacity(3);
        for &arc in curve.arcs() {
            let found = curve.constants.found(arc, self.given, &self.value, bits);
            let quick: Option<Vec<T>> = found.and_then(|found| found.into_iter().map(&quickly).collect());
            let general = |[unknown, parameter]: &[Ball; 2]| generally(arc, unknown, parameter);
            all.extend(quick.unwrap_or_else(|| self.exactly(arc).iter().map(general).collect()));
        }
        all
    }

    /// The unknown group and λ at each point of an arc, whose number is decided exactly.
    fn exactly(&self, arc: Arc) -> Vec<[Ball; 2]> {
        let BoundaryCurve { slider, effect_ratio, bits, .. } = self.curve;
        let value = match self.section {
            Section::AtVelocity(velocity) => velocity.square() / slider.velocity_scale_squared(),
            Section::AtNormalStress(stress) => slider.stress_scale_pa() / stress,
        };
        exactly((arc, self.given), &value, effect_ratio, *bits)
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
}

impl BoundaryCurve {
    /// Every point of the boundary on a section, by arc, then from the quasi-static end on.
    ///
    /// At given V0: one on the upper arc (none for a = b), two, one (at the cusp) or none on the lower arc.
    /// At given σ: one on the upper arc above σ of eq 15; on the lower arc one below eq 16, two up to the cusp.
    #[must_use]
    pub fn on_section(&self, section: &Section) -> Vec<BoundaryPoint> {
        let line = SectionLine::new(self, section);
        let row = |arc: Arc, parameter: &Ball, unknown: &Ball| {
            let position = line.position(unknown).map(|part| part.with_precision(self.bits));
            BoundaryPoint::new(&self.frame, (arc, &parameter.with_precision(self.bits)), position, None)
        };
        line.each(
            |found| {
                let (arc, unknown) = (found.arc, found.unknown.clone());
                let parameter = self.constants.parameter(found, line.given, &line.value)?;
                Some(row(arc, &parameter, &unknown))
            },
            |arc, unknown, parameter| row(arc, parameter, unknown),
        )
    }

    /// The places of [`Self::on_section`] without λ, errors and condition number, in a quarter of its time.
    #[must_use]
    pub fn crossings(&self, section: &Section) -> Vec<BoundaryCrossing> {
        let line = SectionLine::new(self, section);
        let crossing = |arc: Arc, unknown: &Ball| BoundaryCrossing { arc, position: line.position(unknown) };
        line.each(|found| Some(crossing(found.arc, &found.unknown)), |arc, unknown, _| crossing(arc, unknown))
    }

    /// The sought coordinate of each of the crossings, σ at given V0 and V0 at given σ, to this curve's precision.
    pub(in crate::stability) fn coordinates(&self, section: &Section) -> Vec<Ball> {
        let sought = self.crossings(section).into_iter().map(|crossing| section.sought(crossing.position));
        sought.map(|value| value.with_precision(self.bits)).collect()
    }

    /// What each of the crossings takes; nothing for one that takes the general way, to its place or to its λ.
    #[must_use]
    pub fn work(&self, section: &Section) -> Vec<Option<Work>> {
        let line = SectionLine::new(self, section);
        let quickly = |found: DoubleRoot| {
            let work = found.work();
            self.constants.parameter(found, line.given, &line.value).map(|_| Some(work))
        };
        line.each(quickly, |_, _, _| None)
    }
}
