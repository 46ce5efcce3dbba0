//! A report from its folder's contents: what is needed is computed, decided, drawn and written as text.

use std::collections::BTreeMap;

use crate::claims::{self, Ledger};
use crate::experiments;
use crate::experiments::Context;
use crate::experiments::Scene;
use crate::experiments::{Figure, FigureMaker, TableMaker, figure_makers, table_makers};
use crate::experiments::{Needs, Outcome, Progress, References};
use crate::report::assemble::{Material, assemble};
use crate::report::blocks::{BlockKind, Piece, pieces};
use crate::report::{FactView, InputView, ReportError, render_html, render_markdown};
use crate::scene::{ClaimEntry, ReportPlan};
use slipmode_core::theory::PaperEquations;
use slipmode_plot::table::Table;

/// The contents of a report folder, read and valid.
#[derive(Debug)]
pub struct Folder {
    /// `report.toml`.
    pub plan: ReportPlan,
    /// `claims.toml`.
    pub claims: Vec<ClaimEntry>,
    /// `equations.toml`.
    pub equations: PaperEquations,
    /// `scenes/*.toml`, in the plan's order.
    pub scenes: Vec<Scene>,
    /// `prose/*.md` by file name.
    pub prose: BTreeMap<String, String>,
    /// Files that scenes refer to.
    pub references: References,
    /// Every file that was read, with its digest.
    pub inputs: Vec<InputView>,
}

/// What a report consists of.
#[derive(Debug)]
pub struct Product {
    /// The verdicts.
    pub ledger: Ledger,
    /// Text files by their path inside the output folder, `/` between the parts.
    pub files: BTreeMap<String, String>,
}

/// Makes a report: the same bytes for the same folder, but for the environment block. `place` is the folder in the commands
/// that the page prints.
///
/// # Errors
/// When prose places what does not exist or no scene provides, or cannot be rendered.
pub fn produce(
    folder: &Folder,
    place: &str,
    environment: Vec<FactView>,
    progress: Progress,
) -> Result<Product, ReportError> {
    let wanted = Wanted::of(folder);
    let mut needs = claims::needs(&folder.claims);
    needs.extend(wanted.needs());
    let outcome = experiments::run(&folder.scenes, &needs, &folder.references, progress);
    let context = Context { equations: &folder.equations, outcome: &outcome };
    let ledger = Ledger::decide(&folder.plan.name, &folder.claims, &context);
    let (figures, tables) = (wanted.figures(&outcome)?, wanted.tables(&context)?);
    let mut files = figure_and_table_files(figures.iter().map(|(figure, _)| figure), &tables);
    files.insert("ledger.json".into(), ledger.to_json());
    let view = assemble(Material {
        plan: &folder.plan,
        place,
        prose: &folder.prose,
        equations: &folder.equations,
        ledger: &ledger,
        figures,
        tables,
        inputs: folder.inputs.clone(),
        environment,
    });
    if let Some(picture) = &view.claims_picture {
        files.insert(format!("figures/{}.svg", picture.id), picture.svg.clone());
    }
    files.insert("index.html".into(), render_html(&view)?);
    files.insert("report.md".into(), render_markdown(&view)?);
    Ok(Product { ledger, files })
}

/// The tables and figures of one scene, with everything that the scene states.
#[must_use]
pub fn produce_scene(
    scene: &Scene,
    equations: &PaperEquations,
    references: &References,
    progress: Progress,
) -> BTreeMap<String, String> {
    let outcome =
        experiments::run(std::slice::from_ref(scene), &experiments::all_needs(), references, progress);
    let context = Context { equations, outcome: &outcome };
    let figures: Vec<Figure> = figure_makers().filter_map(|maker| (maker.make)(&outcome)).collect();
    // Tables that need nothing computed are about the paper, not about the scene.
    let tables: Vec<Table> = all_table_makers()
        .filter(|maker| !maker.needs.is_empty())
        .filter_map(|maker| (maker.make)(&context))
        .collect();
    figure_and_table_files(figures.iter(), &tables)
}

/// The tables of the experiments, and those about the equations and the claims.
fn all_table_makers() -> impl Iterator<Item = &'static TableMaker> {
    table_makers().chain(claims::table_makers())
}

fn figure_and_table_files<'f>(
    figures: impl Iterator<Item = &'f Figure>,
    tables: &[Table],
) -> BTreeMap<String, String> {
    let figures = figures.map(|figure| (format!("figures/{}.svg", figure.id), figure.svg.clone()));
    let tables = tables.iter().map(|table| (format!("tables/{}.csv", table.id), table.to_csv()));
    figures.chain(tables).collect()
}

/// The figures and tables that prose places, and the tables with the numbers of its figures.
struct Wanted {
    figures: Vec<&'static FigureMaker>,
    tables: Vec<&'static TableMaker>,
}

impl Wanted {
    /// What no maker knows is left to the renderer, which names the chapter that places it.
    fn of(folder: &Folder) -> Self {
        let mut wanted = Wanted { figures: Vec::new(), tables: Vec::new() };
        for text in folder.plan.chapters.iter().filter_map(|chapter| folder.prose.get(&chapter.prose)) {
            for piece in pieces(text) {
                if let Piece::Block(kind, id) = piece {
                    wanted.include(kind, &id);
                }
            }
        }
        let data: Vec<&str> = wanted.figures.iter().flat_map(|maker| maker.data).copied().collect();
        for id in data {
            wanted.include(BlockKind::Table, id);
        }
        wanted
    }

    fn include(&mut self, kind: BlockKind, id: &str) {
        match kind {
            BlockKind::Figure if !self.figures.iter().any(|maker| maker.id == id) => {
                self.figures.extend(figure_makers().find(|maker| maker.id == id));
            }
            BlockKind::Table if !self.tables.iter().any(|maker| maker.id == id) => {
                self.tables.extend(all_table_makers().find(|maker| maker.id == id));
            }
            BlockKind::Figure | BlockKind::Table | BlockKind::Equation | BlockKind::Claim => {}
        }
    }

    fn needs(&self) -> Needs {
        let of_figures = self.figures.iter().flat_map(|maker| maker.needs);
        let of_tables = self.tables.iter().flat_map(|maker| maker.needs);
        of_figures.chain(of_tables).copied().collect()
    }

    fn figures(&self, outcome: &Outcome) -> Result<Vec<(Figure, &'static [&'static str])>, ReportError> {
        let made =
            |maker: &&FigureMaker| (maker.id, (maker.make)(outcome).map(|figure| (figure, maker.data)));
        collect("figure", self.figures.iter().map(made))
    }

    fn tables(&self, context: &Context) -> Result<Vec<Table>, ReportError> {
        collect("table", self.tables.iter().map(|maker| (maker.id, (maker.make)(context))))
    }
}

/// All that could be made, or a fault for each that the scenes do not provide.
fn collect<'i, T>(
    kind: &str,
    made: impl Iterator<Item = (&'i str, Option<T>)>,
) -> Result<Vec<T>, ReportError> {
    let mut faults = Vec::new();
    let mut all = Vec::new();
    for (id, one) in made {
        match one {
            Some(one) => all.push(one),
            None => faults
                .push(format!("report.toml: no scene of the report computes what the {kind} `{id}` shows")),
        }
    }
    if faults.is_empty() { Ok(all) } else { Err(ReportError::Faults(faults)) }
}
