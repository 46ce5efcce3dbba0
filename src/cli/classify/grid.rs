//! `classify` of a whole (V0, σ) grid: how many points have which class and slip mode, in constant memory.

use std::path::{Path, PathBuf};

use clap::Args;
use slipmode::scene::{Limits, LogAxis, LogCoordinates, Problem, Quantity, stem_of_key, unit_of};
use slipmode_core::friction::Slider;
use slipmode_core::number::Rational;
use slipmode_core::stability::batch::{GridAxis, StreamedGrid, Tally};
use slipmode_core::stability::{InertialThreshold, SlipMode, SpectralClass};

use crate::cli::answer::Answer;
use crate::cli::classify::rows::NEUTRAL;
use crate::cli::failure::Failure;
use crate::cli::inputs::slider_json;
use crate::cli::options::{Arguments, SliderOptions, option_of};
use crate::cli::output::Output;
use crate::cli::progress::Progress;

/// The most coordinates of an axis: 10^12 points take hours, not memory.
const MOST_COORDINATES: u64 = 1_000_000;

/// Options of a grid.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "Grid (counts of classes and slip modes, instead of one point)")]
pub struct GridOptions {
    /// N loading velocities from FROM to TO m/s, with equal logarithmic steps
    #[arg(long, value_name = "FROM:TO:N", allow_hyphen_values = true, conflicts_with = "points")]
    grid_loading_velocity: Option<String>,
    /// N normal stresses from FROM to TO Pa, with equal logarithmic steps
    ///
    /// Each axis may have 2 to 1 000 000 coordinates; memory does not grow with the number of points. Each coordinate is rounded to 64
    /// bits, and every point is then classified exactly.
    #[arg(long, value_name = "FROM:TO:N", allow_hyphen_values = true, conflicts_with = "points")]
    grid_normal_stress: Option<String>,
    /// Also draw the slip modes of the grid, with the exact boundary, the asymptotes, the transition, and the line of --inertial-threshold
    #[arg(long, value_name = "OUT.svg", conflicts_with = "points")]
    svg: Option<PathBuf>,
}

/// A grid as requested, valid.
#[derive(Debug)]
pub struct GridRequest {
    rows: Option<PathBuf>,
    svg: Option<PathBuf>,
    pub(super) slider: Slider<Rational>,
    pub(super) loading_velocities: LogAxis,
    pub(super) normal_stresses: LogAxis,
}

impl GridOptions {
    /// The options of a grid that is drawn.
    pub fn drawn(loading_velocity: &str, normal_stress: &str) -> Self {
        Self {
            grid_loading_velocity: Some(loading_velocity.to_string()),
            grid_normal_stress: Some(normal_stress.to_string()),
            svg: Some(PathBuf::new()),
        }
    }

    /// Whether a grid is requested.
    pub fn is_given(&self) -> bool {
        self.grid_loading_velocity.is_some() || self.grid_normal_stress.is_some()
    }

    /// Notes the options that need a grid, where there is none.
    pub fn refuse_without_grid(&self, arguments: &mut Arguments) {
        let needs = "--grid-loading-velocity and --grid-normal-stress: only a grid is drawn";
        arguments.refuse("--svg", self.svg.is_some(), needs);
    }

    /// The grid, whose rows go to a place; what is missing or faulty is collected in `arguments`.
    pub fn read(
        &self,
        slider: &SliderOptions,
        rows: Option<&Path>,
        json: bool,
        arguments: &mut Arguments,
    ) -> Option<GridRequest> {
        let fixed = slider.slider(arguments);
        for quantity in [Quantity::NormalStress, Quantity::LoadingVelocity] {
            let needs = "no grid: the grid's axes give this value";
            arguments.refuse_value(&option_of(quantity), slider.text(quantity), needs);
        }
        let velocities = axis(Quantity::LoadingVelocity, self.grid_loading_velocity.as_deref(), arguments);
        let stresses = axis(Quantity::NormalStress, self.grid_normal_stress.as_deref(), arguments);
        arguments.refuse_stream("--svg", self.svg.as_deref(), "something else");
        arguments.refuse_stream("--output", rows.filter(|_| json), "something else");
        let (velocities, stresses) = (velocities?, stresses?);
        let (points, limit) =
            (u64::from(velocities.points) * u64::from(stresses.points), Limits::default().max_points);
        if self.svg.is_some() && points > limit {
            let problem = Problem::Needs(format!("a grid of at most {limit} points"));
            return arguments.fault("--svg", None, problem);
        }
        Some(GridRequest {
            rows: rows.map(Path::to_path_buf),
            svg: self.svg.clone(),
            slider: fixed?,
            loading_velocities: velocities,
            normal_stresses: stresses,
        })
    }
}

/// Reads `FROM:TO:N`.
fn axis(quantity: Quantity, text: Option<&str>, arguments: &mut Arguments) -> Option<LogAxis> {
    let wanted = "FROM:TO:N, such as 1e2:1e9:1000";
    let option = &format!("--grid-{}", stem_of_key(quantity.as_str()).replace('_', "-"));
    let Some(text) = text else {
        return arguments.fault(option, None, Problem::Missing { allowed: wanted.into() });
    };
    let parts: Vec<&str> = text.split(':').collect();
    let [from, to, count] = parts[..] else {
        let problem = Problem::WrongType { wanted: wanted.into(), found: "another text" };
        return arguments.fault(option, Some(text), problem);
    };
    let mut end =
        |name: &str, text: &str| arguments.measured(&format!("{option}, {name}"), text, unit_of(quantity));
    let (from, to) = (end("FROM", from), end("TO", to));
    let points = arguments.whole(&format!("{option}, N"), Some(count), 2..=MOST_COORDINATES);
    let (from, to, points) = (from?, to?, u32::try_from(points?).ok()?);
    if from >= to {
        let problem = if from == to { Problem::EmptyRange } else { Problem::ReversedRange };
        return arguments.fault(option, Some(text), problem);
    }
    Some(LogAxis { from, to, points })
}

impl GridRequest {
    /// Classifies the grid, writes its rows and its picture where they are wanted, and prints the counts.
    ///
    /// # Errors
    /// When an output cannot be written.
    pub fn run(&self, threshold: &InertialThreshold, json: bool, progress: Progress) -> Result<(), Failure> {
        // An output that cannot be written is reported before the work, not after it.
        let [rows, svg] = Output::create_both([self.rows.as_deref(), self.svg.as_deref()])?;
        let tally = self.tally(threshold, progress);
        if let Some(output) = rows {
            let bar = progress.points(self.points());
            self.write_rows(threshold, output, |points| bar.inc(points))?;
            bar.finish_and_clear();
        }
        svg.map_or(Ok(()), |output| output.finish(self.picture(threshold).svg))?;
        self.answer(&tally).print_beside(json, self.rows.as_deref())
    }

    fn tally(&self, threshold: &InertialThreshold, progress: Progress) -> Tally {
        let [velocities, stresses] =
            [&self.loading_velocities, &self.normal_stresses].map(LogCoordinates::of);
        let grid = StreamedGrid {
            slider: &self.slider,
            threshold,
            loading_velocities: GridAxis {
                count: self.loading_velocities.points,
                coordinate: |index| velocities.at(index),
            },
            normal_stresses: GridAxis {
                count: self.normal_stresses.points,
                coordinate: |index| stresses.at(index),
            },
        };
        let bar = progress.points(self.points());
        let tally = grid.tally(|points| bar.inc(points));
        bar.finish_and_clear();
        // Every coordinate of a logarithmic axis in the allowed range is positive and finite.
        tally.unwrap_or_default()
    }

    fn points(&self) -> u64 {
        u64::from(self.loading_velocities.points) * u64::from(self.normal_stresses.points)
    }

    fn answer(&self, tally: &Tally) -> Answer {
        let (velocities, stresses) = (self.loading_velocities.points, self.normal_stresses.points);
        let shared = |part: Answer, (name, count): (&'static str, u64)| {
            counted(part, (name, name, count, &percent(count, tally.points())))
        };
        let modes = SlipMode::ALL.into_iter().map(|mode| (mode.as_str(), tally.of_mode(mode)));
        let classes = SpectralClass::ALL.into_iter().map(|class| (class.as_str(), tally.of_class(class)));
        let neutral = (NEUTRAL, tally.on_transition());
        let axes = format!("({velocities} velocities x {stresses} stresses)");
        let levels = [
            ("f64", "decided by f64", tally.decided_by().f64, ""),
            ("exact", "decided by rationals", tally.decided_by().exact, ""),
        ];
        let answer = Answer::to(slider_json(&self.slider))
            .with("loading_velocities", velocities)
            .with("normal_stresses", stresses);
        let answer = counted(answer, ("points", "points", tally.points(), &axes))
            .part("slip_mode", modes.chain([neutral]).fold(Answer::default(), shared))
            .part("spectral_class", classes.fold(Answer::default(), shared));
        let answer = counted(answer, ("on_transition", "exactly on K = K_c", tally.on_transition(), ""));
        counted(answer, ("on_boundary", "exactly on max Im(s) = 0", tally.on_boundary(), ""))
            .part("rung", levels.into_iter().fold(Answer::default(), counted))
    }
}

/// Adds a count with its key, name and note, in a line wide enough for the longest name of a mode and the largest number of points.
fn counted(answer: Answer, (key, name, count, note): (&str, &str, u64, &str)) -> Answer {
    let line = format!("{name:<37}{count:>13}  {note}");
    answer.with(key, count).text(line.trim_end()).text("\n")
}

/// A share in per cent to four decimals.
fn percent(count: u64, all: u64) -> String {
    format!("({:.4} %)", 100.0 * count as f64 / all as f64)
}
