//! Which figures there are, and what each needs.

use crate::experiments::{Need, Outcome};
use slipmode_plot::figure::Caption;

/// A figure that is ready to be placed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// The id by which prose places it, and the name of its file.
    pub id: String,
    /// Label such as `Figure 1`, the number that the paper gives it. The report gives numbers to all others.
    pub label: String,
    /// What it shows and what to look at, in Markdown.
    pub caption_markdown: String,
    /// Description for those who cannot see it.
    pub description: String,
    /// The drawing.
    pub svg: String,
    /// Ids of the tables that hold its numbers.
    pub data: Vec<String>,
}

impl Figure {
    /// A drawing with its caption.
    #[must_use]
    pub fn new(caption: &Caption, label: &str, caption_markdown: &str, svg: String) -> Self {
        Self {
            id: caption.id.clone(),
            label: label.into(),
            caption_markdown: caption_markdown.into(),
            description: caption.description.clone(),
            svg,
            data: Vec::new(),
        }
    }

    /// A drawing that the paper does not have: the report numbers it.
    #[must_use]
    pub fn own(caption: &Caption, caption_markdown: &str, svg: String) -> Self {
        Self::new(caption, "", caption_markdown, svg)
    }

    /// Whether the paper has such a figure.
    #[must_use]
    pub fn has_number_of_the_paper(&self) -> bool {
        let number = self.label.split_once(' ').map_or("", |(_, number)| number);
        number.starts_with(|first: char| first.is_ascii_digit())
    }

    /// The same with the ids of the tables that hold its numbers.
    #[must_use]
    pub fn with_data(self, data: &[&str]) -> Self {
        Self { data: data.iter().map(|&id| id.to_owned()).collect(), ..self }
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

impl FigureMaker {
    /// How the figure with this id is made.
    pub(crate) const fn new(
        id: &'static str,
        needs: &'static [Need],
        data: &'static [&'static str],
        make: fn(&Outcome) -> Option<Figure>,
    ) -> Self {
        Self { id, needs, data, make }
    }
}
