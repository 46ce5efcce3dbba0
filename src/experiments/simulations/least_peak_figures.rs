//! Normalised peak velocities and their minimum (fig 5).

use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::axes;
use crate::experiments::shared::map_readout::simulated_readout;
use crate::experiments::simulations::map_figure::{least_peak_line, peak_velocity};
use crate::experiments::simulations::{LeastPeak, SimulatedPoint};
use crate::experiments::{Figure, FigureMaker, Need, SceneOutcome};
use crate::scene::cited;
use slipmode_core::friction::EvolutionLaw;
use slipmode_core::number::format::round_digits;
use slipmode_core::number::nearest_f64;
use slipmode_core::stability::Asymptote;
use slipmode_plot::figure::{
    Axis, Caption, ColourScale, HeatMap, Line, LineChart, LineRole, Reference, Series,
};

pub(crate) const FIGURES: &[FigureMaker] = &[
    FigureMaker::new("fig-5a", &[Need::Simulations], &["simulations", "least-peaks"], |outcome| {
        map(outcome.potentially_unstable()?)
    }),
    FigureMaker::new("fig-5b", &[Need::Simulations], &["simulations", "least-peaks"], |outcome| {
        curves(outcome.potentially_unstable()?, EvolutionLaw::Slip, "fig-5b", "Figure 5b")
    }),
    FigureMaker::new("fig-5b-aging", &[Need::Simulations], &["simulations", "least-peaks"], |outcome| {
        curves(outcome.potentially_unstable()?, EvolutionLaw::Aging, "fig-5b-aging", "Figure 5b, aging law")
    }),
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

const MAP: &str = "Map over loading velocity and normal stress of the peak velocity divided by that at the lowest loading velocities. From left to right it falls to a flat minimum close to the line of {inertial-upper} and rises steeply beyond it.";

fn map(scene: &SceneOutcome) -> Option<Figure> {
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
        values: grid.values[first * columns..].iter().collect::<Vec<_>>(),
    };
    let said = scene.boundary.as_ref().map(|boundary| simulated_readout(&shown, boundary));
    let low = values.iter().copied().filter(|value| *value > 0.0).fold(f64::INFINITY, f64::min);
    let law_word = law.as_str();
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
    let title = format!("Peak velocity divided by that at 10^−5.5 m/s, {law_word} law, a < b");
    let map = HeatMap {
        caption: Caption::new("fig-5a", &title, &cited(MAP)),
        columns,
        colours: ColourScale::new(
            "Normalised peak",
            "",
            (libm::exp10((5.0 * libm::log10(low)).floor() / 5.0), BRIGHTEST),
            STEPS,
        ),
        values,
        zero_areas: Vec::new(),
        zero_label: String::new(),
        lines: sections.chain([asymptote, least_peak_line(outcome, *law)]).collect(),
        marks: Vec::new(),
        x,
        y,
    };
    Some(Figure::new(
        &map.caption,
        "Figure 5a",
        &cited(&format!(
            "Peak velocity of the limit cycle with the {law_word} law, divided by that at 10⁻⁵·⁵ m/s and the same normal stress (compare fig 5a of the paper). The dashed line is {{inertial-upper}}. The dotted line joins the minima found by minimisation, which the paper does not have: it reads the minimum off the colours. The paper colours its lines of constant normal stress one by one."
        )),
        map.svg_with(said.as_ref()),
    ))
}

/// Normalised peak that takes the brightest colour, with all above it: the valley is what the figure is about.
const BRIGHTEST: f64 = 2.0;

/// Colour steps of the map.
const STEPS: usize = 30;

/// Normal stresses drawn as curves: every second of the grid's, counted down from the highest.
const EVERY: usize = 2;

/// The most curves of one chart: the styles that can be distinguished, less one for the minima.
const CURVES: usize = 5;

/// Range of the chart in units of the velocity of eq 18.
const LOWEST: f64 = 1e-2;
const HIGHEST: f64 = 10.0;

fn curves(scene: &SceneOutcome, law: EvolutionLaw, id: &str, label: &str) -> Option<Figure> {
    let outcome = scene.simulations.as_ref()?;
    let (_, grid) = outcome.grids.iter().find(|(of, _)| *of == law)?;
    let of_law: Vec<&LeastPeak> = outcome.least_peaks.iter().filter(|least| least.law == law).collect();
    let chosen = chosen(&outcome.least_peaks, law);
    let mut series: Vec<Series> = chosen.iter().filter_map(|least| curve(grid, least)).collect();
    let minima = of_law.iter().filter_map(|least| {
        Some((libm::exp10(least.offset_dex), least.least_m_per_s / unit_peak(grid, least.normal_stress_pa)?))
    });
    series.push(Series::points("minima at all normal stresses", minima.collect()));
    let heights = || series.iter().flat_map(|line| &line.points).filter(|p| p.0 > LOWEST && p.0 < HIGHEST);
    let (low, high) =
        (heights().map(|p| p.1).fold(f64::INFINITY, f64::min), heights().map(|p| p.1).fold(0.0, f64::max));
    let description = format!(
        "Normalised peak velocity with the {} law against loading velocity divided by that of {{inertial-upper}}, for several normal stresses. Every curve falls to a flat minimum near 1 and rises beyond it.",
        law.as_str()
    );
    let title = cited(&format!(
        "Normalised peak velocity against V_l divided by that of {{inertial-upper}}, {} law",
        law.as_str()
    ));
    let chart = LineChart {
        caption: Caption::new(id, &title, &description),
        x: Axis::log10(&cited("*V*_l / velocity of {inertial-upper}"), "", LOWEST, HIGHEST),
        y: Axis::linear("Peak velocity / that at 10^{−5.5} m/s", "", 0.8 * low, 1.25 * high),
        series,
        references: vec![Reference::Vertical { at: 1.0, label: cited("{inertial-upper}") }],
    };
    let caption = cited(&format!(
        "Normalised peak velocity of the limit cycle with the {} law against the loading velocity divided by that of {{inertial-upper}} (compare fig 5b of the paper), with the minima found by minimisation. Every marker is a converged run. The paper joins the runs of its grid by lines and has no minima between them.",
        law.as_str()
    ));
    (!chosen.is_empty()).then(|| Figure::new(&chart.caption, label, &caption, chart.svg()))
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
    let on_grid = grid
        .loading_velocity_m_per_s
        .iter()
        .zip(row(grid, least.normal_stress_pa)?)
        .map(|(velocity, point)| (velocity / least.eq18_velocity_m_per_s, peak_velocity(point)));
    let samples = least.samples.iter().map(|&(offset, peak)| (libm::exp10(offset), peak));
    let minimum = std::iter::once((libm::exp10(least.offset_dex), least.least_m_per_s));
    let mut points: Vec<(f64, f64)> = on_grid
        .chain(samples)
        .chain(minimum)
        .filter(|point| point.1 > 0.0)
        .map(|(velocity, peak)| (velocity, peak / unit))
        .collect();
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    Some(Series::points(
        format!("*σ* = 10^{{{}}} Pa", round_digits(libm::log10(least.normal_stress_pa), 3)),
        points,
    ))
}
