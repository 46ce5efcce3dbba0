//! The slip modes of a slider under its own weight, in the plane of loading velocity and K/M.

use crate::experiments::boundary::BoundaryOutcome;
use crate::experiments::zones::figures::present_zones;
use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::friction::Groups;
use slipmode_core::number::{Ball, nearest_f64};
use slipmode_core::stability::Arc;
use slipmode_plot::figure::{Line, LineRole, ZoneMap};

pub(crate) const FIGURES: &[Drawer] =
    &[("own-weight", |outcome, words| outcome.scenes.iter().find_map(|scene| plane(scene, words)))];

fn plane(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let (found, boundary) = (scene.own_weight.as_ref()?, scene.boundary.as_ref()?);
    let (velocities, ratios) = (&found.loading_velocity_m_per_s, &found.stiffness_over_mass_per_s2);
    let mut map: ZoneMap = words.drawing()?;
    (map.x.min, map.x.max) = (*velocities.first()?, *velocities.last()?);
    (map.y.min, map.y.max) = (*ratios.first()?, *ratios.last()?);
    map.zones = present_zones(found.slip_modes.iter().copied(), velocities.len(), &map.x, &map.y);
    map.lines = lines(scene, boundary, [map.x.min, map.x.max])?;
    Some(map.svg())
}

/// Vertices of the transition.
const VERTICES: u32 = 100;

/// The boundary and the transition: η = V²/(g a D_c) and κ = (K/M)·D_c/(g a).
fn lines(scene: &SceneOutcome, boundary: &BoundaryOutcome, [from, to]: [f64; 2]) -> Option<Vec<Line>> {
    let gravity = nearest_f64(&scene.scene.own_weight.as_ref()?.gravity_m_per_s2);
    let slider = scene.slider()?.map(nearest_f64);
    let distance = slider.critical_slip_distance_m;
    let effect = slider.direct_effect * gravity;
    let arc = |arc: Arc| {
        let points = boundary.points.iter().filter(|point| point.arc == arc);
        let points = points.map(|point| {
            let Groups { inertial_parameter, stiffness_group, .. } = point.groups.map(Ball::to_f64);
            ((inertial_parameter * effect * distance).sqrt(), stiffness_group * effect / distance)
        });
        Line::new("exact boundary max Im(*s*) = 0", LineRole::Boundary, points.collect())
    };
    let level = (slider.evolution_effect - slider.direct_effect) * gravity / distance;
    let transition = (0..=VERTICES).map(|index| {
        let velocity = from * libm::pow(to / from, f64::from(index) / f64::from(VERTICES));
        (velocity, level * (1.0 + velocity * velocity / (effect * distance)))
    });
    let here = slider.stiffness_pa_per_m / slider.mass_per_area_kg_per_m2;
    let mut lines = vec![arc(Arc::Upper), arc(Arc::Lower)];
    if level > 0.0 {
        lines.push(Line::new("transition *K* = *K*_c", LineRole::Transition, transition.collect()));
    }
    lines.push(Line::new("*K*/*M* of this report", LineRole::Guide, vec![(from, here), (to, here)]));
    Some(lines)
}
