//! The peak velocity of deep stick-slip, and why eq 18 governs the least one.

use crate::claims::reading::{Draft, of_readings};
use crate::claims::simulated::{Run, Runs, extent, grids, outcome, range};
use crate::claims::{Evidence, Finding};
use crate::experiments::simulations::LeastPeak;
use crate::experiments::{Context, Outcome};
use crate::scene::cited;
use slipmode_core::dynamics::{DEEP, DeepCycle, PeakLaw, drop_over_impedance};
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::format::round_digits;
use slipmode_core::number::{Rational, nearest_f64};
use slipmode_core::theory::Role;
use slipmode_core::theory::emergence;

/// The largest κ/(β − 1) of the lowest peaks that are compared.
const SOFT: f64 = 0.5;

/// The fewest normal stresses at which the lowest peak must be known.
const FEWEST: usize = 4;

/// Precision of eq 18's velocity, in bits.
const BITS: u32 = 128;

/// One evolution law and the slider that it is compared on.
pub(super) struct Compared<'c> {
    context: &'c Context<'c>,
    parameters: &'c Slider<Rational>,
    pub(super) slider: Slider<f64>,
    law: PeakLaw,
}

/// A cycle of deep stick-slip and what it shows.
pub(super) struct Deep<'r> {
    pub(super) run: &'r Run<'r>,
    pub(super) cycle: DeepCycle,
    /// Velocity of eq 18, m/s.
    pub(super) eq18_m_per_s: f64,
}

/// The comparison of a law with the grid of its runs, and the cycles of deep stick-slip in each row of it.
pub(super) fn compared<'c>(
    context: &'c Context<'c>,
    grid: &'c Runs<'c>,
) -> Result<(Compared<'c>, Vec<Vec<Deep<'c>>>), Finding> {
    let parameters = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    let parameters = parameters.ok_or_else(no_runs)?;
    let slider = parameters.map(nearest_f64);
    let law = PeakLaw::new(grid.law, slider.effect_ratio());
    let compared = Compared { context, parameters, slider, law };
    let rows: Option<Vec<Vec<Deep>>> = grid.rows().map(|row| compared.deep(row)).collect();
    let rows =
        rows.ok_or_else(|| Finding::failing(cited("As stated, {inertial-upper} gives no velocity.")))?;
    match rows.iter().all(Vec::is_empty) {
        true => Err(Finding::not_checked("No limit cycle of the grid is deep stick-slip.")),
        false => Ok((compared, rows)),
    }
}

fn no_runs() -> Finding {
    Finding::not_checked("The report has no simulations with a < b under this law.")
}

pub(super) fn decide(context: &Context, law: EvolutionLaw) -> Result<Finding, Finding> {
    let grid = grids(context, Outcome::potentially_unstable)?.into_iter().find(|grid| grid.law == law);
    let grid = grid.ok_or_else(no_runs)?;
    let (compared, rows) = compared(context, &grid)?;
    let deep: Vec<&Deep> = rows.iter().flatten().collect();
    let least = &outcome(context, Outcome::potentially_unstable)?.least_peaks;
    let least = least.iter().filter(|found| found.law == grid.law).collect();
    let healing = healing(grid.law);
    let written = Draft::new("deep stick-slip, K/K_c,qs and V_l/V_18 up to a tenth")
        .part(
            "the stress drop is 2 √(KM) V_peak [√(1 − 2 V_l/V_peak) + (ln 2 − ½)/A²], A = V_peak/(2 V_18)",
            compared.drop(&grid, &deep),
        )
        .part(
            format!("V_peak = 2 V_18 [ln(V_peak/V_l) + ln(1/κ) + s ln(V_peak/V_18) + c(β)] with the next terms in 1/A and V_l/V_peak, {healing}"),
            compared.peak(&grid, &deep),
        )
        .part(
            format!("−dV_peak/d ln V_l is 2 V_18/(1 − 2 (1 + s) V_18/V_peak), {healing}"),
            compared.slope(&grid, &rows),
        )
        .part(
            format!("the velocity of the lowest peak approaches 2 V_18 [1 + (s − π/2)/A] as K/K_c,qs falls, {healing}"),
            compared.lowest(least)?,
        );
    let [constant, error] = compared.law.constant();
    Ok(of_readings([written])
        .with_supporting(Evidence::Sample {
            quantity: "c(β) of V_peak = 2 V_18 [ln(V_peak/V_l) + ln(1/κ) + s ln(V_peak/V_18) + c(β)] to leading order, and the power s of the healing".into(),
            value: format!(
                "c({}) = {} ± {}; s = {}",
                round_digits(compared.slider.effect_ratio(), 6),
                round_digits(constant, 9),
                round_digits(error, 1),
                round_digits(compared.law.healing(), 6)
            ),
            points: 1,
        })
        .remark(remark(grid.law)))
}

/// The power s of the stick's duration.
pub(super) fn healing(law: EvolutionLaw) -> &'static str {
    match law {
        EvolutionLaw::Slip => "s = 0",
        EvolutionLaw::Aging => "s = β/(β − 1)",
    }
}

fn remark(law: EvolutionLaw) -> &'static str {
    match law {
        EvolutionLaw::Slip => {
            "The peak falls by 2 V_18 for each factor e of V_l, because a faster load point leaves less of the logarithm of V_peak/V_l. The load point adds V_l to the peak during the slip. The two balance at V_l = 2 V_18 to leading order. That the fast slip follows the steady-state friction is due to Rice & Tse (1986); Gu, Rice, Ruina & Tse (1984) describe the quasi-static approach to it."
        }
        EvolutionLaw::Aging => {
            "The contact heals during the stick, for a time in proportion to the stress drop. This adds β/(β − 1) ln(V_peak/V_18) to the strength, and raises the velocity of the lowest peak."
        }
    }
}

impl Compared<'_> {
    /// The velocity of eq 18 as the report states it; none where it gives none.
    fn eq18(&self, stress: f64) -> Option<f64> {
        let stress = Rational::from_f64(stress)?;
        let velocity = emergence::velocity_of(
            self.context.equations,
            Role::InertialUpper,
            self.parameters,
            &stress,
            BITS,
        )?;
        Some(velocity.to_f64())
    }

    /// K/K_c,qs at this normal stress, and κ.
    pub(super) fn softness(&self, stress: f64) -> [f64; 2] {
        let kappa = self.slider.stiffness_stress_pa() / (self.slider.direct_effect * stress);
        [kappa / (self.slider.effect_ratio() - 1.0), kappa]
    }

    /// The cycles of deep stick-slip in a row of constant normal stress.
    fn deep<'r>(&self, row: &'r [Run<'r>]) -> Option<Vec<Deep<'r>>> {
        let Some(first) = row.first() else { return Some(Vec::new()) };
        let eq18_m_per_s = self.eq18(first.normal_stress_pa)?;
        let [softness, stiffness_group] = self.softness(first.normal_stress_pa);
        let deep = |run: &&Run| softness <= DEEP && run.velocity_m_per_s <= DEEP * eq18_m_per_s;
        let of = |run: &'r Run<'r>| {
            let peak_m_per_s = run.simulation.peak_velocity_m_per_s;
            let peak = peak_m_per_s / (2.0 * eq18_m_per_s);
            let loading = run.velocity_m_per_s / peak_m_per_s;
            Deep { run, cycle: DeepCycle { peak, loading, stiffness_group }, eq18_m_per_s }
        };
        Some(row.iter().filter(|run| run.periodic()).filter(deep).map(of).collect())
    }

    fn drop(&self, grid: &Runs, deep: &[&Deep]) -> Finding {
        let impedance = (self.slider.stiffness_pa_per_m * self.slider.mass_per_area_kg_per_m2).sqrt();
        let deviation = |deep: &Deep| {
            let over = deep.run.simulation.stress_drop_pa
                / (2.0 * impedance * deep.run.simulation.peak_velocity_m_per_s);
            [over, over - drop_over_impedance(&deep.cycle)]
        };
        let allowed = |deep: &Deep| self.law.weakening(&deep.cycle) / deep.cycle.peak;
        let ratios = extent(deep.iter().map(|deep| deviation(deep)[0]));
        let worst = extent(deep.iter().map(|deep| deviation(deep)[1]));
        let parts = extent(deep.iter().map(|deep| deviation(deep)[1].abs() / allowed(deep)));
        Finding::from_evidence(of_runs(
            grid,
            deep,
            "Stress drop over 2 √(KM) V_peak; the same less its formula; part of κ Δln θ/((β − 1) A), the spring's loss while the state weakens",
            [ratios, worst, parts],
        ))
        .require(parts.1 <= 1.0, || format!("the difference is up to {} of the allowed one", round_digits(parts.1, 3)))
        .on(format!("{} limit cycles; 2 √(KM) V_peak alone is within {} %", deep.len(), percent(ratios.0 - 1.0, ratios.1 - 1.0)))
    }

    fn peak(&self, grid: &Runs, deep: &[&Deep]) -> Finding {
        let part = |deep: &&Deep| self.law.remainder(&deep.cycle) / self.law.weakening(&deep.cycle);
        let relative = extent(deep.iter().map(|deep| self.law.remainder(&deep.cycle) / deep.cycle.peak));
        let parts = extent(deep.iter().map(part));
        let peaks = extent(deep.iter().map(|deep| deep.cycle.peak));
        Finding::from_evidence(of_runs(
            grid,
            deep,
            "V_peak/(2 V_18); (formula − V_peak)/V_peak; part of κ Δln θ/((β − 1) A), the spring's loss while the state weakens",
            [peaks, relative, parts],
        ))
        .require(parts.0 >= 0.0 && parts.1 <= 1.0, || {
            format!("the difference is {} of the allowed one", range(parts, 3))
        })
        .on(format!(
            "{} limit cycles; V_peak is below the formula by up to {} %, always less than the spring's loss while the state weakens, which is in proportion to K/K_c,qs but for a logarithm",
            deep.len(),
            round_digits(100.0 * relative.1, 2)
        ))
    }

    /// Between neighbours along V_l; the formula leaves out loading during the slip, the spring's loss, and terms in 1/A².
    pub(super) fn slope(&self, grid: &Runs, rows: &[Vec<Deep>]) -> Finding {
        let deviation = |pair: &[Deep]| {
            let [first, second] = pair else { return None };
            let middle = |of: fn(&Deep) -> f64| (of(first) * of(second)).sqrt();
            let peaks = second.cycle.peak - first.cycle.peak;
            let velocities = libm::log(second.run.velocity_m_per_s / first.run.velocity_m_per_s);
            let peak = middle(|deep| deep.cycle.peak);
            let loading = middle(|deep| deep.run.velocity_m_per_s) / (2.0 * first.eq18_m_per_s);
            let [softness, _] = self.softness(first.run.normal_stress_pa);
            let deviation = -peaks / velocities / self.law.slope(peak) - 1.0;
            Some([deviation, deviation.abs() / (loading + softness + 1.0 / (peak * peak))])
        };
        let pairs: Vec<[f64; 2]> = rows.iter().flat_map(|row| row.windows(2)).filter_map(deviation).collect();
        let [relative, parts] = [0, 1].map(|n| extent(pairs.iter().map(|pair| pair[n])));
        Finding::from_evidence(Evidence::Simulation {
            quantity: "Relative deviation of −ΔV_peak/Δ ln V_l from its formula; part of V_l/(2 V_18) + K/K_c,qs + 1/A²".into(),
            value: format!("{}; {}", range(relative, 3), range(parts, 3)),
            error: errors(grid),
            runs: pairs.len(),
        })
        .require(parts.1 <= 1.0, || format!("the deviation is up to {} of the allowed one", round_digits(parts.1, 3)))
        .on(format!("{} pairs of neighbours, deviation {} %", pairs.len(), percent(relative.0, relative.1)))
    }

    /// At every normal stress, softest last.
    fn lowest(&self, mut least: Vec<&LeastPeak>) -> Result<Finding, Finding> {
        least.sort_by(|one, other| one.normal_stress_pa.total_cmp(&other.normal_stress_pa));
        least.retain(|found| self.softness(found.normal_stress_pa)[0] <= SOFT);
        if least.len() < FEWEST {
            return Err(Finding::not_checked("The lowest peak is known at too few normal stresses."));
        }
        let place = |found: &&LeastPeak| {
            let eq18 = self.eq18(found.normal_stress_pa)?;
            let peak = found.least_m_per_s / (2.0 * eq18);
            let velocity = found.eq18_velocity_m_per_s * libm::exp10(found.offset_dex);
            let formula = 2.0 * eq18 * self.law.least_loading(peak);
            Some([libm::log10(velocity / (2.0 * eq18)), libm::log10(velocity / formula)])
        };
        let places: Option<Vec<[f64; 2]>> = least.iter().map(place).collect();
        let places = places
            .ok_or_else(|| Finding::failing(cited("As stated, {inertial-upper} gives no velocity.")))?;
        let falls = places.windows(2).all(|pair| pair[1][1].abs() < pair[0][1].abs());
        let error = least.iter().map(|found| found.offset_error_dex).fold(0.0, f64::max);
        let list =
            |n: usize| places.iter().map(|place| round_digits(place[n], 3)).collect::<Vec<_>>().join(", ");
        let [first, .., last] = places.as_slice() else {
            return Err(Finding::not_checked("The lowest peak is known at too few normal stresses."));
        };
        let softness = |found: Option<&&LeastPeak>| {
            found.map_or_else(String::new, |found| round_digits(self.softness(found.normal_stress_pa)[0], 2))
        };
        Ok(Finding::from_evidence(Evidence::Simulation {
            quantity: "log10 of the velocity of the lowest peak over 2 V_18; over 2 V_18 [1 + (s − π/2)/A]: by rising σ".into(),
            value: format!("{}; {}", list(0), list(1)),
            error: format!("{} dex at most", round_digits(error, 2)),
            runs: least.len(),
        })
        .require(falls, || "the distance from the formula does not fall at every step of σ".into())
        .on(format!(
            "{} normal stresses, K/K_c,qs from {} down to {}: the distance from the formula falls at every step, from {} to {} dex",
            least.len(),
            softness(least.first()),
            softness(least.last()),
            round_digits(first[1].abs(), 2),
            round_digits(last[1].abs(), 2)
        )))
    }
}

/// Evidence from these cycles of the grid: ranges of several numbers.
fn of_runs(grid: &Runs, deep: &[&Deep], quantity: &str, ranges: [(f64, f64); 3]) -> Evidence {
    let value = ranges.map(|extent| range(extent, 3)).join("; ");
    Evidence::Simulation { quantity: quantity.into(), value, error: errors(grid), runs: deep.len() }
}

/// The largest error estimate of a peak or stress drop on the grid.
pub(super) fn errors(grid: &Runs) -> String {
    let of = |run: &Run| run.simulation.peak_relative_error.max(run.simulation.stress_drop_relative_error);
    let cycles = grid.runs.iter().filter(|run| run.periodic());
    format!("{} of peak velocity or stress drop", round_digits(cycles.map(of).fold(0.0, f64::max), 2))
}

fn percent(low: f64, high: f64) -> String {
    range((100.0 * low, 100.0 * high), 2)
}
