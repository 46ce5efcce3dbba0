//! Figures of what happens close to K = K_c: sign of the coefficient, strip of bistability, amplitudes of cycles.

use crate::experiments::near_transition::{CycleFamilyOutcome, Edge, FamilyCycle, NearTransitionOutcome};
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::theory::hopf::degenerate_inertial_parameter;
use slipmode_plot::figure::{
    Axis, Line, LineChart, LineRole, PointMark, Reference, RegionLabel, Series, Side, Zone, ZoneMap,
};

pub(crate) const FIGURES: &[Drawer] = &[
    ("criticality", |outcome, words| criticality(outcome, words)),
    ("bistability-strip", |outcome, words| strip(outcome.potentially_unstable()?, words)),
    ("cycle-amplitudes", |outcome, words| {
        amplitudes(outcome.potentially_unstable()?.near_transition.as_ref()?, words)
    }),
];

/// Vertices of a curve.
const VERTICES: u32 = 80;

fn criticality(outcome: &Outcome, words: &Words) -> Option<String> {
    let x = Axis::log10("*η*", "", 1e-3, 1e1);
    let y = Axis::log10("*β* − 1", "", 1e-2, 1e3);
    let (low, high) = (libm::log10(y.min), libm::log10(y.max));
    let curve: Vec<(f64, f64)> = (0..=VERTICES)
        .map(|index| libm::exp10(low + (high - low) * f64::from(index) / f64::from(VERTICES)))
        .map(|above| (degenerate_inertial_parameter(1.0 + above), above))
        .collect();
    let closed = |edge: f64| [curve.clone(), vec![(edge, y.max), (edge, y.min)]].concat();
    let zone = |label: &str, edge, style| Zone { label: label.into(), outlines: vec![closed(edge)], style };
    let paper = nearest_f64(&outcome.potentially_unstable()?.slider()?.effect_ratio());
    let map = ZoneMap {
        zones: vec![
            zone("aging law subcritical, slip law supercritical", x.min, 2),
            zone("both laws supercritical", x.max, 0),
        ],
        lines: vec![Line::new("*l*_1 = 0 with the aging law", LineRole::Boundary, curve.clone())],
        marks: vec![PointMark::new(
            "*β* of the simulations",
            (degenerate_inertial_parameter(paper), paper - 1.0),
            Side::Right,
        )],
        ..words.zone_map(x.clone(), y.clone())
    };
    Some(map.svg())
}

fn edges(near: &NearTransitionOutcome) -> Vec<(f64, &Edge)> {
    let edge = |family: &'_ CycleFamilyOutcome| nearest_f64(&family.inertial_parameter);
    let families = near.families.iter().filter(|family| family.law == EvolutionLaw::Aging);
    families.filter_map(|family| Some((edge(family), family.edge.as_ref().ok()?.as_ref()?))).collect()
}

fn strip(scene: &SceneOutcome, words: &Words) -> Option<String> {
    let edges = edges(scene.near_transition.as_ref()?);
    let points: Vec<(f64, f64)> = edges.iter().map(|(inertial, edge)| (*inertial, edge.excess)).collect();
    let least = points.iter().map(|(_, excess)| *excess).fold(f64::INFINITY, f64::min);
    let (first, _) = *points.first()?;
    let limit = degenerate_inertial_parameter(nearest_f64(&scene.slider()?.effect_ratio()));
    let x = Axis::log10("*η*", "", first, 1.0);
    let y = Axis::log10("*K*/*K*_c − 1", "", libm::exp10(libm::log10(0.1 * least).floor()), 1e-1);
    let outline = [points.clone(), vec![(limit, y.min), (first, y.min)]].concat();
    let label =
        |lines: &[&str], x, y| RegionLabel { lines: lines.iter().map(|&line| line.into()).collect(), x, y };
    let map = ZoneMap {
        zones: vec![Zone {
            label: "stable cycle and stable sliding".into(),
            outlines: vec![outline],
            style: 2,
        }],
        lines: vec![
            Line::new("limit: fold of cycles", LineRole::Boundary, points.clone()),
            Line::new("*η*_0, where *l*_1 = 0", LineRole::Guide, vec![(limit, y.min), (limit, y.max)]),
        ],
        marks: points.iter().map(|&(x, y)| PointMark::new("", (x, y), Side::Above)).collect(),
        labels: vec![
            label(&["two long-term behaviours:", "the start decides"], 1e-3, 2e-6),
            label(&["stable sliding only"], 1e-4, 1e-2),
        ],
        ..words.zone_map(x, y)
    };
    Some(map.svg())
}

/// The family of the law at the smallest η of the runs at which the aging law has an edge.
fn family<'c>(
    near: &'c NearTransitionOutcome,
    law: EvolutionLaw,
    inertial: &Rational,
) -> Option<&'c CycleFamilyOutcome> {
    near.families.iter().find(|family| family.law == law && family.inertial_parameter == *inertial)
}

fn amplitudes(near: &NearTransitionOutcome, words: &mut Words) -> Option<String> {
    let has_edge = |inertial: &&Rational| {
        family(near, EvolutionLaw::Aging, inertial).is_some_and(|family| matches!(family.edge, Ok(Some(_))))
    };
    let inertial = near.runs.iter().map(|run| &run.inertial_parameter).filter(has_edge).min()?;
    let aging = family(near, EvolutionLaw::Aging, inertial)?;
    let slip = family(near, EvolutionLaw::Slip, inertial)?;
    let edge = aging.edge.as_ref().ok()?.as_ref()?;
    words.fill(&[("inertial", &rational_to_decimal(inertial, 6))]);
    let fold = (edge.excess, edge.log_peak);
    let unstable = |cycle: &&FamilyCycle| cycle.log_peak < edge.log_peak;
    let place = |cycle: &FamilyCycle| (cycle.excess, cycle.log_peak);
    let lower: Vec<(f64, f64)> = aging.cycles.iter().filter(unstable).map(place).collect();
    let upper: Vec<(f64, f64)> = aging.cycles.iter().filter(|cycle| !unstable(cycle)).map(place).collect();
    let x = Axis::linear("*K*/*K*_c − 1", "", -0.01, 0.01);
    let highest = near_peak(&upper, x.min);
    let chart = LineChart {
        caption: words.caption.clone(),
        y: Axis::linear("ln(*V*_{peak}/*V*_l)", "", 0.0, 1.1 * highest),
        series: vec![
            Series::points("aging, stable", [vec![fold], upper].concat()),
            Series::points("aging, unstable", lower),
            Series::points("slip, stable", slip.cycles.iter().map(place).collect()),
            Series::points("aging, runs from *V*_l/10", run_peaks(near, aging)),
            Series::points("slip, runs from *V*_l/10", run_peaks(near, slip)),
            theory(aging, &x),
            Series { label: String::new(), ..theory(slip, &x) },
        ],
        references: vec![Reference::Vertical { at: 0.0, label: "*K* = *K*_c".into() }],
        x,
    };
    Some(chart.svg())
}

/// The peak of the stable branch where it leaves the chart.
fn near_peak(branch: &[(f64, f64)], from: f64) -> f64 {
    branch.iter().filter(|(excess, _)| *excess > from).map(|(_, peak)| *peak).fold(1.0, f64::max)
}

fn run_peaks(near: &NearTransitionOutcome, family: &CycleFamilyOutcome) -> Vec<(f64, f64)> {
    near.runs
        .iter()
        .filter(|run| run.law == family.law && run.inertial_parameter == family.inertial_parameter)
        .filter(|run| run.periodic() == Some(true))
        .filter_map(|run| {
            Some(((nearest_f64(&run.stiffness_over_critical) - 1.0), run.outcome.as_ref().ok()?.log_peak()))
        })
        .collect()
}

/// A = √(A²/(K/K_c − 1) (K/K_c − 1)), on the side where it exists.
fn theory(family: &CycleFamilyOutcome, x: &Axis) -> Series {
    let points = (0..=VERTICES)
        .map(|index| f64::from(index) / f64::from(VERTICES))
        .flat_map(|share| [x.min * share * share, x.max * share * share])
        .filter_map(|excess| Some((excess, family.predicted_amplitude(excess)?)))
        .collect();
    Series::of_theory("first Lyapunov coefficient", points)
}
