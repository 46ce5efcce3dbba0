//! Cycles of deep stick-slip beside the law of their peak: each, from one load velocity to the next, and as a measurement of 2 V_18.

use super::{LeastPeak, SimulatedPoint};
use crate::experiments::shared::cells::Rounded;
use crate::experiments::{Context, Need, SceneOutcome, TableMaker, table_of};
use crate::fitting::{EFFECT_RATIOS, LEAST_ROWS, PeakGiven, PeakRow, fit_peaks};
use slipmode_core::dynamics::{
    Behaviour, DEEP, DeepCycle, PeakLaw, Simulation, drop_over_impedance, least_loading,
};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_plot::table::Table;
use slipmode_theory::{Equations, Role, emergence};

const NEEDS: &[Need] = &[Need::Simulations];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "deep-stick-slip", needs: NEEDS, make: cycles },
    TableMaker { id: "deep-stick-slip-steps", needs: NEEDS, make: steps },
    TableMaker { id: "peak-fits", needs: NEEDS, make: fits },
];

/// Digits of values that runs have.
const DIGITS: usize = 7;

/// Precision of the velocity of the asymptote, in bits.
const BITS: u32 = 128;

/// A cycle of deep stick-slip.
#[derive(Clone, Copy)]
struct Deep<'c> {
    law: PeakLaw,
    run: &'c Simulation,
    load_m_per_s: f64,
    twice_eq18_m_per_s: f64,
    cycle: DeepCycle,
}

/// The cycles of one evolution law at one normal stress, by the loading velocity.
struct Row<'c> {
    scene: &'c str,
    law: EvolutionLaw,
    stress_pa: f64,
    /// K/K_c without inertia.
    softness: f64,
    slider: Slider<f64>,
    cycles: Vec<Deep<'c>>,
}

/// κ = K D_c/(aσ) and K/K_c without inertia.
fn softness(slider: &Slider<f64>, stress_pa: f64) -> [f64; 2] {
    let stiffness_group = slider.stiffness_stress_pa() / (slider.direct_effect * stress_pa);
    [stiffness_group, stiffness_group / (slider.effect_ratio() - 1.0)]
}

/// Twice the velocity of the asymptote as the report states it, m/s; its equations are in the symbols of procedures.
fn twice_eq18(equations: &Equations, slider: &Slider<Rational>, stress_pa: f64) -> Option<f64> {
    let stress = Rational::from_f64(stress_pa)?;
    let velocity = emergence::velocity_of(equations, Role::InertialUpper, slider, &stress, BITS)?;
    Some(2.0 * velocity.to_f64())
}

/// Where the lowest peak lies beside its law.
pub(super) struct LawOfLeast {
    /// K/K_c without inertia.
    pub softness: f64,
    /// log10 of the velocity over that of the law.
    pub offset_dex: f64,
}

impl LawOfLeast {
    pub fn new(equations: &Equations, scene: &SceneOutcome, least: &LeastPeak) -> Option<Self> {
        let exact = scene.slider()?;
        let slider = exact.map(nearest_f64);
        let scale = twice_eq18(equations, exact, least.normal_stress_pa)?;
        let by_law = scale * least_loading(least.law, slider.effect_ratio(), least.least_m_per_s / scale);
        let offset_dex = libm::log10(least.eq18_velocity_m_per_s / by_law) + least.offset_dex;
        Some(Self { softness: softness(&slider, least.normal_stress_pa)[1], offset_dex })
    }
}

fn rows<'c>(context: &Context<'c>) -> Vec<Row<'c>> {
    let equations = context.equations.in_symbols();
    context.outcome.scenes.iter().flat_map(|scene| of_scene(&equations, scene)).collect()
}

fn of_scene<'c>(equations: &Equations, scene: &'c SceneOutcome) -> Vec<Row<'c>> {
    let Some(exact) = scene.slider().filter(|slider| slider.has_transition()) else { return Vec::new() };
    let slider = exact.map(nearest_f64);
    let mut found = Vec::new();
    for (law, grid) in scene.simulations.iter().flat_map(|found| &found.grids) {
        let peak_law = PeakLaw::new(*law, slider.effect_ratio());
        let points: Vec<(f64, f64, &SimulatedPoint)> = grid.points().collect();
        for points in points.chunk_by(|one, other| one.1 == other.1) {
            let stress_pa = points[0].1;
            let [stiffness_group, softness] = softness(&slider, stress_pa);
            let Some(scale) = twice_eq18(equations, exact, stress_pa).filter(|_| softness <= DEEP) else {
                continue;
            };
            let cycle = |&(load_m_per_s, _, point): &(f64, f64, &'c SimulatedPoint)| {
                let run = point.simulation.as_ref().ok()?;
                let peak = run.peak_velocity_m_per_s;
                let cycle = DeepCycle { peak: peak / scale, loading: load_m_per_s / peak, stiffness_group };
                let is_deep = run.behaviour == Behaviour::Periodic && load_m_per_s <= 0.5 * DEEP * scale;
                is_deep.then_some(Deep { law: peak_law, run, load_m_per_s, twice_eq18_m_per_s: scale, cycle })
            };
            let cycles = points.iter().filter_map(cycle).collect();
            let (law, slider) = (*law, slider.clone());
            found.push(Row { scene: &scene.scene.name, law, stress_pa, softness, slider, cycles });
        }
    }
    found
}

impl Deep<'_> {
    /// What the error of the peak changes of a value of the cycle.
    fn change(&self, value: impl Fn(&DeepCycle) -> f64) -> f64 {
        let (cycle, factor) = (self.cycle, 1.0 + self.run.peak_relative_error);
        let moved = DeepCycle { peak: cycle.peak * factor, loading: cycle.loading / factor, ..cycle };
        (value(&moved) - value(&cycle)).abs()
    }
}

fn cycles(context: &Context) -> Option<Table> {
    let rows = rows(context);
    let each = rows.iter().flat_map(|row| row.cycles.iter().map(move |deep| (row, deep)));
    table_of("deep-stick-slip", each)
        .text("scene", |(row, _): (&Row, &Deep)| row.scene.to_owned())
        .text("law", |(row, _)| row.law.as_str())
        .digits("normal_stress_pa", DIGITS, |(row, _)| Rounded(row.stress_pa))
        .digits("loading_velocity_m_per_s", DIGITS, |(_, deep)| Rounded(deep.load_m_per_s))
        .named()
        .digits("stiffness_over_quasi_static", 5, |(row, _)| Rounded(row.softness))
        .digits("peak_over_twice_eq18", DIGITS, |(_, deep)| deep.cycle.peak)
        .digits("peak_relative_error", 2, |(_, deep)| deep.run.peak_relative_error)
        .digits("stress_drop_over_impedance", DIGITS, |(row, deep)| {
            let impedance = (row.slider.stiffness_pa_per_m * row.slider.mass_per_area_kg_per_m2).sqrt();
            deep.run.stress_drop_pa / (2.0 * impedance * deep.run.peak_velocity_m_per_s)
        })
        .digits("stress_drop_relative_error", 2, |(_, deep)| {
            deep.run.stress_drop_relative_error + deep.run.peak_relative_error
        })
        .digits("drop_by_law", DIGITS, |(_, deep)| drop_over_impedance(&deep.cycle))
        .digits("drop_error", 2, |(_, deep)| deep.change(drop_over_impedance))
        .digits("excess_of_law", 5, |(_, deep)| deep.law.remainder(&deep.cycle))
        .digits("excess_error", 2, |(_, deep)| {
            deep.change(|cycle| deep.law.remainder(cycle)) + deep.law.constant()[1]
        })
        .digits("loss_of_spring", 5, |(_, deep)| deep.law.weakening(&deep.cycle))
        .digits("loss_error", 2, |(_, deep)| deep.change(|cycle| deep.law.weakening(cycle)))
        .table()
}

fn steps(context: &Context) -> Option<Table> {
    let rows = rows(context);
    let pairs = rows.iter().flat_map(|row| row.cycles.windows(2).map(move |pair| (row, &pair[0], &pair[1])));
    let middle = |one: f64, other: f64| (one * other).sqrt();
    let peak = move |one: &Deep, other: &Deep| middle(one.cycle.peak, other.cycle.peak);
    let per_log =
        |change: f64, one: &Deep, other: &Deep| change / libm::log(other.load_m_per_s / one.load_m_per_s);
    table_of("deep-stick-slip-steps", pairs)
        .text("scene", |(row, _, _): (&Row, &Deep, &Deep)| row.scene.to_owned())
        .text("law", |(row, _, _)| row.law.as_str())
        .digits("normal_stress_pa", DIGITS, |(row, _, _)| Rounded(row.stress_pa))
        .digits("from_velocity_m_per_s", DIGITS, |(_, one, _)| Rounded(one.load_m_per_s))
        .digits("to_velocity_m_per_s", DIGITS, |(_, _, other)| Rounded(other.load_m_per_s))
        .named()
        .digits("slope_measured", DIGITS, |(_, one, other)| {
            per_log(one.cycle.peak - other.cycle.peak, one, other)
        })
        .digits("slope_by_law", DIGITS, |(_, one, other)| one.law.slope(peak(one, other)))
        .digits("slope_left_out", 5, |(row, one, other)| {
            let load = middle(one.load_m_per_s, other.load_m_per_s) / one.twice_eq18_m_per_s;
            load + row.softness + 1.0 / (peak(one, other) * peak(one, other))
        })
        .digits("slope_error", 2, |(_, one, other)| {
            let error = |deep: &Deep| deep.cycle.peak * deep.run.peak_relative_error;
            per_log(error(one) + error(other), one, other)
        })
        .table()
}

/// What the fit of one row of cycles gives, over 2 V_18; empty where there is no fit.
#[derive(Clone)]
struct Fitted {
    known: Option<f64>,
    other_law: Option<f64>,
    unknown_ratio: Option<[f64; 2]>,
    error: Option<f64>,
    left_out: f64,
}

impl Row<'_> {
    fn fitted(&self) -> Option<Fitted> {
        let given = |law, effect_ratio| PeakGiven { laws: vec![law], effect_ratio, ..PeakGiven::default() };
        let scale = self.cycles.first()?.twice_eq18_m_per_s;
        let fit = |law, ratio: [f64; 2], factor: f64| {
            let row = |deep: &Deep| PeakRow {
                load_m_per_s: deep.load_m_per_s,
                peak_m_per_s: factor * deep.run.peak_velocity_m_per_s,
                relative_error: 1.0,
                stress: 1.0,
            };
            fit_peaks(&self.cycles.iter().map(row).collect::<Vec<_>>(), &given(law, ratio)).ok()?.laws.pop()
        };
        let ratio = [self.slider.effect_ratio(); 2];
        let of = |law, factor| fit(law, ratio, factor).map(|fit| fit.central.scale_m_per_s / scale);
        let other = EvolutionLaw::ALL.into_iter().find(|other| *other != self.law)?;
        let largest = |value: fn(&Deep) -> f64| self.cycles.iter().map(value).fold(0.0, f64::max);
        let load = largest(|deep| deep.load_m_per_s) / scale;
        let inverse_peak = largest(|deep| 1.0 / deep.cycle.peak);
        let known = of(self.law, 1.0);
        let moved = of(self.law, 1.0 + largest(|deep| deep.run.peak_relative_error));
        Some(Fitted {
            known,
            other_law: of(other, 1.0),
            unknown_ratio: fit(self.law, EFFECT_RATIOS, 1.0)
                .map(|fit| fit.over_effect_ratio.map(|end| end / scale)),
            error: known.zip(moved).map(|(known, moved)| (moved - known).abs()),
            left_out: load + self.softness + inverse_peak * inverse_peak,
        })
    }
}

fn fits(context: &Context) -> Option<Table> {
    // Fits take seconds, and several claims read them.
    let fitted = context.once("fits of peaks".into(), || {
        let mut rows = rows(context);
        rows.retain(|row| row.cycles.len() >= LEAST_ROWS);
        let of = |row: &Row| Some((row.scene.to_owned(), row.law, row.stress_pa, row.fitted()?));
        rows.iter().filter_map(of).collect::<Vec<_>>()
    });
    table_of("peak-fits", &fitted)
        .fill("least-rows", &LEAST_ROWS.to_string())
        .fill("low", &EFFECT_RATIOS[0].to_string())
        .fill("high", &EFFECT_RATIOS[1].to_string())
        .text("scene", |(scene, ..): &(String, EvolutionLaw, f64, Fitted)| scene.clone())
        .text("law", |(_, law, ..)| law.as_str())
        .digits("normal_stress_pa", DIGITS, |(_, _, stress, _)| Rounded(*stress))
        .named()
        .digits("fit_over_eq18", DIGITS, |(.., fitted)| fitted.known)
        .digits("fit_other_law", DIGITS, |(.., fitted)| fitted.other_law)
        .digits("fit_unknown_low", DIGITS, |(.., fitted)| fitted.unknown_ratio.map(|ends| ends[0]))
        .digits("fit_unknown_high", DIGITS, |(.., fitted)| fitted.unknown_ratio.map(|ends| ends[1]))
        .digits("fit_left_out", 5, |(.., fitted)| fitted.left_out)
        .digits("fit_error", 2, |(.., fitted)| fitted.error)
        .table()
}
