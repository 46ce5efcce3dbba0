//! (b − a)σ/√(KM) = 2 V_18 from the peak velocities of deep stick-slip, without a velocity step.

use crate::claims::new_peak::{Compared, Deep, compared, errors, healing};
use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Runs, extent, grids, range};
use crate::claims::{Evidence, Finding};
use crate::experiments::{Context, Outcome};
use crate::fitting::{EFFECT_RATIOS, LEAST_ROWS, PeakFit, PeakGiven, PeakRow, fit_peaks};
use crate::scene::cited;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;

/// What the fit of one row of the grid gives, over 2 V_18.
struct Measured {
    /// At the right law and b/a; no number where there is no fit.
    known: f64,
    /// The deviation of this over V_l/(2 V_18) + K/K_c,qs + 1/A².
    part: f64,
    /// With the other law, where it has such peaks.
    other_law: Option<f64>,
    /// With b/a unknown.
    unknown_ratio: Option<[f64; 2]>,
}

pub(super) fn decide(context: &Context) -> Result<Finding, Finding> {
    let mut draft = Draft::new("deep stick-slip, K/K_c,qs and V_l/V_18 up to a tenth");
    let mut notes = Vec::new();
    for grid in &grids(context, Outcome::potentially_unstable)? {
        let (compared, rows) = compared(context, grid)?;
        let measured: Vec<Measured> =
            rows.iter().filter_map(|row| compared.measured(grid.law, row)).collect();
        if measured.is_empty() {
            return Err(Finding::not_checked(
                "No row of the grid has cycles of deep stick-slip at enough load velocities.",
            ));
        }
        let name = grid.law.as_str();
        draft = draft
            .part(
                format!(
                    "{name} law: −dV_peak/d ln V_l is 2 V_18/(1 − 2 V_18 (1 + s)/V_peak), {}",
                    healing(grid.law)
                ),
                compared.slope(grid, &rows),
            )
            .part(format!("{name} law: V_l and V_peak of the cycles give 2 V_18"), of_rows(grid, &measured));
        notes.extend(remarks(grid.law, &measured));
    }
    Ok(notes.into_iter().fold(of_readings([draft]), Finding::remark))
}

impl Compared<'_> {
    /// The fits of a row of constant normal stress; none where it has too few cycles.
    fn measured(&self, law: EvolutionLaw, row: &[Deep]) -> Option<Measured> {
        if row.len() < LEAST_ROWS {
            return None;
        }
        let rows: Vec<PeakRow> = row
            .iter()
            .map(|deep| PeakRow {
                load_m_per_s: deep.run.velocity_m_per_s,
                peak_m_per_s: deep.run.simulation.peak_velocity_m_per_s,
                relative_error: 1.0,
                stress: 1.0,
            })
            .collect();
        let twice_eq18 = 2.0 * row.first()?.eq18_m_per_s;
        let ratio = self.slider.effect_ratio();
        let fit = |law: EvolutionLaw, effect_ratio: [f64; 2]| -> Option<PeakFit> {
            let given = PeakGiven {
                laws: vec![law],
                effect_ratio,
                slip_velocity_m_per_s: None,
                hidden: 0.0,
                has_errors: false,
            };
            fit_peaks(&rows, &given).ok()?.laws.pop()
        };
        let other = EvolutionLaw::ALL.into_iter().find(|other| *other != law)?;
        let known = fit(law, [ratio; 2]).map_or(f64::INFINITY, |fit| fit.scale_m_per_s / twice_eq18);
        let load = rows.iter().map(|row| row.load_m_per_s / twice_eq18).fold(0.0, f64::max);
        let peak = row.iter().map(|deep| deep.cycle.peak).fold(f64::INFINITY, f64::min);
        let [softness, _] = self.softness(row.first()?.run.normal_stress_pa);
        Some(Measured {
            known,
            part: (known - 1.0).abs() / (load + softness + 1.0 / (peak * peak)),
            other_law: fit(other, [ratio; 2]).map(|fit| fit.scale_m_per_s / twice_eq18),
            unknown_ratio: fit(law, EFFECT_RATIOS)
                .map(|fit| fit.over_effect_ratio.map(|scale| scale / twice_eq18)),
        })
    }
}

/// The value at the known law and b/a, which leaves out loading during the slip, the spring's loss, and terms in 1/A².
fn of_rows(grid: &Runs, measured: &[Measured]) -> Finding {
    let has_fit = measured.iter().all(|one| one.known.is_finite());
    let known = extent(measured.iter().map(|one| one.known));
    let parts = extent(measured.iter().map(|one| one.part));
    Finding::from_evidence(Evidence::Simulation {
        quantity: cited("Fitted 2 V_18 over that of {inertial-upper}; deviation as a part of V_l/(2 V_18) + K/K_c,qs + 1/A²"),
        value: format!("{}; {}", range(known, 4), range(parts, 3)),
        error: errors(grid),
        runs: measured.len(),
    })
    .require(has_fit, || "the cycles of one normal stress have no fit".into())
    .require(parts.1 <= 1.0, || {
        format!("the deviation is up to {} of the allowed one", round_digits(parts.1, 3))
    })
    .on(format!(
        "normal stresses with {LEAST_ROWS} or more load velocities: {}; deviation {} %",
        measured.len(),
        percent(known.0 - 1.0, known.1 - 1.0)
    ))
}

/// What the unknown law and the unknown b/a make of the value.
fn remarks(law: EvolutionLaw, measured: &[Measured]) -> Vec<String> {
    let [low, high] = EFFECT_RATIOS;
    let other = measured.iter().filter_map(|one| one.other_law).collect::<Vec<f64>>();
    let ratios = measured.iter().filter_map(|one| one.unknown_ratio).flatten().collect::<Vec<f64>>();
    let differs = |(with, values): (String, Vec<f64>)| {
        let (least, most) = extent(values.iter().map(|value| value - 1.0));
        let name = law.as_str();
        (!values.is_empty()).then(|| {
            format!("Cycles of the {name} law fitted with {with}: {} % from 2 V_18.", percent(least, most))
        })
    };
    let fits = [("the other law".to_string(), other), (format!("b/a anywhere from {low} to {high}"), ratios)];
    fits.into_iter().filter_map(differs).collect()
}

fn percent(low: f64, high: f64) -> String {
    range((100.0 * low, 100.0 * high), 2)
}
