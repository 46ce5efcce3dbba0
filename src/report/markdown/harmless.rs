//! Markdown to Markdown: raw HTML, images and unknown schemes taken out, headings and deep links fitted in.

use std::ops::Range;

use pulldown_cmark::{Event, Parser, Tag};

use super::{is_allowed, options, visible};
use slipmode_plot::table::escape_markdown;

/// Markup nested deeper than this is hostile: each round costs the whole text, and takes one level off.
const MOST_ROUNDS: usize = 20;

/// The same prose as Markdown without raw HTML, images and unknown schemes; headings `shift` levels further down.
///
/// `link` says where a deep link of the page leads in the Markdown report, with the file or `#` in front; a link that leads nowhere keeps its words.
pub(crate) fn harmless(markdown: &str, shift: usize, link: &dyn Fn(&str) -> Option<String>) -> String {
    let mut text = visible(markdown);
    // What is dropped may bring forth new markup from its neighbours; every round makes the text shorter.
    for _ in 0..MOST_ROUNDS {
        let edits = hazards(&text);
        if edits.is_empty() {
            return edited(&text, finishing_edits(&text, shift, link));
        }
        text = edited(&text, edits);
    }
    // Markup inside markup without end is no prose: it is shown as it stands.
    text.lines().map(|line| escape_markdown(line) + "\n").collect()
}

type Edit = (Range<usize>, String);

/// Replacements of everything that must not stay.
fn hazards(text: &str) -> Vec<Edit> {
    let parser = Parser::new_ext(text, options());
    let definitions = parser.reference_definitions().iter();
    let refused = definitions.filter(|(_, definition)| !is_allowed(&definition.dest));
    let mut edits: Vec<Edit> = refused.map(|(_, one)| (one.span.clone(), String::new())).collect();
    let events: Vec<Spanned<'_>> = Parser::new_ext(text, options()).into_offset_iter().collect();
    let mut covered = 0;
    for (at, (event, range)) in events.iter().enumerate() {
        // What lies inside an element that goes is looked at in the next round: a thousand nested ones cost no thousand searches.
        if range.start < covered {
            continue;
        }
        let before = edits.len();
        match event {
            Event::Html(_) | Event::InlineHtml(_) | Event::Start(Tag::HtmlBlock) => {
                edits.push((range.clone(), String::new()));
            }
            Event::Start(Tag::Image { .. }) => edits.push((range.clone(), inner(text, &events[at..]))),
            Event::Start(Tag::Link { dest_url, .. }) if !is_allowed(dest_url) => {
                edits.push((range.clone(), inner(text, &events[at..])));
            }
            _ => {}
        }
        if edits.len() > before {
            covered = range.end;
        }
    }
    edits
}

/// Replacements that fit harmless prose into the Markdown report.
fn finishing_edits(text: &str, shift: usize, link: &dyn Fn(&str) -> Option<String>) -> Vec<Edit> {
    let mut edits = Vec::new();
    let events: Vec<Spanned<'_>> = Parser::new_ext(text, options()).into_offset_iter().collect();
    for (at, (event, range)) in events.iter().enumerate() {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                let marks = "#".repeat((*level as usize + shift).min(6));
                edits.push((range.clone(), format!("{marks} {}\n", inner(text, &events[at..]))));
            }
            Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with('#') => {
                let words = inner(text, &events[at..]);
                let linked = link(&dest_url[1..]).map(|to| format!("[{words}]({to})"));
                edits.push((range.clone(), linked.unwrap_or(words)));
            }
            _ => {}
        }
    }
    edits
}

type Spanned<'a> = (Event<'a>, Range<usize>);

/// The source inside the element that starts first, on one line.
fn inner(text: &str, events: &[Spanned<'_>]) -> String {
    let (mut depth, mut first, mut last) = (0_usize, usize::MAX, 0);
    for (event, span) in events {
        match event {
            Event::End(_) => depth -= 1,
            _ if depth > 0 => (first, last) = (first.min(span.start), last.max(span.end)),
            _ => {}
        }
        depth += usize::from(matches!(event, Event::Start(_)));
        if depth == 0 {
            break;
        }
    }
    text.get(first..last).unwrap_or_default().replace('\n', " ")
}

/// The text with replacements made; of two that overlap the earlier, wider one counts.
fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| (range.start, std::cmp::Reverse(range.end)));
    let (mut result, mut at) = (String::new(), 0);
    for (range, replacement) in edits {
        if range.start >= at {
            result += &text[at..range.start];
            result += &replacement;
            at = range.end;
        }
    }
    result + &text[at..]
}
