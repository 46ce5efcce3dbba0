//! Tables of what happens close to K = K_c: the coefficient, the runs, the cycles and the edge of bistability.

use crate::experiments::near_transition::bistability::DIGITS;
use crate::experiments::near_transition::{CycleFamilyOutcome, NearRun, NearTransitionOutcome, SmallestKick};
use crate::experiments::shared::cells::DigitColumns;
use crate::experiments::{Context, Need, TableMaker};
use slipmode_core::dynamics::Outcome;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::theory::hopf::degenerate_inertial_parameter;
use slipmode_plot::table::Table;

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
    let note = "Derived from {friction, aging-law, slip-law, motion} by two routes and proved (exact). A is the amplitude of ln(V/V_l) along the cycle.";
    let of = |law| Some((law, context.hopf_coefficient(law).ok()?));
    let hopf = EvolutionLaw::ALL.into_iter().map(of).collect::<Option<Vec<_>>>()?;
    Table::of("hopf-coefficient", "The first Lyapunov coefficient on K = K_c", &hopf)
        .note(note)
        .text("law", "Law", |(law, _)| format!("{} law", law.as_str()))
        .text("real_part", "Re c_1 = ω l_1, with ω² = β − 1", |(_, hopf)| {
            hopf.normal_form[0].to_string()
        })
        .text("square_amplitude", "A²/(K/K_c − 1), leading order", |(_, hopf)| {
            hopf.square_amplitude.to_string()
        })
        .text("sign", "Sign over all parameters", |(_, hopf)| hopf.sign_statement)
        .table()
        .into()
}

fn runs(context: &Context) -> Option<Table> {
    let note = "Start: steady sliding at V_l/10. Peak and amplitude (half of the range) are those of the limit cycle; the growth rate is that of the late oscillation of a decay. The coefficient predicts small stable cycles to leading order. Cycles per factor e: number of oscillations in which the distance from the long-term behaviour shrinks by e.";
    let ended = |run: &NearRun, on_cycle| run.periodic() == Some(on_cycle);
    Table::of(
        "near-transition-runs",
        "Runs close to K = K_c",
        found(context).flat_map(|outcome| &outcome.runs),
    )
    .note(note)
    .text("law", "Law", |run| run.law.as_str())
    .digits("inertial_parameter", "η", "", 6, |run| &run.inertial_parameter)
    .digits("stiffness_over_critical", "K/K_c", "", 6, |run| &run.stiffness_over_critical)
    .text("behaviour", "Long-term behaviour", |run| {
        run.outcome.as_ref().ok().map(|_| if ended(run, true) { "periodic" } else { "decaying" })
    })
    .digits("log_peak", "ln(V_peak/V_l)", "", 6, |run| {
        let found = run.outcome.as_ref().ok().filter(|_| ended(run, true));
        found.map(|found| found.log_peak())
    })
    .digits("log_peak_error", "Its error", "", 2, |run| {
        run.outcome.as_ref().ok().map(Outcome::peak_relative_error)
    })
    .digits("log_peak_newton", "the same by Newton's method", "", 6, |run| run.newton_log_peak)
    .digits("amplitude", "Amplitude of ln(V/V_l)", "", 6, |run| run.amplitude())
    .digits("amplitude_predicted", "predicted by the coefficient", "", 6, |run| run.predicted_amplitude)
    .digits("growth_over_rate", "Growth rate", "V_l/D_c", 3, |run| run.growth())
    .digits("linear_growth_over_rate", "Re(s)", "V_l/D_c", 6, |run| {
        run.linear_growth.filter(|_| ended(run, false))
    })
    .digits("laps_per_e_fold", "Cycles per factor e", "", 3, |run| run.returns_per_fold())
    .text("failure", "Failure", |run| run.outcome.as_ref().err().map(ToString::to_string))
    .table()
    .into()
}

fn families(context: &Context) -> Option<Table> {
    let note = "Stable and unstable cycles, found by Newton's method on the return map with K as an unknown. A multiplier above 1 means unstable.";
    let cycles =
        families_of(context).flat_map(|family| family.cycles.iter().map(move |cycle| (family, cycle)));
    Table::of("cycle-families", "Cycles that leave steady sliding at K = K_c", cycles)
        .note(note)
        .text("law", "Law", |(family, _)| family.law.as_str())
        .digits("inertial_parameter", "η", "", 6, |(family, _)| &family.inertial_parameter)
        .digits("stiffness_excess", "K/K_c − 1", "", 5, |(_, cycle)| cycle.excess)
        .digits("stiffness_excess_predicted", "predicted by the coefficient", "", 5, |(_, cycle)| {
            cycle.predicted_excess
        })
        .digits("amplitude", "Amplitude of ln(V/V_l)", "", 6, |(_, cycle)| cycle.amplitude)
        .digits("log_peak", "ln(V_peak/V_l)", "", 6, |(_, cycle)| cycle.log_peak)
        .digits("multiplier", "Leading Floquet multiplier", "", 6, |(_, cycle)| cycle.multiplier)
        .table()
        .into()
}

fn agreement(context: &Context) -> Option<Table> {
    let note = "The deviation is of second order in the amplitude, the next term of the normal form. The order follows from two cycles whose amplitudes differ by a factor of about two (sampled). It is left out where the second-order term is close to changing sign, so that the next term dominates.";
    let rows: Vec<_> =
        families_of(context).filter_map(|family| Some((family, family.agreement()?))).collect();
    Table::of("cycle-agreement", "Integrated cycles compared with the first Lyapunov coefficient", &rows)
        .note(note)
        .text("law", "Law", |(family, _)| family.law.as_str())
        .digits("inertial_parameter", "η", "", 6, |(family, _)| &family.inertial_parameter)
        .text("criticality", "Bifurcation (exact)", |(family, _)| family.criticality().as_str())
        .digits("amplitude", "Amplitude of ln(V/V_l)", "", 3, |(_, found)| found.amplitude)
        .digits("deviation", "(K/K_c − 1) / predicted − 1", "", 3, |(_, found)| found.deviation)
        .digits("order", "Order in the amplitude", "", 3, |(_, found)| found.order)
        .table()
        .into()
}

fn edges(context: &Context) -> Option<Table> {
    let note = format!(
        "The limit of bistability is the fold of the family of cycles (converged). Runs that start on the fold's cycle end on a limit cycle below the fold and in steady sliding above it. Threshold start, for K half-way to the fold: runs that start from slower steady sliding end on the limit cycle, others in steady sliding. Runs from 2 % in ln(V/V_l) on either side confirm it. An empty cell: at least one of the runs has no result.{}",
        orders(context).unwrap_or_default()
    );
    let edges =
        families_of(context).filter_map(|family| Some((family, family.edge.as_ref().ok()?.as_ref()?)));
    Table::of("bistability-edge", "Limit of bistability, aging law", edges)
        .note(&note)
        .digits("inertial_parameter", "η", "", 6, |(family, _)| &family.inertial_parameter)
        .digits("loading_velocity_m_per_s", "V_l on K = K_c", "m/s", 4, |(_, edge)| {
            edge.loading_velocity_m_per_s
        })
        .digits("normal_stress_pa", "σ on K = K_c", "Pa", 4, |(_, edge)| edge.normal_stress_pa)
        .digits("edge_excess", "Fold: K/K_c − 1", "", 5, |(_, edge)| edge.excess)
        .digits("edge_error", "± of the continuation", "", 1, |(_, edge)| edge.error)
        .digits("bracket_by_runs", "Confirmed by runs to a relative", "", 1, |(_, edge)| edge.bracket)
        .digits("edge_log_peak", "ln(V_peak/V_l) at the fold", "", 4, |(_, edge)| edge.log_peak)
        .digits("law_excess", "K/K_c − 1 by the law as η → 0", "", 5, |(_, edge)| {
            Some(edge.law?.excess[0])
        })
        .digits("law_error", "Its error", "", 1, |(_, edge)| Some(edge.law?.excess[1]))
        .digits("peak_by_law", "ln(V_peak/V_l) by this law", "", 4, |(_, edge)| Some(edge.law?.log_peak[0]))
        .digits("peak_error", "Its error", "", 1, |(_, edge)| Some(edge.law?.log_peak[1]))
        .digits("width_dex", "Width in σ", "dex", 3, |(_, edge)| edge.width_dex)
        .digits("half_way_excess", "Half-way: K/K_c − 1", "", 5, |(_, edge)| {
            Some(edge.threshold.as_ref()?.excess)
        })
        .digits("unstable_log_peak", "ln(V_peak/V_l) of the unstable cycle", "", 5, |(_, edge)| {
            Some(edge.threshold.as_ref()?.unstable_log_peak)
        })
        .digits("threshold_start_velocity_ratio", "Threshold start V/V_l", "", 5, |(_, edge)| {
            Some(edge.threshold.as_ref()?.start_velocity_ratio)
        })
        .text("threshold_confirmed", "Confirmed by runs", |(_, edge)| {
            let confirmed = edge.threshold.as_ref().and_then(|at| at.confirmed);
            confirmed.map(|confirmed| if confirmed { "yes" } else { "no" })
        })
        .table()
        .into()
}

fn coexisting(context: &Context) -> Option<Table> {
    let note = "At these decimals, with the aging law, steady sliding and the larger cycle attract and the smaller one repels (certified); bounds of ln(V_peak/V_l). y and ζ at V = V_l: where to look for the smaller cycle.";
    let proved = families_of(context).filter_map(|family| {
        let at = family.edge.as_ref().ok()?.as_ref()?.threshold.as_ref()?;
        Some((family, at, at.coexistence.as_ref().ok()?))
    });
    let [low, high] = [-1.0, 1.0].map(|side| move |bound| outward(bound, side));
    Table::of("bistability-certified", "Bistability, proved", proved)
        .note(note)
        .digits("inertial_parameter", "η", "", 12, |(family, _, _)| &family.inertial_parameter)
        .digits("stiffness_group", "κ", "", DIGITS, |(_, at, _)| &at.stiffness_group)
        .digits("effect_ratio", "β", "", 12, |(family, _, _)| family.effect_ratio())
        .text("stable_log_peak_low", "Larger, from", |(_, _, found)| low(found.attracting_log_peak[0]))
        .text("stable_log_peak_high", "to", |(_, _, found)| high(found.attracting_log_peak[1]))
        .text("unstable_log_peak_low", "Smaller, from", |(_, _, found)| low(found.repelling_log_peak[0]))
        .text("unstable_log_peak_high", "to", |(_, _, found)| high(found.repelling_log_peak[1]))
        .digits("unstable_y", "y", "", 9, |(_, at, _)| at.crossing[0])
        .digits("unstable_zeta", "ζ", "", 9, |(_, at, _)| at.crossing[1])
        .table()
        .into()
}

fn kicks(context: &Context) -> Option<Table> {
    let note = "A kick is a sudden change of V, or of the stress of the spring, on steady sliding. The smallest of the tried kicks that does not decay (sampled). Peak after it: of the twelfth return, when the run moves along the slow direction. Unstable cycle: by Newton's method on the return map, which uses no kick; its bounds are proved together with a larger, stable cycle and stable sliding (certified). Runs from kicks that are 5 % smaller and larger confirm the border: they end in sliding and on a limit cycle.";
    let rows = found(context).flat_map(|found| &found.kicks);
    let border = |row: &SmallestKick| row.border.as_ref().ok().cloned().flatten();
    let middle = |[low, high]: [f64; 2]| 0.5 * (low + high);
    let half_width = |[low, high]: [f64; 2]| 0.5 * (high - low).abs();
    Table::of("smallest-kicks", "Smallest kicks that end stable steady sliding", rows)
        .note(note)
        .text("law", "Law", |row| row.law.as_str())
        .digits("inertial_parameter", "η", "", 6, |row| &row.inertial_parameter)
        .digits("stiffness_over_critical", "K/K_c", "", 6, |row| &row.stiffness_over_critical)
        .text("kick", "Kick", |row| row.kick.as_str())
        .named()
        .digits("fold_over_critical", "K/K_c at the fold", "", 7, |row| {
            row.fold_over_critical.map(|[fold, _]| fold)
        })
        .digits("fold_error", "Its error", "", 1, |row| row.fold_over_critical.map(|[_, error]| error))
        .text("ends_sliding", "Ends steady sliding", |row| {
            row.border.as_ref().ok().map(|border| if border.is_some() { "yes" } else { "no" })
        })
        .digits("kick_change", "V/V_l − 1, or change of stress over aσ", "", 6, move |row| {
            border(row).map(|at| middle(at.changes))
        })
        .digits("kick_error", "Its error", "", 1, move |row| border(row).map(|at| half_width(at.changes)))
        .digits("largest_tried", "Largest tried", "", 6, |row| row.kick.change(row.kick.largest()))
        .digits("border_log_peak", "ln(V_peak/V_l) after it", "", 8, move |row| {
            border(row).map(|at| middle(at.log_peaks))
        })
        .digits("border_error", "Its error", "", 1, move |row| border(row).map(|at| half_width(at.log_peaks)))
        .digits("unstable_log_peak", "ln(V_peak/V_l) of the unstable cycle", "", 8, |row| {
            row.unstable_log_peak.map(|[_, peak, _]| peak)
        })
        .text("unstable_log_peak_low", "From", |row| {
            row.unstable_log_peak.map(|[low, ..]| outward(low, -1.0))
        })
        .text("unstable_log_peak_high", "to", |row| {
            row.unstable_log_peak.map(|[.., high]| outward(high, 1.0))
        })
        .text("confirmed", "Confirmed by runs", move |row| {
            border(row).and_then(|at| at.confirmed).map(|confirmed| if confirmed { "yes" } else { "no" })
        })
        .text("failure", "Failure", |row| row.border.as_ref().err().map(ToString::to_string))
        .table()
        .into()
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
