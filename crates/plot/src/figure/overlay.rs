//! What is drawn over a map: lines, points and the names of regions.

use super::frame::{Frame, SMALL};
use super::legend::{Entry, KEY_WIDTH};
use super::path::{Point, simplify};
use super::path_data::{line_data, outline_data};
use super::svg::{Svg, number};
use super::{palette, rich_text};

/// What a line means; it decides colour, width and dash, the same in every figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineRole {
    /// The exact boundary max Im(s) = 0: solid, dark.
    Boundary,
    /// An asymptote of the boundary: dashed, dark.
    Asymptote,
    /// The transition K = K_c: solid, white on a dark casing.
    Transition,
    /// A line along which another figure shows values: thin and solid.
    Section,
    /// The line on which an oscillation has a stated share of the natural frequency: dashed and dotted, green.
    FrequencyRatio,
    /// A line that only helps the eye: thin and dotted.
    Guide,
    /// The outline of the area within which the exact boundary is not certain: filled.
    BoundaryBand,
    /// The outline of the area within which the transition is not certain: filled.
    TransitionBand,
}

/// A line over a map.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Legend entry in figure markup; lines with equal labels share one entry, an empty label has none.
    pub label: String,
    /// What the line means.
    pub role: LineRole,
    /// Vertices in axis values; a vertex without a place on the axes interrupts the line.
    #[serde(default)]
    pub points: Vec<(f64, f64)>,
}

impl Line {
    /// A line over a map.
    #[must_use]
    pub fn new(label: impl Into<String>, role: LineRole, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), role, points }
    }
}

/// On which side of a point its label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// To the left, ending at the point.
    Left,
    /// To the right, starting at the point.
    Right,
    /// Centred above.
    Above,
}

/// A marked point, such as the cusp.
#[derive(Debug, Clone, PartialEq)]
pub struct PointMark {
    /// Label in figure markup; may be empty.
    pub label: String,
    /// Horizontal axis value.
    pub x: f64,
    /// Vertical axis value.
    pub y: f64,
    /// Where the label stands.
    pub side: Side,
}

impl PointMark {
    /// A point with its label on one side.
    #[must_use]
    pub fn new(label: impl Into<String>, (x, y): (f64, f64), side: Side) -> Self {
        Self { label: label.into(), x, y, side }
    }
}

/// The name of a region or line, centred at a place and set with a halo.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
pub struct RegionLabel {
    /// Lines of text in figure markup, from top to bottom.
    pub lines: Vec<String>,
    /// Horizontal axis value of the centre.
    pub x: f64,
    /// Vertical axis value of the centre.
    pub y: f64,
}

/// How a role is drawn: its class; the colours and the widths of the line and of its casing; its dashes.
type LineStyle = (&'static str, [&'static str; 2], [&'static str; 2], &'static str);

impl LineRole {
    fn style(self) -> LineStyle {
        match self {
            Self::Boundary => ("boundary", ["#111", "#fff"], ["2.2", "4.4"], ""),
            Self::Asymptote => ("asymptote", ["#b3261e", "#fff"], ["1.7", "3.7"], "8 5"),
            Self::Transition => ("transition", ["#fff", "#111"], ["2.2", "4.2"], ""),
            Self::Section => ("section", ["#6b2f8f", "#fff"], ["1.6", "3.0"], ""),
            Self::FrequencyRatio => ("frequency-ratio", ["#00513f", "#fff"], ["1.9", "3.9"], "9 3 2 3"),
            Self::Guide => ("guide", ["#444", "#fff"], ["1.2", "2.6"], "2 3"),
            Self::BoundaryBand => ("boundary-band", ["#111", "#fff"], ["0.8", "0"], ""),
            Self::TransitionBand => ("transition-band", ["#c2388f", "#fff"], ["0.8", "0"], ""),
        }
    }
}

/// Draws the areas and lines, boundaries below transitions below asymptotes, whatever their order in the list.
pub(crate) fn draw_lines(svg: &mut Svg, frame: &Frame, lines: &[Line]) {
    draw_named_lines(svg, frame, lines, "");
}

/// The same for one of several sets of lines in a figure: the names of their paths begin with `set`.
pub(crate) fn draw_named_lines(svg: &mut Svg, frame: &Frame, lines: &[Line], set: &str) {
    if !lines.is_empty() {
        frame.open_window(svg, &format!("{set}window"));
        draw_whole_lines(svg, frame, lines, set);
        svg.close();
    }
}

/// The same without a cut at the frame, where a line that ends there reaches out by half its width.
pub(crate) fn draw_whole_lines(svg: &mut Svg, frame: &Frame, lines: &[Line], set: &str) {
    draw_bands(svg, frame, lines);
    for role in [
        LineRole::Section,
        LineRole::Guide,
        LineRole::Boundary,
        LineRole::FrequencyRatio,
        LineRole::Transition,
        LineRole::Asymptote,
    ] {
        let parts =
            lines.iter().filter(|line| line.role == role).flat_map(|line| frame.visible_line(&line.points));
        let data: String = parts.map(|part| line_data(&simplify(&part, LINE_TOLERANCE))).collect();
        if !data.is_empty() {
            draw_line(svg, role, &data, set);
        }
    }
}

/// Fills the areas within which a line is not certain.
fn draw_bands(svg: &mut Svg, frame: &Frame, lines: &[Line]) {
    for role in [LineRole::BoundaryBand, LineRole::TransitionBand] {
        let areas = lines.iter().filter(|line| line.role == role);
        let outlines = areas.map(|area| simplify(&frame.visible_outline(&area.points), LINE_TOLERANCE));
        let data: String = outlines.map(|outline| outline_data(&outline)).collect();
        if !data.is_empty() {
            fill_band(svg, role, ("path", "d", &data));
        }
    }
}

/// Draws an element as a translucent area with one attribute of its own.
fn fill_band(svg: &mut Svg, role: LineRole, (tag, name, value): (&str, &str, &str)) {
    let (class, [colour, _], [width, _], _) = role.style();
    let attributes = [("class", class), (name, value), ("fill", colour), ("fill-opacity", BAND_OPACITY)];
    svg.leaf(tag, &[&attributes[..], &[("stroke", colour), ("stroke-width", width)]].concat());
}

/// How much an area covers what is below it.
const BAND_OPACITY: &str = "0.35";

/// How far a drawn line may lie from the given one, in canvas units.
const LINE_TOLERANCE: f64 = 0.15;

/// A line of the map: its path is written once and drawn twice, as casing and as line.
fn draw_line(svg: &mut Svg, role: LineRole, data: &str, set: &str) {
    let id = svg.id(&format!("{set}{}", role.style().0));
    svg.open("defs", &[]);
    svg.leaf("path", &[("id", &id), ("d", data), ("fill", "none")]);
    svg.close();
    draw_stroke(svg, role, ("use", "href", &format!("#{id}")));
}

/// Draws an element without area, with one attribute of its own, in a role's two strokes.
fn draw_stroke(svg: &mut Svg, role: LineRole, (tag, name, value): (&str, &str, &str)) {
    let (class, [colour, casing], [width, casing_width], dash) = role.style();
    let casing_class = format!("{class}-casing");
    let passes = [(casing_class.as_str(), casing, casing_width), (class, colour, width)];
    for (class, colour, width) in passes {
        let shape = [("class", class), (name, value)];
        let stroke = [("stroke", colour), ("stroke-width", width), ("stroke-dasharray", dash)];
        svg.leaf(tag, &[&shape[..], &stroke].concat());
    }
}

/// Legend entries of the lines, one for each label.
pub(crate) fn legend_entries(lines: &[Line]) -> Vec<Entry<'_>> {
    let key = |role: LineRole| {
        move |svg: &mut Svg, (x, y): Point| {
            // A dark page would turn casing and line around; the sample keeps the map's own ground.
            let plate = [("class", "key-plate"), ("fill", palette::PLATE)];
            svg.rect((x - 1.0, y - 7.0), (KEY_WIDTH - 5.0, 14.0), &plate);
            let right = x + KEY_WIDTH - 7.0;
            if matches!(role, LineRole::BoundaryBand | LineRole::TransitionBand) {
                let corners = [(x, y - 5.0), (right, y - 5.0), (right, y + 5.0), (x, y + 5.0)];
                fill_band(svg, role, ("path", "d", &outline_data(&corners)));
            } else {
                draw_stroke(svg, role, ("path", "d", &line_data(&[(x, y), (right, y)])));
            }
        }
    };
    lines.iter().map(|line| Entry::new(&line.label, key(line.role))).collect()
}

/// Draws marked points, then their labels.
pub(crate) fn draw_marks(svg: &mut Svg, frame: &Frame, marks: &[PointMark]) {
    let place = |mark: &PointMark| frame.place((mark.x, mark.y)).filter(|&point| frame.contains(point));
    let visible = || marks.iter().filter_map(|mark| Some((mark, place(mark)?)));
    if visible().next().is_some() {
        svg.open("g", &[("class", "mark"), ("fill", "#fff"), ("stroke", "#111"), ("stroke-width", "2")]);
        visible().for_each(|(_, point)| svg.circle(point, "4.5"));
        svg.close();
    }
    for (mark, (x, y)) in visible() {
        let (dx, dy, anchor) = match mark.side {
            Side::Left => (-10.0, 4.5, "end"),
            Side::Right => (10.0, 4.5, ""),
            Side::Above => (0.0, -11.0, "middle"),
        };
        draw_label(svg, (x + dx, y + dy), anchor, &mark.label);
    }
}

/// Draws the names of regions, line below line around their centre.
pub(crate) fn draw_labels(svg: &mut Svg, frame: &Frame, labels: &[RegionLabel]) {
    for label in labels {
        let Some((x, y)) = frame.place((label.x, label.y)).filter(|&point| frame.contains(point)) else {
            continue;
        };
        let top = y - LABEL_LEADING * (label.lines.len() as f64 - 1.0) / 2.0 + 4.5;
        for (index, line) in label.lines.iter().enumerate() {
            draw_label(svg, (x, top + LABEL_LEADING * index as f64), "middle", line);
        }
    }
}

/// Distance between lines of a label.
const LABEL_LEADING: f64 = 17.0;

fn draw_label(svg: &mut Svg, at: Point, anchor: &str, markup: &str) {
    draw_words_on_lines(svg, ("label", palette::INK), at, anchor, markup);
}

/// Small words of a class and a colour that stay readable where lines pass behind them.
pub(crate) fn draw_words_on_lines(
    svg: &mut Svg,
    (class, colour): (&str, &str),
    (x, y): Point,
    anchor: &str,
    markup: &str,
) {
    if markup.is_empty() {
        return;
    }
    let at = [number(x), number(y)];
    svg.text(
        &[
            ("class", class),
            ("x", &at[0]),
            ("y", &at[1]),
            ("text-anchor", anchor),
            ("font-size", "13"),
            ("fill", colour),
            ("stroke", palette::PLATE),
            ("stroke-width", "3.5"),
            ("paint-order", "stroke"),
        ],
        &rich_text::to_svg(markup, SMALL),
    );
}

#[cfg(test)]
mod tests {
    use super::super::sample::{heat_map, zone_map};

    #[test]
    fn what_lies_over_a_map_is_cut_at_its_frame() {
        let beside = zone_map(8).svg_beside(&zone_map(8), ["one", "other"], None);
        for (svg, maps) in [(heat_map(8).svg(), 1), (zone_map(8).svg(), 1), (beside, 2)] {
            let parts: Vec<&str> = svg.split(" clip-path=").collect();
            assert_eq!((parts.len(), svg.matches("<clipPath").count()), (maps + 1, maps));
            // No line is drawn before the cut.
            assert!(!parts[0].contains("-casing") && parts[1..].iter().all(|part| part.contains("-casing")));
        }
    }
}
