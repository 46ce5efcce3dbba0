//! The lines of charts: series, and references across the chart.

use super::frame::Frame;
use super::legend::{Entry, KEY_WIDTH};
use super::overlay::draw_words_on_lines;
use super::palette;
use super::path::{Point, simplify};
use super::path_data::line_data;
use super::series_style::{Look, draw_markers, spread};
use super::svg::Svg;

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
pub(super) fn series_entries<'s>(all: &'s [Series]) -> Vec<Entry<'s>> {
    let entry = |(look, series): (Look, &'s Series)| {
        Entry::new(&series.label, move |svg, (x, y)| {
            let end = x + KEY_WIDTH - 7.0;
            look.open(svg);
            if series.joined {
                look.stroke(svg, &line_data(&[(x, y), (end, y)]));
            }
            draw_markers(svg, look, &[((x + end) / 2.0, y)]);
            svg.close();
        })
    };
    looks(all).map(entry).collect()
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
pub(super) struct ReferencePlace<'a> {
    pub ends: [Point; 2],
    words_at: Point,
    anchor: &'static str,
    label: &'a str,
}

/// The place of a reference line; `None` when its value is not on the axis.
pub(super) fn place_reference<'a>(frame: &Frame, reference: &'a Reference) -> Option<ReferencePlace<'a>> {
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
