//! Values that several sections have: rectangles, axes, places, laws.

use crate::scene::section::Section;
use crate::scene::{AllowedRange, LogAxis, Problem};
use slipmode_core::friction::{EvolutionLaw, OperatingPoint};
use slipmode_core::number::Rational;

/// A rectangle of the (V, σ) plane with a logarithmic grid.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Rectangle {
    /// Loading velocities, m/s.
    pub loading_velocity_m_per_s: LogAxis,
    /// Normal stresses, Pa.
    pub normal_stress_pa: LogAxis,
}

impl Rectangle {
    /// How many points the grid has.
    pub(crate) fn points(&self) -> u64 {
        u64::from(self.loading_velocity_m_per_s.points)
            .saturating_mul(u64::from(self.normal_stress_pa.points))
    }
}

/// A point of the (V, σ) plane.
pub type PlanePoint = OperatingPoint<Rational>;

/// The rule of [`check_name`](crate::scene::check_name) as messages state it.
pub(crate) const NAME_RULE: &str = "A-Z a-z 0-9 . _ -, at most 100 characters";

const PLACES: &str = "a list of { loading_velocity_m_per_s = …, normal_stress_pa = … }";

impl Section<'_> {
    /// The two axes of a rectangle; its points are compared with the limit by the caller.
    pub(crate) fn rectangle(&mut self) -> Rectangle {
        let [loading_velocity_m_per_s, normal_stress_pa] =
            ["loading_velocity_m_per_s", "normal_stress_pa"].map(|key| self.axis(key));
        Rectangle { loading_velocity_m_per_s, normal_stress_pa }
    }

    /// `{ from, to, points }` with positive ends in ascending order.
    pub(crate) fn axis(&mut self, key: &'static str) -> LogAxis {
        self.read(key, "{ from = …, to = …, points = … }", |entry| {
            entry.table(|section| {
                let (from, to) = section.ends();
                LogAxis { from, to, points: section.points() }
            })
        })
    }

    /// A number of points within the limit.
    pub(crate) fn points(&mut self) -> u32 {
        let allowed = format!("a whole number from 2 to {}", self.limits().max_points);
        self.read("points", &allowed, |entry| {
            let points = entry.whole(2..=u64::MAX)?;
            entry.check_points(points)?;
            let allowed = || format!("at most {} points along one axis, for any limit", u32::MAX);
            entry.sound(u32::try_from(points).map_err(|_| Problem::OutOfRange { allowed: allowed() }))
        })
    }

    /// A list of places.
    pub(crate) fn places(&mut self, key: &'static str) -> Vec<PlanePoint> {
        self.list(key, PLACES, |member| {
            member.table(|section| {
                let [loading_velocity_m_per_s, normal_stress_pa] =
                    ["loading_velocity_m_per_s", "normal_stress_pa"]
                        .map(|key| section.decimal(key, AllowedRange::PHYSICAL));
                PlanePoint { loading_velocity_m_per_s, normal_stress_pa }
            })
        })
    }

    /// The evolution laws, each once.
    pub(crate) fn laws(&mut self) -> Vec<EvolutionLaw> {
        self.read("laws", "a list of \"slip\" and \"aging\"", |entry| {
            entry.distinct(
                |law: &EvolutionLaw| format!("an earlier law `{}`", law.as_str()),
                |member| member.word(&EvolutionLaw::ALL, EvolutionLaw::as_str),
            )
        })
    }

    /// A SHA-256 in hexadecimal digits.
    pub(crate) fn digest(&mut self, key: &'static str, allowed: &str) -> String {
        let digest = self.text(key, allowed);
        let is_digest = digest.len() == 64 && digest.bytes().all(|byte| b"0123456789abcdef".contains(&byte));
        if !is_digest && !digest.is_empty() {
            self.refuse(Problem::Needs(format!("a {key} of 64 digits 0-9 a-f")));
        }
        digest
    }
}
