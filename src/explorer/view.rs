//! The explorer of one's own slider: curves, formulas and points for every stored combination of b, K and M, as words.

use crate::scene::cited;
use serde::Serialize;

use crate::experiments::shared::axes::{asymptote_lines, boundary_lines, plane, transition_line};
use crate::experiments::shared::bands::band_lines;
use crate::explorer::formulas::{self, FORMULAS, FormulaRow, formula_values};
use crate::explorer::tables::one_at_a_time;
use crate::explorer::{DIGITS, Factors, Families, NamedPoint, PointState, Varying};
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_plot::figure::{Axis, Caption, FamilyMap, Line, LineRole, PointMark, Side};
use slipmode_plot::table::Table;

/// Everything that the explorer's page shows.
#[derive(Debug, Clone)]
pub struct Explorer {
    /// The map with the slider's own curves shown.
    pub svg: String,
    /// b, K and M.
    pub controls: Vec<Control>,
    /// What the formulas say.
    pub formulas: Vec<FormulaRow>,
    /// What is known of the points.
    pub points: Vec<PointRow>,
    /// The same as tables, one parameter changed at a time.
    pub tables: Vec<Table>,
    /// How many combinations are stored.
    pub combinations: usize,
}

/// A parameter that varies.
#[derive(Debug, Clone, Serialize)]
pub struct Control {
    /// `b`, `K` or `M`.
    pub id: &'static str,
    /// What it is.
    pub name: &'static str,
    /// The slider's values as words, ascending, with `|` between them.
    pub steps: String,
    /// The place of the last of them.
    pub last: usize,
    /// The place of the slider's own value.
    pub base: usize,
    /// Its words.
    pub text: String,
}

/// What is known of a point.
#[derive(Debug, Clone, Serialize)]
pub struct PointRow {
    /// Its name.
    pub name: String,
    /// σ in Pa.
    pub stress: String,
    /// V0 in m/s.
    pub velocity: String,
    /// Slip mode, largest Im(s) in 1/s, and frequency in Hz.
    pub fields: [Varying; 3],
}

/// The part of the plane that is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Loading velocities, m/s.
    pub velocity: (f64, f64),
    /// Normal stresses, Pa.
    pub stress: (f64, f64),
}

/// Decades by which curves move at most: σ by two with K, V by one with K and one with M.
const MARGIN: i32 = 2;

/// Columns and rows of the cells in which the bands of each b are decided: larger cells than on a map of one slider.
const CELLS: [usize; 2] = [256, 256];

const TITLE: &str = "Boundary, transition and asymptotes of the chosen slider";
const DESCRIPTION: &str = "Map over loading velocity and normal stress: the exact boundary max Im(s) = 0 with its upper and its lower arc, the asymptotes of {quasi-static-upper, quasi-static-lower, inertial-upper, inertial-lower} within their ranges, the transition K = K_c where b is greater than a, and the scene's points.";

/// The explorer of a slider's families.
#[must_use]
pub fn explorer(families: &Families, window: Window) -> Explorer {
    let base = families.place([0, 1, 2].map(|at| families.factors[at].base));
    let varying = |texts: Vec<String>| Varying::of(&texts, base);
    let sliders = families.sliders();
    let values: Vec<[String; FORMULAS]> = sliders.iter().map(formula_values).collect();
    let value = |at: usize| varying(values.iter().map(|texts| texts[at].clone()).collect());
    let points = families.points.iter().zip(&families.states);
    Explorer {
        svg: map(families, window).svg(),
        controls: controls(families),
        formulas: formulas::rows(value),
        points: points.map(|(point, states)| point_row(point, states, varying)).collect(),
        tables: one_at_a_time(families, &values),
        combinations: sliders.len(),
    }
}

fn point_row(
    point: &NamedPoint,
    states: &[PointState],
    varying: impl Fn(Vec<String>) -> Varying,
) -> PointRow {
    let of = |text: fn(&PointState) -> String| varying(states.iter().map(text).collect());
    PointRow {
        name: point.name.clone(),
        stress: rational_to_decimal(&point.place.normal_stress_pa, DIGITS),
        velocity: rational_to_decimal(&point.place.loading_velocity_m_per_s, DIGITS),
        fields: [
            of(PointState::mode),
            of(|state| round_digits(state.imaginary(), DIGITS)),
            of(|state| round_digits(state.imaginary() / std::f64::consts::TAU, DIGITS)),
        ],
    }
}

fn controls(families: &Families) -> Vec<Control> {
    let own = &families.parameters;
    let [effects, stiffnesses, masses] = &families.factors;
    let step = |factors: &Factors, value: &Rational, unit: &str| -> Vec<String> {
        let texts = factors.texts.iter().zip(&factors.values);
        texts
            .map(|(factor, times)| {
                format!("{}{unit} (× {factor})", rational_to_decimal(&(value.clone() * times), DIGITS))
            })
            .collect()
    };
    let beta = |times: &Rational| {
        rational_to_decimal(&(own.evolution_effect.clone() * times / &own.direct_effect), DIGITS)
    };
    let effect_steps = step(effects, &own.evolution_effect, "").into_iter().zip(&effects.values);
    let effect_steps = effect_steps.map(|(text, times)| format!("{text}, β = b/a = {}", beta(times)));
    let control = |id, name, steps: Vec<String>, &Factors { base, .. }: &Factors| {
        let text = steps.get(base).cloned().unwrap_or_default();
        Control { id, name, steps: steps.join("|"), last: steps.len().saturating_sub(1), base, text }
    };
    let stiffness_steps = step(stiffnesses, &own.stiffness_pa_per_m, " Pa/m");
    let mass_steps = step(masses, &own.mass_per_area_kg_per_m2, " kg/m²");
    vec![
        control("b", "Evolution effect b", effect_steps.collect(), effects),
        control("K", "Stiffness K", stiffness_steps, stiffnesses),
        control("M", "Mass per area M", mass_steps, masses),
    ]
}

fn map(families: &Families, window: Window) -> FamilyMap {
    let (x, y) = plane(window.velocity, window.stress);
    let far = libm::exp10(f64::from(MARGIN));
    let wide = |axis: &Axis| Axis { min: axis.min / far, max: axis.max * far, ..axis.clone() };
    let (wide_x, wide_y) = (wide(&x), wide(&y));
    let effects = families.effects();
    let regions = families.uncertain_effects();
    let members = effects.iter().zip(&families.boundaries).enumerate().map(|(index, (slider, points))| {
        let mut lines =
            regions.get(index).map_or_else(Vec::new, |region| band_lines(region, &wide_x, &wide_y, CELLS));
        lines.extend(extended_boundary(points, &wide_x));
        lines.extend(asymptote_lines(slider, &wide_x, &wide_y));
        lines.extend(transition_line(slider, &wide_x, &wide_y));
        lines
    });
    let [_, stiffnesses, masses] = &families.factors;
    let decades = |factor: &Rational| libm::log10(nearest_f64(factor));
    FamilyMap {
        caption: Caption::new("explorer-map", TITLE, &cited(DESCRIPTION)),
        members: members.collect(),
        base: families.factors[0].base,
        moves: vec![
            stiffnesses.values.iter().map(|factor| (decades(factor) / 2.0, decades(factor))).collect(),
            masses.values.iter().map(|factor| (-decades(factor) / 2.0, 0.0)).collect(),
        ],
        margin: MARGIN,
        marks: marks(&families.points, &x),
        x,
        y,
    }
}

/// A mark for each place, with the names of all points there.
fn marks(points: &[NamedPoint], x: &Axis) -> Vec<PointMark> {
    let is_first = |at: usize| points[..at].iter().all(|other| other.place != points[at].place);
    let here = |at: usize| points.iter().filter(move |other| other.place == points[at].place);
    let names = |at: usize| here(at).map(|point| point.name.as_str()).collect::<Vec<_>>().join(", ");
    (0..points.len()).filter(|&at| is_first(at)).map(|at| mark(&names(at), &points[at], x)).collect()
}

fn mark(name: &str, point: &NamedPoint, x: &Axis) -> PointMark {
    let velocity = nearest_f64(&point.place.loading_velocity_m_per_s);
    // Above, where a neighbour at the same normal stress is not in its way; at the edge there is no room for half of it.
    let at_the_edge = x.position(velocity).is_some_and(|at| at > 0.95);
    PointMark::new(
        format!("**{name}**"),
        (velocity, nearest_f64(&point.place.normal_stress_pa)),
        if at_the_edge { Side::Left } else { Side::Above },
    )
}

/// The arcs, carried on along their asymptotes, from which their ends differ by less than a billionth.
fn extended_boundary(points: &[BoundaryPoint], x: &Axis) -> Vec<Line> {
    let mut lines = boundary_lines(points);
    for line in lines.iter_mut().filter(|line| line.role == LineRole::Boundary) {
        let (Some(&slow), Some(&fast)) = (line.points.first(), line.points.last()) else { continue };
        let factor = if fast.1 > slow.1 { FAR } else { 1.0 / FAR };
        line.points.insert(0, (slow.0.min(x.min), slow.1));
        line.points.push((fast.0 * factor, fast.1 * factor));
    }
    lines
}

/// Farther than any window reaches.
const FAR: f64 = 1e30;
