//! Tables of what happens close to K = K_c: the coefficient, the runs, the cycles and the edge of bistability.

use crate::experiments::near_transition::bistability::DIGITS;
use crate::experiments::near_transition::{CycleFamilyOutcome, NearRun, NearTransitionOutcome, SmallestKick};
use crate::experiments::{Context, Need, TableMaker, table_of};
use slipmode_core::dynamics::Outcome;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_plot::table::Table;
use slipmode_theory::hopf::degenerate_inertial_parameter;

const NEEDS: &[Need] = &[Need::NearTransition];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "hopf-coefficient", needs: &[], make: coefficients },
    TableMaker { id: "near-transition-runs", needs: NEEDS, make: runs },
    TableMaker { id: "cycle-families", needs: NEEDS, make: families },
    TableMaker { id: "cycle-agreement", needs: NEEDS, make: agreement },
    TableMaker { id: "bistability-edge", needs: NEEDS, make: edges },
    TableMaker { id: "bistability-certified", needs: NEEDS, make: coexisting },
    TableMaker { id: "smallest-kicks", needs: NEEDS, make: kicks },
];

fn found<'c>(context: &'c Context) -> impl Iterator<Item = &'c NearTransitionOutcome> {
    context.outcome.each(|scene| &scene.near_transition).map(|(_, found)| found)
}

fn families_of<'c>(context: &'c Context) -> impl Iterator<Item = &'c CycleFamilyOutcome> {
    found(context).flat_map(|found| &found.families)
}

fn coefficients(context: &Context) -> Option<Table> {
    let of = |law| Some((law, context.hopf_coefficient(law).ok()?));
    let hopf = EvolutionLaw::ALL.into_iter().map(of).collect::<Option<Vec<_>>>()?;
    table_of("hopf-coefficient", &hopf)
        .text("law", |(law, _)| format!("{} law", law.as_str()))
        .text("real_part", |(_, hopf)| hopf.real_part.to_string())
        .text("square_amplitude", |(_, hopf)| hopf.square_amplitude.to_string())
        .text("sign", |(_, hopf)| hopf.sign_statement)
        .table()
}

fn runs(context: &Context) -> Option<Table> {
    let ended = |run: &NearRun, on_cycle| run.periodic() == Some(on_cycle);
    table_of("near-transition-runs", found(context).flat_map(|outcome| &outcome.runs))
        .text("law", |run| run.law.as_str())
        .digits("inertial_parameter", 6, |run| &run.inertial_parameter)
        .digits("stiffness_over_critical", 6, |run| &run.stiffness_over_critical)
        .text("behaviour", |run| {
            run.outcome.as_ref().ok().map(|_| if ended(run, true) { "periodic" } else { "decaying" })
        })
        .digits("log_peak", 6, |run| {
            let found = run.outcome.as_ref().ok().filter(|_| ended(run, true));
            found.map(|found| found.log_peak())
        })
        .digits("log_peak_error", 2, |run| run.outcome.as_ref().ok().map(Outcome::peak_relative_error))
        .digits("log_peak_newton", 6, |run| run.newton_log_peak)
        .digits("amplitude", 6, |run| run.amplitude())
        .digits("amplitude_predicted", 6, |run| run.predicted_amplitude)
        .digits("growth_over_rate", 3, |run| run.growth())
        .digits("linear_growth_over_rate", 6, |run| run.linear_growth.filter(|_| ended(run, false)))
        .digits("laps_per_e_fold", 3, |run| run.returns_per_fold())
        .text("failure", |run| run.outcome.as_ref().err().map(ToString::to_string))
        .table()
}

fn families(context: &Context) -> Option<Table> {
    let cycles =
        families_of(context).flat_map(|family| family.cycles.iter().map(move |cycle| (family, cycle)));
    table_of("cycle-families", cycles)
        .text("law", |(family, _)| family.law.as_str())
        .digits("inertial_parameter", 6, |(family, _)| &family.inertial_parameter)
        .digits("stiffness_excess", 5, |(_, cycle)| cycle.excess)
        .digits("stiffness_excess_predicted", 5, |(_, cycle)| cycle.predicted_excess)
        .digits("amplitude", 6, |(_, cycle)| cycle.amplitude)
        .digits("log_peak", 6, |(_, cycle)| cycle.log_peak)
        .digits("multiplier", 6, |(_, cycle)| cycle.multiplier)
        .table()
}

fn agreement(context: &Context) -> Option<Table> {
    let rows: Vec<_> =
        families_of(context).filter_map(|family| Some((family, family.agreement()?))).collect();
    table_of("cycle-agreement", &rows)
        .text("law", |(family, _)| family.law.as_str())
        .digits("inertial_parameter", 6, |(family, _)| &family.inertial_parameter)
        .text("criticality", |(family, _)| family.criticality().as_str())
        .digits("amplitude", 3, |(_, found)| found.amplitude)
        .digits("deviation", 3, |(_, found)| found.deviation)
        .digits("order", 3, |(_, found)| found.order)
        .table()
}

fn edges(context: &Context) -> Option<Table> {
    let edges =
        families_of(context).filter_map(|family| Some((family, family.edge.as_ref().ok()?.as_ref()?)));
    table_of("bistability-edge", edges)
        .fill("orders", &orders(context).unwrap_or_default())
        .digits("inertial_parameter", 6, |(family, _)| &family.inertial_parameter)
        .digits("loading_velocity_m_per_s", 4, |(_, edge)| edge.loading_velocity_m_per_s)
        .digits("normal_stress_pa", 4, |(_, edge)| edge.normal_stress_pa)
        .digits("edge_excess", 5, |(_, edge)| edge.excess)
        .digits("edge_error", 1, |(_, edge)| edge.error)
        .digits("bracket_by_runs", 1, |(_, edge)| edge.bracket)
        .digits("edge_log_peak", 4, |(_, edge)| edge.log_peak)
        .digits("law_excess", 5, |(_, edge)| Some(edge.law?.excess[0]))
        .digits("law_error", 1, |(_, edge)| Some(edge.law?.excess[1]))
        .digits("peak_by_law", 4, |(_, edge)| Some(edge.law?.log_peak[0]))
        .digits("peak_error", 1, |(_, edge)| Some(edge.law?.log_peak[1]))
        .digits("width_dex", 3, |(_, edge)| edge.width_dex)
        .digits("half_way_excess", 5, |(_, edge)| Some(edge.threshold.as_ref()?.excess))
        .digits("unstable_log_peak", 5, |(_, edge)| Some(edge.threshold.as_ref()?.unstable_log_peak))
        .digits("threshold_start_velocity_ratio", 5, |(_, edge)| {
            Some(edge.threshold.as_ref()?.start_velocity_ratio)
        })
        .text("threshold_confirmed", |(_, edge)| edge.threshold.as_ref().and_then(|at| at.confirmed))
        .table()
}

fn coexisting(context: &Context) -> Option<Table> {
    let proved = families_of(context).filter_map(|family| {
        let at = family.edge.as_ref().ok()?.as_ref()?.threshold.as_ref()?;
        Some((family, at, at.coexistence.as_ref().ok()?))
    });
    let [low, high] = [-1.0, 1.0].map(|side| move |bound| outward(bound, side));
    table_of("bistability-certified", proved)
        .digits("inertial_parameter", 12, |(family, _, _)| &family.inertial_parameter)
        .digits("stiffness_group", DIGITS, |(_, at, _)| &at.stiffness_group)
        .digits("effect_ratio", 12, |(family, _, _)| &family.effect_ratio)
        .text("stable_log_peak_low", |(_, _, found)| low(found.attracting_log_peak[0]))
        .text("stable_log_peak_high", |(_, _, found)| high(found.attracting_log_peak[1]))
        .text("unstable_log_peak_low", |(_, _, found)| low(found.repelling_log_peak[0]))
        .text("unstable_log_peak_high", |(_, _, found)| high(found.repelling_log_peak[1]))
        .digits("unstable_y", 9, |(_, at, _)| at.crossing[0])
        .digits("unstable_zeta", 9, |(_, at, _)| at.crossing[1])
        .table()
}

fn kicks(context: &Context) -> Option<Table> {
    let rows = found(context).flat_map(|found| &found.kicks);
    let border = |row: &SmallestKick| row.border.as_ref().ok().cloned().flatten();
    let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
    let half_width = |[low, high]: [f64; 2]| 0.5 * (high - low).abs();
    table_of("smallest-kicks", rows)
        .text("law", |row| row.law.as_str())
        .digits("inertial_parameter", 6, |row| &row.inertial_parameter)
        .digits("stiffness_over_critical", 6, |row| &row.stiffness_over_critical)
        .text("kick", |row| row.kick.as_str())
        .named()
        .digits("fold_over_critical", 7, |row| row.fold_over_critical.map(|[fold, _]| fold))
        .digits("fold_error", 1, |row| row.fold_over_critical.map(|[_, error]| error))
        .text("ends_sliding", |row| row.border.as_ref().ok().map(Option::is_some))
        .digits("kick_change", 6, move |row| border(row).map(|at| middle(at.changes)))
        .digits("kick_error", 1, move |row| border(row).map(|at| half_width(at.changes)))
        .digits("largest_tried", 6, |row| row.kick.change(row.kick.largest()))
        .digits("border_log_peak", 8, move |row| border(row).map(|at| middle(at.log_peaks)))
        .digits("border_error", 1, move |row| border(row).map(|at| half_width(at.log_peaks)))
        .digits("unstable_log_peak", 8, |row| row.unstable_log_peak.map(|[_, peak, _]| peak))
        .text("unstable_log_peak_low", |row| row.unstable_log_peak.map(|[low, ..]| outward(low, -1.0)))
        .text("unstable_log_peak_high", |row| row.unstable_log_peak.map(|[.., high]| outward(high, 1.0)))
        .text("confirmed", move |row| border(row).and_then(|at| at.confirmed))
        .text("failure", |row| row.border.as_ref().err().map(ToString::to_string))
        .table()
}

/// Twelve decimals of a bound, outward.
fn outward(bound: f64, side: f64) -> String {
    format!("{:.12}", bound + 1e-12 * side)
}

/// How the edge vanishes at both ends of the strip, from the two outermost rows there.
fn orders(context: &Context) -> Option<String> {
    let scene = context.outcome.potentially_unstable()?;
    let limit = degenerate_inertial_parameter(nearest_f64(&scene.slider()?.effect_ratio()));
    let edge = |family: &CycleFamilyOutcome| {
        Some((nearest_f64(&family.inertial_parameter), family.edge.as_ref().ok()?.as_ref()?.excess))
    };
    let edges: Vec<(f64, f64)> = scene.near_transition.as_ref()?.families.iter().filter_map(edge).collect();
    let ([one, two, ..], [.., before, last]) = (edges.as_slice(), edges.as_slice()) else { return None };
    let order = |heights: [f64; 2], places: [f64; 2]| {
        round_digits(libm::log(heights[1] / heights[0]) / libm::log(places[1] / places[0]), 3)
    };
    Some(format!(
        " Between the first two rows K/K_c − 1 at the fold grows as η to the power {}; between the last two it vanishes as η_0 − η to the power {} (sampled).",
        order([one.1, two.1], [one.0, two.0]),
        order([before.1, last.1], [limit - before.0, limit - last.0])
    ))
}
