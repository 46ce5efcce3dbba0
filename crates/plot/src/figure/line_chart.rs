//! Line charts: several series over linear, logarithmic or signed logarithmic axes.

use super::frame::{CANVAS_WIDTH, Frame};
use super::legend::{Entry, KEY_WIDTH, Legend};
use super::overlay::draw_words_on_lines;
use super::path::{Point, simplify};
use super::path_data::line_data;
use super::series_style::{Look, draw_markers, spread};
use super::svg::Svg;
use super::{Axis, Caption, Inset, palette};

/// One line of a chart. Dash, marker and colour follow from its place in the list.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Series {
    /// Legend entry in figure markup.
    pub label: String,
    /// Points in axis values, in drawing order; one without a place on the axes interrupts the line.
    pub points: Vec<(f64, f64)>,
    /// Whether every point carries a marker; otherwise a few are spread along the line.
    pub marked: bool,
    /// Whether a line joins the points; without one the markers stand alone, for points between which nothing is known.
    pub joined: bool,
    /// Drawn thin and grey: a formula that the other series are compared with.
    pub theory: bool,
}

impl Series {
    /// A line with a few markers along it.
    #[must_use]
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, marked: false, joined: true, theory: false }
    }

    /// A line with a marker at every point.
    #[must_use]
    pub fn marked(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { marked: true, ..Self::line(label, points) }
    }

    /// Markers without a line between them.
    #[must_use]
    pub fn points(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { joined: false, ..Self::marked(label, points) }
    }

    /// A formula that the other series are compared with.
    #[must_use]
    pub fn of_theory(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { theory: true, ..Self::line(label, points) }
    }
}

/// What stands across the chart: a straight line at one value, or a shaded strip.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reference {
    /// Across at a value of the vertical axis.
    Horizontal {
        /// Value on the vertical axis.
        at: f64,
        /// Text at its right end in figure markup.
        label: String,
    },
    /// Upright at a value of the horizontal axis.
    Vertical {
        /// Value on the horizontal axis.
        at: f64,
        /// Text at its upper end in figure markup.
        label: String,
    },
    /// A strip between two values of the vertical axis.
    Band {
        /// One edge.
        from: f64,
        /// The other edge.
        to: f64,
        /// Legend entry in figure markup; may be empty.
        label: String,
    },
}

/// A chart of lines.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LineChart {
    /// Id, title and description.
    pub caption: Caption,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines from the lowest to the topmost.
    pub series: Vec<Series>,
    /// Reference lines and shaded strips.
    pub references: Vec<Reference>,
}

/// Upper left corner of the chart on the canvas.
const CORNER: Point = (80.0, 14.0);
/// Width and height of the chart.
const SIZE: Point = (544.0, 360.0);
/// How far a drawn line may lie from the given one, in canvas units.
const LINE_TOLERANCE: f64 = 0.15;

impl LineChart {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg_with(None)
    }

    /// The chart as SVG text, with a small map where it covers no line, or least of them.
    #[must_use]
    pub fn svg_with(&self, inset: Option<&Inset>) -> String {
        let frame = Frame::new(&self.x, &self.y, CORNER, SIZE);
        let legend = Legend::new(self.legend_entries(), CANVAS_WIDTH - CORNER.0);
        let below = frame.bounds.bottom + 60.0;
        let mut svg = Svg::new(&self.caption, CANVAS_WIDTH, below + legend.height());
        frame.draw_panel(&mut svg, "panel");
        for (index, (edges, _)) in self.bands().enumerate() {
            draw_band(&mut svg, &frame, index, edges);
        }
        frame.draw_grid(&mut svg);
        let style = LineStyle { tolerance: LINE_TOLERANCE, markers: true };
        draw_lines(&mut svg, &frame, &self.references, &self.series, style);
        frame.draw_axes(&mut svg);
        if let Some(inset) = inset {
            inset.draw(&mut svg, inset.place(frame.bounds, &self.lines_on(&frame)));
        }
        legend.draw(&mut svg, (CORNER.0, below));
        svg.finish()
    }

    /// The visible parts of the series and of the reference lines on the canvas.
    fn lines_on(&self, frame: &Frame) -> Vec<Vec<Point>> {
        let series = self.series.iter().flat_map(|series| frame.visible_line(&series.points));
        let places = self.references.iter().filter_map(|reference| place_reference(frame, reference));
        series.chain(places.map(|place| place.ends.into())).collect()
    }

    /// The edges of the strips, and their legend entries.
    fn bands(&self) -> impl Iterator<Item = ([f64; 2], &String)> {
        self.references.iter().filter_map(|reference| match reference {
            Reference::Band { from, to, label } => Some(([*from, *to], label)),
            _ => None,
        })
    }

    fn legend_entries(&self) -> Vec<Entry<'_>> {
        let bands = self.bands().enumerate().map(|(index, (_, label))| Entry {
            label: label.clone(),
            key: Box::new(move |svg: &mut Svg, (x, y): Point| {
                let (class, fill) = band_look(index);
                svg.rect((x + 3.0, y - 7.0), (KEY_WIDTH - 13.0, 14.0), &[("class", &class), ("fill", fill)]);
            }),
        });
        series_entries(&self.series).into_iter().chain(bands).collect()
    }
}

/// How the lines of a chart are drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineStyle {
    /// How far a drawn line may lie from the given one, in canvas units.
    pub tolerance: f64,
    /// Whether a line without markers of its own gets a few.
    pub markers: bool,
}

/// Each series with its look; theory lines do not use up the looks of the others.
fn looks(all: &[Series]) -> impl Iterator<Item = (Look, &Series)> {
    let mut measured = 0;
    all.iter().map(move |series| {
        if series.theory {
            return (Look::theory(), series);
        }
        measured += 1;
        (Look::of(measured - 1), series)
    })
}

/// Legend entries of the series.
pub(super) fn series_entries(all: &[Series]) -> Vec<Entry<'_>> {
    looks(all)
        .map(|(look, series)| Entry {
            label: series.label.clone(),
            key: Box::new(move |svg: &mut Svg, (x, y): Point| {
                let end = x + KEY_WIDTH - 7.0;
                look.open(svg);
                if series.joined {
                    look.stroke(svg, &line_data(&[(x, y), (end, y)]));
                }
                draw_markers(svg, look, &[((x + end) / 2.0, y)]);
                svg.close();
            }),
        })
        .collect()
}

/// Draws reference lines, the series over them, and the references' words over both.
pub(super) fn draw_lines(
    svg: &mut Svg,
    frame: &Frame,
    references: &[Reference],
    series: &[Series],
    style: LineStyle,
) {
    let places: Vec<ReferencePlace<'_>> =
        references.iter().filter_map(|reference| place_reference(frame, reference)).collect();
    places.iter().for_each(|place| draw_reference_line(svg, place));
    for (look, series) in looks(series) {
        draw_series(svg, frame, look, series, style);
    }
    for place in places {
        draw_words_on_lines(svg, ("ink halo", palette::FAINT_INK), place.words_at, place.anchor, place.label);
    }
}

fn draw_series(svg: &mut Svg, frame: &Frame, look: Look, series: &Series, style: LineStyle) {
    look.open(svg);
    let parts = frame.visible_line(&series.points);
    let data: String = parts.iter().map(|part| line_data(&simplify(part, style.tolerance))).collect();
    if series.joined {
        look.stroke(svg, &data);
    }
    if series.marked {
        let placed = series.points.iter().filter_map(|&point| frame.place(point));
        draw_markers(svg, look, &placed.filter(|&point| frame.contains(point)).collect::<Vec<_>>());
    } else if style.markers {
        draw_markers(svg, look, &spread(&parts, look));
    }
    svg.close();
}

/// Where a reference line and its words lie on the canvas.
struct ReferencePlace<'a> {
    ends: [Point; 2],
    words_at: Point,
    anchor: &'static str,
    label: &'a str,
}

/// The place of a reference line; `None` when its value is not on the axis.
fn place_reference<'a>(frame: &Frame, reference: &'a Reference) -> Option<ReferencePlace<'a>> {
    let b = frame.bounds;
    match reference {
        Reference::Horizontal { at, label } => {
            let v = frame.y.position(*at).filter(|v| (0.0..=1.0).contains(v))?;
            let y = frame.place_unit((0.0, v)).1;
            let (ends, words_at) = ([(b.left, y), (b.right, y)], (b.right - 8.0, y - 9.0));
            Some(ReferencePlace { ends, words_at, anchor: "end", label })
        }
        Reference::Vertical { at, label } => {
            let u = frame.x.position(*at).filter(|u| (0.0..=1.0).contains(u))?;
            let x = frame.place_unit((u, 0.0)).0;
            let (ends, words_at) = ([(x, b.top), (x, b.bottom)], (x + 6.0, b.top + 17.0));
            Some(ReferencePlace { ends, words_at, anchor: "start", label })
        }
        Reference::Band { .. } => None,
    }
}

fn draw_reference_line(svg: &mut Svg, place: &ReferencePlace<'_>) {
    svg.open(
        "g",
        &[
            ("class", "reference"),
            ("stroke", palette::FAINT_INK),
            ("stroke-width", "1.3"),
            ("stroke-dasharray", "6 4"),
        ],
    );
    svg.line(place.ends[0], place.ends[1]);
    svg.close();
}

fn band_look(index: usize) -> (String, &'static str) {
    const FILLS: [&str; 3] = ["#edf3f9", "#d9e7f3", "#c0d8ec"];
    let look = index % FILLS.len();
    (format!("band band-{look}"), FILLS[look])
}

fn draw_band(svg: &mut Svg, frame: &Frame, index: usize, edges: [f64; 2]) {
    let [Some(one), Some(two)] = edges.map(|edge| frame.y.position(edge)) else { return };
    let (low, high) = (one.min(two).clamp(0.0, 1.0), one.max(two).clamp(0.0, 1.0));
    let (from, to) = (frame.place_unit((0.0, high)), frame.place_unit((1.0, low)));
    let (class, fill) = band_look(index);
    svg.rect(from, (to.0 - from.0, to.1 - from.1), &[("class", &class), ("fill", fill)]);
}
