//! Figures of what happens close to K = K_c: sign of the coefficient, strip of bistability, amplitudes of cycles.

use crate::experiments::described::with_points;
use crate::experiments::near_transition::{
    CycleFamilyOutcome, Edge, FamilyCycle, NearRun, NearTransitionOutcome,
};
use crate::experiments::{Drawer, Outcome, SceneOutcome, Words};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_plot::figure::{Axis, LineChart, PointMark, Side, ZoneMap};
use slipmode_theory::hopf::degenerate_inertial_parameter;

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
    let mut map: ZoneMap = words.drawing()?;
    let (low, high) = (libm::log10(map.y.min), libm::log10(map.y.max));
    let above = |index| libm::exp10(low + (high - low) * f64::from(index) / f64::from(VERTICES));
    let place = |above: f64| (degenerate_inertial_parameter(1.0 + above), above);
    let curve: Vec<(f64, f64)> = (0..=VERTICES).map(above).map(place).collect();
    let edges = [map.x.min, map.x.max].map(|edge| vec![(edge, map.y.max), (edge, map.y.min)]);
    for (zone, edge) in map.zones.iter_mut().zip(edges) {
        zone.outlines = vec![[curve.clone(), edge].concat()];
    }
    let paper = nearest_f64(&outcome.potentially_unstable()?.slider()?.effect_ratio());
    let place = (degenerate_inertial_parameter(paper), paper - 1.0);
    map.lines.iter_mut().for_each(|line| line.points.clone_from(&curve));
    map.marks.push(PointMark::new("*β* of the simulations", place, Side::Right));
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
    let mut map: ZoneMap = words.drawing()?;
    (map.x.min, map.y.min) = (first, libm::exp10(libm::log10(0.1 * least).floor()));
    let (low, high) = (map.y.min, map.y.max);
    for zone in &mut map.zones {
        zone.outlines = vec![[points.clone(), vec![(limit, low), (first, low)]].concat()];
    }
    map.marks = points.iter().map(|&place| PointMark::new("", place, Side::Above)).collect();
    for (line, points) in map.lines.iter_mut().zip([points, vec![(limit, low), (limit, high)]]) {
        line.points = points;
    }
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
    let mut chart: LineChart = words.drawing()?;
    chart.y.max = 1.1 * near_peak(&upper, chart.x.min);
    let lines = [
        [vec![fold], upper].concat(),
        lower,
        slip.cycles.iter().map(place).collect(),
        run_peaks(near, aging),
        run_peaks(near, slip),
        theory(aging, &chart.x),
        theory(slip, &chart.x),
    ];
    Some(with_points(chart, lines)?.svg())
}

/// The peak of the stable branch where it leaves the chart.
fn near_peak(branch: &[(f64, f64)], from: f64) -> f64 {
    branch.iter().filter(|(excess, _)| *excess > from).map(|(_, peak)| *peak).fold(1.0, f64::max)
}

fn run_peaks(near: &NearTransitionOutcome, family: &CycleFamilyOutcome) -> Vec<(f64, f64)> {
    let is_its =
        |run: &&NearRun| run.law == family.law && run.inertial_parameter == family.inertial_parameter;
    let cycles = near.runs.iter().filter(is_its).filter(|run| run.periodic() == Some(true));
    let place = |run: &NearRun| {
        Some((nearest_f64(&run.stiffness_over_critical) - 1.0, run.outcome.as_ref().ok()?.log_peak()))
    };
    cycles.filter_map(place).collect()
}

/// A = √(A²/(K/K_c − 1) (K/K_c − 1)), on the side where it exists.
fn theory(family: &CycleFamilyOutcome, x: &Axis) -> Vec<(f64, f64)> {
    (0..=VERTICES)
        .map(|index| f64::from(index) / f64::from(VERTICES))
        .flat_map(|share| [x.min * share * share, x.max * share * share])
        .filter_map(|excess| Some((excess, family.predicted_amplitude(excess)?)))
        .collect()
}
