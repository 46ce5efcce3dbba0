//! The files of a new report, but for its claims.

use slipmode::scene::Quantity;

use crate::cli::folder::EQUATIONS;
use crate::cli::new::Effects;
use crate::cli::new::ranges::Ranges;
use crate::cli::new::scene::{Typed, scene_text};
use crate::cli::tree::Files;

/// A chapter: its id, which is its file's name too, its title and its text.
struct Chapter {
    id: &'static str,
    title: &'static str,
    prose: &'static str,
}

const INTRODUCTION: Chapter = Chapter {
    id: "introduction",
    title: "Behaviour of this slider, and which formula may be used for it",
    prose: include_str!("../../../templates/new/introduction.md"),
};

/// For a < b.
const WEAKENING: &[Chapter] = &[
    INTRODUCTION,
    map(include_str!("../../../templates/new/map-weakening.md")),
    formulas(formulas_prose(Effects::Weakening)),
    Chapter {
        id: "frequency",
        title: "Frequency",
        prose: include_str!("../../../templates/new/frequency.md"),
    },
    simulations(include_str!("../../../templates/new/simulations-weakening.md")),
    slip_modes(include_str!("../../../templates/new/slip-modes-weakening.md")),
];

/// For a ≥ b: nothing that needs a critical normal stress.
const NEVER_UNSTABLE: &[Chapter] = &[
    INTRODUCTION,
    map(include_str!("../../../templates/new/map-stable.md")),
    formulas(formulas_prose(Effects::Neutral)),
    simulations(include_str!("../../../templates/new/simulations-stable.md")),
    slip_modes(include_str!("../../../templates/new/slip-modes-stable.md")),
];

const fn map(prose: &'static str) -> Chapter {
    Chapter { id: "map", title: "Where sliding is stable, and where it oscillates", prose }
}

const fn formulas(prose: &'static str) -> Chapter {
    Chapter { id: "formulas", title: "Where each formula may be used, and with which error", prose }
}

const fn slip_modes(prose: &'static str) -> Chapter {
    Chapter { id: "slip-modes", title: "Slip modes", prose }
}

const fn simulations(prose: &'static str) -> Chapter {
    Chapter { id: "simulations", title: "Simulations", prose }
}

/// The files for a slider with an operating point, by their path in the folder; [`ERROR_BARS`] for values that have some, [`FIT`] for fitted ones.
const LABORATORY: [(&str, &str); 7] = [
    ("report.toml", include_str!("../../../templates/new/laboratory/report.toml")),
    ("prose/introduction.md", include_str!("../../../templates/new/laboratory/introduction.md")),
    (FIT, include_str!("../../../templates/new/laboratory/fit.md")),
    ("prose/changes.md", include_str!("../../../templates/new/laboratory/changes.md")),
    (ERROR_BARS, include_str!("../../../templates/new/laboratory/error-bars.md")),
    ("prose/runs.md", include_str!("../../../templates/new/laboratory/runs.md")),
    ("prose/comparison.md", include_str!("../../../templates/new/laboratory/comparison.md")),
];

const ERROR_BARS: &str = "prose/error-bars.md";
const FIT: &str = "prose/fit.md";
/// The record of velocity steps.
const RECORD: &str = "vectors/record.csv";

/// Places the claim that compares the runs with theory, where a transition exists.
const CLAIM: &str = include_str!("../../../templates/new/laboratory/claim.md");

fn laboratory_files(typed: &Typed, effects: Effects) -> Files {
    let files = LABORATORY.into_iter().chain([("prose/formulas.md", formulas_prose(effects))]);
    let mut files: Files = files.map(|(path, text)| (path.into(), filled(text, typed, effects))).collect();
    if !typed.slider.is_uncertain() {
        remove_chapter(&mut files, ERROR_BARS);
    }
    match &typed.fitted {
        Some(fitted) => _ = files.insert(RECORD.into(), fitted.record.clone()),
        None => remove_chapter(&mut files, FIT),
    }
    files
}

/// Removes a chapter's prose, and what the report says of it.
fn remove_chapter(files: &mut Files, prose: &str) {
    files.remove(prose);
    let name = prose.trim_start_matches("prose/");
    let without = |report: &str| {
        let kept: Vec<&str> = report.split("\n\n").filter(|chapter| !chapter.contains(name)).collect();
        kept.join("\n\n")
    };
    files.entry("report.toml".into()).and_modify(|report| *report = without(report));
}

const fn formulas_prose(effects: Effects) -> &'static str {
    match effects {
        Effects::Weakening => include_str!("../../../templates/new/formulas-weakening.md"),
        _ => include_str!("../../../templates/new/formulas-stable.md"),
    }
}

/// Every file but `claims.toml`.
pub fn folder_files(typed: &Typed, effects: Effects, ranges: &Ranges) -> Files {
    let shared = [
        ("equations.toml".into(), EQUATIONS.to_string()),
        (format!("scenes/{}.toml", typed.name), scene_text(typed, effects, ranges)),
    ];
    if typed.own.is_some() {
        return laboratory_files(typed, effects).into_iter().chain(shared).collect();
    }
    let chapters = if effects == Effects::Weakening { WEAKENING } else { NEVER_UNSTABLE };
    let prose = chapters
        .iter()
        .map(|chapter| (format!("prose/{}.md", chapter.id), filled(chapter.prose, typed, effects)));
    prose.chain([("report.toml".into(), report_text(&typed.name, chapters))]).chain(shared).collect()
}

fn report_text(name: &str, chapters: &[Chapter]) -> String {
    let head = format!(
        "# Name, title, scenes and chapters of the report; the first chapter is the summary, and its figure stands beside the answer.\n# To add a scene, write \
            scenes/OTHER.toml and list it. To add a chapter, write prose/OTHER.md and list it.\nname = \
            \"{name}\"\ntitle = \"{name}\"\nquestion = \"formulas\"  # what the first sentence answers: formulas or claims\nscenes = [\"{name}\"]\n"
    );
    let section = |chapter: &Chapter| {
        let Chapter { id, title, .. } = chapter;
        format!("\n[[chapter]]\nid = \"{id}\"\ntitle = \"{title}\"\nprose = \"{id}.md\"\n")
    };
    std::iter::once(head).chain(chapters.iter().map(section)).collect()
}

/// The prose with the slider's name and numbers in place.
fn filled(prose: &str, typed: &Typed, effects: Effects) -> String {
    let (comparison, map) = match effects {
        Effects::Weakening => ("a < b", "fig-1"),
        Effects::Neutral => ("a = b", "fig-6a"),
        Effects::Strengthening => ("a > b", "fig-6a"),
    };
    let values = [
        ("{name}", typed.name.clone()),
        ("{comparison}", comparison.into()),
        ("{map}", map.into()),
        ("{a}", typed.in_si(Quantity::DirectEffect)),
        ("{b}", typed.in_si(Quantity::EvolutionEffect)),
        ("{d}", typed.in_si(Quantity::CriticalSlipDistance)),
        ("{k}", typed.in_si(Quantity::Stiffness)),
        ("{m}", typed.in_si(Quantity::MassPerArea)),
        ("{s}", typed.in_si(Quantity::NormalStress)),
        ("{v}", typed.in_si(Quantity::LoadingVelocity)),
        ("{claim}", if effects == Effects::Weakening { CLAIM } else { "" }.into()),
    ];
    values.into_iter().fold(prose.to_string(), |text, (key, value)| text.replace(key, &value))
}
