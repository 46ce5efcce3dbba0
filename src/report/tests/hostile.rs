//! Hostile values in every field of a view: they stay text in every template.

use super::sample::view;
use crate::report::packed::tests::pieces_of;
use crate::report::*;
use slipmode_plot::table::Cell;

/// Tries to leave text, attributes, links, code, tables and formulas of both outputs.
const HOSTILE: &str = "\"><script>alert(1)</script><img src=x onerror=alert(1)> [a](javascript:b) ![i](http://e.example/i) \
    ' onmouseover='x | `{{ title }}` {% raw %} </style></title></svg><!-- --> \u{202e}";

/// The sample with the hostile text in every field, ids and formulas apart.
fn hostile_view() -> ReportView {
    let text = || HOSTILE.to_owned();
    let fact = || FactView { name: text(), value: text() };
    let mut view = view();
    (view.title, view.subtitle, view.summary_markdown) = (text(), text(), text());
    view.citation = CitationView {
        authors: text(),
        date: text(),
        program: text(),
        inputs_sha256: text(),
        bibtex: text(),
        csl: text(),
    };
    for card in &mut view.cards {
        (card.count, card.note) = (text(), text());
    }
    for change in &mut view.changes {
        (change.instead_markdown, change.affects_markdown) = (text(), text());
    }
    for sentence in &mut view.answer {
        sentence.text_markdown = text();
    }
    view.chapters[0].title = text();
    view.chapters[0].text_markdown =
        format!("{HOSTILE}\n\n# {HOSTILE}\n\n[[table:corners]]\n[[claim:B5]]\n[[equation:8]]\n");
    for group in &mut view.ledger {
        group.title = text();
        for claim in &mut group.claims {
            (claim.place, claim.strength, claim.command) = (text(), text(), text());
            (claim.statement_markdown, claim.acceptance_markdown, claim.verdict_markdown) =
                (text(), text(), text());
            (claim.counter_example_markdown, claim.remark_markdown) = (text(), text());
            claim.not_established_markdown = text();
            (claim.kind_markdown, claim.decided_markdown) = (text(), text());
            for reading in &mut claim.readings {
                (reading.words_markdown, reading.strength) = (text(), text());
                for part in &mut reading.parts {
                    (part.words_markdown, part.result_markdown) = (text(), text());
                    part.strength = text();
                }
            }
            for item in &mut claim.evidence {
                (item.kind, item.strength, item.text_markdown) = (text(), text(), text());
                (item.numbers, item.certificate, item.theorem) = (vec![fact()], text(), text());
                for line in &mut item.lines {
                    (line.words_markdown, line.fact_markdown) = (text(), text());
                    line.conditions_markdown = text();
                }
            }
        }
    }
    for equation in &mut view.equations {
        equation.caption_markdown = text();
    }
    for figure in &mut view.figures {
        (figure.label, figure.caption_markdown, figure.description) = (text(), text(), text());
    }
    let table = &mut view.tables[0];
    (table.title, table.note) = (text(), text());
    (table.columns[1].header, table.columns[1].unit) = (text(), text());
    table.rows[0] = table.rows[0].iter().map(|cell| Cell { text: text(), ..cell.clone() }).collect();
    let provenance = &mut view.provenance;
    (provenance.text_markdown, provenance.command) = (text(), text());
    provenance.inputs = vec![InputView { path: text(), bytes: text(), sha256: text() }];
    view.environment = vec![fact()];
    view
}

/// Names of the elements that open in HTML, with the text of each tag.
fn tags(html: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for part in html.split('<').skip(1).filter(|part| part.starts_with(|c: char| c.is_ascii_alphabetic())) {
        let tag = part.split('>').next().unwrap_or_default();
        let name = tag.split(|c: char| c.is_whitespace() || c == '/').next().unwrap_or_default();
        found.push((name.to_owned(), tag.to_owned()));
    }
    found
}

#[test]
fn hostile_values_stay_text_in_every_template_of_the_page() {
    let page = render_html(&hostile_view()).unwrap();
    let (before_script, script) = page.split_once("<script>").unwrap();
    let (script, rest) = script.split_once("</script>").unwrap();
    assert_eq!((script, rest.trim()), (page_style::SCRIPT, "</body>\n</html>"));
    let body = before_script.split("</style>").nth(1).unwrap().to_owned() + &pieces_of(&page).concat();
    for (name, tag) in tags(&body) {
        assert!(!matches!(name.as_str(), "script" | "img" | "iframe" | "object" | "style"), "{tag}");
        let quoted: Vec<&str> = tag.split('"').skip(1).step_by(2).collect();
        let bare = quoted.iter().fold(tag.clone(), |bare, value| bare.replacen(value, "", 1));
        assert!(!bare.contains("onerror") && !bare.contains("onmouseover"), "{tag}");
        assert!(!tag.contains("href=\"javascript"), "{tag}");
    }
    assert!(!page.contains('\u{202e}') && page.contains("{{ title }}"));
    let calm = render_html(&view()).unwrap();
    assert_eq!(page.matches("<title").count(), calm.matches("<title").count());
    assert_eq!(page.matches("</svg>").count(), calm.matches("</svg>").count());
}

#[test]
fn hostile_values_stay_text_in_every_template_of_the_markdown_report() {
    let report = render_markdown(&hostile_view()).unwrap();
    let mut prose = markdown::Prose::default();
    let html = prose.blocks(&report, 0, "report");
    for (name, tag) in tags(&html) {
        assert!(!matches!(name.as_str(), "script" | "img" | "style"), "{tag}");
        assert!(!tag.contains("href=\"javascript") && !tag.contains("href=\"http://e"), "{tag}");
    }
    let raw = markdown::raw_html(&report);
    let own =
        ["<!-- markdownlint-disable MD013 -->", "<!-- environment:begin -->", "<!-- environment:end -->"];
    assert!(raw.iter().all(|html| own.contains(&html.trim())), "{raw:?}");
    let rows = report.lines().filter(|line| line.starts_with('|'));
    let cells = |row: &str| row.replace("\\|", "").matches('|').count();
    assert!(rows.map(cells).all(|count| (3..=7).contains(&count)));
}
