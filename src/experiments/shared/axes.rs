//! The (V, σ) plane of the maps: axes, and the lines of theory drawn over them.

use crate::experiments::boundary::END_ERROR;
use crate::experiments::shared::Grid;
use crate::scene::cited;
use slipmode_core::friction::{OperatingPoint, Slider};
use slipmode_core::number::format::exact_text;
use slipmode_core::number::{Ball, Rational, nearest_f64};
use slipmode_core::stability::boundary::{BoundaryPoint, Mark};
use slipmode_core::stability::{Arc, Asymptote, PairLine, PairRatio, asymptote};
use slipmode_plot::figure::{Axis, Line, LineRole, PointMark, Side};

/// Points that draw a line of given ω/ω_n, and their digits.
const LINE_POINTS: usize = 400;
const LINE_DIGITS: u32 = 10;

/// The axes of the plane over these loading velocities and normal stresses.
pub(crate) fn plane(velocity: (f64, f64), stress: (f64, f64)) -> (Axis, Axis) {
    let x = Axis::log10("Loading velocity *V*_0", "m/s", velocity.0, velocity.1);
    (x, Axis::log10("Normal stress *σ*", "Pa", stress.0, stress.1))
}

/// The two axes of a grid.
pub(crate) fn axes<T>(grid: &Grid<T>) -> Option<(Axis, Axis)> {
    let ends = |values: &[f64]| Some((*values.first()?, *values.last()?));
    Some(plane(ends(&grid.loading_velocity_m_per_s)?, ends(&grid.normal_stress_pa)?))
}

/// The exact boundary as lines, arc by arc, in drawing order.
pub(crate) fn boundary_lines(points: &[BoundaryPoint]) -> Vec<Line> {
    let line = |arc| Line::new("exact boundary max Im(*s*) = 0", LineRole::Boundary, arc_points(points, arc));
    let lines = [Arc::Upper, Arc::Lower].map(line).into_iter();
    lines.filter(|line| !line.points.is_empty()).collect()
}

/// The points of one arc, in drawing order.
pub(crate) fn arc_points(points: &[BoundaryPoint], arc: Arc) -> Vec<(f64, f64)> {
    points.iter().filter(|point| point.arc == arc).map(place).collect()
}

/// Where a point of the boundary lies.
pub(crate) fn place(point: &BoundaryPoint) -> (f64, f64) {
    (point.loading_velocity_m_per_s.to_f64(), point.normal_stress_pa.to_f64())
}

/// The line of a given ω/ω_n or damping ratio; points beyond the map draw no more of it.
pub(crate) fn pair_line(slider: &Slider<Rational>, ratio: &PairRatio) -> Line {
    let points = PairLine::new(slider, ratio, LINE_DIGITS).sample(LINE_POINTS, END_ERROR);
    let places =
        points.iter().map(|point| (point.loading_velocity_m_per_s.to_f64(), point.normal_stress_pa.to_f64()));
    let label = match ratio {
        PairRatio::Frequency(threshold) => {
            format!("(*ω*/*ω*_n)² = {}", exact_text(threshold.squared_ratio()))
        }
        PairRatio::Damping(ratio) => format!("*ζ* = {}", exact_text(ratio.value())),
    };
    Line::new(label, LineRole::FrequencyRatio, places.collect())
}

/// The cusp as a marked point.
pub(crate) fn cusp_mark(points: &[BoundaryPoint]) -> Vec<PointMark> {
    let cusps = points.iter().filter(|point| point.mark == Some(Mark::Cusp));
    cusps.map(|point| PointMark::new("cusp", place(point), Side::Right)).collect()
}

/// Eqs 15, 16, 18 and 20, each from the edge of the map to its corner.
pub(crate) fn asymptote_lines(parameters: &Slider<Rational>, x: &Axis, y: &Axis) -> Vec<Line> {
    let exists = |arc: &Arc| *arc == Arc::Lower || parameters.direct_effect != parameters.evolution_effect;
    let arcs = [Arc::Upper, Arc::Lower].into_iter().filter(exists);
    // In 64 bits: good enough to draw.
    let slider = parameters.map(|value| Ball::from_rational(value, 64).to_f64());
    arcs.flat_map(|arc| {
        let OperatingPoint { normal_stress_pa: corner_stress, loading_velocity_m_per_s: corner_velocity } =
            asymptote::corner(arc, &slider);
        // The inertial asymptote leaves the corner upwards on the upper arc, downwards on the lower one.
        let end_stress = if arc == Arc::Upper { y.max } else { y.min };
        let end_velocity = Asymptote::inertial(arc).value(&slider, &end_stress);
        [
            asymptote_line(vec![(x.min, corner_stress), (corner_velocity, corner_stress)]),
            asymptote_line(vec![(corner_velocity, corner_stress), (end_velocity, end_stress)]),
        ]
    })
    .collect()
}

fn asymptote_line(points: Vec<(f64, f64)>) -> Line {
    Line::new(
        cited("asymptotes, {quasi-static-upper, quasi-static-lower, inertial-upper, inertial-lower}"),
        LineRole::Asymptote,
        points,
    )
}

/// How many vertices draw the bend of K = K_c.
const TRANSITION_VERTICES: u32 = 160;

/// K = K_c (eq 9), which exists for b > a only.
pub(crate) fn transition_line(parameters: &Slider<Rational>, x: &Axis, y: &Axis) -> Option<Line> {
    if !parameters.has_transition() {
        return None;
    }
    let critical_velocity = nearest_f64(&parameters.critical_velocity_squared()).sqrt();
    let rounded = parameters.map(nearest_f64);
    let (low, high) = (libm::log10(x.min), libm::log10(critical_velocity));
    let points = (0..=TRANSITION_VERTICES)
        .map(|index| {
            // Vertices crowd towards V_c, where the line turns down: the distance from it halves evenly.
            let share = f64::from(index) / f64::from(TRANSITION_VERTICES);
            let velocity = libm::exp10(low + (high - low) * (1.0 - (1.0 - share) * (1.0 - share)));
            let velocity = velocity.min(critical_velocity * (1.0 - 1e-9));
            (velocity, rounded.transition_normal_stress_pa(&velocity))
        })
        .chain(std::iter::once((critical_velocity, y.min)))
        .filter(|(_, stress)| *stress > 0.0)
        .collect();
    Some(Line::new("transition *K* = *K*_c", LineRole::Transition, points))
}
