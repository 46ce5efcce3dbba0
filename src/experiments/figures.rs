//! Which figures there are: `figures.toml` describes them, and a function draws each.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::experiments::{Need, Outcome};
use crate::scene::cited;
use slipmode_plot::figure::{Axis, Caption, Panel, Panels, ZoneMap};

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
        let Caption { id, description, .. } = caption.clone();
        let (label, caption_markdown) = (label.into(), caption_markdown.into());
        Self { id, label, caption_markdown, description, svg, data: Vec::new() }
    }

    /// The same with the ids of the tables that hold its numbers.
    #[must_use]
    pub fn with_data(self, data: &[impl ToString]) -> Self {
        Self { data: data.iter().map(ToString::to_string).collect(), ..self }
    }

    /// Whether the paper has such a figure.
    #[must_use]
    pub fn has_number_of_the_paper(&self) -> bool {
        let number = self.label.split_once(' ').map_or("", |(_, number)| number);
        number.starts_with(|first: char| first.is_ascii_digit())
    }
}

/// What a figure says besides its drawing.
#[derive(Debug, Clone)]
pub struct Words {
    /// Id, title and description.
    pub caption: Caption,
    /// The number that the paper gives it; empty for a figure that the paper does not have.
    pub label: String,
    /// What it shows and what to look at, in Markdown.
    pub markdown: String,
}

impl Words {
    /// Puts values in the place of their names in braces.
    pub(crate) fn fill(&mut self, values: &[(&str, &str)]) {
        let Caption { title, description, .. } = &mut self.caption;
        for text in [title, description, &mut self.markdown] {
            for (name, value) in values {
                *text = text.replace(&format!("{{{name}}}"), value);
            }
        }
    }

    /// A zone map without zones.
    pub(crate) fn zone_map(&self, x: Axis, y: Axis) -> ZoneMap {
        let (zones, lines, marks, labels) = Default::default();
        ZoneMap { caption: self.caption.clone(), x, y, zones, lines, marks, labels }
    }

    /// Small charts in rows as SVG; none without a chart.
    pub(crate) fn panels(&self, columns: usize, height: f64, panels: Vec<Panel>) -> Option<String> {
        let is_empty = panels.is_empty();
        let panels = Panels { caption: self.caption.clone(), columns, height, panels };
        (!is_empty).then(|| panels.svg())
    }
}

/// Draws a figure as SVG, whose words it may complete; `None` when the scenes do not hold what it shows.
type Draw = fn(&Outcome, &mut Words) -> Option<String>;

/// The id of a figure, and what draws it.
pub type Drawer = (&'static str, Draw);

/// How a figure is made.
#[derive(Debug)]
pub struct FigureMaker {
    /// The figure's id.
    pub id: &'static str,
    /// What must have been computed.
    pub needs: Vec<Need>,
    /// Ids of the tables that hold its numbers.
    pub data: Vec<String>,
    words: Words,
    draw: Draw,
}

impl FigureMaker {
    /// How a figure with a drawer is made.
    pub(crate) fn new(&(id, draw): &Drawer) -> Option<Self> {
        let Described { label, needs, data, title, caption, description, .. } =
            DESCRIBED.iter().find(|one| one.id == id)?;
        let needs = Need::ALL.iter().copied().filter(|need| needs.iter().any(|key| key == need.key()));
        let words = Words {
            caption: Caption::new(id, &cited(title), &cited(description)),
            label: label.clone(),
            markdown: cited(caption),
        };
        Some(Self { id, needs: needs.collect(), data: data.clone(), words, draw })
    }

    /// The figure; `None` when the scenes do not hold what it shows.
    #[must_use]
    pub fn figure(&self, outcome: &Outcome) -> Option<Figure> {
        let mut words = self.words.clone();
        let svg = (self.draw)(outcome, &mut words)?;
        Some(Figure::new(&words.caption, &words.label, &words.markdown, svg).with_data(&self.data))
    }

    /// Id, title and description.
    pub(crate) fn caption(&self) -> &Caption {
        &self.words.caption
    }
}

/// A figure in the file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Described {
    id: String,
    #[serde(default)]
    label: String,
    needs: Vec<String>,
    data: Vec<String>,
    title: String,
    caption: String,
    description: String,
}

static DESCRIBED: LazyLock<Vec<Described>> = LazyLock::new(|| list_in(include_str!("figures.toml")));

/// The list of a file that has nothing besides.
pub(super) fn list_in<T: DeserializeOwned>(text: &str) -> Vec<T> {
    let file: Option<BTreeMap<String, Vec<T>>> = toml::from_str(text).ok();
    file.into_iter().flat_map(BTreeMap::into_values).flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiments::drawers;
    use crate::experiments::{figure_makers, table_makers};

    #[test]
    fn every_described_figure_is_drawn_and_names_computations_and_tables_that_exist() {
        let made: Vec<&str> = figure_makers().map(|maker| maker.id).collect();
        assert!(made.len() > 20);
        for described in DESCRIBED.iter() {
            let id = described.id.as_str();
            assert_eq!(made.iter().filter(|one| **one == id).count(), 1, "{id}");
            let maker = figure_makers().find(|maker| maker.id == id).unwrap();
            assert_eq!(maker.needs.len(), described.needs.len(), "{id}");
            for table in &maker.data {
                let is_known = table_makers().any(|maker| maker.id == *table) || table == "hopf-coefficient";
                assert!(is_known, "{id}: {table}");
            }
        }
        assert_eq!(drawers().count(), DESCRIBED.len(), "a drawer without a description");
    }
}
