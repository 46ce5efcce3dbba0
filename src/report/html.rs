//! The page: one self-contained HTML file.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::blocks::{BlockKind, Piece, pieces};
use super::catalogue::{Catalogue, anchors, faults, group_anchor};
use super::claim_html::{chip, claim_page};
use super::markdown::Prose;
use super::packed::Packed;
use super::page_style::{LIVE_SCRIPT, LIVE_STYLE, OWN_STYLE, SCRIPT, content_policy, style_sheet};
use super::parts::{anchor, lead, runs, title};
use super::templates::Templates;
use super::view::{
    AnswerView, CardView, ChangeView, ChapterView, ClaimGroupView, ClaimView, EquationView, EvidenceView,
    FigureView, ReportView,
};
use super::{ReportError, cut_note, shown_rows};
use crate::scene::{Part, Source};
use slipmode_plot::figure::within_html;
use slipmode_plot::table::{Cell, Kind, Table};

/// Renders the page: HTML with style sheet, font, figures and mathematics inside, readable without scripts.
///
/// # Errors
/// All faults of the view at once: unknown or doubled ids, placing lines that place nothing, formulas that cannot be
/// read, deep links that lead nowhere.
pub fn render_html(view: &ReportView) -> Result<String, ReportError> {
    let mut page = Page {
        view,
        catalogue: Catalogue::of(view),
        templates: Templates::html()?,
        prose: Prose { faults: faults(view), ..Prose::default() },
        placed: BTreeSet::new(),
        packed: Packed::default(),
    };
    let context = page.context()?;
    page.check_links();
    if !page.prose.faults.is_empty() {
        return Err(ReportError::Faults(page.prose.faults));
    }
    page.templates.render("report.html", &context)
}

/// A page under construction.
struct Page<'a> {
    view: &'a ReportView,
    catalogue: Catalogue<'a>,
    templates: Templates,
    prose: Prose,
    placed: BTreeSet<String>,
    packed: Packed,
}

impl<'a> Page<'a> {
    /// What the template of the page shows.
    fn context(&mut self) -> Result<Value, ReportError> {
        let view = self.view;
        let (summary_html, figure_html) = self.summary()?;
        let answer: Vec<Value> = view.answer.iter().map(|sentence| self.sentence(sentence)).collect();
        let changes: Vec<Value> = view.changes.iter().filter_map(|change| self.change(change)).collect();
        let verdicts: Vec<Value> = view.cards.iter().map(|card| self.tiles(card)).collect();
        let [before, after] = runs(&view.chapters);
        let (of_paper, after) = after.into_iter().partition(|run| run[0].part == Some(Part::Paper));
        let (parts, later_parts) = (self.parts(before)?, self.parts(after)?);
        let paper = self.parts(of_paper)?.pop();
        let groups = self.groups()?;
        let picture_html = view.claims_picture.as_ref().map(|picture| self.figure(picture)).transpose()?;
        let appendix_html = self.appendix()?;
        let provenance = json!({
            "text_html": self.prose.blocks(&view.provenance.text_markdown, 2, "provenance"),
            "command": view.provenance.command,
            "inputs": view.provenance.inputs,
        });
        let own = if paper.is_some() { OWN_STYLE } else { "" };
        let (live_style, live_script) = view.live.as_ref().map_or(("", ""), |_| (LIVE_STYLE, LIVE_SCRIPT));
        let style_css = style_sheet(&format!("{}{own}{live_style}", self.prose.mathematics.style_rules()));
        let script_js = format!("{SCRIPT}{live_script}");
        Ok(json!({
            "title": view.title,
            "subtitle": view.subtitle,
            "citation": view.citation,
            "short_sha256": view.citation.inputs_sha256.get(..12),
            "policy": content_policy(&style_css, &script_js),
            "style_css": style_css,
            "answer": answer,
            "figure_html": figure_html,
            "changes": changes,
            "verdicts": verdicts,
            "summary_html": summary_html,
            "parts": parts,
            "groups": groups,
            "picture_html": picture_html.unwrap_or_default(),
            "later_parts": later_parts,
            "paper": paper,
            "script_js": script_js,
            "live": view.live,
            "appendix_html": appendix_html,
            "provenance": provenance,
            "environment_html": self.environment()?,
            "packed": self.packed.block(),
        }))
    }

    /// The prose of the summary, and the figures that it places: they stand beside the answer.
    fn summary(&mut self) -> Result<(String, String), ReportError> {
        let (mut prose, mut figures) = (String::new(), String::new());
        for piece in pieces(&self.view.summary_markdown) {
            match piece {
                Piece::Prose(text) => prose += &self.prose.blocks(&text, 2, "summary"),
                Piece::Block(BlockKind::Figure, id) => figures += &self.block(BlockKind::Figure, &id)?,
                Piece::Block(kind, id) => prose += &self.block(kind, &id)?,
                Piece::Unknown(_) => {}
            }
        }
        Ok((prose, figures))
    }

    fn sentence(&mut self, sentence: &AnswerView) -> Value {
        json!({
            "text_html": self.prose.inline(&sentence.text_markdown, "answer"),
            "is_list": sentence.is_list,
            "claims": self.with_words(sentence.claims.iter().map(String::as_str)),
        })
    }

    /// What would be true in the place of a sentence, with the claim.
    fn change(&mut self, change: &ChangeView) -> Option<Value> {
        let claim = self.catalogue.claims.get(change.claim.as_str()).copied()?;
        let mut html = |markdown: &str| self.prose.inline(markdown, "sentences to change");
        Some(json!({
            "chip": chip(claim),
            "place": claim.place,
            "words_html": html(&claim.statement_markdown),
            "instead_html": html(&change.instead_markdown),
            "affects_html": html(&change.affects_markdown),
        }))
    }

    /// The paper's claims of one verdict, each with its words.
    fn tiles(&mut self, card: &CardView) -> Value {
        let verdict = card.verdict;
        let claims = self.view.ledger.iter().flat_map(|group| &group.claims);
        let claims = claims.filter(|claim| claim.verdict == verdict && claim.source == Source::Paper);
        let ids = claims.map(|claim| claim.id.as_str());
        json!({
            "class": verdict.as_str(),
            "symbol": verdict.symbol(),
            "word": verdict.word(),
            "count": card.count,
            "note": card.note,
            "claims": self.with_words(ids),
        })
    }

    fn with_words<'i>(&mut self, ids: impl Iterator<Item = &'i str>) -> Vec<Value> {
        let claims: Vec<&ClaimView> = ids.filter_map(|id| self.catalogue.claims.get(id).copied()).collect();
        let one = |claim: &ClaimView| {
            let words = self.prose.inline(&claim.statement_markdown, &format!("claim {}", claim.id));
            json!({ "chip": chip(claim), "words_html": words })
        };
        claims.into_iter().map(one).collect()
    }

    fn groups(&mut self) -> Result<Vec<Value>, ReportError> {
        let view = self.view;
        let group = |(number, group): (usize, &ClaimGroupView)| {
            let claims_html = group.claims.iter().map(|claim| self.claim(claim));
            Ok(json!({
                "claims_html": claims_html.collect::<Result<Vec<_>, _>>()?,
                "anchor": group_anchor(number),
                "title": group.title,
                "chips": group.claims.iter().map(chip).collect::<Vec<_>>(),
            }))
        };
        (1..).zip(&view.ledger).map(group).collect()
    }

    /// A claim of the ledger. What it shows when it is opened is packed, and within it each proof.
    fn claim(&mut self, claim: &ClaimView) -> Result<String, ReportError> {
        let proofs = claim.evidence.iter().map(|evidence| self.proof(claim, evidence));
        let proofs = proofs.collect::<Result<Vec<_>, _>>()?;
        let mut page = claim_page(claim, &proofs, &self.catalogue, &mut self.prose);
        page["packed"] = self.packed.keep(self.templates.render("claim_body.html", &page)?).into();
        self.templates.render("claim.html", &page)
    }

    /// Where the page has a proof; nothing for evidence without one.
    fn proof(&mut self, claim: &ClaimView, evidence: &EvidenceView) -> Result<Value, ReportError> {
        if evidence.lines.is_empty() {
            return Ok(Value::Null);
        }
        let mut html = |markdown: &str| self.prose.inline(markdown, &format!("claim {}, proof", claim.id));
        let lines: Vec<Value> = evidence
            .lines
            .iter()
            .map(|line| {
                json!({
                    "number": line.number,
                    "words_html": html(&line.words_markdown),
                    "is_argued": line.is_argued,
                    "fact_html": html(&line.fact_markdown),
                    "conditions_html": html(&line.conditions_markdown),
                })
            })
            .collect();
        let proof = self.templates.render("proof.html", &json!({ "lines": lines }))?;
        let count = evidence.lines.len();
        Ok(json!({ "packed": self.packed.keep(proof), "lines": count, "theorem": evidence.theorem }))
    }

    fn parts(&mut self, runs: Vec<&'a [ChapterView]>) -> Result<Vec<Value>, ReportError> {
        let part = |run: &'a [ChapterView]| {
            let part = run[0].part;
            // Below the heading of a part, those of its chapters stand one level lower.
            let level = if part.is_some() { 3 } else { 2 };
            let chapters = run.iter().map(|chapter| {
                let body_html = self.chapter(chapter, level)?;
                Ok(json!({ "id": chapter.id, "title": chapter.title, "body_html": body_html }))
            });
            Ok(json!({
                "chapters": chapters.collect::<Result<Vec<_>, ReportError>>()?,
                "anchor": part.map_or_else(String::new, anchor),
                "title": part.map_or("", title),
                "lead": part.map_or("", lead),
                "is_folded": part.is_some_and(Part::follows_ledger),
            }))
        };
        runs.into_iter().map(part).collect()
    }

    fn chapter(&mut self, chapter: &'a ChapterView, level: usize) -> Result<String, ReportError> {
        let mut body_html = String::new();
        for piece in pieces(&chapter.text_markdown) {
            body_html += &match piece {
                Piece::Prose(text) => self.prose.blocks(&text, level, &chapter.id),
                Piece::Block(kind, id) => self.block(kind, &id)?,
                Piece::Unknown(_) => String::new(),
            };
        }
        Ok(body_html)
    }

    /// A placed block; one that does not exist has been reported before.
    fn block(&mut self, kind: BlockKind, id: &str) -> Result<String, ReportError> {
        self.placed.insert(id.into());
        let rendered = match kind {
            BlockKind::Figure => self.catalogue.figures.get(id).copied().map(|figure| self.figure(figure)),
            BlockKind::Table => self.catalogue.tables.get(id).copied().map(|table| self.table(table)),
            BlockKind::Equation => {
                self.catalogue.equations.get(id).copied().map(|equation| self.equation(equation))
            }
            BlockKind::Claim => {
                let claim = self.with_words(std::iter::once(id)).pop();
                claim.map(|claim| self.templates.render("verdict.html", &claim))
            }
        };
        rendered.unwrap_or_else(|| Ok(String::new()))
    }

    fn figure(&mut self, figure: &FigureView) -> Result<String, ReportError> {
        let context = json!({
            "id": figure.id,
            "label": figure.label,
            "is_of_paper": figure.has_number_of_the_paper(),
            "drawing_svg": within_html(&figure.svg),
            "caption_html": self.prose.inline(&figure.caption_markdown, &format!("caption of {}", figure.id)),
            "data": figure.data,
        });
        self.templates.render("figure.html", &context)
    }

    fn table(&mut self, table: &Table) -> Result<String, ReportError> {
        let note_html = self.prose.blocks(&table.note, 3, &format!("note of table {}", table.id));
        let file = format!("tables/{}.csv", table.id);
        table_html(&self.templates, table, note_html, Some((&file, &mut self.packed)))
    }

    fn equation(&mut self, equation: &EquationView) -> Result<String, ReportError> {
        let place = format!("equation {}", equation.id);
        let formula_html = self.prose.mathematics.convert(&equation.latex, true).unwrap_or_else(|fault| {
            self.prose.faults.push(format!("{place}: formula {fault}"));
            String::new()
        });
        let caption_html = self.prose.inline(&equation.caption_markdown, &place);
        let context =
            json!({ "id": equation.id, "formula_html": formula_html, "caption_html": caption_html });
        self.templates.render("equation.html", &context)
    }

    /// Figures and tables that no chapter placed.
    fn appendix(&mut self) -> Result<String, ReportError> {
        let view = self.view;
        let placed = std::mem::take(&mut self.placed);
        let figures = view.figures.iter().filter(|figure| !placed.contains(&figure.id));
        let figures = figures.map(|figure| self.figure(figure)).collect::<Result<String, _>>()?;
        let tables = view.tables.iter().filter(|table| !placed.contains(&table.id));
        Ok(figures + &tables.map(|table| self.table(table)).collect::<Result<String, _>>()?)
    }

    fn environment(&self) -> Result<String, ReportError> {
        if self.view.environment.is_empty() {
            return Ok(String::new());
        }
        self.templates.render("environment.html", &json!({ "facts": self.view.environment }))
    }

    /// Deep links must lead somewhere on this page.
    fn check_links(&mut self) {
        let mut known: BTreeSet<String> = anchors(self.view).into_iter().collect();
        known.extend(self.prose.anchors.iter().cloned());
        let dead = self.prose.links.iter().filter(|(anchor, _)| !known.contains(anchor));
        let faults = dead.map(|(anchor, place)| format!("{place}: link `#{anchor}` leads nowhere"));
        self.prose.faults.extend(faults);
    }
}

/// The first rows of a table as a figure. Beside a CSV file with all of them, more than a few are packed.
pub(super) fn table_html(
    templates: &Templates,
    table: &Table,
    note_html: String,
    beside: Option<(&str, &mut Packed)>,
) -> Result<String, ReportError> {
    let (rows, file) = (shown_rows(table), beside.as_ref().map_or("", |(file, _)| file));
    let mut context = json!({
        "id": table.id,
        "title": table.title,
        "file": file,
        "texts": text_columns(table),
        "columns": table.columns,
        "rows": table.rows[..rows],
        "cut": cut_note(table),
        "is_folded": beside.is_some() && rows > OPEN_ROWS,
        "count": rows,
        "note_html": note_html,
    });
    if let Some((_, packed)) = beside.filter(|_| rows > OPEN_ROWS) {
        context["packed"] = packed.keep(templates.render("rows.html", &context)?).into();
    }
    templates.render("table.html", &context)
}

/// Rows of a table that the page shows without being asked.
const OPEN_ROWS: usize = 6;

/// A class for each column of words, by its place from 1: `t1 w4`, where the words of column 4 take several lines.
fn text_columns(table: &Table) -> String {
    let texts = table.columns.iter().enumerate().filter(|(_, column)| column.kind == Kind::Text);
    let class = |index: usize| {
        let length = |row: &Vec<Cell>| row.get(index).map_or(0, |cell| cell.text.chars().count());
        let longest = table.rows.iter().take(shown_rows(table)).map(length).max();
        let letter = if longest.unwrap_or(0) > LINE_OF_WORDS { 'w' } else { 't' };
        format!("{letter}{}", index + 1)
    };
    texts.map(|(index, _)| class(index)).collect::<Vec<_>>().join(" ")
}

/// Characters of a cell of words that are kept on one line.
const LINE_OF_WORDS: usize = 24;
