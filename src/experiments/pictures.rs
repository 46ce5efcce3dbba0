//! Pictures that a command draws by itself: the boundary, the slip modes of a grid, and a trajectory. `pictures.toml` describes them.

use crate::experiments::described::{extent, over, picture};
use crate::experiments::map::figures::zero_areas;
use crate::experiments::shared::Grid;
use crate::experiments::shared::axes::{
    asymptote_lines, axes, boundary_lines, cusp_mark, pair_line, plane, transition_line,
};
use crate::experiments::shared::bands::{FINE, band_lines};
use crate::experiments::trajectories::curves::stress_unit;
use crate::experiments::trajectories::{DRAWING_TOLERANCE, Moment};
use crate::experiments::zones::figures::present_zones;
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;
use slipmode_core::stability::boundary::BoundaryPoint;
use slipmode_core::stability::{InertialThreshold, PairRatio, ParameterBox, SlipMode};
use slipmode_plot::figure::{Axis, Line, Panels, Scale, Series, ZoneMap, kept};

/// Below this velocity, relative to the largest, a logarithmic axis of velocity ends.
const SLOWEST: f64 = 1e-30;

/// The exact boundary with its asymptotes and the transition, over a rectangle of loading velocities and normal stresses.
///
/// With error bars, the bands are below the lines of the middle values. With a ratio, its line is drawn too.
pub(crate) fn boundary_picture(
    slider: &Slider<Rational>,
    points: &[BoundaryPoint],
    (error_bars, ratio): (Option<&ParameterBox>, Option<&PairRatio>),
    velocity: (f64, f64),
    stress: (f64, f64),
) -> String {
    let (x, y) = plane(velocity, stress);
    let bands = error_bars.map_or_else(Vec::new, |region| band_lines(region, &x, &y, FINE));
    let of_ratio = ratio.map(|ratio| pair_line(slider, ratio));
    let lines = bands.into_iter().chain(theory_lines(slider, points, &x, &y)).chain(of_ratio).collect();
    let mut map = ZoneMap { lines, marks: cusp_mark(points), x, y, ..picture("boundary") };
    for zone in &mut map.zones {
        zone.outlines = zero_areas(points, &map.x, &map.y);
    }
    map.svg()
}

/// The slip modes of a grid with the exact boundary, its asymptotes and the transition; none for an empty grid.
pub(crate) fn mode_picture(
    slider: &Slider<Rational>,
    modes: &Grid<SlipMode>,
    points: &[BoundaryPoint],
    threshold: &InertialThreshold,
) -> Option<String> {
    let (x, y) = axes(modes)?;
    let line = pair_line(slider, &PairRatio::Frequency(threshold.clone()));
    let zones = present_zones(modes.values.iter().copied(), modes.loading_velocity_m_per_s.len(), &x, &y);
    let lines = theory_lines(slider, points, &x, &y).into_iter().chain([line]).collect();
    let map = ZoneMap { zones, lines, marks: cusp_mark(points), x, y, ..picture("slip-modes") };
    Some(map.svg())
}

fn theory_lines(slider: &Slider<Rational>, points: &[BoundaryPoint], x: &Axis, y: &Axis) -> Vec<Line> {
    let mut lines = boundary_lines(points);
    lines.extend(asymptote_lines(slider, x, y));
    lines.extend(transition_line(slider, x, y));
    lines
}

/// Velocity, shear stress and slip of a run against time; none for a run without duration. The slip in m goes with each moment.
pub(crate) fn trajectory_picture(moments: &[(Moment, f64)], loading_velocity_m_per_s: f64) -> Option<String> {
    let end = moments.last()?.0.time_s;
    let velocity = |moment: &Moment| loading_velocity_m_per_s * libm::exp(moment.log_velocity_ratio);
    let (unit, size) = stress_unit(moments.iter().map(|(moment, _)| moment.stress_change_pa));
    let (slip_unit, slip_size) = slip_unit(moments.iter().map(|(_, slip)| *slip));
    let of_moment = |(moment, slip): &(Moment, f64)| {
        [moment.time_s, velocity(moment), moment.stress_change_pa / size, slip / slip_size]
    };
    let values: Vec<[f64; 4]> = moments.iter().map(of_moment).collect();
    let of = |index: usize| values.iter().map(move |value| value[index]);
    let mut panels: Panels = picture("trajectory");
    for (panel, (index, unit)) in panels.panels.iter_mut().zip((1..).zip(["m/s", unit, slip_unit])) {
        panel.x.max = end;
        panel.y.unit = unit.into();
        if panel.y.scale == Scale::Log10 {
            let (slowest, fastest) = extent(of(index))?;
            (panel.y.min, panel.y.max) = ((0.5 * slowest).max(SLOWEST * fastest), 2.0 * fastest);
        }
        panel.y = over(&panel.y, of(index))?;
        panel.series = vec![Series::line("", thinned(&values, index, &panel.y))];
    }
    (end > 0.0).then(|| panels.svg())
}

/// The unit of a picture's slip, and its size in m: labels have few digits then.
fn slip_unit(values: impl Iterator<Item = f64>) -> (&'static str, f64) {
    let largest = values.map(f64::abs).fold(0.0, f64::max);
    let units = [("m", 1.0), ("mm", 1e-3), ("µm", 1e-6)];
    units.into_iter().find(|(_, size)| largest >= *size).unwrap_or(units[2])
}

/// The points of a curve that a drawing needs.
fn thinned(values: &[[f64; 4]], index: usize, axis: &Axis) -> Vec<(f64, f64)> {
    let is_logarithmic = index == 1;
    let height = |value: f64| if is_logarithmic { libm::log10(value.max(f64::MIN_POSITIVE)) } else { value };
    let (low, high) = (height(axis.min), height(axis.max));
    let end = values.last().map_or(1.0, |value| value[0]);
    let places: Vec<[f64; 2]> =
        values.iter().map(|value| [value[0] / end, (height(value[index]) - low) / (high - low)]).collect();
    let keep = kept(&places, |_, _, far| far <= DRAWING_TOLERANCE);
    let chosen = values.iter().zip(keep).filter(|(_, keep)| *keep);
    chosen.map(|(value, _)| (value[0], value[index])).collect()
}
