//! The Markdown report: complete, for forges and for reading as it is, with links to figures and tables.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::blocks::{BlockKind, Piece, pieces};
use super::catalogue::{Catalogue, faults, texts};
use super::claim_text::{cell, claim_text, code_span, line};
use super::markdown::{harmless, slug};
use super::parts::{lead, runs, title};
use super::templates::Templates;
use super::view::{
    AnswerView, CardView, ChangeView, ChapterView, ClaimGroupView, ClaimView, EquationView, FactView,
    FigureView, InputView, ReportView,
};
use super::{ReportError, cut_note, shown_rows};
use crate::scene::Part;
use slipmode_plot::table::{Table, escape_cell, escape_markdown};

/// Renders the whole report as Markdown, one document that links to `figures/*.svg` and `tables/*.csv` next to it.
///
/// # Errors
/// The faults of the view that [`super::render_html`] reports too, save those of formulas and deep links.
pub fn render_markdown(view: &ReportView) -> Result<String, ReportError> {
    Report::rendered(view, "ledger.md", "", |report| report.context())
}

/// The heading of the sentences to change.
const CHANGES: &str = "sentences-to-change";
/// What begins a claim among the text.
const QUOTE: &str = "> ";

/// Renders the reader's edition: answer, sentences to change, verdicts with what decides them, and the paper's figures.
///
/// # Errors
/// Those of the whole report.
pub fn render_edition(view: &ReportView) -> Result<String, ReportError> {
    Report::rendered(view, "report.md", "ledger.md", |report| report.edition())
}

/// A report under construction.
struct Report<'a> {
    view: &'a ReportView,
    catalogue: Catalogue<'a>,
    templates: &'a Templates,
    /// The file in which claims and chapters have their headings; empty for this one.
    whole: &'static str,
}

impl<'a> Report<'a> {
    /// A template with what it shows of a view.
    fn rendered(
        view: &'a ReportView,
        template: &str,
        whole: &'static str,
        context: impl FnOnce(&Report<'_>) -> Result<Value, ReportError>,
    ) -> Result<String, ReportError> {
        let found = faults(view);
        if !found.is_empty() {
            return Err(ReportError::Faults(found));
        }
        let templates = Templates::markdown()?;
        let report = Report { view, catalogue: Catalogue::of(view), templates: &templates, whole };
        Ok(tidied(&templates.render(template, &context(&report)?)?))
    }

    /// What the reader's edition shows.
    fn edition(&self) -> Result<Value, ReportError> {
        let figures = self.view.figures.iter().filter(|figure| figure.has_number_of_the_paper());
        Ok(json!({
            "title": self.view.title,
            "subtitle": self.view.subtitle,
            "answer": self.view.answer.iter().map(|sentence| self.sentence(sentence)).collect::<Vec<_>>(),
            "changes": self.changes(),
            "cards": self.view.cards.iter().map(card).collect::<Vec<_>>(),
            "groups": self.groups()?,
            "figures": figures.map(|figure| self.figure(figure)).collect::<Vec<_>>(),
        }))
    }

    fn changes(&self) -> Vec<Value> {
        let cell = |markdown: &str| cell(&line(&self.prose(markdown, 1)));
        let change = |change: &ChangeView| {
            let claim = self.catalogue.claims.get(change.claim.as_str())?;
            Some(json!({
                "link_md": self.claim_link(&change.claim),
                "place_md": escape_cell(&claim.place),
                "words_md": cell(&claim.statement_markdown),
                "instead_md": cell(&change.instead_markdown),
                "affects_md": cell(&change.affects_markdown),
            }))
        };
        self.view.changes.iter().filter_map(change).collect()
    }

    fn context(&self) -> Result<Value, ReportError> {
        let view = self.view;
        let [before, after] = runs(&view.chapters);
        let (of_paper, after) =
            after.into_iter().partition::<Vec<_>, _>(|run| run[0].part == Some(Part::Paper));
        Ok(json!({
            "title": view.title,
            "subtitle": view.subtitle,
            "answer": view.answer.iter().map(|sentence| self.sentence(sentence)).collect::<Vec<_>>(),
            "changes": self.changes(),
            "summary_md": self.body(&view.summary_markdown, 1),
            "cards": view.cards.iter().map(card).collect::<Vec<_>>(),
            "parts": before.into_iter().map(|run| self.part(run)).collect::<Vec<_>>(),
            "groups": self.groups()?,
            "picture_md":
                view.claims_picture.as_ref().map_or_else(String::new, |picture| self.figure(picture)),
            "later_parts": after.into_iter().map(|run| self.part(run)).collect::<Vec<_>>(),
            "paper": of_paper.first().map(|run| self.part(run)),
            "appendix_md": self.appendix(),
            "provenance": self.provenance(),
            "environment": view.environment.iter().map(fact).collect::<Vec<_>>(),
        }))
    }

    fn prose(&self, markdown: &str, shift: usize) -> String {
        harmless(markdown, shift, &|anchor| self.heading_of(anchor).map(|heading| self.link_to(&heading)))
    }

    /// A link to a heading, which the whole report has.
    fn link_to(&self, heading: &str) -> String {
        let is_here = ["verdicts", CHANGES].contains(&heading);
        format!("{}#{heading}", if is_here { "" } else { self.whole })
    }

    fn claim_link(&self, id: &str) -> String {
        format!("[{}]({})", escape_cell(id), self.link_to(&slug(id)))
    }

    /// Where a deep link of the page leads here: claims and chapters have headings, blocks have none.
    fn heading_of(&self, anchor: &str) -> Option<String> {
        if let Some(id) = anchor.strip_prefix("claim-").filter(|id| self.catalogue.claims.contains_key(id)) {
            return Some(slug(id));
        }
        let chapter = self.view.chapters.iter().find(|chapter| chapter.id == anchor);
        let fixed = [
            ("ledger", "ledger-of-claims"),
            ("provenance", "provenance"),
            ("claims-by-verdict", "verdicts"),
            (CHANGES, CHANGES),
        ];
        let section = fixed.iter().find(|(name, _)| *name == anchor).map(|(_, heading)| (*heading).into());
        chapter.map(|chapter| slug(&chapter.title)).or(section)
    }

    fn sentence(&self, sentence: &AnswerView) -> Value {
        let words = |id: &String| {
            let claim = self.catalogue.claims.get(id.as_str())?;
            Some(
                json!({ "link_md": self.claim_link(id), "words_md": line(&self.prose(&claim.statement_markdown, 1)) }),
            )
        };
        let listed = sentence.claims.iter().filter(|_| sentence.is_list).filter_map(words);
        let links = sentence.claims.iter().filter(|_| !sentence.is_list).map(|id| self.claim_link(id));
        json!({
            "text_md": line(&self.prose(&sentence.text_markdown, 1)),
            "claims_md": links.collect::<Vec<_>>().join(", "),
            "listed": listed.collect::<Vec<_>>(),
        })
    }

    fn groups(&self) -> Result<Vec<Value>, ReportError> {
        let prose = |markdown: &str| self.prose(markdown, 4);
        let text = |claim: &ClaimView| claim_text(claim, &|id| self.claim_link(id), &prose);
        let group = |group: &ClaimGroupView| {
            let claims: Vec<Value> = group.claims.iter().map(text).collect();
            let rendered = claims.iter().map(|claim| self.templates.render("claim.md", claim));
            let claims_md = rendered.collect::<Result<Vec<_>, _>>()?;
            Ok(json!({ "title": group.title, "claims": claims, "claims_md": claims_md }))
        };
        self.view.ledger.iter().map(group).collect()
    }

    fn part(&self, run: &[ChapterView]) -> Value {
        let part = run[0].part;
        let level = if part.is_some() { 3 } else { 2 };
        let chapter = |chapter: &ChapterView| json!({ "title": chapter.title, "body_md": self.body(&chapter.text_markdown, level) });
        json!({
            "title": part.map_or("", title),
            "lead": part.map_or("", lead),
            "chapters": run.iter().map(chapter).collect::<Vec<_>>(),
        })
    }

    fn body(&self, markdown: &str, level: usize) -> String {
        let piece = |piece| match piece {
            Piece::Prose(text) => self.prose(text.trim(), level),
            Piece::Block(kind, id) => self.block(kind, &id),
            Piece::Unknown(_) => String::new(),
        };
        let texts: Vec<String> =
            pieces(markdown).into_iter().map(piece).filter(|text| !text.is_empty()).collect();
        let runs = texts.chunk_by(|one, next| one.starts_with(QUOTE) && next.starts_with(QUOTE));
        runs.map(|run| run.join("\n>\n")).collect::<Vec<_>>().join("\n\n")
    }

    fn block(&self, kind: BlockKind, id: &str) -> String {
        let text = match kind {
            BlockKind::Figure => self.catalogue.figures.get(id).map(|figure| self.figure(figure)),
            BlockKind::Table => self.catalogue.tables.get(id).map(|table| self.table(table)),
            BlockKind::Equation => self.catalogue.equations.get(id).map(|equation| self.equation(equation)),
            BlockKind::Claim => self.catalogue.claims.get(id).map(|claim| {
                let statement = line(&self.prose(&claim.statement_markdown, 2));
                let (link, verdict) = (self.claim_link(&claim.id), claim.verdict);
                format!("{QUOTE}{link} {} {}: {statement}", verdict.symbol(), verdict.word())
            }),
        };
        text.unwrap_or_default()
    }

    fn figure(&self, figure: &FigureView) -> String {
        let description = escape_markdown(&figure.description);
        let caption = line(&self.prose(&figure.caption_markdown, 3));
        let link = |id: &String| format!(" [{}](tables/{id}.csv)", escape_markdown(&format!("{id}.csv")));
        let data = figure.data.iter().map(link);
        let (id, label) = (&figure.id, escape_markdown(&figure.label));
        format!("![{description}](figures/{id}.svg)\n\n**{label}.** {caption}{}", data.collect::<String>())
    }

    fn table(&self, table: &Table) -> String {
        let rows = table.first_rows_to_markdown(shown_rows(table));
        let title = escape_markdown(&table.title);
        let cut = escape_markdown(&cut_note(table));
        let note = self.prose(&table.note, 3);
        format!("**{title}.** [CSV](tables/{}.csv)\n\n{rows}\n{cut}\n\n{note}", table.id)
    }

    fn equation(&self, equation: &EquationView) -> String {
        let caption = line(&self.prose(&equation.caption_markdown, 3));
        let latex = equation.latex.trim().replace("$$", "");
        format!("Equation {}: {caption}\n\n$$\n{latex}\n$$", escape_markdown(&equation.id))
    }

    fn appendix(&self) -> String {
        let id = |piece| if let Piece::Block(_, id) = piece { Some(id) } else { None };
        let placed = texts(self.view).flat_map(|(_, text)| pieces(text)).filter_map(id);
        let placed: BTreeSet<String> = placed.collect();
        let figures = self.view.figures.iter().filter(|figure| !placed.contains(&figure.id));
        let tables = self.view.tables.iter().filter(|table| !placed.contains(&table.id));
        let blocks = figures.map(|figure| self.figure(figure)).chain(tables.map(|table| self.table(table)));
        blocks.collect::<Vec<_>>().join("\n\n")
    }

    fn provenance(&self) -> Value {
        let provenance = &self.view.provenance;
        let input = |input: &InputView| {
            json!({
                "path_md": escape_cell(&input.path),
                "bytes_md": escape_cell(&input.bytes),
                "sha256_md": code_span(&input.sha256),
            })
        };
        json!({
            "text_md": self.prose(&provenance.text_markdown, 2),
            "command_md": code_span(&provenance.command),
            "inputs": provenance.inputs.iter().map(input).collect::<Vec<_>>(),
        })
    }
}

fn card(card: &CardView) -> Value {
    let verdict = card.verdict;
    json!({
        "symbol": verdict.symbol(), "word": verdict.word(), "count": card.count, "note": card.note,
    })
}

fn fact(fact: &FactView) -> Value {
    json!({ "name_md": escape_cell(&fact.name), "value_md": escape_cell(&fact.value) })
}

/// The text without trailing spaces, with single blank lines and even empty cells, code apart, and one newline at the end.
fn tidied(text: &str) -> String {
    let mut tidy = String::with_capacity(text.len());
    let (mut in_code, mut blank) = (false, true);
    for line in text.lines() {
        let fence = line.trim_start().starts_with("```");
        let kept = if in_code { line.to_owned() } else { line.trim_end().replace("|  |", "| |") };
        if in_code || fence || !(kept.is_empty() && blank) {
            tidy += &kept;
            tidy.push('\n');
        }
        blank = !in_code && kept.is_empty();
        in_code ^= fence;
    }
    tidy.trim_end().to_owned() + "\n"
}
