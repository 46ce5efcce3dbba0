//! The page's style sheet with its embedded font, and the content policy that admits nothing else.

use sha2::{Digest, Sha256};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

const STYLE: &str = include_str!("../../templates/style.css");

/// Rules of a page about one's own slider: its values stand below the answer, beside the map.
pub(crate) const OWN_STYLE: &str = include_str!("../../templates/own.css");

/// The page's script: sorting, finding and reading out, over what the page shows without it.
pub(crate) const SCRIPT: &str = include_str!("../../templates/page.js");

/// A subset of Latin Modern Math, renamed as its licence asks; see `templates/fonts/README.md`.
const MATH_FONT: &[u8] = include_bytes!("../../templates/fonts/slipmode-math.woff2");

/// The whole style sheet: the font, the rules, and those of the formulas' classes.
pub(crate) fn style_sheet(formula_rules: &str) -> String {
    let font = BASE64_STANDARD.encode(MATH_FONT);
    format!(
        "@font-face{{font-family:\"Slipmode Math\";src:url(\"data:font/woff2;base64,{font}\") format(\"woff2\")}}\n\
         {STYLE}{formula_rules}"
    )
}

/// The rules of a live map.
pub(crate) const LIVE_STYLE: &str = include_str!("../../templates/live.css");

/// The script of a live map: it evaluates what the program made.
pub(crate) const LIVE_SCRIPT: &str = include_str!("../../templates/live.js");

/// The explorer's script: it chooses among stored curves, steps and words.
pub(crate) const EXPLORER_SCRIPT: &str = include_str!("../../templates/explore.js");

/// The explorer's style sheet: that of the reports without the font, since no formula is set, and its own rules.
pub(crate) fn explorer_style_sheet() -> String {
    format!("{STYLE}{}{LIVE_STYLE}", include_str!("../../templates/explore.css"))
}

/// A content policy under which the page may use this style sheet, this script and embedded fonts: no requests.
pub(crate) fn content_policy(style_sheet: &str, script: &str) -> String {
    let digest = |text: &str| BASE64_STANDARD.encode(Sha256::digest(text.as_bytes()));
    let (style, script) = (digest(style_sheet), digest(script));
    format!(
        "default-src 'none'; style-src 'sha256-{style}'; script-src 'sha256-{script}'; font-src data:; base-uri 'none'; form-action 'none'"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_sheet_asks_for_nothing() {
        let style = style_sheet("");
        let addresses: Vec<&str> = style.split("url(").skip(1).map(|rest| &rest[..6]).collect();
        assert_eq!(addresses, ["\"data:"]);
        assert!(!style.contains("@import") && !style.contains("</style") && !style.contains("http"));
    }

    #[test]
    fn the_policy_admits_this_style_sheet_and_script_and_nothing_else() {
        let policy = content_policy("a{}", "f()");
        assert!(policy.contains("style-src 'sha256-") && policy.contains("script-src 'sha256-"), "{policy}");
        assert!(!policy.contains("unsafe") && !policy.contains("self") && !policy.contains('*'));
        assert_ne!(policy, content_policy("b{}", "f()"));
        assert_ne!(policy, content_policy("a{}", "g()"));
    }

    #[test]
    fn the_script_asks_for_nothing_and_makes_no_markup_of_text() {
        for word in [
            "fetch",
            "XMLHttp",
            "import",
            "eval",
            "innerHTML",
            "document.write",
            "http",
            "</script",
            "Function(",
        ] {
            for script in [SCRIPT, EXPLORER_SCRIPT, LIVE_SCRIPT] {
                assert!(!script.contains(word), "{word}");
            }
        }
    }
}
