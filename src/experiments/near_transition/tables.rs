//! Tables of what happens close to K = K_c: the coefficient, the runs, the cycles and the edge of bistability.

use crate::experiments::Context;
use crate::experiments::Need;
use crate::experiments::TableMaker;
use crate::experiments::near_transition::{
    CycleFamilyOutcome, Edge, NearRun, NearTransitionOutcome, Threshold,
};
use crate::experiments::shared::cells::{rounded, rounded_or_empty};
use crate::experiments::unless_empty;
use slipmode_core::number::format::{rational_to_decimal, round_digits};
use slipmode_core::number::nearest_f64;
use slipmode_core::theory::hopf::{coefficient, degenerate_inertial_parameter};
use slipmode_core::theory::linearisation::Law;
use slipmode_plot::table::{Cell, Column, Table};

const NEEDS: &[Need] = &[Need::NearTransition];

pub(crate) const TABLES: &[TableMaker] = &[
    TableMaker { id: "hopf-coefficient", needs: &[], make: coefficients },
    TableMaker { id: "near-transition-runs", needs: NEEDS, make: runs },
    TableMaker { id: "cycle-families", needs: NEEDS, make: families },
    TableMaker { id: "cycle-agreement", needs: NEEDS, make: agreement },
    TableMaker { id: "bistability-edge", needs: NEEDS, make: edges },
];

fn found<'c>(context: &'c Context) -> impl Iterator<Item = &'c NearTransitionOutcome> {
    context.outcome.scenes.iter().filter_map(|scene| scene.near_transition.as_ref())
}

fn coefficients(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::text("real_part", "Re c_1 = ω l_1, with ω² = β − 1"),
        Column::text("square_amplitude", "A²/(K/K_c − 1), leading order"),
        Column::text("sign", "Sign over all parameters"),
    ];
    let mut table = Table::new("hopf-coefficient", "The first Lyapunov coefficient on K = K_c", columns)
        .with_note("Derived from eqs 1 to 4 by two routes and proved (exact). A is the amplitude of ln(V/V_l) along the cycle.");
    for law in Law::ALL {
        let hopf = coefficient(context.equations, law).ok()?;
        table.push(vec![
            Cell::text(law.as_str()),
            Cell::text(hopf.normal_form[0].to_string()),
            Cell::text(hopf.square_amplitude.to_string()),
            Cell::text(hopf.sign_statement),
        ]);
    }
    unless_empty(table)
}

fn runs(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("inertial_parameter", "η", ""),
        Column::number("stiffness_over_critical", "K/K_c", ""),
        Column::text("behaviour", "Long-term behaviour"),
        Column::number("log_peak", "ln(V_peak/V_l)", ""),
        Column::number("log_peak_newton", "the same by Newton's method", ""),
        Column::number("amplitude", "Amplitude of ln(V/V_l)", ""),
        Column::number("amplitude_predicted", "predicted by the coefficient", ""),
        Column::number("growth_over_rate", "Growth rate", "V_l/D_c"),
        Column::number("linear_growth_over_rate", "Re(s)", "V_l/D_c"),
        Column::number("laps_per_e_fold", "Cycles per factor e", ""),
        Column::text("failure", "Failure"),
    ];
    let mut table = Table::new("near-transition-runs", "Runs close to K = K_c", columns)
        .with_note("Start: steady sliding at V_l/10. Peak and amplitude (half of the range) are those of the limit cycle; the growth rate is that of the late oscillation of a decay. The coefficient predicts small stable cycles to leading order. Cycles per factor e: number of oscillations in which the distance from the long-term behaviour shrinks by e.");
    for run in found(context).flat_map(|outcome| &outcome.runs) {
        let ended = |on_cycle: bool| run.periodic().map(|periodic| periodic == on_cycle) == Some(true);
        let word = if ended(true) { "periodic" } else { "decaying" };
        table.push(vec![
            Cell::text(run.law.as_str()),
            Cell::number(rational_to_decimal(&run.inertial_parameter, 6)),
            Cell::number(rational_to_decimal(&run.stiffness_over_critical, 6)),
            if run.outcome.is_ok() { Cell::text(word) } else { Cell::empty() },
            rounded_or_empty(
                run.outcome.as_ref().ok().filter(|_| ended(true)).map(|found| found.log_peak()),
                6,
            ),
            rounded_or_empty(run.newton_log_peak, 6),
            rounded_or_empty(run.amplitude(), 6),
            rounded_or_empty(run.predicted_amplitude, 6),
            rounded_or_empty(run.growth(), 3),
            rounded_or_empty(run.linear_growth.filter(|_| ended(false)), 6),
            rounded_or_empty(run.returns_per_fold(), 3),
            failure(run),
        ]);
    }
    unless_empty(table)
}

fn failure(run: &NearRun) -> Cell {
    run.outcome.as_ref().err().map_or_else(Cell::empty, |failure| Cell::text(failure.to_string()))
}

fn families(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("inertial_parameter", "η", ""),
        Column::number("stiffness_excess", "K/K_c − 1", ""),
        Column::number("stiffness_excess_predicted", "predicted by the coefficient", ""),
        Column::number("amplitude", "Amplitude of ln(V/V_l)", ""),
        Column::number("log_peak", "ln(V_peak/V_l)", ""),
        Column::number("multiplier", "Leading Floquet multiplier", ""),
    ];
    let mut table = Table::new("cycle-families", "Cycles that leave steady sliding at K = K_c", columns)
        .with_note("Stable and unstable cycles, found by Newton's method on the return map with K as an unknown. A multiplier above 1 means unstable.");
    for family in found(context).flat_map(|outcome| &outcome.families) {
        for cycle in &family.cycles {
            table.push(vec![
                Cell::text(family.law.as_str()),
                Cell::number(rational_to_decimal(&family.inertial_parameter, 6)),
                rounded(cycle.excess, 5),
                rounded_or_empty(cycle.predicted_excess, 5),
                rounded(cycle.amplitude, 6),
                rounded(cycle.log_peak, 6),
                rounded_or_empty(cycle.multiplier, 6),
            ]);
        }
    }
    unless_empty(table)
}

fn agreement(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::text("law", "Law"),
        Column::number("inertial_parameter", "η", ""),
        Column::text("criticality", "Bifurcation (exact)"),
        Column::number("amplitude", "Amplitude of ln(V/V_l)", ""),
        Column::number("deviation", "(K/K_c − 1) / predicted − 1", ""),
        Column::number("order", "Order in the amplitude", ""),
    ];
    let mut table = Table::new("cycle-agreement", "Integrated cycles compared with the first Lyapunov coefficient", columns)
        .with_note("The deviation is of second order in the amplitude, the next term of the normal form. The order follows from two cycles whose amplitudes differ by a factor of about two (sampled). It is left out where the second-order term is close to changing sign, so that the next term dominates.");
    for family in found(context).flat_map(|outcome| &outcome.families) {
        let Some(agreement) = family.agreement() else { continue };
        table.push(vec![
            Cell::text(family.law.as_str()),
            Cell::number(rational_to_decimal(&family.inertial_parameter, 6)),
            Cell::text(family.criticality().as_str()),
            rounded(agreement.amplitude, 3),
            rounded(agreement.deviation, 3),
            rounded_or_empty(agreement.order, 3),
        ]);
    }
    unless_empty(table)
}

fn edges(context: &Context) -> Option<Table> {
    let columns = vec![
        Column::number("inertial_parameter", "η", ""),
        Column::number("loading_velocity_m_per_s", "V_l on K = K_c", "m/s"),
        Column::number("normal_stress_pa", "σ on K = K_c", "Pa"),
        Column::number("edge_excess", "Fold: K/K_c − 1", ""),
        Column::number("edge_error", "± of the continuation", ""),
        Column::number("bracket_by_runs", "Confirmed by runs to a relative", ""),
        Column::number("edge_log_peak", "ln(V_peak/V_l) at the fold", ""),
        Column::number("width_dex", "Width in σ", "dex"),
        Column::number("half_way_excess", "Half-way: K/K_c − 1", ""),
        Column::number("unstable_log_peak", "ln(V_peak/V_l) of the unstable cycle", ""),
        Column::number("threshold_start_velocity_ratio", "Threshold start V/V_l", ""),
        Column::text("threshold_confirmed", "Confirmed by runs"),
    ];
    let note = format!(
        "The limit of bistability is the fold of the family of cycles (converged). Runs that start on the fold's cycle end on a limit cycle below the fold and in steady sliding above it. Threshold start, for K half-way to the fold: runs that start from slower steady sliding end on the limit cycle, others in steady sliding. Runs from 2 % in ln(V/V_l) on either side confirm it. An empty cell: at least one of the runs has no result.{}",
        orders(context).unwrap_or_default()
    );
    let mut table =
        Table::new("bistability-edge", "Limit of bistability, aging law", columns).with_note(&note);
    for family in found(context).flat_map(|outcome| &outcome.families) {
        let Ok(Some(edge)) = &family.edge else { continue };
        let mut row = vec![Cell::number(rational_to_decimal(&family.inertial_parameter, 6))];
        row.extend(edge_cells(edge));
        row.extend(threshold_cells(edge.threshold.as_ref()));
        table.push(row);
    }
    unless_empty(table)
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

fn edge_cells(edge: &Edge) -> [Cell; 7] {
    [
        rounded(edge.loading_velocity_m_per_s, 4),
        rounded(edge.normal_stress_pa, 4),
        rounded(edge.excess, 5),
        rounded(edge.error, 1),
        rounded_or_empty(edge.bracket, 1),
        rounded(edge.log_peak, 4),
        rounded(edge.width_dex, 3),
    ]
}

fn threshold_cells(threshold: Option<&Threshold>) -> [Cell; 4] {
    let Some(threshold) = threshold else { return [0; 4].map(|_| Cell::empty()) };
    let word = |confirmed| Cell::text(if confirmed { "yes" } else { "no" });
    [
        rounded(threshold.excess, 5),
        rounded(threshold.unstable_log_peak, 5),
        rounded(threshold.start_velocity_ratio, 5),
        threshold.confirmed.map_or_else(Cell::empty, word),
    ]
}
