//! The figure of the asymptotes' errors along the boundary.

use crate::experiments::{Drawer, SceneOutcome, Words};
use slipmode_core::stability::boundary::{BoundaryPoint, ErrorPair};
use slipmode_core::stability::{ArcFrame, Asymptote};

pub(crate) const FIGURES: &[Drawer] =
    &[("deviation", |outcome, words| along_arcs(outcome.potentially_unstable()?, words))];

fn along_arcs(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let outcome = scene.boundary.as_ref()?;
    let frame = ArcFrame::of_rational(&scene.slider()?.effect_ratio(), 128);
    let errors = |asymptote: Asymptote| {
        let points = outcome.points.iter().filter(|point| point.arc == asymptote.arc());
        let place = |point: &BoundaryPoint| {
            let pair = ErrorPair::at(&frame, point.arc, &point.parameter);
            let error = if asymptote.is_quasi_static() { pair.quasi_static } else { pair.inertial };
            (point.groups.inertial_parameter.to_f64(), error.to_f64())
        };
        points.map(place).collect()
    };
    words.line_chart(Asymptote::ALL.map(errors))
}
