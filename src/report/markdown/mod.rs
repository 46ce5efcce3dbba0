//! Prose: Markdown to HTML, and Markdown to harmless Markdown. The only folder that knows `pulldown-cmark`.
//!
//! Raw HTML and images are dropped, links keep only known schemes, headings take no attributes: prose comes from
//! files from unknown authors.

mod harmless;

pub(crate) use harmless::harmless;

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeStream, html};

use super::math::Mathematics;
use super::symbols::set_symbols;
use slipmode_plot::table::printable;

/// Schemes that a link may have.
const SCHEMES: [&str; 3] = ["https", "http", "mailto"];

/// Letters of a formula within a line that a screen of 320 px shows in any part of the page.
const LETTERS_OF_A_NARROW_LINE: usize = 18;

/// What rendering prose needs and gathers: formulas, deep links, faults.
#[derive(Debug, Default)]
pub(crate) struct Prose {
    /// Converter of formulas.
    pub mathematics: Mathematics,
    /// Deep links that prose points at, with the place where.
    pub links: Vec<(String, String)>,
    /// Deep links that headings offer.
    pub anchors: Vec<String>,
    /// What is wrong, with the place where.
    pub faults: Vec<String>,
}

/// What Markdown means here; one place for both outputs.
fn options() -> Options {
    Options::ENABLE_TABLES | Options::ENABLE_MATH
}

impl Prose {
    /// Blocks of prose as HTML; headings start `shift` levels below the top. `place` names the text in faults.
    pub fn blocks(&mut self, markdown: &str, shift: usize, place: &str) -> String {
        let mut events = Vec::new();
        let (mut dropped_links, mut image_depth) = (Vec::new(), 0_usize);
        let source = visible(markdown);
        for event in TextMergeStream::new(Parser::new_ext(&source, options())) {
            match event {
                Event::Html(_)
                | Event::InlineHtml(_)
                | Event::Start(Tag::HtmlBlock)
                | Event::End(TagEnd::HtmlBlock) => {}
                Event::Start(Tag::Image { .. }) => image_depth += 1,
                Event::End(TagEnd::Image) => image_depth = image_depth.saturating_sub(1),
                Event::Start(Tag::Link { ref dest_url, .. }) => {
                    let kept = self.allow(dest_url, place);
                    dropped_links.push(!kept);
                    events.extend(kept.then_some(event));
                }
                Event::End(TagEnd::Link) => {
                    events.extend((!dropped_links.pop().unwrap_or(false)).then_some(event))
                }
                Event::InlineMath(latex) => events.push(self.formula(&latex, false, place)),
                Event::DisplayMath(latex) => events.push(self.formula(&latex, true, place)),
                Event::Start(Tag::Table(columns)) => {
                    events.push(raw(
                        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\">",
                    ));
                    events.push(Event::Start(Tag::Table(columns)));
                }
                Event::End(TagEnd::Table) => events.extend([event, raw("</div>\n")]),
                other => events.push(other),
            }
        }
        self.set_headings(&mut events, shift, place);
        let mut text = String::new();
        html::push_html(&mut text, with_symbols(events));
        // Only a table has such a tag: text is escaped, and raw HTML is dropped.
        text.replace("<th ", "<th scope=\"col\" ").replace("<th>", "<th scope=\"col\">")
    }

    /// One paragraph of prose as HTML without the paragraph around it; several are kept as paragraphs.
    pub fn inline(&mut self, markdown: &str, place: &str) -> String {
        let text = self.blocks(markdown, 5, place);
        let inner = text.trim().strip_prefix("<p>").and_then(|rest| rest.strip_suffix("</p>"));
        inner.filter(|inner| !inner.contains("<p>")).map_or_else(|| text.trim().into(), String::from)
    }

    fn formula(&mut self, latex: &str, display: bool, place: &str) -> Event<'static> {
        let mut text = self.mathematics.convert(latex, display).unwrap_or_else(|fault| {
            self.faults.push(format!("{place}: formula {fault}"));
            String::new()
        });
        // What may be wider than a narrow screen scrolls by itself, with the keyboard too.
        if display || letters(&text) > LETTERS_OF_A_NARROW_LINE {
            let named = "class=\"formula\" tabindex=\"0\" role=\"group\" aria-label=\"Formula\"";
            text = format!("<span {named}>{text}</span>");
        }
        Event::InlineHtml(CowStr::from(text))
    }

    fn allow(&mut self, destination: &str, place: &str) -> bool {
        if let Some(anchor) = destination.strip_prefix('#') {
            self.links.push((anchor.into(), place.into()));
        }
        is_allowed(destination)
    }

    /// Moves headings down and gives them ids made of the place and their words.
    fn set_headings(&mut self, events: &mut [Event<'_>], shift: usize, place: &str) {
        for at in 0..events.len() {
            // Before the event is borrowed to be changed, and for headings only: the words reach to the end of the heading.
            let is_heading = matches!(events[at], Event::Start(Tag::Heading { .. }));
            let words = if is_heading { words_of_heading(&events[at..]) } else { String::new() };
            match &mut events[at] {
                Event::Start(Tag::Heading { level, id, .. }) => {
                    *level = lowered(*level, shift);
                    let anchor = format!("{}-{}", slug(place), slug(&words));
                    *id = Some(CowStr::from(anchor.clone()));
                    self.anchors.push(anchor);
                }
                Event::End(TagEnd::Heading(level)) => *level = lowered(*level, shift),
                _ => {}
            }
        }
    }
}

/// Letters between the tags of a formula.
fn letters(mathml: &str) -> usize {
    mathml.split('<').filter_map(|tag| tag.split_once('>')).map(|(_, text)| text.trim().chars().count()).sum()
}

/// The formulas of a Markdown text that cannot be set, each with its line, counted from 1, and what is wrong.
pub(crate) fn formula_faults(markdown: &str) -> Vec<(usize, String)> {
    let mut mathematics = Mathematics::default();
    let source = visible(markdown);
    let mut faults = Vec::new();
    for (event, place) in Parser::new_ext(&source, options()).into_offset_iter() {
        let set = match &event {
            Event::InlineMath(latex) => mathematics.convert(latex, false),
            Event::DisplayMath(latex) => mathematics.convert(latex, true),
            _ => continue,
        };
        let line = source.bytes().take(place.start).filter(|byte| *byte == b'\n').count() + 1;
        faults.extend(set.err().map(|fault| (line, fault)));
    }
    faults
}

/// Text outside code with the indices of its symbols below the line.
fn with_symbols<'a>(events: Vec<Event<'a>>) -> impl Iterator<Item = Event<'a>> {
    let mut is_code = false;
    events.into_iter().map(move |event| match event {
        Event::Text(text) if !is_code => Event::InlineHtml(set_symbols(&text).into()),
        other => {
            match other {
                Event::Start(Tag::CodeBlock(_)) => is_code = true,
                Event::End(TagEnd::CodeBlock) => is_code = false,
                _ => {}
            }
            other
        }
    })
}

fn raw(text: &'static str) -> Event<'static> {
    Event::Html(CowStr::from(text))
}

fn words_of_heading(events: &[Event<'_>]) -> String {
    let inside = events.iter().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
    let words = inside.filter_map(|event| match event {
        Event::Text(text) | Event::Code(text) => Some(text.as_ref()),
        _ => None,
    });
    words.collect()
}

fn lowered(level: HeadingLevel, shift: usize) -> HeadingLevel {
    HeadingLevel::try_from((level as usize + shift).min(6)).unwrap_or(HeadingLevel::H6)
}

/// The words of a heading as forges spell its deep link: lower case, hyphens for spaces, other signs dropped.
pub(crate) fn slug(words: &str) -> String {
    let kept = words.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// Whether a link may stay: a deep link, a path next to the page, or one of the known schemes.
fn is_allowed(destination: &str) -> bool {
    let plain = !destination.chars().any(|c| c.is_control() || c.is_whitespace() || c == '\\');
    let scheme = destination.split(['/', '?', '#']).next().and_then(|start| start.split_once(':'));
    let known = scheme.is_none_or(|(name, _)| SCHEMES.iter().any(|s| s.eq_ignore_ascii_case(name)));
    plain && known && !destination.starts_with("//")
}

/// The source with Unix line ends and without characters that are invisible or reorder text.
fn visible(markdown: &str) -> String {
    markdown.replace("\r\n", "\n").chars().map(printable).collect()
}

/// Raw HTML that the Markdown still holds.
#[cfg(test)]
pub(crate) fn raw_html(markdown: &str) -> Vec<String> {
    let events = Parser::new_ext(markdown, options());
    let raw = events.filter_map(|event| match event {
        Event::Html(text) | Event::InlineHtml(text) => Some(text.to_string()),
        _ => None,
    });
    raw.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: &str = "# Title {onclick=alert(1)}\n\n<script>alert(1)</script>\n\nA <b onmouseover=x>b</b> \
        [x](javascript:alert(1)) [y](JavaScript:z) <javascript:alert(2)> ![pic](https://example.org/p.png) \
        [ok](https://example.org/a) [d](data:text/html,x) [v](vbscript:x) [p](//example.org) [e](java\tscript:x)\n\n\
        [ref]\n\n[ref]: javascript:alert(3)\n\n<scr<b>ipt>alert(4)</scr</b>ipt>\n\n<div>[in](javascript:y)</div>\n";

    #[test]
    fn hostile_prose_becomes_harmless_html() {
        let mut prose = Prose::default();
        let html = prose.blocks(HOSTILE, 2, "chapter");
        for forbidden in [
            "<script",
            "<b ",
            "onmouseover=x>",
            "onclick=\"",
            "javascript:\"",
            "href=\"javascript",
            "<img",
            "data:text",
        ] {
            assert!(!html.contains(forbidden), "{forbidden} in {html}");
        }
        let links: Vec<&str> =
            html.split("href=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
        assert_eq!(links, ["https://example.org/a"]);
        assert!(html.contains("<h3 id=\"chapter-title"), "{html}");
    }

    #[test]
    fn hostile_prose_becomes_harmless_markdown() {
        let markdown = harmless(HOSTILE, 2, &|_| None);
        let html = {
            let mut text = String::new();
            html::push_html(&mut text, Parser::new_ext(&markdown, options()));
            text
        };
        for forbidden in ["<script", "<b ", "<div", "href=\"javascript", "href=\"data", "<img"] {
            assert!(!html.contains(forbidden), "{forbidden} in {html}");
        }
        assert!(markdown.contains("### Title"), "{markdown}");
        assert!(markdown.contains("[ok](https://example.org/a)"));
        assert!(!markdown.contains("[ref]: javascript"), "{markdown}");
    }

    #[test]
    fn references_end_where_their_definitions_lead() {
        let text = "![a][r] and [b][r] and [c][k]\n\n[r]: javascript:x\n[k]: #claim-A8\n";
        let found = harmless(text, 2, &|anchor| (anchor == "claim-A8").then(|| "#a8".into()));
        assert!(found.starts_with("a and b and [c](#a8)\n"), "{found}");
    }

    #[test]
    fn each_heading_of_a_table_has_one_scope() {
        let html = Prose::default().blocks("| a | b |\n|---|:-:|\n| 1 | 2 |\n", 2, "p");
        assert_eq!((html.matches("<th ").count(), html.matches("scope=\"col\"").count()), (2, 2), "{html}");
    }

    #[test]
    fn formulas_become_mathml_and_faults_name_the_place() {
        let mut prose = Prose::default();
        assert!(prose.inline("for $\\eta > 1$ it", "A8").starts_with("for <math>"));
        let wide = prose.inline("for $(a + b)(c + d) = a c + a d + b c + b d$ it", "A8");
        assert!(wide.starts_with("for <span class=\"formula\" tabindex=\"0\""), "{wide}");
        assert!(prose.faults.is_empty());
        prose.inline("bad $\\nonsense{1}$", "claim A8, statement");
        assert!(prose.faults[0].starts_with("claim A8, statement: formula"), "{:?}", prose.faults);
    }

    #[test]
    fn deep_links_are_gathered_and_led_to_the_markdown_headings() {
        let mut prose = Prose::default();
        prose.blocks("see [A8](#claim-A8)", 2, "chapter x");
        assert_eq!(prose.links, [("claim-A8".into(), "chapter x".into())]);
        let to = |anchor: &str| (anchor == "claim-A8").then(|| "#a8".into());
        assert_eq!(harmless("see [**A8**](#claim-A8), [f](#fig)", 2, &to), "see [**A8**](#a8), f");
    }

    #[test]
    fn headings_of_both_kinds_move_down() {
        let found = harmless("# One\n\nText\n\nTwo\n---\n\nEnd\n", 2, &|_| None);
        assert_eq!(found, "### One\n\nText\n\n#### Two\n\nEnd\n");
    }

    proptest::proptest! {
        #[test]
        fn no_prose_brings_markup_or_schemes(text in "[a<>/\\[\\]():!#`$*_ \n\\\\javscriptx=\"&;]{0,120}") {
            let clean = harmless(&text, 2, &|_| None);
            let bad = Parser::new_ext(&clean, options()).any(|event| match event {
                Event::Html(_) | Event::InlineHtml(_) | Event::Start(Tag::Image { .. }) => true,
                Event::Start(Tag::Link { dest_url, .. }) => !is_allowed(&dest_url),
                _ => false,
            });
            proptest::prop_assert!(!bad, "{text:?} -> {clean:?}");
        }
    }
}
