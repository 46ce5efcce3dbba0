//! LaTeX to MathML: the only place that knows `math-core`.

use std::collections::BTreeMap;

use math_core::{LatexToMathML, MathDisplay};

use slipmode_plot::table::printable;

/// The longest formula, in bytes.
const LONGEST_FORMULA: usize = 2_000;
/// The deepest braces in braces.
const DEEPEST_BRACES: usize = 100;

/// A converter that gathers the inline styles of its formulas as rules for the page's style sheet: a strict content
/// policy refuses `style` attributes.
#[derive(Debug, Default)]
pub(crate) struct Mathematics {
    converter: LatexToMathML,
    classes: BTreeMap<String, String>,
}

impl Mathematics {
    /// Rules of the classes used so far.
    pub(crate) fn style_rules(&self) -> String {
        self.classes.iter().map(|(style, class)| format!(".{class}{{{style}}}\n")).collect()
    }

    /// MathML of a formula, within a line or on lines of its own.
    ///
    /// # Errors
    /// What is wrong with the LaTeX, in words.
    pub fn convert(&mut self, latex: &str, is_block: bool) -> Result<String, String> {
        let display = if is_block { MathDisplay::Block } else { MathDisplay::Inline };
        let untagged: String = without_tags(latex).chars().map(printable).collect();
        check_size(latex)?;
        let converted = self.converter.convert_with_local_state(untagged.trim(), display);
        let result = converted.map_err(|error| format!("`{}`: {error}", latex.trim()))?;
        Ok(self.with_classes(&result.mathml))
    }

    /// The MathML with each ` style="…"` replaced by a class.
    fn with_classes(&mut self, mathml: &str) -> String {
        let mut parts = mathml.split(" style=\"");
        let mut text = String::from(parts.next().unwrap_or_default());
        for part in parts {
            let (style, rest) = part.split_once('"').unwrap_or(("", part));
            if is_harmless(style) {
                let next = self.classes.len();
                let class = self.classes.entry(style.into()).or_insert_with(|| format!("math-{next}"));
                text += &format!(" class=\"{class}\"");
            }
            text += rest;
        }
        text
    }
}

/// Whether a formula is small enough for a page, and for a reader that calls itself for every level.
pub(super) fn check_size(latex: &str) -> Result<(), String> {
    let (mut depth, mut deepest) = (0_usize, 0);
    for sign in latex.chars() {
        match sign {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    let start = || latex.trim().chars().take(40).collect::<String>();
    if latex.len() > LONGEST_FORMULA {
        return Err(format!("`{}…`: {} bytes (allowed: at most {LONGEST_FORMULA})", start(), latex.len()));
    }
    if deepest > DEEPEST_BRACES {
        return Err(format!("`{}…`: braces {deepest} deep (allowed: at most {DEEPEST_BRACES})", start()));
    }
    Ok(())
}

/// Whether a declaration list holds lengths, colours and keywords only.
fn is_harmless(style: &str) -> bool {
    let known = |c: char| c.is_ascii_alphanumeric() || matches!(c, ' ' | ':' | ';' | '.' | '-' | '#' | '%');
    !style.is_empty() && style.chars().all(known)
}

/// The formula without `\tag{…}`: numbers stand next to equations, set by the page.
fn without_tags(latex: &str) -> String {
    let mut parts = latex.split("\\tag{");
    let mut text = String::from(parts.next().unwrap_or_default());
    for part in parts {
        text += part.split_once('}').map_or("", |(_, rest)| rest);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_equations_become_mathml_without_inline_styles() {
        let mut mathematics = Mathematics::default();
        for latex in [
            r"\frac{M}{\sigma}s^3 + \left(\frac{a}{V_0} + \frac{M V_0}{\sigma D_c}\right)s^2 = 0 \tag{8}",
            r"\sigma = \frac{K D_c}{(\sqrt{b} - \sqrt{a})^2}",
            r"\begin{aligned} \dot\theta &= 1 - \frac{V\theta}{D_c} \\ \ddot\delta &= 0 \end{aligned}",
            r"\operatorname{Im}(s) \le \omega_n,\quad \mathbb{Q}",
        ] {
            let mathml = mathematics.convert(latex, true).unwrap();
            assert!(
                mathml.starts_with("<math display=\"block\">") && mathml.ends_with("</math>"),
                "{mathml}"
            );
            assert!(!mathml.contains(" style=\"") && !mathml.contains("tag"), "{mathml}");
        }
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let fault = Mathematics::default().convert(r"\frac{1", false).unwrap_err();
        assert!(fault.contains(r"`\frac{1`"), "{fault}");
    }

    #[test]
    fn hostile_formulas_bring_no_markup() {
        let mut mathematics = Mathematics::default();
        for latex in [
            r"\text{<img src=x onerror=alert(1)>}",
            r"\color{red;}<script>",
            r"\href{javascript:alert(1)}{x}",
            r"x < y > z & w",
        ] {
            let mathml = mathematics.convert(latex, false).unwrap_or_default();
            assert!(
                !mathml.contains("<img") && !mathml.contains("<script") && !mathml.contains("href="),
                "{mathml}"
            );
        }
        assert!(!mathematics.style_rules().contains('<'));
    }
}
