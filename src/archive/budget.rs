//! What an archive of unknown origin may ask of the machine that replays it, and what its scenes ask for.

use crate::experiments::Scene;
use crate::experiments::boundary::BoundarySection;
use crate::experiments::simulations::SimulationsSection;
use crate::experiments::speed_counts::SpeedCountsSection;
use crate::experiments::trajectories::TrajectoryPoint;
use crate::scene::{LogAxis, Rectangle};
use slipmode_core::number::{Rational, nearest_f64};

/// The most that a replay may take. The defaults are about ten times what the largest published report takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Estimated work of all scenes together, in seconds of one core.
    pub core_seconds: f64,
    /// Memory, estimated and measured, in MiB.
    pub memory_mib: f64,
    /// Measured time, in seconds.
    pub seconds: f64,
    /// Digits of one number in an input file.
    pub input_digits: f64,
    /// Certified digits of one result.
    pub result_digits: f64,
}

impl Default for Budget {
    fn default() -> Self {
        Self {
            core_seconds: 900.0,
            memory_mib: 2048.0,
            seconds: 3600.0,
            input_digits: 1000.0,
            result_digits: 20_000.0,
        }
    }
}

/// What one section of a scene asks for.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// The scene and the section, `scenes/a.toml: boundary`.
    pub place: String,
    /// What is asked for, in words.
    pub what: String,
    /// Estimated work, in seconds of one core.
    pub core_seconds: f64,
    /// Estimated memory, in MiB.
    pub memory_mib: f64,
    /// Certified digits of one result.
    pub digits: f64,
}

impl Budget {
    /// All limits times a factor.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        let Self { core_seconds, memory_mib, seconds, input_digits, result_digits } = self;
        Self {
            core_seconds: core_seconds * factor,
            memory_mib: memory_mib * factor,
            seconds: seconds * factor,
            input_digits: input_digits * factor,
            result_digits: result_digits * factor,
        }
    }

    /// The limits in words.
    #[must_use]
    pub fn text(&self) -> String {
        let Self { core_seconds, memory_mib, seconds, input_digits, result_digits } = self;
        format!(
            "{core_seconds} s of estimated work on one core, {memory_mib} MiB of memory, {seconds} s of time, \
             {input_digits} digits of a number in an input, {result_digits} digits of a result"
        )
    }

    /// Why these requests go beyond the budget, one line for each limit.
    #[must_use]
    pub fn faults(&self, requests: &[Request]) -> Vec<String> {
        let work =
            sum_fault(requests, |request| request.core_seconds, self.core_seconds, "s of work on one core");
        let memory = sum_fault(requests, |request| request.memory_mib, self.memory_mib, "MiB of memory");
        let digits = requests.iter().find(|request| request.digits > self.result_digits).map(|request| {
            format!("{}: {} (budget: {} digits of a result)", request.place, request.what, self.result_digits)
        });
        [work, memory, digits].into_iter().flatten().collect()
    }

    /// The first number of a text with more digits than the budget has.
    #[must_use]
    pub fn digits_fault(&self, path: &str, text: &str) -> Option<String> {
        let longest = |line: &str| -> usize {
            let runs = line.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '_');
            runs.map(|run| run.bytes().filter(u8::is_ascii_digit).count()).max().unwrap_or(0)
        };
        let (line, digits) =
            (1..).zip(text.lines().map(longest)).find(|(_, count)| *count as f64 > self.input_digits)?;
        Some(format!("{path}:{line}: a number of {digits} digits (budget: {})", self.input_digits))
    }
}

/// The fault of an amount whose sum over all requests is more than allowed.
fn sum_fault(
    requests: &[Request],
    amount: impl Fn(&Request) -> f64,
    most: f64,
    unit: &str,
) -> Option<String> {
    let total: f64 = requests.iter().map(&amount).sum();
    let largest = requests.iter().max_by(|one, other| amount(one).total_cmp(&amount(other)))?;
    let Request { place, what, .. } = largest;
    let [share, all] = [amount(largest), total].map(libm::ceil);
    (total > most)
        .then(|| format!("{place}: {what} take about {share} {unit}, all sections {all} (budget: {most})"))
}

/// Core-seconds of one decision in a map, measured and rounded up; so are the others.
const DECISION: f64 = 5e-6;
/// Core-seconds of a simulation to 1e-8.
const RUN: f64 = 5e-3;
/// Core-seconds of a boundary point of few digits, and the factor of its digits to the power 3/2.
const BOUNDARY_POINT: [f64; 2] = [1e-4, 2e-8];
/// MiB of a point of a map or of a simulation.
const POINT_MIB: f64 = 200.0 / (1 << 20) as f64;
/// Simulations of one search along a line.
const SEARCH_RUNS: f64 = 200.0;

/// What the scenes ask for; sections that only name files ask for nothing.
#[must_use]
pub fn requests(scenes: &[Scene]) -> Vec<Request> {
    scenes.iter().flat_map(scene_requests).collect()
}

/// What a section asks for.
struct Asked {
    section: &'static str,
    what: String,
    core_seconds: f64,
    /// Points that are kept.
    kept: f64,
    digits: f64,
}

fn scene_requests(scene: &Scene) -> Vec<Request> {
    let request = |Asked { section, what, core_seconds, kept, digits }: Asked| Request {
        place: format!("scenes/{}.toml: {section}", scene.name),
        what,
        core_seconds,
        memory_mib: kept * POINT_MIB,
        digits,
    };
    plane_requests(scene).into_iter().chain(simulation_requests(scene)).map(request).collect()
}

/// Points of one kind, all kept.
fn points(section: &'static str, points: f64, seconds_per_point: f64) -> Asked {
    let (what, core_seconds) = (format!("{points} points"), points * seconds_per_point);
    Asked { section, what, core_seconds, kept: points, digits: 0.0 }
}

/// Sections about the linear theory.
fn plane_requests(scene: &Scene) -> Vec<Asked> {
    let rectangle = |section, rectangle: &Rectangle| points(section, rectangle_points(rectangle), DECISION);
    let map = scene.map.as_ref().map(|section| rectangle("map", &section.rectangle));
    let zones = scene.zones.as_ref().map(|section| rectangle("zones", &section.rectangle));
    let lines = scene.frequency.as_ref().map(|section| {
        let lines = section.normal_stress_over_critical.len() as f64;
        points("frequency", axis_points(&section.loading_velocity_m_per_s) * lines, DECISION)
    });
    let ratios = scene.effect_ratio_sweep.as_ref().map(|section| {
        let ratios = axis_points(&section.effect_ratio) + 2.0 * section.near_equal.len() as f64;
        points("effect_ratio_sweep", ratios, 10.0 * point_of(0.0))
    });
    let boundary = scene.boundary.map(boundary);
    let counts = scene.speed_counts.as_ref().map(speed_counts);
    [map, zones, boundary, lines, ratios, counts].into_iter().flatten().collect()
}

fn boundary(section: BoundarySection) -> Asked {
    // On each of two arcs.
    let (points, digits) = (f64::from(section.points) * 2.0, f64::from(section.digits));
    let what = format!("{points} points of {digits} digits");
    let kept = points * (5.0 + digits / 20.0);
    Asked { section: "boundary", what, core_seconds: points * point_of(digits), kept, digits }
}

/// Core-seconds of a boundary point of this many digits.
fn point_of(digits: f64) -> f64 {
    let [least, factor] = BOUNDARY_POINT;
    least + factor * digits * libm::sqrt(digits)
}

fn speed_counts(section: &SpeedCountsSection) -> Asked {
    let decided = f64::from(section.points) + f64::from(section.textbook_points) * 10.0;
    let of_digits: f64 = section.digits.iter().map(|digits| point_of(f64::from(*digits))).sum();
    let runs =
        f64::from(section.sweep_side) * f64::from(section.sweep_side) * section.tolerances.len() as f64;
    Asked {
        section: "speed_counts",
        what: format!("{decided} points and {runs} simulations"),
        core_seconds: decided * DECISION + f64::from(section.cubics) * of_digits + runs * RUN,
        kept: decided / 10.0,
        digits: f64::from(section.digits.iter().copied().max().unwrap_or(0)),
    }
}

/// Sections about the nonlinear slider.
fn simulation_requests(scene: &Scene) -> Vec<Asked> {
    let mut found = Vec::new();
    let mut add =
        |section, runs: f64, tolerance: &Rational| found.push(simulations(section, runs, tolerance));
    let eight_digits = Rational::from((1, 100_000_000));
    if let Some(SimulationsSection { rectangle, laws, tolerance }) = &scene.simulations {
        add("simulations", rectangle_points(rectangle) * laws.len() as f64, tolerance);
    }
    if let Some(section) = &scene.trajectories {
        let runs = section.points.iter().map(|TrajectoryPoint { laws, .. }| laws.len()).sum::<usize>();
        add("trajectories", runs as f64, &section.tolerance);
    }
    if let Some(section) = &scene.linear_regime {
        let runs = section.points.len() as f64 * section.laws.len() as f64 * section.amplitudes.len() as f64;
        add("linear_regime", runs * 3.0, &eight_digits);
    }
    if let Some(section) = &scene.start_sensitivity {
        add(
            "start_sensitivity",
            section.points.len() as f64 * section.laws.len() as f64 * 4.0,
            &section.tolerance,
        );
    }
    if let Some(section) = &scene.onset {
        let runs = SEARCH_RUNS * section.laws.len() as f64 + section.velocity_over_asymptote.len() as f64;
        add("onset", runs * section.normal_stress_pa.len() as f64, &section.tolerance);
    }
    if let Some(section) = &scene.near_transition {
        let grid = section.inertial_parameter.len() as f64 * section.stiffness_over_critical.len() as f64;
        let runs = (grid + section.edge_inertial_parameter.len() as f64) * 10.0;
        add("near_transition", runs, &section.tolerance);
    }
    if let Some(section) = &scene.original_scheme {
        let steps: f64 = section.steps.iter().map(|step| 1.0 / nearest_f64(step)).sum();
        let places = rectangle_points(&section.rectangle) + section.places.len() as f64;
        let searched = section.least_peak_stresses_pa.len() as f64 * SEARCH_RUNS;
        add("original_scheme", (places + searched) * steps, &eight_digits);
    }
    if let Some(section) = &scene.work_precision {
        add("work_precision", section.places.len() as f64 * SEARCH_RUNS, &eight_digits);
    }
    if let Some(section) = &scene.error_bound {
        for tolerance in &section.tolerances {
            add("error_bound", f64::from(section.groups) * 2.0, tolerance);
        }
    }
    found
}

/// Runs of the nonlinear slider: a run takes 1.26 times as long for each further digit.
fn simulations(section: &'static str, runs: f64, tolerance: &Rational) -> Asked {
    let tolerance = nearest_f64(tolerance);
    let core_seconds = runs * RUN * libm::pow(tolerance / 1e-8, -0.1);
    let what = format!("{runs} simulations at tolerance {tolerance:e}");
    Asked { section, what, core_seconds, kept: runs, digits: 0.0 }
}

fn axis_points(axis: &LogAxis) -> f64 {
    f64::from(axis.points)
}

fn rectangle_points(rectangle: &Rectangle) -> f64 {
    axis_points(&rectangle.loading_velocity_m_per_s) * axis_points(&rectangle.normal_stress_pa)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Limits;

    fn faults(sections: &str) -> Vec<String> {
        let slider = "name = \"a\"\ntitle = \"A\"\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
            critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";
        let text = format!("{slider}{sections}");
        let scene = Scene::parse("a.toml", text.as_bytes(), &Limits::default()).unwrap();
        Budget::default().faults(&requests(&[scene]))
    }

    const AXES: &str = "loading_velocity_m_per_s = { from = 1e-6, to = 1e-1, points = 1000 }\n\
        normal_stress_pa = { from = 1e2, to = 1e8, points = 1000 }\n";

    #[test]
    fn the_fault_names_the_section_that_asks_for_most() {
        assert!(faults(&format!("[map]\n{AXES}")).is_empty());
        for (section, words) in [
            (
                format!("[map]\n{AXES}[simulations]\n{AXES}laws = [\"slip\", \"aging\"]\ntolerance = 1e-15\n"),
                "scenes/a.toml: simulations: 2000000 simulations at tolerance 1e-15",
            ),
            ("[boundary]\npoints = 2\ndigits = 1000000\n".into(), "boundary: 4 points of 1000000 digits (budget: 20000 digits of a result)"),
            ("[boundary]\npoints = 4000000\ndigits = 20\n".into(), "boundary: 8000000 points of 20 digits"),
            (
                "[start_sensitivity]\npoints = [{ loading_velocity_m_per_s = 1, normal_stress_pa = 1 }]\n\
                 laws = [\"slip\"]\ntolerance = 1e-15\n[effect_ratio_sweep]\neffect_ratio = { from = 1, to = 2, points = 1000000 }\n"
                    .into(),
                "effect_ratio_sweep: 1000000 points",
            ),
        ] {
            let found = faults(&section);
            assert!(found.first().is_some_and(|fault| fault.contains(words)), "{words}: {found:?}");
        }
    }

    #[test]
    fn the_largest_published_report_takes_a_tenth_of_the_budget() {
        let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/reports/im-avouac/scenes");
        let parse = |entry: std::io::Result<std::fs::DirEntry>| {
            let bytes = std::fs::read(entry.unwrap().path()).unwrap();
            Scene::parse("a.toml", &bytes, &Limits::default()).unwrap()
        };
        let scenes: Vec<Scene> = std::fs::read_dir(scenes).unwrap().map(parse).collect();
        let faults = Budget::default().times(0.1).faults(&requests(&scenes));
        // The chapter on speed asks for results of 10 000 digits, half of the budget.
        assert!(faults.iter().all(|fault| fault.contains("digits of a result")), "{faults:?}");
        assert!(Budget::default().times(0.5).faults(&requests(&scenes)).is_empty());
    }

    #[test]
    fn the_budget_counts_digits_and_grows_by_its_factor() {
        let budget = Budget::default();
        let text = format!("a = 1\nb = 0.{}\n", "1".repeat(5000));
        assert_eq!(
            budget.digits_fault("a.toml", &text).unwrap(),
            "a.toml:2: a number of 5001 digits (budget: 1000)"
        );
        assert_eq!(budget.times(10.0).digits_fault("a.toml", &text), None);
        assert!(budget.text().starts_with("900 s of estimated work"));
    }
}
