//! The files of a new report, but for its claims.

use slipmode::scene::{Quantity, Sliders};

use crate::cli::folder::EQUATIONS;
use crate::cli::new::ranges::Ranges;
use crate::cli::new::scene::{Typed, scene_text};
use crate::cli::tree::Files;

/// The files for a < b, by their path in the folder.
const WEAKENING: [(&str, &str); 7] = [
    ("report.toml", include_str!("../../../templates/new/report-weakening.toml")),
    ("prose/introduction.md", INTRODUCTION),
    ("prose/map.md", include_str!("../../../templates/new/map-weakening.md")),
    ("prose/formulas.md", formulas_prose(Sliders::Weakening)),
    ("prose/frequency.md", include_str!("../../../templates/new/frequency.md")),
    ("prose/simulations.md", include_str!("../../../templates/new/simulations-weakening.md")),
    ("prose/slip-modes.md", include_str!("../../../templates/new/slip-modes-weakening.md")),
];

/// The files for a ≥ b: nothing that needs a critical normal stress.
const NEVER_UNSTABLE: [(&str, &str); 6] = [
    ("report.toml", include_str!("../../../templates/new/report-stable.toml")),
    ("prose/introduction.md", INTRODUCTION),
    ("prose/map.md", include_str!("../../../templates/new/map-stable.md")),
    ("prose/formulas.md", formulas_prose(Sliders::Neutral)),
    ("prose/simulations.md", include_str!("../../../templates/new/simulations-stable.md")),
    ("prose/slip-modes.md", include_str!("../../../templates/new/slip-modes-stable.md")),
];

const INTRODUCTION: &str = include_str!("../../../templates/new/introduction.md");

/// The files for a slider with an operating point, besides that on formulas; [`ERROR_BARS`] for values that have some, [`FIT`] for fitted ones.
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

const fn formulas_prose(effects: Sliders) -> &'static str {
    match effects {
        Sliders::Weakening => include_str!("../../../templates/new/formulas-weakening.md"),
        _ => include_str!("../../../templates/new/formulas-stable.md"),
    }
}

/// Every file but `claims.toml`.
pub fn folder_files(typed: &Typed, effects: Sliders, ranges: &Ranges) -> Files {
    let formulas = [("prose/formulas.md", formulas_prose(effects))];
    let texts: Vec<(&str, &str)> = match (&typed.own, effects) {
        (Some(_), _) => LABORATORY.into_iter().chain(formulas).collect(),
        (None, Sliders::Weakening) => WEAKENING.into(),
        (None, _) => NEVER_UNSTABLE.into(),
    };
    let texts = texts.into_iter().map(|(path, text)| (path.into(), filled(text, typed, effects)));
    let mut files: Files = texts.collect();
    files.insert("equations.toml".into(), EQUATIONS.to_string());
    files.insert(format!("scenes/{}.toml", typed.name), scene_text(typed, effects, ranges));
    if typed.own.is_none() {
        return files;
    }
    if !typed.slider.is_uncertain() {
        remove_chapter(&mut files, ERROR_BARS);
    }
    match &typed.fitted {
        Some(fitted) => _ = files.insert(RECORD.into(), fitted.record.clone()),
        None => remove_chapter(&mut files, FIT),
    }
    files
}

/// A text with the slider's name and numbers in place.
fn filled(text: &str, typed: &Typed, effects: Sliders) -> String {
    let is_weakening = effects == Sliders::Weakening;
    let values = [
        ("{name}", typed.name.clone()),
        ("{comparison}", effects.as_str().into()),
        ("{map}", if is_weakening { "fig-1" } else { "fig-6a" }.into()),
        ("{a}", typed.in_si(Quantity::DirectEffect)),
        ("{b}", typed.in_si(Quantity::EvolutionEffect)),
        ("{d}", typed.in_si(Quantity::CriticalSlipDistance)),
        ("{k}", typed.in_si(Quantity::Stiffness)),
        ("{m}", typed.in_si(Quantity::MassPerArea)),
        ("{s}", typed.in_si(Quantity::NormalStress)),
        ("{v}", typed.in_si(Quantity::LoadingVelocity)),
        ("{claim}", if is_weakening { CLAIM } else { "" }.into()),
    ];
    values.into_iter().fold(text.to_string(), |text, (key, value)| text.replace(key, &value))
}
