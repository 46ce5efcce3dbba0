//! Which figures there are, and what each needs.

use crate::exhibit::{deviation, frequency, maps, numerical_error, simulation_map};
use crate::study::{Need, Outcome};

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

/// All figures.
pub fn figure_makers() -> impl Iterator<Item = &'static FigureMaker> {
    [maps::FIGURES, frequency::FIGURES, deviation::FIGURES, simulation_map::FIGURES, numerical_error::FIGURES]
        .into_iter()
        .flatten()
}
