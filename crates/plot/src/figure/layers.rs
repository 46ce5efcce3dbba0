//! Pictures of what rests on what: boxes in columns from left to right, joined by curves.

use std::collections::BTreeMap;

use super::frame::CANVAS_WIDTH;
use super::layer_places::{Slot, places};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::path::Point;
use super::path_data::{level_curve_data, line_data};
use super::svg::{Svg, number};
use super::{Caption, palette};

/// How boxes of one kind look, and the words for them in the legend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoxLook {
    /// Class, by which a page restyles them.
    pub class: String,
    /// Colour inside.
    pub fill: String,
    /// Colour of border and text.
    pub ink: String,
    /// Legend entry in figure markup.
    pub words: String,
}

/// One box.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoxNode {
    /// A few characters inside it.
    pub label: String,
    /// What it stands for, in plain words: its accessible name.
    pub name: String,
    /// Address that it leads to.
    pub link: String,
    /// Which of the looks it has.
    pub look: usize,
    /// Places in the list of the boxes that it rests on.
    pub rests_on: Vec<usize>,
}

/// Boxes, each to the right of those that it rests on.
#[derive(Debug, Clone, PartialEq)]
pub struct LayeredGraph {
    /// Id, title and description.
    pub caption: Caption,
    /// The looks, in the order of the legend.
    pub looks: Vec<BoxLook>,
    /// The boxes.
    pub nodes: Vec<BoxNode>,
    /// Legend entry of the curves in figure markup.
    pub curve_words: String,
}

/// Width and height of a box.
const BOX: Point = (62.0, 26.0);
/// Space around the picture.
const MARGIN: f64 = 8.0;
impl LayeredGraph {
    /// The picture as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let slots = self.slots();
        let (heights, tallest) = places(&slots);
        let columns = slots.iter().map(|slot| slot.column + 1).max().unwrap_or(1);
        let legend = Legend::new(self.legend_entries(), CANVAS_WIDTH - 2.0 * MARGIN);
        let below = tallest + 2.0 * MARGIN + 8.0;
        // Its boxes are links, which a picture of one piece would hide.
        let mut svg = Svg::with_role(&self.caption, CANVAS_WIDTH, below + legend.height(), "group");
        let stride = (CANVAS_WIDTH - 2.0 * MARGIN - BOX.0) / (columns.max(2) - 1) as f64;
        let corner = |slot: usize| {
            (MARGIN + stride * slots[slot].column as f64, MARGIN + tallest / 2.0 + heights[slot])
        };
        draw_curves(&mut svg, &slots, &corner);
        svg.open("g", &[("text-anchor", "middle"), ("font-size", "13"), ("font-weight", "600")]);
        for (index, slot) in slots.iter().enumerate() {
            if let Some(node) = slot.node.and_then(|node| self.nodes.get(node)) {
                self.draw_node(&mut svg, node, corner(index));
            }
        }
        svg.close();
        legend.draw(&mut svg, (MARGIN, below));
        svg.finish()
    }

    /// The column of each box: one further than the furthest that it rests on.
    fn columns(&self) -> Vec<usize> {
        let mut columns = vec![0; self.nodes.len()];
        // Boxes that rest on each other in a circle stop moving after as many rounds as there are boxes.
        for _ in 0..self.nodes.len() {
            for (index, node) in self.nodes.iter().enumerate() {
                let furthest = node.rests_on.iter().filter_map(|&on| columns.get(on)).max();
                columns[index] = furthest.map_or(0, |column| column + 1).min(self.nodes.len());
            }
        }
        columns
    }

    /// Boxes and passing curves; curves from one box pass a column together.
    fn slots(&self) -> Vec<Slot> {
        let columns = self.columns();
        let node_slot =
            |(node, &column): (usize, &usize)| Slot { column, node: Some(node), before: Vec::new() };
        let mut slots: Vec<Slot> = columns.iter().enumerate().map(node_slot).collect();
        let mut passing = BTreeMap::new();
        for (index, node) in self.nodes.iter().enumerate() {
            for &on in node.rests_on.iter().filter(|&&on| on < columns.len() && columns[on] < columns[index])
            {
                let mut last = on;
                for column in columns[on] + 1..columns[index] {
                    last = *passing.entry((on, column)).or_insert_with(|| {
                        slots.push(Slot { column, node: None, before: vec![last] });
                        slots.len() - 1
                    });
                }
                slots[index].before.push(last);
            }
        }
        slots
    }

    fn draw_node(&self, svg: &mut Svg, node: &BoxNode, (x, y): Point) {
        let Some(look) = self.looks.get(node.look) else { return };
        let class = format!("node {}", look.class);
        svg.open("a", &[("class", &class), ("href", &node.link)]);
        svg.title(&node.name);
        draw_box(svg, (x, y), BOX, look);
        let at = [number(x + BOX.0 / 2.0), number(y + 4.5)];
        svg.text(&[("x", &at[0]), ("y", &at[1]), ("fill", &look.ink)], &super::svg::escape(&node.label));
        svg.close();
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let boxes = self.looks.iter().enumerate();
        let used = boxes.filter(|(index, _)| self.nodes.iter().any(|node| node.look == *index));
        let curves = Entry::new(&self.curve_words, |svg, (x, y)| {
            let data = line_data(&[(x, y), (x + KEY_WIDTH - 8.0, y)]);
            svg.leaf("path", &curve_attributes(&data));
        });
        used.map(|(_, look)| legend_entry(look)).chain(std::iter::once(curves)).collect()
    }
}

fn legend_entry(look: &BoxLook) -> Entry<'_> {
    Entry::new(&look.words, move |svg, (x, y)| {
        svg.open("g", &[("class", &format!("node {}", look.class))]);
        draw_box(svg, (x, y), (KEY_WIDTH - 10.0, 14.0), look);
        svg.close();
    })
}

/// A box with the middle of its left side at a point.
fn draw_box(svg: &mut Svg, (x, y): Point, (width, height): Point, look: &BoxLook) {
    let attributes = [("rx", "4"), ("fill", look.fill.as_str()), ("stroke", look.ink.as_str())];
    svg.rect((x, y - height / 2.0), (width, height), &attributes);
}

fn curve_attributes(data: &str) -> [(&str, &str); 5] {
    [
        ("class", "edge"),
        ("d", data),
        ("fill", "none"),
        ("stroke", palette::FAINT_INK),
        ("stroke-width", "1.1"),
    ]
}

fn draw_curves(svg: &mut Svg, slots: &[Slot], corner: &dyn Fn(usize) -> Point) {
    let mut data = String::new();
    for (index, slot) in slots.iter().enumerate() {
        let (x, y) = corner(index);
        for &before in &slot.before {
            let from = corner(before);
            data += &level_curve_data((from.0 + BOX.0, from.1), (x, y));
        }
        if slot.node.is_none() {
            data += &line_data(&[(x, y), (x + BOX.0, y)]);
        }
    }
    if !data.is_empty() {
        svg.leaf("path", &curve_attributes(&data));
    }
}

#[cfg(test)]
mod tests {
    use super::super::layer_places::row;
    use super::*;

    fn graph(rests_on: &[&[usize]]) -> LayeredGraph {
        let node = |(index, on): (usize, &&[usize])| BoxNode {
            label: format!("n{index}"),
            name: format!("<node> {index}"),
            link: format!("#n{index}"),
            look: 0,
            rests_on: on.to_vec(),
        };
        LayeredGraph {
            caption: Caption::new("graph", "Graph", "Boxes."),
            looks: vec![BoxLook {
                class: "plain".into(),
                fill: "#ffffff".into(),
                ink: "#000000".into(),
                words: "plain".into(),
            }],
            nodes: rests_on.iter().enumerate().map(node).collect(),
            curve_words: "rests on".into(),
        }
    }

    #[test]
    fn a_box_stands_right_of_all_that_it_rests_on() {
        assert_eq!(graph(&[&[], &[0], &[1, 0], &[]]).columns(), [0, 1, 2, 0]);
    }

    #[test]
    fn a_circle_and_an_unknown_box_do_no_harm() {
        let svg = graph(&[&[1], &[0], &[7]]).svg();
        assert_eq!(svg.matches("<a ").count(), 3);
    }

    #[test]
    fn no_two_boxes_overlap_and_long_curves_pass_between_them() {
        let graph = graph(&[&[], &[0], &[1], &[2, 0], &[0], &[0], &[4, 1]]);
        let slots = graph.slots();
        let (heights, tallest) = places(&slots);
        assert_eq!(slots.len(), 7 + 2, "the curve from 0 to 3 passes two columns");
        for (one, two) in (0..slots.len()).flat_map(|one| (0..one).map(move |two| (one, two))) {
            let apart = (row(&slots[one]) + row(&slots[two])) / 2.0 - 1e-9;
            let clear =
                slots[one].column != slots[two].column || (heights[one] - heights[two]).abs() >= apart;
            assert!(clear, "{one} {two} {heights:?}");
        }
        assert!(heights.iter().all(|height| height.abs() <= tallest / 2.0));
    }

    #[test]
    fn every_box_is_a_named_link_and_words_stay_words() {
        let svg = graph(&[&[], &[0]]).svg();
        assert!(svg.contains("role=\"group\"") && svg.contains("href=\"#n1\""));
        assert!(svg.contains("<title>&lt;node&gt; 1</title>") && !svg.contains("<node>"), "{svg}");
    }
}
