//! Zone maps: a plane divided into named regions with pattern, colour and name.

use super::frame::{CANVAS_WIDTH, Frame, SMALL};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::overlay::{draw_labels, draw_lines, draw_marks, draw_named_lines, legend_entries};
use super::path::{Point, simplify};
use super::path_data::outline_data;
use super::svg::Svg;
use super::{Axis, Caption, Line, PointMark, Readout, RegionLabel, palette};

/// A region of the plane.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Zone {
    /// Legend entry in figure markup.
    pub label: String,
    /// Outlines in axis values; an outline inside another is a hole.
    pub outlines: Vec<Vec<(f64, f64)>>,
    /// Pattern and colour, 0 to 7; equal numbers look alike in every figure.
    pub style: usize,
}

/// A plane divided into zones.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ZoneMap {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Zones, the later ones over the earlier ones.
    pub zones: Vec<Zone>,
    /// Lines over the zones.
    pub lines: Vec<Line>,
    /// Marked points.
    #[serde(skip)]
    pub marks: Vec<PointMark>,
    /// Names of zones.
    pub labels: Vec<RegionLabel>,
}

/// Upper left corner of the map on the canvas.
const CORNER: Point = (80.0, 14.0);
/// Width and height of the map.
const SIZE: Point = (544.0, 440.0);
/// Left edges of two maps side by side, their upper edge and their size.
const PAIR_LEFT: [f64; 2] = [78.0, 388.0];
const PAIR_TOP: f64 = 30.0;
const PAIR_SIZE: Point = (236.0, 236.0);
/// How far a drawn edge may lie from the given one, in canvas units: less than a grid step of a fine map.
const EDGE_TOLERANCE: f64 = 0.7;

impl ZoneMap {
    /// The map as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg_with(None)
    }

    /// The map as SVG text that carries words to be read out at its points.
    #[must_use]
    pub fn svg_with(&self, readout: Option<&Readout>) -> String {
        let frame = Frame::new(&self.x, &self.y, CORNER, SIZE);
        let legend = Legend::new(self.legend_entries(), CANVAS_WIDTH - CORNER.0);
        let below = frame.bounds.bottom + 60.0;
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, below + legend.height());
        define_patterns(&mut svg, self.zones.iter());
        frame.draw_panel(&mut svg, "panel-map");
        self.zones.iter().for_each(|zone| draw_zone(&mut svg, &frame, zone));
        draw_lines(&mut svg, &frame, &self.lines);
        draw_labels(&mut svg, &frame, &self.labels);
        draw_marks(&mut svg, &frame, &self.marks);
        frame.draw_axes(&mut svg);
        readout.iter().for_each(|readout| readout.draw(&mut svg, &frame));
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    /// This map and another with the same axes side by side, each under its heading, with one legend, as SVG text; the words to be
    /// read out are this map's.
    #[must_use]
    pub fn svg_beside(&self, other: &Self, headings: [&str; 2], readout: Option<&Readout>) -> String {
        let height = PAIR_TOP + PAIR_SIZE.1 + 60.0;
        let entries = self.legend_entries().into_iter().chain(other.legend_entries()).collect();
        let legend = Legend::new(entries, CANVAS_WIDTH - PAIR_LEFT[0]);
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, height + legend.height());
        define_patterns(&mut svg, self.zones.iter().chain(&other.zones));
        for (index, map) in [self, other].into_iter().enumerate() {
            let corner = (PAIR_LEFT[index], PAIR_TOP);
            let frame = Frame::new(&map.x, &map.y, corner, PAIR_SIZE);
            frame.draw_panel(&mut svg, "panel-map");
            map.zones.iter().for_each(|zone| draw_zone(&mut svg, &frame, zone));
            draw_named_lines(&mut svg, &frame, &map.lines, ["left-", "right-"][index]);
            draw_marks(&mut svg, &frame, &map.marks);
            frame.draw_axes(&mut svg);
            svg.open("g", &[("class", "ink"), ("fill", palette::INK), ("font-size", "13")]);
            svg.words((corner.0, PAIR_TOP - 9.0), headings[index], SMALL);
            svg.close();
            readout.filter(|_| index == 0).iter().for_each(|readout| readout.draw(&mut svg, &frame));
        }
        legend.draw(&mut svg, (PAIR_LEFT[0], height));
        svg.finish()
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let key = |style: usize| {
            move |svg: &mut Svg, (x, y): Point| {
                let fill = svg.url(&pattern_name(style));
                let attributes = [("fill", fill.as_str()), ("stroke", palette::ZONE_INKS[style])];
                svg.rect((x + 1.0, y - 7.5), (KEY_WIDTH - 9.0, 15.0), &attributes);
            }
        };
        let zones = self.zones.iter().map(|zone| Entry::new(&zone.label, key(look(zone.style))));
        zones.chain(legend_entries(&self.lines)).collect()
    }
}

fn define_patterns<'z>(svg: &mut Svg, zones: impl Iterator<Item = &'z Zone>) {
    let mut styles: Vec<usize> = zones.map(|zone| look(zone.style)).collect();
    styles.sort_unstable();
    styles.dedup();
    svg.open("defs", &[]);
    styles.into_iter().for_each(|style| define_pattern(svg, style));
    svg.close();
}

/// The colour of the zones of a style.
#[must_use]
pub fn zone_fill(style: usize) -> &'static str {
    palette::ZONES[look(style)]
}

fn look(style: usize) -> usize {
    style % palette::ZONES.len()
}

fn pattern_name(style: usize) -> String {
    format!("zone-{style}")
}

fn draw_zone(svg: &mut Svg, frame: &Frame, zone: &Zone) {
    let outline = |points: &Vec<Point>| {
        let visible = frame.visible_outline(points);
        let closed: Vec<Point> = visible.iter().chain(visible.first()).copied().collect();
        outline_data(&simplify(&closed, EDGE_TOLERANCE))
    };
    let data: String = zone.outlines.iter().map(outline).collect();
    let fill = svg.url(&pattern_name(look(zone.style)));
    // A hairline of the zone's own colour closes the gap that rounding leaves between neighbours.
    svg.leaf(
        "path",
        &[
            ("class", "zone"),
            ("d", &data),
            ("fill", &fill),
            ("fill-rule", "evenodd"),
            ("stroke", palette::ZONES[look(zone.style)]),
            ("stroke-width", "0.8"),
        ],
    );
}

/// A tile of the zone's colour with strokes or dots of its ink: the pattern alone distinguishes zones.
fn define_pattern(svg: &mut Svg, style: usize) {
    let (tile, strokes, dots): (f64, &str, &str) = match style {
        1 => (10.0, "", "M5 4.2a.8 .8 0 1 0 .01 0z"),
        2 => (9.0, "M-1 10L10 -1M-1 1L1 -1M8 10L10 8", ""),
        3 => (9.0, "M-1 -1L10 10M8 -1L10 1M-1 8L1 10", ""),
        4 => (9.0, "M0 4.5H9", ""),
        5 => (9.0, "M4.5 0V9", ""),
        6 => (11.0, "M0 5.5H11M5.5 0V11", ""),
        7 => (11.0, "M3 5.5H8M5.5 3V8", ""),
        _ => (10.0, "", ""),
    };
    let (id, size) = (svg.id(&pattern_name(style)), super::svg::number(tile));
    let ink = palette::ZONE_INKS[style];
    svg.open(
        "pattern",
        &[("id", &id), ("width", &size), ("height", &size), ("patternUnits", "userSpaceOnUse")],
    );
    svg.leaf("rect", &[("width", &size), ("height", &size), ("fill", palette::ZONES[style])]);
    if !strokes.is_empty() {
        svg.leaf(
            "path",
            &[("d", strokes), ("stroke", ink), ("stroke-width", "0.8"), ("stroke-opacity", "0.55")],
        );
    }
    if !dots.is_empty() {
        svg.leaf("path", &[("d", dots), ("fill", ink)]);
    }
    svg.close();
}
