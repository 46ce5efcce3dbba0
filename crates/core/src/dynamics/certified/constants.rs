//! What the equations and the units are made of, enclosed over a box of parameters. A point is a box of one point.

use super::interval::Interval;
use crate::friction::{EvolutionLaw, Groups, ParameterBox, Parameters};
use crate::number::Rational;

/// η, κ and β, enclosed, and the law.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants {
    pub inertia: Interval,
    pub stiffness: Interval,
    pub effect_ratio: Interval,
    pub law: EvolutionLaw,
}

impl Constants {
    /// Those of one slider.
    pub fn of(groups: &Groups<Rational>, law: EvolutionLaw) -> Self {
        Self {
            inertia: Interval::of_rational(&groups.inertial_parameter),
            stiffness: Interval::of_rational(&groups.stiffness_group),
            effect_ratio: Interval::of_rational(&groups.effect_ratio),
            law,
        }
    }

    /// Those of all sliders in a box: each group rises with some values and falls with others, and is extreme at two corners.
    pub fn over(region: &ParameterBox, law: EvolutionLaw) -> Self {
        let [low, high] = [region.lower(), region.upper()];
        let corners = |up: &Parameters<Rational>, down: &Parameters<Rational>| {
            let (slider, point) = (up.slider.clone(), up.point.clone());
            // All three groups fall with a, and η and κ with σ.
            let mut corner = Parameters { slider, point };
            corner.slider.direct_effect.clone_from(&down.slider.direct_effect);
            corner.point.normal_stress_pa.clone_from(&down.point.normal_stress_pa);
            let others = corner.groups();
            // η falls with D_c, κ rises.
            corner.slider.critical_slip_distance_m.clone_from(&down.slider.critical_slip_distance_m);
            Groups { inertial_parameter: corner.groups().inertial_parameter, ..others }
        };
        let [least, largest] = [corners(&low, &high), corners(&high, &low)];
        let over = |of: fn(&Groups<Rational>) -> &Rational| Interval::over([of(&least), of(&largest)]);
        Self {
            inertia: over(|groups| &groups.inertial_parameter),
            stiffness: over(|groups| &groups.stiffness_group),
            effect_ratio: over(|groups| &groups.effect_ratio),
            law,
        }
    }
}

/// Enclosures in SI.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    velocity: Interval,
    time: Interval,
    stress: Interval,
}

impl Units {
    /// V_l, D_c/V_l and aσ over a box.
    pub fn over(region: &ParameterBox) -> Self {
        let [low, high] = [region.lower(), region.upper()];
        let [slowest, fastest] = [&low, &high].map(|slider| slider.point.loading_velocity_m_per_s.clone());
        let [shortest, longest] = [&low, &high].map(|slider| slider.slider.critical_slip_distance_m.clone());
        Self {
            velocity: Interval::over([&slowest, &fastest]),
            time: Interval::over([&(shortest / &fastest), &(longest / &slowest)]),
            stress: Interval::over([&low.direct_stress_pa(), &high.direct_stress_pa()]),
        }
    }

    fn velocity_of([low, high]: [f64; 2], unit: Interval) -> [f64; 2] {
        outward([low, high].map(|x| Interval::point(x).exp() * unit))
    }

    pub fn peak(&self, log_peak: [f64; 2]) -> [f64; 2] {
        Self::velocity_of(log_peak, self.velocity)
    }

    pub fn duration(&self, duration: Interval) -> [f64; 2] {
        outward([duration * self.time; 2])
    }

    pub fn drop(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        outward([low, high].map(|drop| Interval::point(drop) * self.stress))
    }
}

/// The lower end of the first and the upper end of the second, one number further out: the shortest decimals of these numbers are bounds too.
fn outward([low, high]: [Interval; 2]) -> [f64; 2] {
    [low.lower().next_down(), high.upper().next_up()]
}
