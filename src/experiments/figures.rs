//! Which figures there are: `figures.toml` describes them and their charts, and a function puts in the numbers of each.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::experiments::described::with_points;
use crate::experiments::{Need, Outcome};
use crate::scene::cited;
use slipmode_plot::figure::{Caption, Panel, Panels};

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
    pub(crate) fn new(caption: &Caption, label: &str, caption_markdown: &str, svg: String) -> Self {
        let Caption { id, description, .. } = caption.clone();
        let (label, caption_markdown) = (label.into(), caption_markdown.into());
        Self { id, label, caption_markdown, description, svg, data: Vec::new() }
    }

    /// The same with the ids of the tables that hold its numbers.
    pub(crate) fn with_data(self, data: &[impl ToString]) -> Self {
        Self { data: data.iter().map(ToString::to_string).collect(), ..self }
    }

    /// Whether the paper has such a figure.
    pub(crate) fn has_number_of_the_paper(&self) -> bool {
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
    /// What the drawing shows besides numbers, as TOML.
    drawing: String,
}

impl Words {
    /// Puts values in the place of their names in braces. They have no quotation mark and no backslash: the drawing stays TOML.
    pub(crate) fn fill(&mut self, values: &[(&str, &str)]) {
        let Caption { title, description, .. } = &mut self.caption;
        for text in [title, description, &mut self.markdown, &mut self.drawing] {
            for (name, value) in values {
                *text = text.replace(&format!("{{{name}}}"), value);
            }
        }
    }

    /// The drawing as the file describes it, still without numbers.
    pub(crate) fn drawing<T: DeserializeOwned>(&self) -> Option<T> {
        toml::from_str(&self.drawing).ok()
    }

    /// The described chart with the points of its series, as SVG.
    pub(crate) fn line_chart(&self, lines: impl IntoIterator<Item = Vec<(f64, f64)>>) -> Option<String> {
        Some(with_points(self.drawing()?, lines)?.svg())
    }

    /// The last of the described small charts, with values in the place of their names in braces.
    pub(crate) fn panel(&self, values: &[(&str, &str)]) -> Option<Panel> {
        let mut own = self.clone();
        own.fill(values);
        own.drawing::<Panels>()?.panels.pop()
    }

    /// Small charts in rows as SVG; none without a chart.
    pub(crate) fn panels(&self, panels: impl Iterator<Item = Panel>) -> Option<String> {
        let panels = Panels { panels: panels.collect(), ..self.drawing()? };
        (!panels.panels.is_empty()).then(|| panels.svg())
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
        let Described { label, needs, data, title, caption: markdown, description, drawing, .. } =
            DESCRIBED.iter().find(|one| one.id == id)?;
        let needs = Need::ALL.iter().copied().filter(|need| needs.iter().any(|key| key == need.key()));
        let caption = Caption::new(id, &cited(title), &cited(description));
        let mut drawing = drawing.clone();
        drawing.insert("caption".into(), toml::Value::try_from(&caption).ok()?);
        let (label, markdown, drawing) = (label.clone(), cited(markdown), cited(&drawing.to_string()));
        let words = Words { caption, label, markdown, drawing };
        Some(Self { id, needs: needs.collect(), data: data.clone(), words, draw })
    }

    /// The figure; `None` when the scenes do not hold what it shows.
    pub(crate) fn figure(&self, outcome: &Outcome) -> Option<Figure> {
        let mut words = self.words();
        let svg = (self.draw)(outcome, &mut words)?;
        Some(Figure::new(&words.caption, &words.label, &words.markdown, svg).with_data(&self.data))
    }

    /// Its words.
    pub(crate) fn words(&self) -> Words {
        self.words.clone()
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
    #[serde(default)]
    drawing: toml::Table,
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
    use slipmode_plot::figure::{HeatMap, LineChart, RangeChart, ZoneMap};

    #[test]
    fn every_drawing_describes_a_chart_and_has_the_caption_of_its_figure() {
        for maker in figure_makers() {
            let words = maker.words();
            let captions = [
                words.drawing::<LineChart>().map(|chart| chart.caption),
                words.drawing::<Panels>().map(|panels| panels.caption),
                words.drawing::<HeatMap>().map(|map| map.caption),
                words.drawing::<ZoneMap>().map(|map| map.caption),
                words.drawing::<RangeChart>().map(|chart| chart.caption),
            ];
            let found: Vec<Caption> = captions.into_iter().flatten().collect();
            assert!(found.first() == Some(&words.caption), "{}: {found:?}", maker.id);
        }
    }

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
