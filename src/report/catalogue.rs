//! What a view offers by id, and the faults that can be seen without rendering it.

use std::collections::{BTreeMap, BTreeSet};

use super::blocks::{BlockKind, Piece, pieces};
use super::parts::{anchor, runs};
use super::view::{ClaimView, EquationView, FigureView, ReportView};
use slipmode_plot::table::Table;

/// Figures, tables, equations and claims by id.
#[derive(Debug)]
pub(crate) struct Catalogue<'a> {
    /// Figures by id.
    pub figures: BTreeMap<&'a str, &'a FigureView>,
    /// Tables by id.
    pub tables: BTreeMap<&'a str, &'a Table>,
    /// Equations by id.
    pub equations: BTreeMap<&'a str, &'a EquationView>,
    /// Claims by id.
    pub claims: BTreeMap<&'a str, &'a ClaimView>,
}

impl<'a> Catalogue<'a> {
    /// Everything the view offers.
    pub fn of(view: &'a ReportView) -> Self {
        let claims = view.ledger.iter().flat_map(|group| &group.claims);
        Self {
            figures: view.figures.iter().map(|figure| (figure.id.as_str(), figure)).collect(),
            tables: view.tables.iter().map(|table| (table.id.as_str(), table)).collect(),
            equations: view.equations.iter().map(|equation| (equation.id.as_str(), equation)).collect(),
            claims: claims.map(|claim| (claim.id.as_str(), claim)).collect(),
        }
    }

    /// Whether there is such a block.
    pub fn has(&self, kind: BlockKind, id: &str) -> bool {
        match kind {
            BlockKind::Figure => self.figures.contains_key(id),
            BlockKind::Table => self.tables.contains_key(id),
            BlockKind::Equation => self.equations.contains_key(id),
            BlockKind::Claim => self.claims.contains_key(id),
        }
    }
}

/// Sections that every page has.
const SECTIONS: [&str; 7] =
    ["overview", "sentences-to-change", "claims-by-verdict", "ledger", "appendix", "provenance", "inputs"];

/// Deep links of the page, in the order of the view; a link that occurs twice is a fault.
pub(crate) fn anchors(view: &ReportView) -> Vec<String> {
    let claims = view.ledger.iter().flat_map(|group| &group.claims);
    let mut all: Vec<String> = SECTIONS.iter().map(|&section| section.into()).collect();
    all.extend(view.chapters.iter().map(|chapter| chapter.id.clone()));
    all.extend(claims.map(|claim| format!("claim-{}", claim.id)));
    all.extend(view.figures.iter().chain(&view.claims_picture).map(|figure| figure.id.clone()));
    all.extend(runs(&view.chapters).into_iter().flatten().filter_map(|run| Some(anchor(run[0].part?))));
    all.extend(view.tables.iter().map(|table| format!("table-{}", table.id)));
    all.extend(view.equations.iter().map(|equation| format!("eq-{}", equation.id)));
    all.extend((1..=view.ledger.len()).map(group_anchor));
    all
}

/// Deep link of a group of claims by its number from 1.
pub(crate) fn group_anchor(number: usize) -> String {
    format!("ledger-{number}")
}

/// The summary and the chapters, each with its name.
pub(crate) fn texts(view: &ReportView) -> impl Iterator<Item = (&str, &str)> {
    let chapters = view.chapters.iter().map(|chapter| (chapter.id.as_str(), chapter.text_markdown.as_str()));
    std::iter::once(("summary", view.summary_markdown.as_str())).chain(chapters)
}

/// Faults of ids and references: every one, in the order of the view.
pub(crate) fn faults(view: &ReportView) -> Vec<String> {
    let catalogue = Catalogue::of(view);
    let mut found = id_faults(view);
    let mut placed = BTreeSet::new();
    for (chapter, text) in texts(view) {
        for piece in pieces(text) {
            match piece {
                Piece::Block(kind, id) if !catalogue.has(kind, &id) => {
                    found.push(format!("chapter {chapter}: there is no {kind} `{id}`"));
                }
                Piece::Block(kind @ (BlockKind::Figure | BlockKind::Table | BlockKind::Equation), id)
                    if !placed.insert((kind.as_str(), id.clone())) =>
                {
                    found.push(format!("chapter {chapter}: `{id}` is placed a second time"));
                }
                Piece::Unknown(line) => found.push(format!(
                    "chapter {chapter}: `{line}` names no block; a line has one figure, table, equation or claim"
                )),
                _ => {}
            }
        }
    }
    found.extend(reference_faults(view, &catalogue));
    found
}

fn id_faults(view: &ReportView) -> Vec<String> {
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    for anchor in anchors(view) {
        let fits = anchor.len() <= 100
            && anchor.starts_with(|c: char| c.is_ascii_alphanumeric())
            && anchor.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '-'));
        if !fits {
            found.push(format!(
                "id `{}`: must be letters, digits, `.`, `_`, `-`, at most 100",
                anchor.escape_debug()
            ));
        } else if !seen.insert(anchor.to_ascii_lowercase()) {
            found.push(format!("id `{anchor}` occurs twice (upper and lower case count as equal)"));
        }
    }
    found
}

fn reference_faults(view: &ReportView, catalogue: &Catalogue<'_>) -> Vec<String> {
    let mut found = Vec::new();
    for claims in view.answer.iter().map(|sentence| &sentence.claims) {
        let unknown = claims.iter().filter(|id| !catalogue.claims.contains_key(id.as_str()));
        found.extend(unknown.map(|id| format!("answer: there is no claim `{id}`")));
    }
    for claim in catalogue.claims.values() {
        let unknown = claim.rests_on.iter().filter(|id| !catalogue.claims.contains_key(id.as_str()));
        found.extend(unknown.map(|id| format!("claim {}: depends on unknown claim `{id}`", claim.id)));
    }
    for figure in &view.figures {
        let unknown = figure.data.iter().filter(|id| !catalogue.tables.contains_key(id.as_str()));
        found.extend(unknown.map(|id| format!("figure {}: there is no table `{id}`", figure.id)));
    }
    for table in &view.tables {
        let ragged = table.rows.iter().position(|row| row.len() != table.columns.len());
        found.extend(
            ragged.map(|row| format!("table {}: row {} has not one cell per column", table.id, row + 1)),
        );
    }
    found
}
