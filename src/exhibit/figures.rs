//! Which figures there are, and what each needs.

use crate::study::{Need, Outcome};
use slipmode_plot::figure::Caption;

/// A figure that is ready to be placed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// The id by which prose places it, and the name of its file.
    pub id: String,
    /// Label such as `Figure 1`.
    pub label: String,
    /// What it shows and what to look at, in Markdown.
    pub caption_markdown: String,
    /// Description for those who cannot see it.
    pub description: String,
    /// The drawing.
    pub svg: String,
}

impl Figure {
    /// The figure of a drawing with this caption.
    pub(super) fn new(caption: Caption, label: &str, caption_markdown: &str, svg: String) -> Self {
        Self {
            id: caption.id,
            label: label.into(),
            caption_markdown: caption_markdown.into(),
            description: caption.description,
            svg,
        }
    }
}

/// How a figure is made.
#[derive(Debug)]
pub struct FigureMaker {
    /// The figure's id.
    pub id: &'static str,
    /// What must have been computed.
    pub needs: &'static [Need],
    /// Ids of the tables that hold its numbers.
    pub data: &'static [&'static str],
    /// Draws it; `None` when the scenes do not hold what it shows.
    pub make: fn(&Outcome) -> Option<Figure>,
}

/// The figures of every room, a line each.
const ROOMS: &[&[FigureMaker]] = &[
    crate::exhibit::deviation::FIGURES,
    crate::exhibit::frequency::FIGURES,
    crate::exhibit::least_peak::FIGURES,
    crate::exhibit::linear_regime::FIGURES,
    crate::exhibit::maps::FIGURES,
    crate::exhibit::near_transition::FIGURES,
    crate::exhibit::numerical_error::FIGURES,
    crate::exhibit::onset::FIGURES,
    crate::exhibit::overshoot_map::FIGURES,
    crate::exhibit::phase_portraits::FIGURES,
    crate::exhibit::simulation_map::FIGURES,
    crate::exhibit::speed_figures::FIGURES,
    crate::exhibit::swept::FIGURES,
    crate::exhibit::trajectory_figures::FIGURES,
];

/// All figures.
pub fn figure_makers() -> impl Iterator<Item = &'static FigureMaker> {
    ROOMS.iter().copied().flatten()
}
