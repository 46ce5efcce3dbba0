//! A small SVG writer: escaped text, quoted attributes, coordinates in tenths.

use super::path::Point;
use super::{Caption, palette};
use crate::table::escape_html;

/// Fonts of all figures; the first that the viewer has is taken.
const FONTS: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";

/// SVG text under construction.
#[derive(Debug)]
pub(crate) struct Svg {
    text: String,
    prefix: String,
    open: Vec<&'static str>,
}

impl Svg {
    /// Starts a figure of the given size with its accessible name and description.
    pub fn new(caption: &Caption, width: f64, height: f64) -> Self {
        Self::with_role(caption, width, height, "img")
    }

    /// Starts a figure with another role than that of one picture.
    pub fn with_role(caption: &Caption, width: f64, height: f64, role: &str) -> Self {
        let prefix = id_text(&caption.id);
        let mut svg = Self { text: String::new(), prefix: prefix.clone(), open: Vec::new() };
        let [width, height] = [width, height].map(number);
        let view_box = format!("0 0 {width} {height}");
        let names = format!("{prefix}-title {prefix}-desc");
        svg.open(
            "svg",
            &[
                ("xmlns", "http://www.w3.org/2000/svg"),
                ("class", "fig"),
                ("role", role),
                ("aria-labelledby", &names),
                ("viewBox", &view_box),
                ("font-family", FONTS),
                ("font-size", "14"),
                ("stroke-linejoin", "round"),
            ],
        );
        for (tag, content) in [("title", &caption.title), ("desc", &caption.description)] {
            svg.text += &format!("<{tag} id=\"{prefix}-{tag}\">{}</{tag}>\n", escape(content));
        }
        let fill = ("fill", palette::PLATE);
        svg.leaf("rect", &[("class", "plate"), ("width", &width), ("height", &height), fill]);
        svg
    }

    /// Opens an element; attributes whose value is empty are left out.
    pub fn open(&mut self, tag: &'static str, attributes: &[(&str, &str)]) {
        self.start(tag, attributes);
        self.text += ">\n";
        self.open.push(tag);
    }

    /// Closes the element opened last.
    pub fn close(&mut self) {
        if let Some(tag) = self.open.pop() {
            self.text += &format!("</{tag}>\n");
        }
    }

    /// Writes an element without content.
    pub fn leaf(&mut self, tag: &str, attributes: &[(&str, &str)]) {
        self.start(tag, attributes);
        self.text += "/>\n";
    }

    /// Writes a `text` element around markup made by [`super::rich_text`].
    pub fn text(&mut self, attributes: &[(&str, &str)], markup: &str) {
        self.start("text", attributes);
        self.text += &format!(">{markup}</text>\n");
    }

    /// The accessible name of the element opened last.
    pub fn title(&mut self, words: &str) {
        self.text += &format!("<title>{}</title>\n", escape(words));
    }

    /// A straight line.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64)) {
        let ends = [number(from.0), number(from.1), number(to.0), number(to.1)];
        self.leaf("line", &[("x1", &ends[0]), ("y1", &ends[1]), ("x2", &ends[2]), ("y2", &ends[3])]);
    }

    /// A circle around a point.
    pub fn circle(&mut self, (x, y): Point, radius: &str) {
        self.leaf("circle", &[("cx", &number(x)), ("cy", &number(y)), ("r", radius)]);
    }

    /// A rectangle with further attributes.
    pub fn rect(&mut self, at: (f64, f64), size: (f64, f64), attributes: &[(&str, &str)]) {
        let numbers = [number(at.0), number(at.1), number(size.0), number(size.1)];
        let mut all: Vec<(&str, &str)> =
            ["x", "y", "width", "height"].into_iter().zip(numbers.iter().map(String::as_str)).collect();
        all.extend_from_slice(attributes);
        self.leaf("rect", &all);
    }

    /// An id that no other figure on the page has.
    pub fn id(&self, name: &str) -> String {
        format!("{}-{name}", self.prefix)
    }

    /// `url(#…)` for such an id.
    pub fn url(&self, name: &str) -> String {
        format!("url(#{})", self.id(name))
    }

    /// Closes everything and gives the text.
    pub fn finish(mut self) -> String {
        while !self.open.is_empty() {
            self.close();
        }
        self.text
    }

    fn start(&mut self, tag: &str, attributes: &[(&str, &str)]) {
        self.text.push('<');
        self.text += tag;
        for (name, value) in attributes.iter().filter(|(_, value)| !value.is_empty()) {
            self.text += &format!(" {name}=\"{}\"", escape(value));
        }
    }
}

/// A coordinate rounded to a tenth, without trailing zero: the same text everywhere.
pub(crate) fn number(value: f64) -> String {
    tenths_text(tenths(value))
}

/// A coordinate in whole tenths; values far outside any figure are held at its far edge.
pub(crate) fn tenths(value: f64) -> i64 {
    libm::round(value.clamp(-1e6, 1e6) * 10.0) as i64
}

/// Tenths as a decimal.
pub(crate) fn tenths_text(tenths: i64) -> String {
    let sign = if tenths < 0 { "-" } else { "" };
    let (whole, rest) = (tenths.abs() / 10, tenths.abs() % 10);
    if rest == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{rest}") }
}

/// A drawing without what an HTML page gives it anyway: the namespace, and fonts, which its style sheet names.
#[must_use]
pub fn within_html(svg: &str) -> String {
    let fonts = format!(" font-family=\"{}\"", escape(FONTS));
    svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1).replacen(&fonts, "", 1)
}

/// Text for use between tags and in quoted attributes.
pub(crate) fn escape(text: &str) -> String {
    escape_html(&text.replace(['\n', '\r', '\t'], " "))
}

/// The id with every character that an id in a reference cannot carry replaced.
fn id_text(id: &str) -> String {
    id.chars().map(|c| if c.is_ascii_alphanumeric() || matches!(c, '-' | '_') { c } else { '-' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_rounded_to_a_tenth_without_noise() {
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.04), "0");
        assert_eq!(number(-12.36), "-12.4");
        assert_eq!(number(f64::INFINITY), "1000000");
    }

    #[test]
    fn hostile_words_stay_words() {
        let caption = Caption::new("x\" onload=\"y", "</title><script>alert(1)</script>", "a & b\u{202e}");
        let svg = Svg::new(&caption, 10.0, 10.0).finish();
        assert!(!svg.contains("<script") && !svg.contains("onload=\""), "{svg}");
        assert!(svg.contains("a &amp; b\u{fffd}"));
        assert!(svg.ends_with("</svg>\n"));
    }
}
