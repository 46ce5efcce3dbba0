//! The points that a page of a scene follows.

use slipmode_core::{friction::OperatingPoint, number::Rational};

use super::{NamedPoint, Window};
use crate::experiments::Scene;
use crate::scene::ParametersSection;

/// Points on a page at most: each takes about 40 kB.
const MOST_POINTS: usize = 8;

/// The points that are followed, and a sentence on where they come from.
#[must_use]
pub fn points(
    scene: &Scene,
    parameters: &ParametersSection,
    own: Option<&OperatingPoint<Rational>>,
    window: Window,
) -> (Vec<NamedPoint>, String) {
    let own_point = own.map(|own| named("given", own.clone(), false));
    let of_the_scene = parameters.point().map(|point| named("scene", point, true));
    let trajectories = scene.trajectories.iter().flat_map(|section| &section.points).map(|point| {
        let place = [&point.normal_stress_pa, &point.loading_velocity_m_per_s].map(Rational::clone);
        named(&point.id, place.into(), false)
    });
    let mut points: Vec<_> = own_point.into_iter().chain(of_the_scene).chain(trajectories).collect();
    let stated = points.len();
    points.truncate(MOST_POINTS);
    let words = match stated {
        0 => {
            points.push(middle(window));
            "The scene has no points; the marked point is the middle of the map.".into()
        }
        _ if stated > MOST_POINTS => {
            format!("The points are the first {MOST_POINTS} of the {stated} points of the scene.")
        }
        _ if own.is_some() => "The points are the given operating point and the points of the scene.".into(),
        _ => "The points are the points of the scene.".into(),
    };
    (points, words)
}

/// The middle of the axes, as the binary numbers that it is nearest to.
fn middle(window: Window) -> NamedPoint {
    let middle = |(low, high): (f64, f64)| {
        let decade = (libm::log10(low) + libm::log10(high)) / 2.0;
        Rational::from_f64(libm::exp10(decade)).unwrap_or_default()
    };
    named("middle", [window.stress, window.velocity].map(middle).into(), false)
}

fn named(name: &str, place: OperatingPoint<Rational>, has_error_bars: bool) -> NamedPoint {
    NamedPoint { name: name.into(), place, has_error_bars }
}
