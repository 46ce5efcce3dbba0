//! The templates: embedded, parsed before use, every value in them escaped.

use serde::Serialize;
use tera::{Context, Kwargs, State, Tera, Value};

use super::ReportError;
use super::symbols::set_symbols;
use slipmode_plot::table::{escape_html, escape_markdown};

/// The templates with these names, each with its text.
macro_rules! sources {
    ($($name:literal)*) => { [$(($name, include_str!(concat!("../../templates/", $name))),)*] };
}

/// Templates of the page, and of the results of a verification. Every one is escaped for HTML, whatever its name.
const HTML: [(&str, &str); 23] = sources! {
    "report.html" "edition.html" "part.html" "verdicts.html" "ledger.html" "appendix.html"
    "paper.html" "contents.html" "chip.html" "claim.html" "claim_result.html" "claim_body.html"
    "figure.html" "proof.html" "folded_proof.html" "rows.html" "table.html" "equation.html"
    "verdict.html" "environment.html" "live.html" "explore.html" "junit.xml"
};

/// Templates of the Markdown report. Every one is escaped for Markdown.
const MARKDOWN: [(&str, &str); 6] = sources! {
    "report.md" "ledger.md" "verdicts.md" "claims.md" "part.md" "claim.md"
};

/// A set of templates with one way of escaping.
#[derive(Debug)]
pub(crate) struct Templates {
    engine: Tera,
}

impl Templates {
    /// The page's templates.
    ///
    /// # Errors
    /// When a template does not parse: an error of this program.
    pub fn html() -> Result<Self, ReportError> {
        Self::parsed(&HTML, |text, output| output.write_all(escape_html(text).as_bytes()))
    }

    /// The Markdown report's templates.
    ///
    /// # Errors
    /// When a template does not parse: an error of this program.
    pub fn markdown() -> Result<Self, ReportError> {
        Self::parsed(&MARKDOWN, |text, output| output.write_all(escape_markdown(text).as_bytes()))
    }

    fn parsed(sources: &[(&'static str, &'static str)], escape: tera::EscapeFn) -> Result<Self, ReportError> {
        let mut engine = Tera::new();
        engine.set_escape_fn(escape);
        // Every name ends with the empty suffix: nothing is left unescaped because of how it is called.
        engine.autoescape_on([""]);
        engine.register_filter("symbols", |words: &str, _: Kwargs, _: &State<'_>| {
            Value::safe_string(&set_symbols(words))
        });
        engine.add_raw_templates(sources.iter().copied()).map_err(|error| fault("templates", &error))?;
        Ok(Self { engine })
    }

    /// Renders a template with a view.
    ///
    /// # Errors
    /// When the template uses a field that the view does not have: an error of this program.
    pub fn render(&self, name: &str, view: &impl Serialize) -> Result<String, ReportError> {
        let context = Context::from_serialize(view).map_err(|error| fault(name, &error))?;
        self.engine.render(name, &context).map_err(|error| fault(name, &error))
    }
}

fn fault(template: &str, error: &tera::Error) -> ReportError {
    ReportError::Template { template: template.into(), reason: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_values_that_this_program_made_are_trusted() {
        for (name, source) in HTML.iter().chain(&MARKDOWN) {
            for before in source.rsplit("| safe").skip(1) {
                let value = before.trim_end().rsplit([' ', '.']).next().unwrap();
                let made = ["_html", "_svg", "_css", "_md", "_js"].iter().any(|end| value.ends_with(end));
                assert!(made, "{name}: {value} | safe");
            }
            let bare = source.replace("<script>{{ script_js | safe }}</script>", "");
            assert!(!bare.contains("<script") && !bare.contains("style=\""), "{name}");
        }
    }

    #[test]
    fn attributes_are_quoted() {
        for (name, source) in &HTML {
            assert!(!source.contains("={{"), "{name}: an attribute without quotes");
        }
    }
}
