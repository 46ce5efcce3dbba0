//! Where stick-slip turns into vibration, how harmonic the vibration is, and what fig 5 divides by.

use crate::claims::certified::{Pair, Pairs, both_cycle, rises};
use crate::claims::reading::{Draft, of_readings};
use crate::claims::rule::{Deviations, Measure};
use crate::claims::simulated::{Run, Runs, grids, outcome};
use crate::claims::simulated_least_peak::{extent, range, velocity_of_least_peak};
use crate::claims::{Evidence, Finding};
use crate::experiments::simulations::{LeastPeak, PERIOD_LEVELS, SIDE_WIDTH};
use crate::experiments::{Context, Outcome};
use crate::scene::Kind;
use slipmode_core::dynamics::Estimate;
use slipmode_core::friction::{EvolutionLaw, Slider};
use slipmode_core::number::format::{Side, round_digits, rounded};
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::SlipMode;
use slipmode_core::stability::asymptote::inertial_upper_velocity_m_per_s;

pub(super) fn period_at_least_peak(context: &Context) -> Result<Finding, Finding> {
    let least = &outcome(context, Outcome::potentially_unstable)?.least_peaks;
    let by_peak = velocity_of_least_peak(context)?;
    let written =
        Draft::new("the cycle turns from stick-slip to vibration, and its peak is lowest, at eq 18");
    let written = EvolutionLaw::ALL.into_iter().fold(written, |draft, law| {
        let found: Vec<&LeastPeak> = least.iter().filter(|found| found.law == law).collect();
        draft.part(
            format!("{} law: the period becomes that of vibration at eq 18", law.as_str()),
            period_at_eq18(law, &found, context.kind),
        )
    });
    let written = written.part("the peak velocity is lowest at eq 18", by_peak.clone());
    let peak = Draft::new("the transition is the minimum of the peak velocity, whatever the period")
        .part("the peak velocity is lowest at eq 18", by_peak);
    let [slow, fast] = PERIOD_LEVELS;
    let width = |found: &LeastPeak| Some(found.period_change_dex[1]? - found.period_change_dex[0]?);
    let width = extent(least.iter().filter_map(width));
    let theory = extent(least.iter().filter_map(|found| found.theory_mode_change_dex));
    let change = extent(least.iter().filter_map(|found| found.cycle_mode_change_dex));
    Ok(of_readings([written, peak])
    .number("change_low", rounded(change.0, 2, Side::Below))
    .number("change_high", rounded(change.1, 2, Side::Above))
    .with_supporting(Evidence::Simulation {
        quantity: "log10 of the velocity divided by that of eq 18 where the frequency of small deviations passes √½ ω_n by the exact theory".into(),
        value: format!("{} dex", range(theory, 3)),
        error: format!("{SIDE_WIDTH} dex"),
        runs: least.len(),
    })
    .remark(format!("The transition has a width: the period falls from {slow} to {fast} natural periods over {} dex of velocity.", range(width, 3))))
}

/// Whether the period of the cycles falls below √2 natural periods, the border of the two modes' names, at eq 18.
fn period_at_eq18(law: EvolutionLaw, least: &[&LeastPeak], kind: Kind) -> Finding {
    if least.is_empty() {
        return Finding::not_checked(format!("The report has no lowest peak of the {} law.", law.as_str()));
    }
    let periods = |index: usize| extent(least.iter().map(|found| found.periods_over_natural[index].0));
    let error = least.iter().flat_map(|found| found.periods_over_natural).map(|period| period.1);
    let change = extent(least.iter().filter_map(|found| found.cycle_mode_change_dex));
    let found = least.iter().filter_map(|found| found.cycle_mode_change_dex);
    let changes = Deviations::new(Measure::Place, found.map(|dex| (dex, SIDE_WIDTH)));
    let level = |index: usize| extent(least.iter().filter_map(|found| found.period_change_dex[index]));
    let found_all = least.iter().all(|found| found.cycle_mode_change_dex.is_some());
    let [slow, fast] = PERIOD_LEVELS;
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "{} law: period over 2π/ω_n at eq 18; at the lowest peak; log10 of the velocity divided by that of eq 18 where the period is {slow}, √2 and {fast} times 2π/ω_n",
            law.as_str()
        ),
        value: format!(
            "{}; {}; {} dex, {} dex, {} dex",
            range(periods(0), 3),
            range(periods(1), 3),
            range(level(0), 3),
            range(change, 3),
            range(level(1), 3)
        ),
        error: format!("{} of the period, {SIDE_WIDTH} dex", round_digits(error.fold(0.0, f64::max), 1)),
        runs: least.len(),
    })
    .require(found_all, || "at one normal stress no change of mode was found".into())
    .near(kind, &changes)
}

pub(super) fn harmonic_distortion(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let slider = slider(context)?;
    let draft = Draft::new("V of every limit cycle named harmonic vibration is sinusoidal");
    let measured: Vec<_> = grids.iter().map(|grid| (grid, distortions(grid, &slider))).collect();
    let written =
        measured.iter().map(|(grid, found)| (grid, distortion(grid.law, found.as_deref(), context.kind)));
    let written = written.fold(draft, |draft, (grid, finding)| {
        draft.part(
            format!("{} law: the overtones are at most a tenth of the fundamental", grid.law.as_str()),
            finding,
        )
    });
    let all = measured.iter().filter_map(|(_, found)| found.as_deref());
    let from = all.filter_map(|found| harmonic_from(found, context.kind)).fold(0.0, f64::max);
    Ok(of_readings([written]).number("harmonic_from", rounded(from, 2, Side::Above)))
}

/// The slider of the simulations in 64 bits.
pub(super) fn slider(context: &Context) -> Result<Slider<f64>, Finding> {
    let scene = context.outcome.potentially_unstable().and_then(|scene| scene.slider());
    scene
        .map(|slider| slider.map(nearest_f64))
        .ok_or_else(|| Finding::not_checked("The scene has no parameters."))
}

/// V_l/V_18 and the distortion of each harmonic vibration of a grid, by rising velocity; none where a distortion is unknown.
fn distortions(grid: &Runs, slider: &Slider<f64>) -> Option<Vec<(f64, Estimate)>> {
    let vibrations = grid.runs.iter().filter(|run| run.is(SlipMode::HarmonicVibration));
    let measured = vibrations.map(|run| {
        let over_eq18 = run.velocity_m_per_s / inertial_upper_velocity_m_per_s(slider, &run.normal_stress_pa);
        Some((over_eq18, run.course?.on_cycle?.distortion))
    });
    let mut measured = measured.collect::<Option<Vec<_>>>()?;
    measured.sort_by(|one, other| one.0.total_cmp(&other.0));
    Some(measured)
}

/// How far the distortions are from none.
fn deviations(measured: &[(f64, Estimate)]) -> Deviations {
    Deviations::new(
        Measure::Value,
        measured.iter().map(|(_, distortion)| (distortion.value, distortion.error)),
    )
}

/// The V_l/V_18 above which every vibration of the grid is harmonic.
fn harmonic_from(measured: &[(f64, Estimate)], kind: Kind) -> Option<f64> {
    let allowed = deviations(measured);
    let distorted = measured.iter().rev().find(|(_, distortion)| allowed.is_outside(kind, distortion.value));
    distorted.map(|(over_eq18, _)| *over_eq18)
}

fn distortion(law: EvolutionLaw, measured: Option<&[(f64, Estimate)]>, kind: Kind) -> Finding {
    let Some(measured) = measured else {
        return Finding::not_checked("The harmonics of a limit cycle could not be computed.");
    };
    let Some((fastest, last)) = measured.last().copied() else {
        return Finding::not_checked("No run of the grid is a harmonic vibration.");
    };
    let values = extent(measured.iter().map(|(_, distortion)| distortion.value));
    let error =
        measured.iter().map(|(_, distortion)| distortion.error / distortion.value).fold(0.0, f64::max);
    Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "{} law: total harmonic distortion of V, least and largest; the same times V_l/V_18 at the largest V_l/V_18, {}",
            law.as_str(),
            round_digits(fastest, 3)
        ),
        value: format!("{}; {}", range(values, 3), round_digits(last.value * fastest, 4)),
        error: format!("{} of the distortion", round_digits(error, 1)),
        runs: measured.len(),
    })
    .near(kind, &deviations(measured))
}

/// log10 of the velocity in m/s by whose peak fig 5 divides, and how far a column of the grid may be from it.
const DIVISOR_LOG10: f64 = -5.5;
const SAME_COLUMN: f64 = 1e-6;

pub(super) fn cycles_at_one_velocity(context: &Context) -> Result<Finding, Finding> {
    let grids = grids(context, Outcome::potentially_unstable)?;
    let critical_pa = slider(context)?.critical_normal_stress_pa();
    let side = |above: bool| divisors(&grids, move |stress| (stress > critical_pa) == above);
    let below = side(false)?;
    let is_below = move |(run, _): &Pair| run.normal_stress_pa < critical_pa;
    let rising = Pairs::new(
        &grids,
        move |grid| grid.along_velocity().filter(is_below),
        |pair| rises(pair).among(both_cycle(pair)),
    );
    let below = rising
        .evidence("Neighbouring limit cycles at the same σ < σ_c whose peak velocity rises with V_l")
        .into_iter()
        .fold(below, Finding::with_evidence);
    let words = "the peak at 10^-5.5 m/s, by which fig 5 divides, is that of a limit cycle";
    let written = Draft::new("at every normal stress of fig 3a")
        .part(format!("above σ_c {words}"), side(true)?)
        .part(format!("below σ_c {words}"), below);
    Ok(of_readings([written]).remark(format!("Below σ_c, fig 5 divides the peak of a limit cycle by that of a transient, which the start V_l/10 decides. There the peak of the cycles rises between {} neighbours, so the lowest peak is where they begin, at K = K_c, and not at eq 18.", rising.share())))
}

/// Whether the runs at the velocity of the divisor end on a limit cycle, at the chosen normal stresses.
fn divisors(grids: &[Runs], chosen: impl Fn(f64) -> bool) -> Result<Finding, Finding> {
    let is_divisor = |run: &&Run| (libm::log10(run.velocity_m_per_s) - DIVISOR_LOG10).abs() < SAME_COLUMN;
    let runs = || grids.iter().flat_map(|grid| &grid.runs).filter(is_divisor);
    let runs: Vec<&Run> = runs().filter(|run| chosen(run.normal_stress_pa)).collect();
    let decaying: Vec<&&Run> = runs.iter().filter(|run| !run.periodic()).collect();
    let ratios = extent(runs.iter().map(|run| run.simulation.peak_velocity_m_per_s / run.velocity_m_per_s));
    let error = runs.iter().map(|run| run.simulation.peak_relative_error).fold(0.0, f64::max);
    let [Some(first), Some(last)] = [runs.first(), runs.last()] else {
        return Err(Finding::not_checked("The grid has no run at 10^-5.5 m/s."));
    };
    let stresses = extent([first, last].into_iter().map(|run| run.normal_stress_pa));
    Ok(Finding::from_evidence(Evidence::Simulation {
        quantity: format!(
            "Runs at V_l = 10^-5.5 m/s, σ from {} Pa: limit cycles, decays; V_peak/V_l",
            range(stresses, 4)
        ),
        value: format!("{}, {}; {}", runs.len() - decaying.len(), decaying.len(), range(ratios, 4)),
        error: format!("{} of the peak", round_digits(error, 1)),
        runs: runs.len(),
    })
    .require(decaying.is_empty(), || {
        format!(
            "{} of {} runs decay; their V_peak/V_l of {} is that of the transient",
            decaying.len(),
            runs.len(),
            range(ratios, 4)
        )
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::Verdict;
    use crate::experiments::simulations::SimulatedPoint;
    use crate::experiments::{Need, References, Scene, run};
    use crate::scene::{Limits, read_equations};
    use slipmode_core::dynamics::Behaviour;
    use slipmode_core::friction::EvolutionLaw::Slip;

    fn least(cycle_mode_change_dex: f64) -> LeastPeak {
        LeastPeak {
            law: Slip,
            normal_stress_pa: 1e6,
            eq18_velocity_m_per_s: 1e-2,
            offset_dex: 0.0,
            offset_error_dex: 1e-3,
            least_m_per_s: 1.0,
            peak_at_eq18_over_least: 1.0,
            curvature_per_dex2: 1.0,
            flat: [[None; 2]; 2],
            cycle_mode_change_dex: Some(cycle_mode_change_dex),
            period_change_dex: [Some(-0.1), Some(0.1)],
            periods_over_natural: [(1.4, 1e-9); 2],
            theory_mode_change_dex: Some(0.0),
            samples: Vec::new(),
        }
    }

    #[test]
    fn a_transition_at_eq_18_would_be_found_there_and_one_elsewhere_is_refuted() {
        let (there, elsewhere) = (least(0.5 * SIDE_WIDTH), least(0.7));
        let near = |least: &[&LeastPeak]| period_at_eq18(Slip, least, Kind::Universal);
        assert_eq!(near(&[&there]).verdict, Verdict::Holds);
        let found = near(&[&there, &elsewhere]);
        assert_eq!(found.verdict, Verdict::Fails);
        assert_eq!(found.counter_example.as_deref(), Some("off by 0.0005 to 0.7 dex"));
        assert_eq!(near(&[]).verdict, Verdict::NotChecked);
    }

    /// A small grid of the paper's slider, with the slip law: σ below and above σ_c, V_l from 10^-5.5 m/s.
    fn small_grid() -> Outcome {
        let text = include_str!("../../reports/im-avouac/scenes/potentially-unstable.toml");
        let (head, _) = text.split_once("[simulations]").unwrap();
        let slider = format!(
            "{}[simulations]\nloading_velocity_m_per_s = {{ from = 3.1622776601683795e-6, to = 3.1622776601683795e-2, points = 3 }}\n\
             normal_stress_pa = {{ from = 1e4, to = 1e6, points = 2 }}\nlaws = [\"slip\"]\ntolerance = 1e-6\n",
            &head[..head.find("[map]").unwrap_or(head.len())]
        );
        let scene = Scene::parse("s.toml", slider.as_bytes(), &Limits::default()).unwrap();
        run(&[scene], &[Need::Simulations].into(), &References::default(), &|_, _, _| {})
    }

    fn verdict(outcome: &Outcome, decide: fn(&Context) -> Result<Finding, Finding>) -> Verdict {
        let text = include_bytes!("../../reports/im-avouac/equations.toml");
        let equations = read_equations("equations.toml", text).unwrap();
        let context = Context::new(&equations, outcome);
        let context = context.with_kind(Kind::Approximate);
        decide(&context).unwrap_or_else(|undecided| undecided).verdict
    }

    fn points(outcome: &mut Outcome) -> impl Iterator<Item = &mut SimulatedPoint> {
        let simulations = outcome.scenes.iter_mut().filter_map(|scene| scene.simulations.as_mut());
        simulations.flat_map(|simulations| &mut simulations.grids).flat_map(|(_, grid)| &mut grid.values)
    }

    #[test]
    fn runs_that_were_altered_change_the_verdicts_on_harmonics_and_on_the_divisors_of_fig_5() {
        let mut outcome = small_grid();
        assert_eq!(verdict(&outcome, cycles_at_one_velocity), Verdict::Fails);
        for point in points(&mut outcome) {
            point.simulation.as_mut().unwrap().behaviour = Behaviour::Periodic;
        }
        assert_eq!(verdict(&outcome, cycles_at_one_velocity), Verdict::Holds);
        let mut with_distortion = |value| {
            let cycles = points(&mut outcome).filter_map(|point| point.course.as_mut()?.on_cycle.as_mut());
            cycles.for_each(|cycle| cycle.distortion.value = value);
            verdict(&outcome, harmonic_distortion)
        };
        assert_eq!(with_distortion(0.01), Verdict::Holds);
        assert_eq!(with_distortion(0.9), Verdict::Fails);
    }
}
