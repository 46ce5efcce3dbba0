//! The frame of a chart: where values lie on the canvas, axes with ticks, titles.

use super::path::{Bounds, Point, clip_line, clip_polygon};
use super::svg::{Svg, number};
use super::ticks::Tick;
use super::{Axis, Scale, palette, rich_text};

/// Width of every figure's canvas.
pub(crate) const CANVAS_WIDTH: f64 = 640.0;

/// Size of tick labels and legends.
pub(crate) const SMALL: f64 = 13.0;

/// Size of axis titles.
pub(crate) const NORMAL: f64 = 14.0;

/// A rectangle of the canvas with its two axes.
#[derive(Debug, Clone)]
pub(crate) struct Frame<'a> {
    /// Horizontal axis.
    pub x: &'a Axis,
    /// Vertical axis.
    pub y: &'a Axis,
    /// Edges on the canvas.
    pub bounds: Bounds,
}

impl<'a> Frame<'a> {
    /// A frame with its upper left corner, width and height on the canvas.
    pub fn new(x: &'a Axis, y: &'a Axis, corner: Point, size: Point) -> Self {
        Self { x, y, bounds: Bounds::new(corner, size) }
    }

    /// Width and height.
    pub fn size(&self) -> Point {
        self.bounds.size()
    }

    /// The canvas point of coordinates that run from 0 to 1 along the axes.
    pub fn place_unit(&self, (u, v): Point) -> Point {
        let (width, height) = self.size();
        (self.bounds.left + u * width, self.bounds.bottom - v * height)
    }

    /// The canvas point of a pair of values; `None` when an axis has no place for one of them.
    pub fn place(&self, (x, y): Point) -> Option<Point> {
        Some(self.place_unit((self.x.position(x)?, self.y.position(y)?)))
    }

    /// The visible parts of a line given in values.
    pub fn visible_line(&self, points: &[Point]) -> Vec<Vec<Point>> {
        let placed: Vec<Option<Point>> = points.iter().map(|&point| self.place(point)).collect();
        clip_line(&placed, self.bounds)
    }

    /// The visible part of an outline given in values.
    pub fn visible_outline(&self, points: &[Point]) -> Vec<Point> {
        let placed: Vec<Point> = points.iter().filter_map(|&point| self.place(point)).collect();
        clip_polygon(&placed, self.bounds)
    }

    /// Whether a canvas point lies in the frame.
    pub fn contains(&self, (x, y): Point) -> bool {
        let b = self.bounds;
        (b.left..=b.right).contains(&x) && (b.top..=b.bottom).contains(&y)
    }

    /// Draws the background: `class` is `panel` for charts that follow the page's theme, `panel-map` for maps.
    pub fn draw_panel(&self, svg: &mut Svg, class: &str) {
        let corner = (self.bounds.left, self.bounds.top);
        svg.rect(corner, self.size(), &[("class", class), ("fill", palette::PLATE)]);
    }

    /// Opens a group of which nothing shows outside the frame.
    pub fn open_window(&self, svg: &mut Svg, name: &str) {
        let (id, clip) = (svg.id(name), svg.url(name));
        svg.open("clipPath", &[("id", &id)]);
        svg.rect((self.bounds.left, self.bounds.top), self.size(), &[]);
        svg.close();
        svg.open("g", &[("clip-path", &clip)]);
    }

    /// Draws a line at every labelled tick of both axes.
    pub fn draw_grid(&self, svg: &mut Svg) {
        let b = self.bounds;
        self.draw_upright_grid(svg);
        self.draw_rules(svg, self.y, |v| [b.left, b.right].map(|x| (x, self.place_unit((0.0, v)).1)).into());
    }

    /// Draws a line at every labelled tick of the horizontal axis.
    pub fn draw_upright_grid(&self, svg: &mut Svg) {
        let b = self.bounds;
        self.draw_rules(svg, self.x, |u| [b.top, b.bottom].map(|y| (self.place_unit((u, 0.0)).0, y)).into());
    }

    fn draw_rules(&self, svg: &mut Svg, axis: &Axis, rule: impl Fn(f64) -> (Point, Point)) {
        svg.open("g", &[("class", "grid"), ("stroke", palette::GRID)]);
        let places = places(axis).filter(|(_, tick)| tick.is_major());
        svg.rules(&places.map(|(at, _)| rule(at)).collect::<Vec<_>>());
        svg.close();
    }

    /// Draws border, ticks, tick labels and titles of both axes.
    pub fn draw_axes(&self, svg: &mut Svg) {
        self.draw_border(svg, true);
        self.label_x(svg);
        self.label_y(svg);
        self.draw_title_x(svg);
        self.draw_title_y(svg);
    }

    /// Draws border, ticks, tick labels and title of the horizontal axis alone.
    pub fn draw_lower_axis(&self, svg: &mut Svg) {
        self.draw_border(svg, false);
        self.label_x(svg);
        self.draw_title_x(svg);
    }

    fn draw_border(&self, svg: &mut Svg, upright_ticks: bool) {
        svg.open("g", &[("class", "axis"), ("stroke", palette::FAINT_INK), ("fill", "none")]);
        svg.rect((self.bounds.left, self.bounds.top), self.size(), &[]);
        self.draw_ticks(svg, self.ticks_x(), |u| (u, 0.0), (0.0, 1.0));
        if upright_ticks {
            self.draw_ticks(svg, self.ticks_y(), |v| (0.0, v), (-1.0, 0.0));
        }
        svg.close();
    }

    /// Ticks of an axis of this length, without the minor ones where an even scale would crowd them.
    fn uncrowded(&self, axis: &Axis, length: f64) -> Vec<(f64, Tick)> {
        let mut ticks: Vec<(f64, Tick)> = places(axis).collect();
        let close = |pair: &[(f64, Tick)]| (pair[1].0 - pair[0].0) * length < TICK_ROOM;
        if axis.scale == Scale::Linear && ticks.windows(2).any(close) {
            ticks.retain(|(_, tick)| tick.is_major());
        }
        ticks
    }

    /// Ticks of the horizontal axis, as many of them labelled as have room.
    fn ticks_x(&self) -> Vec<(f64, Tick)> {
        let length = self.size().0;
        let width = |tick: &Tick| rich_text::width(&tick.label, SMALL);
        with_room(self.uncrowded(self.x, length), |(u, tick), (next_u, next)| {
            (next_u - u) * length >= (width(tick) + width(next)) / 2.0 + LABEL_GAP
        })
    }

    /// Ticks of the vertical axis, as many of them labelled as have room.
    fn ticks_y(&self) -> Vec<(f64, Tick)> {
        let length = self.size().1;
        with_room(self.uncrowded(self.y, length), |(v, _), (next_v, _)| (next_v - v) * length >= LABEL_ROW)
    }

    /// Ticks at their places along an axis, which point outwards.
    fn draw_ticks(&self, svg: &mut Svg, ticks: Vec<(f64, Tick)>, at: fn(f64) -> Point, out: Point) {
        let rule = |(place, tick): (f64, Tick)| {
            let ((x, y), length) = (self.place_unit(at(place)), tick_length(&tick));
            ((x, y), (x + out.0 * length, y + out.1 * length))
        };
        svg.rules(&ticks.into_iter().map(rule).collect::<Vec<_>>());
    }

    fn label_x(&self, svg: &mut Svg) {
        svg.open("g", &label_attributes("middle"));
        for (u, tick) in self.ticks_x().into_iter().filter(|(_, tick)| tick.is_major()) {
            let (x, y) = self.place_unit((u, 0.0));
            let half = rich_text::width(&tick.label, SMALL) / 2.0;
            svg.words((x.clamp(half, CANVAS_WIDTH - half), y + 21.0), &tick.label, SMALL);
        }
        svg.close();
    }

    fn label_y(&self, svg: &mut Svg) {
        svg.open("g", &label_attributes("end"));
        for (v, tick) in self.ticks_y().into_iter().filter(|(_, tick)| tick.is_major()) {
            let (x, y) = self.place_unit((0.0, v));
            svg.words((x - LABEL_OFFSET, y + 4.5), &tick.label, SMALL);
        }
        svg.close();
    }

    fn draw_title_x(&self, svg: &mut Svg) {
        let b = self.bounds;
        let at = [number((b.left + b.right) / 2.0), number(b.bottom + 44.0)];
        let attributes = [TITLE[0], TITLE[1], TITLE[2], ("x", &at[0]), ("y", &at[1])];
        svg.text(&attributes, &rich_text::to_svg(&self.x.heading(), NORMAL));
    }

    fn draw_title_y(&self, svg: &mut Svg) {
        let b = self.bounds;
        let widths = self.ticks_y().into_iter().map(|(_, tick)| rich_text::width(&tick.label, SMALL));
        let room = widths.fold(0.0, f64::max) + LABEL_OFFSET + TITLE_DESCENT;
        draw_upright_title(svg, self.y, (b.left - room.clamp(58.0, 66.0), (b.top + b.bottom) / 2.0));
    }
}

/// Distance of the labels of the vertical axis from it.
const LABEL_OFFSET: f64 = 10.0;

/// What an upright title takes beside its place, on the side of the labels.
const TITLE_DESCENT: f64 = 5.0;

/// Least distance between two ticks of an even scale.
const TICK_ROOM: f64 = 5.0;

/// Least space between two tick labels side by side.
const LABEL_GAP: f64 = 6.0;

/// Least distance between two tick labels above each other.
const LABEL_ROW: f64 = 17.0;

/// The ticks with every n-th label only, counted from 0 or 1, n as small as `fits` allows; then without minor ticks between them.
fn with_room(ticks: Vec<(f64, Tick)>, fits: impl Fn(&(f64, Tick), &(f64, Tick)) -> bool) -> Vec<(f64, Tick)> {
    let majors: Vec<(f64, Tick)> = ticks.iter().filter(|(_, tick)| tick.is_major()).cloned().collect();
    let place_of = |value: f64| majors.iter().position(|(_, tick)| tick.value == value);
    let first = place_of(0.0).or_else(|| place_of(1.0)).unwrap_or(0);
    let kept = |stride: usize| move |index: &usize| index.abs_diff(first).is_multiple_of(stride);
    let roomy = |stride: &usize| {
        let shown: Vec<usize> = (0..majors.len()).filter(kept(*stride)).collect();
        shown.windows(2).all(|pair| fits(&majors[pair[0]], &majors[pair[1]]))
    };
    match (1..=majors.len()).find(roomy) {
        None | Some(1) => ticks,
        Some(stride) => {
            let shown = kept(stride);
            let thinned = majors.iter().cloned().enumerate().map(|(index, (at, mut tick))| {
                if !shown(&index) {
                    tick.label.clear();
                }
                (at, tick)
            });
            thinned.collect()
        }
    }
}

/// The ticks of an axis, each after its place from 0 to 1.
pub(crate) fn places(axis: &Axis) -> impl Iterator<Item = (f64, Tick)> {
    axis.ticks().into_iter().filter_map(|tick| Some((axis.position(tick.value)?, tick)))
}

/// The title of an axis, from below to above, about a place.
pub(crate) fn draw_upright_title(svg: &mut Svg, axis: &Axis, (x, y): Point) {
    let turn = format!("translate({} {}) rotate(-90)", number(x), number(y));
    let attributes = [TITLE[0], TITLE[1], TITLE[2], ("transform", &turn)];
    svg.text(&attributes, &rich_text::to_svg(&axis.heading(), NORMAL));
}

/// Attributes of axis titles.
const TITLE: [(&str, &str); 3] = [("class", "ink"), ("fill", palette::INK), ("text-anchor", "middle")];

fn label_attributes(anchor: &str) -> [(&str, &str); 4] {
    [("class", "ink"), ("fill", palette::INK), ("font-size", "13"), ("text-anchor", anchor)]
}

fn tick_length(tick: &Tick) -> f64 {
    if tick.is_major() { 6.0 } else { 3.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, height: f64) -> Vec<String> {
        let x = Axis::linear("x", "", 0.0, 1.0);
        let frame = Frame::new(&x, axis, (0.0, 0.0), (100.0, height));
        frame.ticks_y().into_iter().map(|(_, tick)| tick.label).filter(|label| !label.is_empty()).collect()
    }

    #[test]
    fn labels_without_room_are_thinned_evenly_and_zero_stays() {
        let axis = Axis::linear("y", "", -35.0, 8.0);
        assert_eq!(labels(&axis, 360.0), ["−35", "−30", "−25", "−20", "−15", "−10", "−5", "0", "5"]);
        assert_eq!(labels(&axis, 120.0), ["−30", "−20", "−10", "0"]);
        assert_eq!(labels(&axis, 60.0), ["−30", "−15", "0"]);
        let axis = Axis::log10("y", "", 1e-4, 1e3);
        assert_eq!(labels(&axis, 100.0), ["10^{−4}", "10^{−2}", "1", "10^{2}"]);
    }
}
