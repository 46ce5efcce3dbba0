//! The explorer page of one slider: a family of sliders with b, K and M changed, as curves, formulas and words.

pub(crate) mod families;
pub(crate) mod formulas;
pub(crate) mod live;
pub(crate) mod points;
pub(crate) mod tables;
pub(crate) mod view;

pub use families::{Factors, Families, NamedPoint, PointState};
pub use formulas::FormulaRow;
pub use live::{LiveControl, LiveMap, LiveMode, live_map};
pub use points::points;
pub use view::{Control, Explorer, PointRow, Window, explorer};

/// Digits of a number; what is computed is certain to far more.
const DIGITS: usize = 4;

/// A text for every combination: its different words and a code for each, and the text of the slider itself.
#[derive(Debug, Clone, Default, serde::Serialize)]
pub struct Varying {
    /// The different texts.
    pub words: String,
    /// A code for each combination; see [`slipmode_plot::figure::packed`].
    pub cells: String,
    /// The text for the slider's own b, K and M.
    pub base: String,
}

impl Varying {
    fn of(texts: &[String], base: usize) -> Self {
        let texts: Vec<String> = texts.iter().map(|text| in_print(text)).collect();
        let (words, cells) = slipmode_plot::figure::packed(&texts);
        Self { words, cells, base: texts.get(base).cloned().unwrap_or_default() }
    }
}

/// A number with its power of ten raised, as the script writes it; other texts as they are.
fn in_print(text: &str) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |sign: char| sign.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    match text.split_once('e').filter(|_| text.parse::<f64>().is_ok()) {
        Some((digits, power)) => format!("{digits} × 10{}", power.chars().map(raised).collect::<String>()),
        None => text.into(),
    }
}
