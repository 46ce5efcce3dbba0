//! The explorer's page: one self-contained HTML file. Its scripts choose among what is stored in it, and compute what the program made.

use serde_json::json;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;

use super::ReportError;
use super::html::table_html;
use super::page_style::{EXPLORER_SCRIPT, LIVE_SCRIPT, content_policy, explorer_style_sheet};
use super::templates::Templates;
use crate::explorer::{Explorer, LiveMap};
use slipmode_core::number::format::rational_to_decimal;
use slipmode_plot::figure::within_html;

/// What the explorer's page says besides the numbers.
#[derive(Debug, Clone)]
pub struct ExplorerPage<'a> {
    /// The scene's title.
    pub title: &'a str,
    /// The slider.
    pub slider: &'a Slider<Rational>,
    /// Where the points come from, in a sentence.
    pub marks: &'a str,
    /// The command that makes the page again.
    pub command: &'a str,
    /// The scene's file, by name.
    pub scene: &'a str,
    /// Its SHA-256.
    pub digest: &'a str,
    /// The map on which all values can be changed.
    pub live: Option<&'a LiveMap>,
}

/// Digits of the slider's parameters: all that a person typed.
const DIGITS: usize = 17;

/// Renders the explorer's page.
///
/// # Errors
/// When a template and its view do not fit: an error of this program.
pub fn render_explorer(explorer: &Explorer, page: &ExplorerPage<'_>) -> Result<String, ReportError> {
    let templates = Templates::html()?;
    let mut tables_html = String::new();
    for table in &explorer.tables {
        tables_html += &table_html(&templates, table, String::new(), None)?;
    }
    let style_css = explorer_style_sheet();
    let script_js = format!("{EXPLORER_SCRIPT}{LIVE_SCRIPT}");
    let grid = format!(
        "The page stores {} combinations of b, K and M, each the scene’s value times one of the factors in the tables. It does not interpolate between them.",
        explorer.combinations
    );
    let context = json!({
        "title": page.title,
        "effect": rational_to_decimal(&page.slider.direct_effect, DIGITS),
        "slip": rational_to_decimal(&page.slider.critical_slip_distance_m, DIGITS),
        "live": page.live,
        "policy": content_policy(&style_css, &script_js),
        "style_css": style_css,
        "controls": explorer.controls,
        "drawing_svg": within_html(&explorer.svg),
        "marks": page.marks,
        "points": explorer.points,
        "formulas": explorer.formulas,
        "tables_html": tables_html,
        "grid": grid,
        "command": page.command,
        "scene": page.scene,
        "digest": page.digest,
        "script_js": script_js,
    });
    templates.render("explore.html", &context)
}
