//! Which figures there are, and what each needs.

use crate::experiments::{Need, Outcome};
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
    pub(crate) fn new(caption: Caption, label: &str, caption_markdown: &str, svg: String) -> Self {
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
    crate::experiments::tolerance::figures::FIGURES,
    crate::experiments::frequency::figures::FIGURES,
    crate::experiments::simulations::least_peak_figures::FIGURES,
    crate::experiments::linear_regime::figures::FIGURES,
    crate::experiments::map::figures::FIGURES,
    crate::experiments::near_transition::figures::FIGURES,
    crate::experiments::original_scheme::figures::FIGURES,
    crate::experiments::onset::figures::FIGURES,
    crate::experiments::simulations::overshoot_figure::FIGURES,
    crate::experiments::trajectories::phase_portraits::FIGURES,
    crate::experiments::simulations::map_figure::FIGURES,
    crate::experiments::speed_counts::figures::FIGURES,
    crate::experiments::swept::figures::FIGURES,
    crate::experiments::trajectories::figures::FIGURES,
];

/// All figures.
pub fn figure_makers() -> impl Iterator<Item = &'static FigureMaker> {
    ROOMS.iter().copied().flatten()
}
