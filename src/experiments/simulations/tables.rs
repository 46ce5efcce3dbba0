//! Tables of the simulations: the grid, the disagreements with the theory, and the least peaks.

use std::f64::consts::{SQRT_2, TAU};

use crate::experiments::shared::cells::Rounded;
use crate::experiments::simulations::deep_stick_slip::LawOfLeast;
use crate::experiments::simulations::{LeastPeak, SIDE_WIDTH, SimulatedPoint};
use crate::experiments::{Context, Need, Rows, SceneOutcome, TableMaker, table_of};
use slipmode_certified::Certificate;
use slipmode_core::dynamics::{Behaviour, Estimate, Simulation};
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::{Side, rounded};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::SlipMode;
use slipmode_core::stability::asymptote::inertial_upper_velocity_m_per_s;
use slipmode_plot::table::{Cell, Table};

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "simulations", needs: &[Need::Simulations, Need::Certificates], make: simulations },
    TableMaker { id: "simulation-disagreements", needs: &[Need::Simulations], make: disagreements },
    TableMaker { id: "least-peaks", needs: &[Need::Simulations], make: least_peaks },
];

/// Digits of peak and period: one fewer than the tolerance of 1e-8 allows, so that no rounding shows.
const DIGITS: usize = 7;

/// A point of a grid with its scene, its law, its run, where that has a result, and what is proved of it.
#[derive(Clone, Copy)]
pub(super) struct GridPoint<'c> {
    pub scene: &'c SceneOutcome,
    pub law: EvolutionLaw,
    pub velocity: f64,
    pub stress: f64,
    pub point: &'c SimulatedPoint,
    pub run: Option<&'c Simulation>,
    proof: Option<&'c Certificate>,
}

pub(super) fn points<'c>(context: &'c Context) -> impl Iterator<Item = GridPoint<'c>> {
    let of_scene = |scene: &'c SceneOutcome| {
        let grids = scene.simulations.iter().flat_map(|found| &found.grids);
        grids.flat_map(move |&(law, ref grid)| {
            grid.points().map(move |(velocity, stress, point)| GridPoint {
                scene,
                law,
                velocity,
                stress,
                point,
                run: point.simulation.as_ref().ok(),
                proof: scene.certificates.as_ref().and_then(|all| all.at(law, velocity, stress)),
            })
        })
    };
    context.outcome.scenes.iter().flat_map(of_scene)
}

/// What stands where no limit cycle is.
const NO_CYCLE: &str = "none";

/// More than the error of a period over √2 natural ones, in 64 bits.
const ROUNDING: f64 = 1e-14;

impl GridPoint<'_> {
    pub fn scene(&self) -> &str {
        &self.scene.scene.name
    }

    /// K over the critical stiffness without inertia; below 1 steady sliding is unstable at every velocity.
    fn stiffness_over_quasi_static(&self) -> Option<f64> {
        let slider = self.scene.slider().filter(|slider| slider.has_transition())?;
        Some(nearest_f64(&slider.critical_normal_stress_pa()) / self.stress)
    }

    /// √(K/M), 1/s.
    fn natural_per_s(&self) -> Option<f64> {
        Some(self.scene.slider()?.map(nearest_f64).natural_angular_frequency_per_s())
    }

    /// The largest imaginary part of a root in ω_n.
    fn max_imaginary_over_natural(&self) -> Option<f64> {
        let largest = &self.point.theory.max_imaginary_per_s;
        let largest = if largest.is_zero() { 0.0 } else { largest.to_f64()? };
        Some(largest / self.natural_per_s()?)
    }

    /// V_l over the velocity of eq 18.
    fn velocity_over_eq18(&self) -> Option<f64> {
        let slider = self.scene.slider().filter(|slider| slider.has_transition())?.map(nearest_f64);
        Some(self.velocity / inertial_upper_velocity_m_per_s(&slider, &self.stress))
    }

    /// ω/ω_n − 1 of the run.
    fn frequency_excess(&self) -> Option<f64> {
        Some(TAU / (self.run?.period_s? * self.natural_per_s()?) - 1.0)
    }

    fn distortion(&self) -> Option<Estimate> {
        Some(self.point.course?.on_cycle?.distortion)
    }

    /// The slip mode of the limit cycle on which the run ends.
    fn cycle(&self) -> Option<&'static str> {
        let run = self.run?;
        Some(if run.behaviour == Behaviour::Periodic { run.slip_mode.as_str() } else { NO_CYCLE })
    }

    /// The slip mode of the limit cycle that is proved to be there: stick-slip has a period above √2 natural ones.
    fn cycle_proved(&self) -> Option<&'static str> {
        let Some([low, high]) = self.proof?.period_s() else { return Some(NO_CYCLE) };
        let limit = SQRT_2 * TAU / self.natural_per_s()?;
        let is_slow = low > limit * (1.0 + ROUNDING);
        let is_fast = high < limit * (1.0 - ROUNDING);
        let mode = if is_slow { SlipMode::StickSlip } else { SlipMode::HarmonicVibration };
        (is_slow || is_fast).then(|| mode.as_str())
    }
}

/// Digits of the ends of an enclosure.
const ENCLOSED_DIGITS: usize = 12;

/// Two columns with the ends of an enclosure of a column, rounded outward.
fn enclosed<'c>(
    table: Rows<GridPoint<'c>>,
    name: &str,
    ends: impl Fn(&Certificate) -> Option<[f64; 2]>,
) -> Rows<GridPoint<'c>> {
    let columns = [("low", Side::Below), ("high", Side::Above)].into_iter().enumerate();
    columns.fold(table, |table, (which, (end, side))| {
        table.number(&format!("{name}_{end}"), |at| {
            let bound = at.proof.and_then(&ends)?[which];
            Some(Cell::number(rounded(bound, ENCLOSED_DIGITS, side)).certain())
        })
    })
}

fn simulations(context: &Context) -> Option<Table> {
    let table = table_of("simulations", points(context))
        .text("scene", |at: GridPoint| at.scene().to_owned())
        .text("slider", |at| at.scene.slider_words())
        .text("law", |at| at.law.as_str())
        .digits("normal_stress_pa", DIGITS, |at| Rounded(at.stress))
        .digits("loading_velocity_m_per_s", DIGITS, |at| Rounded(at.velocity))
        .named()
        .digits("stiffness_over_critical", DIGITS, |at| at.point.stiffness_over_critical.map(Rounded))
        .text("slip_mode_theory", |at| at.point.theory.slip_mode.as_str())
        .text("slip_mode_simulation", |at| at.run.map(|run| run.slip_mode.as_str()))
        .text("behaviour", |at| at.run.map(|run| run.behaviour.as_str()))
        .digits("peak_velocity_m_per_s", DIGITS, |at| Some(at.run?.peak_velocity_m_per_s))
        .digits("period_s", DIGITS, |at| at.run?.period_s)
        .digits("stress_drop_pa", DIGITS, |at| Some(at.run?.stress_drop_pa))
        .digits("peak_relative_error", 2, |at| Some(at.run?.peak_relative_error))
        .digits("period_relative_error", 2, |at| at.run?.period_relative_error)
        .text("failure", |at| at.point.simulation.as_ref().err().map(ToString::to_string))
        .digits("stress_drop_relative_error", 2, |at| {
            Some(at.run?.stress_drop_relative_error).filter(|error| error.is_finite())
        })
        .digits("max_imaginary_over_natural", DIGITS, |at| at.max_imaginary_over_natural().map(Rounded))
        .digits("stiffness_over_quasi_static", DIGITS, |at| at.stiffness_over_quasi_static().map(Rounded))
        .digits("velocity_over_eq18", DIGITS, |at| at.velocity_over_eq18().map(Rounded))
        .digits("frequency_excess", 5, |at| at.frequency_excess())
        .digits("harmonic_distortion", 5, |at| Some(at.distortion()?.value))
        .digits("harmonic_error", 2, |at| Some(at.distortion()?.error))
        .text("cycle", |at| at.cycle())
        .text("cycle_proved", |at| at.cycle_proved());
    let table = enclosed(table, "peak_velocity_m_per_s", |proof| Some(proof.peak_velocity_m_per_s));
    let table = enclosed(table, "period_s", Certificate::period_s);
    let is_cycle = |proof: &Certificate| proof.period_s().map(|_| proof.stress_drop_pa);
    enclosed(table, "stress_drop_pa", is_cycle).table()
}

fn disagreements(context: &Context) -> Option<Table> {
    let disagreeing = points(context).filter(|at| !at.point.agrees());
    table_of("simulation-disagreements", disagreeing)
        .text("scene", |at: GridPoint| at.scene().to_owned())
        .text("law", |at| at.law.as_str())
        .digits("normal_stress_pa", 4, |at| at.stress)
        .digits("loading_velocity_m_per_s", 4, |at| at.velocity)
        .text("slip_mode_theory", |at| at.point.theory.slip_mode.as_str())
        .text("slip_mode_simulation", |at| at.run.map(|run| run.slip_mode.as_str()))
        .digits("max_imaginary_per_s", 5, |at| at.point.theory.max_imaginary_per_s.to_f64())
        .digits("angular_frequency_per_s", 5, |at| Some(TAU * at.run?.frequency_hz?))
        .table()
}

fn least_peaks(context: &Context) -> Option<Table> {
    let found = context.outcome.scenes.iter().flat_map(|scene| {
        let peaks = scene.simulations.iter().flat_map(|found| &found.least_peaks);
        peaks.map(move |least| (scene, least))
    });
    let equations = context.equations.in_symbols();
    let of_law = |scene, least| (least, LawOfLeast::new(&equations, scene, least));
    let least_peaks: Vec<_> = found.map(|(scene, least)| of_law(scene, least)).collect();
    table_of("least-peaks", &least_peaks)
        .text("law", |(least, _): &(&LeastPeak, Option<LawOfLeast>)| least.law.as_str())
        .digits("normal_stress_pa", 4, |(least, _)| least.normal_stress_pa)
        .named()
        .digits("eq18_velocity_m_per_s", 4, |(least, _)| least.eq18_velocity_m_per_s)
        .digits("offset_dex", 6, |(least, _)| least.offset_dex)
        .digits("offset_error_dex", 1, |(least, _)| least.offset_error_dex)
        .digits("peak_at_eq18_over_least", 5, |(least, _)| least.peak_at_eq18_over_least)
        .digits("curvature_per_dex2", 3, |(least, _)| least.curvature_per_dex2)
        .digits("one_percent_from_dex", 3, |(least, _)| least.flat[0][0])
        .digits("one_percent_to_dex", 3, |(least, _)| least.flat[0][1])
        .digits("five_percent_from_dex", 3, |(least, _)| least.flat[1][0])
        .digits("five_percent_to_dex", 3, |(least, _)| least.flat[1][1])
        .digits("cycle_mode_change_dex", 6, |(least, _)| least.cycle_mode_change_dex)
        .digits("cycle_mode_change_error_dex", 1, |_| SIDE_WIDTH)
        .digits("period_change_width_dex", 6, |(least, _)| {
            let [slow, fast] = least.period_change_dex;
            Some(fast? - slow?)
        })
        .digits("theory_mode_change_dex", 3, |(least, _)| least.theory_mode_change_dex)
        .digits("stiffness_over_quasi_static", 5, |(_, law)| Some(Rounded(law.as_ref()?.softness)))
        .digits("law_offset_dex", 6, |(_, law)| Some(law.as_ref()?.offset_dex))
        .digits("law_offset_error_dex", 1, |(least, _)| least.offset_error_dex)
        .table()
}
