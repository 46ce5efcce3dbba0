//! Values that several sections have: rectangles, axes, places, laws.

use crate::scene::section::{Entry, Section};
use crate::scene::{AllowedRange, LogAxis, Problem};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::Rational;

/// A rectangle of the (V, σ) plane with a logarithmic grid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rectangle {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
    /// Normal stresses, Pa.
    pub normal_stress_pa: LogAxis,
}

impl Rectangle {
    /// A section that is a rectangle, with no more points than the limit.
    pub(crate) fn read(entry: &Entry<'_>) -> Option<Self> {
        let mut section = entry.section()?;
        let rectangle = section.rectangle();
        section.finish();
        let rectangle = rectangle?;
        entry.check_points(rectangle.points())?;
        Some(rectangle)
    }

    /// How many points the grid has.
    pub(crate) fn points(&self) -> u64 {
        u64::from(self.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(self.normal_stress_pa.points))
    }
}

/// A point of the (V, σ) plane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlanePoint {
    /// V, m/s.
    pub loading_velocity_m_per_s: Rational,
    /// σ, Pa.
    pub normal_stress_pa: Rational,
}

/// The rule of [`check_name`](crate::scene::check_name) as messages state it.
pub(crate) const NAME_RULE: &str = "A-Z a-z 0-9 . _ -, at most 100 characters";

const PLACES: &str = "a list of { loading_velocity_m_per_s = …, normal_stress_pa = … }";

impl Section<'_> {
    /// The two axes of a rectangle; its points are compared with the limit by the caller.
    pub(crate) fn rectangle(&mut self) -> Option<Rectangle> {
        let [velocity, stress] = ["loading_velocity_m_per_s", "normal_stress_pa"].map(|key| self.axis(key));
        Some(Rectangle { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? })
    }

    /// `{ from, to, points }` with positive ends in ascending order.
    pub(crate) fn axis(&mut self, key: &'static str) -> Option<LogAxis> {
        let mut section = self.required(key, "{ from = …, to = …, points = … }")?.section()?;
        let ends = section.ends();
        let points = section.points();
        section.finish();
        let (from, to) = ends?;
        Some(LogAxis { from, to, points: points? })
    }

    /// A number of points within the limit.
    pub(crate) fn points(&mut self) -> Option<u32> {
        let allowed = format!("a whole number from 2 to {}", self.limits().max_points);
        let entry = self.required("points", &allowed)?;
        let points = entry.whole(2..=u64::MAX)?;
        entry.check_points(points)?;
        let allowed = || format!("at most {} points along one axis, for any limit", u32::MAX);
        entry.sound(u32::try_from(points).map_err(|_| Problem::OutOfRange { allowed: allowed() }))
    }

    /// A list of places.
    pub(crate) fn places(&mut self, key: &'static str) -> Option<Vec<PlanePoint>> {
        self.required(key, PLACES)?.list(|member| {
            let mut section = member.section()?;
            let [velocity, stress] = ["loading_velocity_m_per_s", "normal_stress_pa"]
                .map(|key| section.decimal(key, AllowedRange::PHYSICAL));
            section.finish();
            Some(PlanePoint { loading_velocity_m_per_s: velocity?, normal_stress_pa: stress? })
        })
    }

    /// The evolution laws, each once.
    pub(crate) fn laws(&mut self) -> Option<Vec<EvolutionLaw>> {
        self.required("laws", "a list of \"slip\" and \"aging\"")?.distinct(
            |law: &EvolutionLaw| format!("an earlier law `{}`", law.as_str()),
            |member| member.word(&EvolutionLaw::ALL, EvolutionLaw::as_str),
        )
    }
}
