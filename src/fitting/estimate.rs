//! A fit: the best values of a law, their errors and correlations, and how the other law compares.

use crate::parallel;
use nalgebra::DMatrix;

use super::least_squares::{LONG, Minimum, SHORT, covariance, minimise};
use super::parameter::{Parameter, Point};
use super::problem::{FitGiven, FitProblem};
use super::profile::{ProfilePoint, Profiler};
use super::record::StepRecord;
use super::residuals::Residuals;
use super::start::starts;
use slipmode_core::friction::EvolutionLaw;
use thiserror::Error;

/// A fitted parameter in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Which one.
    pub parameter: Parameter,
    /// The best value.
    pub value: f64,
    /// One standard error, from the curvature at the best value.
    pub standard_error: f64,
    /// The ends of the 95 % interval by profile likelihood; none where the record sets no bound.
    pub ends: [Option<f64>; 2],
    /// How far they are from the best value in standard errors of independent samples.
    pub half_width: f64,
    /// The ends that the curvature at the best value alone gives.
    pub quadratic_ends: [f64; 2],
    /// The profile.
    pub profile: Vec<ProfilePoint>,
}

/// What a record gives.
#[derive(Debug, Clone)]
pub struct Fit {
    /// What was known.
    pub given: FitGiven,
    /// The fitted parameters.
    pub estimates: Vec<Estimate>,
    /// Where they are, with what was given, as coordinates of the search.
    pub point: Point,
    /// The covariance of their coordinates, with the noise; its order is that of the estimates.
    pub covariance: DMatrix<f64>,
    /// The noise.
    pub residuals: Residuals,
    /// Model less record at every sample, in what was measured over the normal stress at the start.
    pub differences: Vec<f64>,
    /// The sum of their squares.
    pub cost: f64,
    /// Samples within the first D_c of the load point's way after a step, the fewest of all steps.
    pub samples_per_slip_distance: f64,
    /// Runs of the slider that the fit made with derivatives.
    pub runs: usize,
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitFailure {
    /// No friction parameters follow the record at all.
    #[error("no friction parameters reproduce the record: {0}")]
    NoMinimum(&'static str),
    /// The record fits far better with the sign of its friction reversed.
    #[error(
        "row {0}: the friction falls where the velocity of the load point rises, or the other way round: is the sign of the changes of friction reversed?"
    )]
    WrongSign(usize),
    /// Too few samples after a step.
    #[error(
        "{0:.2} points per D_c after a step (wanted: at least {LEAST_SAMPLES}): the record does not show the direct effect"
    )]
    TooFewSamples(f64),
    /// The record does not determine all parameters.
    #[error(
        "the record does not determine {0} together; give the stiffness, or record more samples after a step"
    )]
    Undetermined(String),
    /// D_c is shorter than the samples tell, or longer than the record.
    #[error(
        "the record does not determine D_c: the best value is far below the way between two samples, or far beyond the way after a step"
    )]
    Unresolved,
    /// A parameter that no material has: its value, the smallest and the largest that are taken for possible.
    #[error("the best {0} is {1:.3e} (wanted: {low:e} to {high:e}; is a column in another unit?)", low = .2[0], high = .2[1])]
    Absurd(Parameter, f64, [f64; 2]),
}

/// Two laws on the same record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawComparison {
    /// The law that fits better.
    pub better: EvolutionLaw,
    /// ln of the likelihood of the better law over that of the other, for independent samples.
    pub log_likelihood_ratio: f64,
    /// The same in units of its own standard deviation (Vuong 1989): beyond 1.96 the record tells the laws apart.
    pub vuong: f64,
}

/// The fits of a record.
#[derive(Debug, Clone)]
pub struct Fits {
    /// That of the law that fits better.
    pub best: Fit,
    /// That of the other law, where it was requested and has one.
    pub other: Option<Fit>,
}

impl Fits {
    /// Fits these laws to a record; what else is known is the same for all of them.
    ///
    /// # Errors
    /// When no law has a fit: why the first one has none.
    pub fn of(record: &StepRecord, laws: &[EvolutionLaw], given: &FitGiven) -> Result<Self, FitFailure> {
        let found: Vec<Result<Fit, FitFailure>> =
            parallel::map(laws, |law| fit(record, &FitGiven { law: *law, ..*given }));
        let failure = found.iter().find_map(|found| found.as_ref().err()).cloned();
        let mut fits: Vec<Fit> = found.into_iter().flatten().collect();
        fits.sort_by(|one, other| one.cost.total_cmp(&other.cost));
        let mut fits = fits.into_iter();
        let none = || failure.unwrap_or(FitFailure::NoMinimum("no law was requested"));
        Ok(Self { best: fits.next().ok_or_else(none)?, other: fits.next() })
    }

    /// How the two laws compare, where both have a fit.
    pub(crate) fn comparison(&self) -> Option<LawComparison> {
        self.other.as_ref().map(|other| self.best.compared_with(other))
    }
}

/// Fits of one law, restarted from better points that profiles meet, at most this often.
const RESTARTS: usize = 3;
/// Searches that go on after the short ones, and how often each goes on.
const LONGER: usize = 2;
const CONTINUED: usize = 2;
const NO_END: &str = "no search from the values read off the record ends";
const INDEFINITE: &str = "the sum of squares has no definite minimum";
/// The share of the spread of a record that a fit leaves, from which on the sign of the record is doubted.
const UNEXPLAINED: f64 = 0.5;
/// A record that is this many times nearer to the model with its sign reversed has the wrong sign.
const SIGN_FACTOR: f64 = 4.0;
/// What a and b, and D_c, can be: friction beyond these has never been measured.
const POSSIBLE_EFFECT: [f64; 2] = [1e-5, 0.5];
const POSSIBLE_DISTANCE_M: [f64; 2] = [1e-9, 0.01];
/// A smaller change of the velocity is no step whose samples count.
const SMALLEST_STEP: f64 = 0.05;
/// Fewest samples within D_c after a step.
const LEAST_SAMPLES: f64 = 1.0;

/// Fits the parameters that are not given to a record.
///
/// # Errors
/// When no parameters follow the record, its sign is reversed, or it does not determine them.
fn fit(record: &StepRecord, given: &FitGiven) -> Result<Fit, FitFailure> {
    let problem = FitProblem::new(record, given);
    let best = best_minimum(problem);
    let cost = best.as_ref().map_or(f64::INFINITY, |best| best.cost);
    if cost > UNEXPLAINED * spread(record) && is_reversed(problem, cost) {
        let step = record.path.strides().nth(1).map_or(0, |(samples, _)| samples.start);
        return Err(FitFailure::WrongSign(step + 1));
    }
    completed(problem, best.ok_or(FitFailure::NoMinimum(NO_END))?)
}

/// The sum of squares of the friction about its mean.
fn spread(record: &StepRecord) -> f64 {
    let mean = record.frictions.iter().sum::<f64>() / record.rows() as f64;
    record.frictions.iter().map(|friction| (friction - mean) * (friction - mean)).sum()
}

/// Completes a minimum, or a better one that its profiles meet.
fn completed(problem: FitProblem<'_>, mut best: Minimum) -> Result<Fit, FitFailure> {
    let mut runs = best.runs;
    for _ in 0..RESTARTS {
        let point = match complete(problem, &best, &mut runs)? {
            Ok(fit) => return Ok(fit),
            Err(better) => better,
        };
        let found = minimise(problem, &point, &problem.given.free(), LONG);
        let better = found.filter(|found| found.cost < best.cost);
        best = better.ok_or(FitFailure::NoMinimum(INDEFINITE))?;
    }
    Err(FitFailure::NoMinimum(INDEFINITE))
}

/// Short searches from all starts, and long ones from where the best of them end.
fn best_minimum(problem: FitProblem<'_>) -> Option<Minimum> {
    let free = &problem.given.free();
    let by_cost = |one: &Minimum, other: &Minimum| one.cost.total_cmp(&other.cost);
    let mut rough: Vec<Minimum> =
        starts(problem).into_iter().filter_map(|(start, _)| minimise(problem, &start, free, SHORT)).collect();
    let mut runs: usize = rough.iter().map(|found| found.runs).sum();
    rough.sort_by(by_cost);
    let mut longer = |mut found: Minimum| {
        for _ in 0..CONTINUED {
            found = minimise(problem, &found.point, free, LONG)?;
            runs += found.runs;
            if found.is_converged {
                return Some(found);
            }
        }
        None
    };
    let found: Vec<Minimum> = rough.into_iter().take(LONGER).filter_map(&mut longer).collect();
    let best = found.into_iter().min_by(by_cost)?;
    // A search can end early in a narrow valley, and starts anew with longer steps.
    let again = minimise(problem, &best.point, free, LONG).filter(|again| again.cost < best.cost);
    let best = again.unwrap_or(best);
    Some(Minimum { runs: runs + best.runs, ..best })
}

/// Whether the model is far nearer to the record with all changes of friction reversed.
fn is_reversed(problem: FitProblem<'_>, cost: f64) -> bool {
    let before = problem.record.frictions[0];
    let mirrored = problem.record.frictions.iter().map(|friction| 2.0 * before - friction).collect();
    let record = problem.record.with_frictions(mirrored);
    let found = best_minimum(FitProblem::new(&record, problem.given));
    found.is_some_and(|found| cost > SIGN_FACTOR * found.cost)
}

/// Errors, intervals and correlations at a minimum; or a point where the sum of squares is smaller.
fn complete(
    problem: FitProblem<'_>,
    minimum: &Minimum,
    runs: &mut usize,
) -> Result<Result<Fit, Point>, FitFailure> {
    let free = &problem.given.free();
    check_possible(&minimum.point, free)?;
    if problem.is_unresolved(&minimum.point) {
        return Err(FitFailure::Unresolved);
    }
    let residuals = Residuals::of(&minimum.evaluated.residuals, free.len(), problem.record.resolution());
    let symbols = || free.iter().map(|parameter| parameter.symbol()).collect::<Vec<_>>().join(", ");
    let covariance =
        covariance(&minimum.evaluated, free).ok_or_else(|| FitFailure::Undetermined(symbols()))?;
    let profiler = Profiler { problem, minimum, free, covariance: &covariance, residuals: &residuals };
    let mut estimates = Vec::new();
    for (index, parameter) in free.iter().enumerate() {
        let profile = profiler.profile(index);
        *runs += profile.points.len();
        if let Some(point) = profile.better {
            return Ok(Err(point));
        }
        // Without one neighbour that can be fitted, the best value is none.
        if profile.points.len() == 1 {
            return Err(FitFailure::NoMinimum(INDEFINITE));
        }
        let coordinate = minimum.point[*parameter as usize];
        let value = parameter.at(&minimum.point);
        let error = residuals.standard_deviation * (residuals.inflation * covariance[(index, index)]).sqrt();
        let half_width = profiler.half_width(index);
        let to_end = half_width / residuals.inflation.sqrt() * error;
        estimates.push(Estimate {
            parameter: *parameter,
            value,
            standard_error: if parameter.is_logarithmic() { value * error } else { error },
            ends: profile.ends.map(|end| end.map(|end| parameter.value(end))),
            quadratic_ends: [-1.0, 1.0].map(|side| parameter.value(coordinate + side * to_end)),
            half_width,
            profile: profile.points,
        });
    }
    let variance = residuals.standard_deviation * residuals.standard_deviation * residuals.inflation;
    let distance = Parameter::CriticalSlipDistance.at(&minimum.point);
    let samples_per_slip_distance = samples_per_slip_distance(problem.record, distance);
    if samples_per_slip_distance < LEAST_SAMPLES {
        return Err(FitFailure::TooFewSamples(samples_per_slip_distance));
    }
    Ok(Ok(Fit {
        given: *problem.given,
        estimates,
        point: minimum.point,
        covariance: covariance * variance,
        residuals,
        differences: minimum.evaluated.residuals.clone(),
        cost: minimum.cost,
        samples_per_slip_distance,
        runs: *runs,
    }))
}

fn check_possible(point: &Point, free: &[Parameter]) -> Result<(), FitFailure> {
    for parameter in free {
        let [low, high] = match parameter {
            Parameter::DirectEffect => POSSIBLE_EFFECT,
            Parameter::CriticalSlipDistance => POSSIBLE_DISTANCE_M,
            _ => continue,
        };
        let value = parameter.at(point);
        if !(low..=high).contains(&value) {
            return Err(FitFailure::Absurd(*parameter, value, [low, high]));
        }
    }
    Ok(())
}

/// Samples within the first D_c of the load point's way after a step: the fewest of all steps.
fn samples_per_slip_distance(record: &StepRecord, distance_m: f64) -> f64 {
    let mut last = record.reference_velocity_m_per_s();
    let is_step = move |(_, velocity): &(std::ops::Range<usize>, f64)| {
        let change = (velocity - last).abs();
        let is_step = change > SMALLEST_STEP * last.abs();
        last = *velocity;
        is_step
    };
    let within = |(samples, _): (std::ops::Range<usize>, f64)| {
        let start = samples.start;
        let way = |sample: usize| (record.displacements_m[sample] - record.displacements_m[start]).abs();
        let count = (start + 1..=samples.end).take_while(|sample| way(*sample) <= distance_m).count();
        // A stride shorter than D_c has as many as if it went on, and one whose first sample lies beyond has a part of one.
        let density = distance_m / if count == 0 { way(start + 1) } else { way(samples.end).min(distance_m) };
        density * count.max(1) as f64
    };
    record.path.strides().skip(1).filter(is_step).map(within).fold(f64::INFINITY, f64::min)
}

impl Fit {
    /// The estimate of a parameter, where it was fitted.
    pub(crate) fn estimate(&self, parameter: Parameter) -> Option<&Estimate> {
        self.estimates.iter().find(|estimate| estimate.parameter == parameter)
    }

    /// The friction of the model at every sample.
    pub fn fitted(&self, record: &StepRecord) -> impl Iterator<Item = f64> {
        let samples = record.frictions.iter().zip(&self.differences).enumerate();
        samples.map(|(sample, (friction, difference))| friction + difference / record.scale(sample))
    }

    /// The correlation of each pair of estimates, by their indices.
    pub fn correlations(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let covariance = &self.covariance;
        let correlation =
            |i: usize, j: usize| covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt();
        let pairs =
            (0..self.estimates.len()).flat_map(move |i| (i + 1..self.estimates.len()).map(move |j| (i, j)));
        pairs.map(move |(i, j)| (i, j, correlation(i, j)))
    }

    /// Compares this fit with that of another law on the same record.
    pub(crate) fn compared_with(&self, other: &Self) -> LawComparison {
        let (better, worse) = if self.cost <= other.cost { (self, other) } else { (other, self) };
        let rows = self.differences.len() as f64;
        // Each law has its own variance, that of the maximum likelihood.
        let variance = |fit: &Self| fit.cost / rows;
        let log_likelihood = |difference: f64, variance: f64| {
            -0.5 * (difference * difference / variance + libm::log(variance))
        };
        let ratios: Vec<f64> = better
            .differences
            .iter()
            .zip(&worse.differences)
            .map(|(one, two)| log_likelihood(*one, variance(better)) - log_likelihood(*two, variance(worse)))
            .collect();
        let sum: f64 = ratios.iter().sum();
        let spread = ratios.iter().map(|ratio| (ratio - sum / rows) * (ratio - sum / rows)).sum::<f64>();
        let inflation = better.residuals.inflation;
        let vuong = if spread > 0.0 { sum / (spread * inflation).sqrt() } else { 0.0 };
        LawComparison { better: better.given.law, log_likelihood_ratio: sum, vuong }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fitting::record::fixtures::{driven, record};
    use slipmode_core::dynamics::DrivenSlider;
    use slipmode_core::number::split_mix::SplitMix64;

    fn slider(law: EvolutionLaw) -> DrivenSlider {
        DrivenSlider {
            direct_effect: 0.008,
            evolution_effect: 0.012,
            critical_slip_distance_m: 1e-5,
            stiffness_pa_per_m: 2e10,
            reference_friction: 0.6,
            mass_per_area_kg_per_m2: None,
            law,
        }
    }

    fn given(law: EvolutionLaw) -> FitGiven {
        FitGiven { law, stiffness_pa_per_m: None, mass_per_area_kg_per_m2: None, has_drift: false }
    }

    #[test]
    fn a_record_without_noise_gives_its_parameters_back() {
        for law in EvolutionLaw::ALL {
            let found = fit(&record(&slider(law), 1e-9, 1200), &given(law)).unwrap();
            for (estimate, wanted) in found.estimates.iter().zip([0.008, 0.012, 1e-5, 2e10, 0.6]) {
                assert!((estimate.value / wanted - 1.0).abs() < 1e-5, "{law:?} {estimate:?}");
            }
        }
    }

    #[test]
    fn intervals_hold_for_noise_below_the_resolution() {
        // (noise in steps of the resolution, whether rounding widens the interval of mu_0 too little for a remark)
        for (share, is_noise) in [(0.5, true), (0.3, false), (0.2, false), (0.1, false), (0.02, false)] {
            let [mut held, mut all] = [0, 0];
            for phase in 0..5 {
                let step = 2e-4;
                let exact = record(&slider(EvolutionLaw::Slip), 0.0, 1200);
                let mut random = SplitMix64(phase + 1);
                let mut noise = || share * step * ((0..12).map(|_| random.unit()).sum::<f64>() - 6.0);
                let noisy =
                    exact.with_frictions(exact.frictions.iter().map(|friction| friction + noise()).collect());
                // A grid that has no value at 0.
                let at = 0.2 * phase as f64;
                let round = |friction: &f64| ((friction / step + at).round() - at) * step;
                let rounded = noisy.with_frictions(noisy.frictions.iter().map(round).collect());
                assert!((rounded.resolution() / step - 1.0).abs() < 1e-6 && noisy.resolution() == 0.0);
                let found = fit(&rounded, &given(EvolutionLaw::Slip)).unwrap();
                for (estimate, wanted) in found.estimates.iter().zip([0.008, 0.012, 1e-5, 2e10, 0.6]) {
                    let [low, high] = estimate.ends.map(Option::unwrap);
                    held += i32::from(low <= wanted && wanted <= high);
                    all += 1;
                }
                let width = found.estimates[4].half_width / found.residuals.half_width();
                assert_eq!(width < 1.2, is_noise, "{share}: {width}");
            }
            assert!(10 * held >= 9 * all, "{share}: {held} of {all}");
        }
    }

    #[test]
    fn holds_give_the_parameters_too() {
        let record = driven([1e-5, 0.0, 1e-5, 3e-6], &slider(EvolutionLaw::Aging), 1e-5, 1200);
        let found = fit(&record, &given(EvolutionLaw::Aging)).unwrap();
        for (estimate, wanted) in found.estimates.iter().zip([0.008, 0.012, 1e-5, 2e10, 0.6]) {
            assert!((estimate.value - wanted).abs() < 5.0 * estimate.standard_error, "{estimate:?}");
            assert!((estimate.value / wanted - 1.0).abs() < 0.05, "{estimate:?}");
        }
    }

    #[test]
    fn estimates_are_within_their_errors_and_the_right_law_wins() {
        let record = record(&slider(EvolutionLaw::Aging), 3e-4, 1200);
        let [aging, slip] =
            [EvolutionLaw::Aging, EvolutionLaw::Slip].map(|law| fit(&record, &given(law)).unwrap());
        for (estimate, wanted) in aging.estimates.iter().zip([0.008, 0.012, 1e-5, 2e10, 0.6]) {
            let [low, high] = estimate.ends.map(Option::unwrap);
            assert!((estimate.value - wanted).abs() < 4.0 * estimate.standard_error, "{estimate:?}");
            assert!(low < estimate.value && estimate.value < high);
        }
        assert!((aging.residuals.standard_deviation / 3e-4 - 1.0).abs() < 0.1);
        let comparison = slip.compared_with(&aging);
        assert!(comparison.better == EvolutionLaw::Aging && comparison.vuong > 1.96, "{comparison:?}");
    }
}
