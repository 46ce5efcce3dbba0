//! Scenes and report folders, read whole, with every fault of every file.

mod references;

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use slipmode::archive::{Files, sha256_hex};
use slipmode::claims::{equation_faults, procedures, row_faults};
use slipmode::experiments::{References, Scene, check_distinct_scene_names};
use slipmode::report::{Folder, InputView, formula_faults};
use slipmode::scene::{
    ClaimEntry, EquationChart, Fault, Faults, Limits, Problem, ReportPlan, file_text, join_proofs,
    read_chart, read_claims, read_equations, read_equations_partly, read_proofs,
};
use slipmode_theory::Equations;
use slipmode_theory::stated_proofs::StatedProofs;

use crate::cli::input::{fault_of, place_inside, read_small_file, unreadable};
use references::VECTORS;

/// The paper's equations for scenes that stand outside a report.
pub const EQUATIONS: &str = include_str!("../../reports/im-avouac/equations.toml");

/// The longest prose of a chapter, in bytes: a book's chapter has less, and markup without end costs more than its length.
const MOST_PROSE_BYTES: usize = 1 << 16;

/// Where the files of a report are.
#[derive(Debug)]
pub enum Source {
    /// In a folder.
    Folder(PathBuf),
    /// In memory, unpacked from an archive whose name messages use.
    Archive(PathBuf, Files),
}

impl Source {
    fn read(&self, path: &str) -> Result<Vec<u8>, Fault> {
        match self {
            Self::Folder(root) => {
                let place = place_inside(root, path).map_err(|error| unreadable(&root.join(path), &error))?;
                read_small_file(&place)
            }
            Self::Archive(root, files) => {
                let missing = || unreadable(&root.join(path), &io::Error::from(io::ErrorKind::NotFound));
                files.get(path).cloned().ok_or_else(missing)
            }
        }
    }
}

/// A reader of the files of one source that keeps what it read, and all faults.
#[derive(Debug)]
struct Reader {
    source: Source,
    limits: Limits,
    faults: Faults,
    inputs: Vec<InputView>,
    kept: Files,
}

/// Reads a report folder.
///
/// # Errors
/// Every fault of every file.
pub fn read_report(root: &Path, limits: Limits) -> Result<Folder, Faults> {
    read_report_from(Source::Folder(root.to_path_buf()), limits).map(|(folder, _)| folder)
}

/// Reads a report, and gives the files it consists of besides.
///
/// # Errors
/// Every fault of every file.
pub fn read_report_from(source: Source, limits: Limits) -> Result<(Folder, Files), Faults> {
    if let Source::Folder(root) = &source
        && !root.is_dir()
    {
        let error =
            io::Error::other("no such folder (expected: a report's folder, such as `slipmode new` writes)");
        return Err(vec![unreadable(root, &error)]);
    }
    let mut reader = Reader::new(source, limits);
    let plan = reader.read("report.toml", |file, bytes, _| ReportPlan::parse(file, bytes));
    let equations = reader.read("equations.toml", |file, bytes, _| read_equations_partly(file, bytes));
    let (equations, faults) = equations.unzip();
    let faults = faults.unwrap_or_default();
    let proofs = reader.proofs(plan.as_ref().map_or(&[], |plan| &plan.proofs));
    let has_proofs = proofs.is_some();
    let equations = equations.map(|equations| equations.with_proofs(proofs.unwrap_or_default()));
    let sound = equations.as_ref().filter(|_| faults.is_empty() && has_proofs);
    let claims = reader.read("claims.toml", |file, bytes, _| read_claims(file, bytes, &procedures(), sound));
    let of_claims = claims.as_ref().map(|claims| claim_faults(&reader.name("claims.toml"), claims, sound));
    let charts = plan.as_ref().map_or(&[][..], |plan| &plan.charts);
    let charts: Vec<_> = charts.iter().filter_map(|id| reader.chart(id, sound)).collect();
    reader.faults.extend(faults);
    reader.faults.extend(of_claims.unwrap_or_default());
    let (names, chapters) = plan.as_ref().map_or((&[][..], &[][..]), |plan| (&plan.scenes, &plan.chapters));
    let scenes: Vec<(String, Scene)> = names
        .iter()
        .filter_map(|name| {
            let scene = reader.read(&format!("scenes/{name}.toml"), Scene::parse)?;
            Some((reader.name(&format!("scenes/{name}.toml")), scene))
        })
        .collect();
    if let Err(faults) = check_distinct_scene_names(&scenes) {
        reader.faults.extend(faults);
    }
    let scenes: Vec<Scene> = scenes.into_iter().map(|(_, scene)| scene).collect();
    let mut prose = BTreeMap::new();
    for file in chapters.iter().map(|chapter| &chapter.prose).collect::<BTreeSet<_>>() {
        let text = reader.read(&format!("prose/{file}"), |file, bytes, _| read_prose(file, bytes));
        prose.extend(text.map(|text| (file.clone(), text)));
    }
    let references = reader.references(&scenes, VECTORS);
    let measured =
        plan.as_ref().and_then(|plan| plan.measured.as_ref()).map(|folder| reader.measured(folder));
    let measured = measured.flatten().unwrap_or_default();
    match (plan, claims, equations) {
        (Some(plan), Some(claims), Some(equations)) if reader.faults.is_empty() => {
            let inputs = reader.inputs;
            Ok((
                Folder { plan, claims, equations, scenes, prose, references, measured, charts, inputs },
                reader.kept,
            ))
        }
        _ => Err(reader.faults),
    }
}

/// What claims need of the equations, where these are sound, and of tables, and do not find there.
pub fn claim_faults(file: &str, claims: &[ClaimEntry], equations: Option<&Equations>) -> Faults {
    let of_equations = equations.map(|equations| equation_faults(file, claims, equations));
    of_equations.unwrap_or_default().into_iter().chain(row_faults(file, claims)).collect()
}

/// A scene on its own, with what it refers to.
#[derive(Debug)]
pub struct LoneScene {
    /// The scene.
    pub scene: Scene,
    /// The paper's equations.
    pub equations: Equations,
    /// Files that the scene names: next to it, or in the folders of its report.
    pub references: References,
}

/// Reads a scene.
///
/// # Errors
/// Every fault of the scene and of the files that it names.
pub fn read_scene(path: &Path, limits: Limits) -> Result<LoneScene, Faults> {
    let bytes = read_small_file(path).map_err(|fault| vec![fault])?;
    let scene = Scene::parse(&path.display().to_string(), &bytes, &limits)?;
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let report = Some(beside.join("..")).filter(|report| report.join(VECTORS).is_dir());
    let (place, files) = report.map_or((beside.to_path_buf(), ""), |report| (report, VECTORS));
    let mut reader = Reader::new(Source::Folder(place), limits);
    let references = reader.references(std::slice::from_ref(&scene), files);
    if !reader.faults.is_empty() {
        return Err(reader.faults);
    }
    let equations = read_equations("equations.toml", EQUATIONS.as_bytes())?;
    Ok(LoneScene { scene, equations, references })
}

impl Reader {
    fn new(source: Source, limits: Limits) -> Self {
        Self { source, limits, faults: Faults::new(), inputs: Vec::new(), kept: Files::new() }
    }

    /// The name of a file, for messages.
    fn name(&self, path: &str) -> String {
        let (Source::Folder(root) | Source::Archive(root, _)) = &self.source;
        root.join(path).display().to_string()
    }

    /// Reads the files of `proofs/` with these names.
    fn proofs(&mut self, names: &[String]) -> Option<Arc<StatedProofs>> {
        let path = |name: &String| format!("proofs/{name}.toml");
        let files: Vec<_> = names
            .iter()
            .map(|name| self.read(&path(name), |file, bytes, _| read_proofs(file, bytes)))
            .collect();
        // With a file missing, a fault of the others may only say so again.
        let files = files.into_iter().collect::<Option<Vec<_>>>()?;
        join_proofs(&self.name("proofs"), files).map_err(|faults| self.faults.extend(faults)).ok()
    }

    /// Reads a chart of equations, where these are sound.
    fn chart(&mut self, id: &str, equations: Option<&Equations>) -> Option<EquationChart> {
        let place = format!("charts/{id}.toml");
        self.read(&place, |file, bytes, limits| read_chart(file, bytes, limits, id, equations)).flatten()
    }

    /// Reads a file with `parse`; its faults are kept.
    fn read<T>(
        &mut self,
        path: &str,
        parse: impl FnOnce(&str, &[u8], &Limits) -> Result<T, Faults>,
    ) -> Option<T> {
        let bytes = self.source.read(path).map_err(|fault| self.faults.push(fault)).ok()?;
        self.inputs.push(InputView {
            path: path.to_string(),
            bytes: bytes.len().to_string(),
            sha256: sha256_hex(&bytes),
        });
        let parsed = parse(&self.name(path), &bytes, &self.limits);
        self.kept.insert(path.to_string(), bytes);
        parsed.map_err(|faults| self.faults.extend(faults)).ok()
    }
}

fn read_prose(file: &str, bytes: &[u8]) -> Result<String, Faults> {
    if bytes.len() > MOST_PROSE_BYTES {
        let problem = Problem::TooLarge { bytes: bytes.len() as u64, limit: MOST_PROSE_BYTES as u64 };
        return Err(vec![fault_of(Path::new(file), problem)]);
    }
    let text = file_text(file, bytes).map_err(|fault| vec![fault])?;
    let fault = |(line, message)| Fault::of(file, "formula", Problem::Equation(message)).at(Some(line));
    let faults: Faults = formula_faults(text).into_iter().map(fault).collect();
    if faults.is_empty() { Ok(text.to_string()) } else { Err(faults) }
}
