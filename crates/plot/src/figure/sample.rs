//! Figures with the shapes of the paper's, for tests and for looking at: 64-bit closed forms, no part of any result.

use super::*;

/// a, b, D_c (m), K (Pa/m), M (kg/m²) of the paper's first figure.
const PAPER: [f64; 5] = [0.004, 0.006, 1e-5, 1e7, 1e3];

/// max Im(s) of eq. 8 by the closed formula, 0 where all roots are real.
fn max_imaginary_per_s(velocity: f64, stress: f64) -> f64 {
    let [a, b, d_c, k, m] = PAPER;
    let (eta, kappa) = (m * velocity * velocity / (stress * a * d_c), k * d_c / (a * stress));
    let (c2, c1, c0) = ((1.0 + eta) / eta, (kappa + 1.0 - b / a) / eta, kappa / eta);
    let (p, q) = (c1 - c2 * c2 / 3.0, 2.0 * c2 * c2 * c2 / 27.0 - c2 * c1 / 3.0 + c0);
    let disc = q * q / 4.0 + p * p * p / 27.0;
    if disc <= 0.0 {
        return 0.0;
    }
    let root = disc.sqrt();
    let (u, v) = (libm::cbrt(-q / 2.0 + root), libm::cbrt(-q / 2.0 - root));
    3.0_f64.sqrt() / 2.0 * (u - v).abs() * velocity / d_c
}

/// (V, σ) on the exact boundary at double root `r`.
fn boundary_point(r: f64) -> (f64, f64) {
    let [a, b, d_c, k, m] = PAPER;
    let beta = b / a;
    let square = (r + 1.0) * (r + 1.0);
    let eta = (beta - square) / (2.0 * r * square);
    let kappa = r * ((2.0 * r + 1.0) * beta - square) / (2.0 * square);
    let stress = k * d_c / (a * kappa);
    ((eta * stress * a * d_c / m).sqrt(), stress)
}

fn axes() -> (Axis, Axis) {
    let x = Axis::log10("Loading velocity *V*_0", "m/s", 1e-6, 1e-1);
    (x, Axis::log10("Normal stress *σ*", "Pa", 1e3, 1e8))
}

/// Upper and lower arc of the exact boundary.
fn arcs() -> [Vec<(f64, f64)>; 2] {
    let beta = PAPER[1] / PAPER[0];
    let end = beta.sqrt() - 1.0;
    let upper = (0..=400).map(|i| boundary_point(end * libm::exp10(-f64::from(i) / 80.0) * (1.0 - 1e-9)));
    let lower =
        (0..=400).map(|i| boundary_point(-(1.0 + beta.sqrt()) - 1e-7 * libm::exp10(f64::from(i) / 40.0)));
    [upper.collect(), lower.collect()]
}

fn theory_lines() -> Vec<Line> {
    let [a, b, d_c, k, m] = PAPER;
    let (root_a, root_b) = (a.sqrt(), b.sqrt());
    let eq15 = k * d_c / ((root_b - root_a) * (root_b - root_a));
    let eq16 = k * d_c / ((root_b + root_a) * (root_b + root_a));
    let corner18 = (b - a) * eq15 / (2.0 * (m * k).sqrt());
    let corner20 = a * eq16 / (2.0 * (m * k).sqrt());
    let transition = (0..=200).filter_map(|i| {
        let velocity = libm::exp10(-6.0 + f64::from(i) / 40.0);
        let stress = d_c / (b - a) * (k - (b - a) / a * m * velocity * velocity / (d_c * d_c));
        (stress > 0.0).then_some((velocity, stress))
    });
    let asymptotes = "asymptotes, eqs 15, 16, 18 and 20";
    let [upper, lower] = arcs();
    vec![
        Line::new("exact boundary max Im(*s*) = 0", LineRole::Boundary, upper),
        Line::new("exact boundary max Im(*s*) = 0", LineRole::Boundary, lower),
        Line::new("transition *K* = *K*_c", LineRole::Transition, transition.collect()),
        Line::new(asymptotes, LineRole::Asymptote, vec![(1e-6, eq15), (corner18, eq15)]),
        Line::new(asymptotes, LineRole::Asymptote, vec![(1e-6, eq16), (corner20, eq16)]),
        Line::new(asymptotes, LineRole::Asymptote, vec![(corner18, eq15), (corner18 * 1e3, eq15 * 1e3)]),
        Line::new(asymptotes, LineRole::Asymptote, vec![(corner20, eq16), (corner20 * 1e-3, eq16 * 1e-3)]),
    ]
}

fn label(lines: &[&str], x: f64, y: f64) -> RegionLabel {
    RegionLabel { lines: lines.iter().map(|&line| line.into()).collect(), x, y }
}

/// A map like figure 1, `size` points along each axis.
pub(crate) fn heat_map(size: usize) -> HeatMap {
    let (x, y) = axes();
    let at = |axis: &Axis, i: usize| axis.value_at(i as f64 / (size - 1) as f64).unwrap();
    let values = (0..size * size).map(|i| max_imaginary_per_s(at(&x, i % size), at(&y, i / size))).collect();
    let [mut upper, mut lower] = arcs();
    upper.push((1e-9, 1e12));
    upper.push((1e-9, upper[0].1));
    lower.push((1e-9, 1e-3));
    lower.push((1e-9, lower[0].1));
    HeatMap {
        caption: Caption::new(
            "fig-1",
            "Map of max Im(s) over loading velocity and normal stress",
            "The imaginary part rises towards high velocity and low stress up to 100 per second; it is exactly zero \
             in an area at high stress and in one at low stress, both at low velocity.",
        ),
        x,
        y,
        columns: size,
        values,
        colours: ColourScale {
            title: "max Im(*s*)".into(),
            unit: "1/s".into(),
            min: 0.01,
            max: 100.0,
            steps: 20,
            contours: vec![80.0, 95.0],
            contour_label: "80 and 95 /s".into(),
        },
        zero_areas: vec![upper, lower],
        zero_label: "max Im(*s*) = 0 exactly".into(),
        lines: theory_lines(),
        marks: vec![PointMark::new("cusp", (1.5964e-4, 5857.9), Side::Right)],
    }
}

/// A chart like figure 2.
pub(crate) fn frequency_chart() -> LineChart {
    let velocities = || (0..=250).map(|i| libm::exp10(-6.0 + f64::from(i) / 50.0));
    let series = |label: &str, stress: f64| {
        Series::line(label, velocities().map(|v| (v, max_imaginary_per_s(v, stress))).collect())
    };
    let ends = [1e-6, 1e-2].map(|v| (v, 0.5_f64.sqrt() * v * 1e5));
    LineChart {
        caption: Caption::new(
            "fig-2",
            "Angular frequency against loading velocity at three normal stresses",
            "All three curves reach the natural frequency; at the critical stress the curve follows equation 23.",
        ),
        x: axes().0,
        y: Axis::log10("max Im(*s*)", "1/s", 1e-2, 1e3),
        series: vec![
            series("*σ* = *σ*_c", 5e4),
            series("*σ* = 3 *σ*_c", 1.5e5),
            series("*σ* = *σ*_c / 3", 5e4 / 3.0),
            Series::of_theory("eq. 23", ends.to_vec()),
        ],
        references: vec![
            Reference::Horizontal { at: 100.0, label: "*ω*_n = 100 /s".into() },
            Reference::Vertical { at: 1.414e-3, label: "*V*_c".into() },
        ],
    }
}

/// A chart like that of an asymptote's signed error along its arc.
pub(crate) fn error_chart() -> LineChart {
    let scale = Scale::SignedLog10 { smallest: 1e-6 };
    let velocities = || (0..=40).map(|i| libm::exp10(-6.0 + f64::from(i) / 10.0));
    let series = |label: &str, factor: f64| Series {
        marked: factor > 0.0,
        ..Series::line(label, velocities().map(|v| (v, factor * v * v * 1e5)).collect())
    };
    LineChart {
        caption: Caption::new(
            "error",
            "Relative error of the asymptotes",
            "Both grow with the square of the velocity.",
        ),
        x: axes().0,
        y: Axis { scale, ..Axis::linear("*σ*_{exact}/*σ*_{15} − 1", "", -10.0, 10.0) },
        series: vec![series("eq. 15", 1.0), series("eq. 18", -0.3)],
        references: vec![
            Reference::Band { from: -0.1, to: 0.1, label: "within 10 %".into() },
            Reference::Band { from: -0.01, to: 0.01, label: "within 1 %".into() },
        ],
    }
}

/// A map like figure 7a.
pub(crate) fn zone_map(size: usize) -> ZoneMap {
    let (x, y) = axes();
    let at = |axis: &Axis, i: usize| axis.value_at(i as f64 / (size - 1) as f64).unwrap();
    let class = |i: usize| {
        let (velocity, stress) = (at(&x, i % size), at(&y, i / size));
        let frequency = max_imaginary_per_s(velocity, stress);
        let stable = 1e7 > 0.002 * stress / 1e-5 * (1.0 + 1e3 * velocity * velocity / (stress * 4e-8));
        match (stable, frequency) {
            (true, 0.0) => 0,
            (true, f) if f < 70.7 => 1,
            (true, _) => 2,
            (false, f) if f < 70.7 => 3,
            (false, _) => 4,
        }
    };
    let classes: Vec<usize> = (0..size * size).map(class).collect();
    let names = [
        "overdamped stable sliding",
        "non-inertial underdamped oscillation",
        "inertial underdamped oscillation",
        "stick-slip",
        "harmonic vibration",
    ];
    let zones = zones_of_grid(&x, &y, size, &classes, names.len());
    let zone = |(style, outlines): (usize, _)| Zone { label: names[style].into(), outlines, style };
    ZoneMap {
        caption: Caption::new("fig-7a", "Zones of slip modes, a < b", "Five zones."),
        zones: zones.into_iter().enumerate().map(zone).collect(),
        x,
        y,
        lines: theory_lines(),
        marks: vec![],
        labels: vec![
            label(&["(i) overdamped", "stable sliding"], 1e-5, 3e3),
            label(&["(ii) non-inertial", "underdamped"], 8e-6, 2.6e4),
            label(&["(iii) inertial", "underdamped"], 6e-4, 4e3),
            label(&["(iv) stick-slip"], 3e-5, 4e6),
            label(&["(v) harmonic", "vibration"], 2e-2, 2e5),
        ],
    }
}

/// A chart of where each asymptote is good enough.
pub(crate) fn range_chart() -> RangeChart {
    let row = |label: &str, detail: &str, ends: [f64; 3]| RangeRow {
        label: label.into(),
        detail: detail.into(),
        spans: ends.iter().enumerate().map(|(level, &to)| Span { from: 1e-9, to, level }).collect(),
    };
    RangeChart {
        caption: Caption::new(
            "good-enough",
            "Where each asymptote is accurate enough",
            "Stricter levels end earlier.",
        ),
        axis: Axis::log10("Loading velocity *V*_0", "m/s", 1e-6, 1e-1),
        levels: vec!["within 10 %".into(), "within 1 %".into(), "within 0.1 %".into()],
        rows: vec![
            row("eq. 15", "quasi-static, upper", [2e-3, 6e-4, 2e-4]),
            row("eq. 16", "quasi-static, lower", [4.5e-5, 1.4e-5, 4.5e-6]),
            row("eq. 18", "inertial, upper", [9e-2, 3e-2, 3e-3]),
        ],
    }
}

pub(crate) fn inset() -> Inset {
    let chart = frequency_chart();
    Inset {
        lines: heat_map(8).lines,
        series: chart.series,
        x: chart.x,
        y: Axis::log10("*σ*", "Pa", 1e2, 1e8),
    }
}
