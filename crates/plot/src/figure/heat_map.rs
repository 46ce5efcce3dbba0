//! Heat maps over two axes: filled contours of a grid of values, with the area of exact zeros left uncoloured.

use super::contour::outlines;
use super::covered::Covers;
use super::frame::{CANVAS_WIDTH, Frame, SMALL, draw_upright_title, places};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::overlay::{draw_lines, draw_marks, legend_entries};
use super::path::{Point, simplify};
use super::path_data::{line_data, outline_data, outline_data_in_tenths};
use super::svg::{Svg, number};
use super::{Axis, Caption, Line, PointMark, Readout, palette};

/// The colour bar of a heat map: logarithmic, in even steps.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ColourScale {
    /// Title with figure markup, such as `max Im(*s*)`.
    pub title: String,
    /// Unit, such as `1/s`.
    pub unit: String,
    /// Value at the dark end; smaller positive values take the same colour. Positive.
    pub min: f64,
    /// Value at the bright end; larger values take the same colour.
    pub max: f64,
    /// Number of colour steps between `min` and `max`, 2 to 64.
    pub steps: usize,
    /// Values at which a thin line is drawn, for differences that one colour covers.
    pub contours: Vec<f64>,
    /// Legend entry of these lines in figure markup.
    pub contour_label: String,
}

/// A map of a positive quantity over two axes.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct HeatMap {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Number of grid columns, at least 2; they are even on the axis, the first at `x.min`, the last at `x.max`.
    pub columns: usize,
    /// Values row by row from `y.min` to `y.max`, `columns` in each row; zero or less and NaN are left uncoloured.
    pub values: Vec<f64>,
    /// Colour bar.
    pub colours: ColourScale,
    /// Outlines of the areas where the value is exactly zero, in axis values. Where they are given, the colour
    /// reaches up to them; without them the edge lies half-way between grid points.
    pub zero_areas: Vec<Vec<(f64, f64)>>,
    /// Legend entry for the uncoloured area in figure markup; empty when there is none.
    pub zero_label: String,
    /// Lines over the map.
    pub lines: Vec<Line>,
    /// Marked points.
    #[serde(skip)]
    pub marks: Vec<PointMark>,
}

/// Upper left corner of the map on the canvas.
const CORNER: Point = (80.0, 14.0);
/// Width and height of the map.
const SIZE: Point = (452.0, 420.0);
/// How far a drawn contour may lie from the interpolated one, in canvas units.
const CONTOUR_TOLERANCE: f64 = 0.4;

/// Colour of a contour line, and its width in tenths.
const CONTOUR: [&str; 2] = ["#4a4a00", "10"];

impl HeatMap {
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
        frame.draw_panel(&mut svg, "panel-map");
        self.draw_values(&mut svg, &frame);
        self.draw_zero_areas(&mut svg, &frame);
        draw_lines(&mut svg, &frame, &self.lines);
        draw_marks(&mut svg, &frame, &self.marks);
        frame.draw_axes(&mut svg);
        readout.iter().for_each(|readout| readout.draw(&mut svg, &frame));
        self.draw_colour_bar(&mut svg, &frame);
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    fn steps(&self) -> usize {
        self.colours.steps.clamp(2, 64)
    }

    /// Lower edge of a colour step; every positive value belongs to step 0 at least.
    fn level(&self, step: usize) -> f64 {
        let (low, high) = (libm::log10(self.colours.min), libm::log10(self.colours.max));
        if step == 0 { 0.0 } else { libm::exp10(low + (high - low) * step as f64 / self.steps() as f64) }
    }

    /// Paints for each step the whole area above its lower edge, the brighter over the darker.
    fn draw_values(&self, svg: &mut Svg, frame: &Frame) {
        let covers = Covers::new(self.zero_areas.iter().map(|area| frame.visible_outline(area)).collect());
        let outlines = |level| self.outlines_in_tenths(frame, &covers, level);
        svg.open("g", &[("class", "values"), ("transform", "scale(.1)")]);
        for step in 0..self.steps() {
            let data = outlines(self.level(step));
            if !data.is_empty() {
                svg.leaf("path", &[("d", &data), ("fill", &palette::value_colour(step, self.steps()))]);
            }
        }
        let contours: String = self.colours.contours.iter().map(|&level| outlines(level)).collect();
        if !contours.is_empty() {
            let [colour, width] = CONTOUR;
            svg.leaf(
                "path",
                &[("d", &contours), ("fill", "none"), ("stroke", colour), ("stroke-width", width)],
            );
        }
        svg.close();
    }

    /// The outlines of the area above a level, with a short course where areas of zeros are painted over them.
    fn outlines_in_tenths(&self, frame: &Frame, covers: &Covers, level: f64) -> String {
        let inside = |value: f64| value > 0.0 && value >= level;
        let crossing = |outside: f64, inside: f64| self.crossing(level, outside, inside);
        let areas = outlines(&self.values, self.columns, &inside, &crossing);
        let outline = |area: &Vec<Point>| {
            let placed: Vec<Point> = area.iter().map(|&point| frame.place_unit(point)).collect();
            outline_data_in_tenths(&covers.simplify(&placed, CONTOUR_TOLERANCE))
        };
        areas.iter().map(outline).collect()
    }

    /// Where between two grid points the level is crossed.
    ///
    /// Between positive values the logarithm is taken to be linear. Next to an exact zero the square is: the imaginary
    /// part grows like the root of the distance from a double root.
    fn crossing(&self, level: f64, outside: f64, inside: f64) -> f64 {
        if outside > 0.0 {
            let from = libm::log10(outside);
            return (libm::log10(level) - from) / (libm::log10(inside) - from);
        }
        let ratio = level / inside;
        let edge = if self.zero_areas.is_empty() { 0.5 } else { 0.0 };
        edge + (1.0 - edge) * ratio * ratio
    }

    fn draw_zero_areas(&self, svg: &mut Svg, frame: &Frame) {
        let outline = |area: &Vec<Point>| outline_data(&simplify(&frame.visible_outline(area), 0.06));
        let data: String = self.zero_areas.iter().map(outline).collect();
        if !data.is_empty() {
            svg.leaf("path", &[("class", "zero"), ("d", &data), ("fill", palette::PLATE)]);
        }
    }

    fn draw_colour_bar(&self, svg: &mut Svg, frame: &Frame) {
        let axis = Axis::log10(&self.colours.title, &self.colours.unit, self.colours.min, self.colours.max);
        let (left, width) = (frame.bounds.right + 16.0, 18.0);
        let (top, height) = (frame.bounds.top, frame.size().1);
        let step_height = height / self.steps() as f64;
        let middle = left + width / 2.0;
        let bar =
            [("class", "colour-bar"), ("shape-rendering", "crispEdges"), ("stroke-width", &number(width))];
        svg.open("g", &bar);
        for step in 0..self.steps() {
            let y = top + height - step_height * (step as f64 + 1.0);
            let colour = palette::value_colour(step, self.steps());
            let data = line_data(&[(middle, y), (middle, y + step_height + 0.4)]);
            svg.leaf("path", &[("d", &data), ("stroke", &colour)]);
        }
        svg.close();
        svg.open("g", &[("class", "axis"), ("stroke", palette::FAINT_INK), ("fill", "none")]);
        svg.rect((left, top), (width, height), &[]);
        svg.close();
        self.label_colour_bar(svg, &axis, (left + width, top), height);
    }

    fn label_colour_bar(&self, svg: &mut Svg, axis: &Axis, (right, top): Point, height: f64) {
        svg.open("g", &[("class", "ink"), ("fill", palette::INK), ("font-size", "13")]);
        for (v, tick) in places(axis).filter(|(_, tick)| tick.is_major()) {
            svg.words((right + 6.0, top + height * (1.0 - v) + 4.5), &tick.label, SMALL);
        }
        svg.close();
        draw_upright_title(svg, axis, (right + 52.0, top + height / 2.0));
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let mut entries = legend_entries(&self.lines);
        entries.push(Entry::new(&self.colours.contour_label, |svg, (x, y)| {
            let brightest = palette::value_colour(self.steps() - 1, self.steps());
            svg.rect((x - 1.0, y - 7.0), (KEY_WIDTH - 5.0, 14.0), &[("fill", brightest.as_str())]);
            let data = line_data(&[(x, y), (x + KEY_WIDTH - 7.0, y)]);
            svg.leaf("path", &[("d", data.as_str()), ("stroke", CONTOUR[0]), ("stroke-width", "1")]);
        }));
        entries.push(Entry::new(&self.zero_label, |svg, (x, y)| {
            let attributes =
                [("class", "zero-key"), ("fill", palette::PLATE), ("stroke", palette::FAINT_INK)];
            svg.rect((x + 3.0, y - 7.0), (KEY_WIDTH - 13.0, 14.0), &attributes);
        }));
        entries
    }
}
