//! Normalised peak velocities and their minimum (fig 5).

use crate::experiments::described::{extent, with_points};
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::map_figures::{least_peak_line, peak_velocity};
use crate::experiments::simulations::{LeastPeak, SimulatedPoint};
use crate::experiments::{Drawer, SceneOutcome, Words};
use crate::scene::cited;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{HeatMap, Line, LineRole, Series};

pub(crate) const FIGURES: &[Drawer] = &[
    ("fig-5a", |outcome, words| map(outcome.potentially_unstable()?, words)),
    ("fig-5b", |outcome, words| curves(outcome.potentially_unstable()?, EvolutionLaw::Slip, words)),
    ("fig-5b-aging", |outcome, words| curves(outcome.potentially_unstable()?, EvolutionLaw::Aging, words)),
];

/// The velocity at which the paper normalises, 10^−5.5 m/s.
const NORMAL_VELOCITY: f64 = 3.162_277_660_168_379_5e-6;

/// The grid's column nearest to the velocity of normalisation, if it is that velocity to a tenth of a percent.
fn normal_column(grid: &Grid<SimulatedPoint>) -> Option<usize> {
    grid.loading_velocity_m_per_s.iter().position(|velocity| (velocity / NORMAL_VELOCITY - 1.0).abs() < 1e-3)
}

/// Peak velocity of each limit cycle over that at 10^−5.5 m/s on the same row; 0 where either is missing.
fn normalised(grid: &Grid<SimulatedPoint>) -> Option<Vec<f64>> {
    let column = normal_column(grid)?;
    let row = |row: &[SimulatedPoint]| {
        let unit = peak_velocity(&row[column]);
        row.iter().map(|point| if unit > 0.0 { peak_velocity(point) / unit } else { 0.0 }).collect::<Vec<_>>()
    };
    Some(grid.values.chunks(grid.loading_velocity_m_per_s.len()).flat_map(row).collect())
}

fn map(scene: &SceneOutcome, words: &mut Words) -> Option<String> {
    let outcome = scene.simulations.as_ref()?;
    let (law, grid) = outcome.grids.first()?;
    let (x, mut y) = axes(grid)?;
    let columns = grid.loading_velocity_m_per_s.len();
    // Rows without a limit cycle at the velocity of normalisation have nothing to show.
    let all = normalised(grid)?;
    let first = all.iter().position(|value| *value > 0.0)? / columns;
    let values = all[first * columns..].to_vec();
    y.min = grid.normal_stress_pa[first];
    let shown = Grid {
        loading_velocity_m_per_s: grid.loading_velocity_m_per_s.clone(),
        normal_stress_pa: grid.normal_stress_pa[first..].to_vec(),
        values: grid.values[first * columns..].to_vec(),
    };
    let said = scene.boundary.as_ref().map(|boundary| simulated_readout(&shown, boundary));
    words.fill(&[("law", law.as_str())]);
    let eq18 = |stress: f64| {
        let slider = scene.slider()?.map(nearest_f64);
        Some(Asymptote::InertialUpper.value(&slider, &stress))
    };
    let asymptote = Line::new(
        cited("{inertial-upper}"),
        LineRole::Asymptote,
        vec![(eq18(y.min)?, y.min), (eq18(y.max)?, y.max)],
    );
    let (from, to) = (x.min, x.max);
    let sections = chosen(&outcome.least_peaks, *law).into_iter().map(|least| {
        let stress = least.normal_stress_pa;
        Line::new("normal stresses of fig 5b", LineRole::Section, vec![(from, stress), (to, stress)])
    });
    let lines = sections.chain([asymptote, least_peak_line(outcome, *law)]).collect();
    let mut map = HeatMap { columns, values, lines, x, y, ..words.drawing()? };
    let (low, _) = extent(map.values.iter().copied().filter(|value| *value > 0.0))?;
    map.colours.min = libm::exp10((5.0 * libm::log10(low)).floor() / 5.0);
    Some(map.svg_with(said.as_ref()))
}

/// Normal stresses drawn as curves: every second of the grid's, counted down from the highest.
const EVERY: usize = 2;

/// The most curves of one chart: the styles that can be distinguished, less one for the minima.
const CURVES: usize = 5;

fn curves(scene: &SceneOutcome, law: EvolutionLaw, words: &Words) -> Option<String> {
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(of, _)| *of == law)?;
    let of_law: Vec<&LeastPeak> = outcome.least_peaks.iter().filter(|least| least.law == law).collect();
    let chosen = chosen(&outcome.least_peaks, law);
    let mut series: Vec<Series> = chosen.iter().filter_map(|least| curve(grid, least)).collect();
    let minima = of_law.iter().filter_map(|least| {
        Some((libm::exp10(least.offset_dex), least.least_m_per_s / unit_peak(grid, least.normal_stress_pa)?))
    });
    let mut chart = with_points(words.drawing()?, [minima.collect()])?;
    series.append(&mut chart.series);
    let inside =
        series.iter().flat_map(|line| &line.points).filter(|at| at.0 > chart.x.min && at.0 < chart.x.max);
    let (low, high) = extent(inside.map(|at| at.1))?;
    (chart.y.min, chart.y.max) = (0.8 * low, 1.25 * high);
    chart.series = series;
    (!chosen.is_empty()).then(|| chart.svg())
}

/// The normal stresses whose curves are drawn.
fn chosen(least_peaks: &[LeastPeak], law: EvolutionLaw) -> Vec<&LeastPeak> {
    least_peaks.iter().filter(|least| least.law == law).rev().skip(1).step_by(EVERY).take(CURVES).collect()
}

/// The row of the grid at a normal stress.
fn row(grid: &Grid<SimulatedPoint>, stress: f64) -> Option<&[SimulatedPoint]> {
    let index = grid.normal_stress_pa.iter().position(|at| *at == stress)?;
    grid.values.chunks(grid.loading_velocity_m_per_s.len()).nth(index)
}

fn unit_peak(grid: &Grid<SimulatedPoint>, stress: f64) -> Option<f64> {
    let unit = peak_velocity(row(grid, stress)?.get(normal_column(grid)?)?);
    (unit > 0.0).then_some(unit)
}

/// The grid's row and the samples of the minimisation as one curve.
fn curve(grid: &Grid<SimulatedPoint>, least: &LeastPeak) -> Option<Series> {
    let unit = unit_peak(grid, least.normal_stress_pa)?;
    let on_grid = grid.loading_velocity_m_per_s.iter().zip(row(grid, least.normal_stress_pa)?);
    let on_grid = on_grid.map(|(velocity, at)| (velocity / least.eq18_velocity_m_per_s, peak_velocity(at)));
    let samples = least.samples.iter().map(|&(offset, peak)| (libm::exp10(offset), peak));
    let minimum = std::iter::once((libm::exp10(least.offset_dex), least.least_m_per_s));
    let cycles = on_grid.chain(samples).chain(minimum).filter(|point| point.1 > 0.0);
    let mut points: Vec<(f64, f64)> = cycles.map(|(velocity, peak)| (velocity, peak / unit)).collect();
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    Some(Series::points(
        format!("*σ* = 10^{{{}}} Pa", round_digits(libm::log10(least.normal_stress_pa), 3)),
        points,
    ))
}
