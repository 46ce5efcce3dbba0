//! Runs over error bars: at the middle values, at every corner, and at points spread between; their ranges are sampled.

use clap::Args;
use slipmode::comparison::{Observable, sampled_range, simulated};
use slipmode::csv::{Column, Datum};
use slipmode::parallel;
use slipmode::sweep::LowDiscrepancy;
use slipmode_core::dynamics::{Options, Simulation};
use slipmode_core::friction::{EvolutionLaw, Parameters};
use slipmode_core::number::Rational;
use slipmode_core::number::format::ends_around;
use slipmode_core::stability::{InertialThreshold, ParameterBox, over_box};

use crate::cli::answer::{Answer, SHOWN_DIGITS};
use crate::cli::classify::box_view;
use crate::cli::options::Arguments;
use crate::cli::simulate::range;
use crate::cli::simulate::run::{self, Shown, simulate_point};

/// The runs between the corners unless their number is given.
pub const DEFAULT_RUNS: u64 = 32;
/// The largest number of runs between the corners.
const MOST_RUNS: u64 = 10_000;

/// How many runs there are where values have error bars.
#[derive(Debug, Args)]
pub struct BoxOptions {
    /// Runs at points spread within error bars, 0 to 10 000; the middle and all corners are added [default: 32]
    ///
    /// One value with an error bar has 2 corners, seven have 128. Ranges over these runs are sampled: no proof says that other
    /// values within the error bars stay inside. The points are the same in every run.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub box_runs: Option<String>,
}

impl BoxOptions {
    /// Reads the number.
    pub fn read(&self, arguments: &mut Arguments) -> u64 {
        arguments.whole("--box-runs", self.box_runs.as_deref(), 0..=MOST_RUNS).unwrap_or(DEFAULT_RUNS)
    }

    /// Notes it where it would have no effect.
    pub fn refuse(&self, needs: &str, arguments: &mut Arguments) {
        arguments.refuse_value("--box-runs", self.box_runs.as_deref(), needs);
    }
}

/// Whether no value has an error bar.
pub fn is_point(region: &ParameterBox) -> bool {
    region.lower() == region.upper()
}

/// All corners of error bars, then points spread between them; none without error bars.
pub fn points_within(region: &ParameterBox, spread: u64) -> Vec<Parameters<Rational>> {
    let [lower, upper]: [[Rational; 7]; 2] = [region.lower().into(), region.upper().into()];
    let wide: Vec<usize> = (0..lower.len()).filter(|index| lower[*index] < upper[*index]).collect();
    if wide.is_empty() {
        return Vec::new();
    }
    // The point whose wide values lie at these fractions of their error bars.
    let at = |fraction: &dyn Fn(usize) -> Rational| {
        let mut point = lower.clone();
        for (place, index) in wide.iter().enumerate() {
            point[*index] += fraction(place) * Rational::from(&upper[*index] - &lower[*index]);
        }
        Parameters::from(point)
    };
    let corners = (0..1_u64 << wide.len()).map(|corner| at(&|place| Rational::from(corner >> place & 1)));
    let sequence = LowDiscrepancy::new(b"error bars");
    let fraction = |number, place| Rational::from_f64(sequence.coordinate(number, place)).unwrap_or_default();
    let between = (0..spread).map(|number| at(&|place| fraction(number, place)));
    corners.chain(between).collect()
}

/// The runs over error bars, that of the middle values first.
#[derive(Debug)]
pub struct BoxRuns {
    runs: Vec<Shown>,
    corners: usize,
    outside_tested_range: bool,
}

impl BoxRuns {
    /// Adds to the run of the middle values those at the corners and at `spread` points between them.
    pub fn new(
        middle: Shown,
        region: &ParameterBox,
        law: EvolutionLaw,
        options: Options,
        spread: u64,
    ) -> Self {
        let points = points_within(region, spread);
        let runs = parallel::map(&points, |point| simulate_point(point, law, options));
        let runs: Vec<Shown> = std::iter::once(middle).chain(runs).collect();
        let outside_tested_range = points.iter().any(|point| range::outside_tested(point).next().is_some());
        Self { corners: runs.len() - 1 - spread as usize, runs, outside_tested_range }
    }

    /// Whether no run has an answer.
    pub fn is_unanswered(&self) -> bool {
        self.ended().next().is_none()
    }

    fn ended(&self) -> impl Iterator<Item = &Simulation> {
        self.runs.iter().flatten()
    }

    /// The range of a value, widened by the estimated errors; none where no run has it.
    fn range(&self, of: Observable) -> Option<[f64; 2]> {
        sampled_range(self.ended().filter_map(|run| Some(simulated(run, of)?.with_absolute_error())))
    }

    fn minimum(&self) -> Option<[f64; 2]> {
        let value = |run: &Simulation| (run.minimum_velocity_log10_ratio, run.minimum_velocity_log10_error);
        sampled_range(self.ended().map(value))
    }

    /// The words that runs have, each with the number of these runs, in alphabetical order.
    fn words(&self, word: fn(&Simulation) -> &'static str) -> Vec<(&'static str, usize)> {
        let mut words: Vec<&str> = self.ended().map(word).collect();
        words.sort_unstable();
        words.chunk_by(|one, next| one == next).map(|same| (same[0], same.len())).collect()
    }

    fn listed(&self, word: fn(&Simulation) -> &'static str) -> Datum {
        let words: Vec<&str> = self.words(word).into_iter().map(|(word, _)| word).collect();
        Datum::Text(words.join(";"))
    }

    fn largest(&self, error: fn(&Simulation) -> Option<f64>) -> Datum {
        Datum::Number(self.ended().filter_map(error).reduce(f64::max))
    }

    /// The number of runs that failed, and the reason of the first.
    fn failed(&self) -> (usize, &str) {
        let mut reasons = self.runs.iter().filter_map(|run| run.as_ref().err());
        let first = reasons.next().map(String::as_str);
        (usize::from(first.is_some()) + reasons.count(), first.unwrap_or_default())
    }

    fn status(&self) -> String {
        let all = self.runs.len();
        match self.failed() {
            (0, _) => format!("sampled: {all} runs"),
            (failed, reason) => format!("sampled: {all} runs, of which {failed} failed: {reason}"),
        }
    }

    /// States how many runs there are, what they show, and what the linear theory decides exactly.
    pub fn answer(&self, region: &ParameterBox) -> Answer {
        let (all, (failed, reason)) = (self.runs.len(), self.failed());
        let spread = all - 1 - self.corners;
        let failures = if failed > 0 { format!("; {failed} failed: {reason}") } else { String::new() };
        let answer = Answer::line("\nall values within the error bars, sampled:")
            .with("strength", "sampled")
            .item("runs", "runs", all as u64)
            .note(&format!("(the middle, {} corners and {spread} points{failures})", self.corners))
            .with("corners", self.corners)
            .with("spread_points", spread)
            .with("failed", failed)
            .columns(&COLUMNS, self)
            .and(self.counted("mode", "mode", |run| run.behaviour.as_str()))
            .and(self.counted("slip_mode", "slip mode", |run| run.slip_mode.as_str()))
            .and(self.ranges());
        let theory = over_box(region, &InertialThreshold::default());
        let theory = theory.map_or_else(Answer::default, |found| box_view::modes(region, &found));
        answer
            .text("\nlinear theory, all values within the error bars, exact:\n")
            .part("linear_theory", theory)
    }

    /// A list of words with the number of runs that have each.
    fn counted(&self, key: &str, name: &str, word: fn(&Simulation) -> &'static str) -> Answer {
        let ended = self.ended().count();
        let part = |(word, runs): (&'static str, usize)| {
            let part = Answer::default().item(key, name, word).with("runs", runs);
            part.note(&format!("(in {runs} of {ended} runs)"))
        };
        Answer::default().list(&format!("{key}s"), self.words(word).into_iter().map(part))
    }

    /// Lines for people of the ranges.
    fn ranges(&self) -> Answer {
        let ended = self.ended().count();
        let is_mixed = self.words(|run| run.behaviour.as_str()).len() > 1;
        Observable::STATED.into_iter().fold(Answer::default(), |answer, of| {
            let have = self.ended().filter(|run| simulated(run, of).is_some()).count();
            let text = self.range(of).map_or("none".into(), |ends| {
                format!("{} {}", ends_around(ends, SHOWN_DIGITS).join(" to "), of.unit())
            });
            let runs = if have < ended { format!("{have} of {ended} runs oscillate") } else { String::new() };
            let mixed = if is_mixed { "cycles and decays together" } else { "" };
            let notes: Vec<&str> =
                [runs.as_str(), mixed].into_iter().filter(|note| !note.is_empty()).collect();
            let note = if notes.is_empty() { String::new() } else { format!("({})", notes.join("; ")) };
            answer.named(&of.words(), &text).note(&note)
        })
    }
}

/// The columns of `simulate` where values have error bars: what occurs, ranges, the largest errors, and the work of all runs.
pub const COLUMNS: [Column<BoxRuns>; run::COLUMNS.len()] = [
    (run::COLUMNS[0].0, |it| it.listed(|run| run.behaviour.as_str())),
    (run::COLUMNS[1].0, |it| it.listed(|run| run.slip_mode.as_str())),
    (run::COLUMNS[2].0, |it| Datum::Range(it.range(Observable::PeakVelocity))),
    (run::COLUMNS[3].0, |it| Datum::Range(it.minimum())),
    (run::COLUMNS[4].0, |it| Datum::Range(it.range(Observable::Period))),
    (run::COLUMNS[5].0, |it| Datum::Range(it.range(Observable::StressDrop))),
    (run::COLUMNS[6].0, |it| Datum::Range(it.range(Observable::Frequency))),
    (run::COLUMNS[7].0, |it| it.largest(|run| Some(run.peak_relative_error))),
    (run::COLUMNS[8].0, |it| it.largest(|run| run.period_relative_error)),
    (run::COLUMNS[9].0, |it| Datum::Count(it.ended().map(|run| run.steps).sum())),
    (run::COLUMNS[10].0, |it| Datum::Count(it.ended().map(|run| run.evaluations).sum())),
    (run::COLUMNS[11].0, |it| Datum::Flag(it.outside_tested_range)),
    (run::COLUMNS[12].0, |it| Datum::Text(it.status())),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_the_corners_and_then_others_within_the_error_bars() {
        let point = |values: [u32; 7]| Parameters::from(values.map(Rational::from));
        let (lower, upper) = (point([1, 2, 3, 4, 5, 6, 7]), point([1, 4, 3, 4, 6, 6, 8]));
        let region = ParameterBox::new(lower.clone(), upper.clone()).unwrap();
        let points = points_within(&region, 100);
        assert_eq!((points.len(), &points[0], &points[7]), (108, &lower, &upper));
        assert!(points.iter().all(|point| region.contains(point)));
        assert!(points.iter().enumerate().all(|(index, point)| !points[..index].contains(point)));
        assert!(points_within(&ParameterBox::of(lower).unwrap(), 100).is_empty());
    }
}
