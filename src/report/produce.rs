//! A report from its folder's contents: what is needed is computed, decided, drawn and written as text.

use std::collections::BTreeMap;

use crate::parallel;

use crate::charts;
use crate::claims::{self, Ledger};
use crate::experiments;
use crate::experiments::{
    Context, Figure, FigureMaker, Needs, Outcome, Progress, References, Scene, TableMaker, figure_makers,
    table_makers,
};
use crate::report::assemble::{Material, assemble};
use crate::report::blocks::{BlockKind, Piece, pieces};
use crate::report::theorems::{THEOREMS_FILE, theorems};
use crate::report::{FactView, InputView, ReportError, render_edition, render_html, render_markdown};
use crate::scene::{ClaimEntry, EquationChart, Measured, MeasuredChart, ReportPlan};
use slipmode_plot::table::Table;
use slipmode_theory::{Equations, Role, asymptote_series, hopf};

/// The contents of a report folder, read and valid.
#[derive(Debug)]
pub struct Folder {
    /// `report.toml`.
    pub plan: ReportPlan,
    /// `claims.toml`.
    pub claims: Vec<ClaimEntry>,
    /// `equations.toml`.
    pub equations: Equations,
    /// `scenes/*.toml`, in the plan's order.
    pub scenes: Vec<Scene>,
    /// `prose/*.md` by file name.
    pub prose: BTreeMap<String, String>,
    /// Files that scenes refer to.
    pub references: References,
    /// What was measured apart.
    pub measured: Measured,
    /// `charts/*.toml`, in the plan's order.
    pub charts: Vec<EquationChart>,
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

/// Computes what claims of a folder need, and decides them.
pub(crate) fn decide(folder: &Folder, claims: &[ClaimEntry], progress: Progress) -> (Ledger, Outcome) {
    let needs = claims::needs(claims);
    let outcome = experiments::run(&folder.scenes, &needs, &folder.references, progress);
    let context = Context::new(&folder.equations, &outcome);
    (Ledger::decide(&folder.plan.name, claims, &context), outcome)
}

/// Makes a report: the same bytes for the same folder, but for the environment block.
///
/// # Errors
/// When prose places what does not exist or no scene provides, or cannot be rendered.
pub fn produce(
    folder: &Folder,
    environment: Vec<FactView>,
    progress: Progress,
) -> Result<Product, ReportError> {
    check_names(folder)?;
    let wanted = Wanted::of(folder);
    let mut needs = claims::needs(&folder.claims);
    needs.extend(wanted.needs());
    let outcome = experiments::run(&folder.scenes, &needs, &folder.references, progress);
    let context = Context::new(&folder.equations, &outcome).with_claims(&folder.claims);
    let ledger = Ledger::decide(&folder.plan.name, &folder.claims, &context);
    let (figures, tables) = wanted.apart(folder);
    let (figures, tables) = (wanted.figures(&outcome, &figures)?, wanted.tables(&context, &tables)?);
    let mut files = figure_and_table_files(&figures, &tables);
    files.insert("ledger.json".into(), ledger.to_json());
    files.extend(theorems(&ledger, &folder.equations).map(|text| (THEOREMS_FILE.to_owned(), text)));
    let view = assemble(Material {
        plan: &folder.plan,
        prose: &folder.prose,
        equations: &folder.equations,
        outcome: &outcome,
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
    files.insert("report.md".into(), render_edition(&view)?);
    files.insert("ledger.md".into(), render_markdown(&view)?);
    Ok(Product { ledger, files })
}

/// The tables and figures of one scene, with everything that the scene states.
pub(crate) fn produce_scene(
    scene: &Scene,
    equations: &Equations,
    references: &References,
    progress: Progress,
) -> BTreeMap<String, String> {
    let outcome =
        experiments::run(std::slice::from_ref(scene), &experiments::all_needs(), references, progress);
    let context = Context::new(equations, &outcome);
    let figures: Vec<Figure> = figure_makers().filter_map(|maker| maker.figure(&outcome)).collect();
    // Tables that need nothing computed are about the paper, not about the scene.
    let makers = all_table_makers().filter(|maker| !maker.needs.is_empty());
    let tables: Vec<Table> = makers.filter_map(|maker| maker.table(&context)).collect();
    figure_and_table_files(&figures, &tables)
}

/// The tables of the experiments, and those about the equations and the claims.
fn all_table_makers() -> impl Iterator<Item = &'static TableMaker> {
    table_makers().chain(claims::table_makers())
}

/// The figures and tables as files.
pub(crate) fn figure_and_table_files(figures: &[Figure], tables: &[Table]) -> BTreeMap<String, String> {
    let figures = figures.iter().map(|figure| (format!("figures/{}.svg", figure.id), figure.svg.clone()));
    let tables = tables.iter().map(|table| (format!("tables/{}.csv", table.id), table.to_csv()));
    figures.chain(tables).collect()
}

/// What is measured, what is charted and what the program computes have different names.
fn check_names(folder: &Folder) -> Result<(), ReportError> {
    let Folder { measured, charts, .. } = folder;
    let figures = measured.charts.iter().map(|measured| &measured.chart.caption.id);
    let figures = figures.filter(|id| figure_maker(id).is_some()).map(|id| (id, "measured"));
    let tables = measured.tables.iter().map(|table| &table.id);
    let tables = tables.filter(|id| table_maker(id).is_some()).map(|id| (id, "measured"));
    let is_taken = |id: &str| figure_maker(id).is_some() || table_maker(id).is_some();
    let charted = charts.iter().map(|chart| &chart.caption.id);
    let clashes = |id: &&String| is_taken(id) || measured.chart(id).is_some() || measured.table(id).is_some();
    let charted = charted.filter(clashes).map(|id| (id, "a chart of equations"));
    let fault = |(id, what)| {
        format!("report.toml: `{id}` is {what} and also computed or measured: one of them needs another name")
    };
    let faults: Vec<String> = figures.chain(tables).chain(charted).map(fault).collect();
    if faults.is_empty() { Ok(()) } else { Err(ReportError::Faults(faults)) }
}

fn figure_maker(id: &str) -> Option<&'static FigureMaker> {
    figure_makers().find(|maker| maker.id == id)
}

fn table_maker(id: &str) -> Option<&'static TableMaker> {
    all_table_makers().find(|maker| maker.id == id)
}

fn figure_of(measured: &MeasuredChart) -> Figure {
    let MeasuredChart { label, caption_markdown, data, chart } = measured;
    Figure { data: data.clone(), ..Figure::new(&chart.caption, label, caption_markdown, chart.svg()) }
}

/// The ids of the figures and tables that prose places, and of the tables with the numbers of its figures.
#[derive(Default)]
struct Wanted {
    figures: Vec<String>,
    tables: Vec<String>,
}

impl Wanted {
    /// What nothing provides is left to the renderer, which names the chapter that places it.
    fn of(folder: &Folder) -> Self {
        let mut wanted = Self::default();
        for text in folder.plan.chapters.iter().filter_map(|chapter| folder.prose.get(&chapter.prose)) {
            for piece in pieces(text) {
                if let Piece::Block(kind, id) = piece {
                    wanted.include(kind, &id);
                }
            }
        }
        for figure in wanted.figures.clone() {
            let made = figure_maker(&figure).map_or(&[][..], |maker| &maker.data);
            made.iter().for_each(|id| wanted.include(BlockKind::Table, id));
            let measured = folder.measured.chart(&figure).map_or(&[][..], |measured| &measured.data);
            measured.iter().for_each(|id| wanted.include(BlockKind::Table, id));
            if folder.charts.iter().any(|chart| chart.caption.id == figure) {
                wanted.include(BlockKind::Table, &figure);
            }
        }
        wanted
    }

    /// What no experiment makes: charts and tables that were measured, and charts of equations.
    fn apart(&self, folder: &Folder) -> (Vec<Figure>, Vec<Table>) {
        let is_placed = |chart: &&EquationChart| self.tables.contains(&chart.caption.id);
        let charts: Vec<&EquationChart> = folder.charts.iter().filter(is_placed).collect();
        let drawn = parallel::map(&charts, |chart| charts::draw(chart));
        let (figures, tables): (Vec<_>, Vec<_>) = drawn.into_iter().unzip();
        let Measured { charts, tables: measured, .. } = &folder.measured;
        let charts = charts.iter().filter(|measured| self.figures.contains(&measured.chart.caption.id));
        let figures = charts.map(figure_of).chain(figures).collect();
        (figures, measured.iter().cloned().chain(tables).collect())
    }

    fn include(&mut self, kind: BlockKind, id: &str) {
        let ids = match kind {
            BlockKind::Figure => &mut self.figures,
            BlockKind::Table => &mut self.tables,
            BlockKind::Equation | BlockKind::Claim => return,
        };
        if !ids.iter().any(|known| known == id) {
            ids.push(id.to_owned());
        }
    }

    fn needs(&self) -> Needs {
        let of_figures = self.figures.iter().filter_map(|id| figure_maker(id)).flat_map(|maker| &maker.needs);
        let of_tables = self.tables.iter().filter_map(|id| table_maker(id)).flat_map(|maker| maker.needs);
        of_figures.chain(of_tables).copied().collect()
    }

    fn figures(&self, outcome: &Outcome, apart: &[Figure]) -> Result<Vec<Figure>, ReportError> {
        let other = |id: &String| apart.iter().find(|one| one.id == *id);
        let shown = |id: &String| match figure_maker(id) {
            Some(maker) => Some((maker.id, maker.figure(outcome))),
            None => other(id).map(|one| (one.id.as_str(), Some(one.clone()))),
        };
        collect("figure", parallel::flat_map(&self.figures, shown), |_| None)
    }

    fn tables(&self, context: &Context, apart: &[Table]) -> Result<Vec<Table>, ReportError> {
        let other = |id: &String| apart.iter().find(|one| one.id == *id);
        let shown = |id: &String| match table_maker(id) {
            Some(maker) => Some((maker.id, maker.table(context))),
            None => other(id).map(|one| (one.id.as_str(), Some(one.clone()))),
        };
        let made = parallel::flat_map(&self.tables, shown);
        // A table that needs nothing computed is made of the paper's equations.
        let of_equations = |id: &str| {
            table_maker(id).filter(|maker| maker.needs.is_empty())?;
            let missing = context.equations.missing(roles_of(id)).join("; ");
            let missing = if missing.is_empty() { "they have another form".to_owned() } else { missing };
            Some(format!("equations.toml: the table `{id}` needs other equations: {missing}"))
        };
        collect("table", made, of_equations)
    }
}

/// The equations from which a table that needs nothing computed is derived.
fn roles_of(table: &str) -> &'static [Role] {
    match table {
        "series" => &asymptote_series::EQUATIONS,
        "hopf-coefficient" => &hopf::EQUATIONS,
        _ => &[],
    }
}

/// All that could be made, or a fault for each that the scenes do not provide.
fn collect<'i, T>(
    kind: &str,
    made: impl IntoIterator<Item = (&'i str, Option<T>)>,
    other_reason: impl Fn(&str) -> Option<String>,
) -> Result<Vec<T>, ReportError> {
    let mut faults = Vec::new();
    let mut all = Vec::new();
    for (id, one) in made {
        match one {
            Some(one) => all.push(one),
            None => faults.push(other_reason(id).unwrap_or_else(|| {
                format!("report.toml: no scene of the report computes what the {kind} `{id}` shows")
            })),
        }
    }
    if faults.is_empty() { Ok(all) } else { Err(ReportError::Faults(faults)) }
}
