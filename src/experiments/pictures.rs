//! Pictures that a command draws by itself: the boundary, the slip modes of a grid, and a trajectory.

use crate::experiments::map::figures::zero_areas;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{
    asymptote_lines, axes, boundary_lines, cusp_mark, pair_line, transition_line,
};
use crate::experiments::shared::bands::{FINE, band_lines};
use crate::experiments::trajectories::curves::{extent, linear_axis, stress_unit};
use crate::experiments::trajectories::thinning::kept;
use crate::experiments::trajectories::{DRAWING_TOLERANCE, Moment};
use crate::experiments::zones::figures::present_zones;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_core::stability::{InertialThreshold, PairRatio, ParameterBox, SlipMode};
use slipmode_plot::figure::{Axis, Caption, Line, Panel, Panels, Reference, Series, Zone, ZoneMap};

/// Height of one chart of a trajectory, in canvas units.
const CHART_HEIGHT: f64 = 150.0;
/// Style of the areas without oscillation.
const QUIET_STYLE: usize = 5;
/// Below this velocity, relative to the largest, a logarithmic axis of velocity ends.
const SLOWEST: f64 = 1e-30;

/// The exact boundary with its asymptotes and the transition, over a rectangle of loading velocities and normal stresses.
///
/// With error bars, the bands are below the lines of the middle values. With a ratio, its line is drawn too.
#[must_use]
pub fn boundary_picture(
    slider: &Slider<Rational>,
    points: &[BoundaryPoint],
    (error_bars, ratio): (Option<&ParameterBox>, Option<&PairRatio>),
    velocity: (f64, f64),
    stress: (f64, f64),
) -> String {
    let x = Axis::log10("Loading velocity *V*_0", "m/s", velocity.0, velocity.1);
    let y = Axis::log10("Normal stress *σ*", "Pa", stress.0, stress.1);
    let description = "Loading velocity and normal stress, with the areas in which no disturbance oscillates, their exact edges, the asymptotes of these edges, and the transition to unstable sliding.";
    let quiet = Zone {
        label: "max Im(*s*) = 0 exactly".into(),
        outlines: zero_areas(points, &x, &y),
        style: QUIET_STYLE,
    };
    let bands = error_bars.map_or_else(Vec::new, |region| band_lines(region, &x, &y, FINE));
    let of_ratio = ratio.map(|ratio| pair_line(slider, ratio));
    let lines = bands.into_iter().chain(theory_lines(slider, points, &x, &y)).chain(of_ratio).collect();
    let map = ZoneMap {
        caption: Caption::new("boundary", "Exact boundary of oscillation", description),
        zones: vec![quiet],
        lines,
        marks: cusp_mark(points),
        labels: Vec::new(),
        x,
        y,
    };
    map.svg()
}

/// The slip modes of a grid with the exact boundary, its asymptotes and the transition; none for an empty grid.
#[must_use]
pub fn mode_picture(
    slider: &Slider<Rational>,
    modes: &Grid<SlipMode>,
    points: &[BoundaryPoint],
    threshold: &InertialThreshold,
) -> Option<String> {
    let (x, y) = axes(modes)?;
    let description = "Slip modes over loading velocity and normal stress, with the exact boundary of oscillation, its asymptotes, the transition to unstable sliding, and the line between inertial and non-inertial oscillation.";
    let line = pair_line(slider, &PairRatio::Frequency(threshold.clone()));
    let zones = present_zones(modes.values.iter().copied(), modes.loading_velocity_m_per_s.len(), &x, &y);
    let map = ZoneMap {
        caption: Caption::new("slip-modes", "Slip modes", description),
        zones,
        lines: theory_lines(slider, points, &x, &y).into_iter().chain([line]).collect(),
        marks: cusp_mark(points),
        labels: Vec::new(),
        x,
        y,
    };
    Some(map.svg())
}

fn theory_lines(slider: &Slider<Rational>, points: &[BoundaryPoint], x: &Axis, y: &Axis) -> Vec<Line> {
    let mut lines = boundary_lines(points);
    lines.extend(asymptote_lines(slider, x, y));
    lines.extend(transition_line(slider, x, y));
    lines
}

/// Velocity, shear stress and slip of a run against time; none for a run without duration. The slip in m goes with each moment.
#[must_use]
pub fn trajectory_picture(moments: &[(Moment, f64)], loading_velocity_m_per_s: f64) -> Option<String> {
    let end = moments.last()?.0.time_s;
    let velocity = |moment: &Moment| loading_velocity_m_per_s * libm::exp(moment.log_velocity_ratio);
    let (unit, size) = stress_unit(moments.iter().map(|(moment, _)| moment.stress_change_pa));
    let values: Vec<[f64; 4]> = moments
        .iter()
        .map(|(moment, slip)| [moment.time_s, velocity(moment), moment.stress_change_pa / size, *slip])
        .collect();
    let of = |index: usize| values.iter().map(move |value| value[index]);
    let (slowest, fastest) = extent(of(1))?;
    let y = [
        Axis::log10("Velocity *V*", "m/s", (0.5 * slowest).max(SLOWEST * fastest), 2.0 * fastest),
        linear_axis("Δ*τ*", unit, of(2))?,
        linear_axis("Slip", "m", of(3))?,
    ];
    let panel = |(index, y): (usize, Axis)| Panel {
        heading: vec![
            ["**velocity**", "**shear stress** relative to steady sliding", "**slip** since the start"]
                [index]
                .into(),
        ],
        x: Axis::linear("Time", "s", 0.0, end),
        series: vec![Series::line("", thinned(&values, index + 1, &y))],
        references: if index == 1 {
            vec![Reference::Horizontal { at: 0.0, label: String::new() }]
        } else {
            Vec::new()
        },
        y,
    };
    let description = "Three charts against time: the velocity of the slider on a logarithmic axis, the shear stress relative to steady sliding, and the slip since the start.";
    let panels = Panels {
        caption: Caption::new("trajectory", "Simulated run", description),
        columns: 1,
        height: CHART_HEIGHT,
        panels: y.into_iter().enumerate().map(panel).collect(),
    };
    (end > 0.0).then(|| panels.svg())
}

/// The points of a curve that a drawing needs.
fn thinned(values: &[[f64; 4]], index: usize, axis: &Axis) -> Vec<(f64, f64)> {
    let is_logarithmic = index == 1;
    let height = |value: f64| if is_logarithmic { libm::log10(value.max(f64::MIN_POSITIVE)) } else { value };
    let (low, high) = (height(axis.min), height(axis.max));
    let end = values.last().map_or(1.0, |value| value[0]);
    let places: Vec<[f64; 2]> =
        values.iter().map(|value| [value[0] / end, (height(value[index]) - low) / (high - low)]).collect();
    let keep = kept(&places, DRAWING_TOLERANCE);
    let chosen = values.iter().zip(keep).filter(|(_, keep)| *keep);
    chosen.map(|(value, _)| (value[0], value[index])).collect()
}
