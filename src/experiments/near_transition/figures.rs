//! Figures of what happens close to K = K_c: sign of the coefficient, strip of bistability, amplitudes of cycles.

use crate::experiments::near_transition::{CycleFamilyOutcome, Edge, FamilyCycle, NearTransitionOutcome};
use crate::experiments::{Figure, FigureMaker, Need, Outcome, SceneOutcome};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::rational_to_decimal;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::theory::hopf::degenerate_inertial_parameter;
use slipmode_plot::figure::{
    Axis, Caption, Line, LineChart, LineRole, PointMark, Reference, RegionLabel, Series, Side, Zone, ZoneMap,
};

const NEEDS: &[Need] = &[Need::NearTransition];

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker::new("criticality", &[], &["hopf-coefficient"], criticality),
    FigureMaker::new("bistability-strip", NEEDS, &["bistability-edge", "bistability-certified"], |outcome| {
        strip(outcome.potentially_unstable()?)
    }),
    FigureMaker::new("cycle-amplitudes", NEEDS, &["cycle-families", "near-transition-runs"], |outcome| {
        amplitudes(outcome.potentially_unstable()?.near_transition.as_ref()?)
    }),
];

/// Vertices of a curve.
const VERTICES: u32 = 80;

const CRITICALITY: &str = "Plane of the inertial parameter eta and of b/a minus 1, both logarithmic. A curve divides it; the curve starts upright at eta = 1/7 and bends to smaller eta as b/a grows. Left of it the aging law is subcritical, right of it both laws are supercritical.";
const CRITICALITY_CAPTION: &str = "Sign of the first Lyapunov coefficient on $K = K_c$ (exact). Where it is negative, the bifurcation is supercritical. Where it is positive, it is subcritical, with a range of bistability. The coefficient of the slip law is negative everywhere.";

fn criticality(outcome: &Outcome) -> Option<Figure> {
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
        caption: Caption::new("criticality", "Sign of the first Lyapunov coefficient", CRITICALITY),
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
        labels: Vec::new(),
        x: x.clone(),
        y: y.clone(),
    };
    Some(Figure::own(&map.caption, CRITICALITY_CAPTION, map.svg()))
}

const STRIP: &str = "Relative distance from the critical stiffness against eta, both logarithmic. Below a curve that rises to about 0.006 near eta = 0.025 and then falls steeply to zero at eta = 0.138 lies the strip in which a limit cycle and steady sliding are both stable.";

fn edges(near: &NearTransitionOutcome) -> Vec<(f64, &Edge)> {
    let edge = |family: &'_ CycleFamilyOutcome| nearest_f64(&family.inertial_parameter);
    let families = near.families.iter().filter(|family| family.law == EvolutionLaw::Aging);
    families.filter_map(|family| Some((edge(family), family.edge.as_ref().ok()?.as_ref()?))).collect()
}

const STRIP_CAPTION: &str = "Values of $K > K_c$ at which a stable limit cycle exists: aging law, $\\beta$ of the simulations. Points: folds of the families of cycles (converged), joined by straight lines. With the slip law no cycle was found at any $K > K_c$.";

fn strip(scene: &SceneOutcome) -> Option<Figure> {
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
        caption: Caption::new("bistability-strip", "Strip of bistability of the aging law", STRIP),
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
        x,
        y,
    };
    Some(Figure::own(&map.caption, STRIP_CAPTION, map.svg()))
}

const AMPLITUDES: &str = "Peak velocity of cycles against K/K_c minus 1 at one small eta. With the slip law a stable branch rises from zero towards smaller stiffness. With the aging law an unstable branch rises from zero towards larger stiffness, turns at the fold, and continues as the stable branch to smaller stiffness. Thin parabolas of the theory touch both at zero.";

/// The family of the law at the smallest η of the runs at which the aging law has an edge.
fn family<'c>(
    near: &'c NearTransitionOutcome,
    law: EvolutionLaw,
    inertial: &Rational,
) -> Option<&'c CycleFamilyOutcome> {
    near.families.iter().find(|family| family.law == law && family.inertial_parameter == *inertial)
}

fn amplitudes(near: &NearTransitionOutcome) -> Option<Figure> {
    let has_edge = |inertial: &&Rational| {
        family(near, EvolutionLaw::Aging, inertial).is_some_and(|family| matches!(family.edge, Ok(Some(_))))
    };
    let inertial = near.runs.iter().map(|run| &run.inertial_parameter).filter(has_edge).min()?;
    let aging = family(near, EvolutionLaw::Aging, inertial)?;
    let slip = family(near, EvolutionLaw::Slip, inertial)?;
    let edge = aging.edge.as_ref().ok()?.as_ref()?;
    let fold = (edge.excess, edge.log_peak);
    let unstable = |cycle: &&FamilyCycle| cycle.log_peak < edge.log_peak;
    let place = |cycle: &FamilyCycle| (cycle.excess, cycle.log_peak);
    let lower: Vec<(f64, f64)> = aging.cycles.iter().filter(unstable).map(place).collect();
    let upper: Vec<(f64, f64)> = aging.cycles.iter().filter(|cycle| !unstable(cycle)).map(place).collect();
    let x = Axis::linear("*K*/*K*_c − 1", "", -0.01, 0.01);
    let highest = near_peak(&upper, x.min);
    let chart = LineChart {
        caption: Caption::new("cycle-amplitudes", "Amplitudes of cycles close to K = K_c", AMPLITUDES),
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
    Some(Figure::own(
        &chart.caption,
        &format!(
            "Cycles close to $K = K_c$ at $\\eta = {}$, stable and unstable, by Newton's method on the return map, and the limit cycles at which runs from $V_l/10$ end. Thin lines: amplitude $A \\propto \\sqrt{{|1 - K/K_c|}}$ predicted by the first Lyapunov coefficient.",
            rational_to_decimal(inertial, 6)
        ),
        chart.svg(),
    ))
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
